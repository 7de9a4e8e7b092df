#include "model/plant_model.hpp"

#include "base/convert.hpp"
#include "mesh/joint_binding.hpp"
#include "model/model_bones.hpp"
#include "model/surface_arrays.hpp"
#include "species/sampled_plant.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace godot;

namespace undergrowth {

static constexpr int MAX_LODS = 4; // Besides the finest level.
static constexpr float MAX_SHARE = 0.45f; // Of the triangles of the same surface in the level before.
static constexpr float MAX_LEVEL_SHARE = 0.75f; // The same of all surfaces: otherwise a level is not worth it.
static constexpr float LEAF_SHARE = 0.4f; // Of the leaves of the level before.
static constexpr float MAX_WIDENING = 2.5f;
// Segments at which a coarser level begins, for the levels of fields (field/view/field_levels.cpp).
static constexpr int LEVEL_SEGMENTS[] = { 12, 8, 5, 3 };
static constexpr int64_t CUSTOM_FORMAT = custom_format(0, Mesh::ARRAY_CUSTOM_RGBA_FLOAT) |
		custom_format(1, Mesh::ARRAY_CUSTOM_RGBA_FLOAT) | custom_format(2, Mesh::ARRAY_CUSTOM_RGBA_FLOAT) |
		custom_format(3, Mesh::ARRAY_CUSTOM_RGBA_FLOAT);

// The surfaces as the core reads them. `file` must outlive the result.
static std::vector<ModelSurface> to_core(const std::vector<FileSurface> &file, const PackedInt32Array &foliage) {
	std::vector<ModelSurface> surfaces;
	for (const FileSurface &one : file) {
		const PackedVector3Array positions = one.arrays[Mesh::ARRAY_VERTEX];
		const PackedInt32Array indices = one.arrays[Mesh::ARRAY_INDEX];
		const bool has_colors = one.arrays[Mesh::ARRAY_COLOR].get_type() == Variant::PACKED_COLOR_ARRAY;
		const PackedColorArray colors =
				has_colors ? PackedColorArray(one.arrays[Mesh::ARRAY_COLOR]) : PackedColorArray();
		const bool is_foliage = foliage.is_empty() ? one.is_foliage : foliage.has(int32_t(surfaces.size()));
		surfaces.push_back({ reinterpret_cast<const glm::vec3 *>(positions.ptr()), int(positions.size()), indices.ptr(),
				int(indices.size()), has_colors ? reinterpret_cast<const glm::vec4 *>(colors.ptr()) : nullptr,
				is_foliage });
	}
	return surfaces;
}

std::shared_ptr<const PlantModel> PlantModel::make(
		const FileModel &file, const ModelOptions &options, String &problem) {
	auto made = std::make_shared<PlantModel>();
	for (const std::vector<FileSurface> &level : file.levels) {
		const std::vector<ModelSurface> surfaces = to_core(level, options.foliage);
		const ModelFault fault = find_model_fault(surfaces);
		if (fault != ModelFault::none) {
			problem = describe(fault);
			return nullptr;
		}
		if (made->motions.empty()) {
			made->frame = find_model_frame(surfaces, options.frame);
		}
		made->add_level(level, find_model_motion(surfaces, made->frame, options.colors));
	}
	if (file.levels.size() == 1) {
		made->add_lods(file.levels[0]);
	}
	return made;
}

static PackedFloat32Array floats_of(const std::vector<glm::vec4> &from, size_t first, size_t count) {
	PackedFloat32Array made;
	made.resize(int64_t(4 * count));
	std::memcpy(made.ptrw(), from.data() + first, 4 * count * sizeof(float));
	return made;
}

// Files without normals are lit from above.
static PackedVector3Array upward(int64_t count) {
	PackedVector3Array normals;
	normals.resize(count);
	std::fill(normals.ptrw(), normals.ptrw() + count, Vector3(0.0f, 1.0f, 0.0f));
	return normals;
}

void PlantModel::add_level(const std::vector<FileSurface> &surfaces, ModelMotion &&motion) {
	std::vector<Drawn> drawn;
	size_t first = 0;
	const ModelVertices &found = motion.vertices;
	for (const FileSurface &surface : surfaces) {
		Vertices own;
		own.material = surface.material;
		own.arrays = surface.arrays.duplicate();
		const size_t count = size_t(PackedVector3Array(own.arrays[Mesh::ARRAY_VERTEX]).size());
		const auto turn = [this](const Vector3 &way) { return to_godot(frame.direction_of(to_glm(way))); };
		map_directions(own.arrays, turn, turn);
		if (own.arrays[Mesh::ARRAY_NORMAL].get_type() != Variant::PACKED_VECTOR3_ARRAY) {
			own.arrays[Mesh::ARRAY_NORMAL] = upward(int64_t(count));
		}
		own.positions.resize(int64_t(count));
		std::transform(found.places.begin() + std::ptrdiff_t(first),
				found.places.begin() + std::ptrdiff_t(first + count), own.positions.ptrw(),
				[](const glm::vec3 &place) { return to_godot(place); });
		own.customs[0] = floats_of(found.custom0, first, count);
		own.customs[1] = floats_of(found.custom1, first, count);
		own.customs[2] = floats_of(found.custom2, first, count);
		own.customs[3].resize(int64_t(4 * count));
		own.stem_places.resize(int64_t(count));
		own.leaves.assign(
				found.leaves.begin() + std::ptrdiff_t(first), found.leaves.begin() + std::ptrdiff_t(first + count));
		own.bones.resize(int64_t(4 * count));
		own.weights.resize(int64_t(4 * count));
		float *customs = own.customs[3].ptrw();
		float *places = own.stem_places.ptrw();
		int32_t *bones = own.bones.ptrw();
		float *weights = own.weights.ptrw();
		const FormBones &all_bones = motions.empty() ? motion.bones : motions.front().bones;
		for (size_t i = 0; i < count; i++) {
			const glm::vec3 &place = found.places[first + i];
			const float values[4] = { frame.height, found.stem_places[first + i], place.x, place.z };
			std::copy(values, values + 4, customs + 4 * i);
			places[i] = found.stem_places[first + i];
			// Skeletons show the finest level only.
			all_bones.bind(motions.empty() ? found.swingers[first + i] : -1, found.custom0[first + i].x,
					found.bone_weights[first + i], bones + 4 * i, weights + 4 * i);
		}
		drawn.push_back({ int(all.size()), surface.arrays[Mesh::ARRAY_INDEX] });
		all.push_back(std::move(own));
		first += count;
	}
	motion.vertices = ModelVertices();
	motions.push_back(std::move(motion));
	levels.push_back(std::move(drawn));
}

PlantModel::Drawn PlantModel::thinned(const Drawn &whole, float share) {
	const std::vector<int> &leaves = all[size_t(whole.vertices)].leaves;
	const auto is_kept = [&](int32_t vertex) {
		return leaves[size_t(vertex)] < 0 || is_leaf_kept(leaves[size_t(vertex)], share);
	};
	Drawn made;
	for (int64_t i = 0; i < whole.indices.size(); i += 3) {
		for (int64_t corner = i; corner < i + 3 && is_kept(whole.indices[i]); corner++) {
			made.indices.push_back(whole.indices[corner]);
		}
	}
	if (made.indices.is_empty() || made.indices.size() == whole.indices.size()) {
		return whole;
	}
	Vertices wider = all[size_t(whole.vertices)];
	const float factor = std::min(1.0f / share, MAX_WIDENING);
	Vector3 *places = wider.positions.ptrw();
	float *asides = wider.customs[2].ptrw();
	for (size_t i = 0; i < leaves.size(); i++) {
		if (leaves[i] >= 0) {
			float *aside = asides + 4 * i;
			places[i] += Vector3(aside[0], aside[1], aside[2]) * (factor - 1.0f);
			std::transform(aside, aside + 3, aside, [factor](float one) { return one * factor; });
		}
	}
	made.vertices = int(all.size());
	all.push_back(std::move(wider));
	return made;
}

// A level consists of the next LOD of each surface. Surfaces without LODs, as of leaf cards, have fewer leaves.
void PlantModel::add_lods(const std::vector<FileSurface> &surfaces) {
	const auto count = [](const std::vector<Drawn> &level) {
		int64_t indices = 0;
		for (const Drawn &one : level) {
			indices += one.indices.size();
		}
		return indices;
	};
	float share = 1.0f;
	for (int number = 0; number < MAX_LODS; number++) {
		share *= LEAF_SHARE;
		std::vector<Drawn> level = levels.back();
		for (size_t i = 0; i < surfaces.size(); i++) {
			if (surfaces[i].lods.empty()) {
				level[i] = thinned(levels.front()[i], share);
				continue;
			}
			for (const PackedInt32Array &lod : surfaces[i].lods) {
				if (float(lod.size()) <= MAX_SHARE * float(levels.back()[i].indices.size())) {
					level[i].indices = lod;
					break;
				}
			}
		}
		if (float(count(level)) > MAX_LEVEL_SHARE * float(count(levels.back()))) {
			return;
		}
		levels.push_back(std::move(level));
	}
}

int PlantModel::level_of(int segments) const {
	int level = 0;
	for (const int from : LEVEL_SEGMENTS) {
		level += segments < from ? 1 : 0;
	}
	return std::min(level, level_count() - 1);
}

int PlantModel::triangles(int segments) const {
	int64_t indices = 0;
	for (const Drawn &one : levels[size_t(level_of(segments))]) {
		indices += one.indices.size();
	}
	return int(indices / 3);
}

void PlantModel::list_materials(int segments, std::vector<Ref<Material>> &into) const {
	for (const Drawn &one : levels[size_t(level_of(segments))]) {
		if (!one.indices.is_empty()) {
			into.push_back(all[size_t(one.vertices)].material);
		}
	}
}

void PlantModel::measure() const {
	std::vector<glm::vec3> places;
	std::vector<int32_t> indices;
	const auto seen = [&](size_t level) {
		places.clear();
		indices.clear();
		for (const Drawn &one : levels[level]) {
			const PackedVector3Array &own = all[size_t(one.vertices)].positions;
			const auto first = int32_t(places.size());
			for (int64_t i = 0; i < own.size(); i++) {
				places.push_back(to_glm(own[i]));
			}
			for (int64_t i = 0; i < one.indices.size(); i++) {
				indices.push_back(first + one.indices[i]);
			}
		}
		return SeenMesh{ places.data(), int(places.size()), indices.data(), int(indices.size()) };
	};
	const LevelError whole(seen(0));
	errors.push_back(0.0f);
	for (size_t level = 1; level < levels.size(); level++) {
		errors.push_back(std::max(whole.of(seen(level)), errors.back()));
	}
}

float PlantModel::error(int segments) const {
	const std::lock_guard<std::mutex> lock(measuring);
	if (errors.empty()) {
		measure();
	}
	return errors[size_t(level_of(segments))];
}

// The vertices of a plant that is stretched along y.
static void stretch(float factor, PackedVector3Array &positions, PackedFloat32Array (&customs)[4]) {
	Vector3 *places = positions.ptrw();
	float *pivots = customs[1].ptrw();
	float *heights = customs[3].ptrw();
	for (int64_t i = 0; i < positions.size(); i++) {
		places[i].y *= factor;
		pivots[4 * i + 1] *= factor;
		heights[4 * i] *= factor;
	}
}

MeshArrays PlantModel::build(const SampledPlant &sampled) const {
	MeshArrays made;
	bool is_first = true;
	for (const Drawn &one : levels[size_t(level_of(sampled.lod))]) {
		if (one.indices.is_empty()) {
			continue;
		}
		const Vertices &own = all[size_t(one.vertices)];
		MeshArrays surface;
		surface.format = CUSTOM_FORMAT;
		surface.material = sampled.material.is_valid() ? sampled.material : own.material;
		surface.is_model = true;
		surface.arrays = own.arrays.duplicate();
		PackedVector3Array positions = own.positions;
		PackedFloat32Array customs[4] = { own.customs[0], own.customs[1], own.customs[2], own.customs[3] };
		if (sampled.height != frame.height) {
			stretch(sampled.height / frame.height, positions, customs);
		}
		PackedInt32Array bones = own.bones;
		PackedFloat32Array weights = own.weights;
		if (sampled.stem) {
			bind_to_joints(
					sampled.stem->joints, int(positions.size()), own.stem_places.ptr(), bones.ptrw(), weights.ptrw());
			hold_base(int(positions.size()), own.stem_places.ptr(), bones.ptrw(), weights.ptrw());
		}
		surface.arrays[Mesh::ARRAY_VERTEX] = positions;
		surface.arrays[Mesh::ARRAY_INDEX] = one.indices;
		surface.arrays[Mesh::ARRAY_BONES] = bones;
		surface.arrays[Mesh::ARRAY_WEIGHTS] = weights;
		for (int i = 0; i < 4; i++) {
			surface.arrays[Mesh::ARRAY_CUSTOM0 + i] = customs[i];
		}
		keep_used_vertices(surface.arrays);
		if (std::exchange(is_first, false)) {
			made = std::move(surface);
		} else {
			made.others.push_back(std::move(surface));
		}
	}
	return made;
}

} // namespace undergrowth
