#pragma once

#include "species/sampled_plant.hpp"

namespace undergrowth {

/// Returns the arrays of a plant of parts with packed vertices (mesh/packed_vertex.hpp) of 44 bytes in place of 112,
/// for materials that read them. Positions are rounded to 1/65535 of the mesh's size. Only positions, colours and two
/// custom attributes remain: fields bend plants in their shader. Plants with branched branches have two more.
MeshArrays pack_arrays(const MeshArrays &from);

} // namespace undergrowth
