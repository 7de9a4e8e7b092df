#include "wind/air_profile.hpp"
#include "wind/air_sources.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

using namespace undergrowth;

namespace {

constexpr double TOLERANCE = 1e-4; // Of a speed.

AirSource source_of(AirSource::Kind kind) {
	AirSource source;
	source.kind = kind;
	source.place = { 2.0f, 1.0f, -3.0f };
	source.speed = 40.0f;
	source.radius = 2.0f;
	source.duration = 0.2f;
	source.front = 100.0f;
	source.age = 0.3f;
	source.velocity = { 0.0f, 0.0f, 9.0f };
	return source;
}

constexpr AirSource::Kind ALL[] = { AirSource::Kind::explosion, AirSource::Kind::fan, AirSource::Kind::wake };

} // namespace

TEST_CASE("an explosion pushes outward by its formula, and then back") {
	AirSource source = source_of(AirSource::Kind::explosion);
	for (const float age : { 0.02f, 0.1f, 0.15f, 0.3f, 0.9f, 2.0f }) {
		for (const float distance : { 0.5f, 3.0f, 8.0f, 20.0f }) {
			source.age = age;
			const double y = (static_cast<double>(age) - static_cast<double>(distance) / 100.0) / 0.2;
			const double far = static_cast<double>(distance) / 2.0;
			const double late = 1.0 + y * y;
			const double expected = y <= 0.0 || y > 8.0 ? 0.0 : 40.0 / (1.0 + far * far) * (1.0 - y) / (late * late);
			const glm::vec3 felt = velocity_at(source, source.place + glm::vec3(0.0f, 0.0f, distance));
			REQUIRE(std::fabs(static_cast<double>(felt.z) - expected) < TOLERANCE * 40.0);
			REQUIRE(felt.x == 0.0f);
		}
	}
	// Total impulse: U·T times the integral of (1 - y)/(1 + y²)², from 0 to 8.
	double impulse = 0.0;
	for (int i = 0; i < 20000; i++) {
		source.age = 0.0001f * static_cast<float>(i);
		impulse += 0.0001 * static_cast<double>(velocity_at(source, source.place + glm::vec3(1e-3f, 0.0f, 0.0f)).x);
	}
	CHECK(std::fabs(impulse / (40.0 * 0.2) - 0.285) < 0.01);
}

TEST_CASE("a fan's jet runs outward along the ground") {
	AirSource source = source_of(AirSource::Kind::fan);
	for (const float distance : { 0.5f, 2.6f, 10.0f, 20.0f }) {
		const double x = static_cast<double>(distance) / 2.6;
		const glm::vec3 felt = velocity_at(source, source.place + glm::vec3(-distance, -1.0f, 0.0f));
		CHECK(std::fabs(static_cast<double>(felt.x) + 40.0 * 4.0 * x / (1.0 + x * x)) < TOLERANCE * 40.0);
		CHECK(felt.z == 0.0f);
	}
	CHECK(static_cast<double>(induced_speed(15000.0f, 5.0f)) ==
			doctest::Approx(std::sqrt(15000.0 / (2.0 * 1.225 * 3.14159265 * 25.0))));
	const glm::vec3 place = source.place + glm::vec3(2.6f, 0.0f, 0.0f);
	const float low = velocity_at(source, place).x;
	source.height = 20.0f;
	CHECK(velocity_at(source, place).x == low); // Five diameters above the ground.
	source.height = 48.0f;
	CHECK(velocity_at(source, place).x == doctest::Approx(0.5f * low));
}

TEST_CASE("a fan's jet ends smoothly at sixteen of its radii, at any height") {
	AirSource source = source_of(AirSource::Kind::fan);
	const double spread = 1.3 * 2.0; // m.
	for (const float height : { 0.0f, 40.0f }) {
		source.height = height;
		const double arrived = std::min(24.0 / std::max(static_cast<double>(height), 1e-9), 1.0);
		for (const double x : { 7.9, 9.0, 12.0, 15.5 }) {
			const double faded = std::max(x - 8.0, 0.0) / 8.0;
			const double kept = (1.0 - faded * faded) * (1.0 - faded * faded);
			const double expected = 4.0 * 40.0 * x / (1.0 + x * x) * kept * arrived;
			const glm::vec3 on_ground = source.place + glm::vec3(static_cast<float>(x * spread), -height, 0.0f);
			REQUIRE(std::fabs(static_cast<double>(velocity_at(source, on_ground).x) - expected) < TOLERANCE * 40.0);
		}
	}
}

