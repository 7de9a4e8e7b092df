#include "mesh/plant_mesh.hpp"
#include "mesh_fixture.hpp"
#include "plant/base_shape.hpp"
#include "plant/species/tulip.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace undergrowth;

namespace {

bool all_indices_in_range(const BuiltMesh &mesh) {
	const int32_t vertices = static_cast<int32_t>(mesh.positions.size());
	return std::all_of(mesh.indices.begin(), mesh.indices.end(), [&](int32_t i) { return i >= 0 && i < vertices; });
}

bool all_normals_unit(const BuiltMesh &mesh) {
	return std::all_of(mesh.normals.begin(), mesh.normals.end(),
			[](const glm::vec3 &n) { return std::abs(glm::length(glm::dvec3(n)) - 1.0) < 1e-6; });
}

} // namespace

TEST_CASE("a mesh has the counted vertices and triangles, and indices in range") {
	const MeshCounts smooth = count_mesh(16, 8, Shading::smooth);
	CHECK(smooth.vertices == 9 * 17 + 2 * 16);
	CHECK(smooth.indices == 3 * (2 * 16 * 8 + 2 * 14));
	const MeshCounts flat = count_mesh(16, 8, Shading::flat);
	CHECK(flat.vertices == smooth.indices);
	CHECK(flat.indices == smooth.indices);

	for (const int lod : { 1, 2, 7, 16 }) {
		const Plant plant = make_species_plant(Tulip(), lod, 1.5f);
		CHECK(all_indices_in_range(build(plant)));
		CHECK(all_indices_in_range(build(plant, { Shading::flat })));
	}
}

TEST_CASE("ring k is at height k/lod and is the base shape times the width there") {
	const float height = 1.7f;
	const int lod = 12;
	const Plant plant = make_species_plant(Tulip(), lod, height);
	const BuiltMesh mesh = build(plant);
	for (int k = 0; k <= lod; k++) {
		for (int i = 0; i < mesh.points; i++) {
			const glm::vec3 p = mesh.positions[mesh.side(k, i)];
			CHECK(p.x == plant.section.points[i].x * plant.widths[k]);
			CHECK(p.z == plant.section.points[i].y * plant.widths[k]);
			CHECK(p.y == static_cast<float>(static_cast<double>(height) * k / lod));
		}
	}
	CHECK(mesh.positions[mesh.side(lod, 0)].y == height);
}

TEST_CASE("the last ring is at the height itself, for any number of segments") {
	for (const float height : { 0.1f, 0.7f, 1.1f, 3.3f, 1e-3f, 1e4f }) {
		for (int lod = MIN_LOD; lod <= MAX_LOD; lod += 5) {
			const BuiltMesh mesh = build(make_plant(circle_ring(4), std::vector<float>(lod + 1, 1.0f), height));
			CHECK(mesh.positions[mesh.side(lod, 0)].y == height);
		}
	}
}

TEST_CASE("the second bone's weight is height over plant height, and the weights sum to 1 exactly") {
	for (const Shading shading : { Shading::smooth, Shading::flat }) {
		const Plant plant = make_species_plant(Tulip(), 13, 1.37f);
		const BuiltMesh mesh = build(plant, { shading });
		for (size_t i = 0; i < mesh.positions.size(); i++) {
			const float *weights = &mesh.weights[4 * i];
			CHECK(weights[1] == mesh.positions[i].y / plant.height);
			CHECK(weights[0] + weights[1] == 1.0f);
			CHECK(weights[2] == 0.0f);
			CHECK(weights[3] == 0.0f);
			CHECK(mesh.bones[4 * i] == 0);
			CHECK(mesh.bones[4 * i + 1] == 1);
			CHECK(mesh.bones[4 * i + 2] == 0);
			CHECK(mesh.bones[4 * i + 3] == 0);
		}
	}
}

