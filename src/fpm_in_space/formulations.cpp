#include "fpm_in_space/formulations.hpp"

#include "batra2008/section_2_ssph_basis.hpp"
#include "fpm_in_space/section_1_second_order_fpm.hpp"
#include "fpm_in_space/section_2_literal_extension.hpp"

namespace fpm_in_space {

template <class Scalar, int dim>
const std::vector<Formulation<Scalar, dim>>& formulations() {
    using Near = particles::Neighbourhood<Scalar, dim>;
    static const std::vector<Formulation<Scalar, dim>> all{
        {second_order_fpm::required<dim>.formulation,
         "F5 F6",
         second_order_fpm::required<dim>.particles,
         {2, 3},
         second_order_fpm::derivatives<Scalar, dim>},
        {"ssph",
         "B2.11, degree 2",
         terms<dim, 2>,
         {2, 2},
         [](const Near& near) { return batra2008::ssph_basis::derivatives<2>(near); }},
        {"cubic_ssph",
         "B2.11, degree 3",
         terms<dim, 3>,
         {3, 3},
         [](const Near& near) { return batra2008::ssph_basis::derivatives<3>(near); }},
        {"literal_modified_fpm", "F7", terms<dim, 2>, {2, 2}, literal_extension::modified<Scalar, dim>},
        {"literal_fpm_by_derivatives",
         "F8",
         terms<dim, 2>,
         {2, 2},
         literal_extension::modified_by_derivatives<Scalar, dim>},
        {"literal_second_order_fpm",
         "F9",
         terms<dim, 3>,
         {2, 3},
         literal_extension::second_order<Scalar, dim>},
    };
    return all;
}

std::vector<std::string> formulation_names() {
    std::vector<std::string> names;
    for (const auto& one : formulations<double, 2>()) names.emplace_back(one.name);
    return names;
}

template const std::vector<Formulation<double, 2>>& formulations();
template const std::vector<Formulation<double, 3>>& formulations();
template const std::vector<Formulation<base::Quad, 2>>& formulations();
template const std::vector<Formulation<base::Quad, 3>>& formulations();

}  // namespace fpm_in_space
