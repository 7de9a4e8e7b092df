#pragma once

#include "base/workers.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>

namespace undergrowth {

class FieldSteps;

/// Runs the steps of all small fields of a frame in one group task, so that they wake the worker threads once. Owns a
/// slot for each step. A step that is needed before a thread has taken it runs on the main thread. The functions are
/// for the main thread; the steps run on any thread.
class StepBatch {
public:
	/// A step in a batch. Empty: none.
	struct Ticket {
		StepBatch *batch = nullptr;
		size_t index = 0;
	};

	/// Adds a step to the batch of this frame. It starts when all nodes have processed the frame. `cost`: in plants.
	/// Call finish() before the steps are freed.
	static Ticket add(FieldSteps &steps, int cost);
	/// Returns when the step is done, and empties the ticket. Returns true if it ran on this thread.
	static bool finish(Ticket &ticket);
	/// Starts the batch of this frame. Cheap batches run on this thread.
	static void start_collected();
	/// Waits for all threads. Call it before the library is unloaded.
	static void end_all();

private:
	enum State : int { WAITING, TAKEN, DONE };
	/// One step. The batch owns it, so a thread may read `state` after the step's field was freed.
	struct Slot {
		std::atomic<int> state{ WAITING };
		FieldSteps *steps = nullptr; ///< Valid for the thread that took it.
		bool is_main = false; ///< It ran on the main thread.
	};

	std::deque<Slot> slots; ///< The first `count` are in use. Addresses do not change.
	size_t count = 0;
	size_t open = 0; ///< Number of tickets that are not finished.
	int64_t cost = 0;
	std::atomic<size_t> next{ 0 }; ///< Next slot for a thread.
	int64_t group = Workers::NONE; ///< A group task of the engine's worker threads.

	static StepBatch *find_idle();
	bool is_idle();
	bool take(Slot &slot) const;
	static void run(Slot &slot);
	void start();
	static void work(void *self, uint32_t worker);
};

} // namespace undergrowth
