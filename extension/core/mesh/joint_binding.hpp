#pragma once

#include <cstdint>

namespace undergrowth {

/// Binds the vertices of a plant whose stem has joints: what was bound to root and tip goes over to the bones of the
/// stem (stem/stem_bones.hpp). Bones: root 0 and tip 1 as before, the stem's from 2 on, those of parts `joints` later
/// than they were. Four a vertex; weights sum to 1. Where a part's vertex would need more, the four heaviest stay.
/// `places`: where on the stem each vertex is attached; null: by the weight of the tip.
void bind_to_joints(int joints, int vertices, const float *places, int32_t *bones, float *weights);

} // namespace undergrowth
