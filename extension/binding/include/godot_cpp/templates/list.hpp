#pragma once

#include <list>

namespace godot {

// Only what _get_property_list needs: this code uses the standard containers.
template <typename T> class List : public std::list<T> {};

} // namespace godot
