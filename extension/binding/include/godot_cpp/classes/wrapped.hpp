#pragma once

#include <type_traits>
#include <typeinfo>

#include <godot_cpp/core/property_info.hpp>
#include <godot_cpp/templates/list.hpp>

namespace godot {

namespace internal {

struct ClassRecord;
class VirtualTable;

// An object under construction on this thread. A constructor uses the innermost one, so that the arguments and the body
// of a constructor may create objects.
struct Construction {
	static thread_local Construction *current;

	const StringName *native_name;
	void *owner;
	Construction *previous;
	bool taken = false;

	// Creates an engine object of that class, or uses `p_owner` if it is not null.
	Construction(const StringName *p_native_name, void *p_owner) :
			native_name(p_native_name), owner(p_owner), previous(current) {
		current = this;
	}
	~Construction() { current = previous; }
	Construction(const Construction &) = delete;
	Construction &operator=(const Construction &) = delete;
};

} // namespace internal

// Base of all classes of the engine and of the library: the C++ side of one engine object.
class Wrapped {
public:
	void *_owner;
	// A list of the wrappers of engine objects, because these objects may outlive the library.
	struct {
		Wrapped *previous = nullptr;
		Wrapped *next = nullptr;
		bool is_singleton = false; // a Singleton points here and must be reset at the end
	} _wrapper;

	Wrapped(const Wrapped &) = delete;
	Wrapped &operator=(const Wrapped &) = delete;
	virtual ~Wrapped() = default;

	static void _initialize_class() {}
	// Returns the record of the object's library class; null for objects of engine classes.
	virtual const internal::ClassRecord *_get_class_record() const { return nullptr; }

protected:
	// Uses the engine object of the construction that memnew began. Aborts without one.
	Wrapped();

	static void _bind_methods() {}
	static void (*_get_bind_methods())() { return &Wrapped::_bind_methods; }
	template <typename T> static void _bind_virtuals(internal::VirtualTable &) {}

	void _notification(int) {}
	bool _set(const StringName &, const Variant &) { return false; }
	bool _get(const StringName &, Variant &) const { return false; }
	void _get_property_list(List<PropertyInfo> *) const {}
	bool _property_can_revert(const StringName &) const { return false; }
	bool _property_get_revert(const StringName &, Variant &) const { return false; }
	void _validate_property(PropertyInfo &) const {}
	String _to_string() const { return String(); }
};

namespace internal {

// Returns the C++ object of an engine object: the existing one, or a new one of the nearest listed class. Null for
// null.
Wrapped *wrapper_of(void *p_owner);
// Detaches all wrappers from existing engine objects, because no code of the library may run after it is unloaded.
void release_wrappers();
// Returns the object in a Variant; null if there is none or it was freed.
Wrapped *wrapped_in(const Variant &p_value);

// A dynamic_cast with a shortcut for the most common case: the object is exactly of that class.
template <typename T> inline T *cast(Wrapped *p_wrapped) {
	if (p_wrapped && typeid(*p_wrapped) == typeid(T)) {
		return static_cast<T *>(p_wrapped);
	}
	return dynamic_cast<T *>(p_wrapped);
}

} // namespace internal

} // namespace godot
