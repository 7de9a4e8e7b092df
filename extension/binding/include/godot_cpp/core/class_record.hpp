#pragma once

#include <memory>

#include <godot_cpp/core/bound_method.hpp>
#include <godot_cpp/core/engine_class.hpp>

namespace godot::internal {

// The registration of one class of the library.
struct ClassRecord {
	StringName class_name;
	StringName parent_name;
	StringName native_name; // the engine class below all classes of the library
	ClassRecord *parent = nullptr; // the base class in the library, if any
	int level = 0;
	bool is_virtual = false;
	bool is_abstract = false;
	bool is_exposed = true;
	bool is_runtime = false;

	Wrapped *(*construct)() = nullptr;
	VirtualTable virtuals;
	std::vector<std::unique_ptr<BoundMethod>> methods;

	// Functions that the class itself declares. The callers also call those of the base classes.
	void (*notification)(Wrapped *, int) = nullptr;
	bool (*set)(Wrapped *, const StringName &, const Variant &) = nullptr;
	bool (*get)(const Wrapped *, const StringName &, Variant &) = nullptr;
	void (*get_property_list)(const Wrapped *, List<PropertyInfo> *) = nullptr;
	bool (*property_can_revert)(const Wrapped *, const StringName &) = nullptr;
	bool (*property_get_revert)(const Wrapped *, const StringName &, Variant &) = nullptr;
	void (*validate_property)(const Wrapped *, PropertyInfo &) = nullptr;
	String (*to_string)(const Wrapped *) = nullptr;

	void register_class();
};

// The record of one class while it is registered.
template <typename T> inline ClassRecord *record_of_class = nullptr;

// Called inside of the class, so that the functions may be private. Includes only functions that the class itself
// declares.
template <typename T> struct ClassHooks {
	ClassRecord &record;

	template <auto M> static constexpr bool is_own = std::is_same_v<typename FunctionType<decltype(M)>::Class, T>;

	static T *self(Wrapped *p_self) { return static_cast<T *>(p_self); }
	static T *self(const Wrapped *p_self) { return const_cast<T *>(static_cast<const T *>(p_self)); }

	template <auto M> void notification() {
		if constexpr (is_own<M>) {
			record.notification = [](Wrapped *p_self, int p_what) { (self(p_self)->*M)(p_what); };
		}
	}
	template <auto M> void set() {
		if constexpr (is_own<M>) {
			record.set = [](Wrapped *p_self, const StringName &p_name, const Variant &p_value) -> bool {
				return (self(p_self)->*M)(p_name, p_value);
			};
		}
	}
	template <auto M> void get() {
		if constexpr (is_own<M>) {
			record.get = [](const Wrapped *p_self, const StringName &p_name, Variant &r_value) -> bool {
				return (self(p_self)->*M)(p_name, r_value);
			};
		}
	}
	template <auto M> void get_property_list() {
		if constexpr (is_own<M>) {
			record.get_property_list = [](const Wrapped *p_self, List<PropertyInfo> *r_list) {
				(self(p_self)->*M)(r_list);
			};
		}
	}
	template <auto M> void property_can_revert() {
		if constexpr (is_own<M>) {
			record.property_can_revert = [](const Wrapped *p_self, const StringName &p_name) -> bool {
				return (self(p_self)->*M)(p_name);
			};
		}
	}
	template <auto M> void property_get_revert() {
		if constexpr (is_own<M>) {
			record.property_get_revert = [](const Wrapped *p_self, const StringName &p_name, Variant &r_value) -> bool {
				return (self(p_self)->*M)(p_name, r_value);
			};
		}
	}
	template <auto M> void validate_property() {
		if constexpr (is_own<M>) {
			record.validate_property = [](const Wrapped *p_self, PropertyInfo &r_info) { (self(p_self)->*M)(r_info); };
		}
	}
	template <auto M> void to_string() {
		if constexpr (is_own<M>) {
			record.to_string = [](const Wrapped *p_self) -> String { return (self(p_self)->*M)(); };
		}
	}
};

} // namespace godot::internal

// Required at the start of every class of the library.
#define GDCLASS(m_class, m_inherits)                                                                                   \
public:                                                                                                                \
	using self_type = m_class;                                                                                         \
	using super_type = m_inherits;                                                                                     \
	static const ::godot::StringName &get_class_static() {                                                             \
		static ::godot::internal::StaticName name(#m_class);                                                           \
		return name.get();                                                                                             \
	}                                                                                                                  \
	static const ::godot::StringName &get_parent_class_static() {                                                      \
		return m_inherits::get_class_static();                                                                         \
	}                                                                                                                  \
	static void _initialize_class() {                                                                                  \
		if (m_class::_get_bind_methods() != m_inherits::_get_bind_methods()) {                                         \
			m_class::_bind_methods();                                                                                  \
		}                                                                                                              \
	}                                                                                                                  \
	const ::godot::internal::ClassRecord *_get_class_record() const override {                                         \
		return ::godot::internal::record_of_class<m_class>;                                                            \
	}                                                                                                                  \
	static void _describe_class(::godot::internal::ClassHooks<m_class> &r_hooks) {                                     \
		m_class::_bind_virtuals<m_class>(r_hooks.record.virtuals);                                                     \
		r_hooks.notification<&m_class::_notification>();                                                               \
		r_hooks.set<&m_class::_set>();                                                                                 \
		r_hooks.get<&m_class::_get>();                                                                                 \
		r_hooks.get_property_list<&m_class::_get_property_list>();                                                     \
		r_hooks.property_can_revert<&m_class::_property_can_revert>();                                                 \
		r_hooks.property_get_revert<&m_class::_property_get_revert>();                                                 \
		r_hooks.validate_property<&m_class::_validate_property>();                                                     \
		r_hooks.to_string<&m_class::_to_string>();                                                                     \
	}                                                                                                                  \
                                                                                                                       \
protected:                                                                                                             \
	static void (*_get_bind_methods())() {                                                                             \
		return &m_class::_bind_methods;                                                                                \
	}                                                                                                                  \
                                                                                                                       \
private:
