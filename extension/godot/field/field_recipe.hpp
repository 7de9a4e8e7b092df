#pragma once

#include "field/field_fill.hpp"
#include "field/field_options.hpp"
#include "stand/area.hpp"

#include <godot_cpp/classes/geometry_instance3d.hpp>
#include <godot_cpp/classes/node3d.hpp>

#include <vector>

namespace undergrowth {

// Reads from properties and scene what growing a field needs to know. Main thread. What returns a String tells what is
// wrong and what to do about it, or nothing.

/// From a node's axes to the world's. A node that is scaled to nothing, or is nowhere, counts as one at the origin, so
/// that everything can be brought back into its axes.
godot::Transform3D axes_of(const godot::Node3D *node);

/// The seed for the positions of plants in a field of this `seed`; for PLACE_SEED one from the node's global position.
int64_t seed_at(const godot::Node3D *node, int64_t seed);

/// Where plants stand, and of which species of the list. `style` has those that are absent. With `part` (m, field axes)
/// only what is in that box, and of the map what meets it.
godot::String read_request(const godot::Node3D *field, const StandOptions &options, const FieldStyle &style,
		const AreaBox *part, PlacementRequest &into);

/// What they stand on.
godot::String read_ground(const godot::Node3D *field, const StandOptions &options, FieldGround &into);

/// What is wrong with the levels that users set.
godot::String find_level_fault(const ViewOptions &options);

/// How far a field is seen, and how finely: what the engine's own properties say.
struct SightRange {
	float end = 0.0f; ///< m; 0: without end.
	float lod_bias = 1.0f; ///< By what all levels end farther away.

	bool operator!=(const SightRange &other) const { return end != other.end || lod_bias != other.lod_bias; }
};

SightRange sight_range_of(const godot::GeometryInstance3D *node);

/// Levels up to the range's end, at least one. Where none are set they hang on the species.
std::vector<FieldLevel> read_levels(const FieldProperties &options, const SightRange &range);

/// The first species of the list that is this function, or -1.
int64_t number_in_list(const StandOptions &options, const godot::Ref<PlantFunction> &function);

/// A look for each species of the list, not sampled yet; then for each of `others`. Entries without a species are
/// absent; where all are, that is the fault.
/// `field`, which may be null, helps to name a missing file.
godot::String list_looks(
		const godot::Node *field, const StandOptions &options, const std::vector<FieldLook> &others, FieldStyle &into);

/// Whether worker threads may make meshes, too. What they are made of is built there anyway.
bool renders_on_threads();

/// Samples what looks have not sampled yet, until `usec` have gone by: a script's answer cannot be cut short.
/// `is_done`: all are sampled. A species with a fault becomes absent, unless it is one of `standing`, or the last that
/// is left.
godot::String sample_looks(
		FieldStyle &style, const std::vector<godot::Ref<PlantFunction>> &standing, double usec, bool &is_done);

/// A look of a function that code adds plants of, sampled and built.
godot::String read_other_look(const godot::Ref<PlantFunction> &function, const StandOptions &options,
		const FieldStyle &style, FieldLook &into);

} // namespace undergrowth
