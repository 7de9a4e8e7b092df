#include "base/worker_task.hpp"

#include <utility>

namespace undergrowth {

void WorkerTask::start(std::function<void()> &&what) {
	wait();
	work = std::move(what);
	is_over = false;
	task = Workers::start(&WorkerTask::run, this);
}

void WorkerTask::wait() {
	Workers::wait(task);
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
