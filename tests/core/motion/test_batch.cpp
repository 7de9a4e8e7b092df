#include "swing.hpp"

#include "base/random.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <vector>

using namespace undergrowth;

namespace {

constexpr Law BOTH_LAWS[] = { Law::elasticity, Law::spring };
constexpr float STATE_TOLERANCE = 1e-6f;
constexpr glm::vec3 CALM = { 0.0f, 0.0f, 0.0f };

float noise(int index, int which) {
	return signed_noise(static_cast<uint64_t>(which), static_cast<uint64_t>(index));
}

Joint varied_joint(int index) {
	Joint joint;
	joint.length = 1.0f + 0.8f * noise(index, 1);
	joint.mass = 0.6f + 0.5f * noise(index, 2);
	joint.elasticity = 5.0f + 4.0f * noise(index, 3);
	joint.inner_friction = 0.3f + 0.3f * noise(index, 4);
	joint.above_ground = index % 3 != 0;
	joint.natural_frequency = 1.5f + noise(index, 5);
	joint.damping_ratio = 0.8f + 0.8f * noise(index, 6);
	joint.rest = glm::normalize(glm::vec3(0.5f * noise(index, 7), 1.0f, 0.5f * noise(index, 8)));
	return joint;
}

TipState varied_state(int index) {
	return { { noise(index, 9), 1.0f, noise(index, 10) }, { noise(index, 11), noise(index, 12), noise(index, 13) } };
}

PendulumBatch meadow(Law law, int count) {
	PendulumBatch batch(law, FRAME_STEP);
	for (int i = 0; i < count; i++) {
		batch.add(varied_joint(i), varied_state(i));
	}
	return batch;
}

glm::vec3 wind_at(int step) {
	return { 3.0f + static_cast<float>(step % 7), 0.0f, static_cast<float>(step % 5) - 2.0f };
}

bool same_bits(const TipState &a, const TipState &b) {
	return std::memcmp(&a, &b, sizeof a) == 0;
}

bool is_finite(const TipState &state) {
	return std::isfinite(state.direction.x + state.direction.y + state.direction.z) &&
			std::isfinite(state.rate.x + state.rate.y + state.rate.z);
}

} // namespace

TEST_CASE("an empty batch steps and interpolates without effect") {
	for (const Law law : BOTH_LAWS) {
		PendulumBatch batch(law, FRAME_STEP);
		batch.step(wind_at(0));
		batch.step(0, 0, wind_at(0), SimdLevel::baseline);
		batch.interpolate(0.5f, nullptr);
		CHECK(batch.size() == 0);
		CHECK(batch.law() == law);
		CHECK(batch.step_length() == FRAME_STEP);
	}
}

TEST_CASE("a state comes back as it was put in") {
	for (const Law law : BOTH_LAWS) {
		PendulumBatch batch(law, FRAME_STEP);
		const glm::vec3 direction = glm::normalize(glm::vec3(0.4f, 0.8f, -0.2f));
		const glm::vec3 raw = { 0.3f, -0.1f, 0.9f };
		const glm::vec3 rate = raw - glm::dot(raw, direction) * direction;
		const int index = batch.add(Joint{}, { direction, rate });
		CHECK(glm::length(batch.state(index).direction - direction) < STATE_TOLERANCE);
		CHECK(glm::length(batch.state(index).rate - rate) < STATE_TOLERANCE);
	}
}

TEST_CASE("the state survives a change of law") {
	for (int i = 0; i < 200; i++) {
		PendulumBatch first(Law::elasticity, FRAME_STEP);
		PendulumBatch second(Law::spring, FRAME_STEP);
		PendulumBatch third(Law::elasticity, FRAME_STEP);
		first.add(varied_joint(i), varied_state(i));
		second.add(varied_joint(i), first.state(0));
		third.add(varied_joint(i), second.state(0));
		CHECK(glm::length(third.state(0).direction - first.state(0).direction) < 4.0f * STATE_TOLERANCE);
		CHECK(glm::length(third.state(0).rate - first.state(0).rate) < 4.0f * STATE_TOLERANCE);
	}
}

TEST_CASE("a tip below the ground comes to the spring law just above the horizon") {
	PendulumBatch batch(Law::spring, FRAME_STEP);
	for (const glm::vec3 &direction : { glm::vec3(0.0f, -1.0f, 0.0f), glm::vec3(0.8f, -0.6f, 0.0f) }) {
		const int index = batch.add(Joint{}, { direction, { 0.0f, 0.0f, 2.0f } });
		CHECK(is_finite(batch.state(index)));
		CHECK(batch.state(index).direction.y > 0.0f);
	}
}

