#pragma once

#include <godot_cpp/classes/object.hpp>
#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/core/object_id.hpp>
#include <godot_cpp/core/type_info.hpp>

namespace godot {

// A method or a signal, as the engine lists it.
struct MethodInfo {
	StringName name;
	PropertyInfo return_val;
	uint32_t flags = METHOD_FLAGS_DEFAULT;
	int id = 0;
	std::vector<PropertyInfo> arguments;
	std::vector<Variant> default_arguments;
	GDExtensionClassMethodArgumentMetadata return_val_metadata = GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;
	std::vector<GDExtensionClassMethodArgumentMetadata> arguments_metadata;

	MethodInfo() = default;
	explicit MethodInfo(const StringName &p_name) : name(p_name) {}
	template <typename... Args>
	MethodInfo(const StringName &p_name, const Args &...p_arguments) : name(p_name), arguments{ p_arguments... } {}
	template <typename... Args>
	MethodInfo(Variant::Type p_return, const StringName &p_name, const Args &...p_arguments) :
			name(p_name), return_val(PropertyInfo(p_return, StringName())), arguments{ p_arguments... } {}
	template <typename... Args>
	MethodInfo(const PropertyInfo &p_return, const StringName &p_name, const Args &...p_arguments) :
			name(p_name), return_val(p_return), arguments{ p_arguments... } {}
};

class ObjectDB {
public:
	// Null if the object was freed.
	static Object *get_instance(uint64_t p_id);
	static Object *get_instance(ObjectID p_id) { return get_instance(uint64_t(p_id)); }
};

} // namespace godot
