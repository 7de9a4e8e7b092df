#pragma once

#include <godot_cpp/variant/utility_functions.hpp>

namespace godot {

template <typename... Args> void print_line(const Args &...p_values) {
	UtilityFunctions::print(p_values...);
}
template <typename... Args> void print_error(const Args &...p_values) {
	UtilityFunctions::printerr(p_values...);
}

} // namespace godot