TEST_CASE("a fan's air comes down as much as it runs outward") {
	constexpr double STEP = 1e-3; // m.
	AirSource source = source_of(AirSource::Kind::fan);
	const float height = 0.2f;
	for (const double distance : { 0.0, 1.0, 2.6, 6.0, 15.0 }) {
		const auto outward = [&](double x, double z) {
			const glm::vec3 way(static_cast<float>(x), -1.0f, static_cast<float>(z));
			return glm::dvec3(velocity_at(source, source.place + way, height));
		};
		const double apart = (outward(distance + STEP, 0.0).x - outward(distance - STEP, 0.0).x +
									 outward(distance, STEP).z - outward(distance, -STEP).z) /
				(2.0 * STEP);
		const double down = outward(distance, 0.0).y;
		CHECK(down == doctest::Approx(-0.75 * 0.2 * apart).epsilon(0.01).scale(1.0));
	}
	const glm::vec3 below = source.place - glm::vec3(0.0f, 1.0f, 0.0f);
	CHECK(velocity_at(source, below, 30.0f).y == -80.0f);
	CHECK(velocity_at(source, below, 0.0f).y == 0.0f);
}

TEST_CASE("a fan's eddies move plants in the middle of its jet, too, and leave the mean as it is") {
	AirSource source = source_of(AirSource::Kind::fan);
	const AirSource steady = source;
	source.unrest = 0.3f;
	constexpr int STEPS = 6400; // A hundred in a turn.
	for (const double x : { 0.0, 0.5, 1.0, 3.0, 7.0 }) {
		const glm::vec3 place = source.place + glm::vec3(static_cast<float>(x * 2.6), -1.0f, 0.0f);
		const glm::vec3 mean = velocity_at(steady, place);
		glm::dvec3 sum(0.0), squares(0.0);
		for (int i = 0; i < STEPS; i++) {
			source.eddies = EDDY_TURNS * static_cast<float>(i) / STEPS;
			const glm::dvec3 apart(velocity_at(source, place) - mean);
			sum += apart;
			squares += apart * apart;
		}
		const double fastest = 80.0 * (x < 1.0 ? 1.0 : 2.0 * x / (1.0 + x * x));
		const double deviation = 0.3 * fastest;
		CHECK(glm::length(sum) / STEPS < 0.01 * deviation);
		CHECK(std::sqrt(squares.x / STEPS) == doctest::Approx(deviation).epsilon(0.02));
		CHECK(std::sqrt(squares.z / STEPS) == doctest::Approx(deviation).epsilon(0.02));
		CHECK(squares.y == 0.0);
	}
	source.eddies = 0.37f;
	AirSource later = source;
	later.eddies += EDDY_TURNS;
	const glm::vec3 place = source.place + glm::vec3(1.0f, 0.0f, 2.0f);
	CHECK(glm::distance(velocity_at(source, place), velocity_at(later, place)) < 0.01f);
	CHECK(eddy_rate(13.0f, 5.0f) == doctest::Approx(2.0f));
}

TEST_CASE("a source acts on a plant at its own height, and on its nearer end above and below it") {
	AirSource source = source_of(AirSource::Kind::wake);
	source.radius = 0.3f;
	source.place = { 0.0f, 0.9f, 0.0f };
	const glm::vec3 root(0.0f, 0.0f, -1.0f); // Behind the body.
	CHECK(velocity_at(source, root, 1.0f) == velocity_at(source, root + glm::vec3(0.0f, 0.9f, 0.0f)));
	CHECK(velocity_at(source, root, 0.5f) == velocity_at(source, root + glm::vec3(0.0f, 0.5f, 0.0f)));
	CHECK(velocity_at(source, root, 1.0f).z > 4.0f * velocity_at(source, root).z);
	source.place.y = -0.2f;
	CHECK(velocity_at(source, root, 1.0f) == velocity_at(source, root));
	const float height = 1.0f;
	float x = 0.0f, z = 0.0f;
	source.place.y = 0.9f;
	const AirSources all = { &source, 1 };
	add_sources(all, root, root, &root.x, &root.y, &root.z, &height, 1, &x, nullptr, &z);
	CHECK(z == velocity_at(source, root, height).z);
}

