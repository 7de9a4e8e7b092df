#include "mesh/deviation.hpp"
#include "mesh_fixture.hpp"
#include "plant/base_shape.hpp"
#include "plant/species/tulip.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include <algorithm>

using namespace undergrowth;

namespace {

MeshOptions deviating(float shape, float color, uint64_t seed) {
	return { Shading::smooth, shape, color, seed };
}

} // namespace

TEST_CASE("a deviation of 0 gives the regular plant to the bit, for any seed") {
	const Plant plant = make_species_plant(Tulip(), 12, 1.5f);
	CHECK(same_bytes(build(plant), build(plant, deviating(0.0f, 0.0f, 99))));
}

TEST_CASE("equal seeds give equal bytes and other seeds another plant") {
	const Plant plant = make_species_plant(Tulip(), 12, 1.5f);
	const BuiltMesh first = build(plant, deviating(0.4f, 0.4f, 5));
	CHECK(same_bytes(first, build(plant, deviating(0.4f, 0.4f, 5))));
	const BuiltMesh other = build(plant, deviating(0.4f, 0.4f, 6));
	CHECK_FALSE(same_bytes(first.positions, other.positions));
	CHECK_FALSE(same_bytes(first.colors, other.colors));
	CHECK(same_bytes(first.indices, other.indices));
}

TEST_CASE("shape and colour deviate on their own") {
	const Plant plant = make_species_plant(Tulip(), 12, 1.5f);
	const BuiltMesh regular = build(plant);
	const BuiltMesh shaped = build(plant, deviating(0.4f, 0.0f, 5));
	CHECK_FALSE(same_bytes(shaped.positions, regular.positions));
	CHECK(same_bytes(shaped.colors, regular.colors));
	const BuiltMesh colored = build(plant, deviating(0.0f, 0.4f, 5));
	CHECK(same_bytes(colored.positions, regular.positions));
	CHECK(same_bytes(colored.normals, regular.normals));
	CHECK_FALSE(same_bytes(colored.colors, regular.colors));
}

TEST_CASE("all levels of detail of one seed show the same plant") {
	// A constant width makes the rings that two levels share equally regular.
	const MeshOptions options = deviating(0.6f, 0.6f, 8);
	const BuiltMesh coarse = build(make_plant(circle_ring(16), std::vector<float>(9, 0.2f)), options);
	const BuiltMesh fine = build(make_plant(circle_ring(16), std::vector<float>(33, 0.2f)), options);
	for (int k = 0; k <= coarse.lod; k++) {
		for (int i = 0; i < coarse.points; i++) {
			CHECK(coarse.positions[coarse.side(k, i)] == fine.positions[fine.side(4 * k, i)]);
			CHECK(coarse.colors[coarse.side(k, i)] == fine.colors[fine.side(4 * k, i)]);
		}
	}
	// Also points at the same angle of a coarser ring. The tolerance covers the rounding of its own angles.
	const BuiltMesh square = build(make_plant(circle_ring(4), std::vector<float>(9, 0.2f)), options);
	for (int k = 0; k <= square.lod; k++) {
		for (int i = 0; i < 4; i++) {
			const glm::vec3 between = square.positions[square.side(k, i)] - coarse.positions[coarse.side(k, 4 * i)];
			CHECK(glm::length(between) < 1e-6f);
		}
	}
}

TEST_CASE("a deviating plant is on its root, preserves its height and closes its seam") {
	const float height = 1.5f;
	const Plant plant = make_plant(circle_ring(12), std::vector<float>(17, 0.2f), height);
	const BuiltMesh mesh = build(plant, deviating(1.0f, 1.0f, 21));
	CHECK(mesh.positions[mesh.side(mesh.lod, 0)].y == height);
	for (int i = 0; i < mesh.points; i++) {
		const glm::vec3 p = mesh.positions[mesh.side(0, i)];
		const glm::vec2 regular = plant.section.points[i];
		// Still on the ray from the root through the regular point.
		CHECK(p.x * regular.y - p.z * regular.x == doctest::Approx(0.0).epsilon(1e-7));
		CHECK(p.x * regular.x + p.z * regular.y > 0.0f);
	}
	for (int k = 0; k <= mesh.lod; k++) {
		const int first = mesh.side(k, 0);
		const int last = mesh.side(k, mesh.points);
		CHECK(mesh.positions[first] == mesh.positions[last]);
		CHECK(mesh.normals[first] == mesh.normals[last]);
		CHECK(mesh.colors[first] == mesh.colors[last]);
	}
}

TEST_CASE("with full deviations radii stay above 0 and colours within 0 and 1") {
	for (uint64_t seed = 0; seed < 200; seed++) {
		const Deviation deviation(1.0f, 1.0f, seed);
		for (const float offset : { 0.0f, 0.3f, 0.5f, 0.99f, 1.0f }) {
			const Deviation::Ring ring = deviation.at(offset);
			for (const glm::vec2 point : circle_ring(16)) {
				const Bearing bearing = make_bearing(point);
				CHECK(ring.stretch(bearing) > 0.3f);
				const glm::vec4 color = ring.tint({ 1.0f, 0.0f, 0.95f, 0.5f }, bearing);
				CHECK((color.x >= 0.0f && color.x <= 1.0f));
				CHECK((color.z >= 0.0f && color.z <= 1.0f));
				CHECK(color.y == 0.0f);
				CHECK(color.w == 0.5f);
			}
		}
	}
}

TEST_CASE("deviations are smooth along the plant") {
	const Deviation deviation(1.0f, 1.0f, 4);
	constexpr int STEPS = 1000;
	for (int i = 1; i <= STEPS; i++) {
		const Deviation::Ring a = deviation.at(static_cast<float>(i - 1) / STEPS);
		const Deviation::Ring b = deviation.at(static_cast<float>(i) / STEPS);
		CHECK(glm::length(a.center - b.center) < 2e-3f);
		CHECK(std::abs(a.scale - b.scale) < 5e-3f);
		CHECK(std::abs(a.brightness - b.brightness) < 5e-3f);
	}
}

TEST_CASE("a point on the axis has no bearing and stays there") {
	const Bearing bearing = make_bearing({ 0.0f, 0.0f });
	CHECK(bearing.once == glm::vec2(0.0f));
	CHECK(bearing.thrice == glm::vec2(0.0f));
}
