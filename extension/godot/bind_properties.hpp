#pragma once

#include <godot_cpp/core/class_db.hpp>

// For _bind_methods(): a line for each method and property of the class that it is of.

/// The method `m_name`; what follows are the names of its arguments.
#define BIND(m_name, ...) ClassDB::bind_method(D_METHOD(#m_name, ##__VA_ARGS__), &self_type::m_name)

/// The property `m_name`, with the setter and the getter that C++ knows by these; what follows is what PropertyInfo
/// says of it beside its type.
#define BIND_PROPERTY(m_type, m_name, m_getter_name, m_setter, m_getter, ...)                                          \
	ClassDB::bind_method(D_METHOD("set_" #m_name, "value"), m_setter);                                                 \
	ClassDB::bind_method(D_METHOD(m_getter_name), m_getter);                                                           \
	ADD_PROPERTY(PropertyInfo(Variant::m_type, #m_name, ##__VA_ARGS__), "set_" #m_name, m_getter_name)

/// The same where the class has functions set_`m_name`() and get_`m_name`().
#define PROPERTY(m_type, m_name, ...)                                                                                  \
	BIND_PROPERTY(m_type, m_name, "get_" #m_name, &self_type::set_##m_name, &self_type::get_##m_name, ##__VA_ARGS__)

/// What PropertyInfo takes for a slider.
#define SLIDER(m_text) PROPERTY_HINT_RANGE, String::utf8(m_text)
