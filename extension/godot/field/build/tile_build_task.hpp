#pragma once

#include "base/workers.hpp"
#include "field/build/field_ground.hpp"
#include "field/motion/field_motion.hpp"
#include "field/view/batch_plans.hpp"
#include "placement/edit_log.hpp"
#include "placement/placement.hpp"
#include "placement/plant_matches.hpp"
#include "placement/region_diff.hpp"

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <vector>

namespace undergrowth {

/// A copy of all inputs for placing the plants of a tile, so that it can run on a worker thread.
struct TileBuildInput {
	TileKey tile;
	float tile_size = 16.0f; ///< m.
	/// Part of the tile (m, field axes) that is placed again while the rest stays. Empty: the whole tile.
	std::optional<AreaBox> part;
	PlacementRequest request; ///< Within the tile, or within `part`.
	FieldGround ground;
	double spacing = 1.0; ///< m, of the placement.
	EditLog edits; ///< Their removed plants are not built.
	/// Of a whole tile: its generated plants before the build. Plants that exist again continue their motion.
	GeneratedChunks existing;
	ExistingPlants existing_in_part;
	FieldSettings settings;
	std::shared_ptr<const FieldRenderSetup> setup; ///< For prepared chunks and plans.
};

/// A chunk to draw: a copy, with its number if it contains new plants of a live tile, else -1.
struct ChunkToDraw {
	int number = -1;
	PlantChunk chunk;
	PoseTexels texels;
};

/// The build of a tile on one of the engine's worker threads.
///
/// A whole tile is placed; then the owner reserves texels, a thread plans how the chunks are drawn, and one edit
/// replaces the tile. A part of a tile is placed and compared with the existing plants; its edit changes only plants
/// that differ. Another task then plans how the new plants of live tiles are drawn. Call it from the main thread.
class TileBuildTask {
public:
	explicit TileBuildTask(TileBuildInput &&with);
	/// For draw() only: chunks of new plants, that have texels.
	TileBuildTask(std::shared_ptr<const FieldRenderSetup> setup, std::vector<ChunkToDraw> &&new_chunks);
	~TileBuildTask() { wait(); }
	TileBuildTask(const TileBuildTask &) = delete;
	TileBuildTask &operator=(const TileBuildTask &) = delete;

	const TileKey &tile() const { return input.tile; }
	double spacing() const { return input.spacing; }
	/// The part of the tile that it places, or empty.
	const std::optional<AreaBox> &part() const { return input.part; }
	void start() { launch(Stage::placing); }
	/// True if a worker thread uses it, or will.
	bool is_at_work() const;
	/// Waits until the present stage ends, at most `usec`.
	void wait_a_little(double usec);
	/// Waits until no worker thread uses it.
	void wait();
	/// True if its plants need ground queries. resume() continues.
	bool needs_ground() const { return stage.load() == Stage::grounding; }
	const FieldPlants &plants() const { return placed; }
	void resume(std::vector<float> &&heights, std::vector<glm::vec3> &&normals);
	bool is_placed() const { return stage.load() == Stage::placed; }

	/// Reserves texels for all chunks of a whole tile, before draw(). release_texels() releases them.
	void reserve(FieldMotion &motion);
	void release_texels(FieldMotion &motion);
	/// Plans how the chunks are drawn.
	void draw() { launch(Stage::drawing); }
	bool is_drawn() const { return stage.load() == Stage::drawn; }
	/// Returns the next plan, or null if none is left.
	const BatchPlan *next_plan() const { return shown < plans.size() ? &plans[shown] : nullptr; }
	/// Frees the data of the next plan, which is no longer the next one.
	void leave_plan();
	const std::vector<ChunkToDraw> &chunks() const { return copies; }
	/// Number of plants of a whole tile, once they are placed.
	int plant_count() const { return built_count; }
	std::vector<BatchPlan> take_plans() { return std::move(plans); }

	/// Returns the edit that changes the tile. For a whole tile it replaces all generated plants, by `arriving`.
	StoreEdit take_edit(ArrivingChunks &arriving);
	/// True if it compares a part with plants of this chunk.
	bool compares_with(int chunk) const { return compared_chunks.count(chunk) > 0; }

private:
	enum class Stage { fresh, placing, grounding, finishing, placed, drawing, drawn };

	TileBuildInput input;
	FieldPlants placed; ///< Of a part: only new plants.
	std::unique_ptr<RegionDiff> diff; ///< Of a part.
	std::set<int> compared_chunks; ///< Of the existing plants of a part.
	std::vector<float> heights;
	std::vector<glm::vec3> normals;
	StoreEdit edit;
	int built_count = 0;
	std::vector<ChunkToDraw> copies;
	std::vector<std::unique_ptr<PreparedChunk>> prepared;
	std::vector<PlantMatch> matches;
	std::vector<BatchPlan> plans;
	size_t shown = 0;
	std::atomic<Stage> stage{ Stage::fresh };
	std::mutex stage_mutex;
	std::condition_variable stage_ended; ///< Signals the end of a stage.
	int64_t task = Workers::NONE;

	static void work(void *self);
	void launch(Stage next);
	Stage do_stage();
	void place();
	void finish_placing();
	void make_chunks();
	void plan();
};

} // namespace undergrowth
