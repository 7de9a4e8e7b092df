#include "form/set_by_names.hpp"

#include "messages.hpp"

#include <godot_cpp/variant/packed_string_array.hpp>

using namespace godot;

namespace undergrowth {

static bool is_number(const Variant &value) {
	return value.get_type() == Variant::FLOAT || value.get_type() == Variant::INT;
}

// The properties of its own, without those of every resource.
static PackedStringArray names_of(Resource *resource) {
	PackedStringArray names;
	const Array all = resource->get_property_list();
	for (int64_t i = 0; i < all.size(); i++) {
		const Dictionary property = all[i];
		const String name = property["name"];
		const int64_t usage = property["usage"];
		if ((usage & int64_t(PROPERTY_USAGE_STORAGE)) != 0 && !name.begins_with("resource_") && name != "script") {
			names.push_back(name);
		}
	}
	return names;
}

void set_by_names(Resource *resource, const Dictionary &values) {
	const PackedStringArray known = names_of(resource);
	const Array names = values.keys();
	for (int64_t i = 0; i < names.size(); i++) {
		const String name = names[i];
		if (!known.has(name)) {
			report_error(resource, "has no '" + name + "'. Use " + String(", ").join(known) + ".");
			continue;
		}
		Variant value = values[names[i]];
		const Variant now = resource->get(name);
		if (now.get_type() == Variant::VECTOR2 && is_number(value)) {
			value = Vector2(float(double(value)), float(double(value)));
		} else if (now.get_type() == Variant::VECTOR2I && value.get_type() == Variant::INT) {
			value = Vector2i(int32_t(int64_t(value)), int32_t(int64_t(value)));
		}
		resource->set(name, value);
	}
}

} // namespace undergrowth
