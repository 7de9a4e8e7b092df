#pragma once

#include <vulkan/vulkan_core.h>

/// The functions of the driver below the layer.
namespace gpu {

struct Driver {
	PFN_vkGetInstanceProcAddr instance_function = nullptr;
	PFN_vkGetDeviceProcAddr device_function = nullptr;
	VkInstance instance = VK_NULL_HANDLE;
	VkDevice device = VK_NULL_HANDLE;

	/// `Function` is the PFN_ type of the function of this name.
	template <class Function> Function of_instance(const char *name) const {
		return reinterpret_cast<Function>(instance_function(instance, name));
	}
	template <class Function> Function of_device(const char *name) const {
		return reinterpret_cast<Function>(device_function(device, name));
	}
};

/// One instance and one device: the engine creates no more.
inline Driver driver;

/// An entry of a table of functions that the layer replaces.
struct Replacement {
	const char *name;
	PFN_vkVoidFunction function;
};

template <class Function> Replacement replacement(const char *name, Function *function) {
	return { name, reinterpret_cast<PFN_vkVoidFunction>(function) };
}

} // namespace gpu