TEST_CASE("growing keeps all states, removing moves only the last plant") {
	for (const Law law : BOTH_LAWS) {
		PendulumBatch batch(law, FRAME_STEP);
		std::vector<TipState> states;
		for (int i = 0; i < 3000; i++) {
			CHECK(batch.add(varied_joint(i), varied_state(i)) == i);
			states.push_back(batch.state(i));
		}
		for (const int index : { 0, 17, 2997, 1500 }) {
			batch.remove(index);
			states[static_cast<size_t>(index)] = states.back();
			states.pop_back();
		}
		REQUIRE(batch.size() == 2996);
		bool same = true;
		for (int i = 0; i < batch.size(); i++) {
			same = same && same_bits(batch.state(i), states[static_cast<size_t>(i)]);
		}
		CHECK(same);
		while (batch.size() > 0) {
			batch.remove(batch.size() - 1);
		}
		CHECK(batch.add(Joint{}, TipState{}) == 0);
	}
}

TEST_CASE("a plant that took another's place goes on as if it had always stood there") {
	for (const Law law : BOTH_LAWS) {
		PendulumBatch moved = meadow(law, 40);
		PendulumBatch alone(law, FRAME_STEP);
		alone.add(varied_joint(39), varied_state(39));
		for (int i = 0; i < 30; i++) {
			moved.step(wind_at(i));
			alone.step(wind_at(i));
		}
		moved.remove(3);
		for (int i = 30; i < 60; i++) {
			moved.step(wind_at(i));
			alone.step(wind_at(i));
		}
		CHECK(same_bits(moved.state(3), alone.state(0)));
	}
}

TEST_CASE("changing a joint does not touch the motion") {
	for (const Law law : BOTH_LAWS) {
		PendulumBatch batch = meadow(law, 5);
		batch.step(wind_at(0));
		const TipState before = batch.state(2);
		batch.set_joint(2, varied_joint(99));
		CHECK(same_bits(batch.state(2), before));
	}
}

TEST_CASE("a blow changes the velocity by impulse/mass along the sphere") {
	for (const Law law : BOTH_LAWS) {
		Joint joint;
		joint.length = 2.0f;
		joint.mass = 0.5f;
		PendulumBatch batch(law, FRAME_STEP);
		batch.add(joint, leaning(0.5));
		batch.apply_impulse(0, { 1.0f, 0.0f, 0.3f });
		const TipState tip = batch.state(0);
		const float along = static_cast<float>(std::cos(0.5));
		CHECK(glm::length(tip.rate - glm::vec3(along * along, -along * std::sin(0.5f), 0.3f)) < 4.0f * STATE_TOLERANCE);
		CHECK(glm::length(tip.direction - leaning(0.5).direction) < STATE_TOLERANCE);
	}
}

TEST_CASE("interpolation goes from the last step but one to the last") {
	for (const Law law : BOTH_LAWS) {
		PendulumBatch batch = meadow(law, 37);
		for (int i = 0; i < 20; i++) {
			batch.step(wind_at(i));
		}
		std::vector<glm::vec3> before;
		for (int i = 0; i < 37; i++) {
			before.push_back(batch.state(i).direction);
		}
		batch.step(wind_at(20));
		std::vector<glm::vec3> start(37), middle(37), end(37);
		batch.interpolate(0.0f, start.data());
		batch.interpolate(0.5f, middle.data());
		batch.interpolate(1.0f, end.data());
		for (size_t i = 0; i < 37; i++) {
			const glm::vec3 now = batch.state(static_cast<int>(i)).direction;
			CHECK(glm::length(start[i] - before[i]) < STATE_TOLERANCE);
			CHECK(glm::length(end[i] - now) < STATE_TOLERANCE);
			CHECK(std::fabs(glm::length(middle[i]) - 1.0f) < STATE_TOLERANCE);
			CHECK(glm::length(middle[i] - glm::normalize(before[i] + now)) < 0.02f);
		}
	}
}

TEST_CASE("a state that is set leaves no trace of the last one") {
	for (const Law law : BOTH_LAWS) {
		PendulumBatch batch = meadow(law, 1);
		batch.step(wind_at(0));
		batch.set_state(0, leaning(0.2));
		glm::vec3 drawn;
		batch.interpolate(0.3f, &drawn);
		CHECK(glm::length(drawn - leaning(0.2).direction) < STATE_TOLERANCE);
	}
}

