#pragma once

#include <godot_cpp/classes/mesh.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include <algorithm>

namespace undergrowth {

/// Replaces all normals and all tangents of the engine's arrays of a surface by what `normal` and `tangent` return for
/// each.
template <class Normal, class Tangent>
void map_directions(godot::Array &arrays, const Normal &normal, const Tangent &tangent) {
	using godot::Mesh;
	using godot::Variant;
	using godot::Vector3;
	if (arrays[Mesh::ARRAY_NORMAL].get_type() == Variant::PACKED_VECTOR3_ARRAY) {
		godot::PackedVector3Array normals = arrays[Mesh::ARRAY_NORMAL];
		Vector3 *to = normals.ptrw();
		std::transform(to, to + normals.size(), to, normal);
		arrays[Mesh::ARRAY_NORMAL] = normals;
	}
	if (arrays[Mesh::ARRAY_TANGENT].get_type() == Variant::PACKED_FLOAT32_ARRAY) {
		godot::PackedFloat32Array tangents = arrays[Mesh::ARRAY_TANGENT];
		float *to = tangents.ptrw();
		for (int64_t i = 0; i + 3 < tangents.size(); i += 4) {
			const Vector3 mapped = tangent(Vector3(to[i], to[i + 1], to[i + 2]));
			to[i] = mapped.x;
			to[i + 1] = mapped.y;
			to[i + 2] = mapped.z;
		}
		arrays[Mesh::ARRAY_TANGENT] = tangents;
	}
}

/// Removes the vertices of the engine's arrays of a surface that no triangle uses, as in coarse levels of detail.
void keep_used_vertices(godot::Array &arrays);

} // namespace undergrowth
