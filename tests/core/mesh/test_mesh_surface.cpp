#include "mesh_fixture.hpp"
#include "plant/base_shape.hpp"
#include "plant/species/bellflower.hpp"
#include "plant/species/cattail.hpp"
#include "plant/species/grass.hpp"
#include "plant/species/reed.hpp"
#include "plant/species/tulip.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <map>
#include <utility>

using namespace undergrowth;

namespace {

using Place = std::array<float, 3>;

/// Counts the uses of each directed edge after vertices at one position are merged. Triangles that lose a side are
/// dropped.
std::map<std::pair<Place, Place>, int> welded_edges(const BuiltMesh &mesh) {
	std::map<std::pair<Place, Place>, int> edges;
	for (int t = 0; t < mesh.triangles(); t++) {
		Place corners[3];
		for (int c = 0; c < 3; c++) {
			// Adding 0 changes -0 to 0.
			const glm::vec3 p = mesh.corner(t, c) + 0.0f;
			corners[c] = { p.x, p.y, p.z };
		}
		if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
			continue;
		}
		for (int c = 0; c < 3; c++) {
			edges[{ corners[c], corners[(c + 1) % 3] }]++;
		}
	}
	return edges;
}

bool is_watertight(const BuiltMesh &mesh) {
	const auto edges = welded_edges(mesh);
	for (const auto &[edge, uses] : edges) {
		const auto back = edges.find({ edge.second, edge.first });
		if (uses != 1 || back == edges.end() || back->second != 1) {
			return false;
		}
	}
	return !edges.empty();
}

/// The enclosed volume; positive only if triangles are clockwise from outside.
double volume(const BuiltMesh &mesh) {
	double sum = 0.0;
	for (int t = 0; t < mesh.triangles(); t++) {
		sum += glm::dot(glm::dvec3(mesh.corner(t, 0)), mesh.face(t)) / 6.0;
	}
	return sum;
}

/// The volume between rings of one shape: each band is a frustum with the volume h·A·(a² + a·b + b²)/3.
double frustum_volume(const Plant &plant) {
	double sum = 0.0;
	for (int k = 0; k < plant.lod(); k++) {
		const double a = plant.widths[k];
		const double b = plant.widths[k + 1];
		sum += (a * a + a * b + b * b) / 3.0;
	}
	return sum * plant.height / plant.lod() * ring_area(plant.section.points);
}

std::vector<Plant> all_species(int lod) {
	return { make_species_plant(Grass(), lod, 0.6f), make_species_plant(Reed(), lod, 2.0f),
		make_species_plant(Cattail(), lod, 1.8f), make_species_plant(Tulip(), lod, 1.5f),
		make_species_plant(Bellflower(), lod, 0.7f), make_plant(star_ring(), std::vector<float>(lod + 1, 0.1f)) };
}

MeshOptions options_of(Shading shading, float deviation) {
	MeshOptions options;
	options.shading = shading;
	options.shape_deviation = deviation;
	options.seed = 11;
	return options;
}

} // namespace

TEST_CASE("welded meshes are closed: every edge is used once in each direction") {
	for (const int lod : { 1, 2, 8, 17 }) {
		for (const Plant &plant : all_species(lod)) {
			for (const Shading shading : { Shading::smooth, Shading::flat }) {
				CHECK(is_watertight(build(plant, options_of(shading, 0.0f))));
				CHECK(is_watertight(build(plant, options_of(shading, 0.8f))));
			}
		}
	}
}

TEST_CASE("triangles are clockwise from outside and enclose the volume of the frustums") {
	for (const int lod : { 1, 8, 20 }) {
		for (const Plant &plant : all_species(lod)) {
			CHECK(volume(build(plant)) == doctest::Approx(frustum_volume(plant)).epsilon(1e-5));
		}
	}
}

TEST_CASE("a cylinder's side triangles face away from its axis") {
	const BuiltMesh mesh = build(make_plant(circle_ring(12), { 1.0f, 1.0f, 1.0f }));
	for (int t = 0; t < mesh.side_triangles(); t++) {
		const glm::dvec3 middle = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0f;
		CHECK(middle.x * mesh.face(t).x + middle.z * mesh.face(t).z > 0.0);
	}
}

