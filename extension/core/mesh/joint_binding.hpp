#pragma once

#include <cstdint>

namespace undergrowth {

/// Binds the vertices of a plant with stem joints: weights of root and tip move to the bones of the stem
/// (stem/stem_bones.hpp). Bone order: root 0, tip 1, the stem's from 2 on, then the parts' bones, shifted by `joints`.
/// Each vertex has four weights that sum to 1; if it needs more, the four largest remain. `places`: positions on the
/// stem where the vertices are attached; null: from the weights of the tip.
void bind_to_joints(int joints, int vertices, const float *places, int32_t *bones, float *weights);

} // namespace undergrowth
