#pragma once

#include "plant_function.hpp"

namespace undergrowth {

// The inspector shows entries of a list by their names. What a user has not named is named for what it holds; such a
// name is never saved.

/// Names `resource`, without a signal, where it has no name or still the one that was `given` before.
void give_name(godot::Resource *resource, godot::String &given, const godot::String &name);

/// Keeps a name that was `given` out of files. For `_validate_property`.
void hide_given_name(const godot::Resource *resource, const godot::String &given, godot::PropertyInfo &property);

/// A few words for a species, such as "Tulip"; nothing where there is none.
godot::String name_of_species(const godot::Ref<PlantFunction> &species);

} // namespace undergrowth
