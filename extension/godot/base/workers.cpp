#include "base/workers.hpp"

#include <godot_cpp/classes/os.hpp>
#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/classes/worker_thread_pool.hpp>

#include <limits>

using namespace godot;

namespace undergrowth {

static const char *const WORKERS_SETTING = "undergrowth/simulation/use_worker_threads";
static constexpr int64_t OVER = std::numeric_limits<int64_t>::max(); // Of tasks that ran in start().

bool Workers::are_used() {
	static const bool are = OS::get_singleton()->has_feature("threads") &&
			bool(ProjectSettings::get_singleton()->get_setting(WORKERS_SETTING, true));
	return are;
}

int64_t Workers::start(void (*work)(void *), void *data) {
	if (are_used()) {
		return WorkerThreadPool::get_singleton()->add_native_task(work, data);
	}
	work(data);
	return OVER;
}

void Workers::wait(int64_t &task) {
	if (task != NONE && task != OVER) {
		WorkerThreadPool::get_singleton()->wait_for_task_completion(task);
	}
	task = NONE;
}

int64_t Workers::start_group(void (*work)(void *, uint32_t), void *data, int count) {
	if (are_used()) {
		return WorkerThreadPool::get_singleton()->add_native_group_task(work, data, count, count, true);
	}
	for (int i = 0; i < count; i++) {
		work(data, uint32_t(i));
	}
	return OVER;
}

bool Workers::is_group_over(int64_t group) {
	return group == OVER || WorkerThreadPool::get_singleton()->is_group_task_completed(group);
}

void Workers::wait_for_group(int64_t &group) {
	if (group != NONE && group != OVER) {
		WorkerThreadPool::get_singleton()->wait_for_group_task_completion(group);
	}
	group = NONE;
}

} // namespace undergrowth
