#include "fpm_in_space/section_2_literal_extension.hpp"

namespace fpm_in_space::literal_extension {

template Derivatives<double, 1> modified(const Neighbourhood<double, 1>&);
template Derivatives<double, 1> modified_by_derivatives(const Neighbourhood<double, 1>&);
template Derivatives<double, 1> second_order(const Neighbourhood<double, 1>&);
template Derivatives<double, 2> modified(const Neighbourhood<double, 2>&);
template Derivatives<double, 2> modified_by_derivatives(const Neighbourhood<double, 2>&);
template Derivatives<double, 2> second_order(const Neighbourhood<double, 2>&);
template Derivatives<double, 3> modified(const Neighbourhood<double, 3>&);
template Derivatives<double, 3> modified_by_derivatives(const Neighbourhood<double, 3>&);
template Derivatives<double, 3> second_order(const Neighbourhood<double, 3>&);
template Derivatives<base::Quad, 2> modified(const Neighbourhood<base::Quad, 2>&);
template Derivatives<base::Quad, 2> modified_by_derivatives(const Neighbourhood<base::Quad, 2>&);
template Derivatives<base::Quad, 2> second_order(const Neighbourhood<base::Quad, 2>&);
template Derivatives<base::Quad, 3> modified(const Neighbourhood<base::Quad, 3>&);
template Derivatives<base::Quad, 3> modified_by_derivatives(const Neighbourhood<base::Quad, 3>&);
template Derivatives<base::Quad, 3> second_order(const Neighbourhood<base::Quad, 3>&);
template Table<double> harmonic_kernels(const Neighbourhood<double, 1>&);
template Table<double> kernel_derivatives(const Neighbourhood<double, 1>&);
template Table<double> corrected_kernels(const Neighbourhood<double, 1>&);
template Table<double> harmonic_kernels(const Neighbourhood<double, 2>&);
template Table<double> kernel_derivatives(const Neighbourhood<double, 2>&);
template Table<double> corrected_kernels(const Neighbourhood<double, 2>&);
template Table<double> harmonic_kernels(const Neighbourhood<double, 3>&);
template Table<double> kernel_derivatives(const Neighbourhood<double, 3>&);
template Table<double> corrected_kernels(const Neighbourhood<double, 3>&);

}  // namespace fpm_in_space::literal_extension
