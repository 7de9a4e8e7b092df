#pragma once

#include "base/workers.hpp"

#include <atomic>
#include <cstdint>
#include <functional>

namespace undergrowth {

/// Work on one of the engine's worker threads, one task at a time. The destructor waits, so the data of the task must
/// outlive this object. The owner's thread makes all calls.
class WorkerTask {
public:
	WorkerTask() = default;
	~WorkerTask() { wait(); }
	WorkerTask(const WorkerTask &) = delete;
	WorkerTask &operator=(const WorkerTask &) = delete;

	/// Starts `what` after the present task has ended.
	void start(std::function<void()> &&what);
	bool is_running() const { return task != Workers::NONE && !is_over.load(); }
	void wait();

private:
	std::function<void()> work;
	std::atomic<bool> is_over{ true };
	int64_t task = Workers::NONE;

	static void run(void *self);
};

} // namespace undergrowth