TEST_CASE("steps split anywhere, at every level, give the same bits") {
	constexpr int COUNT = 101;
	for (const Law law : BOTH_LAWS) {
		PendulumBatch whole = meadow(law, COUNT);
		PendulumBatch split = meadow(law, COUNT);
		PendulumBatch best = meadow(law, COUNT);
		for (int i = 0; i < 300; i++) {
			const int cut = (i * 37) % (COUNT + 1);
			whole.step(0, COUNT, wind_at(i), SimdLevel::baseline);
			split.step(cut, COUNT, wind_at(i), SimdLevel::avx2);
			split.step(0, cut, wind_at(i), SimdLevel::baseline);
			best.step(0, COUNT, wind_at(i), SimdLevel::avx2);
		}
		CHECK(hash_states(whole) == hash_states(split));
		CHECK(hash_states(whole) == hash_states(best));
	}
}

TEST_CASE("a range beyond the ends steps the plants that there are") {
	PendulumBatch batch = meadow(Law::spring, 3);
	PendulumBatch other = meadow(Law::spring, 3);
	batch.step(-5, 99, wind_at(0), SimdLevel::baseline);
	other.step(wind_at(0));
	CHECK(hash_states(batch) == hash_states(other));
}

TEST_CASE("no joint, state or wind, however extreme, leads to a number that is none") {
	constexpr float NONE = std::numeric_limits<float>::quiet_NaN();
	constexpr float INF = std::numeric_limits<float>::infinity();
	constexpr float EXTREMES[] = { 0.0f, 1e-30f, 1e-6f, 1.0f, 1e6f, 1e30f, -1.0f, NONE, INF };
	for (const Law law : BOTH_LAWS) {
		PendulumBatch batch(law, FRAME_STEP);
		for (const float a : EXTREMES) {
			for (const float b : EXTREMES) {
				Joint joint;
				joint.length = a;
				joint.mass = b;
				batch.add(joint, leaning(1.0));
				joint = Joint{};
				joint.elasticity = a;
				joint.inner_friction = b;
				joint.natural_frequency = a;
				joint.damping_ratio = b;
				batch.add(joint, leaning(-0.5));
				joint.length = 1e-3f;
				joint.mass = 1e-3f;
				joint.wind_weight = a;
				joint.rest = { a, b, 0.0f };
				joint.above_ground = false;
				batch.add(joint, { { a, b, 1.0f }, { b, a, a } });
			}
		}
		const glm::vec3 winds[] = { { 1e6f, 0.0f, 0.0f }, CALM, { -1e6f, 1e6f, 1e6f }, { NONE, INF, 0.0f },
			{ 0.0f, 0.0f, 1e30f } };
		for (int i = 0; i < 2000; i++) {
			batch.step(winds[(i / 7) % 5]);
			if (i % 100 == 0) {
				for (int k = 0; k < batch.size(); k++) {
					batch.apply_impulse(k, { 1e6f, -1e6f, NONE });
					batch.apply_impulse(k, { 1e6f, -1e6f, 1e30f });
				}
			}
		}
		std::vector<glm::vec3> drawn(static_cast<size_t>(batch.size()));
		batch.interpolate(0.5f, drawn.data());
		for (int i = 0; i < batch.size(); i++) {
			CAPTURE(i);
			CHECK(is_finite(batch.state(i)));
			CHECK(std::fabs(glm::length(batch.state(i).direction) - 1.0f) < 4.0f * STATE_TOLERANCE);
			CHECK(std::fabs(glm::length(drawn[static_cast<size_t>(i)]) - 1.0f) < 4.0f * STATE_TOLERANCE);
		}
	}
}

TEST_CASE("a run of each law has the same bits on every platform") {
	constexpr uint64_t ELASTICITY_GOLDEN = 0x213c5fb3c2308ef1ull;
	constexpr uint64_t SPRING_GOLDEN = 0x39485c024b044527ull;
	for (const Law law : BOTH_LAWS) {
		PendulumBatch batch = meadow(law, 50);
		for (int i = 0; i < 600; i++) {
			batch.step(wind_at(i));
		}
		CHECK(hash_states(batch) == (law == Law::elasticity ? ELASTICITY_GOLDEN : SPRING_GOLDEN));
	}
}
