#pragma once

#include "field/field_ground.hpp"
#include "field/field_view.hpp"
#include "stand/placement.hpp"
#include "stand/stand_changes.hpp"
#include "stand/stand_patch.hpp"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <vector>

namespace undergrowth {

/// All that placing plants anew in some boxes needs to know, copied, so that it may run beside the game.
struct PatchRecipe {
	PlacementRequest request; ///< Of an area that holds the boxes, or what may stand of them.
	std::vector<AreaBox> boxes; ///< m; no two of them share a place.
	FieldGround ground;
	StandChanges changes; ///< Whoever is gone by them does not stand.
	StandingPlants standing; ///< In these boxes.
	double spacing = 1.0; ///< m: of the placement.
};

/// Of a style, what plans are made by and blocks are prepared by.
FieldStyle outline_of(const FieldStyle &style);

/// A block of newcomers, copied, and how it is drawn.
struct DrawnNewcomers {
	int number = -1;
	PlantBlock block;
	PoseTexels texels;
	std::vector<ClumpPlan> plans;
};

/// Finds, on one of the engine's worker threads, who comes and who goes in some boxes of a field that stands; and then,
/// once they stand, how they are drawn.
class FieldPatch {
public:
	/// What is only to be drawn has no recipe.
	FieldPatch() = default;
	explicit FieldPatch(PatchRecipe &&with);
	~FieldPatch();
	FieldPatch(const FieldPatch &) = delete;
	FieldPatch &operator=(const FieldPatch &) = delete;

	const std::vector<AreaBox> &boxes() const { return recipe.boxes; }
	void place();
	/// Newcomers wait for a survey of the ground.
	bool wants_ground() const { return stage.load() == Stage::grounding; }
	const FieldPlants &plants() const { return newcomers; }
	void go_on(std::vector<float> &&heights, std::vector<glm::vec3> &&normals);
	bool is_placed() const { return stage.load() == Stage::placed; }
	StandEdit take_edit() { return std::move(edit); }
	/// Plans how blocks are drawn. `with` is a copy, too.
	void draw(FieldStyle &&with, std::vector<DrawnNewcomers> &&blocks);
	/// Nobody comes by it any more.
	bool is_drawing() const { return stage.load() == Stage::drawing || is_drawn(); }
	bool is_drawn() const { return stage.load() == Stage::drawn; }
	const std::vector<DrawnNewcomers> &drawn() const { return blocks; }
	/// Waits until the stage that goes on is over, but no longer than so many µs.
	void wait_a_little(double usec);
	/// Until no worker thread has it.
	void wait();

private:
	enum class Stage { fresh, placing, grounding, standing, placed, drawing, drawn };

	PatchRecipe recipe;
	FieldPlants newcomers;
	std::unique_ptr<StandPatch> patch;
	std::vector<float> heights;
	std::vector<glm::vec3> normals;
	StandEdit edit;
	FieldStyle style;
	std::vector<DrawnNewcomers> blocks;
	std::atomic<Stage> stage{ Stage::fresh };
	std::mutex telling;
	std::condition_variable told; ///< That a stage is over.
	int64_t task = -1;

	static void work(void *self);
	Stage do_stage();
	void launch(Stage next);
	void find_newcomers();
	void stand();
	void plan();
};

} // namespace undergrowth
