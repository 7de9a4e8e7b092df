#pragma once

#include "mesh/form_mesh.hpp"

#include <string>
#include <vector>

/// A mesh of a form, in arrays that are exactly as long as its plan says.
class DrawnForm {
public:
	DrawnForm(const undergrowth::PlantForm &form, const undergrowth::FormMeasure &measure,
			const undergrowth::FormPlan &plan, const undergrowth::FormBones &bones,
			const undergrowth::MeshOptions &options, float height);

	/// What the mesh breaks of what mesh/form_mesh.hpp and mesh/vertex_format.hpp promise, or nothing.
	std::string problem() const;

private:
	std::vector<glm::vec3> positions, normals;
	std::vector<glm::vec4> tangents, colors, custom0, custom1, custom2;
	std::vector<glm::vec2> uvs;
	std::vector<int32_t> bone_indices, indices;
	std::vector<float> weights, stem_places;
	int bone_count;

	std::string problem_of(size_t vertex) const;
	std::string problem_of_weights(size_t vertex) const;
};
