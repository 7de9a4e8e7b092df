#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

namespace undergrowth {

/// A piece of work on one of the engine's worker threads, one at a time. What it works on outlives it: the destructor
/// waits. Its owner's thread calls everything here.
class WorkerTask {
public:
	WorkerTask() = default;
	~WorkerTask() { wait(); }
	WorkerTask(const WorkerTask &) = delete;
	WorkerTask &operator=(const WorkerTask &) = delete;

	/// Waits for the one before.
	void start(std::function<void()> &&what);
	bool is_running() const { return task >= 0 && !is_over.load(); }
	void wait();

private:
	std::function<void()> work;
	std::atomic<bool> is_over{ true };
	int64_t task = -1;

	static void run(void *self);
};

} // namespace undergrowth
