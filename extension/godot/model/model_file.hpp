#pragma once

#include <godot_cpp/classes/material.hpp>
#include <godot_cpp/classes/mesh.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/string.hpp>

#include <vector>

namespace undergrowth {

/// One surface of a file: the engine's arrays in the axes of the file.
struct FileSurface {
	godot::Array arrays; ///< Vertices, normals, tangents, colours, UVs, indices. All that exist in the file.
	std::vector<godot::PackedInt32Array> lods; ///< Indices of coarser levels of the same vertices, finest first.
	godot::Ref<godot::Material> material; ///< Null: none.
	bool is_foliage = false; ///< Its material is cut out, or its name says that it is leaves.
};

/// The surfaces of a mesh or of all meshes of a scene.
struct FileModel {
	/// By level: that of the file, and its nodes whose names end with `_LOD1` and so on.
	std::vector<std::vector<FileSurface>> levels;
	godot::String problem; ///< What is wrong and what to do; empty: nothing.
};

/// Reads a Mesh or a PackedScene. Surfaces of lines and points are left out. A mesh without levels gets those that the
/// engine makes for an imported file. Main thread.
FileModel read_model_file(const godot::Ref<godot::Resource> &file);

} // namespace undergrowth
