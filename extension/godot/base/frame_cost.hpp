#pragma once

#include "base/stopwatch.hpp"

#include <godot_cpp/classes/engine.hpp>

#include <cstdint>
#include <ctime>

namespace undergrowth {

/// Measures main-thread time in the last frame that used any. It is CPU time of the thread if the system supplies it,
/// so that the load of other programs has no effect.
class FrameCost {
public:
	/// Adds the time from its construction to its destruction.
	class Share {
	public:
		explicit Share(FrameCost &of) : cost(of), start(now()) {}
		~Share() { cost.add(now() - start); }
		Share(const Share &) = delete;
		Share &operator=(const Share &) = delete;

	private:
		FrameCost &cost;
		double start;
	};

	/// Returns µs; 0 if the last frame used none.
	double usec() const { return this_frame() - frame <= 1 ? spent : 0.0; }

private:
	uint64_t frame = 0;
	double spent = 0.0;

	static uint64_t this_frame() { return godot::Engine::get_singleton()->get_process_frames(); }

	static double now() {
#ifdef CLOCK_THREAD_CPUTIME_ID
		timespec time = {};
		clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
		return 1e6 * double(time.tv_sec) + 1e-3 * double(time.tv_nsec);
#else
		static const Stopwatch since_first;
		return since_first.usec();
#endif
	}

	void add(double usec) {
		spent = this_frame() == frame ? spent + usec : usec;
		frame = this_frame();
	}
};

} // namespace undergrowth
