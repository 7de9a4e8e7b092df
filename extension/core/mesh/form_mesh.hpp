#pragma once

#include "mesh/form_bones.hpp"
#include "mesh/form_plan.hpp"
#include "mesh/plant_mesh.hpp"
#include "mesh/vertex_format.hpp"

namespace undergrowth {

/// Builds the mesh of a plan into buffers of plan.counts: first parts in order of growth, then bodies. Open sheets have
/// one side only; draw them without culling. All triangles are clockwise from the side of their normals.
///
/// `height` (m): the plant is stretched along y to it, as in fields; the form's own height means no stretch. Of the
/// options only the colour deviation has an effect. Vertices are bound to `bones` besides root and tip.
///
/// Guarantees: indices in range, normals and tangents of length 1 within 1e-6, weights that sum to 1 exactly, the same
/// bytes for the same arguments.
void build_form_mesh(const PlantForm &form, const FormMeasure &measure, const FormPlan &plan, const FormBones &bones,
		const MeshOptions &options, float height, const FormBuffers &buffers);

} // namespace undergrowth
