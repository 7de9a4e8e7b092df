#pragma once

#include <list>

namespace godot {

// For _get_property_list() only. Everything else uses the standard containers.
template <typename T> class List : public std::list<T> {};

} // namespace godot
