#pragma once

#include <type_traits>
#include <typeinfo>

#include <godot_cpp/core/property_info.hpp>
#include <godot_cpp/templates/list.hpp>

namespace godot {

namespace internal {

struct ClassRecord;
class VirtualTable;

// One object under construction on this thread. A constructor takes the innermost one, so that objects may be made in
// the arguments and the body of another's constructor.
struct Construction {
	static thread_local Construction *current;

	const StringName *native_name;
	void *owner;
	Construction *previous;
	bool taken = false;

	// A new engine object of that class, or the given one when owner is set.
	Construction(const StringName *p_native_name, void *p_owner) :
			native_name(p_native_name), owner(p_owner), previous(current) {
		current = this;
	}
	~Construction() { current = previous; }
	Construction(const Construction &) = delete;
	Construction &operator=(const Construction &) = delete;
};

} // namespace internal

// The base of all classes of the engine and of ours: the C++ side of one engine object.
class Wrapped {
public:
	void *_owner;
	// Wrappers of engine objects are listed, because their objects may outlive the library.
	struct {
		Wrapped *previous = nullptr;
		Wrapped *next = nullptr;
		bool is_singleton = false; // then a record points here, which must hear of the end
	} _wrapper;

	Wrapped(const Wrapped &) = delete;
	Wrapped &operator=(const Wrapped &) = delete;
	virtual ~Wrapped() = default;

	static void _initialize_class() {}
	// Of the class of ours that the object belongs to; null for objects of the engine's classes.
	virtual const internal::ClassRecord *_get_class_record() const { return nullptr; }

protected:
	// Takes the engine object from the construction that memnew began; aborts without one.
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

// The C++ object of an engine object: the one that was made for it, or a new one of the nearest class we know. Null for
// null.
Wrapped *wrapper_of(void *p_owner);
// Takes all wrappers from engine objects that are still alive: nothing of the library may be called after it is closed.
void release_wrappers();
// The object in a Variant, null when there is none or it was freed.
Wrapped *wrapped_in(const Variant &p_value);

// dynamic_cast, with a shortcut for the most common case: the object is exactly of that class.
template <typename T> inline T *cast(Wrapped *p_wrapped) {
	if (p_wrapped && typeid(*p_wrapped) == typeid(T)) {
		return static_cast<T *>(p_wrapped);
	}
	return dynamic_cast<T *>(p_wrapped);
}

} // namespace internal

} // namespace godot
