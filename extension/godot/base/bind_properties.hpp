#pragma once

#include <godot_cpp/core/class_db.hpp>

// For _bind_methods() of a class with GDCLASS: one line for each method and property.

/// Binds the method `m_name`. The remaining arguments are the names of its parameters.
#define BIND(m_name, ...) ClassDB::bind_method(D_METHOD(#m_name, ##__VA_ARGS__), &self_type::m_name)

/// Binds the property `m_name` with a C++ setter and getter. The remaining arguments are those of PropertyInfo after
/// the name.
#define BIND_PROPERTY(m_type, m_name, m_getter_name, m_setter, m_getter, ...)                                          \
	ClassDB::bind_method(D_METHOD("set_" #m_name, "value"), m_setter);                                                 \
	ClassDB::bind_method(D_METHOD(m_getter_name), m_getter);                                                           \
	ADD_PROPERTY(PropertyInfo(Variant::m_type, #m_name, ##__VA_ARGS__), "set_" #m_name, m_getter_name)

/// Binds a property of a class with the functions set_`m_name`() and get_`m_name`().
#define PROPERTY(m_type, m_name, ...)                                                                                  \
	BIND_PROPERTY(m_type, m_name, "get_" #m_name, &self_type::set_##m_name, &self_type::get_##m_name, ##__VA_ARGS__)

/// Arguments of PropertyInfo for a slider.
#define SLIDER(m_text) PROPERTY_HINT_RANGE, String::utf8(m_text)
