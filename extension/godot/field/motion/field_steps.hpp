#pragma once

#include "base/workers.hpp"
#include "field/contact.hpp"
#include "field/field_simulation.hpp"
#include "field/mean_lean.hpp"
#include "field/motion/pose_texture.hpp"
#include "field/motion/step_batch.hpp"

#include <atomic>
#include <cstdint>
#include <vector>

namespace undergrowth {

/// Steps a field's simulation on the engine's worker threads and copies its poses to the texture. No other code may use
/// either between start() and wait().
class FieldSteps {
public:
	FieldSteps() = default;
	~FieldSteps() { wait(); }
	FieldSteps(const FieldSteps &) = delete;
	FieldSteps &operator=(const FieldSteps &) = delete;

	/// Starts one step on up to `workers` threads and returns at once. Steps that cost less than waking a thread share
	/// a StepBatch. `contact`, if any, runs after all plants have moved. The last thread measures `leans`.
	void start(FieldSimulation &simulation, PoseTexture &poses, MeanLean &leans, TipContact *contact, int workers);
	/// Waits for the step; returns at once if there is none.
	void wait();
	/// Time of the last step that has ended, summed over all threads. Does not wait.
	double busy_usec() const { return ended_usec; }
	/// The part of it that ran on the main thread.
	double inline_usec() const { return is_inline ? busy_usec() : 0.0; }
	/// True between start() and wait().
	bool is_running() const { return group != Workers::NONE || ticket.batch; }
	/// Runs a whole step on this thread. For StepBatch.
	void run();

private:
	/// The phases of a step, in order. Each is divided among the threads.
	enum Phase : int { STEP, GATHER, SORT, COUNT, SEPARATE, WRITE, PHASES };

	FieldSimulation *stepped = nullptr;
	PoseTexture *written = nullptr;
	MeanLean *measured = nullptr;
	TipContact *touching = nullptr;
	std::vector<int> runs; ///< First pages of the parts that threads take, and the end.
	int plants_in_run = 0; ///< Of the last part.
	std::atomic<int> next_part[PHASES] = {};
	std::atomic<int> parts_done[PHASES] = {};
	std::atomic<int64_t> busy_nsec{ 0 };
	double ended_usec = 0.0;
	bool is_inline = false;
	int64_t group = Workers::NONE; ///< A group task of the engine's worker threads.
	StepBatch::Ticket ticket; ///< Of a small step.
	bool is_divided = false;

	int divide();
	int divide_due();
	int divide_all();
	void add_to_run(int page, int plants);
	int work_of_step(int due) const;
	int max_work() const;
	static void work(void *self, uint32_t worker);
	int parts_of(int phase) const;
	void do_part(int phase, int part);
};

} // namespace undergrowth
