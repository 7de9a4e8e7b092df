#pragma once

#include "driver.hpp"

#include <vector>

/// Memory, buffers and images without a device. The null device has no memory types, so the engine could not start.
/// Only memory that the engine maps exists; its content is never read.
namespace gpu {

/// Returns a new handle. Handles of the layer never reach the driver.
uint64_t make_handle();

/// Returns the size (bytes) of a buffer of the layer; 0 for others.
VkDeviceSize size_of_buffer(VkBuffer buffer);

/// Creates an image without memory.
VkImage make_image(const VkImageCreateInfo &info);

std::vector<Replacement> memory_replacements();
std::vector<Replacement> memory_replacements_of_instance();

} // namespace gpu
