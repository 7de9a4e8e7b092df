#include "field/motion/step_batch.hpp"

#include "field/motion/field_steps.hpp"
#include "plants/plant_simulation.hpp"

#include <godot_cpp/classes/os.hpp>

#include <algorithm>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

using namespace godot;

namespace undergrowth {

/// Stepping this many plants takes less time than waking a worker thread takes in both threads.
static constexpr int64_t FEW_PLANTS = 4096;
static constexpr int64_t PLANTS_PER_THREAD = 8192; // Fewer do not justify another thread.
static constexpr int64_t FIELD_COST = 256; // Cost of a field without plants, in plants.

static StepBatch *collected = nullptr; // The batch of this frame.

static std::vector<std::unique_ptr<StepBatch>> &all_batches() {
	static std::vector<std::unique_ptr<StepBatch>> all;
	return all;
}

// A thread that comes late finds only steps that are done. The main thread does not wait for it.
bool StepBatch::is_idle() {
	if (open > 0 || this == collected) {
		return false;
	}
	if (group != Workers::NONE) {
		if (!Workers::is_group_over(group)) {
			return false;
		}
		Workers::wait_for_group(group);
	}
	return true;
}

StepBatch *StepBatch::find_idle() {
	std::vector<std::unique_ptr<StepBatch>> &all = all_batches();
	const auto found = std::find_if(all.begin(), all.end(), [](const auto &batch) { return batch->is_idle(); });
	if (found == all.end()) {
		all.push_back(std::make_unique<StepBatch>());
		return all.back().get();
	}
	StepBatch *batch = found->get();
	batch->count = 0;
	batch->cost = 0;
	batch->next = 0;
	return batch;
}

StepBatch::Ticket StepBatch::add(FieldSteps &steps, int cost) {
	if (!collected) {
		collected = find_idle();
		PlantSimulation::get_singleton()->start_steps_soon();
	}
	StepBatch &batch = *collected;
	if (batch.count == batch.slots.size()) {
		batch.slots.emplace_back();
	}
	Slot &slot = batch.slots[batch.count];
	slot.state.store(WAITING, std::memory_order_relaxed);
	slot.steps = &steps;
	slot.is_main = false;
	batch.cost += FIELD_COST + cost;
	batch.open++;
	return { &batch, batch.count++ };
}

bool StepBatch::take(Slot &slot) const {
	int expected = WAITING;
	return slot.state.compare_exchange_strong(expected, TAKEN, std::memory_order_acquire);
}

void StepBatch::run(Slot &slot) {
	slot.steps->run();
	slot.state.store(DONE, std::memory_order_release);
}

bool StepBatch::finish(Ticket &ticket) {
	StepBatch &batch = *ticket.batch;
	Slot &slot = batch.slots[ticket.index];
	if (batch.take(slot)) {
		slot.is_main = true;
		run(slot);
	}
	while (slot.state.load(std::memory_order_acquire) != DONE) {
		std::this_thread::yield();
	}
	batch.open--;
	ticket = {};
	return slot.is_main;
}

void StepBatch::start() {
	if (cost <= FEW_PLANTS) {
		for (size_t i = 0; i < count; i++) {
			if (take(slots[i])) {
				slots[i].is_main = true;
				run(slots[i]);
			}
		}
		return;
	}
	static const int64_t processors = OS::get_singleton()->get_processor_count();
	const int tasks = int(std::clamp(cost / PLANTS_PER_THREAD, int64_t(1), std::max(processors, int64_t(1))));
	group = Workers::start_group(&StepBatch::work, this, tasks);
}

void StepBatch::start_collected() {
	if (StepBatch *batch = std::exchange(collected, nullptr)) {
		if (batch->open > 0) {
			batch->start();
		}
	}
}

// Each step goes to the next free thread; the results do not depend on the order.
void StepBatch::work(void *self, uint32_t) {
	StepBatch &batch = *static_cast<StepBatch *>(self);
	for (size_t i = batch.next++; i < batch.count; i = batch.next++) {
		if (batch.take(batch.slots[i])) {
			run(batch.slots[i]);
		}
	}
}

void StepBatch::end_all() {
	for (const std::unique_ptr<StepBatch> &batch : all_batches()) {
		Workers::wait_for_group(batch->group);
	}
}

} // namespace undergrowth
