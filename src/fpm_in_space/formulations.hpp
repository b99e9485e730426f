#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "asprone2010/formulations.hpp"
#include "base/quad.hpp"
#include "particles/operators.hpp"

namespace fpm_in_space {

/// A formulation for both derivatives in the plane or in space, as tests and programs see it.
template <class Scalar, int dim>
struct Formulation {
    std::string_view name;           ///< on the command line and in tables
    std::string_view equations;      ///< of its discrete form
    particles::Index particles = 0;  ///< that a neighbourhood must hold, the particle itself included
    asprone2010::Exactness exact;

    /// Weights on \f$B(x_j) - B(x_i)\f$ [1/h, 1/h²].
    std::function<particles::Derivatives<Scalar, dim>(const particles::Neighbourhood<Scalar, dim>&)> weights;

    [[nodiscard]] particles::Requirement required() const { return {name, particles}; }
};

/// The second-order FPM of Section 1, the SSPH basis of degree 2 and 3, and the literal extensions of
/// Section 2. Compiled once for each scalar and dimension.
/// \tparam Scalar double or base::Quad \tparam dim 2 or 3
template <class Scalar, int dim>
const std::vector<Formulation<Scalar, dim>>& formulations();

std::vector<std::string> formulation_names();

/// "inside", "face", "edge" or "corner": a place by the number of sides that it lies on.
template <int dim>
std::string place(int sides) {
    static_assert(dim == 2 || dim == 3);
    return sides == 0 ? "inside" : sides == dim ? "corner" : sides == dim - 1 ? "edge" : "face";
}

/// \throws base::InvalidInput for a name that no formulation has
template <class Scalar, int dim>
const Formulation<Scalar, dim>& formulation_named(std::string_view wanted) {
    std::vector<std::pair<std::string, const Formulation<Scalar, dim>*>> known;
    for (const auto& one : formulations<Scalar, dim>()) known.emplace_back(one.name, &one);
    return *base::choose("formulation", wanted, known);
}

extern template const std::vector<Formulation<double, 2>>& formulations();
extern template const std::vector<Formulation<double, 3>>& formulations();
extern template const std::vector<Formulation<base::Quad, 2>>& formulations();
extern template const std::vector<Formulation<base::Quad, 3>>& formulations();

}  // namespace fpm_in_space
