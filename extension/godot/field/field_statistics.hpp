#pragma once

#include "field/field_runtime.hpp"

#include <godot_cpp/variant/dictionary.hpp>

namespace undergrowth {

/// The present work of a field and the cost of its last frame, for get_statistics(). Main thread.
class FieldStatistics {
public:
	/// Sets the µs of a frame: of the main thread, and of its wait for workers that took longer than the frame.
	void note_frame(double of_main, double of_waiting) {
		main_usec = of_main;
		wait_usec = of_waiting;
	}
	/// Does not wait for the running step. `is_restyle_queued`: materials are rebuilt after this frame, but `runtime`
	/// has not started yet.
	godot::Dictionary to_dictionary(const godot::Node3D *node, FieldRuntime &runtime, bool is_restyle_queued) const;

private:
	double main_usec = 0.0;
	double wait_usec = 0.0;
};

} // namespace undergrowth
