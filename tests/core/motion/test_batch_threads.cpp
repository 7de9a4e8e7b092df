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
constexpr glm::vec3 WIND = { 2.0f, 0.0f, 1.0f };

PendulumBatch meadow(Law law) {
	PendulumBatch batch(law, FRAME_STEP);
	for (int i = 0; i < COUNT; i++) {
		Joint joint;
		joint.length = 0.3f + 0.001f * static_cast<float>(i % 1000);
		batch.add(joint, leaning(0.01 * (i % 100)));
	}
	return batch;
}

void step_on_threads(PendulumBatch &batch) {
	std::vector<std::thread> threads;
	for (int i = 0; i < THREADS; i++) {
		threads.emplace_back(
				[&batch, i] { batch.step(COUNT * i / THREADS, COUNT * (i + 1) / THREADS, WIND, best_simd_level()); });
	}
	for (std::thread &thread : threads) {
		thread.join();
	}
}

} // namespace

TEST_CASE("disjoint ranges on several threads give the same bits as one call") {
	for (const Law law : { Law::elasticity, Law::spring }) {
		PendulumBatch threaded = meadow(law);
		PendulumBatch single = meadow(law);
		for (int i = 0; i < STEPS; i++) {
			step_on_threads(threaded);
			single.step(WIND);
		}
		CHECK(hash_states(threaded) == hash_states(single));
	}
}
