#pragma once

#include "field/build/field_ground.hpp"
#include "field/view/field_view.hpp"
#include "placement/edit_log.hpp"
#include "placement/placement.hpp"
#include "placement/region_diff.hpp"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <vector>

namespace undergrowth {

/// A copy of all inputs for placing plants again in some boxes, so that it can run on a worker thread.
struct RegionBuildInput {
	PlacementRequest request; ///< Of an area that contains the boxes, as far as plants may grow there.
	std::vector<AreaBox> boxes; ///< m, without overlap.
	FieldGround ground;
	EditLog edits; ///< Their removed plants are not built.
	ExistingPlants existing; ///< Existing plants in the boxes.
	double spacing = 1.0; ///< m, of the placement.
};

/// Copies the parts of a setup that plans and prepared chunks need.
FieldRenderSetup outline_of(const FieldRenderSetup &setup);

/// A copy of a chunk of new plants, with its texels and plans.
struct NewChunk {
	int number = -1;
	PlantChunk chunk;
	PoseTexels texels;
	std::vector<BatchPlan> plans;
};

/// A job on one of the engine's worker threads for some boxes of an existing field. It first finds the new and the
/// removed plants, then plans how the new ones are drawn.
class RegionBuild {
public:
	/// For draw() only: without an input.
	RegionBuild() = default;
	explicit RegionBuild(RegionBuildInput &&with);
	~RegionBuild();
	RegionBuild(const RegionBuild &) = delete;
	RegionBuild &operator=(const RegionBuild &) = delete;

	const std::vector<AreaBox> &boxes() const { return input.boxes; }
	void place();
	/// True if new plants need ground queries. resume() continues.
	bool needs_ground() const { return stage.load() == Stage::grounding; }
	const FieldPlants &plants() const { return new_plants; }
	void resume(std::vector<float> &&heights, std::vector<glm::vec3> &&normals);
	bool is_placed() const { return stage.load() == Stage::placed; }
	StoreEdit take_edit() { return std::move(edit); }
	/// Plans how chunks are drawn. Both arguments are copies.
	void draw(FieldRenderSetup &&with, std::vector<NewChunk> &&chunks);
	/// True if it plans or has planned how plants are drawn. It then has no edit.
	bool is_drawing() const { return stage.load() == Stage::drawing || is_drawn(); }
	bool is_drawn() const { return stage.load() == Stage::drawn; }
	const std::vector<NewChunk> &drawn() const { return chunks; }
	/// Waits until the present stage ends, at most `usec`.
	void wait_a_little(double usec);
	/// Waits until no worker thread uses it.
	void wait();

private:
	enum class Stage { fresh, placing, grounding, finishing, placed, drawing, drawn };

	RegionBuildInput input;
	FieldPlants new_plants;
	std::unique_ptr<RegionDiff> diff;
	std::vector<float> heights;
	std::vector<glm::vec3> normals;
	StoreEdit edit;
	FieldRenderSetup setup;
	std::vector<NewChunk> chunks;
	std::atomic<Stage> stage{ Stage::fresh };
	std::mutex stage_mutex;
	std::condition_variable stage_ended; ///< Signals the end of a stage.
	int64_t task = -1;

	static void work(void *self);
	Stage do_stage();
	void launch(Stage next);
	void find_new_plants();
	void make_edit();
	void plan();
};

} // namespace undergrowth
