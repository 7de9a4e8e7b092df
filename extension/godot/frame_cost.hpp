#pragma once

#include "stopwatch.hpp"

#include <godot_cpp/classes/engine.hpp>

#include <cstdint>
#include <ctime>

namespace undergrowth {

/// What something took of the main thread in the last frame that it took any of: by the processor's time of the thread,
/// where the system tells it, so that it does not hang on who else is at work.
class FrameCost {
public:
	/// A piece of it: from when it is made until it goes.
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

	/// µs; 0 where the last frame took nothing.
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
