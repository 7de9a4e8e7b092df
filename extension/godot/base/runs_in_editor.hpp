#pragma once

#include <godot_cpp/classes/engine.hpp>

namespace undergrowth {

/// True if scenes are edited and do not run. Asks the engine once.
inline bool runs_in_editor() {
	static const bool in_editor = godot::Engine::get_singleton()->is_editor_hint();
	return in_editor;
}

} // namespace undergrowth
