#include "programs/formulations.hpp"

#include "batra2008/section_2_ssph_basis.hpp"

namespace programs {

namespace {

/// The derivatives of the SSPH basis with monomials of degree 2 at a particle, in units of h. The weights of a derivative sum
/// to zero, so that they serve differences as well.
/// \param r, W offsets and kernel values of the particles
particles::Derivatives<double> derivatives(const particles::Column<double>& r,
                                           const particles::Column<double>& W) {
    const batra2008::ssph_basis::Basis<1, 2> basis({r, W, 0, {}}, 1);
    return {batra2008::ssph_basis::derivative(basis, 1), batra2008::ssph_basis::derivative(basis, 2)};
}

/// SSPH weighs with any kernel that has a compact support. In place of the Gaussian, which has none, it takes (3.15) with ρ = 4.
particles::Operators<double> ssph(const particles::Line<double>& line,
                                  const particles::Smoothing<double>& smoothing,
                                  const particles::Requirement& required) {
    using Near = particles::Neighbourhood<double>;
    if (!std::holds_alternative<particles::Gaussian>(smoothing.kernel()))
        return particles::assemble(line, smoothing, required,
                                   [](const Near& near) { return derivatives(near.r, near.W); });
    return particles::assemble(line, smoothing, required,
                               [W = particles::TruncatedGaussian<1>(4)](const Near& near) {
                                   return derivatives(near.r, W.W(near.r.square()));
                               });
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
