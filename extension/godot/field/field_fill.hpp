#pragma once

#include "field/field_bends.hpp"
#include "field/field_drawing.hpp"
#include "field/field_ground.hpp"
#include "field/placement.hpp"

#include <atomic>
#include <memory>
#include <vector>

namespace undergrowth {

/// How plants of a field come to be: all that a fill needs to know, copied, so that it may run beside the game.
struct FieldRecipe {
	PlacementRequest request;
	FieldSettings settings;
	FieldStyle style; ///< Sampled, but without meshes.
	FieldGround ground;
	FieldWind wind; ///< At the simulation's start: prototypes have felt it before.
	float chunk_size = 16.0f; ///< m.
};

/// A field that is done.
struct FieldResult {
	FieldStyle style;
	FieldPatch patch;
	std::unique_ptr<FieldSimulation> simulation;
	std::unique_ptr<FieldBends> bends;
	std::vector<ClumpPlan> plans;
};

/// How far plants of each species reach at scale and height 1 (m), for sort_into_chunks().
std::vector<float> reaches(const FieldStyle &style);

/// Fills a field on one of the engine's worker threads.
class FieldFill {
public:
	explicit FieldFill(FieldRecipe &&with);
	~FieldFill();
	FieldFill(const FieldFill &) = delete;
	FieldFill &operator=(const FieldFill &) = delete;

	void start();
	/// 0 to 1.
	float progress() const { return done.load(); }
	/// Plants wait on the ground for rays, which only the main thread may cast; finish() goes on.
	bool wants_ground() const { return stage.load() == Stage::placed; }
	FieldPlants &plants() { return result.patch.plants; }
	const FieldRecipe &made_by() const { return recipe; }
	/// On with it: heights and normals for all plants.
	void go_on(std::vector<float> &&heights, std::vector<glm::vec3> &&normals);
	bool is_done() const { return stage.load() == Stage::done; }
	/// Waits for the thread.
	FieldResult &finish();

private:
	enum class Stage { fresh, placing, placed, building, done };

	FieldRecipe recipe;
	FieldResult result;
	std::vector<float> heights;
	std::vector<glm::vec3> normals;
	std::atomic<float> done{ 0.0f };
	std::atomic<Stage> stage{ Stage::fresh };
	std::atomic<bool> is_cancelled{ false };
	int64_t task = -1;

	static void work(void *self);
	void launch(Stage next);
	void wait();
	void place();
	void stand();
	void build();
};

} // namespace undergrowth
