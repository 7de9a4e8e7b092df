#pragma once

#include "species/sampled_plant.hpp"

namespace undergrowth {

/// Returns the arrays of a field's mesh in a smaller format, for materials that read no packed vertices: graphics cards
/// read all attributes again for each vertex of each plant. A vertex has 48 bytes in place of 112. Positions are
/// rounded to 1/65535 of the mesh's size, UVs to 1/65535, and custom attributes to half floats. CUSTOM3 has two
/// numbers, and the bones are left out, because fields bend plants in their shader. `reads_half_floats`: false for the
/// Compatibility renderer, which reads two of four half floats only; a vertex has 76 bytes there. Meshes of lathes lose
/// their bones only.
MeshArrays compact_arrays(const MeshArrays &from, bool reads_half_floats);

} // namespace undergrowth
