#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/choose.hpp"
#include "particles/operators.hpp"

namespace asprone2010 {

using particles::Column;
using particles::Index;
using particles::Line;
using particles::Operator;

/// The degrees up to which D and D² differentiate polynomials exactly, on any particles.
struct Exactness {
    int first = 0, second = 0;
};

/// A formulation of Sections 3 and 4 as tests, programs and figures see it.
template <class Scalar = double>
struct Formulation {
    std::string_view name;       ///< on the command line and in tables
    std::string_view section;    ///< of the paper
    std::string_view equations;  ///< of its discrete form
    Index particles = 0;         ///< that a neighbourhood must hold, the particle itself included
    Exactness exact;

    using Assemble = void (*)(particles::Operators<Scalar>&, const Line<Scalar>&,
                              const particles::Smoothing<Scalar>&, const particles::Requirement&);
    Assemble assemble = nullptr;  ///< as particles::assemble_again

    /// D and D² of the formulation on a line of particles. Errors as for particles::assemble.
    [[nodiscard]] particles::Operators<Scalar> operators(
        const Line<Scalar>& line, const particles::Smoothing<Scalar>& smoothing) const {
        particles::Operators<Scalar> all;
        assemble_again(all, line, smoothing);
        return all;
    }

    /// The same in the memory of operators of other positions: for particles that move, in every time step.
    void assemble_again(particles::Operators<Scalar>& all, const Line<Scalar>& line,
                        const particles::Smoothing<Scalar>& smoothing) const {
        assemble(all, line, smoothing, {name, particles});
    }
};

/// All formulations, in the paper's order. Compiled once for each precision, like the numerical tests:
/// in_double.cpp, in_long_double.cpp, in_quad.cpp.
/// \tparam Scalar double, long double or base::Quad
template <class Scalar = double>
const std::vector<Formulation<Scalar>>& formulations();

/// The formulation of a list that has a name.
/// \throws base::InvalidInput where none has
template <class Scalar>
const Formulation<Scalar>& named(const std::vector<Formulation<Scalar>>& list, std::string_view wanted) {
    std::vector<std::pair<std::string, const Formulation<Scalar>*>> known;
    known.reserve(list.size());
    for (const auto& formulation : list) known.emplace_back(formulation.name, &formulation);
    return *base::choose("formulation", wanted, known);
}

/// \throws base::InvalidInput for a name that no formulation has
template <class Scalar = double>
const Formulation<Scalar>& formulation_named(std::string_view wanted) {
    return named(formulations<Scalar>(), wanted);
}

}  // namespace asprone2010
