#pragma once

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/array.hpp>

namespace undergrowth {

/// Calls a script's override on the main thread. Sets `problem` if it cannot run or its result is not of type `wanted`
/// (NIL: no result). An integer is accepted for a float.
godot::Variant call_script_override(godot::Resource *resource, const godot::StringName &method,
		const godot::Array &arguments, godot::Variant::Type wanted, godot::String &problem);

} // namespace undergrowth
