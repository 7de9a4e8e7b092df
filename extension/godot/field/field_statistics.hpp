#pragma once

#include "field/meadow.hpp"

#include <godot_cpp/variant/dictionary.hpp>

namespace undergrowth {

/// What a field has to do, and what of it the last frame took: what get_statistics() tells. Main thread.
class FieldStatistics {
public:
	/// µs of the frame: of this thread, and of its waiting for the workers where they took longer than the frame.
	void note_frame(double of_main, double of_waiting) {
		main_usec = of_main;
		wait_usec = of_waiting;
	}
	/// Waits for the step that goes on. `is_dressed_soon`: after this frame, though nothing of `meadow` is at it yet.
	godot::Dictionary tell(const godot::Node3D *node, Meadow &meadow, bool is_dressed_soon) const;

private:
	double main_usec = 0.0;
	double wait_usec = 0.0;
};

} // namespace undergrowth
