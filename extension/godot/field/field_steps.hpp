#pragma once

#include "field/contact.hpp"
#include "field/field_bends.hpp"
#include "field/field_simulation.hpp"

#include <atomic>
#include <cstdint>

namespace undergrowth {

/// Steps a field's simulation on the engine's worker threads and takes its bends over into the images.
/// Between start() and wait() nobody else may touch either.
class FieldSteps {
public:
	FieldSteps() = default;
	~FieldSteps() { wait(); }
	FieldSteps(const FieldSteps &) = delete;
	FieldSteps &operator=(const FieldSteps &) = delete;

	/// Begins one step on up to `workers` threads and returns at once.
	/// `contact`, where there is one, takes part after all plants have moved.
	void start(FieldSimulation &simulation, FieldBends &bends, TipContact *contact, int workers);
	/// Until the step is done; at once where there is none.
	void wait();
	/// Time that the last step took of all threads together.
	double busy_usec() const { return double(busy_nsec.load()) * 1e-3; }

private:
	FieldSimulation *stepped = nullptr;
	FieldBends *written = nullptr;
	TipContact *touching = nullptr;
	std::atomic<int> next_page{ 0 };
	std::atomic<int> still_working{ 0 };
	std::atomic<int64_t> busy_nsec{ 0 };
	int64_t group = -1; ///< Of the engine's worker threads.

	static void work(void *self, uint32_t worker);
	void step_and_write();
	void separate_and_write();
};

} // namespace undergrowth
