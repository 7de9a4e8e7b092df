#pragma once

#include "field/resources/field_options.hpp"
#include "field/view/field_render_setup.hpp"

#include <godot_cpp/classes/geometry_instance3d.hpp>

#include <vector>

namespace undergrowth {

// Reads the levels of detail that users set, or the defaults. Main thread.

/// Returns what is wrong with the levels that users set.
godot::String find_level_fault(const ViewOptions &options);

/// Visibility range and LOD bias of a field, from the engine's own properties.
struct SightRange {
	float end = 0.0f; ///< m; 0: no end.
	float lod_bias = 1.0f; ///< Factor of the end distances of all levels.

	bool operator!=(const SightRange &other) const { return end != other.end || lod_bias != other.lod_bias; }
};

SightRange sight_range_of(const godot::GeometryInstance3D *node);

/// Returns levels up to the range's end, at least one. Without user levels, the defaults depend on the species.
std::vector<FieldLevel> read_levels(const FieldProperties &options, const SightRange &range);

/// True if only species without cards use a default level with this number of segments: on cards, heads of these forms
/// would cover far less than the plant's.
bool is_for_solids(int segments);

/// Returns how the levels of species are chosen.
LevelRule read_level_rule(const FieldProperties &options, const SightRange &range);

} // namespace undergrowth
