#include "base/messages.hpp"

#include "base/deferred_error.hpp"
#include "conventions.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/script.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr double RADIANS_PER_DEGREE = PI / 180.0;
static constexpr int SPAN_DECIMALS = 5; // Precision of most spans in floats.
static constexpr double ANGLE_TOLERANCE = 1e-5; // Degrees: precision of angles in floats.

// Returns the file of a resource, or the file that embeds it.
static String file_of(const Resource *resource) {
	return resource->get_path().get_slice("::", 0);
}

// Returns the resource's file, or else its script, because its faults are fixed there, or else its name.
static String describe_resource(const Resource *resource) {
	const String file = file_of(resource);
	const bool is_embedded = resource->get_path() != file;
	if (!is_embedded && !file.is_empty()) {
		return " '" + file + "'";
	}
	const Ref<Script> script = resource->get_script();
	String label = script.is_valid() ? file_of(script.ptr()) : String();
	if (label.is_empty()) {
		label = resource->get_name();
	}
	return (label.is_empty() ? String() : " '" + label + "'") + (is_embedded ? " in '" + file + "'" : String());
}

// In a game, paths start at the root. In the editor the edited scene is below the editor's own nodes, so paths start at
// the root of the scene.
static String describe_node(Node *node) {
	if (!node->is_inside_tree()) {
		return node->get_name();
	}
	Node *root = node->get_tree()->get_edited_scene_root();
	if (!root && !Engine::get_singleton()->is_editor_hint()) {
		return node->get_path();
	}
	if (!root || (root != node && !root->is_ancestor_of(node))) {
		root = node->get_owner();
	}
	if (!root || root == node) {
		return node->get_name();
	}
	return String(root->get_name()) + "/" + String(root->get_path_to(node));
}

String describe(const Object *object) {
	if (const Resource *resource = Object::cast_to<Resource>(object)) {
		return object->get_class() + describe_resource(resource);
	}
	Node *node = Object::cast_to<Node>(const_cast<Object *>(object)); // The engine's getters are not const.
	const String label = node ? describe_node(node) : String();
	return label.is_empty() ? object->get_class() : object->get_class() + " '" + label + "'";
}

void report_error(const Object *object, const String &what) {
	if (DeferredError::suits(object)) {
		DeferredError::post(object, what);
		return;
	}
	UtilityFunctions::push_error(describe(object) + ": " + what);
}

void report_warning(const Object *object, const String &what) {
	UtilityFunctions::push_warning(describe(object) + ": " + what);
}

bool accept_value(const Object *object, const char *property, double value, const Range &range) {
	if (std::isfinite(value) && value >= range.min && value <= range.max) {
		return true;
	}
	report_error(object,
			String(property) + " cannot be " + String::num(value) + "; the old value stays. Set a number from " +
					String::num(range.min) + " to " + String::num(range.max) + ".");
	return false;
}

bool accept_angle(const Object *object, const char *property, double radians, const Range &degrees) {
	const double turned = radians / RADIANS_PER_DEGREE;
	if (std::isfinite(radians) && turned >= degrees.min - ANGLE_TOLERANCE && turned <= degrees.max + ANGLE_TOLERANCE) {
		return true;
	}
	const bool looks_like_degrees = std::isfinite(radians) && radians >= degrees.min && radians <= degrees.max;
	const double meant = looks_like_degrees ? radians : degrees.max;
	report_error(object,
			String(property) + " cannot be " + String::num(radians) + " rad, which is " + String::num(turned, 1) +
					String::utf8("°; the old value stays. Set an angle from ") + String::num(degrees.min) + " to " +
					String::num(degrees.max) + String::utf8("°, in radians: deg_to_rad(") + String::num(meant) +
					(looks_like_degrees ? String::utf8(") is ") + String::num(meant) + String::utf8("°.")
										: String(") is the largest.")));
	return false;
}

// If one end passes the other, moves the other with it. Returns false if both are new.
static bool order_span(const Vector2 &before, Vector2 &value) {
	if (value.y >= value.x) {
		return true;
	}
	if (value.x != before.x && value.y != before.y) {
		return false;
	}
	value = value.x != before.x ? Vector2(value.x, value.x) : Vector2(value.y, value.y);
	return true;
}

static bool accept_order(const Object *object, const char *property, const Vector2 &before, Vector2 &value) {
	const Vector2 given = value;
	if (order_span(before, value)) {
		return true;
	}
	report_error(object,
			String(property) + " goes from " + String::num(given.x, SPAN_DECIMALS) + " down to " +
					String::num(given.y, SPAN_DECIMALS) + "; the old value stays. Set the smaller number first.");
	return false;
}

bool accept_span(
		const Object *object, const char *property, const Vector2 &before, Vector2 &value, const Range &range) {
	return accept_value(object, property, value.x, range) && accept_value(object, property, value.y, range) &&
			accept_order(object, property, before, value);
}

bool accept_angle_span(
		const Object *object, const char *property, const Vector2 &before, Vector2 &radians, const Range &degrees) {
	return accept_angle(object, property, radians.x, degrees) && accept_angle(object, property, radians.y, degrees) &&
			accept_order(object, property, before, radians);
}

} // namespace undergrowth
