#include "species/packed_arrays.hpp"

#include "base/convert.hpp"
#include "mesh/packed_vertex.hpp"

#include <cstring>

using namespace godot;

namespace undergrowth {

static constexpr int HALF_WORDS = PackedVertex::WORDS / 2;
static constexpr int64_t FORMAT = int64_t(Mesh::ARRAY_FLAG_COMPRESS_ATTRIBUTES) |
		custom_format(0, Mesh::ARRAY_CUSTOM_RGBA_FLOAT) | custom_format(1, Mesh::ARRAY_CUSTOM_RGBA_FLOAT);

namespace {

/// The arrays that are packed.
struct FormattedVertices {
	PackedVector3Array normals;
	PackedVector2Array uvs;
	PackedFloat32Array tangents;
	PackedFloat32Array customs[4];

	explicit FormattedVertices(const Array &arrays) :
			normals(arrays[Mesh::ARRAY_NORMAL]),
			uvs(arrays[Mesh::ARRAY_TEX_UV]),
			tangents(arrays[Mesh::ARRAY_TANGENT]) {
		for (int i = 0; i < 4; i++) {
			customs[i] = arrays[Mesh::ARRAY_CUSTOM0 + i];
		}
	}

	VertexAttributes vertex(int64_t i) const {
		VertexAttributes all;
		all.normal = to_glm(normals[i]);
		all.tangent = { tangents[4 * i], tangents[4 * i + 1], tangents[4 * i + 2] };
		all.uv = { uvs[i].x, uvs[i].y };
		all.custom0 = custom(0, i);
		all.custom1 = custom(1, i);
		all.custom2 = custom(2, i);
		all.height = customs[3][4 * i];
		all.stem_place = customs[3][4 * i + 1];
		return all;
	}

	glm::vec4 custom(int slot, int64_t i) const {
		const float *from = customs[slot].ptr() + 4 * i;
		return { from[0], from[1], from[2], from[3] };
	}
};

} // namespace

MeshArrays pack_arrays(const MeshArrays &from) {
	const FormattedVertices vertices(from.arrays);
	PackedFloat32Array first, second;
	first.resize(vertices.normals.size() * HALF_WORDS);
	second.resize(vertices.normals.size() * HALF_WORDS);
	float *to_first = first.ptrw();
	float *to_second = second.ptrw();
	for (int64_t i = 0; i < vertices.normals.size(); i++) {
		const PackedVertex packed = pack_vertex(vertices.vertex(i));
		std::memcpy(to_first + HALF_WORDS * i, packed.words, HALF_WORDS * sizeof(float));
		std::memcpy(to_second + HALF_WORDS * i, packed.words + HALF_WORDS, HALF_WORDS * sizeof(float));
	}
	MeshArrays made = from;
	made.format = FORMAT;
	made.arrays = Array();
	made.arrays.resize(Mesh::ARRAY_MAX);
	for (const int kept : { Mesh::ARRAY_VERTEX, Mesh::ARRAY_COLOR, Mesh::ARRAY_INDEX }) {
		made.arrays[kept] = from.arrays[kept];
	}
	made.arrays[Mesh::ARRAY_CUSTOM0] = first;
	made.arrays[Mesh::ARRAY_CUSTOM1] = second;
	for (int k = 0; k < MAX_INNER_SWINGS && !from.inner[k].is_empty(); k++) {
		made.arrays[Mesh::ARRAY_CUSTOM2 + k] = from.inner[k];
		made.format |= custom_format(2 + k, Mesh::ARRAY_CUSTOM_RGB_FLOAT);
		made.inner[k] = PackedFloat32Array();
	}
	return made;
}

} // namespace undergrowth
