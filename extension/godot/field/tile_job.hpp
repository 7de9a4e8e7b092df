#pragma once

#include "field/field_ground.hpp"
#include "field/field_motion.hpp"
#include "field/field_view.hpp"
#include "stand/kept_plants.hpp"
#include "stand/placement.hpp"
#include "stand/stand_changes.hpp"

#include <atomic>
#include <memory>
#include <vector>

namespace undergrowth {

/// A copy of all inputs of a tile's build, so that it can run on a worker thread.
struct TileRecipe {
	TileKey tile;
	float tile_size = 16.0f; ///< m.
	PlacementRequest request; ///< Within the tile.
	FieldGround ground;
	double spacing = 1.0; ///< m, of the placement.
	StandChanges changes; ///< Their removed plants are not built.
	FilledBlocks standing; ///< The generated plants before the build. Plants that exist again continue their motion.
	FieldMotion::PrepareBlock prepare = nullptr;
	FieldSettings settings;
	std::shared_ptr<const FieldStyle> style; ///< For the plans.
};

/// A build of one tile on one of the engine's worker threads. In a tile without plants, its blocks are added one by
/// one, and a thread then plans how they are drawn. In a tile with plants, a thread plans first, and all blocks are
/// added at once.
class TileJob {
public:
	static constexpr int MAX_WORKING = 4; ///< Jobs of an owner on worker threads at the same time.
	static constexpr size_t MAX_JOBS = 16; ///< Jobs of an owner, including those that wait for the main thread.

	explicit TileJob(TileRecipe &&with);
	~TileJob();
	TileJob(const TileJob &) = delete;
	TileJob &operator=(const TileJob &) = delete;

	const TileKey &tile() const { return recipe.tile; }
	void start();
	/// True if a worker thread uses it, or will.
	bool is_at_work() const;
	/// Waits until no worker thread uses it.
	void wait();
	/// True if its plants need a survey of the ground. go_on() continues.
	bool wants_ground() const { return stage.load() == Stage::grounding; }
	const FieldPlants &plants() const { return placed; }
	void go_on(std::vector<float> &&heights, std::vector<glm::vec3> &&normals);

	/// True if its blocks may be taken.
	bool is_placed() const { return stage.load() == Stage::placed; }
	bool has_more_blocks() const { return taken < blocks.size(); }
	/// True if at least one block was taken.
	bool has_begun() const { return taken > 0; }
	/// Returns the next block for the store, with the block that the motion prepared.
	PlantBlock take_block(std::unique_ptr<PreparedBlock> &prepared);
	/// Sets the texels of the block that was taken last.
	void set_texels(const PoseTexels &texels) { places.push_back(texels); }
	/// Instead of these: reserves texels for all blocks before draw(), and then takes all blocks at once. give_up()
	/// releases the texels.
	void reserve(FieldMotion &motion);
	void give_up(FieldMotion &motion);
	void take_all(StandEdit &edit, ArrivingBlocks &arriving);
	/// Plans how the blocks are drawn. All of them must have texels.
	void draw();
	bool is_drawn() const { return stage.load() == Stage::drawn; }
	/// Returns the next plan, or null.
	const ClumpPlan *next_plan() { return shown < plans.size() ? &plans[shown++] : nullptr; }

private:
	enum class Stage { fresh, placing, grounding, standing, placed, drawing, drawn };

	TileRecipe recipe;
	FieldPlants placed;
	std::vector<float> heights;
	std::vector<glm::vec3> normals;
	std::vector<PlantBlock> blocks;
	std::vector<PlantBlock> copies; ///< Copies of `blocks`, for the plans.
	std::vector<std::unique_ptr<PreparedBlock>> prepared;
	std::vector<KeptPlant> kept;
	size_t taken = 0;
	std::vector<PoseTexels> places;
	std::vector<ClumpPlan> plans;
	size_t shown = 0;
	std::atomic<Stage> stage{ Stage::fresh };
	int64_t task = -1;

	static void work(void *self);
	void launch(Stage next);
	void stand();
	void plan();
};

} // namespace undergrowth
