#include "screen.hpp"

#include "draws.hpp"
#include "memory.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

namespace gpu {

namespace {

std::array<VkImage, 3> images; // Of the swapchain.

VkExtent2D window_size() {
	unsigned width = 1920;
	unsigned height = 1080;
	const char *text = std::getenv("UNDERGROWTH_GPU_SIZE");
	if (text && std::sscanf(text, "%ux%u", &width, &height) != 2) {
		std::fprintf(stderr, "UNDERGROWTH_GPU_SIZE is no size: %s\n", text);
	}
	return { width, height };
}

VkResult surface_support(VkPhysicalDevice, uint32_t, VkSurfaceKHR, VkBool32 *out) {
	*out = VK_TRUE;
	return VK_SUCCESS;
}

VkResult surface_capabilities(VkPhysicalDevice, VkSurfaceKHR, VkSurfaceCapabilitiesKHR *out) {
	*out = {};
	out->minImageCount = 2;
	out->maxImageCount = 8;
	out->currentExtent = window_size();
	out->minImageExtent = { 1, 1 };
	out->maxImageExtent = { 8192, 8192 };
	out->maxImageArrayLayers = 1;
	out->supportedTransforms = VK_SURFACE_TRANSFORM_IDENTITY_BIT_KHR;
	out->currentTransform = VK_SURFACE_TRANSFORM_IDENTITY_BIT_KHR;
	out->supportedCompositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
	out->supportedUsageFlags = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT |
			VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT |
			VK_IMAGE_USAGE_INPUT_ATTACHMENT_BIT;
	return VK_SUCCESS;
}

template <class Value> VkResult answer_one(const Value &value, uint32_t *count, Value *out) {
	if (out && *count > 0) {
		out[0] = value;
	}
	*count = 1;
	return VK_SUCCESS;
}

VkResult surface_formats(VkPhysicalDevice, VkSurfaceKHR, uint32_t *count, VkSurfaceFormatKHR *out) {
	return answer_one({ VK_FORMAT_B8G8R8A8_UNORM, VK_COLOR_SPACE_SRGB_NONLINEAR_KHR }, count, out);
}

VkResult present_modes(VkPhysicalDevice, VkSurfaceKHR, uint32_t *count, VkPresentModeKHR *out) {
	return answer_one(VK_PRESENT_MODE_FIFO_KHR, count, out);
}

VkResult create_swapchain(
		VkDevice, const VkSwapchainCreateInfoKHR *info, const VkAllocationCallbacks *, VkSwapchainKHR *out) {
	VkImageCreateInfo image{ VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO };
	image.extent = { info->imageExtent.width, info->imageExtent.height, 1 };
	image.mipLevels = 1;
	image.arrayLayers = 1;
	std::generate(images.begin(), images.end(), [&] { return make_image(image); });
	*out = reinterpret_cast<VkSwapchainKHR>(make_handle());
	return VK_SUCCESS;
}

VkResult swapchain_images(VkDevice, VkSwapchainKHR, uint32_t *count, VkImage *out) {
	if (out) {
		std::copy_n(images.begin(), std::min<size_t>(*count, images.size()), out);
	}
	*count = static_cast<uint32_t>(images.size());
	return VK_SUCCESS;
}

VkResult acquire_image(VkDevice, VkSwapchainKHR, uint64_t, VkSemaphore, VkFence, uint32_t *out) {
	static uint32_t next = 0;
	*out = next++ % static_cast<uint32_t>(images.size());
	return VK_SUCCESS;
}

VkResult present(VkQueue, const VkPresentInfoKHR *) {
	end_frame();
	return VK_SUCCESS;
}

} // namespace

std::vector<Replacement> screen_replacements() {
	return {
		replacement("vkCreateSwapchainKHR", create_swapchain),
		replacement("vkGetSwapchainImagesKHR", swapchain_images),
		replacement("vkAcquireNextImageKHR", acquire_image),
		replacement("vkQueuePresentKHR", present),
	};
}

std::vector<Replacement> screen_replacements_of_instance() {
	return {
		replacement("vkGetPhysicalDeviceSurfaceSupportKHR", surface_support),
		replacement("vkGetPhysicalDeviceSurfaceCapabilitiesKHR", surface_capabilities),
		replacement("vkGetPhysicalDeviceSurfaceFormatsKHR", surface_formats),
		replacement("vkGetPhysicalDeviceSurfacePresentModesKHR", present_modes),
	};
}

} // namespace gpu
