#pragma once

#include "mesh/form_bones.hpp"
#include "mesh/form_plan.hpp"
#include "mesh/plant_mesh.hpp"
#include "mesh/vertex_format.hpp"

namespace undergrowth {

/// Builds the mesh that a plan draws of a form, into buffers of plan.counts. Order: parts as they grew, then bodies.
/// Open sheets have one side only and must be drawn without culling. All triangles are clockwise from the side of their
/// normals. `height` (m): the plant is stretched along y to this height, as fields stretch plants; the form's own
/// height leaves it unchanged. Of the options only the colour deviation has an effect. Guarantees: indices in range,
/// normals and tangents of length 1 within 1e-6, weights that sum to 1 exactly, the same bytes for the same arguments.
/// Vertices are bound to `bones` besides root and tip.
void build_form_mesh(const PlantForm &form, const FormMeasure &measure, const FormPlan &plan, const FormBones &bones,
		const MeshOptions &options, float height, const FormBuffers &buffers);

} // namespace undergrowth
