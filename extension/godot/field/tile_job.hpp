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

/// All that growing one tile needs to know, copied, so that it may run beside the game.
struct TileRecipe {
	TileKey tile;
	float tile_size = 16.0f; ///< m.
	PlacementRequest request; ///< Within the tile.
	FieldGround ground;
	double spacing = 1.0; ///< m, of the placement.
	StandChanges changes; ///< Whoever is gone by them does not stand.
	FilledBlocks standing; ///< What stands there until then. Plants that stand again go on with their motion.
	FieldMotion::PrepareBlock prepare = nullptr;
	FieldSettings settings;
	std::shared_ptr<const FieldStyle> style; ///< What plans are made by.
};

/// Grows one tile of a field that stands, on one of the engine's worker threads. Where nobody stood its blocks then
/// stand one by one, and once all of them do, a thread plans how they are drawn; where somebody did, that is planned
/// first, and all of them come at once.
class TileJob {
public:
	static constexpr int MAX_WORKING = 4; ///< Jobs of an owner on worker threads at the same time.
	static constexpr size_t MAX_JOBS = 16; ///< Jobs of an owner, those included that wait for the main thread.

	explicit TileJob(TileRecipe &&with);
	~TileJob();
	TileJob(const TileJob &) = delete;
	TileJob &operator=(const TileJob &) = delete;

	const TileKey &tile() const { return recipe.tile; }
	void start();
	/// Whether a worker thread has it, or will.
	bool is_at_work() const;
	/// Until no worker thread has it.
	void wait();
	/// Plants wait for a survey of the ground.
	bool wants_ground() const { return stage.load() == Stage::grounding; }
	const FieldPlants &plants() const { return placed; }
	void go_on(std::vector<float> &&heights, std::vector<glm::vec3> &&normals);

	/// Blocks may be taken.
	bool is_placed() const { return stage.load() == Stage::placed; }
	bool has_more_blocks() const { return taken < blocks.size(); }
	/// Whether some of it stands.
	bool has_begun() const { return taken > 0; }
	/// The next one, to stand, with what the motion makes of it.
	PlantBlock take_block(std::unique_ptr<PreparedBlock> &prepared);
	/// Of the block that was taken last.
	void set_texels(const PoseTexels &texels) { places.push_back(texels); }
	/// Instead of that: texels for all of them, which the motion keeps for what is planned, and then all that comes.
	void reserve(FieldMotion &motion);
	void give_up(FieldMotion &motion);
	void take_all(StandEdit &edit, ArrivingBlocks &arriving);
	/// All of them stand, or have texels: plans how they are drawn.
	void draw();
	bool is_drawn() const { return stage.load() == Stage::drawn; }
	/// The next plan, or null.
	const ClumpPlan *next_plan() { return shown < plans.size() ? &plans[shown++] : nullptr; }

private:
	enum class Stage { fresh, placing, grounding, standing, placed, drawing, drawn };

	TileRecipe recipe;
	FieldPlants placed;
	std::vector<float> heights;
	std::vector<glm::vec3> normals;
	std::vector<PlantBlock> blocks;
	std::vector<PlantBlock> copies; ///< Of them, to be drawn.
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
