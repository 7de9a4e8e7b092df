#include "allocations.hpp"
#include "field/speed_histogram.hpp"
#include "field_fixture.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace undergrowth;

namespace {

constexpr int RUNG_DOWN =
		static_cast<int>((DetachedFollowers::ALONE + DetachedFollowers::GOING_BACK) / FIELD_STEP) + 2; // Steps.
constexpr int STIRRED = 180; // Steps.
constexpr int CALM = STIRRED + 120; // The effect of the fan has nearly vanished.
constexpr float FAR = 500.0f; // m, to the second page.
constexpr float JUMP = 0.12f; // Between two steps, as for other pushed followers.

AirSource fan() {
	AirSource source;
	source.kind = AirSource::Kind::fan;
	source.speed = 1.5f;
	return source;
}

/// Plants that follow, `apart` (m) from each other around the origin, and the same number far away.
FieldSimulation two_lawns(Law law, int side, float apart) {
	FieldSettings settings;
	settings.prototypes = 16;
	FieldSimulation field(settings);
	const int kind = field.add_species(species_of(law));
	for (const float place : { 0.0f, FAR }) {
		std::vector<MotionPlant> plants;
		for (int i = 0; i < side * side; i++) {
			plants.push_back(chance_plant(i));
			const auto column = static_cast<float>(i % side) - 0.5f * static_cast<float>(side);
			const auto row = static_cast<float>(i / side) - 0.5f * static_cast<float>(side);
			plants.back().root = { place + apart * (column + 0.3f), 0.0f, apart * (row + 0.3f) };
			if (static_cast<int>(plants.size()) == MotionPage::PAGE_PLANTS || i == side * side - 1) {
				field.add_page(kind, plants.data(), static_cast<int>(plants.size()));
				plants.clear();
			}
		}
	}
	field.set_wind(wave_wind());
	for (int i = 0; i < 60; i++) {
		field.step();
	}
	return field;
}

float speed_at(const AirSource &source, const FieldSimulation &field, int page, int index) {
	const glm::vec3 added = velocity_at(source, field.page(page).root(index));
	return std::sqrt(added.x * added.x + added.z * added.z);
}

} // namespace

TEST_CASE("followers react to sources within their reach, and follow again without a jump") {
	for (const Law law : { Law::elasticity, Law::spring }) {
		FieldSimulation field = two_lawns(law, 14, 0.5f), calm = two_lawns(law, 14, 0.5f);
		const int plants = field.page(0).size();
		std::vector<glm::vec3> before(static_cast<size_t>(plants));
		float outward = 0.0f;
		for (int i = 0; i < STIRRED + RUNG_DOWN; i++) {
			field.set_air_sources(i < STIRRED ? std::vector<AirSource>{ fan() } : std::vector<AirSource>{});
			field.step();
			calm.step();
			for (int k = 0; k < plants; k++) {
				const glm::vec3 now = field.state(0, k).direction;
				REQUIRE((i < CALM || glm::distance(now, before[static_cast<size_t>(k)]) < JUMP));
				before[static_cast<size_t>(k)] = now;
				if (i >= 60 && i < STIRRED) {
					const glm::vec3 away = glm::normalize(field.page(0).root(k));
					outward += glm::dot(now - calm.state(0, k).direction, away) /
							static_cast<float>((STIRRED - 60) * plants);
				}
			}
			REQUIRE((i < 3 || i >= STIRRED || field.detached_followers(0)->count() > plants / 2));
		}
		CHECK(outward > 0.02f);
		CHECK(field.detached_followers(0)->count() == 0);
		for (int k = 0; k < plants; k++) {
			REQUIRE(field.state(0, k).direction == calm.state(0, k).direction);
		}
	}
}

TEST_CASE("sources do not affect followers beyond their reach") {
	FieldSimulation field = two_lawns(Law::spring, 14, 0.5f), calm = two_lawns(Law::spring, 14, 0.5f);
	field.set_air_sources({ fan() });
	for (int i = 0; i < 30; i++) {
		field.step();
		calm.step();
		for (int k = 0; k < field.page(1).size(); k++) {
			REQUIRE(field.follower(1, k).detached == 0);
			REQUIRE(field.state(1, k).direction == calm.state(1, k).direction);
		}
	}
	CHECK(field.detached_followers(0)->count() > 0);
}

TEST_CASE("with too many followers, those with the most stirred air react") {
	FieldSimulation field = two_lawns(Law::spring, 100, 0.3f);
	AirSource wide = fan();
	wide.radius = 2.0f;
	field.set_air_sources({ wide });
	for (int i = 0; i < 6; i++) {
		field.step();
	}
	float weakest = 1e9f, strongest = 0.0f;
	for (int page = 0; page < field.page_count(); page++) {
		for (int k = 0; k < field.page(page).size(); k++) {
			const float speed = speed_at(wide, field, page, k);
			float &edge = field.follower(page, k).detached > 0 ? weakest : strongest;
			edge = field.follower(page, k).detached > 0 ? std::min(edge, speed) : std::max(edge, speed);
		}
	}
	CHECK(field.detached_followers(0)->count() <= DetachedFollowers::MAX_COUNT);
	CHECK(field.detached_followers(0)->count() > DetachedFollowers::MAX_COUNT / 4);
	CHECK(strongest > SpeedHistogram::MIN_SPEED);
	CHECK(weakest >= strongest);
}

TEST_CASE("stirred followers allocate nothing in steps" * doctest::skip(!counts_allocations())) {
	FieldSimulation field = two_lawns(Law::spring, 14, 0.5f);
	field.set_air_sources({ fan() });
	const long before = allocation_count();
	for (int i = 0; i < 12; i++) {
		field.step();
	}
	CHECK(allocation_count() == before);
	CHECK(field.detached_followers(0)->count() > 0);
}

TEST_CASE("the fastest of the stirred plants are chosen, up to the limit") {
	SpeedHistogram counts;
	for (int i = 0; i < 100; i++) {
		counts.add(0.6f);
		counts.add(3.0f);
	}
	counts.add(1e6f);
	counts.choose(1000);
	CHECK(counts.chosen() == SpeedHistogram::MIN_SPEED);
	counts.choose(150);
	CHECK(counts.chosen() > 0.6f);
	CHECK(counts.chosen() <= 3.0f);
	counts.choose(50);
	CHECK(counts.chosen() > 3.0f);
	counts.choose(0);
	CHECK(counts.chosen() > 80.0f);
	CHECK(counts.chosen() < 1e6f);
	counts.clear();
	counts.choose(0);
	CHECK(counts.chosen() == SpeedHistogram::MIN_SPEED);
}
