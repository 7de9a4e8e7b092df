#include "form/set_by_names.hpp"

#include "base/messages.hpp"

#include <godot_cpp/variant/packed_string_array.hpp>

using namespace godot;

namespace undergrowth {

static bool is_number(const Variant &value) {
	return value.get_type() == Variant::FLOAT || value.get_type() == Variant::INT;
}

// Returns the types of a resource's own properties by their names, without the properties of every resource.
static Dictionary types_of(Resource *resource) {
	Dictionary types;
	const Array all = resource->get_property_list();
	for (int64_t i = 0; i < all.size(); i++) {
		const Dictionary property = all[i];
		const String name = property["name"];
		const int64_t usage = property["usage"];
		if ((usage & int64_t(PROPERTY_USAGE_STORAGE)) != 0 && !name.begins_with("resource_") && name != "script") {
			types[name] = property["type"];
		}
	}
	return types;
}

// Converts a number to a range with equal ends.
static Variant as_range(const Variant &value, Variant::Type type) {
	if (type == Variant::VECTOR2 && is_number(value)) {
		return Vector2(float(double(value)), float(double(value)));
	}
	if (type == Variant::VECTOR2I && value.get_type() == Variant::INT) {
		return Vector2i(int32_t(int64_t(value)), int32_t(int64_t(value)));
	}
	return value;
}

void set_by_names(Resource *resource, const Dictionary &values) {
	const Dictionary types = types_of(resource);
	const Array names = values.keys();
	for (int64_t i = 0; i < names.size(); i++) {
		const String name = names[i];
		if (!types.has(name)) {
			const PackedStringArray known = types.keys();
			report_error(resource, "has no '" + name + "'. Use " + String(", ").join(known) + ".");
			continue;
		}
		const auto type = Variant::Type(int64_t(types[name]));
		const Variant value = as_range(values[names[i]], type);
		if (value.get_type() != type && !Variant::can_convert_strict(value.get_type(), type)) {
			report_error(resource,
					"'" + name + "' cannot be of type " + Variant::get_type_name(value.get_type()) + ". Give it a " +
							Variant::get_type_name(type) + ".");
			continue;
		}
		resource->set(name, value);
	}
}

} // namespace undergrowth
