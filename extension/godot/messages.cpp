#include "messages.hpp"

#include "conventions.hpp"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/classes/script.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr double RADIANS_PER_DEGREE = PI / 180.0;
static constexpr double ANGLE_TOLERANCE = 1e-5; // Degrees; what single precision leaves of them.

static String describe_resource(const Resource *resource) {
	String label = resource->get_path();
	if (label.is_empty()) {
		label = resource->get_name();
	}
	const Ref<Script> script = resource->get_script();
	if (label.is_empty() && script.is_valid()) {
		label = script->get_path();
	}
	return label;
}

String describe(const Object *object) {
	String label;
	if (const Node *node = Object::cast_to<Node>(object)) {
		label = node->is_inside_tree() ? String(node->get_path()) : String(node->get_name());
	} else if (const Resource *resource = Object::cast_to<Resource>(object)) {
		label = describe_resource(resource);
	}
	return label.is_empty() ? object->get_class() : object->get_class() + " '" + label + "'";
}

void report_error(const Object *object, const String &what) {
	UtilityFunctions::push_error(describe(object) + ": " + what);
}

void report_warning(const Object *object, const String &what) {
	UtilityFunctions::push_warning(describe(object) + ": " + what);
}

bool accept_value(const Object *object, const char *property, double value, const Range &range) {
	if (std::isfinite(value) && value >= range.least && value <= range.most) {
		return true;
	}
	report_error(object,
			String(property) + " cannot be " + String::num(value) + ", it keeps its value. Set a number from " +
					String::num(range.least) + " to " + String::num(range.most) + ".");
	return false;
}

bool accept_angle(const Object *object, const char *property, double radians, const Range &degrees) {
	const double turned = radians / RADIANS_PER_DEGREE;
	if (std::isfinite(radians) && turned >= degrees.least - ANGLE_TOLERANCE &&
			turned <= degrees.most + ANGLE_TOLERANCE) {
		return true;
	}
	report_error(object,
			String(property) + " cannot be " + String::num(radians) + " rad, which is " + String::num(turned, 1) +
					String::utf8("°, it keeps its value. Set an angle from ") + String::num(degrees.least) + " to " +
					String::num(degrees.most) + String::utf8("°, in radians: deg_to_rad(") +
					String::num(degrees.most) + ") is the largest.");
	return false;
}

bool accept_span(const Object *object, const char *property, const Vector2 &value, const Range &range) {
	if (!accept_value(object, property, value.x, range) || !accept_value(object, property, value.y, range)) {
		return false;
	}
	if (value.y < value.x) {
		report_error(object,
				String(property) + " goes from " + String::num(value.x) + " down to " + String::num(value.y) +
						", it keeps its value. Set the smaller number first.");
		return false;
	}
	return true;
}

} // namespace undergrowth
