#pragma once

#include <vector>

#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace godot {

// The engine's description of a property, an argument or a returned value.
struct PropertyInfo {
	Variant::Type type = Variant::NIL;
	StringName name;
	StringName class_name;
	uint32_t hint = PROPERTY_HINT_NONE;
	String hint_string;
	uint32_t usage = PROPERTY_USAGE_DEFAULT;

	PropertyInfo() = default;
	PropertyInfo(Variant::Type p_type, const StringName &p_name, PropertyHint p_hint = PROPERTY_HINT_NONE,
			const String &p_hint_string = String(), uint32_t p_usage = PROPERTY_USAGE_DEFAULT,
			const StringName &p_class_name = StringName()) :
			type(p_type),
			name(p_name),
			class_name(p_hint == PROPERTY_HINT_RESOURCE_TYPE ? StringName(p_hint_string) : p_class_name),
			hint(p_hint),
			hint_string(p_hint_string),
			usage(p_usage) {}

	bool operator==(const PropertyInfo &p_other) const {
		return type == p_other.type && name == p_other.name && class_name == p_other.class_name &&
				hint == p_other.hint && hint_string == p_other.hint_string && usage == p_other.usage;
	}

	// Returns the engine's form, which points to this object.
	GDExtensionPropertyInfo c_info() const {
		return { GDExtensionVariantType(type), const_cast<StringName *>(&name), const_cast<StringName *>(&class_name),
			hint, const_cast<String *>(&hint_string), usage };
	}
};

} // namespace godot
