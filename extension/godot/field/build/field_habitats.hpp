#pragma once

#include "field/resources/field_options.hpp"
#include "placement/competition.hpp"
#include "placement/habitats.hpp"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

#include <vector>

namespace undergrowth {

// Reads the habitats of a field's species, and the paths that they depend on. Main thread.

/// Returns the habitat of an entry of the species, or null.
godot::Ref<PlantHabitat> habitat_of(const PlacementOptions &options, int64_t number);
/// Returns the habitats.
Habitats read_habitats(const godot::Node3D *field, const PlacementOptions &options);
/// True if a habitat of some species uses the factor.
bool habitats_use(const PlacementOptions &options, HabitatFactor factor);
/// True if the habitat uses moisture, light or values, which need a survey of the ground.
bool uses_survey(const PlantHabitat *habitat);
/// True if the field has the area that a survey needs.
bool has_area(const PlacementOptions &options);
/// Returns the paths and fields whose distance matters to habitats.
std::vector<godot::Node3D *> find_habitat_nodes(const godot::Node3D *field, const PlacementOptions &options);
/// Returns the competition of the species.
Competition read_competition(const PlacementOptions &options);
/// Returns the object that has the method of a habitat's values, or null.
godot::Object *find_value_source(
		const godot::Node3D *field, const PlacementOptions &options, const PlantHabitat *habitat);
/// Returns warnings about habitats that have no effect, with their remedies.
godot::PackedStringArray find_habitat_warnings(const godot::Node *field, const PlacementOptions &options);

} // namespace undergrowth
