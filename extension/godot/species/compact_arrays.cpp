#include "species/compact_arrays.hpp"

#include "base/convert.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>

#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr int CUSTOMS = 4;
static constexpr int HALF_BYTES = 2;

// Returns the first `count` of every four numbers as half floats.
static PackedByteArray halves_of(const PackedFloat32Array &numbers, int count) {
	PackedByteArray packed;
	packed.resize(numbers.size() / 4 * count * HALF_BYTES);
	const float *from = numbers.ptr();
	uint16_t *to = reinterpret_cast<uint16_t *>(packed.ptrw());
	for (int64_t i = 0; i < numbers.size(); i += 4) {
		for (int k = 0; k < count; k++) {
			*to++ = glm::packHalf1x16(from[i + k]);
		}
	}
	return packed;
}

// Returns the first two of every four numbers.
static PackedFloat32Array pairs_of(const PackedFloat32Array &numbers) {
	PackedFloat32Array pairs;
	pairs.resize(numbers.size() / 2);
	float *to = pairs.ptrw();
	for (int64_t i = 0; i < numbers.size(); i += 4) {
		*to++ = numbers[i];
		*to++ = numbers[i + 1];
	}
	return pairs;
}

// The engine stores normal and tangent as a rotation, so they must be perpendicular.
static PackedFloat32Array perpendicular(const PackedFloat32Array &tangents, const PackedVector3Array &normals) {
	PackedFloat32Array turned = tangents;
	float *to = turned.ptrw();
	for (int64_t i = 0; i < normals.size(); i++) {
		const glm::vec3 normal = to_glm(normals[i]);
		const glm::vec3 tangent(to[4 * i], to[4 * i + 1], to[4 * i + 2]);
		glm::vec3 made = tangent - normal * glm::dot(tangent, normal);
		if (glm::dot(made, made) < 1e-6f) { // Any direction is right.
			made = glm::cross(
					normal, std::fabs(normal.x) < 0.5f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f));
		}
		made = glm::normalize(made);
		to[4 * i] = made.x;
		to[4 * i + 1] = made.y;
		to[4 * i + 2] = made.z;
	}
	return turned;
}

// For an attribute that a file does not contain.
static PackedFloat32Array no_tangents(int64_t count) {
	PackedFloat32Array made;
	made.resize(4 * count);
	float *to = made.ptrw();
	for (int64_t i = 0; i < count; i++) {
		to[4 * i] = to[4 * i + 3] = 1.0f;
		to[4 * i + 1] = to[4 * i + 2] = 0.0f;
	}
	return made;
}

MeshArrays compact_arrays(const MeshArrays &from, bool reads_half_floats) {
	MeshArrays made = from;
	made.arrays = from.arrays.duplicate();
	made.arrays[Mesh::ARRAY_BONES] = Variant();
	made.arrays[Mesh::ARRAY_WEIGHTS] = Variant();
	for (MeshArrays &other : made.others) {
		other = compact_arrays(other, reads_half_floats);
	}
	if (!from.has_parts && !from.is_model) {
		return made;
	}
	made.format = int64_t(Mesh::ARRAY_FLAG_COMPRESS_ATTRIBUTES);
	const PackedVector3Array normals = from.arrays[Mesh::ARRAY_NORMAL];
	const bool has_tangents = from.arrays[Mesh::ARRAY_TANGENT].get_type() == Variant::PACKED_FLOAT32_ARRAY;
	made.arrays[Mesh::ARRAY_TANGENT] = perpendicular(
			has_tangents ? PackedFloat32Array(from.arrays[Mesh::ARRAY_TANGENT]) : no_tangents(normals.size()), normals);
	for (int i = 0; i < CUSTOMS; i++) {
		const int slot = Mesh::ARRAY_CUSTOM0 + i;
		const bool is_last = i == CUSTOMS - 1;
		if (reads_half_floats) {
			made.arrays[slot] = halves_of(from.arrays[slot], is_last ? 2 : 4);
			made.format |= custom_format(i, is_last ? Mesh::ARRAY_CUSTOM_RG_HALF : Mesh::ARRAY_CUSTOM_RGBA_HALF);
		} else {
			made.arrays[slot] = is_last ? pairs_of(from.arrays[slot]) : PackedFloat32Array(from.arrays[slot]);
			made.format |= custom_format(i, is_last ? Mesh::ARRAY_CUSTOM_RG_FLOAT : Mesh::ARRAY_CUSTOM_RGBA_FLOAT);
		}
	}
	return made;
}

} // namespace undergrowth
