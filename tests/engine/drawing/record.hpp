#pragma once

#include <godot_cpp/variant/aabb.hpp>

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace recorder {

struct Multimesh {
	int64_t shown = -1; ///< Instances; -1: all.
	uint64_t mesh = 0; ///< A RID.
	godot::AABB box; ///< Field axes, m.
	std::vector<float> buffer;
};

struct Instance {
	uint64_t multimesh = 0; ///< A RID, as all keys below.
	uint64_t scenario = 0; ///< A RID.
	bool is_visible = true;
	uint32_t gi_flags = 1; ///< 1: baked light, 2: dynamic; new instances of the engine have the first.
	double begin = 0.0; ///< m, of the visibility range.
	double end = 0.0; ///< m; 0: without end.
};

/// State of the renderer by the add-on's calls. It references no engine objects.
struct Record {
	std::mutex mutex;
	std::map<uint64_t, Multimesh> multimeshes;
	std::map<uint64_t, Instance> instances;
	std::map<uint64_t, std::vector<std::vector<uint8_t>>> textures; ///< Bytes of each layer.
	std::map<std::string, int64_t> parameters; ///< Calls of material_set_param() by the parameter's name.
};

Record &record();

} // namespace recorder
