#pragma once

#include <godot_cpp/classes/rendering_server.hpp>

namespace undergrowth {

/// True if the engine draws with this rendering method.
inline bool is_drawn_with(const char *method) {
	return godot::RenderingServer::get_singleton()->get_current_rendering_method() == godot::String(method);
}

inline bool is_compatibility() {
	return is_drawn_with("gl_compatibility");
}

inline bool is_forward_plus() {
	return is_drawn_with("forward_plus");
}

} // namespace undergrowth