TEST_CASE("velocities of sources turn with the axes of plants") {
	const AirSource source = source_of(AirSource::Kind::wake);
	const glm::vec3 root = source.place + glm::vec3(1.5f, 0.0f, 2.0f);
	const glm::vec3 in_world = velocity_at(source, root);
	REQUIRE(std::min(std::fabs(in_world.x), std::fabs(in_world.z)) > 0.1f);
	const float c = std::cos(0.6f), s = std::sin(0.6f), height = 0.0f;
	float x = 1.0f, z = 2.0f;
	const AirSources turned = { &source, 1, c, s, -s, c };
	add_sources(turned, root, root, &root.x, &root.y, &root.z, &height, 1, &x, nullptr, &z);
	CHECK(x == doctest::Approx(1.0f + c * in_world.x - s * in_world.z));
	CHECK(z == doctest::Approx(2.0f + s * in_world.x + c * in_world.z));
}

TEST_CASE("a body pushes air aside and ahead, and draws a wake along") {
	const AirSource source = source_of(AirSource::Kind::wake);
	const glm::vec3 ahead = velocity_at(source, source.place + glm::vec3(0.0f, 0.0f, 4.0f));
	CHECK(ahead.z == doctest::Approx(9.0f / 8.0f)); // a³/r³·V.
	const glm::vec3 beside = velocity_at(source, source.place + glm::vec3(4.0f, 0.0f, 0.0f));
	CHECK(beside.z == doctest::Approx(-0.5f * 9.0f / 8.0f));
	const glm::vec3 behind = velocity_at(source, source.place + glm::vec3(0.0f, 0.0f, -16.0f));
	CHECK(static_cast<double>(behind.z) == doctest::Approx(0.6 * 9.0 * std::pow(1.0 + 16.0 / 8.0, -2.0 / 3.0)));
	const double width = 2.0 * std::cbrt(3.0);
	const glm::vec3 at_width = velocity_at(source, source.place + glm::vec3(static_cast<float>(width), 0.0f, -16.0f));
	CHECK(at_width.z == doctest::Approx(0.25f * behind.z));
}

TEST_CASE("no source has an effect beyond its reach, and pages beyond it skip it") {
	for (const AirSource::Kind kind : ALL) {
		AirSource source = source_of(kind);
		source.scale = 2.0f;
		const float far = 0.5f * reach_of(source);
		for (int i = 0; i < 100; i++) {
			const float angle = 0.0628f * static_cast<float>(i);
			const glm::vec3 way = { std::sin(angle), 0.0f, std::cos(angle) };
			REQUIRE(velocity_at(source, source.place + 1.01f * far * way) == glm::vec3(0.0f));
			const glm::vec3 corner = source.place + 1.01f * far * way;
			REQUIRE(!reaches(source, corner, corner));
		}
		CHECK(reaches(source, source.place - glm::vec3(1.0f), source.place + glm::vec3(1.0f)));
	}
	AirSource over = source_of(AirSource::Kind::explosion);
	over.age = 60.0f;
	CHECK(!reaches(over, over.place, over.place));
}

TEST_CASE("sources at any positions, of any sizes and inside each other give finite numbers") {
	constexpr float EXTREMES[] = { 0.0f, 1e-6f, 1.0f, 300.0f, 1e6f };
	for (const AirSource::Kind kind : ALL) {
		for (const float a : EXTREMES) {
			for (const float b : EXTREMES) {
				AirSource source = source_of(kind);
				source.radius = a > 0.0f ? a : 1e-3f;
				source.velocity = { b, -a, 0.0f };
				source.age = b;
				source.height = a;
				for (const float distance : EXTREMES) {
					const glm::vec3 felt = velocity_at(source, source.place + glm::vec3(distance, 0.0f, 0.0f));
					REQUIRE(std::isfinite(felt.x + felt.y + felt.z));
				}
			}
		}
	}
}
