#pragma once

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/dictionary.hpp>

namespace recorder {

/// The record, for test scripts.
class DrawingRecord : public godot::RefCounted {
	GDCLASS(DrawingRecord, godot::RefCounted)

protected:
	static void _bind_methods();

public:
	/// All instances of multimeshes that exist: `visible`, `begin`, `end`, `box`, `shown` (-1: all), `buffer`,
	/// `gi_flags`, `mesh` (the id of its RID).
	static godot::Array get_instances();
	/// All textures that exist, by the id of their RID: an Array of the bytes of each layer.
	static godot::Dictionary get_textures();
	/// Returns the number of calls of material_set_param() for a parameter.
	static int64_t count_parameter(const godot::String &name);
};

} // namespace recorder
