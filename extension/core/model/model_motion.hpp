#pragma once

#include "mesh/form_bones.hpp"
#include "model/model_frame.hpp"
#include "model/model_parts.hpp"
#include "stem/stem_beam.hpp"

#include <glm/vec4.hpp>

namespace undergrowth {

/// The motion of the vertices of a model, through all its surfaces: the attributes of mesh/vertex_format.hpp.
struct ModelVertices {
	std::vector<glm::vec3> places; ///< m, in the plant's axes.
	std::vector<glm::vec4> custom0, custom1, custom2;
	std::vector<float> stem_places;
	std::vector<int> swingers; ///< For ModelMotion::bones; -1: none.
	std::vector<int> leaves; ///< Number of the leaf or blade; -1: part of a stem, twig or head.
	std::vector<float> bone_weights; ///< Own weights on a skeleton: less than CUSTOM0.y if parts share bones.
};

/// What was found in a model.
struct ModelMotion {
	ModelVertices vertices;
	FormBones bones;
	StemBeam beam; ///< Its length is the height; thickness and loads are measured.
	int roots = 0; ///< Islands at the ground.
	int leaves = 0; ///< Islands that swing by themselves.
	int heads = 0;
	int twigs = 0;
};

/// True if a coarse level with this share of the leaves draws the leaf. Kept leaves are spread evenly.
bool is_leaf_kept(int leaf, float share);

/// Finds the motion of surfaces without a fault.
ModelMotion find_model_motion(
		const std::vector<ModelSurface> &surfaces, const ModelFrame &frame, const ModelColors &colors = {});

} // namespace undergrowth
