#include "fpm_in_space/section_1_second_order_fpm.hpp"

namespace fpm_in_space::second_order_fpm {

template Derivatives<double, 1> derivatives(const Neighbourhood<double, 1>&);
template Derivatives<double, 2> derivatives(const Neighbourhood<double, 2>&);
template Derivatives<double, 3> derivatives(const Neighbourhood<double, 3>&);
template Derivatives<long double, 1> derivatives(const Neighbourhood<long double, 1>&);
template Derivatives<base::Quad, 1> derivatives(const Neighbourhood<base::Quad, 1>&);
template Derivatives<base::Quad, 2> derivatives(const Neighbourhood<base::Quad, 2>&);
template Derivatives<base::Quad, 3> derivatives(const Neighbourhood<base::Quad, 3>&);

}  // namespace fpm_in_space::second_order_fpm
