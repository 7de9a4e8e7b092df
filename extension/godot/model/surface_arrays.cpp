#include "model/surface_arrays.hpp"

#include <godot_cpp/classes/mesh.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_color_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include <algorithm>
#include <vector>

using namespace godot;

namespace undergrowth {

template <class Packed> static Variant picked(const Packed &from, const std::vector<int32_t> &used, int64_t vertices) {
	const int64_t each = from.size() / vertices;
	Packed made;
	made.resize(each * int64_t(used.size()));
	auto *to = made.ptrw();
	for (const int32_t vertex : used) {
		to = std::copy_n(from.ptr() + each * vertex, each, to);
	}
	return made;
}

static Variant picked_of(const Variant &from, const std::vector<int32_t> &used, int64_t vertices) {
	switch (from.get_type()) {
		case Variant::PACKED_BYTE_ARRAY:
			return picked(PackedByteArray(from), used, vertices);
		case Variant::PACKED_COLOR_ARRAY:
			return picked(PackedColorArray(from), used, vertices);
		case Variant::PACKED_FLOAT32_ARRAY:
			return picked(PackedFloat32Array(from), used, vertices);
		case Variant::PACKED_INT32_ARRAY:
			return picked(PackedInt32Array(from), used, vertices);
		case Variant::PACKED_VECTOR2_ARRAY:
			return picked(PackedVector2Array(from), used, vertices);
		case Variant::PACKED_VECTOR3_ARRAY:
			return picked(PackedVector3Array(from), used, vertices);
		default:
			return from;
	}
}

void keep_used_vertices(Array &arrays) {
	const int64_t vertices = PackedVector3Array(arrays[Mesh::ARRAY_VERTEX]).size();
	PackedInt32Array indices = arrays[Mesh::ARRAY_INDEX];
	std::vector<int32_t> numbers(size_t(vertices), -1);
	std::vector<int32_t> used;
	int32_t *to = indices.ptrw();
	for (int64_t i = 0; i < indices.size(); i++) {
		int32_t &number = numbers[size_t(to[i])];
		if (number < 0) {
			number = int32_t(used.size());
			used.push_back(to[i]);
		}
		to[i] = number;
	}
	if (int64_t(used.size()) == vertices) {
		return; // The order of the file is as good.
	}
	for (int i = 0; i < Mesh::ARRAY_INDEX; i++) {
		arrays[i] = picked_of(arrays[i], used, vertices);
	}
	arrays[Mesh::ARRAY_INDEX] = indices;
}

} // namespace undergrowth
