#pragma once

#include "field/plant_field_species.hpp"

#include <godot_cpp/classes/node.hpp>

namespace undergrowth {

/// One sentence or two about an entry of a field's list that has no species: which one, what file is missing where that
/// is known, and what to do. `field` may be null: then no file is looked for.
godot::String describe_empty_entry(const godot::Node *field, int number, const godot::Ref<PlantFieldSpecies> &entry);

} // namespace undergrowth
