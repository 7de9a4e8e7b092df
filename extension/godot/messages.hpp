#pragma once

#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/vector2.hpp>

namespace undergrowth {

/// Inclusive bounds of a number that users set.
struct Range {
	double least;
	double most;
};

/// How messages call an object: its class, and where a user finds it. A resource by its file, else by its script or
/// name and the file that it is embedded in; a node by its path in the game or in the edited scene.
godot::String describe(const godot::Object *object);

/// One error in Godot's log that names its object and says what to do. Of a resource that is being read from its file
/// it comes at the end of the frame: only then is it known which file that is.
void report_error(const godot::Object *object, const godot::String &what);

/// The same for what may be meant so, as a warning.
void report_warning(const godot::Object *object, const godot::String &what);

/// True where `value` is finite and within `range`; else reports that `property` keeps its value, and why.
bool accept_value(const godot::Object *object, const char *property, double value, const Range &range);

/// The same of an angle: `radians` within `degrees`. The message speaks of both, as one is easily taken for the other.
bool accept_angle(const godot::Object *object, const char *property, double radians, const Range &degrees);

/// The same of a span from x up to y, which is `before` until then. Where one end passes the other, `value` becomes a
/// span of no width there; where both ends are new and in the wrong order, that is an error.
bool accept_span(const godot::Object *object, const char *property, const godot::Vector2 &before, godot::Vector2 &value,
		const Range &range);

/// The same of angles in radians, within `degrees`.
bool accept_angle_span(const godot::Object *object, const char *property, const godot::Vector2 &before,
		godot::Vector2 &radians, const Range &degrees);

} // namespace undergrowth
