#pragma once

#include "field/build/field_build.hpp"
#include "field/resources/field_options.hpp"
#include "field/view/field_levels.hpp"
#include "placement/area.hpp"

#include <godot_cpp/classes/geometry_instance3d.hpp>
#include <godot_cpp/classes/node3d.hpp>

#include <vector>

namespace undergrowth {

// Reads the input of a build from properties and scene. Main thread. A returned String describes a fault and its
// remedy; empty: no fault.

/// Returns the transform from a node's axes to the world's, or to its parent's outside the tree. A singular or infinite
/// transform counts as the identity, so that the result is always invertible.
godot::Transform3D axes_of(const godot::Node3D *node);

/// Returns the seed for the positions of plants in a field of this `seed`; for PLACE_SEED, one from the node's global
/// position.
int64_t seed_at(const godot::Node3D *node, int64_t seed);

/// Reads where plants are placed, and of which species of the list. `setup` marks absent species. With `part` (m, field
/// axes): only the plants in that box, and only the cells of the map that meet it.
godot::String read_request(const godot::Node3D *field, const PlacementOptions &options, const FieldRenderSetup &setup,
		const AreaBox *part, PlacementRequest &into);

/// Reads the ground.
godot::String read_ground(const godot::Node3D *field, const PlacementOptions &options, FieldGround &into);

/// Sets the densities of the styles of the list.
void read_densities(const PlacementOptions &options, FieldRenderSetup &into);

/// Returns the first index of this function in the list, or -1.
int64_t number_in_list(const PlacementOptions &options, const godot::Ref<PlantFunction> &function);

/// Appends a style for each species of the list, then one for each of `others`; none is sampled. Entries without a
/// species become absent. Returns a fault only if all are absent. The message uses `field`, which may be null, to name
/// a missing file.
godot::String list_styles(const godot::Node *field, const PlacementOptions &options,
		const std::vector<SpeciesStyle> &others, FieldRenderSetup &into);

/// True if worker threads may create meshes. The mesh arrays are always built on worker threads.
bool renders_on_threads();

/// Samples styles for about `usec` µs; a script cannot be interrupted. Sets `is_done` if all are sampled. A species
/// with a fault becomes absent. The fault is returned if that species is in `existing`, not in the list, or the last
/// one. Loads their shaders, for drafts without that of cards.
godot::String sample_styles(FieldRenderSetup &setup, const std::vector<godot::Ref<PlantFunction>> &existing,
		bool are_drafts, double usec, bool &is_done);

/// Returns a sampled and built style of a function that code adds plants of.
godot::String read_other_style(const godot::Ref<PlantFunction> &function, const PlacementOptions &options,
		const FieldRenderSetup &setup, SpeciesStyle &into);

} // namespace undergrowth
