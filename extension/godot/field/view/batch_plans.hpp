#pragma once

#include "field/motion/pose_texels.hpp"
#include "field/view/field_render_setup.hpp"
#include "field/view/near_square.hpp"
#include "placement/chunks.hpp"

#include <godot_cpp/variant/packed_float32_array.hpp>

#include <array>
#include <memory>
#include <tuple>
#include <vector>

namespace undergrowth {

/// In place of a level: squares of single plants, from which NearPlants and ShadowPlants draw.
constexpr int SQUARES = -1;

/// A square of the ground at one level of detail: one or more tiles wide, or a part of a tile. Plants that code added
/// have their own multimeshes, and so has each chunk of new plants. So the multimeshes of generated plants do not
/// change.
struct BatchKey {
	bool is_added;
	int level; ///< Or SQUARES.
	int factor; ///< Width in tiles.
	TileKey tile; ///< Of wider_tile() for that factor.
	int new_chunk = -1; ///< Number of a chunk of new plants, or -1.
	int part = -1; ///< Index of the part of a divided tile, or -1.

	bool operator<(const BatchKey &other) const {
		return std::tie(is_added, level, factor, tile, new_chunk, part) <
				std::tie(other.is_added, other.level, other.factor, other.tile, other.new_chunk, other.part);
	}
	/// True if only the part differs.
	bool is_beside(const BatchKey &other) const {
		return std::tie(is_added, level, factor, tile, new_chunk) ==
				std::tie(other.is_added, other.level, other.factor, other.tile, other.new_chunk);
	}
};

/// Number of steps of rank in which a multimesh's plants are counted.
constexpr int RANK_STEPS = 32;
using RankCounts = std::array<int, RANK_STEPS + 1>;
/// Largest factor by which the shader widens plants (undergrowth_width.gdshaderinc).
constexpr float MAX_WIDENING = 3.0f;

/// The data of one multimesh: plants of one square with one mesh, sorted by rank.
struct BatchPlan {
	BatchKey place;
	int species = 0;
	int group = 0; ///< Index of the mesh among those of the species at its level.
	int count = 0;
	int stride = 0; ///< Floats per plant.
	RankCounts rank_counts = {}; ///< Number of plants with a rank of at most i / RANK_STEPS.
	godot::PackedFloat32Array buffer;
	godot::AABB box; ///< Covers the largest deflection.
	godot::AABB roots; ///< Bounding box of the roots.
	std::shared_ptr<NearSquare> near; ///< Instead of the buffer, for SQUARES.
};

/// A chunk to be drawn.
struct DrawnChunk {
	PoseTexels texels;
	const PlantChunk *chunk;
	int new_chunk = -1; ///< Number of a chunk of new plants, or -1.
};

/// Plans the multimeshes of some chunks at all levels. On any thread.
std::vector<BatchPlan> plan_batches(const FieldRenderSetup &setup, const std::vector<DrawnChunk> &chunks);
/// The same at one level of detail, or only the squares of single plants.
std::vector<BatchPlan> plan_level(const FieldRenderSetup &setup, const std::vector<DrawnChunk> &chunks, int level);

} // namespace undergrowth
