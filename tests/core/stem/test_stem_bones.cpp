#include "stems.hpp"

#include "stem/stem_bones.hpp"
#include "stem/stem_shape.hpp"

#include "figures.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

using namespace undergrowth;
using doctest::Approx;

namespace {

constexpr double LENGTH = 1e-5; // Of the stem; so is the next.
constexpr double FINE_LINE = 0.005;
constexpr double SHADER = 0.01;

/// The centre line, integrated in very many short steps.
glm::dvec3 integrated(const StemConstants &stem, const SteadyStem &steady, double x) {
	glm::dvec3 sum(0.0);
	constexpr int STEPS = 500;
	for (int i = 0; i < STEPS; i++) {
		const float at = static_cast<float>(x * (i + 0.5) / STEPS);
		const glm::dvec2 bend = stem_bend(stem, steady.amplitudes, at);
		const double n = glm::dot(bend, bend);
		sum += glm::dvec3(2.0 * bend.x, 1.0 - n, 2.0 * bend.y) * (x / STEPS / (1.0 + n));
	}
	return sum;
}

glm::vec3 turned(const glm::vec4 &turn, const glm::vec3 &v) {
	return glm::quat(turn.w, turn.x, turn.y, turn.z) * v;
}

/// Position of a vertex by linear blend skinning, at rest, in stem lengths.
glm::vec3 skinned(const StemConstants &stem, const SteadyStem &steady, const glm::vec3 &vertex) {
	StemLink links[MAX_STEM_JOINTS];
	stem_links(stem, steady.amplitudes, links);
	const StemBinding binding = bind_to_stem(stem.joints, vertex.y);
	glm::vec3 sum(0.0f);
	for (int i = 0; i < 4; i++) {
		const int bone = binding.bones[i];
		if (bone == 0) {
			sum += binding.weights[i] * vertex;
			continue;
		}
		const glm::vec3 rest(0.0f, static_cast<float>(bone - 1) / static_cast<float>(stem.joints), 0.0f);
		sum += binding.weights[i] * (links[bone - 1].start + turned(links[bone - 1].turn, vertex - rest));
	}
	return sum;
}

} // namespace

TEST_CASE("a chain of bones is as long as its stem at any bend") {
	for (int joints = 1; joints <= MAX_STEM_JOINTS; joints++) {
		const StemConstants stem = jointed(joints, 0.5, 0.5);
		for (int i = 0; i < 50; i++) {
			const float size = 0.03f * static_cast<float>(i);
			const glm::vec2 amplitudes[2] = { { size, -0.3f * size }, { -0.5f * size, 0.8f } };
			StemLink links[MAX_STEM_JOINTS];
			const glm::vec3 end = stem_links(stem, amplitudes, links);
			double length = 0.0;
			for (int j = 0; j < joints; j++) {
				const glm::vec3 next = j + 1 < joints ? links[j + 1].start : end;
				length += glm::distance(glm::dvec3(links[j].start), glm::dvec3(next));
				REQUIRE(glm::distance(turned(links[j].turn, { 0.0f, 1.0f, 0.0f }), links[j].direction) < 1e-5f);
				REQUIRE(glm::length(links[j].turn) == Approx(1.0).epsilon(1e-6).scale(0.0));
			}
			REQUIRE(length == Approx(1.0).epsilon(LENGTH).scale(0.0));
			figures::record_error(figures::STEMS, "length of a chain of bones", LENGTH, length - 1.0);
		}
	}
}

