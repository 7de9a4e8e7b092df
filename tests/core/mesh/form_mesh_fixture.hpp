#pragma once

#include "mesh/form_mesh.hpp"
#include "motion/part_bend.hpp"

#include "../golden.hpp"

#include <vector>

/// The mesh of a form in its own vectors.
struct BuiltForm {
	std::vector<glm::vec3> positions;
	std::vector<glm::vec3> normals;
	std::vector<glm::vec4> tangents;
	std::vector<glm::vec4> colors;
	std::vector<glm::vec2> uvs;
	std::vector<glm::vec4> custom0;
	std::vector<glm::vec4> custom1;
	std::vector<glm::vec4> custom2;
	std::vector<int32_t> bones;
	std::vector<float> weights;
	std::vector<int32_t> indices;
	std::vector<float> stem_places;
	std::vector<undergrowth::InnerVertex> inner[undergrowth::MAX_INNER_SWINGS];

	void resize(const undergrowth::MeshCounts &counts) {
		const size_t n = static_cast<size_t>(counts.vertices);
		positions.resize(n);
		normals.resize(n);
		tangents.resize(n);
		colors.resize(n);
		uvs.resize(n);
		custom0.resize(n);
		custom1.resize(n);
		custom2.resize(n);
		bones.resize(4 * n);
		weights.resize(4 * n);
		stem_places.resize(n);
		for (auto &order : inner) {
			order.resize(n);
		}
		indices.resize(static_cast<size_t>(counts.indices), -1);
	}
	undergrowth::FormBuffers buffers() {
		return { positions.data(), normals.data(), tangents.data(), colors.data(), uvs.data(), custom0.data(),
			custom1.data(), custom2.data(), bones.data(), weights.data(), indices.data(), stem_places.data(),
			{ inner[0].data(), inner[1].data() } };
	}
	int size() const { return static_cast<int>(positions.size()); }
	uint64_t hash() const {
		return GoldenHash()
				.add(positions)
				.add(normals)
				.add(tangents)
				.add(colors)
				.add(uvs)
				.add(custom0)
				.add(custom1)
				.add(custom2)
				.add(bones)
				.add(weights)
				.add(indices)
				.add(stem_places)
				.value();
	}
};

inline BuiltForm build(const undergrowth::PlantForm &form, const undergrowth::FormPlan &plan, float height = 0.0f,
		const undergrowth::MeshOptions &options = {}, const undergrowth::FormBones &bones = {}) {
	BuiltForm mesh;
	mesh.resize(plan.counts);
	undergrowth::build_form_mesh(form, undergrowth::measure_form(form), plan, bones, options,
			height > 0.0f ? height : form.height, mesh.buffers());
	return mesh;
}

/// Position of a vertex on the skeleton of the mesh (m).
glm::vec3 skinned(
		const BuiltForm &mesh, const undergrowth::FormBones &bones, size_t vertex, const undergrowth::StemMotion &stem);

/// View of a mesh from a distant camera.
struct Sight {
	double area = 0.0; ///< m² of the silhouette.
	glm::dvec3 light = glm::dvec3(0.0); ///< Mean colour in linear light, with the same light on every triangle.
};

/// Level view from `side` of eight, on `pixels` by `pixels` over `box` metres from the ground up.
Sight look_at(const BuiltForm &mesh, int side, double box, int pixels = 500);

/// Difference of two colours in linear light: CIE 1976 ΔE in L*a*b* under D65.
double color_distance(const glm::dvec3 &a, const glm::dvec3 &b);
