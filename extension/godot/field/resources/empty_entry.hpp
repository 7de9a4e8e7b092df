#pragma once

#include "field/resources/plant_field_species.hpp"

#include <godot_cpp/classes/node.hpp>

namespace undergrowth {

/// Describes an entry of a field's list without a species: which entry, the missing file if it can be found, and what
/// to do. `field` may be null: then no file is searched.
godot::String describe_empty_entry(const godot::Node *field, int number, const godot::Ref<PlantFieldSpecies> &entry);

} // namespace undergrowth
