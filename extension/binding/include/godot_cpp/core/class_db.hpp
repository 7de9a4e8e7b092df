#pragma once

#include <memory>
#include <unordered_map>

#include <godot_cpp/core/bound_method.hpp>
#include <godot_cpp/core/class_record.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/gdvirtual.gen.inc>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/godot.hpp>

namespace godot {

// The name of a method and the names of its arguments.
struct MethodDefinition {
	StringName name;
	std::vector<StringName> args;

	MethodDefinition(const char *p_name) : name(p_name) {}
	MethodDefinition(const StringName &p_name, std::vector<StringName> p_args = {}) :
			name(p_name), args(std::move(p_args)) {}
};

template <typename... Args> MethodDefinition D_METHOD(const StringName &p_name, const Args &...p_args) {
	return MethodDefinition(p_name, { StringName(p_args)... });
}

#define DEFVAL(m_default) (m_default)

// Registers classes of the library with their methods, properties, signals and constants.
class ClassDB {
	static internal::ClassRecord *current_record(const StringName &p_class);
	static void add_class(std::unique_ptr<internal::ClassRecord> p_record);
	static void add_method(const StringName &p_class, std::unique_ptr<internal::BoundMethod> p_method,
			const MethodDefinition &p_definition, std::vector<Variant> p_defaults);

	template <typename T>
	static void add_class(bool p_is_virtual, bool p_is_abstract, bool p_is_exposed, bool p_is_runtime);

public:
	template <typename T> static void register_class(bool p_virtual = false) {
		add_class<T>(p_virtual, std::is_abstract_v<T>, true, false);
	}
	template <typename T> static void register_abstract_class() { add_class<T>(false, true, true, false); }
	template <typename T> static void register_internal_class() {
		add_class<T>(false, std::is_abstract_v<T>, false, false);
	}
	template <typename T> static void register_runtime_class() {
		add_class<T>(false, std::is_abstract_v<T>, true, true);
	}

	template <typename M, typename... Defaults>
	static void bind_method(const MethodDefinition &p_definition, M p_method, const Defaults &...p_defaults) {
		using Class = typename internal::FunctionType<M>::Class;
		add_method(Class::get_class_static(), std::make_unique<internal::MemberMethod<M>>(p_method), p_definition,
				{ Variant(p_defaults)... });
	}
	template <typename M, typename... Defaults>
	static void bind_static_method(const StringName &p_class, const MethodDefinition &p_definition, M p_method,
			const Defaults &...p_defaults) {
		add_method(p_class, std::make_unique<internal::StaticMethod<M>>(p_method), p_definition,
				{ Variant(p_defaults)... });
	}
	static void add_virtual_method(
			const StringName &p_class, const MethodInfo &p_method, const std::vector<StringName> &p_names = {});

	static void add_property(const StringName &p_class, const PropertyInfo &p_info, const StringName &p_setter,
			const StringName &p_getter, int p_index = -1);
	static void add_property_group(const StringName &p_class, const String &p_name, const String &p_prefix);
	static void add_property_subgroup(const StringName &p_class, const String &p_name, const String &p_prefix);
	static void add_signal(const StringName &p_class, const MethodInfo &p_signal);
	static void bind_integer_constant(const StringName &p_class, const StringName &p_enum, const StringName &p_name,
			int64_t p_value, bool p_is_bit_field = false);

	// All registrations are inside of one level and end with it.
	static void initialize(GDExtensionInitializationLevel p_level);
	static void deinitialize(GDExtensionInitializationLevel p_level);
};

template <typename T>
void ClassDB::add_class(bool p_is_virtual, bool p_is_abstract, bool p_is_exposed, bool p_is_runtime) {
	auto record = std::make_unique<internal::ClassRecord>();
	record->class_name = T::get_class_static();
	record->parent_name = T::get_parent_class_static();
	record->native_name = T::native_type::get_class_static();
	record->is_virtual = p_is_virtual;
	record->is_abstract = p_is_abstract;
	record->is_exposed = p_is_exposed;
	record->is_runtime = p_is_runtime;
	if constexpr (!std::is_abstract_v<T>) {
		record->construct = []() -> Wrapped * { return new T; };
	}
	internal::record_of_class<T> = record.get();
	internal::ClassHooks<T> hooks{ *record };
	T::_describe_class(hooks);
	add_class(std::move(record));
	T::_initialize_class();
}

} // namespace godot

#define GDREGISTER_CLASS(m_class) ::godot::ClassDB::register_class<m_class>();
#define GDREGISTER_VIRTUAL_CLASS(m_class) ::godot::ClassDB::register_class<m_class>(true);
#define GDREGISTER_ABSTRACT_CLASS(m_class) ::godot::ClassDB::register_abstract_class<m_class>();
#define GDREGISTER_INTERNAL_CLASS(m_class) ::godot::ClassDB::register_internal_class<m_class>();
#define GDREGISTER_RUNTIME_CLASS(m_class) ::godot::ClassDB::register_runtime_class<m_class>();

// For use in _bind_methods().
#define ADD_PROPERTY(m_property, m_setter, m_getter)                                                                   \
	::godot::ClassDB::add_property(get_class_static(), m_property, m_setter, m_getter)
#define ADD_PROPERTYI(m_property, m_setter, m_getter, m_index)                                                         \
	::godot::ClassDB::add_property(get_class_static(), m_property, m_setter, m_getter, m_index)
#define ADD_GROUP(m_name, m_prefix) ::godot::ClassDB::add_property_group(get_class_static(), m_name, m_prefix)
#define ADD_SUBGROUP(m_name, m_prefix) ::godot::ClassDB::add_property_subgroup(get_class_static(), m_name, m_prefix)
#define ADD_SIGNAL(m_signal) ::godot::ClassDB::add_signal(get_class_static(), m_signal)
#define GODOT_BIND_CONSTANT(m_constant, m_enum, m_is_bit_field)                                                        \
	::godot::ClassDB::bind_integer_constant(                                                                           \
			get_class_static(), m_enum, ::godot::StringName(#m_constant), int64_t(m_constant), m_is_bit_field)
#define GODOT_ENUM_NAME_OF(m_constant)                                                                                 \
	::godot::internal::enum_name(::godot::internal::TypeTraits<decltype(m_constant)>::cpp_name)
#define BIND_CONSTANT(m_constant) GODOT_BIND_CONSTANT(m_constant, ::godot::StringName(), false)
#define BIND_ENUM_CONSTANT(m_constant) GODOT_BIND_CONSTANT(m_constant, GODOT_ENUM_NAME_OF(m_constant), false)
#define BIND_BITFIELD_FLAG(m_constant) GODOT_BIND_CONSTANT(m_constant, GODOT_ENUM_NAME_OF(m_constant), true)
