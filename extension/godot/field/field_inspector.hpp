#pragma once

#include "field/field_options.hpp"

#include <godot_cpp/variant/string.hpp>

namespace undergrowth {

/// Whether a field's property counts for the ground and the area that it has, and is no more than what the engine's
/// base classes say of one mesh: the inspector shows those. (Properties with a slider stay: a new list would end the
/// dragging of it.)
bool shows_in_inspector(const godot::String &name, const StandOptions &options);

} // namespace undergrowth
