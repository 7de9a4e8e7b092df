#pragma once

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/array.hpp>

namespace undergrowth {

/// Calls a script's override on the main thread; tells in `problem` where it cannot run or returned something else than
/// `wanted` (NIL: nothing is wanted). A whole number passes for a float.
godot::Variant call_script_override(godot::Resource *resource, const godot::StringName &method,
		const godot::Array &arguments, godot::Variant::Type wanted, godot::String &problem);

} // namespace undergrowth
