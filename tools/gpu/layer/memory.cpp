#include "memory.hpp"

#include <atomic>
#include <memory>
#include <mutex>
#include <unordered_map>

namespace gpu {

namespace {

constexpr VkDeviceSize HEAP = VkDeviceSize(200) << 30;
constexpr VkDeviceSize ALIGNMENT = 256;
constexpr VkDeviceSize BYTES_PER_TEXEL = 8; // At least that of the formats that matter; images are never written.
constexpr uint32_t ALL_TYPES = 3;

std::mutex mutex;
std::unordered_map<uint64_t, VkDeviceSize> sizes; // Of buffers and images.
struct Memory {
	VkDeviceSize size = 0;
	std::unique_ptr<char[]> bytes; // Only if it is mapped.
};
std::unordered_map<uint64_t, Memory> memories;

template <class Handle> uint64_t number_of(Handle handle) {
	return reinterpret_cast<uint64_t>(handle);
}
template <class Handle> Handle handle_of(uint64_t number) {
	return reinterpret_cast<Handle>(number);
}

uint64_t make_sized(VkDeviceSize size) {
	const uint64_t handle = make_handle();
	const std::lock_guard<std::mutex> guard(mutex);
	sizes[handle] = size;
	return handle;
}

VkDeviceSize size_of(uint64_t handle) {
	const std::lock_guard<std::mutex> guard(mutex);
	const auto found = sizes.find(handle);
	return found == sizes.end() ? 0 : found->second;
}

VkDeviceSize size_of_image(const VkImageCreateInfo &info) {
	const VkDeviceSize mipmaps = info.mipLevels > 1 ? 2 : 1;
	return BYTES_PER_TEXEL * info.extent.width * info.extent.height * info.extent.depth * info.arrayLayers * mipmaps;
}

VkMemoryRequirements requirements(VkDeviceSize size) {
	return { (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT, ALIGNMENT, ALL_TYPES };
}

void answer(VkDeviceSize size, VkMemoryRequirements2 *out) {
	out->memoryRequirements = requirements(size);
	for (auto *next = static_cast<VkBaseOutStructure *>(out->pNext); next; next = next->pNext) {
		if (next->sType == VK_STRUCTURE_TYPE_MEMORY_DEDICATED_REQUIREMENTS) {
			auto *dedicated = reinterpret_cast<VkMemoryDedicatedRequirements *>(next);
			dedicated->prefersDedicatedAllocation = VK_FALSE;
			dedicated->requiresDedicatedAllocation = VK_FALSE;
		}
	}
}

VkPhysicalDeviceMemoryProperties memory_properties() {
	VkPhysicalDeviceMemoryProperties properties{};
	properties.memoryHeapCount = 1;
	properties.memoryHeaps[0] = { HEAP, VK_MEMORY_HEAP_DEVICE_LOCAL_BIT };
	properties.memoryTypeCount = 2;
	properties.memoryTypes[0].propertyFlags = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
	properties.memoryTypes[1].propertyFlags = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT |
			VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT |
			VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
	return properties;
}

void get_memory_properties(VkPhysicalDevice, VkPhysicalDeviceMemoryProperties *out) {
	*out = memory_properties();
}

void get_memory_properties_2(VkPhysicalDevice, VkPhysicalDeviceMemoryProperties2 *out) {
	out->memoryProperties = memory_properties();
}

VkResult create_buffer(VkDevice, const VkBufferCreateInfo *info, const VkAllocationCallbacks *, VkBuffer *out) {
	*out = handle_of<VkBuffer>(make_sized(info->size));
	return VK_SUCCESS;
}

VkResult create_image(VkDevice, const VkImageCreateInfo *info, const VkAllocationCallbacks *, VkImage *out) {
	*out = make_image(*info);
	return VK_SUCCESS;
}

void destroy_buffer(VkDevice, VkBuffer buffer, const VkAllocationCallbacks *) {
	const std::lock_guard<std::mutex> guard(mutex);
	sizes.erase(number_of(buffer));
}

void destroy_image(VkDevice, VkImage image, const VkAllocationCallbacks *) {
	const std::lock_guard<std::mutex> guard(mutex);
	sizes.erase(number_of(image));
}

void buffer_requirements(VkDevice, VkBuffer buffer, VkMemoryRequirements *out) {
	*out = requirements(size_of_buffer(buffer));
}

void image_requirements(VkDevice, VkImage image, VkMemoryRequirements *out) {
	*out = requirements(size_of(number_of(image)));
}

void buffer_requirements_2(VkDevice, const VkBufferMemoryRequirementsInfo2 *info, VkMemoryRequirements2 *out) {
	answer(size_of_buffer(info->buffer), out);
}

void image_requirements_2(VkDevice, const VkImageMemoryRequirementsInfo2 *info, VkMemoryRequirements2 *out) {
	answer(size_of(number_of(info->image)), out);
}

void future_buffer_requirements(VkDevice, const VkDeviceBufferMemoryRequirements *info, VkMemoryRequirements2 *out) {
	answer(info->pCreateInfo->size, out);
}

void future_image_requirements(VkDevice, const VkDeviceImageMemoryRequirements *info, VkMemoryRequirements2 *out) {
	answer(size_of_image(*info->pCreateInfo), out);
}

void subresource_layout(VkDevice, VkImage, const VkImageSubresource *, VkSubresourceLayout *out) {
	*out = {};
}

VkDeviceAddress buffer_address(VkDevice, const VkBufferDeviceAddressInfo *) {
	return 0x10000;
}

VkResult allocate(VkDevice, const VkMemoryAllocateInfo *info, const VkAllocationCallbacks *, VkDeviceMemory *out) {
	const uint64_t handle = make_handle();
	const std::lock_guard<std::mutex> guard(mutex);
	memories[handle].size = info->allocationSize;
	*out = handle_of<VkDeviceMemory>(handle);
	return VK_SUCCESS;
}

void free_memory(VkDevice, VkDeviceMemory memory, const VkAllocationCallbacks *) {
	const std::lock_guard<std::mutex> guard(mutex);
	memories.erase(number_of(memory));
}

VkResult map(VkDevice, VkDeviceMemory memory, VkDeviceSize offset, VkDeviceSize, VkMemoryMapFlags, void **out) {
	const std::lock_guard<std::mutex> guard(mutex);
	Memory &mapped = memories[number_of(memory)];
	if (!mapped.bytes) {
		mapped.bytes = std::make_unique<char[]>(mapped.size); // Zeros.
	}
	*out = mapped.bytes.get() + offset;
	return VK_SUCCESS;
}

} // namespace

uint64_t make_handle() {
	static std::atomic<uint64_t> last{ 0x1000 };
	return ++last;
}

VkDeviceSize size_of_buffer(VkBuffer buffer) {
	return size_of(number_of(buffer));
}

VkImage make_image(const VkImageCreateInfo &info) {
	return handle_of<VkImage>(make_sized(size_of_image(info)));
}

std::vector<Replacement> memory_replacements() {
	return {
		replacement("vkCreateBuffer", create_buffer),
		replacement("vkDestroyBuffer", destroy_buffer),
		replacement("vkCreateImage", create_image),
		replacement("vkDestroyImage", destroy_image),
		replacement("vkGetBufferMemoryRequirements", buffer_requirements),
		replacement("vkGetImageMemoryRequirements", image_requirements),
		replacement("vkGetBufferMemoryRequirements2", buffer_requirements_2),
		replacement("vkGetImageMemoryRequirements2", image_requirements_2),
		replacement("vkGetDeviceBufferMemoryRequirements", future_buffer_requirements),
		replacement("vkGetDeviceImageMemoryRequirements", future_image_requirements),
		replacement("vkGetImageSubresourceLayout", subresource_layout),
		replacement("vkGetBufferDeviceAddress", buffer_address),
		replacement("vkAllocateMemory", allocate),
		replacement("vkFreeMemory", free_memory),
		replacement("vkMapMemory", map),
	};
}

std::vector<Replacement> memory_replacements_of_instance() {
	return {
		replacement("vkGetPhysicalDeviceMemoryProperties", get_memory_properties),
		replacement("vkGetPhysicalDeviceMemoryProperties2", get_memory_properties_2),
	};
}

} // namespace gpu
