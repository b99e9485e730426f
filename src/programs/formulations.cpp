#include "programs/formulations.hpp"

#include "batra2008/section_2_ssph_basis.hpp"

namespace programs {

namespace {

/// The derivatives of the SSPH basis with monomials of degree 2 at a particle, in units of h. The weights of a derivative sum
/// to zero, so that they serve differences as well.
particles::Derivatives<double> derivatives(const particles::Neighbourhood<double>& near) {
    const batra2008::ssph_basis::Basis<1, 2> basis({near.r, near.W, 0, {}}, 1);
    return {batra2008::ssph_basis::derivative(basis, 1), batra2008::ssph_basis::derivative(basis, 2)};
}

/// SSPH has the Gaussian that vanishes at the edge of its support, (3.15) with ρ = 4, in place of the one that never does.
particles::Operators<double> ssph(const particles::Line<double>& line,
                                  const particles::Smoothing<double>& smoothing,
                                  const particles::Requirement& required) {
    const bool gaussian = std::holds_alternative<particles::Gaussian>(smoothing.kernel());
    const particles::Kernel kernel = gaussian ? particles::LoweredGaussian{} : smoothing.kernel();
    return particles::assemble(line, particles::Smoothing<double>(kernel, smoothing.h()), required,
                               derivatives);
}

}  // namespace

const std::vector<asprone2010::Formulation<double>>& formulations() {
    static const auto all = [] {
        auto list = asprone2010::formulations<double>();
        list.push_back({"ssph", "2", "(2.11) of Batra and Zhang (2008)", 3, ssph});
        return list;
    }();
    return all;
}

const asprone2010::Formulation<double>& formulation_named(std::string_view wanted) {
    std::string names;
    for (const auto& formulation : formulations()) {
        if (formulation.name == wanted) return formulation;
        names += (names.empty() ? "" : ", ") + std::string(formulation.name);
    }
    throw particles::InvalidInput("there is no formulation '" + std::string(wanted) +
                                  "'; choose all or some of " + names);
}

}  // namespace programs
