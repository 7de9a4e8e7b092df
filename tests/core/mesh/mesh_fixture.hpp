#pragma once

#include "mesh/plant_mesh.hpp"

#include <cstring>
#include <vector>

/// A mesh in its own vectors, for tests.
struct BuiltMesh {
	int points = 0;
	int lod = 0;
	std::vector<glm::vec3> positions;
	std::vector<glm::vec3> normals;
	std::vector<glm::vec4> colors;
	std::vector<glm::vec2> uvs;
	std::vector<int32_t> bones;
	std::vector<float> weights;
	std::vector<int32_t> indices;

	/// Index of point i of ring k; smooth shading only.
	int side(int k, int i) const { return k * (points + 1) + i; }
	/// Corner 0 to 2 of a triangle.
	glm::vec3 corner(int triangle, int which) const { return positions[indices[3 * triangle + which]]; }
	int triangles() const { return static_cast<int>(indices.size()) / 3; }
	int side_triangles() const { return 2 * points * lod; }
	/// Vector on the outward side of a triangle, with twice its area as length.
	glm::dvec3 face(int triangle) const;
};

/// The inputs of a mesh.
struct Plant {
	undergrowth::CrossSection section;
	std::vector<float> widths;
	std::vector<glm::vec4> colors;
	float height = 1.5f;

	int lod() const { return static_cast<int>(widths.size()) - 1; }
	undergrowth::PlantSample sample() const { return { &section, widths.data(), colors.data(), height, lod() }; }
};

inline glm::dvec3 BuiltMesh::face(int triangle) const {
	const glm::dvec3 a = corner(triangle, 0);
	const glm::dvec3 first = glm::dvec3(corner(triangle, 1)) - a;
	const glm::dvec3 second = glm::dvec3(corner(triangle, 2)) - a;
	// Clockwise from outside: the reverse of the mathematical order.
	return { second.y * first.z - second.z * first.y, second.z * first.x - second.x * first.z,
		second.x * first.y - second.y * first.x };
}

/// A plant of one colour with the given widths.
inline Plant make_plant(const std::vector<glm::vec2> &ring, const std::vector<float> &widths, float height = 1.5f) {
	return { undergrowth::make_cross_section(ring), widths,
		std::vector<glm::vec4>(widths.size(), glm::vec4(0.2f, 0.6f, 0.3f, 1.0f)), height };
}

template <class Species> Plant make_species_plant(const Species &species, int lod, float height) {
	Plant plant = make_plant(species.base_shape(lod), std::vector<float>(lod + 1), height);
	for (int k = 0; k <= lod; k++) {
		const float offset = static_cast<float>(k) / static_cast<float>(lod);
		plant.widths[k] = species.width(offset);
		plant.colors[k] = species.color(offset);
	}
	return plant;
}

inline BuiltMesh build(const Plant &plant, const undergrowth::MeshOptions &options = {}) {
	BuiltMesh mesh;
	mesh.points = static_cast<int>(plant.section.points.size());
	mesh.lod = plant.lod();
	const undergrowth::MeshCounts counts = undergrowth::count_mesh(mesh.points, mesh.lod, options.shading);
	mesh.positions.resize(counts.vertices);
	mesh.normals.resize(counts.vertices);
	mesh.colors.resize(counts.vertices);
	mesh.uvs.resize(counts.vertices);
	mesh.bones.resize(4 * counts.vertices);
	mesh.weights.resize(4 * counts.vertices);
	mesh.indices.resize(counts.indices);
	undergrowth::build_mesh(plant.sample(), options,
			{ mesh.positions.data(), mesh.normals.data(), mesh.colors.data(), mesh.uvs.data(), mesh.bones.data(),
					mesh.weights.data(), mesh.indices.data() });
	return mesh;
}

template <class T> bool same_bytes(const std::vector<T> &a, const std::vector<T> &b) {
	return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

inline bool same_bytes(const BuiltMesh &a, const BuiltMesh &b) {
	return same_bytes(a.positions, b.positions) && same_bytes(a.normals, b.normals) && same_bytes(a.colors, b.colors) &&
			same_bytes(a.uvs, b.uvs) && same_bytes(a.bones, b.bones) && same_bytes(a.weights, b.weights) &&
			same_bytes(a.indices, b.indices);
}

/// A five-pointed star: concave at every second point.
inline std::vector<glm::vec2> star_ring() {
	return { { -1.0f, 0.0f }, { -0.32f, 0.24f }, { -0.31f, 0.95f }, { 0.12f, 0.38f }, { 0.81f, 0.59f }, { 0.4f, 0.0f },
		{ 0.81f, -0.59f }, { 0.12f, -0.38f }, { -0.31f, -0.95f }, { -0.32f, -0.24f } };
}

/// The area that a ring encloses, positive if it runs counter-clockwise from above (the z axis points down the page).
inline double ring_area(const std::vector<glm::vec2> &ring) {
	double twice = 0.0;
	for (size_t i = 0; i < ring.size(); i++) {
		const glm::dvec2 a = ring[i];
		const glm::dvec2 b = ring[(i + 1) % ring.size()];
		twice += a.y * b.x - a.x * b.y;
	}
	return 0.5 * twice;
}
