#pragma once

#include "field/resources/field_options.hpp"
#include "field/view/field_render_setup.hpp"
#include "placement/plant_store.hpp"

#include <vector>

namespace undergrowth {

/// Returns styles of added plants that no species of the list has. `numbers` gets the new index of each style of
/// `setup`, or -1: species of the list first, then these styles.
std::vector<SpeciesStyle> others_of(const FieldRenderSetup &setup, const PlantStore &store,
		const PlacementOptions &options, std::vector<int> &numbers);

/// True if a setup matches the list in `options`: the same species, seeds, variants and segments.
bool is_listed_so(const FieldRenderSetup &setup, const PlacementOptions &options);

/// Returns the entry of the list with this function, or null.
godot::Ref<PlantFieldSpecies> listed_entry(const PlacementOptions &options, const godot::Ref<PlantFunction> &function);
/// Returns the listed species with this layer of its map, or null.
godot::Ref<PlantFunction> listed_species(const PlacementOptions &options, const godot::String &name);
/// Returns the map layers of the listed species.
godot::PackedStringArray layers_of(const PlacementOptions &options);
/// Returns the painted layers that no listed species has.
godot::PackedStringArray forgotten_layers(const PlacementOptions &options);

} // namespace undergrowth