TEST_CASE("a stem at rest is upright") {
	const StemConstants stem = jointed(4, 0.5, 0.5);
	const glm::vec2 amplitudes[2] = {};
	StemLink links[MAX_STEM_JOINTS];
	CHECK(stem_links(stem, amplitudes, links) == glm::vec3(0.0f, 1.0f, 0.0f));
	for (int j = 0; j < 4; j++) {
		CHECK(links[j].turn == glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
	}
	CHECK(glm::distance(stem_place(stem, amplitudes, 0.3f).centre, { 0.0f, 0.3f, 0.0f }) < 1e-6f);
}

TEST_CASE("the centre line of three points matches that of very many") {
	for (const double taper : { 0.0, 0.6 }) {
		const StemConstants stem = jointed(4, taper, taper);
		for (const auto &[slope, max] : { std::pair(1.0, 0.002), std::pair(2.747, 0.003) }) { // 45° and 70°.
			const SteadyStem steady = in_newtons(stem, slope);
			for (int i = 1; i <= 16; i++) {
				const float x = static_cast<float>(i) / 16.0f;
				const glm::dvec3 drawn = stem_place(stem, steady.amplitudes, x).centre;
				CHECK(glm::distance(drawn, integrated(stem, steady, x)) < max);
			}
		}
	}
}

TEST_CASE("skinning with four bones matches the shader within 0.5 % of the length at 45 degrees") {
	for (const double taper : { 0.0, 0.6 }) {
		const StemConstants stem = jointed(4, taper, taper);
		const SteadyStem steady = in_newtons(stem, 1.0);
		StemLink links[MAX_STEM_JOINTS];
		const glm::vec3 end = stem_links(stem, steady.amplitudes, links);
		CHECK(glm::distance(glm::dvec3(end), integrated(stem, steady, 1.0)) < FINE_LINE);
		for (int i = 0; i <= 64; i++) {
			const float x = static_cast<float>(i) / 64.0f;
			const glm::vec3 skin = skinned(stem, steady, { 0.0f, x, 0.0f });
			const double far = glm::distance(glm::dvec3(skin), integrated(stem, steady, x));
			const float apart = glm::distance(skin, stem_place(stem, steady.amplitudes, x).centre);
			CHECK(far < FINE_LINE);
			CHECK(apart < SHADER);
			figures::record_error(figures::STEMS, "skin of four bones, tip to 45°, of the length", FINE_LINE, far);
			figures::record_error(figures::STEMS, "skin beside the shader of fields, of the length", SHADER, apart);
		}
	}
}

TEST_CASE("weights sum to one, change smoothly and do not move the root") {
	for (int joints = 1; joints <= MAX_STEM_JOINTS; joints++) {
		float before[MAX_STEM_JOINTS + 1] = {};
		for (int i = 0; i <= 1000; i++) {
			const StemBinding binding = bind_to_stem(joints, static_cast<float>(i) / 1000.0f);
			float of_bone[MAX_STEM_JOINTS + 1] = {};
			float sum = 0.0f;
			for (int k = 0; k < 4; k++) {
				REQUIRE(binding.bones[k] >= 0);
				REQUIRE(binding.bones[k] <= joints);
				REQUIRE(binding.weights[k] >= -1e-6f);
				of_bone[binding.bones[k]] += binding.weights[k];
				sum += binding.weights[k];
			}
			REQUIRE(sum == Approx(1.0).epsilon(1e-6).scale(0.0));
			for (int bone = 0; bone <= joints; bone++) {
				REQUIRE((i == 0 || std::abs(of_bone[bone] - before[bone]) < 0.002f * static_cast<float>(joints)));
				before[bone] = of_bone[bone];
			}
		}
		const StemConstants stem = jointed(joints, 0.6, 0.5);
		CHECK(glm::length(skinned(stem, in_newtons(stem, 2.0), glm::vec3(0.0f))) < 1e-6f);
	}
}

TEST_CASE("a head above its stem turns with the last bone alone") {
	for (const float x : { 1.001f, 1.3f, std::numeric_limits<float>::infinity() }) {
		const StemBinding binding = bind_to_stem(4, x);
		CHECK(binding.bones[0] == 4);
		CHECK(binding.weights[0] == 1.0f);
		CHECK(binding.weights[1] + binding.weights[2] + binding.weights[3] == 0.0f);
	}
}

TEST_CASE("a stem that points straight down has bones with valid rotations") {
	StemConstants stem = jointed(2, 0.0, 0.0, 1);
	const glm::vec2 amplitudes[1] = { { 1e6f, 0.0f } };
	StemLink links[MAX_STEM_JOINTS];
	const glm::vec3 end = stem_links(stem, amplitudes, links);
	CHECK(std::isfinite(end.x + end.y + end.z));
	for (int j = 0; j < 2; j++) {
		CHECK(glm::length(links[j].turn) == Approx(1.0).epsilon(1e-5).scale(0.0));
	}
}
