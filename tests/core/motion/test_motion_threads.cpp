#include "swing.hpp"

#include <doctest/doctest.h>

#include <initializer_list>
#include <thread>
#include <vector>

using namespace undergrowth;

namespace {

constexpr int COUNT = 5003;
constexpr int THREADS = 4;
constexpr int STEPS = 60;

/// Plants [first, last) of one meadow.
MotionPage meadow(Law law, int first, int last) {
	std::vector<MotionPlant> plants;
	for (int i = first; i < last; i++) {
		MotionPlant plant;
		plant.length = 0.3f + 0.001f * static_cast<float>(i % 1000);
		plants.push_back(plant);
	}
	MotionPage page(0, species_with(law, {}), plants.data(), last - first, FRAME_STEP, true);
	for (int i = first; i < last; i++) {
		page.set_state(i - first, leaning(0.01 * (i % 100)));
	}
	return page;
}

void run(MotionPage &page) {
	for (int i = 0; i < STEPS; i++) {
		step_in(page, { 2.0f, 0.0f, 1.0f });
	}
}

} // namespace

TEST_CASE("pages on several threads give the same bits as one page on one thread") {
	for (const Law law : { Law::elasticity, Law::spring }) {
		MotionPage single = meadow(law, 0, COUNT);
		run(single);
		std::vector<MotionPage> parts;
		for (int i = 0; i < THREADS; i++) {
			parts.push_back(meadow(law, COUNT * i / THREADS, COUNT * (i + 1) / THREADS));
		}
		std::vector<std::thread> threads;
		for (MotionPage &part : parts) {
			threads.emplace_back([&part] { run(part); });
		}
		for (std::thread &thread : threads) {
			thread.join();
		}
		int index = 0;
		for (const MotionPage &part : parts) {
			for (int i = 0; i < part.size(); i++, index++) {
				REQUIRE(part.state(i).direction == single.state(index).direction);
				REQUIRE(part.state(i).rate == single.state(index).rate);
			}
		}
		CHECK(index == COUNT);
	}
}
