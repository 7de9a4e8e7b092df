#pragma once

#include "field/resources/field_options.hpp"

#include <godot_cpp/variant/string.hpp>

namespace undergrowth {

/// True if a property of a field has an effect with the field's ground and area. False for properties of the engine's
/// base classes that only affect a single mesh. The inspector shows the properties for which it is true. (Properties
/// with a slider always stay: a rebuilt property list would interrupt dragging it.)
bool shows_in_inspector(const godot::String &name, const PlacementOptions &options);

} // namespace undergrowth
