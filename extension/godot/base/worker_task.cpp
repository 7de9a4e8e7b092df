#include "base/worker_task.hpp"

#include <godot_cpp/classes/worker_thread_pool.hpp>

#include <utility>

using namespace godot;

namespace undergrowth {

void WorkerTask::start(std::function<void()> &&what) {
	wait();
	work = std::move(what);
	is_over = false;
	task = WorkerThreadPool::get_singleton()->add_native_task(&WorkerTask::run, this);
}

void WorkerTask::wait() {
	if (task >= 0) {
		WorkerThreadPool::get_singleton()->wait_for_task_completion(task);
		task = -1;
	}
}

void WorkerTask::run(void *self) {
	auto *own = static_cast<WorkerTask *>(self);
	{
		std::function<void()> work = std::move(own->work);
		work();
	} // Frees the captured data before the task is over.
	own->is_over = true;
}

} // namespace undergrowth
