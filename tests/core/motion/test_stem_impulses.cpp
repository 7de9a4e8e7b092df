#include "../stem/stems.hpp"
#include "motion/stem_impulses.hpp"
#include "stem/stem_bones.hpp"
#include "stem_plants.hpp"

#include "figures.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <initializer_list>

using namespace undergrowth;

namespace {

constexpr float SPEED_TOLERANCE = 0.01f; // Relative.

/// Position of a joint, from 1 on; the last one is the head's centre.
float at_joint(const StemConstants &stem, int joint) {
	return joint > stem.joints ? ON_HEAD : static_cast<float>(joint) / static_cast<float>(stem.joints);
}

StemState standing(const glm::vec2 &first, const glm::vec2 &second) {
	StemState state;
	state.place[0] = first;
	state.place[1] = second;
	return state;
}

StemConstants sample(int modes) {
	StemBeam beam = stem_of(0.6, 0.5);
	beam.modes = modes;
	return solve_stem(beam).constants;
}

} // namespace

TEST_CASE("an impulse changes a joint's speed by impulse over mass, across the stem, bent or not, of any length") {
	for (const int modes : { 1, 2 }) {
		const StemConstants stem = sample(modes);
		for (int joint = 1; joint <= stem.joints + 1; joint++) {
			for (const float bent : { 0.0f, 0.3f, -0.5f }) {
				for (const float scale : { 1.0f, 0.5f, 2.0f }) {
					StemState state = standing({ bent, 0.2f * bent }, { modes == 2 ? 0.01f : 0.0f, 0.0f });
					const glm::vec3 impulse(1e-5f, 2e-6f, -3e-6f);
					apply_stem_impulse(stem, state, at_joint(stem, joint), impulse, scale);
					const glm::vec3 speed = stem_velocity(stem, state, at_joint(stem, joint), scale);
					const float x = std::min(static_cast<float>(joint) / static_cast<float>(stem.joints), 1.0f);
					const glm::vec2 bend = stem_bend(stem, state.place, x);
					const glm::vec3 direction = from_stereographic(bend);
					const glm::vec3 expected = (impulse - direction * glm::dot(impulse, direction)) /
							stem_mass(stem, at_joint(stem, joint));
					CAPTURE(joint);
					CAPTURE(bent);
					const float off = glm::distance(speed, expected) / glm::length(expected);
					CHECK(off < SPEED_TOLERANCE);
					figures::record_error(figures::SWINGS, "speed after an impulse on a joint", SPEED_TOLERANCE, off);
					CHECK(std::fabs(glm::dot(speed, direction)) < 1e-4f * glm::length(speed));
				}
			}
		}
	}
}

TEST_CASE("the mass at the head of a light stem is that of the head") {
	StemBeam beam = stem_of(0.0, 20.0);
	const StemConstants stem = solve_stem(beam).constants;
	// The effective mass at a cantilever's tip includes 33/140 of the stem's.
	const double expected = static_cast<double>(beam.head_mass) + 33.0 / 140.0 * mass_of(beam);
	CHECK(static_cast<double>(stem_mass(stem, ON_HEAD)) == doctest::Approx(expected).epsilon(0.06));
}

TEST_CASE("the root resists an impulse along the stem") {
	const StemConstants stem = sample(2);
	StemState state = standing({ 0.4f, -0.1f }, { 0.0f, 0.0f });
	apply_stem_impulse(stem, state, 1.0f, 1e-3f * from_stereographic(stem_bend(stem, state.place, 1.0f)), 1.0f);
	CHECK(glm::length(state.rate[0]) < 1e-4f);
	CHECK(glm::length(state.rate[1]) < 1e-3f);
}

TEST_CASE("a push moves a joint by its length, with the least energy") {
	for (const int modes : { 1, 2 }) {
		const StemConstants stem = sample(modes);
		for (int joint = 1; joint <= stem.joints; joint++) {
			StemState state;
			const glm::vec2 *places = state.place;
			const float way = 0.02f * stem.deflection[joint - 1][0];
			push_stem(stem, state, at_joint(stem, joint), { 0.0f, 0.0f, way }, 1.0f);
			float moved = 0.0f;
			for (int k = 0; k < modes; k++) {
				moved += 2.0f * stem.deflection[joint - 1][k] * places[k].y;
			}
			CAPTURE(joint);
			CHECK(moved == doctest::Approx(way).epsilon(1e-4));
			const float x = static_cast<float>(joint) / static_cast<float>(stem.joints);
			CHECK(stem_place(stem, places, x).centre.z * stem.length == doctest::Approx(way).epsilon(0.02));
			if (modes == 2) { // More of one mode and less of the other store more energy.
				const float a = stem.mode[0].stiffness * places[0].y * stem.deflection[joint - 1][1];
				const float b = stem.mode[1].stiffness * places[1].y * stem.deflection[joint - 1][0];
				CHECK(a == doctest::Approx(b).epsilon(1e-3));
			}
		}
	}
}

TEST_CASE("no impulse and no push, however strong, exceeds the limits") {
	const StemConstants stem = sample(2);
	for (const float size : { 1e3f, 1e30f, std::nanf("") }) {
		StemState state = standing({ 0.4f, -0.1f }, { 0.0f, 0.0f });
		apply_stem_impulse(stem, state, 0.5f, { size, size, -size }, 1.0f);
		push_stem(stem, state, 0.25f, { -size, 0.0f, size }, 1.0f);
		for (int k = 0; k < 2; k++) {
			CHECK(glm::length(state.rate[k]) <= 1.001f * MAX_STEM_RATE * stem.mode[k].frequency);
			CHECK(glm::length(state.place[k]) <= 1.001f * MAX_STEM_AMPLITUDE);
		}
	}
}
