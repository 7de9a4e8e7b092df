#pragma once

#include <godot_cpp/classes/class_db_singleton.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace undergrowth {

// Creates objects of engine classes that may outlive a reload of the library. The engine creates them, so a reload
// discards their wrappers. Objects made by memnew() or Ref::instantiate() retain a wrapper with unloaded code.

/// Creates a node of class `Kind`.
template <class Kind> Kind *new_node() {
	godot::Object *made = godot::ClassDBSingleton::get_singleton()->instantiate(Kind::get_class_static());
	return godot::Object::cast_to<Kind>(made);
}

/// Creates a resource, or another reference-counted object, of class `Kind`.
template <class Kind> godot::Ref<Kind> new_counted() {
	return godot::Ref<Kind>(godot::ClassDBSingleton::get_singleton()->instantiate(Kind::get_class_static()));
}

} // namespace undergrowth
