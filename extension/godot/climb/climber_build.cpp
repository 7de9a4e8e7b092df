#include "climb/climber_build.hpp"

#include "base/convert.hpp"
#include "base/random.hpp"
#include "mesh/level_error.hpp"
#include "species/compact_arrays.hpp"
#include "species/shared_resources.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr float CHUNK_SIZE = 3.0f; // m.
static constexpr float CELL_SIZE = 0.8f; // m, of leaves that move alike.
static constexpr float PIXELS = 704.0f; // Per radian: 1080 rows in a view of 75°.
static constexpr float PHASES = 32.0f;
static constexpr float FAR_STEMS = 1.5f; // Radius (mm) below which distant stems are left out.
static const glm::vec3 YOUNG_TINT(1.75f, 1.55f, 1.25f); // Of a leaf at the tip of a shoot, relative to a grown one.

static SeenMesh seen(const MeshArrays &from, PackedVector3Array &positions, PackedInt32Array &indices) {
	positions = from.arrays[Mesh::ARRAY_VERTEX];
	indices = from.arrays[Mesh::ARRAY_INDEX];
	return { reinterpret_cast<const glm::vec3 *>(positions.ptr()), int(positions.size()), indices.ptr(),
		int(indices.size()) };
}

void ClimberBuild::run() {
	const auto start = std::chrono::steady_clock::now();
	build_leaf();
	fault = grow_climb(join_faces(faces), settings, climb);
	if (fault.empty()) {
		cells = find_cells(climb, CELL_SIZE, MAX_CLIMBER_CELLS);
		build_chunks();
	}
	if (makes_meshes) {
		make_meshes();
	}
	faces.clear();
	seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// A level begins where the outline of its mesh differs by less than a pixel from that of the finest one.
void ClimberBuild::build_leaf() {
	PackedVector3Array positions;
	PackedInt32Array indices;
	leaf_arrays[0] = leaf[0].build_arrays();
	const LevelError whole(seen(leaf_arrays[0], positions, indices));
	float reach = 0.0f;
	for (const Vector3 &position : positions) {
		reach = std::max(reach, Vector2(position.x, position.z).length());
	}
	settings.leaf_reach = std::max(reach * leaf_scale, 0.002f);
	leaf_vertices[0] = int(positions.size());
	for (size_t i = 1; i < CLIMBER_LEVELS.size(); i++) {
		const ClimberLevel &level = CLIMBER_LEVELS[i];
		leaf_arrays[i] = leaf[i].build_arrays();
		const float error = whole.of(seen(leaf_arrays[i], positions, indices)) * leaf_scale;
		const float far = level.leaf_pixels > 0.0f ? settings.leaf_reach * PIXELS / level.leaf_pixels : error * PIXELS;
		begins[i] = std::max(far, begins[i - 1]);
		leaf_vertices[i] = int(positions.size());
	}
}

static Basis axes_of(const ClimbLeaf &leaf, float scale) {
	const glm::vec3 across = glm::cross(leaf.out, leaf.down) * scale;
	const glm::vec3 out = leaf.out * scale;
	const glm::vec3 down = leaf.down * scale;
	return Basis(to_godot(across), to_godot(out), to_godot(down));
}

// Leaves nearer to the surface are under others.
static glm::vec4 tint_of(const ClimbLeaf &leaf, int number) {
	const float chance = signed_noise(uint64_t(number), 17);
	const float shade = 1.0f + 0.14f * chance;
	const glm::vec3 tint = glm::mix(YOUNG_TINT, glm::vec3(1.0f), leaf.age) * shade;
	return { tint.x * (1.0f + 0.05f * signed_noise(uint64_t(number), 18)), tint.y, tint.z,
		0.85f + 0.15f * signed_noise(uint64_t(number), 19) };
}

void ClimberBuild::write_leaves(const ClimbChunk &chunk, int level, ClimberChunk &into) const {
	const float share = CLIMBER_LEVELS[size_t(level)].share;
	const size_t count = std::max(size_t(std::lround(share * float(chunk.leaves.size()))), size_t(1));
	const float scale = leaf_scale / std::sqrt(share);
	PackedFloat32Array &buffer = into.buffers[size_t(level)];
	buffer.resize(int64_t(count) * INSTANCE_FLOATS);
	float *to = buffer.ptrw();
	for (size_t i = 0; i < count; i++) {
		const int number = chunk.leaves[i];
		const ClimbLeaf &one = climb.leaves[size_t(number)];
		const Basis axes = axes_of(one, scale * one.size);
		for (int row = 0; row < 3; row++) {
			for (int column = 0; column < 3; column++) {
				*to++ = axes[row][column];
			}
			*to++ = one.place[row];
		}
		const glm::vec4 tint = tint_of(one, number);
		const float numbers[8] = { tint.x, tint.y, tint.z, tint.w, float(cells.of_leaves[size_t(number)]),
			std::floor(one.phase * PHASES), one.age, 0.0f };
		to = std::copy(numbers, numbers + 8, to);
	}
}

static MeshArrays arrays_of(const StemMesh &mesh) {
	PackedVector3Array positions, normals;
	PackedColorArray colors;
	PackedVector2Array uvs;
	PackedInt32Array indices;
	positions.resize(int64_t(mesh.positions.size()));
	normals.resize(int64_t(mesh.normals.size()));
	colors.resize(int64_t(mesh.colors.size()));
	uvs.resize(int64_t(mesh.uvs.size()));
	indices.resize(int64_t(mesh.indices.size()));
	std::copy(mesh.positions.begin(), mesh.positions.end(), reinterpret_cast<glm::vec3 *>(positions.ptrw()));
	std::copy(mesh.normals.begin(), mesh.normals.end(), reinterpret_cast<glm::vec3 *>(normals.ptrw()));
	std::copy(mesh.colors.begin(), mesh.colors.end(), reinterpret_cast<glm::vec4 *>(colors.ptrw()));
	std::copy(mesh.uvs.begin(), mesh.uvs.end(), reinterpret_cast<glm::vec2 *>(uvs.ptrw()));
	std::copy(mesh.indices.begin(), mesh.indices.end(), indices.ptrw());
	MeshArrays made;
	made.material = default_material();
	made.arrays.resize(Mesh::ARRAY_MAX);
	made.arrays[Mesh::ARRAY_VERTEX] = positions;
	made.arrays[Mesh::ARRAY_NORMAL] = normals;
	made.arrays[Mesh::ARRAY_COLOR] = colors;
	made.arrays[Mesh::ARRAY_TEX_UV] = uvs;
	made.arrays[Mesh::ARRAY_INDEX] = indices;
	return made;
}

void ClimberBuild::write_stems(const ClimbChunk &chunk, int level, ClimberChunk &into) {
	StemStyle style;
	if (level > 0) {
		style.sides = 3;
		style.tolerance = 0.012f;
		style.thinnest = 0.001f * FAR_STEMS;
	}
	const StemMesh mesh = build_stems(climb, chunk.stems, style);
	if (!mesh.indices.empty()) {
		into.stem_arrays[size_t(level)] = arrays_of(mesh);
		stem_vertices += level == 0 ? int(mesh.positions.size()) : 0;
	}
}

void ClimberBuild::build_chunks() {
	for (const ClimbChunk &chunk : divide_climb(climb, CHUNK_SIZE)) {
		ClimberChunk made;
		made.body = chunk.body;
		made.leaves = int(chunk.leaves.size());
		bool has_box = false;
		const auto include = [&](const glm::vec3 &place, float around) {
			const AABB box(to_godot(place - glm::vec3(around)), Vector3(1.0f, 1.0f, 1.0f) * (2.0f * around));
			made.box = has_box ? made.box.merge(box) : box;
			has_box = true;
		};
		for (const int leaf_number : chunk.leaves) {
			const ClimbLeaf &one = climb.leaves[size_t(leaf_number)];
			include(one.place, 2.0f * settings.leaf_reach * one.size);
		}
		for (const StemRun &run : chunk.stems) {
			for (int i = run.first; i < run.first + run.count; i++) {
				include(climb.points[size_t(i)].place, climb.points[size_t(i)].radius);
			}
		}
		for (int level = 0; level < CLIMBER_LEVEL_COUNT && made.leaves > 0; level++) {
			write_leaves(chunk, level, made);
		}
		for (int level = 0; level < STEM_LEVELS; level++) {
			write_stems(chunk, level, made);
		}
		chunks.push_back(std::move(made));
	}
}

void ClimberBuild::make_meshes() {
	for (size_t i = 0; i < leaf_arrays.size(); i++) {
		if (leaf_meshes[i].is_null() && !leaf_arrays[i].arrays.is_empty()) {
			leaf_meshes[i] = compact_arrays(leaf_arrays[i], reads_half_floats).make();
			leaf_arrays[i] = MeshArrays();
		}
	}
	for (ClimberChunk &chunk : chunks) {
		for (size_t i = 0; i < chunk.stems.size(); i++) {
			if (chunk.stems[i].is_null() && !chunk.stem_arrays[i].arrays.is_empty()) {
				chunk.stems[i] = chunk.stem_arrays[i].make();
				chunk.stem_arrays[i] = MeshArrays();
			}
		}
	}
}

} // namespace undergrowth
