#pragma once

#include "driver.hpp"

#include <vector>

/// A window of the size that UNDERGROWTH_GPU_SIZE names (1920x1080), which never shows a picture. The null device
/// supports no surface.
namespace gpu {

std::vector<Replacement> screen_replacements();
std::vector<Replacement> screen_replacements_of_instance();

} // namespace gpu
