#include "draws.hpp"

#include "log.hpp"
#include "memory.hpp"
#include "pipelines.hpp"

#include <vulkan/vk_icd.h>

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <string>
#include <tuple>
#include <unordered_map>

namespace gpu {

namespace {

constexpr uint32_t MAX_BINDINGS = 32;

struct BoundBuffer {
	VkBuffer buffer = VK_NULL_HANDLE;
	VkDeviceSize offset = 0;
};

/// What a VkCommandBuffer of the layer points to. The loader writes into the first member.
struct CommandBuffer {
	VK_LOADER_DATA loader_data{};
	VkExtent2D target{ 0, 0 };
	const Pipeline *pipeline = nullptr;
	std::array<BoundBuffer, MAX_BINDINGS> buffers;
};

struct Sum {
	uint64_t draws = 0;
	uint64_t instances = 0;
	uint64_t indices = 0;
	uint64_t vertices = 0;
};

using Key = std::tuple<int, uint32_t, uint32_t>; // Number of the pipeline, width and height of the target.

std::mutex mutex; // Of all below.
std::map<Key, Sum> frame;
int frames = 0;
std::unordered_map<VkFramebuffer, VkExtent2D> framebuffers;

CommandBuffer &commands_of(VkCommandBuffer handle) {
	return *reinterpret_cast<CommandBuffer *>(handle);
}

VkExtent2D size_of(VkFramebuffer handle) {
	const std::lock_guard<std::mutex> guard(mutex);
	const auto found = framebuffers.find(handle);
	return found == framebuffers.end() ? VkExtent2D{ 0, 0 } : found->second;
}

VkResult create_framebuffer(
		VkDevice, const VkFramebufferCreateInfo *info, const VkAllocationCallbacks *, VkFramebuffer *out) {
	*out = reinterpret_cast<VkFramebuffer>(make_handle());
	const std::lock_guard<std::mutex> guard(mutex);
	framebuffers[*out] = { info->width, info->height };
	return VK_SUCCESS;
}

VkResult allocate_commands(VkDevice, const VkCommandBufferAllocateInfo *info, VkCommandBuffer *out) {
	for (uint32_t i = 0; i < info->commandBufferCount; i++) {
		auto *commands = new CommandBuffer; // Never freed: the engine creates a few dozen.
		set_loader_magic_value(commands);
		out[i] = reinterpret_cast<VkCommandBuffer>(commands);
	}
	return VK_SUCCESS;
}

VkResult begin_commands(VkCommandBuffer handle, const VkCommandBufferBeginInfo *info) {
	CommandBuffer &commands = commands_of(handle);
	commands.pipeline = nullptr;
	commands.buffers = {};
	// A secondary command buffer continues a pass of its primary one.
	const bool continues = (info->flags & VK_COMMAND_BUFFER_USAGE_RENDER_PASS_CONTINUE_BIT) && info->pInheritanceInfo;
	commands.target = continues ? size_of(info->pInheritanceInfo->framebuffer) : VkExtent2D{ 0, 0 };
	return VK_SUCCESS;
}

void begin_pass(VkCommandBuffer handle, const VkRenderPassBeginInfo *info, VkSubpassContents) {
	commands_of(handle).target = size_of(info->framebuffer);
}

void begin_pass_2(VkCommandBuffer handle, const VkRenderPassBeginInfo *info, const VkSubpassBeginInfo *) {
	commands_of(handle).target = size_of(info->framebuffer);
}

void bind_pipeline(VkCommandBuffer handle, VkPipelineBindPoint point, VkPipeline pipeline) {
	if (point == VK_PIPELINE_BIND_POINT_GRAPHICS) {
		commands_of(handle).pipeline = find_pipeline(pipeline);
	}
}

void bind_buffers(
		VkCommandBuffer handle, uint32_t first, uint32_t count, const VkBuffer *buffers, const VkDeviceSize *offsets) {
	for (uint32_t i = 0; i < count && first + i < MAX_BINDINGS; i++) {
		commands_of(handle).buffers[first + i] = { buffers[i], offsets[i] };
	}
}

void bind_buffers_2(VkCommandBuffer handle, uint32_t first, uint32_t count, const VkBuffer *buffers,
		const VkDeviceSize *offsets, const VkDeviceSize *, const VkDeviceSize *) {
	bind_buffers(handle, first, count, buffers, offsets);
}

/// The number of vertices of the bound mesh: each of its buffers contains at least one element for each vertex, and
/// those of attributes exactly one.
uint64_t bound_vertices(const CommandBuffer &commands, uint64_t indices) {
	uint64_t vertices = indices;
	for (const VertexBinding &binding : commands.pipeline->bindings) {
		const BoundBuffer &bound = commands.buffers[std::min(binding.binding, MAX_BINDINGS - 1)];
		const VkDeviceSize size = size_of_buffer(bound.buffer);
		if (binding.stride > 0 && size > bound.offset) {
			vertices = std::min<uint64_t>(vertices, (size - bound.offset) / binding.stride);
		}
	}
	return vertices;
}

void add(const CommandBuffer &commands, uint64_t indices, uint64_t vertices, uint32_t instances) {
	const std::lock_guard<std::mutex> guard(mutex);
	Sum &sum = frame[{ commands.pipeline->number, commands.target.width, commands.target.height }];
	sum.draws++;
	sum.instances += instances;
	sum.indices += indices * instances;
	sum.vertices += vertices * instances;
}

void draw(VkCommandBuffer handle, uint32_t vertices, uint32_t instances, uint32_t, uint32_t) {
	const CommandBuffer &commands = commands_of(handle);
	if (commands.pipeline) {
		add(commands, vertices, vertices, instances);
	}
}

void draw_indexed(VkCommandBuffer handle, uint32_t indices, uint32_t instances, uint32_t, int32_t, uint32_t) {
	const CommandBuffer &commands = commands_of(handle);
	if (commands.pipeline) {
		add(commands, indices, bound_vertices(commands, indices), instances);
	}
}

} // namespace

void end_frame() {
	const std::lock_guard<std::mutex> guard(mutex);
	for (const auto &[key, sum] : frame) {
		const auto &[pipeline, width, height] = key;
		std::string text =
				"draw " + std::to_string(pipeline) + " " + std::to_string(width) + "x" + std::to_string(height);
		text += " draws=" + std::to_string(sum.draws) + " instances=" + std::to_string(sum.instances);
		text += " indices=" + std::to_string(sum.indices) + " vertices=" + std::to_string(sum.vertices);
		log.line("%s", text.c_str());
	}
	log.line("frame %d", ++frames);
	frame.clear();
}

std::vector<Replacement> draw_replacements() {
	return {
		replacement("vkCreateFramebuffer", create_framebuffer),
		replacement("vkAllocateCommandBuffers", allocate_commands),
		replacement("vkBeginCommandBuffer", begin_commands),
		replacement("vkCmdBeginRenderPass", begin_pass),
		replacement("vkCmdBeginRenderPass2", begin_pass_2),
		replacement("vkCmdBindPipeline", bind_pipeline),
		replacement("vkCmdBindVertexBuffers", bind_buffers),
		replacement("vkCmdBindVertexBuffers2", bind_buffers_2),
		replacement("vkCmdDraw", draw),
		replacement("vkCmdDrawIndexed", draw_indexed),
	};
}

} // namespace gpu
