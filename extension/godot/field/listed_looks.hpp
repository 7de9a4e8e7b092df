#pragma once

#include "field/field_options.hpp"
#include "field/field_style.hpp"
#include "stand/plant_store.hpp"

#include <vector>

namespace undergrowth {

/// Looks of plants that code added and that no species of the list has, and in `numbers` what each look of `style` is
/// from now on, or -1: species of the list have its numbers, and these come after them.
std::vector<FieldLook> others_of(
		const FieldStyle &style, const PlantStore &store, const StandOptions &options, std::vector<int> &numbers);

/// Whether a style is what `options` list: the same species, of the same seeds, and as many variants and segments.
bool is_listed_so(const FieldStyle &style, const StandOptions &options);

/// The entry of the list that a function is of, or null.
godot::Ref<PlantFieldSpecies> listed_entry(const StandOptions &options, const godot::Ref<PlantFunction> &function);
/// The listed species that its map knows by this name, or null.
godot::Ref<PlantFunction> listed_species(const StandOptions &options, const godot::String &name);
/// What its map calls the listed species.
godot::PackedStringArray layers_of(const StandOptions &options);
/// What is painted of none of them.
godot::PackedStringArray forgotten_layers(const StandOptions &options);

} // namespace undergrowth
