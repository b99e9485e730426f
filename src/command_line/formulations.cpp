#include "command_line/formulations.hpp"

#include <string>
#include <string_view>
#include <variant>

#include "asprone2010/in_quad.hpp"
#include "batra2008/section_2_ssph_basis.hpp"
#include "fpm_in_space/section_1_second_order_fpm.hpp"

namespace command_line {

namespace {

/// SSPH takes any kernel with compact support as weight. The Gaussian has none; it is lowered as in (3.15)
/// with ρ = 4. The factor G cancels.
template <class Scalar>
void ssph(particles::Operators<Scalar>& all, const particles::Line<Scalar>& line,
          const particles::Smoothing<Scalar>& smoothing, const particles::Requirement& required) {
    const bool lowered = std::holds_alternative<particles::Gaussian<>>(smoothing.kernel());
    const Scalar edge = lowered ? particles::Gaussian<>::W(Scalar(4)) : Scalar(0);
    particles::assemble_again(all, line, smoothing, required, [edge](particles::Neighbourhood<Scalar> near) {
        near.W = (near.W - edge).max(Scalar(0));
        return batra2008::ssph_basis::derivatives<2>(near);
    });
}

template <class Scalar>
void definite_fpm(particles::Operators<Scalar>& all, const particles::Line<Scalar>& line,
                  const particles::Smoothing<Scalar>& smoothing, const particles::Requirement& required) {
    particles::assemble_again(all, line, smoothing, required,
                              [](const particles::Neighbourhood<Scalar>& near) {
                                  return fpm_in_space::second_order_fpm::derivatives(near);
                              });
}

}  // namespace

template <class Scalar>
const std::vector<asprone2010::Formulation<Scalar>>& formulations() {
    static const auto all = [] {
        auto list = asprone2010::formulations<Scalar>();
        list.push_back({"ssph", "2", "(2.11) of Batra and Zhang (2008)", 3, {2, 2}, ssph<Scalar>});
        return list;
    }();
    return all;
}

std::vector<std::string> formulation_names() {
    std::vector<std::string> names;
    for (const auto& formulation : formulations<double>()) names.emplace_back(formulation.name);
    return names;
}

std::vector<std::string> kernel_names() {
    std::vector<std::string> names;
    particles::for_each_kernel([&](const auto& kernel) { names.push_back(particles::name(kernel)); });
    return names;
}

std::vector<std::string> names_beside_all() {
    return {"definite_fpm"};
}

template <class Scalar>
const asprone2010::Formulation<Scalar>& formulation_named(std::string_view wanted) {
    static const auto known = [] {
        auto list = formulations<Scalar>();
        list.push_back({"definite_fpm", "1", "F5", 4, {2, 3}, definite_fpm<Scalar>});
        return list;
    }();
    return asprone2010::named(known, wanted);
}

template const std::vector<asprone2010::Formulation<double>>& formulations();
template const std::vector<asprone2010::Formulation<long double>>& formulations();
template const std::vector<asprone2010::Formulation<base::Quad>>& formulations();
template const asprone2010::Formulation<double>& formulation_named(std::string_view);
template const asprone2010::Formulation<long double>& formulation_named(std::string_view);
template const asprone2010::Formulation<base::Quad>& formulation_named(std::string_view);

}  // namespace command_line
