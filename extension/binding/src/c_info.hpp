#pragma once

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/property_info.hpp>

namespace godot::internal {

// Returns the engine's form of a list. It points to the data of the list.
inline std::vector<GDExtensionPropertyInfo> c_infos(const std::vector<PropertyInfo> &p_list) {
	std::vector<GDExtensionPropertyInfo> result;
	for (const PropertyInfo &info : p_list) {
		result.push_back(info.c_info());
	}
	return result;
}

} // namespace godot::internal
