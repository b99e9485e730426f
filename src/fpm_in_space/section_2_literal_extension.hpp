#pragma once

#include "fpm_in_space/section_1_second_order_fpm.hpp"

namespace fpm_in_space {

/// Section 2, why it looked complicated: the formulations of the first paper, extended word by word.
namespace literal_extension {}  // namespace literal_extension
}  // namespace fpm_in_space
