#pragma once

#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/vector2.hpp>

namespace undergrowth {

/// Inclusive range of a number that users set.
struct Range {
	double min;
	double max;
};

/// Returns the text for an object in messages: its class and its location. For a resource: its file, or else its script
/// or name and the file that contains it. For a node: its path in the game or in the edited scene.
godot::String describe(const godot::Object *object);

/// Prints one error that contains the location of `object`. `what` says what is wrong and what to do. For a resource
/// that is being read from its file, the error is deferred to the end of the frame, when the path exists.
void report_error(const godot::Object *object, const godot::String &what);

/// Prints a warning, for values that may be intended.
void report_warning(const godot::Object *object, const godot::String &what);

/// True if `value` is finite and within `range`, else reports that `property` retains its value, and why.
bool accept_value(const godot::Object *object, const char *property, double value, const Range &range);

/// accept_value() for an angle: `radians` is accepted within the range `degrees`. The message contains both units,
/// because they are easily confused.
bool accept_angle(const godot::Object *object, const char *property, double radians, const Range &degrees);

/// accept_value() for both ends of a span from x to y; `before` is the present span. If one new end passes the other,
/// both become that end. Two new ends in the wrong order are an error.
bool accept_span(const godot::Object *object, const char *property, const godot::Vector2 &before, godot::Vector2 &value,
		const Range &range);

/// accept_span() for angles in radians, with a range in degrees.
bool accept_angle_span(const godot::Object *object, const char *property, const godot::Vector2 &before,
		godot::Vector2 &radians, const Range &degrees);

} // namespace undergrowth
