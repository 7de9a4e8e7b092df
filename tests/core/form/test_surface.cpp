#include "form/surface.hpp"
#include "form_species.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace undergrowth;

namespace {

constexpr float STEP = 2e-3f;
constexpr float MAX_ERROR = 3.0f * DEGREE;

glm::vec3 blade_at(const Part &part, const Midrib &midrib, float s, float u) {
	const SurfacePoint point = blade_point(make_blade_row(part, midrib, s, false), make_blade_column(part.blade, u));
	return point.middle * part.length_max + point.aside * part.width;
}

/// Max angle between a blade's normals and those of differences, over both halves.
float worst_blade_normal(const Part &part) {
	const Midrib midrib(part.curve);
	float worst = 0.0f;
	for (float s = 0.04f; s < 0.97f; s += 0.04f) {
		for (const float u : { -0.95f, -0.5f, -0.1f, 0.1f, 0.5f, 0.95f }) {
			const SurfacePoint point =
					blade_point(make_blade_row(part, midrib, s, false), make_blade_column(part.blade, u));
			const glm::vec3 along = blade_at(part, midrib, s + STEP, u) - blade_at(part, midrib, s - STEP, u);
			const glm::vec3 across = blade_at(part, midrib, s, u + STEP) - blade_at(part, midrib, s, u - STEP);
			const glm::vec3 normal = glm::normalize(glm::cross(along, across));
			worst = std::max(worst,
					std::acos(std::min(1.0f, glm::dot(normal, surface_normal(point, part.length_max, part.width)))));
		}
	}
	return worst;
}

Part leaf(const Profile &profile) {
	Part part;
	part.length_min = part.length_max = 0.2f;
	part.width = 0.06f;
	part.widths.profile = profile;
	return part;
}

} // namespace

TEST_CASE("a blade's normals are those of its surface: folded, rolled, twisted, waved and bent") {
	for (const Profile &profile : { GRASS_PROFILE, OVATE_PROFILE, SPATULATE_PROFILE, RAY_PROFILE }) {
		Part part = leaf(profile);
		CHECK(worst_blade_normal(part) < MAX_ERROR);
		part.curve.bend = 70.0f * DEGREE;
		part.blade.fold = 35.0f * DEGREE;
		CHECK(worst_blade_normal(part) < MAX_ERROR);
		part.blade.roll = 40.0f * DEGREE;
		CHECK(worst_blade_normal(part) < MAX_ERROR);
		part.blade.twist = 90.0f * DEGREE;
		CHECK(worst_blade_normal(part) < MAX_ERROR);
		part.blade.wave = 0.3f;
		part.curve.bend = -60.0f * DEGREE;
		CHECK(worst_blade_normal(part) < MAX_ERROR);
	}
}

TEST_CASE("an axis's normals are those of its surface: tapered, bent, lobed") {
	Part part;
	part.kind = PartKind::axis;
	part.length_min = part.length_max = 0.1f;
	part.width = 0.04f;
	part.axis.tip_diameter = 0.01f;
	part.axis.lobes = 5;
	part.axis.lobe_depth = 0.2f;
	part.widths.profile = { 0.3f, 0.2f };
	part.curve.bend = 50.0f * DEGREE;
	const Midrib midrib(part.curve);
	const int columns = 720;
	const std::vector<TubeColumn> round = make_tube_columns(part.axis, columns);
	const auto at = [&](float s, int i) {
		const SurfacePoint point =
				tube_point(make_tube_ring(part, midrib, s), round[static_cast<size_t>((i + columns) % columns)]);
		return point.middle * part.length_max + point.aside * part.width;
	};
	for (float s = 0.05f; s < 0.95f; s += 0.05f) {
		for (int i = 0; i < columns; i += 7) {
			const glm::vec3 normal =
					glm::normalize(glm::cross(at(s + STEP, i) - at(s - STEP, i), at(s, i + 1) - at(s, i - 1)));
			const SurfacePoint point = tube_point(make_tube_ring(part, midrib, s), round[static_cast<size_t>(i)]);
			const glm::vec3 found = surface_normal(point, part.length_max, part.width);
			CHECK(std::acos(std::min(1.0f, glm::dot(normal, found))) < MAX_ERROR);
			CHECK(glm::dot(found, point.aside) > 0.0f);
		}
	}
}

TEST_CASE("a rolled blade is as wide along its arc as a flat one") {
	Part part = leaf(EVEN_PROFILE);
	part.blade.roll = 1.2f;
	const Midrib midrib(part.curve);
	float length = 0.0f;
	for (int i = 0; i < 200; i++) {
		length += glm::length(blade_at(part, midrib, 0.5f, 0.01f * static_cast<float>(i + 1) - 1.0f) -
				blade_at(part, midrib, 0.5f, 0.01f * static_cast<float>(i) - 1.0f));
	}
	CHECK(std::abs(length - part.width) < 1e-3f * part.width);
}

TEST_CASE("a non-round ring has the same direction, and the width of its farthest point") {
	AxisShape axis;
	axis.ring = { { -2.0f, 0.0f }, { 0.0f, 1.0f }, { 2.0f, 0.0f }, { 0.0f, -1.0f } };
	const std::vector<TubeColumn> columns = make_tube_columns(axis, 4);
	CHECK(columns[0].x == -1.0f);
	float area = 0.0f;
	for (size_t i = 0; i < 4; i++) {
		const TubeColumn &next = columns[(i + 1) % 4];
		area += columns[i].x * next.z - columns[i].z * next.x;
	}
	CHECK(area > 0.0f); // As cosine and sine of an increasing angle.
}

TEST_CASE("colours run from base to tip, or as they were sampled") {
	PartColors colors;
	colors.base = glm::vec4(0.0f);
	colors.tip = glm::vec4(1.0f);
	CHECK(colors.at(0.25f, 1.0f) == glm::vec4(0.25f));
	colors.samples.assign(PartColors::ROWS * PartColors::COLUMNS, glm::vec4(0.0f));
	colors.samples[2] = glm::vec4(1.0f); // The edge at the base.
	CHECK(colors.at(0.0f, 1.0f) == glm::vec4(1.0f));
	CHECK(colors.at(0.0f, 0.75f) == glm::vec4(0.5f));
	CHECK(colors.at(1.0f, 1.0f) == glm::vec4(0.0f));
}
