#pragma once

#include <godot_cpp/core/interface.hpp>

namespace godot {

// Plugins written in C++; they are added at the editor level.
class EditorPlugins {
public:
	template <typename T> static void add_by_type() { internal::gde.editor_add_plugin(&T::get_class_static()); }
	template <typename T> static void remove_by_type() { internal::gde.editor_remove_plugin(&T::get_class_static()); }
};

} // namespace godot
