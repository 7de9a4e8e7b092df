#pragma once

#include <cstdint>

namespace undergrowth {

/// Binds the vertices of a plant with a jointed stem: weights of root and tip move to the bones of the stem
/// (stem/stem_bones.hpp). Bones: root 0 and tip 1 as before, those of the stem from 2 on, those of parts `joints` later
/// than before. Each vertex has four; weights sum to 1. If a vertex of a part needs more, the four heaviest remain.
/// `places`: position of each vertex's attachment on the stem; null: by the weight of the tip.
void bind_to_joints(int joints, int vertices, const float *places, int32_t *bones, float *weights);

} // namespace undergrowth
