#include "fpm_in_space/section_3_error_constants.hpp"

namespace fpm_in_space::error_constants {

FPM_IN_SPACE_ERROR_CONSTANTS(template, base::Quad, 2)
FPM_IN_SPACE_ERROR_CONSTANTS(template, base::Quad, 3)

}  // namespace fpm_in_space::error_constants