TEST_CASE("the ends face down and up and have the area of their ring") {
	const float widths[] = { 0.5f, 0.8f };
	const Plant plant = make_plant(star_ring(), { widths[0], widths[1] });
	const BuiltMesh mesh = build(plant);
	const int end_triangles = mesh.points - 2;
	double areas[2] = { 0.0, 0.0 };
	for (int t = mesh.side_triangles(); t < mesh.triangles(); t++) {
		const int end = (t - mesh.side_triangles()) / end_triangles;
		const double up = mesh.face(t).y;
		CHECK(mesh.normals[mesh.indices[3 * t]] == glm::vec3(0.0f, end == 0 ? -1.0f : 1.0f, 0.0f));
		CHECK((end == 0 ? up < 0.0 : up > 0.0));
		areas[end] += 0.5 * std::abs(up);
	}
	for (int end = 0; end < 2; end++) {
		CHECK(areas[end] == doctest::Approx(ring_area(star_ring()) * widths[end] * widths[end]).epsilon(1e-5));
	}
}

TEST_CASE("a cone's smooth normals are those of the cone") {
	const float height = 2.0f;
	const BuiltMesh mesh = build(make_plant(circle_ring(16), { 1.0f, 0.75f, 0.5f, 0.25f, 0.0f }, height));
	const double slope = 0.3 / height;
	const double length = std::sqrt(1.0 + slope * slope);
	for (int k = 0; k <= mesh.lod; k++) {
		for (int i = 0; i < mesh.points; i++) {
			const glm::dvec3 foot = glm::dvec3(mesh.positions[mesh.side(0, i)]) / 0.3;
			const glm::dvec3 exact = glm::dvec3(foot.x, slope, foot.z) / length;
			CHECK(glm::length(glm::dvec3(mesh.normals[mesh.side(k, i)]) - exact) < 1e-6);
		}
	}
}

TEST_CASE("a bulging plant's smooth normals are those of its curve, whether its rings wander or not") {
	// Radius r(y) = 0.3·(1 + y - y²) at y = 0 to 1: differences of the rings above and below are exact.
	constexpr int RINGS = 16;
	std::vector<float> widths;
	for (int k = 0; k <= RINGS; k++) {
		const float y = static_cast<float>(k) / RINGS;
		widths.push_back(1.0f + y - y * y);
	}
	for (const float deviation : { 0.0f, 1e-6f }) {
		const BuiltMesh mesh = build(make_plant(circle_ring(24), widths, 1.0f), options_of(Shading::smooth, deviation));
		for (int k = 0; k <= RINGS; k++) {
			const bool is_end = k == 0 || k == RINGS;
			// At the ends: the slope of the last band.
			const double y = is_end ? (k == 0 ? 0.5 / RINGS : 1.0 - 0.5 / RINGS) : static_cast<double>(k) / RINGS;
			const double slope = 0.3 * (1.0 - 2.0 * y);
			for (int i = 0; i < mesh.points; i++) {
				const glm::dvec3 place = mesh.positions[mesh.side(k, i)];
				const double around = std::hypot(place.x, place.z);
				const glm::dvec3 exact = glm::normalize(glm::dvec3(place.x / around, -slope, place.z / around));
				CHECK(glm::length(glm::dvec3(mesh.normals[mesh.side(k, i)]) - exact) < 1e-5);
			}
		}
	}
}

TEST_CASE("flat normals are those of the triangles") {
	for (const float deviation : { 0.0f, 0.8f }) {
		const BuiltMesh mesh = build(make_species_plant(Tulip(), 10, 1.5f), options_of(Shading::flat, deviation));
		for (int t = 0; t < mesh.triangles(); t++) {
			const glm::dvec3 exact = glm::normalize(mesh.face(t));
			for (int c = 0; c < 3; c++) {
				CHECK(glm::length(glm::dvec3(mesh.normals[3 * t + c]) - exact) < 1e-5);
			}
		}
	}
}

TEST_CASE("normals have length 1 and lie on the outer side of their triangles") {
	for (const int lod : { 8, 24 }) {
		for (const Plant &plant : all_species(lod)) {
			for (const float deviation : { 0.0f, 0.5f }) {
				const BuiltMesh mesh = build(plant, options_of(Shading::smooth, deviation));
				for (int t = 0; t < mesh.triangles(); t++) {
					for (int c = 0; c < 3; c++) {
						const glm::dvec3 normal = mesh.normals[mesh.indices[3 * t + c]];
						CHECK(glm::length(normal) == doctest::Approx(1.0).epsilon(1e-6));
						CHECK(glm::dot(normal, mesh.face(t)) >= 0.0);
					}
				}
			}
		}
	}
}
