#include "model/model_file.hpp"

#include "base/messages.hpp"
#include "model/surface_arrays.hpp"

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/base_material3d.hpp>
#include <godot_cpp/classes/importer_mesh.hpp>
#include <godot_cpp/classes/mesh_instance3d.hpp>
#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/packed_scene.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/shader.hpp>
#include <godot_cpp/classes/shader_material.hpp>

#include <algorithm>
#include <utility>

using namespace godot;

namespace undergrowth {

// Angles of the engine's import of scenes, in degrees.
static constexpr float MERGE_ANGLE = 60.0f;
static constexpr float SPLIT_ANGLE = 25.0f;
static constexpr int MAX_LEVEL = 9; // `_LOD9`.
static constexpr int64_t MAX_SHORT_VERTICES = 65536; // Of a surface with indices of 16 bits.
static constexpr int64_t MIN_TRIANGLES = 32; // Smaller meshes have no levels.

static bool names_leaves(const String &name) {
	static const char *const words[] = { "leaf", "leaves", "foliage", "petal", "frond", "needle", "flower", "blossom" };
	const String lower = name.to_lower();
	return std::any_of(std::begin(words), std::end(words), [&](const char *word) { return lower.contains(word); });
}

static bool is_foliage(const Ref<Material> &material) {
	const Ref<BaseMaterial3D> plain = material;
	if (plain.is_valid() && plain->get_transparency() != BaseMaterial3D::TRANSPARENCY_DISABLED) {
		return true;
	}
	const Ref<ShaderMaterial> own = material;
	const Ref<Shader> shader = own.is_valid() ? own->get_shader() : Ref<Shader>();
	return (shader.is_valid() && shader->get_code().contains("ALPHA_SCISSOR")) ||
			(material.is_valid() && names_leaves(material->get_name()));
}

static PackedInt32Array in_order(int64_t count) {
	PackedInt32Array indices;
	indices.resize(count - count % 3);
	int32_t *to = indices.ptrw();
	for (int64_t i = 0; i < indices.size(); i++) {
		to[i] = int32_t(i);
	}
	return indices;
}

static void transform(const Transform3D &by, Array &arrays) {
	PackedVector3Array positions = arrays[Mesh::ARRAY_VERTEX];
	Vector3 *places = positions.ptrw();
	for (int64_t i = 0; i < positions.size(); i++) {
		places[i] = by.xform(places[i]);
	}
	arrays[Mesh::ARRAY_VERTEX] = positions;
	const Basis of_normals = by.basis.inverse().transposed();
	map_directions(
			arrays, [&](const Vector3 &normal) { return of_normals.xform(normal).normalized(); },
			[&](const Vector3 &tangent) { return by.basis.xform(tangent).normalized(); });
}

// A mirrored node draws its triangles the other way round.
static PackedInt32Array reversed(PackedInt32Array indices) {
	int32_t *to = indices.ptrw();
	for (int64_t i = 0; i + 2 < indices.size(); i += 3) {
		std::swap(to[i + 1], to[i + 2]);
	}
	return indices;
}

static int64_t index_count(const Array &arrays) {
	return arrays[Mesh::ARRAY_INDEX].get_type() == Variant::PACKED_INT32_ARRAY
			? PackedInt32Array(arrays[Mesh::ARRAY_INDEX]).size()
			: 0;
}

static bool needs_lods(const Ref<ImporterMesh> &mesh) {
	int64_t indices = 0;
	for (int i = 0; i < mesh->get_surface_count(); i++) {
		if (mesh->get_surface_lod_count(i) > 0) {
			return false;
		}
		indices += index_count(mesh->get_surface_arrays(i));
	}
	return indices >= 3 * MIN_TRIANGLES;
}

namespace {

/// Where a mesh is in its scene.
struct Found {
	Ref<Mesh> mesh;
	Transform3D place;
	const MeshInstance3D *node = nullptr; // Null: the file is a mesh.
	int level = 0;
};

} // namespace

static Ref<Material> material_of(const Found &found, const Ref<ImporterMesh> &mesh, int surface) {
	Ref<Material> own;
	if (found.node) {
		own = found.node->get_material_override();
		own = own.is_null() && surface < found.node->get_surface_override_material_count()
				? found.node->get_surface_override_material(surface)
				: own;
	}
	return own.is_valid() ? own : mesh->get_surface_material(surface);
}

// The levels of a surface as the renderer has them: {edge length: indices}, of 16 bits where they suffice.
static Dictionary levels_of(const Dictionary &surface) {
	const bool is_short = int64_t(surface["vertex_count"]) <= MAX_SHORT_VERTICES;
	const Array levels = surface.get("lods", Array());
	Dictionary found;
	for (int64_t i = 0; i < levels.size(); i++) {
		const Dictionary level = levels[i];
		const PackedByteArray bytes = level["index_data"];
		PackedInt32Array indices;
		indices.resize(bytes.size() / (is_short ? 2 : 4));
		int32_t *to = indices.ptrw();
		for (int64_t k = 0; k < indices.size(); k++) {
			to[k] = int32_t(is_short ? bytes.decode_u16(2 * k) : bytes.decode_u32(4 * k));
		}
		found[level["edge_length"]] = indices;
	}
	return found;
}

// As ImporterMesh::from_mesh(), which Godot 4.5 does not have.
static Ref<ImporterMesh> imported(const Ref<Mesh> &mesh) {
	Ref<ImporterMesh> made;
	if (mesh.is_null()) {
		return made;
	}
	made.instantiate();
	const Ref<ArrayMesh> own = mesh;
	for (int i = 0; i < mesh->get_surface_count(); i++) {
		const Dictionary surface = RenderingServer::get_singleton()->mesh_get_surface(mesh->get_rid(), i);
		made->add_surface(Mesh::PrimitiveType(int64_t(surface["primitive"])), mesh->surface_get_arrays(i),
				TypedArray<Array>(), levels_of(surface), mesh->surface_get_material(i),
				own.is_valid() ? own->surface_get_name(i) : String());
	}
	return made;
}

static void read_mesh(const Found &found, FileModel &model) {
	const Ref<ImporterMesh> mesh = imported(found.mesh);
	if (mesh.is_null()) {
		return;
	}
	if (needs_lods(mesh)) {
		mesh->generate_lods(MERGE_ANGLE, SPLIT_ANGLE, Array());
	}
	if (int(model.levels.size()) <= found.level) {
		model.levels.resize(size_t(found.level) + 1);
	}
	for (int i = 0; i < mesh->get_surface_count(); i++) {
		if (mesh->get_surface_primitive_type(i) != Mesh::PRIMITIVE_TRIANGLES) {
			continue;
		}
		FileSurface surface;
		surface.arrays = mesh->get_surface_arrays(i);
		if (index_count(surface.arrays) == 0) {
			surface.arrays[Mesh::ARRAY_INDEX] = in_order(PackedVector3Array(surface.arrays[Mesh::ARRAY_VERTEX]).size());
		}
		transform(found.place, surface.arrays);
		for (int lod = 0; lod < mesh->get_surface_lod_count(i); lod++) {
			surface.lods.push_back(mesh->get_surface_lod_indices(i, lod));
		}
		if (found.place.basis.determinant() < 0.0f) {
			surface.arrays[Mesh::ARRAY_INDEX] = reversed(surface.arrays[Mesh::ARRAY_INDEX]);
			for (PackedInt32Array &lod : surface.lods) {
				lod = reversed(lod);
			}
		}
		surface.material = material_of(found, mesh, i);
		surface.is_foliage = is_foliage(surface.material) || names_leaves(mesh->get_surface_name(i)) ||
				(found.node && names_leaves(found.node->get_name()));
		model.levels[size_t(found.level)].push_back(std::move(surface));
	}
}

// Returns the number behind `_LOD`; 0 without one.
static int level_of(const String &name) {
	const String upper = name.to_upper();
	const int64_t at = upper.rfind("_LOD");
	const String number = at < 0 ? String() : upper.substr(at + 4, 1);
	return number.is_valid_int() ? std::min(int(number.to_int()), MAX_LEVEL) : 0;
}

static void find_meshes(const Node *node, const Transform3D &parent, int level, std::vector<Found> &found) {
	const Node3D *spatial = Object::cast_to<Node3D>(node);
	const Transform3D place = spatial ? parent * spatial->get_transform() : parent;
	level = std::max(level, level_of(node->get_name()));
	const MeshInstance3D *shown = Object::cast_to<MeshInstance3D>(node);
	if (shown && shown->get_mesh().is_valid()) {
		found.push_back({ shown->get_mesh(), place, shown, level });
	}
	for (int i = 0; i < node->get_child_count(); i++) {
		find_meshes(node->get_child(i), place, level, found);
	}
}

static String no_mesh_in(const Ref<Resource> &file) {
	return describe(file.ptr()) + " contains no mesh. Use a mesh, or a scene with at least one MeshInstance3D.";
}

static void read_scene(const Ref<PackedScene> &scene, FileModel &model) {
	Node *root = scene->can_instantiate() ? scene->instantiate() : nullptr;
	if (!root) {
		model.problem = no_mesh_in(scene);
		return;
	}
	std::vector<Found> found;
	find_meshes(root, Transform3D(), 0, found);
	for (const Found &one : found) {
		read_mesh(one, model);
	}
	memdelete(root);
}

FileModel read_model_file(const Ref<Resource> &file) {
	FileModel model;
	const Ref<Mesh> mesh = file;
	const Ref<PackedScene> scene = file;
	if (mesh.is_valid()) {
		read_mesh({ mesh, Transform3D(), nullptr, 0 }, model);
	} else if (scene.is_valid()) {
		read_scene(scene, model);
	}
	const auto is_empty = [](const std::vector<FileSurface> &level) { return level.empty(); };
	model.levels.erase(std::remove_if(model.levels.begin(), model.levels.end(), is_empty), model.levels.end());
	if (model.problem.is_empty() && model.levels.empty()) {
		model.problem = no_mesh_in(file);
	}
	return model;
}

} // namespace undergrowth
