#include "mesh/mesh_parts.hpp"

#include <glm/geometric.hpp>

#include <numeric>

namespace undergrowth {

namespace {

/// One ring, before its triangles are cut.
struct Ring {
	glm::vec3 positions[MAX_RING_POINTS];
	glm::vec4 colors[MAX_RING_POINTS];
	float v = 0.0f;
	float weight = 0.0f;
};

void fill(Ring &ring, const PlantSample &sample, const RingPlacer &placer, int level) {
	placer.place(level, ring.positions);
	placer.paint(level, ring.colors);
	ring.v = 1.0f - static_cast<float>(level) / static_cast<float>(sample.lod);
	ring.weight = ring.positions[0].y / sample.height;
}

/// A corner of a triangle: point `index` of a ring, at `column` of the texture.
struct Corner {
	const Ring &ring;
	int index;
	int column;
};

/// Appends triangles.
class Writer {
public:
	Writer(const MeshBuffers &p_out, int p_points) : out(p_out), points(p_points) {}

	void add(const Corner &a, const Corner &b, const Corner &c, const glm::vec3 &normal) {
		put(a, normal);
		put(b, normal);
		put(c, normal);
	}

private:
	void put(const Corner &corner, const glm::vec3 &normal) {
		out.positions[next] = corner.ring.positions[corner.index];
		out.normals[next] = normal;
		out.colors[next] = corner.ring.colors[corner.index];
		out.uvs[next] = { static_cast<float>(corner.column) / static_cast<float>(points), corner.ring.v };
		write_weights(1, corner.ring.weight, out.weights + 4 * next);
		next++;
	}

	const MeshBuffers &out;
	const int points;
	int next = 0;
};

/// Returns the normal of a triangle that is clockwise from outside, or `otherwise` if its area is too small.
glm::vec3 triangle_normal(const glm::vec3 &a, const glm::vec3 &b, const glm::vec3 &c, const glm::vec3 &otherwise) {
	const glm::dvec3 first = glm::dvec3(b) - glm::dvec3(a);
	const glm::dvec3 second = glm::dvec3(c) - glm::dvec3(a);
	const glm::dvec3 normal = glm::cross(second, first);
	const double length = glm::length(normal);
	return length > 1e-6 * glm::length(first) * glm::length(second) ? glm::vec3(normal / length) : otherwise;
}

void add_quad(Writer &writer, const Ring &lower, const Ring &upper, int i, int next, const glm::vec3 &otherwise) {
	const glm::vec3 &low = lower.positions[i];
	const glm::vec3 &high = upper.positions[i];
	const glm::vec3 &next_low = lower.positions[next];
	const glm::vec3 &next_high = upper.positions[next];
	writer.add(
			{ lower, i, i }, { upper, i, i }, { lower, next, i + 1 }, triangle_normal(low, high, next_low, otherwise));
	writer.add({ upper, i, i }, { upper, next, i + 1 }, { lower, next, i + 1 },
			triangle_normal(high, next_high, next_low, otherwise));
}

void add_band(Writer &writer, const PlantSample &sample, const Ring &lower, const Ring &upper, float slope) {
	const std::vector<glm::vec2> &points = sample.cross_section->points;
	const int n = static_cast<int>(points.size());
	for (int i = 0; i < n; i++) {
		const int next = i + 1 < n ? i + 1 : 0;
		// If the band has no width, the normal of the regular quad still points outward.
		const glm::vec2 outward = edge_normal(points[i], points[next]);
		add_quad(writer, lower, upper, i, next, leaning_normal(outward, slope * glm::dot(outward, points[i])));
	}
}

void add_end(Writer &writer, const std::vector<int32_t> &cap, const Ring &ring, bool top) {
	const glm::vec3 normal = { 0.0f, top ? 1.0f : -1.0f, 0.0f };
	for (size_t i = 0; i < cap.size(); i += 3) {
		const int second = cap[i + (top ? 2 : 1)];
		const int third = cap[i + (top ? 1 : 2)];
		writer.add({ ring, cap[i], cap[i] }, { ring, second, second }, { ring, third, third }, normal);
	}
}

} // namespace

void build_flat_mesh(const PlantSample &sample, const RingPlacer &placer, const MeshBuffers &buffers) {
	Writer writer(buffers, placer.points());
	Ring rings[2];
	fill(rings[0], sample, placer, 0);
	for (int k = 0; k < sample.lod; k++) {
		const Ring &lower = rings[k % 2];
		Ring &upper = rings[(k + 1) % 2];
		fill(upper, sample, placer, k + 1);
		const float slope = (sample.widths[k + 1] - sample.widths[k]) / placer.rise_between(k, k + 1);
		add_band(writer, sample, lower, upper, slope);
	}
	// The ends are written last, when the bottom ring is no longer available.
	const std::vector<int32_t> &cap = sample.cross_section->cap;
	Ring &bottom = rings[(sample.lod + 1) % 2];
	fill(bottom, sample, placer, 0);
	add_end(writer, cap, bottom, false);
	add_end(writer, cap, rings[sample.lod % 2], true);

	const MeshCounts counts = count_mesh(placer.points(), sample.lod, Shading::flat);
	std::iota(buffers.indices, buffers.indices + counts.indices, 0);
}

} // namespace undergrowth
