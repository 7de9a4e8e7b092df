#pragma once

namespace undergrowth {

/// Location of a chunk's poses for the shader: plant `slot` has texel first + slot of a layer.
struct PoseTexels {
	int layer = -1;
	int first = 0;
};

} // namespace undergrowth