TEST_CASE("texture coordinates run around and up, and the seam repeats the first column at u = 1") {
	const BuiltMesh mesh = build(make_species_plant(Tulip(), 10, 1.5f));
	for (int k = 0; k <= mesh.lod; k++) {
		for (int i = 0; i <= mesh.points; i++) {
			const glm::vec2 uv = mesh.uvs[mesh.side(k, i)];
			CHECK(uv.x == static_cast<float>(i) / mesh.points);
			CHECK(uv.y == 1.0f - static_cast<float>(k) / mesh.lod);
		}
		CHECK(mesh.positions[mesh.side(k, mesh.points)] == mesh.positions[mesh.side(k, 0)]);
		CHECK(mesh.normals[mesh.side(k, mesh.points)] == mesh.normals[mesh.side(k, 0)]);
	}
}

TEST_CASE("vertices have the colour of their ring") {
	const Tulip tulip;
	const BuiltMesh mesh = build(make_species_plant(tulip, 8, 1.5f));
	for (int i = 0; i <= mesh.points; i++) {
		CHECK(mesh.colors[mesh.side(5, i)] == tulip.stem_color);
		CHECK(mesh.colors[mesh.side(6, i)] == tulip.flower_color);
	}
	CHECK(mesh.colors.back() == tulip.flower_color);
}

TEST_CASE("flat and smooth shading draw the same triangles") {
	MeshOptions options;
	options.seed = 3;
	for (const float deviation : { 0.0f, 0.7f }) {
		options.shape_deviation = deviation;
		options.color_deviation = deviation;
		const Plant plant = make_species_plant(Tulip(), 9, 1.5f);
		options.shading = Shading::smooth;
		const BuiltMesh smooth = build(plant, options);
		options.shading = Shading::flat;
		const BuiltMesh flat = build(plant, options);
		REQUIRE(smooth.indices.size() == flat.indices.size());
		for (size_t i = 0; i < flat.indices.size(); i++) {
			const int32_t vertex = smooth.indices[i];
			CHECK(flat.indices[i] == static_cast<int32_t>(i));
			CHECK(flat.positions[i] == smooth.positions[vertex]);
			CHECK(flat.colors[i] == smooth.colors[vertex]);
			CHECK(flat.uvs[i] == smooth.uvs[vertex]);
		}
	}
}

TEST_CASE("one segment, and widths of 0 anywhere, give finite unit normals") {
	const std::vector<glm::vec2> ring = circle_ring(8);
	for (const std::vector<float> &widths : { std::vector<float>{ 1.0f, 0.0f }, { 0.0f, 1.0f }, { 0.0f, 0.0f },
				 { 0.0f, 1.0f, 0.0f }, { 1.0f, 0.0f, 1.0f }, { 0.0f, 0.0f, 0.0f, 1.0f }, { 1e-30f, 1.0f, 1e30f } }) {
		for (const Shading shading : { Shading::smooth, Shading::flat }) {
			for (const float deviation : { 0.0f, 1.0f }) {
				MeshOptions options;
				options.shading = shading;
				options.shape_deviation = deviation;
				CHECK(all_normals_unit(build(make_plant(ring, widths), options)));
			}
		}
	}
}

TEST_CASE("heights at the limits of floats give finite unit normals") {
	for (const float height : { 1e-45f, 1e-38f, 1e38f }) {
		for (const Shading shading : { Shading::smooth, Shading::flat }) {
			for (const float deviation : { 0.0f, 1.0f }) {
				MeshOptions options;
				options.shading = shading;
				options.shape_deviation = deviation;
				CHECK(all_normals_unit(build(make_plant(circle_ring(8), { 1.0f, 1.0f, 0.5f, 0.0f }, height), options)));
			}
		}
	}
}

TEST_CASE("a plant without any width still faces outward") {
	const Plant plant = make_plant(circle_ring(8), { 0.0f, 0.0f, 0.0f });
	const BuiltMesh mesh = build(plant);
	for (int i = 0; i < mesh.points; i++) {
		const glm::vec2 outward = plant.section.normals[i];
		CHECK(mesh.normals[mesh.side(1, i)] == glm::vec3(outward.x, 0.0f, outward.y));
	}
}
