#include "mesh/mesh_parts.hpp"

#include <glm/geometric.hpp>

#include <algorithm>

namespace undergrowth {

namespace {

void write_sides(const PlantSample &sample, const RingPlacer &placer, const MeshBuffers &out) {
	const int n = placer.points();
	for (int k = 0; k <= sample.lod; k++) {
		const int first = k * (n + 1);
		glm::vec3 *positions = out.positions + first;
		placer.place(k, positions);
		positions[n] = positions[0];
		glm::vec4 *colors = out.colors + first;
		placer.paint(k, colors);
		colors[n] = colors[0];

		const float v = 1.0f - static_cast<float>(k) / static_cast<float>(sample.lod);
		glm::vec2 *uvs = out.uvs + first;
		for (int i = 0; i <= n; i++) {
			uvs[i] = { static_cast<float>(i) / static_cast<float>(n), v };
		}
		write_weights(n + 1, positions[0].y / sample.height, out.weights + 4 * first);
	}
}

/// For regular rings: the surface moves outward only with the width, by `reach` per unit of width.
void write_regular_normals(const PlantSample &sample, const RingPlacer &placer, glm::vec3 *out) {
	const int n = placer.points();
	const glm::vec2 *outward = sample.cross_section->normals.data();
	const float *reach = sample.cross_section->reach.data();
	for (int k = 0; k <= sample.lod; k++, out += n + 1) {
		const float slope = placer.width_slope(k);
		for (int i = 0; i < n; i++) {
			out[i] = leaning_normal(outward[i], slope * reach[i]);
		}
		out[n] = out[0];
	}
}

/// For irregular rings: measures the outward motion of the surface between the rings below and above.
void write_deviating_normals(const RingPlacer &placer, const glm::vec3 *positions, glm::vec3 *out) {
	const int n = placer.points();
	glm::vec2 outward[MAX_RING_POINTS];
	for (int k = 0; k <= placer.lod(); k++) {
		placer.level_normals(k, outward);
		const int lower = std::max(k - 1, 0);
		const int upper = std::min(k + 1, placer.lod());
		const float rise = placer.rise_between(lower, upper);
		const glm::vec3 *below = positions + lower * (n + 1);
		const glm::vec3 *above = positions + upper * (n + 1);
		for (int i = 0; i < n; i++) {
			const glm::vec2 way = { above[i].x - below[i].x, above[i].z - below[i].z };
			out[i] = leaning_normal(outward[i], glm::dot(outward[i], way) / rise);
		}
		out[n] = out[0];
		out += n + 1;
	}
}

/// Repeats ring `level` from `first` on, with normals straight up or down.
void write_end(const PlantSample &sample, int n, int level, int first, float facing, const MeshBuffers &out) {
	const int ring = level * (n + 1);
	std::copy_n(out.positions + ring, n, out.positions + first);
	std::copy_n(out.colors + ring, n, out.colors + first);
	std::copy_n(out.uvs + ring, n, out.uvs + first);
	std::fill_n(out.normals + first, n, glm::vec3(0.0f, facing, 0.0f));
	write_weights(n, out.positions[ring].y / sample.height, out.weights + 4 * first);
}

int32_t *write_side_indices(int n, int lod, int32_t *indices) {
	int32_t *out = indices;
	for (int32_t i = 0; i < n; i++, out += 6) {
		const int32_t above = i + n + 1;
		out[0] = i;
		out[1] = above;
		out[2] = i + 1;
		out[3] = above;
		out[4] = above + 1;
		out[5] = i + 1;
	}
	// Every further band is the first one, shifted.
	const int rest = 6 * n * (lod - 1);
	for (int i = 0; i < rest; i++) {
		indices[6 * n + i] = indices[i] + n + 1;
	}
	return out + rest;
}

void write_indices(const std::vector<int32_t> &cap, int n, int lod, int32_t *indices) {
	int32_t *out = write_side_indices(n, lod, indices);
	const int32_t bottom = (lod + 1) * (n + 1);
	const int32_t top = bottom + n;
	const size_t count = cap.size();
	for (size_t i = 0; i < count; i++) {
		out[i] = bottom + cap[i];
	}
	for (size_t i = 0; i < count; i += 3) {
		out[count + i] = top + cap[i];
		out[count + i + 1] = top + cap[i + 2];
		out[count + i + 2] = top + cap[i + 1];
	}
}

} // namespace

void build_smooth_mesh(const PlantSample &sample, const RingPlacer &placer, const MeshBuffers &buffers) {
	const int n = placer.points();
	write_sides(sample, placer, buffers);
	if (placer.has_shape_deviation()) {
		write_deviating_normals(placer, buffers.positions, buffers.normals);
	} else {
		write_regular_normals(sample, placer, buffers.normals);
	}
	const int ends = (sample.lod + 1) * (n + 1);
	write_end(sample, n, 0, ends, -1.0f, buffers);
	write_end(sample, n, sample.lod, ends + n, 1.0f, buffers);
	write_indices(sample.cross_section->cap, n, sample.lod, buffers.indices);
}

} // namespace undergrowth
