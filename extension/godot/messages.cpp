#include "messages.hpp"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/classes/script.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

#include <cmath>

using namespace godot;

namespace undergrowth {

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

} // namespace undergrowth
