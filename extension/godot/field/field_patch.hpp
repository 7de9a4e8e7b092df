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

/// A copy of all inputs for placing plants again in some boxes, so that it can run on a worker thread.
struct PatchRecipe {
	PlacementRequest request; ///< Of an area that contains the boxes, as far as plants may grow there.
	std::vector<AreaBox> boxes; ///< m, without overlap.
	FieldGround ground;
	StandChanges changes; ///< Their removed plants are not built.
	StandingPlants standing; ///< Existing plants in the boxes.
	double spacing = 1.0; ///< m, of the placement.
};

/// Copies the parts of a style that plans and prepared blocks need.
FieldStyle outline_of(const FieldStyle &style);

/// A copy of a block of new plants, with its texels and plans.
struct DrawnNewcomers {
	int number = -1;
	PlantBlock block;
	PoseTexels texels;
	std::vector<ClumpPlan> plans;
};

/// A job on one of the engine's worker threads for some boxes of an existing field. It first finds the new and the
/// removed plants, then plans how the new ones are drawn.
class FieldPatch {
public:
	/// For draw() only: without a recipe.
	FieldPatch() = default;
	explicit FieldPatch(PatchRecipe &&with);
	~FieldPatch();
	FieldPatch(const FieldPatch &) = delete;
	FieldPatch &operator=(const FieldPatch &) = delete;

	const std::vector<AreaBox> &boxes() const { return recipe.boxes; }
	void place();
	/// True if new plants need a survey of the ground. go_on() continues.
	bool wants_ground() const { return stage.load() == Stage::grounding; }
	const FieldPlants &plants() const { return newcomers; }
	void go_on(std::vector<float> &&heights, std::vector<glm::vec3> &&normals);
	bool is_placed() const { return stage.load() == Stage::placed; }
	StandEdit take_edit() { return std::move(edit); }
	/// Plans how blocks are drawn. Both arguments are copies.
	void draw(FieldStyle &&with, std::vector<DrawnNewcomers> &&blocks);
	/// True if it plans or has planned how plants are drawn. It then has no edit.
	bool is_drawing() const { return stage.load() == Stage::drawing || is_drawn(); }
	bool is_drawn() const { return stage.load() == Stage::drawn; }
	const std::vector<DrawnNewcomers> &drawn() const { return blocks; }
	/// Waits until the present stage ends, at most `usec`.
	void wait_a_little(double usec);
	/// Waits until no worker thread uses it.
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
	std::condition_variable told; ///< Signals the end of a stage.
	int64_t task = -1;

	static void work(void *self);
	Stage do_stage();
	void launch(Stage next);
	void find_newcomers();
	void stand();
	void plan();
};

} // namespace undergrowth
