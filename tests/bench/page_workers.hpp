#pragma once

#include <algorithm>
#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace undergrowth {

/// Threads that wait, spinning, for pages to step.
class PageWorkers {
public:
	explicit PageWorkers(int count) {
		for (int i = 1; i < count; i++) {
			threads.emplace_back([this] { work(); });
		}
	}
	PageWorkers(const PageWorkers &) = delete;
	PageWorkers &operator=(const PageWorkers &) = delete;
	~PageWorkers() {
		stopping = true;
		round++;
		for (std::thread &thread : threads) {
			thread.join();
		}
	}

	/// Calls work(begin, end) for all of `pages`, some at a time, on all threads.
	void for_pages(int pages, const std::function<void(int, int)> &work) {
		present = &work;
		page_count = pages;
		next_page = 0;
		busy = static_cast<int>(threads.size());
		round++;
		take_pages();
		while (busy.load() > 0) {
			std::this_thread::yield();
		}
	}

private:
	static constexpr int PAGES_AT_ONCE = 2;

	std::vector<std::thread> threads;
	const std::function<void(int, int)> *present = nullptr;
	int page_count = 0;
	std::atomic<int> next_page = 0;
	std::atomic<int> busy = 0;
	std::atomic<int> round = 0;
	std::atomic<bool> stopping = false;

	void take_pages() {
		for (int page = next_page.fetch_add(PAGES_AT_ONCE); page < page_count;
				page = next_page.fetch_add(PAGES_AT_ONCE)) {
			(*present)(page, std::min(page + PAGES_AT_ONCE, page_count));
		}
	}

	void work() {
		for (int seen = 0;;) {
			while (round.load() == seen) {
				std::this_thread::yield();
			}
			seen = round.load();
			if (stopping) {
				return;
			}
			take_pages();
			busy--;
		}
	}
};

} // namespace undergrowth
