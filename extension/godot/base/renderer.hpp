#pragma once

#include <godot_cpp/classes/rendering_server.hpp>

namespace undergrowth {

/// True if the engine draws with the Compatibility renderer.
inline bool is_compatibility() {
	const godot::RenderingServer *server = godot::RenderingServer::get_singleton();
	return server->get_current_rendering_method() == godot::String("gl_compatibility");
}

} // namespace undergrowth
