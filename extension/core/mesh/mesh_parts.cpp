#include "mesh/mesh_parts.hpp"

namespace undergrowth {

void write_bones(int vertices, int32_t *bones) {
	for (int i = 0; i < vertices; i++) {
		bones[4 * i] = 0;
		bones[4 * i + 1] = 1;
		bones[4 * i + 2] = 0;
		bones[4 * i + 3] = 0;
	}
}

void write_weights(int vertices, float w, float *weights) {
	for (int i = 0; i < vertices; i++) {
		weights[4 * i] = 1.0f - w;
		weights[4 * i + 1] = w;
		weights[4 * i + 2] = 0.0f;
		weights[4 * i + 3] = 0.0f;
	}
}

} // namespace undergrowth
