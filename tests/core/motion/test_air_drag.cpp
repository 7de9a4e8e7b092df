#include "../wind/air_series.hpp"
#include "varied.hpp"

#include "conventions.hpp"
#include "wind/air_sources.hpp"
#include "wind/field_wind.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace undergrowth;

namespace {

constexpr double DAMPING_TOLERANCE = 0.06;
constexpr double BEND_TOLERANCE = 1e-3; // Of the tangent.

FieldWind air_of(float turbulence) {
	FieldWind wind;
	wind.wind.kind = WindKind::air;
	wind.wind.direction = 0.7f;
	wind.air.heading = 0.7;
	wind.air.speed = 8.0f;
	wind.air.turbulence = turbulence;
	wind.tiles = std::shared_ptr<const AirTiles>(&shared_tiles(), [](const AirTiles *) {});
	return wind;
}

MotionPage one_plant(Law law, const Joint &joint, float canopy_height) {
	MotionSpecies species;
	species.law = law;
	species.joint = joint;
	species.canopy_height = canopy_height;
	MotionPlant plant;
	plant.length = 0.8f;
	return MotionPage(0, species, &plant, 1, 1.0f / 60.0f, true, MotionPage::Keeps::directions);
}

/// Tangent of the bend along the wind, at rest in a smooth wind.
double resting_bend(Law law, const Joint &joint, float canopy_height) {
	MotionPage page = one_plant(law, joint, canopy_height);
	const FieldWind wind = air_of(0.0f);
	for (int i = 0; i < 6000; i++) {
		page.step(wind_at_time(wind, i / 60.0), winds_along(wind));
	}
	const glm::vec3 d = page.direction(0);
	const PlantWinds along = winds_along(wind);
	return static_cast<double>((d.x * along.x + d.z * along.z) / d.y);
}

double force_of(double area, double speed) {
	return 0.5 * 1.225 * area * speed * speed;
}

} // namespace

TEST_CASE("a plant in smooth air bends by the drag of its area at the speed of its tip") {
	Joint joint;
	joint.mass = 0.01f;
	joint.wind_weight = 0.02f;
	joint.natural_frequency = 1.5f;
	joint.damping_ratio = 0.3f;
	const double omega = 2.0 * 3.14159265358979 * 1.5;
	const double stiffness = 0.01 * omega * omega * 0.8;
	const double alone = 8.0 * open_ground_speed(0.8, 0.03), sheltered = 8.0 * canopy_top_speed(0.8);
	for (const float area : { -1.0f, 0.005f, 0.0f }) {
		joint.drag_area = area;
		const double felt = area < 0.0f ? 0.02 : static_cast<double>(area);
		const double bend = resting_bend(Law::spring, joint, 0.0f);
		CHECK(std::fabs(bend - force_of(felt, alone) / stiffness) < BEND_TOLERANCE);
		const double in_canopy = resting_bend(Law::spring, joint, 0.8f);
		CHECK(std::fabs(in_canopy - force_of(felt, sheltered) / stiffness) < BEND_TOLERANCE);
	}
	joint.wind_weight = 0.0f;
	CHECK(resting_bend(Law::spring, joint, 0.0f) == 0.0);
}

TEST_CASE("under the elasticity law air has the same force as newtons of the same size") {
	Joint joint;
	joint.mass = 0.02f;
	joint.drag_area = 0.004f;
	joint.inner_friction = 0.05f;
	const double bend = resting_bend(Law::elasticity, joint, 0.0f);
	const double force = force_of(0.004, 8.0 * open_ground_speed(0.8, 0.03));
	const double angle = std::atan(bend);
	const double held = 0.02 * 9.81 * std::tan(angle) * (5.0 * std::cos(angle) - 1.0);
	CHECK(std::fabs(held / force - 1.0) < BEND_TOLERANCE);
}

TEST_CASE("air damps a swing across it by its drag, and one along it twice as much") {
	Joint joint;
	joint.mass = 0.01f;
	joint.wind_weight = 0.02f;
	joint.natural_frequency = 2.0f;
	joint.damping_ratio = 0.0f;
	joint.elasticity = 12.0f;
	joint.inner_friction = 0.0f;
	FieldWind wind = air_of(0.0f);
	wind.wind.direction = 0.0f;
	wind.air.heading = 0.0;
	wind.air.speed = 1.5f;
	const double speed = 1.5 * open_ground_speed(0.8, 0.03);
	const double rate = 0.5 * 1.225 * 0.02 * speed / 0.01; // Of the energy of a swing across, 1/s.
	for (const Law law : BOTH_LAWS) {
		for (const bool is_along : { false, true }) {
			MotionPage page = one_plant(law, joint, 0.0f), calm = one_plant(law, joint, 0.0f);
			const glm::vec3 pushed = is_along ? glm::vec3(0.0f, 1.0f, 0.05f) : glm::vec3(0.05f, 1.0f, 0.0f);
			page.set_state(0, { glm::normalize(pushed), {} });
			std::vector<double> peaks;
			double last = 0.0, before = 0.0;
			for (int i = 0; i < 240; i++) {
				const WindSnapshot now = wind_at_time(wind, i / 60.0);
				page.step(now, winds_along(wind));
				calm.step(now, winds_along(wind));
				const glm::vec3 off = page.direction(0) - calm.direction(0);
				const auto place = static_cast<double>(is_along ? off.z : off.x);
				if (last > before && last > place) {
					peaks.push_back(last);
				}
				before = last;
				last = place;
			}
			const double periods = static_cast<double>(peaks.size()) - 1.0;
			const double frequency = law == Law::spring ? 2.0 : std::sqrt(12.0 * 9.81 / 0.8) / (2.0 * PI);
			const double decay = std::log(peaks.front() / peaks.back()) * frequency / periods;
			CHECK(std::fabs(decay / (0.5 * rate * (is_along ? 2.0 : 1.0)) - 1.0) < DAMPING_TOLERANCE);
		}
	}
}

