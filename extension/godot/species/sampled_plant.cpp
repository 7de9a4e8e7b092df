// SampledPlant and MeshArrays: from a sampled plant function to a mesh of the engine.

#include "species/sampled_plant.hpp"

#include "base/new_object.hpp"
#include "form/form_arrays.hpp"
#include "form/grown_plant.hpp"
#include "mesh/joint_binding.hpp"
#include "model/plant_model.hpp"
#include "species/shared_resources.hpp"

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

float SampledPlant::widest() const {
	const float width = widths.empty() ? 0.0f : *std::max_element(widths.begin(), widths.end());
	return width * cross_section.radius;
}

// Without a skeleton, shaders do not get the bones' weights. The shader of fields reads the weight of the tip from
// here.
static constexpr int64_t CUSTOM_FORMAT = custom_format(0, Mesh::ARRAY_CUSTOM_R_FLOAT);

static PackedFloat32Array tip_weights(const PackedFloat32Array &weights) {
	PackedFloat32Array of_tip;
	of_tip.resize(weights.size() / 4);
	const float *from = weights.ptr();
	float *to = of_tip.ptrw();
	for (int64_t i = 0; i < of_tip.size(); i++) {
		to[i] = from[4 * i + 1];
	}
	return of_tip;
}

float MeshArrays::width() const {
	const PackedVector3Array positions = arrays[Mesh::ARRAY_VERTEX];
	Vector3 farthest;
	for (const Vector3 &position : positions) {
		farthest = farthest.max(position.abs());
	}
	float widest = std::sqrt(farthest.x * farthest.x + farthest.z * farthest.z);
	for (const MeshArrays &other : others) {
		widest = std::max(widest, other.width());
	}
	return widest;
}

static void add_surface(const MeshArrays &from, const Ref<ArrayMesh> &mesh) {
	const int number = mesh->get_surface_count();
	mesh->add_surface_from_arrays(
			Mesh::PRIMITIVE_TRIANGLES, from.arrays, TypedArray<Array>(), Dictionary(), from.format);
	Ref<Material> own = from.material;
	if (own.is_null() && !from.is_model) {
		own = from.has_parts ? Ref<Material>(parts_material()) : Ref<Material>(default_material());
	}
	mesh->surface_set_material(number, own);
}

Ref<ArrayMesh> MeshArrays::make() const {
	Ref<ArrayMesh> mesh = new_counted<ArrayMesh>();
	add_surface(*this, mesh);
	for (const MeshArrays &other : others) {
		add_surface(other, mesh);
	}
	return mesh;
}

const FormBones *SampledPlant::part_bones() const {
	if (!has_part_bones || !has_parts()) {
		return nullptr;
	}
	const FormBones &bones = model ? model->bones() : grown->bones;
	return bones.bones().empty() ? nullptr : &bones;
}

float SampledPlant::bones_height() const {
	return model ? model->height() : grown->form.height;
}

MeshArrays SampledPlant::build_arrays(Vector2 *from_above) const {
	if (model) {
		return model->build(*this);
	}
	if (grown) {
		return build_form_arrays(*grown, *this, from_above);
	}
	const MeshCounts counts = count_mesh(int(cross_section.points.size()), lod, options.shading);
	PackedVector3Array positions, normals;
	PackedColorArray tints;
	PackedVector2Array uvs;
	PackedInt32Array bones, indices;
	PackedFloat32Array weights;
	positions.resize(counts.vertices);
	normals.resize(counts.vertices);
	tints.resize(counts.vertices);
	uvs.resize(counts.vertices);
	bones.resize(counts.vertices * 4);
	weights.resize(counts.vertices * 4);
	indices.resize(counts.indices);

	MeshBuffers buffers;
	buffers.positions = reinterpret_cast<glm::vec3 *>(positions.ptrw());
	buffers.normals = reinterpret_cast<glm::vec3 *>(normals.ptrw());
	buffers.colors = reinterpret_cast<glm::vec4 *>(tints.ptrw());
	buffers.uvs = reinterpret_cast<glm::vec2 *>(uvs.ptrw());
	buffers.bones = bones.ptrw();
	buffers.weights = weights.ptrw();
	buffers.indices = indices.ptrw();
	build_mesh({ &cross_section, widths.data(), colors.data(), height, lod }, options, buffers);

	const PackedFloat32Array offsets = tip_weights(weights);
	if (stem) {
		bind_to_joints(stem->joints, counts.vertices, nullptr, bones.ptrw(), weights.ptrw());
	}
	MeshArrays made = { Array(), CUSTOM_FORMAT, material, false };
	Array &arrays = made.arrays;
	arrays.resize(Mesh::ARRAY_MAX);
	arrays[Mesh::ARRAY_VERTEX] = positions;
	arrays[Mesh::ARRAY_NORMAL] = normals;
	arrays[Mesh::ARRAY_COLOR] = tints;
	arrays[Mesh::ARRAY_TEX_UV] = uvs;
	arrays[Mesh::ARRAY_BONES] = bones;
	arrays[Mesh::ARRAY_WEIGHTS] = weights;
	arrays[Mesh::ARRAY_INDEX] = indices;
	arrays[Mesh::ARRAY_CUSTOM0] = offsets;
	return made;
}

} // namespace undergrowth
