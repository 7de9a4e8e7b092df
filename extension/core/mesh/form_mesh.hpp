#pragma once

#include "mesh/form_bones.hpp"
#include "mesh/form_plan.hpp"
#include "mesh/plant_mesh.hpp"
#include "mesh/vertex_format.hpp"

namespace undergrowth {

/// Builds what a plan draws of a form into buffers of plan.counts. Order: parts as they grew, then bodies. Open sheets
/// have one side only and are to be drawn without culling; all triangles are clockwise from the side that their normals
/// point to. `height`: m, to which the grown plant is stretched along y, as fields stretch plants; the form's own
/// height leaves it as it grew. Of the options only the colour deviation counts. Guarantees: indices in range, normals
/// and tangents of length 1 within 1e-6, weights that sum to 1 exactly, the same bytes for the same arguments.
/// Vertices are bound to `bones` beside root and tip.
void build_form_mesh(const PlantForm &form, const FormMeasure &measure, const FormPlan &plan, const FormBones &bones,
		const MeshOptions &options, float height, const FormBuffers &buffers);

} // namespace undergrowth
