#pragma once

#include "base/stopwatch.hpp"

#include <godot_cpp/classes/engine.hpp>

#include <cstdint>

namespace undergrowth {

/// Limit of the main-thread time that the builds of all fields use in one frame. When it is spent, the remaining fields
/// continue in the next frame. Main thread.
class FrameBudget {
public:
	static FrameBudget &of_fields() {
		static FrameBudget budget;
		return budget;
	}

	/// Adds the time from its construction to its destruction.
	class Share {
	public:
		explicit Share(FrameBudget &of) : budget(of) {}
		~Share() { budget.spend(watch.usec()); }
		Share(const Share &) = delete;
		Share &operator=(const Share &) = delete;

	private:
		FrameBudget &budget;
		Stopwatch watch;
	};

	bool is_left() const { return frame != this_frame() || spent < USEC_PER_FRAME; }

private:
	static constexpr double USEC_PER_FRAME = 4000.0;

	uint64_t frame = 0;
	double spent = 0.0; ///< µs in that frame.

	static uint64_t this_frame() { return godot::Engine::get_singleton()->get_process_frames(); }
	void spend(double usec) {
		spent = frame == this_frame() ? spent + usec : usec;
		frame = this_frame();
	}
};

} // namespace undergrowth
