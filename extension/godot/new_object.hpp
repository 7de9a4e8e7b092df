#pragma once

#include <godot_cpp/classes/class_db_singleton.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace undergrowth {

// Objects of the engine's own classes that may outlive a reload of the library. The engine makes them, and so forgets
// our wrappers of them at a reload; what memnew() or Ref::instantiate() made keeps a wrapper whose code is gone.

/// A node of class `Kind`.
template <class Kind> Kind *new_node() {
	godot::Object *made = godot::ClassDBSingleton::get_singleton()->instantiate(Kind::get_class_static());
	return godot::Object::cast_to<Kind>(made);
}

/// A resource, or another counted object, of class `Kind`.
template <class Kind> godot::Ref<Kind> new_counted() {
	return godot::Ref<Kind>(godot::ClassDBSingleton::get_singleton()->instantiate(Kind::get_class_static()));
}

} // namespace undergrowth
