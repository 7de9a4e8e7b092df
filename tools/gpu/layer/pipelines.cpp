#include "pipelines.hpp"

#include "log.hpp"
#include "memory.hpp"

#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>

namespace gpu {

namespace {

std::mutex mutex; // Of the two maps.
std::unordered_map<VkShaderModule, uint64_t> module_hashes;
std::unordered_map<VkPipeline, std::unique_ptr<Pipeline>> pipelines;
std::mutex compiling; // Keeps the lines of a pipeline together.

uint64_t hash_of(const uint32_t *words, size_t bytes) {
	uint64_t hash = 0xcbf29ce484222325u; // FNV-1a.
	for (size_t i = 0; i < bytes / sizeof(uint32_t); i++) {
		hash = (hash ^ words[i]) * 0x100000001b3u;
	}
	return hash;
}

VkResult create_module(VkDevice device, const VkShaderModuleCreateInfo *info, const VkAllocationCallbacks *allocator,
		VkShaderModule *out) {
	const auto create = driver.of_device<PFN_vkCreateShaderModule>("vkCreateShaderModule");
	const VkResult result = create(device, info, allocator, out);
	const std::lock_guard<std::mutex> guard(mutex);
	module_hashes[*out] = hash_of(info->pCode, info->codeSize);
	return result;
}

uint64_t vertex_hash(const VkGraphicsPipelineCreateInfo &info) {
	const std::lock_guard<std::mutex> guard(mutex);
	for (uint32_t i = 0; i < info.stageCount; i++) {
		if (info.pStages[i].stage == VK_SHADER_STAGE_VERTEX_BIT) {
			return module_hashes[info.pStages[i].module];
		}
	}
	return 0;
}

int written_colours(const VkPipelineColorBlendStateCreateInfo *blend) {
	int count = 0;
	for (uint32_t i = 0; blend && i < blend->attachmentCount; i++) {
		count += blend->pAttachments[i].colorWriteMask != 0;
	}
	return count;
}

std::string text_of(const VkPipelineExecutableStatisticKHR &statistic) {
	switch (statistic.format) {
		case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_FLOAT64_KHR:
			return std::to_string(statistic.value.f64);
		case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_INT64_KHR:
			return std::to_string(statistic.value.i64);
		case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_BOOL32_KHR:
			return std::to_string(statistic.value.b32);
		default:
			return std::to_string(statistic.value.u64);
	}
}

/// The statistics of one stage: `; name=value` for each.
std::string statistics_of(VkDevice device, VkPipeline handle, uint32_t index) {
	static const auto get =
			driver.of_device<PFN_vkGetPipelineExecutableStatisticsKHR>("vkGetPipelineExecutableStatisticsKHR");
	VkPipelineExecutableInfoKHR info{ VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR };
	info.pipeline = handle;
	info.executableIndex = index;
	uint32_t count = 0;
	get(device, &info, &count, nullptr);
	std::vector<VkPipelineExecutableStatisticKHR> found(count, { VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR });
	get(device, &info, &count, found.data());
	std::string text;
	for (const VkPipelineExecutableStatisticKHR &statistic : found) {
		text += std::string("; ") + statistic.name + "=" + text_of(statistic);
	}
	return text;
}

void log_stages(VkDevice device, VkPipeline handle, int number) {
	static const auto get =
			driver.of_device<PFN_vkGetPipelineExecutablePropertiesKHR>("vkGetPipelineExecutablePropertiesKHR");
	if (!get) {
		return;
	}
	VkPipelineInfoKHR info{ VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR };
	info.pipeline = handle;
	uint32_t count = 0;
	get(device, &info, &count, nullptr);
	std::vector<VkPipelineExecutablePropertiesKHR> stages(
			count, { VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR });
	get(device, &info, &count, stages.data());
	for (uint32_t i = 0; i < count; i++) {
		log.line("stage %d %s subgroup=%u%s", number, stages[i].name, stages[i].subgroupSize,
				statistics_of(device, handle, i).c_str());
	}
}

VkResult create_one(
		VkDevice device, VkGraphicsPipelineCreateInfo info, const VkAllocationCallbacks *allocator, VkPipeline *out) {
	static const auto create = driver.of_device<PFN_vkCreateGraphicsPipelines>("vkCreateGraphicsPipelines");
	static int last_number = 0;
	const std::lock_guard<std::mutex> one_at_a_time(compiling);
	const int number = ++last_number;
	log.line("compiling %d", number);
	info.flags |= VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR;
	// Without the engine's cache: pipelines from a cache have no statistics.
	const VkResult result = create(device, VK_NULL_HANDLE, 1, &info, allocator, out);
	if (result != VK_SUCCESS) {
		return result;
	}
	auto pipeline = std::make_unique<Pipeline>();
	pipeline->number = number;
	const VkPipelineVertexInputStateCreateInfo *input = info.pVertexInputState;
	for (uint32_t i = 0; input && i < input->vertexBindingDescriptionCount; i++) {
		const VkVertexInputBindingDescription &binding = input->pVertexBindingDescriptions[i];
		pipeline->bindings.push_back({ binding.binding, binding.stride });
	}
	log.line("pipeline %d vertex=%016llx colours=%d attributes=%u", number,
			static_cast<unsigned long long>(vertex_hash(info)), written_colours(info.pColorBlendState),
			input ? input->vertexAttributeDescriptionCount : 0);
	log_stages(device, *out, number);
	const std::lock_guard<std::mutex> guard(mutex);
	pipelines[*out] = std::move(pipeline);
	return result;
}

VkResult create_graphics(VkDevice device, VkPipelineCache, uint32_t count, const VkGraphicsPipelineCreateInfo *infos,
		const VkAllocationCallbacks *allocator, VkPipeline *out) {
	VkResult result = VK_SUCCESS;
	for (uint32_t i = 0; i < count; i++) {
		const VkResult one = create_one(device, infos[i], allocator, &out[i]);
		result = one == VK_SUCCESS ? result : one;
	}
	return result;
}

/// Compute pipelines are not measured, so they take no time either.
VkResult create_compute(VkDevice, VkPipelineCache, uint32_t count, const VkComputePipelineCreateInfo *,
		const VkAllocationCallbacks *, VkPipeline *out) {
	for (uint32_t i = 0; i < count; i++) {
		out[i] = reinterpret_cast<VkPipeline>(make_handle());
	}
	return VK_SUCCESS;
}

/// Keeps it, so that its handle stays unique in the log.
void destroy_pipeline(VkDevice, VkPipeline, const VkAllocationCallbacks *) {}

} // namespace

const Pipeline *find_pipeline(VkPipeline handle) {
	static const Pipeline none;
	const std::lock_guard<std::mutex> guard(mutex);
	const auto found = pipelines.find(handle);
	return found == pipelines.end() ? &none : found->second.get();
}

std::vector<Replacement> pipeline_replacements() {
	return {
		replacement("vkCreateShaderModule", create_module),
		replacement("vkCreateGraphicsPipelines", create_graphics),
		replacement("vkCreateComputePipelines", create_compute),
		replacement("vkDestroyPipeline", destroy_pipeline),
	};
}

} // namespace gpu
