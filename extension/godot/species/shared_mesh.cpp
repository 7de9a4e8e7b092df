#include "species/shared_mesh.hpp"

#include "base/renderer.hpp"
#include "form/shared_cards.hpp"
#include "species/compact_arrays.hpp"
#include "species/packed_arrays.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <tuple>
#include <unordered_map>

using namespace godot;

namespace undergrowth {

namespace {

/// All shared meshes of the process, by the hash of their sample.
struct SharedMeshes {
	std::mutex mutex;
	std::unordered_multimap<size_t, std::weak_ptr<SharedMesh>> entries;
	size_t next_sweep = 64;

	/// Removes freed meshes when the number of entries has doubled.
	void sweep() {
		if (entries.size() < next_sweep) {
			return;
		}
		for (auto entry = entries.begin(); entry != entries.end();) {
			entry = entry->second.expired() ? entries.erase(entry) : std::next(entry);
		}
		next_sweep = std::max(size_t(64), 2 * entries.size());
	}
};

} // namespace

static SharedMeshes &all_meshes() {
	static SharedMeshes *const all = new SharedMeshes; // Worker threads may outlive static objects.
	return *all;
}

static auto traits_of(const SampledPlant &plant) {
	const MeshOptions &options = plant.options;
	return std::make_tuple(plant.height, plant.lod, options.shading, options.shape_deviation, options.color_deviation,
			options.seed, plant.material.ptr(), plant.has_part_bones, plant.is_packed, plant.stem.get(), plant.rest.x,
			plant.rest.y, plant.grown.get(), plant.model.get(), plant.cards.get(), plant.cross_section.points.size());
}

static bool are_equal(const SampledPlant &one, const SampledPlant &other) {
	return traits_of(one) == traits_of(other) && one.cross_section.points == other.cross_section.points &&
			one.widths == other.widths && one.colors == other.colors;
}

static size_t hash_of(const SampledPlant &plant) {
	size_t hash = 0;
	const auto add = [&](size_t value) { hash = hash * 31 + value; };
	add(std::hash<float>()(plant.height));
	add(size_t(plant.lod));
	add(size_t(plant.options.seed));
	add(std::hash<const void *>()(plant.grown.get()));
	add(std::hash<const void *>()(plant.model.get()));
	add(std::hash<const void *>()(plant.cards.get()));
	for (const float width : plant.widths) {
		add(std::hash<float>()(width));
	}
	return hash;
}

std::shared_ptr<SharedMesh> SharedMesh::of(const SampledPlant &plant) {
	SharedMeshes &all = all_meshes();
	const size_t hash = hash_of(plant);
	const std::lock_guard<std::mutex> lock(all.mutex);
	const auto [first, end] = all.entries.equal_range(hash);
	for (auto entry = first; entry != end; ++entry) {
		std::shared_ptr<SharedMesh> known = entry->second.lock();
		if (known && are_equal(known->plant, plant)) {
			return known;
		}
	}
	all.sweep();
	auto made = std::make_shared<SharedMesh>(plant);
	all.entries.emplace(hash, made);
	return made;
}

void SharedMesh::build() {
	const std::lock_guard<std::mutex> lock(building);
	build_locked();
}

bool SharedMesh::try_build() {
	const std::unique_lock<std::mutex> lock(building, std::try_to_lock);
	if (lock.owns_lock()) {
		build_locked();
	}
	return lock.owns_lock();
}

void SharedMesh::build_locked() {
	if (!is_built) {
		arrays = plant.build_arrays(&built_from_above);
		built_width = arrays.width();
		built_has_cards = arrays.has_cards;
		built_has_bodies = arrays.has_bodies;
		built_triangles = int(PackedInt32Array(arrays.arrays[Mesh::ARRAY_INDEX]).size()) / 3;
		is_built = true;
	}
}

float SharedMesh::outline_error(const LevelError &whole) {
	MeshArrays seen;
	{
		const std::lock_guard<std::mutex> lock(building);
		build_locked();
		seen = mesh.is_valid() ? plant.build_arrays() : arrays; // make() frees the arrays.
	}
	const PackedVector3Array positions = seen.arrays[Mesh::ARRAY_VERTEX];
	const PackedInt32Array indices = seen.arrays[Mesh::ARRAY_INDEX];
	const SeenMesh level = { reinterpret_cast<const glm::vec3 *>(positions.ptr()), int(positions.size()), indices.ptr(),
		int(indices.size()) };
	if (!seen.has_cards) {
		return std::max(whole.of(level), seen.facets);
	}
	const PackedVector3Array normals = seen.arrays[Mesh::ARRAY_NORMAL];
	const PackedFloat32Array tangents = seen.arrays[Mesh::ARRAY_TANGENT];
	const PackedVector2Array uvs = seen.arrays[Mesh::ARRAY_TEX_UV];
	const PackedFloat32Array custom0 = seen.arrays[Mesh::ARRAY_CUSTOM0];
	const PackedFloat32Array custom2 = seen.arrays[Mesh::ARRAY_CUSTOM2];
	const CardSheet &sheet = plant.cards->sheet();
	SeenCards cards;
	cards.normals = reinterpret_cast<const glm::vec3 *>(normals.ptr());
	cards.tangents = reinterpret_cast<const glm::vec4 *>(tangents.ptr());
	cards.uvs = reinterpret_cast<const glm::vec2 *>(uvs.ptr());
	cards.custom0 = reinterpret_cast<const glm::vec4 *>(custom0.ptr());
	cards.custom2 = reinterpret_cast<const glm::vec4 *>(custom2.ptr());
	cards.width = sheet.width;
	cards.height = sheet.height;
	for (const CardLayer &layer : sheet.pictures) {
		cards.layers.push_back(layer.colors.data());
	}
	return std::max(whole.of(level, cards), seen.facets);
}

// The engine may wait for the main thread while it creates a mesh, so this does not hold the lock. If two threads
// create it at the same time, one drops its own.
Ref<ArrayMesh> SharedMesh::make() {
	MeshArrays from;
	{
		const std::lock_guard<std::mutex> lock(building);
		if (mesh.is_valid()) {
			return mesh;
		}
		from = arrays;
	}
	const Ref<ArrayMesh> made =
			(plant.is_packed ? pack_arrays(from) : compact_arrays(from, !is_compatibility())).make();
	const std::lock_guard<std::mutex> lock(building);
	if (mesh.is_null()) {
		mesh = made;
		arrays = MeshArrays();
	}
	return mesh;
}

} // namespace undergrowth
