#pragma once

#include "field/field_options.hpp"
#include "field/field_style.hpp"
#include "stand/plant_store.hpp"

#include <vector>

namespace undergrowth {

/// Returns looks of added plants that no species of the list has. `numbers` gets the new index of each look of `style`,
/// or -1: species of the list first, then these looks.
std::vector<FieldLook> others_of(
		const FieldStyle &style, const PlantStore &store, const StandOptions &options, std::vector<int> &numbers);

/// True if a style matches the list in `options`: the same species, seeds, variants and segments.
bool is_listed_so(const FieldStyle &style, const StandOptions &options);

/// Returns the entry of the list with this function, or null.
godot::Ref<PlantFieldSpecies> listed_entry(const StandOptions &options, const godot::Ref<PlantFunction> &function);
/// Returns the listed species with this layer of its map, or null.
godot::Ref<PlantFunction> listed_species(const StandOptions &options, const godot::String &name);
/// Returns the map layers of the listed species.
godot::PackedStringArray layers_of(const StandOptions &options);
/// Returns the painted layers that no listed species has.
godot::PackedStringArray forgotten_layers(const StandOptions &options);

} // namespace undergrowth
