/// A Vulkan layer that lets the engine run on the null device of Mesa's driver for AMD cards. The null device compiles
/// shaders for a card that the machine does not have. It has no memory, no queue that ends its work, and no surface;
/// the layer replaces the functions for these. Nothing is drawn. The log contains the compiler's statistics of each
/// pipeline (pipelines.hpp) and the draws of each frame (draws.hpp).

#include "draws.hpp"
#include "driver.hpp"
#include "log.hpp"
#include "memory.hpp"
#include "pipelines.hpp"
#include "screen.hpp"

#include <vulkan/vk_layer.h>

#include <cstring>
#include <string>
#include <unordered_map>

namespace gpu {

namespace {

VkResult succeed() {
	return VK_SUCCESS;
}

void do_nothing() {}

/// Any function that creates one object, at the same place among its arguments.
VkResult create_handle(VkDevice, const void *, const VkAllocationCallbacks *, uint64_t *out) {
	*out = make_handle();
	return VK_SUCCESS;
}

VkResult allocate_sets(VkDevice, const VkDescriptorSetAllocateInfo *info, VkDescriptorSet *out) {
	for (uint32_t i = 0; i < info->descriptorSetCount; i++) {
		out[i] = reinterpret_cast<VkDescriptorSet>(make_handle());
	}
	return VK_SUCCESS;
}

/// All work that waits for a timeline semaphore is done.
VkResult semaphore_value(VkDevice, VkSemaphore, uint64_t *out) {
	*out = UINT64_MAX / 2;
	return VK_SUCCESS;
}

VkResult query_results(
		VkDevice, VkQueryPool, uint32_t, uint32_t, size_t size, void *out, VkDeviceSize, VkQueryResultFlags) {
	std::memset(out, 0, size);
	return VK_SUCCESS;
}

/// Functions without an effect, and those that only create a handle.
std::vector<Replacement> empty_replacements() {
	std::vector<Replacement> found = {
		replacement("vkAllocateDescriptorSets", allocate_sets),
		replacement("vkGetSemaphoreCounterValue", semaphore_value),
		replacement("vkGetQueryPoolResults", query_results),
	};
	for (const char *name : { "vkCreateImageView", "vkCreateBufferView", "vkCreateDescriptorPool", "vkCreateSampler",
				 "vkCreateFence", "vkCreateSemaphore", "vkCreateEvent", "vkCreateQueryPool", "vkCreateCommandPool" }) {
		found.push_back(replacement(name, create_handle));
	}
	for (const char *name : { "vkBindBufferMemory", "vkBindImageMemory", "vkBindBufferMemory2", "vkBindImageMemory2",
				 "vkFlushMappedMemoryRanges", "vkInvalidateMappedMemoryRanges", "vkResetDescriptorPool",
				 "vkFreeDescriptorSets", "vkWaitForFences", "vkResetFences", "vkGetFenceStatus", "vkWaitSemaphores",
				 "vkSignalSemaphore", "vkResetCommandPool", "vkEndCommandBuffer", "vkResetCommandBuffer",
				 "vkQueueSubmit", "vkQueueSubmit2", "vkQueueWaitIdle", "vkDeviceWaitIdle", "vkQueueBindSparse" }) {
		found.push_back(replacement(name, succeed));
	}
	for (const char *name :
			{ "vkDestroyImageView", "vkDestroyBufferView", "vkDestroyFramebuffer", "vkDestroyDescriptorPool",
					"vkDestroySampler", "vkDestroyFence", "vkDestroySemaphore", "vkDestroyEvent", "vkDestroyQueryPool",
					"vkDestroyCommandPool", "vkDestroySwapchainKHR", "vkDestroyShaderModule", "vkUpdateDescriptorSets",
					"vkUnmapMemory", "vkResetQueryPool", "vkFreeCommandBuffers" }) {
		found.push_back(replacement(name, do_nothing));
	}
	return found;
}

using Table = std::unordered_map<std::string, PFN_vkVoidFunction>;

Table table_of(std::initializer_list<std::vector<Replacement>> groups) {
	Table table;
	for (const std::vector<Replacement> &group : groups) {
		for (const Replacement &one : group) {
			table.emplace(one.name, one.function);
		}
	}
	return table;
}

/// Looks a function up, also by the name that it had as an extension. Null: it is the driver's.
PFN_vkVoidFunction find(const Table &table, std::string name) {
	for (const char *suffix : { "", "KHR", "EXT" }) {
		const size_t length = std::strlen(suffix);
		const size_t base = name.size() - std::min(length, name.size());
		if (name.compare(base, length, suffix) == 0) {
			const auto found = table.find(name.substr(0, base));
			if (found != table.end()) {
				return found->second;
			}
		}
	}
	return nullptr;
}

PFN_vkVoidFunction find_for_device(const char *name) {
	static const Table table = table_of({ memory_replacements(), screen_replacements(), pipeline_replacements(),
			draw_replacements(), empty_replacements() });
	if (const PFN_vkVoidFunction found = find(table, name)) {
		return found;
	}
	return std::strncmp(name, "vkCmd", 5) == 0 ? reinterpret_cast<PFN_vkVoidFunction>(do_nothing) : nullptr;
}

/// The loader's description of the next layer or the driver, in the chain of a create info.
template <class Link> Link *find_link(const void *chain, VkStructureType type) {
	auto *link = const_cast<Link *>(static_cast<const Link *>(chain));
	while (link && !(link->sType == type && link->function == VK_LAYER_LINK_INFO)) {
		link = const_cast<Link *>(static_cast<const Link *>(link->pNext));
	}
	return link;
}

VkResult create_instance(const VkInstanceCreateInfo *info, const VkAllocationCallbacks *allocator, VkInstance *out) {
	auto *link = find_link<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
	driver.instance_function = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
	link->u.pLayerInfo = link->u.pLayerInfo->pNext;
	const auto create =
			reinterpret_cast<PFN_vkCreateInstance>(driver.instance_function(VK_NULL_HANDLE, "vkCreateInstance"));
	const VkResult result = create(info, allocator, out);
	driver.instance = *out;
	return result;
}

/// Also enables the extension that returns the compiler's statistics.
VkResult create_device(VkPhysicalDevice physical, const VkDeviceCreateInfo *info,
		const VkAllocationCallbacks *allocator, VkDevice *out) {
	auto *link = find_link<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
	driver.device_function = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
	link->u.pLayerInfo = link->u.pLayerInfo->pNext;
	std::vector<const char *> extensions(
			info->ppEnabledExtensionNames, info->ppEnabledExtensionNames + info->enabledExtensionCount);
	extensions.push_back(VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME);
	VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR statistics{
		VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR
	};
	statistics.pNext = const_cast<void *>(info->pNext);
	statistics.pipelineExecutableInfo = VK_TRUE;
	VkDeviceCreateInfo with_statistics = *info;
	with_statistics.pNext = &statistics;
	with_statistics.ppEnabledExtensionNames = extensions.data();
	with_statistics.enabledExtensionCount = static_cast<uint32_t>(extensions.size());
	const VkResult result =
			driver.of_instance<PFN_vkCreateDevice>("vkCreateDevice")(physical, &with_statistics, allocator, out);
	driver.device = *out;
	VkPhysicalDeviceProperties properties{};
	driver.of_instance<PFN_vkGetPhysicalDeviceProperties>("vkGetPhysicalDeviceProperties")(physical, &properties);
	log.line("device %s", properties.deviceName);
	return result;
}

PFN_vkVoidFunction VKAPI_CALL get_device_function(VkDevice device, const char *name) {
	if (std::strcmp(name, "vkGetDeviceProcAddr") == 0) {
		return reinterpret_cast<PFN_vkVoidFunction>(get_device_function);
	}
	const PFN_vkVoidFunction found = find_for_device(name);
	return found ? found : driver.device_function(device, name);
}

PFN_vkVoidFunction VKAPI_CALL get_instance_function(VkInstance instance, const char *name) {
	static const Table table = table_of({
			{
					replacement("vkGetInstanceProcAddr", get_instance_function),
					replacement("vkGetDeviceProcAddr", get_device_function),
					replacement("vkCreateInstance", create_instance),
					replacement("vkCreateDevice", create_device),
			},
			memory_replacements_of_instance(),
			screen_replacements_of_instance(),
	});
	if (const PFN_vkVoidFunction found = find(table, name)) {
		return found;
	}
	const PFN_vkVoidFunction found = find_for_device(name);
	return found || !driver.instance_function ? found : driver.instance_function(instance, name);
}

} // namespace

} // namespace gpu

extern "C" __attribute__((visibility("default"))) VkResult vkNegotiateLoaderLayerInterfaceVersion(
		VkNegotiateLayerInterface *interface) {
	interface->loaderLayerInterfaceVersion = 2;
	interface->pfnGetInstanceProcAddr = gpu::get_instance_function;
	interface->pfnGetDeviceProcAddr = gpu::get_device_function;
	interface->pfnGetPhysicalDeviceProcAddr = nullptr;
	return VK_SUCCESS;
}
