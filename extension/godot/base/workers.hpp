#pragma once

#include <cstdint>

namespace undergrowth {

/// The engine's worker threads. Without them each task runs where it is started, before start() returns: in an engine
/// without threads, and with the project setting undergrowth/simulation/use_worker_threads off. Main thread.
class Workers {
public:
	/// False without threads. Any thread.
	static bool are_used();

	/// Number of no task and of no group.
	static constexpr int64_t NONE = -1;

	/// Each task and group must be waited for. Waiting sets its number to NONE, and does nothing for NONE.
	static int64_t start(void (*work)(void *), void *data);
	static void wait(int64_t &task);

	/// `work` gets the numbers 0 to `count` - 1.
	static int64_t start_group(void (*work)(void *, uint32_t), void *data, int count);
	static bool is_group_over(int64_t group);
	static void wait_for_group(int64_t &group);
};

} // namespace undergrowth
