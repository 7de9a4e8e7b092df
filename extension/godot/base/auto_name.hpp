#pragma once

#include "species/plant_function.hpp"

namespace undergrowth {

// The inspector shows list entries by their names. An entry without a name gets one that describes its content. Such a
// name is never saved.

/// Names `resource`, without a signal, if it has no name or still has the previous name `given`.
void update_auto_name(godot::Resource *resource, godot::String &given, const godot::String &name);

/// Excludes the name `given` from files. For `_validate_property`.
void hide_auto_name(const godot::Resource *resource, const godot::String &given, godot::PropertyInfo &property);

/// Returns a short name for a species, such as "Tulip", or an empty string if there is none.
godot::String name_of_species(const godot::Ref<PlantFunction> &species);

} // namespace undergrowth
