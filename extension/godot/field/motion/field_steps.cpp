#include "field/motion/field_steps.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

using namespace godot;

namespace undergrowth {

using Clock = std::chrono::steady_clock;

static constexpr int FEW_PLANTS = 4096; // Fewer do not justify a group task of their own.
/// Fewer do not justify another thread: waking it takes the main thread up to 10 µs, and a step has a whole frame.
static constexpr int PLANTS_PER_THREAD = 16384;
static constexpr int PLANTS_PER_PART = 2048; // Enough to make the cost of taking a part negligible.
static constexpr int TOUCHING_PLANT = 16; // Cost of a plant with contact, in plants without contact.

// Starts a new part at a page if the present one has enough plants.
void FieldSteps::add_to_run(int page, int plants) {
	if (plants_in_run >= PLANTS_PER_PART) {
		runs.push_back(page);
		plants_in_run = 0;
	}
	plants_in_run += plants;
}

// Starts the step and divides its pages, which may be small, into parts for the threads. Returns the number of plants
// that are due and get new poses.
int FieldSteps::divide() {
	is_divided = true;
	runs.clear();
	plants_in_run = PLANTS_PER_PART;
	if (stepped->settings().prototypes > 0) {
		return stepped->due_count();
	}
	stepped->begin_step(); // Without prototypes. With prototypes it also steps those, so that the workers call it.
	for (const int page : stepped->changed_pages()) {
		written->give_seconds(*stepped, page);
	}
	const int due = touching ? divide_all() : divide_due();
	runs.push_back(stepped->page_count());
	return due;
}

int FieldSteps::divide_due() {
	int due = 0;
	if (stepped->page_count() > 0) {
		add_to_run(0, 0);
	}
	for (const int page : stepped->due_pages()) {
		const int plants = stepped->page(page).live_count();
		add_to_run(page, plants);
		due += plants;
		if (plants > 0) {
			written->will_write(page);
		}
	}
	return due;
}

// Contact moves plants of all pages.
int FieldSteps::divide_all() {
	touching->follow_radii(*stepped);
	int due = 0;
	for (int page = 0; page < stepped->page_count(); page++) {
		add_to_run(page, stepped->page(page).size());
		const int plants = stepped->page(page).live_count();
		due += stepped->has_stepped(page) ? plants : 0;
		if (plants > 0) {
			written->will_write(page);
		}
	}
	return due;
}

int FieldSteps::work_of_step(int due) const {
	if (touching) {
		return TOUCHING_PLANT * stepped->plant_count();
	}
	return due;
}

// Upper bound of work_of_step(), without divide().
int FieldSteps::max_work() const {
	return work_of_step(stepped->settings().prototypes > 0 ? stepped->due_count() : stepped->row_count());
}

void FieldSteps::start(
		FieldSimulation &simulation, PoseTexture &poses, MeanLean &leans, TipContact *contact, int workers) {
	wait();
	stepped = &simulation;
	written = &poses;
	measured = &leans;
	touching = contact;
	for (int phase = 0; phase < PHASES; phase++) {
		next_part[phase].store(0, std::memory_order_relaxed);
		parts_done[phase].store(0, std::memory_order_relaxed);
	}
	busy_nsec = 0;
	is_inline = is_divided = false;
	int plants = max_work(); // The cost, in plants without contact.
	if (plants > FEW_PLANTS) {
		plants = work_of_step(divide());
	}
	if (plants <= FEW_PLANTS) {
		ticket = StepBatch::add(*this, plants);
		return;
	}
	const bool follows = simulation.settings().prototypes > 0;
	const int useful = std::max(plants / PLANTS_PER_THREAD, 1);
	const int tasks = follows ? 1 : std::clamp(std::min(useful, int(runs.size()) - 1), 1, workers);
	group = Workers::start_group(&FieldSteps::work, this, tasks);
}

void FieldSteps::wait() {
	if (!is_running()) {
		return;
	}
	if (ticket.batch) {
		is_inline = StepBatch::finish(ticket);
	}
	Workers::wait_for_group(group);
	ended_usec = double(busy_nsec.load()) * 1e-3;
}

void FieldSteps::run() {
	if (!is_divided) {
		divide();
	}
	work(this, 0);
}

// Each part goes to the next free thread; the results do not depend on the order. A thread that finds no part left
// waits for parts that are in progress. It never waits for a thread that has not started.
void FieldSteps::work(void *self, uint32_t) {
	const Clock::time_point start = Clock::now();
	FieldSteps *steps = static_cast<FieldSteps *>(self);
	if (steps->stepped->settings().prototypes > 0) {
		steps->stepped->begin_step();
	}
	const int last_phase = steps->touching ? PHASES - 1 : STEP;
	for (int phase = 0; phase <= last_phase; phase++) {
		const int parts = steps->parts_of(phase);
		for (int part = steps->next_part[phase]++; part < parts; part = steps->next_part[phase]++) {
			steps->do_part(phase, part);
			const bool is_last = ++steps->parts_done[phase] == parts && phase == last_phase;
			if (is_last) {
				steps->measured->follow(*steps->stepped); // The main thread would miss its cache for each plant.
			}
		}
		while (steps->touching && steps->parts_done[phase].load() < parts) {
			std::this_thread::yield();
		}
	}
	steps->busy_nsec += std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - start).count();
}

int FieldSteps::parts_of(int phase) const {
	if (phase == SORT || stepped->settings().prototypes > 0) {
		return 1;
	}
	return int(runs.size()) - 1;
}

void FieldSteps::do_part(int phase, int part) {
	if (stepped->settings().prototypes > 0) {
		stepped->step_pages(0, stepped->page_count());
		written->write_history(*stepped, false);
		return;
	}
	if (phase == SORT) {
		touching->sort();
		return;
	}
	const int first = runs[size_t(part)];
	const int end = runs[size_t(part) + 1];
	switch (phase) {
		case STEP:
			for (int page = first; page < end; page++) {
				stepped->step_pages(page, page + 1);
				if (!touching && stepped->has_stepped(page) && stepped->page(page).live_count() > 0) {
					written->write_bends(*stepped, page);
				}
			}
			break;
		case GATHER:
			touching->gather(*stepped, first, end);
			break;
		case COUNT:
			touching->count(*stepped, first, end);
			break;
		case SEPARATE:
			touching->separate(*stepped, first, end);
			break;
		default:
			for (int page = first; page < end; page++) {
				if (stepped->page(page).live_count() > 0) {
					written->write_bends(*stepped, page);
				}
			}
			break;
	}
}

} // namespace undergrowth