TEST_CASE("plants in turbulent air have the same bits at every level, for any division") {
	const FieldWind wind = air_of(-1.0f);
	for (const Law law : BOTH_LAWS) {
		MotionPage whole = meadow(law, 0, 601), best = meadow(law, 0, 601), first = meadow(law, 0, 123);
		for (int i = 0; i < 200; i++) {
			const WindSnapshot now = wind_at_time(wind, i / 60.0);
			whole.step(now, winds_along(wind), SimdLevel::baseline);
			best.step(now, winds_along(wind), SimdLevel::avx2);
			first.step(now, winds_along(wind));
		}
		CHECK(hash_states(whole) == hash_states(best));
		REQUIRE(same_bits(whole.state(17), first.state(17)));
		CHECK(whole.direction(17) != whole.direction(18));
	}
}

TEST_CASE("a source moves only the pages within its reach, with the same bits at every level") {
	AirSource fan;
	fan.kind = AirSource::Kind::fan;
	fan.speed = 8.0f;
	for (const bool newtons : { false, true }) {
		FieldWind wind = air_of(-1.0f);
		wind.wind.kind = newtons ? WindKind::waves : WindKind::air;
		for (const Law law : BOTH_LAWS) {
			MotionPage calm = meadow(law, 0, 601), near = meadow(law, 0, 601), best = meadow(law, 0, 601);
			MotionPage far = meadow(law, 0, 601);
			for (int i = 0; i < 100; i++) {
				WindSnapshot now = wind_at_time(wind, i / 60.0);
				calm.step(now, winds_along(wind));
				fan.place = { 1e4f, 0.0f, 0.0f };
				now.sources = { &fan, 1 };
				far.step(now, winds_along(wind));
				fan.place = { 0.0f, 0.0f, 0.0f };
				near.step(now, winds_along(wind), SimdLevel::baseline);
				best.step(now, winds_along(wind), SimdLevel::avx2);
			}
			CHECK(hash_states(far) == hash_states(calm));
			CHECK(hash_states(near) != hash_states(calm));
			CHECK(hash_states(near) == hash_states(best));
		}
	}
}

TEST_CASE("a wind in newtons preserves its direction and force while a source stirs the air") {
	AirSource still;
	still.kind = AirSource::Kind::fan;
	still.speed = 0.0f;
	Joint joint;
	joint.natural_frequency = 1.5f;
	joint.damping_ratio = 0.3f;
	for (const float direction : { 0.0f, 0.7f, 0.5f * static_cast<float>(PI), 4.0f }) {
		FieldWind wind;
		wind.wind.kind = WindKind::constant;
		wind.wind.strength = 10.0f;
		wind.wind.direction = direction;
		MotionPage calm = one_plant(Law::spring, joint, 0.0f), stirred = one_plant(Law::spring, joint, 0.0f);
		for (int i = 0; i < 3000; i++) {
			WindSnapshot now = wind_at_time(wind, i / 60.0);
			calm.step(now, winds_along(wind));
			now.sources = { &still, 1 };
			stirred.step(now, winds_along(wind));
		}
		CHECK(glm::length(calm.direction(0) - glm::vec3(0.0f, 1.0f, 0.0f)) > 0.05f);
		CHECK(glm::length(calm.direction(0) - stirred.direction(0)) < static_cast<float>(BEND_TOLERANCE));
	}
}

TEST_CASE("no joint, state or air, however extreme, causes an invalid number") {
	constexpr float NONE = std::numeric_limits<float>::quiet_NaN();
	constexpr float EXTREMES[] = { 0.0f, 1e-6f, 1.0f, 1e6f, 1e30f, -1.0f, NONE };
	for (const Law law : BOTH_LAWS) {
		for (const float a : EXTREMES) {
			for (const float b : EXTREMES) {
				Joint joint;
				joint.mass = b;
				joint.wind_weight = a;
				joint.drag_area = b;
				joint.natural_frequency = a;
				joint.elasticity = b;
				MotionPage page = one_plant(law, joint, 0.0f);
				page.set_state(0, { { a, 1.0f, b }, { b, a, a } });
				FieldWind wind = air_of(-1.0f);
				AirSource blast;
				blast.speed = 340.0f;
				for (int i = 0; i < 200; i++) {
					wind.air.speed = i % 50 < 25 ? 100.0f : b;
					WindSnapshot now = wind_at_time(wind, i / 60.0);
					blast.age = static_cast<float>(i % 40) / 60.0f;
					now.sources = { &blast, 1 };
					page.step(now, winds_along(wind));
				}
				REQUIRE(is_finite(page.state(0)));
			}
		}
	}
}
