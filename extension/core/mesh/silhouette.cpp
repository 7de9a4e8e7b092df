#include "mesh/silhouette.hpp"

#include "mesh/sight_lens.hpp"

namespace undergrowth {

namespace {

constexpr int COLUMNS = 512; // Per box.
constexpr int ROWS = 160;
constexpr int ABOVE = 192; // Columns and rows of the view from above.

/// Dots in rows of bits.
class Outline {
public:
	Outline(int columns, int rows) : words((columns + 63) / 64), bits(static_cast<size_t>(words * rows)) {}

	void clear() { std::fill(bits.begin(), bits.end(), 0); }
	void fill(int row, int first, int end) {
		uint64_t *own = bits.data() + row * words;
		for (int at = first; at < end;) {
			const int next = std::min(end, (at / 64 + 1) * 64);
			own[at / 64] |= (~uint64_t(0) >> (64 - (next - at))) << (at % 64);
			at = next;
		}
	}
	int count() const {
		int sum = 0;
		for (uint64_t word : bits) { // Sums neighbours: bits, pairs, fours; then all bytes at once.
			word -= (word >> 1) & 0x5555555555555555u;
			word = (word & 0x3333333333333333u) + ((word >> 2) & 0x3333333333333333u);
			word = (word + (word >> 4)) & 0x0f0f0f0f0f0f0f0fu;
			sum += static_cast<int>((word * 0x0101010101010101u) >> 56);
		}
		return sum;
	}

private:
	const int words;
	std::vector<uint64_t> bits;
};

float area_of_side(SightLens &lens, size_t side, Outline &outline) {
	lens.set_view(side);
	outline.clear();
	for (const SightLens::Triangle &triangle : lens.triangles()) {
		const TriangleEdges edges(lens, triangle);
		for (int row = triangle.begin; row < triangle.end; row++) {
			int first, end;
			edges.columns(row, lens.columns(), first, end);
			outline.fill(row, first, end);
		}
	}
	return static_cast<float>(outline.count()) * lens.dot_area();
}

} // namespace

void SightBox::take_in(const glm::vec3 &point) {
	reach = std::max(reach, std::sqrt(point.x * point.x + point.z * point.z));
	low = std::min(low, point.y);
	top = std::max(top, point.y);
}

SightLens::SightLens(const SeenMesh &p_mesh, const SightBox &box, int columns, int rows) :
		mesh(p_mesh),
		across(static_cast<float>(columns) / (2.0f * box.reach)),
		up(static_cast<float>(rows) / (box.top - box.low)),
		ground(box.low),
		corners(static_cast<size_t>(p_mesh.vertex_count)) {
	SightBox own = box;
	for (int i = 0; i < mesh.vertex_count; i++) {
		own.take_in(mesh.positions[i]);
	}
	const auto dots = [](float metres, float a_metre, int usual) {
		return std::ceil(std::min(metres * a_metre, MAX_ENLARGEMENT * static_cast<float>(usual)) - 0.01f);
	};
	half = static_cast<int>(dots(own.reach, across, columns / 2));
	low = dots(box.low - own.low, up, rows);
	height = static_cast<int>(low + dots(own.top - box.low, up, rows));
	find_triangles();
}

void SightLens::find_triangles() {
	for (size_t i = 0; i < corners.size(); i++) {
		corners[i].y = (mesh.positions[i].y - ground) * up + low;
	}
	upright.reserve(static_cast<size_t>(mesh.index_count / 3));
	for (int i = 0; i < mesh.index_count; i += 3) {
		const int32_t *at = mesh.indices + i;
		Triangle triangle = { { at[0], at[1], at[2] }, 0, 0, i };
		const auto sort = [&](int lower, int upper) {
			if (corner(triangle.corners[upper]).y < corner(triangle.corners[lower]).y) {
				std::swap(triangle.corners[lower], triangle.corners[upper]);
			}
		};
		sort(0, 1);
		sort(1, 2);
		sort(0, 1);
		triangle.begin = first_beyond(corner(triangle.corners[0]).y);
		triangle.end = std::min(height, first_beyond(corner(triangle.corners[2]).y));
		if (triangle.begin < triangle.end) { // Most small triangles lie between two rows.
			upright.push_back(triangle);
		}
	}
}

void SightLens::set_view(size_t side) {
	const float cosine = OUTLINE_COSINES[side];
	const float sine = OUTLINE_SINES[side];
	for (size_t i = 0; i < corners.size(); i++) {
		const glm::vec3 &point = mesh.positions[i];
		corners[i].x = (point.x * cosine + point.z * sine) * across + static_cast<float>(half);
		corners[i].depth = point.z * cosine - point.x * sine;
	}
}

Outlines outline_areas(const SeenMesh &mesh, const SightBox &box) {
	SightLens lens(mesh, box, COLUMNS, ROWS);
	Outline outline(lens.columns(), lens.rows());
	Outlines areas = {};
	for (size_t side = 0; side < OUTLINES; side++) {
		areas[side] = area_of_side(lens, side, outline);
	}
	return areas;
}

float area_from_above(const SeenMesh &mesh) {
	std::vector<glm::vec3> rotated; // Depth becomes height.
	SightBox box;
	for (int i = 0; i < mesh.vertex_count; i++) {
		const glm::vec3 &point = mesh.positions[i];
		rotated.emplace_back(point.x, point.z, point.y);
		box.take_in(point);
	}
	if (!(box.reach > 0.0f)) {
		return 0.0f;
	}
	box.low = -box.reach;
	box.top = box.reach;
	const SeenMesh seen = { rotated.data(), mesh.vertex_count, mesh.indices, mesh.index_count };
	SightLens lens(seen, box, ABOVE, ABOVE);
	Outline outline(lens.columns(), lens.rows());
	return area_of_side(lens, 0, outline);
}

} // namespace undergrowth
