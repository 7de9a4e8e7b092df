#pragma once

#include "driver.hpp"

#include <vector>

/// Graphics pipelines: the driver compiles them, and its statistics go into the log.
///
///     compiling 12
///     pipeline 12 vertex=4be1a6f0c1d2e3f4 colours=1 attributes=9
///     stage 12 vertex subgroup=64; VGPRs=96; ...; Inverse Throughput=1951
///
/// vertex: hash of the SPIR-V of the vertex stage. colours: attachments that are written. attributes: of vertices.
namespace gpu {

/// The stride (bytes) of the vertices of a binding.
struct VertexBinding {
	uint32_t binding = 0;
	uint32_t stride = 0;
};

struct Pipeline {
	int number = -1; ///< In the log. -1: not a pipeline of the driver.
	std::vector<VertexBinding> bindings;
};

/// Returns the pipeline of a handle. It stays valid.
const Pipeline *find_pipeline(VkPipeline handle);

std::vector<Replacement> pipeline_replacements();

} // namespace gpu
