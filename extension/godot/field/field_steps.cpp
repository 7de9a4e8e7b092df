#include "field/field_steps.hpp"

#include <godot_cpp/classes/worker_thread_pool.hpp>

#include <algorithm>
#include <chrono>

using namespace godot;

namespace undergrowth {

using Clock = std::chrono::steady_clock;

void FieldSteps::start(FieldSimulation &simulation, FieldBends &bends, TipContact *contact, int workers) {
	wait();
	stepped = &simulation;
	written = &bends;
	touching = contact;
	next_page = 0;
	busy_nsec = 0;
	const bool follows = simulation.settings().prototypes > 0;
	if (!follows) {
		simulation.begin_step(); // Prototypes step in it: those go to the workers, too.
	}
	const int tasks = follows ? 1 : std::clamp(workers, 1, std::max(simulation.page_count(), 1));
	still_working = tasks;
	group = WorkerThreadPool::get_singleton()->add_native_group_task(&FieldSteps::work, this, tasks, tasks, true);
}

void FieldSteps::wait() {
	if (group >= 0) {
		WorkerThreadPool::get_singleton()->wait_for_group_task_completion(group);
		group = -1;
	}
}

void FieldSteps::work(void *self, uint32_t) {
	const Clock::time_point start = Clock::now();
	FieldSteps *steps = static_cast<FieldSteps *>(self);
	if (steps->stepped->settings().prototypes > 0) {
		steps->stepped->begin_step();
		steps->stepped->step_pages(0, steps->stepped->page_count());
		steps->written->write_history(*steps->stepped);
	} else {
		steps->step_and_write();
		if (--steps->still_working == 0 && steps->touching) {
			steps->separate_and_write();
		}
	}
	steps->busy_nsec += std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - start).count();
}

// Pages go to whoever is free: the bits do not depend on it.
void FieldSteps::step_and_write() {
	const int count = stepped->page_count();
	for (int page = next_page++; page < count; page = next_page++) {
		stepped->step_pages(page, page + 1);
		if (!touching && stepped->has_stepped(page)) {
			written->write_page(*stepped, page);
		}
	}
}

// By the last of the threads.
void FieldSteps::separate_and_write() {
	touching->resolve(*stepped);
	for (int page = 0; page < stepped->page_count(); page++) {
		written->write_page(*stepped, page);
	}
}

} // namespace undergrowth
