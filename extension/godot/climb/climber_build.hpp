#pragma once

#include "climb/climb_chunks.hpp"
#include "climb/climb_stems.hpp"
#include "climb/climber_supports.hpp"
#include "species/sampled_plant.hpp"

#include <godot_cpp/variant/aabb.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>

#include <array>
#include <string>
#include <vector>

namespace undergrowth {

/// A level of detail of a climber's leaves.
struct ClimberLevel {
	int segments; ///< Of the leaf's mesh.
	float share; ///< Of the leaves that are drawn, wider by its root.
	float leaf_pixels; ///< Begins where a leaf is that long; 0: where the error of its outline is below a pixel.
};

inline constexpr std::array<ClimberLevel, 5> CLIMBER_LEVELS = { { { 4, 1.0f, 0.0f }, { 3, 1.0f, 0.0f },
		{ 2, 1.0f, 0.0f }, { 2, 0.5f, 3.5f }, { 2, 0.25f, 1.75f } } };
inline constexpr int CLIMBER_LEVEL_COUNT = int(CLIMBER_LEVELS.size());
inline constexpr int STEM_LEVELS = 2;
inline constexpr int MAX_CLIMBER_CELLS = 1024;
inline constexpr int INSTANCE_FLOATS = 20; ///< Of a leaf in a multimesh: transform, colour and custom data.

/// What is drawn together.
struct ClimberChunk {
	int body = 0;
	godot::AABB box; ///< m, axes of growth.
	int leaves = 0;
	std::array<godot::PackedFloat32Array, CLIMBER_LEVEL_COUNT> buffers; ///< Of multimeshes, by level.
	std::array<godot::Ref<godot::ArrayMesh>, STEM_LEVELS> stems; ///< Null: none.
	std::array<MeshArrays, STEM_LEVELS> stem_arrays; ///< Until the meshes are made.
};

/// Grows a climber and makes all that is drawn of it: input, then results. run() is for a worker.
struct ClimberBuild {
	// Input.
	ClimbSettings settings; ///< `leaf_reach` is measured.
	std::vector<SupportFaces> faces;
	std::array<SampledPlant, CLIMBER_LEVEL_COUNT> leaf;
	float leaf_scale = 1.0f;
	bool makes_meshes = false; ///< run() may create meshes.
	bool reads_half_floats = true;

	// Results.
	std::string fault;
	Climb climb;
	ClimbCells cells;
	std::vector<ClimberChunk> chunks;
	std::array<godot::Ref<godot::ArrayMesh>, CLIMBER_LEVEL_COUNT> leaf_meshes;
	std::array<MeshArrays, CLIMBER_LEVEL_COUNT> leaf_arrays;
	std::array<float, CLIMBER_LEVEL_COUNT> begins = {}; ///< m from the camera.
	std::array<int, CLIMBER_LEVEL_COUNT> leaf_vertices = {};
	int stem_vertices = 0; ///< Of the finest level.
	double seconds = 0.0;

	void run();
	/// Creates the meshes that run() did not create. Main thread.
	void make_meshes();

private:
	void build_leaf();
	void build_chunks();
	void write_leaves(const ClimbChunk &chunk, int level, ClimberChunk &into) const;
	void write_stems(const ClimbChunk &chunk, int level, ClimberChunk &into);
};

} // namespace undergrowth
