#pragma once

#include "field/field_ground.hpp"
#include "field/field_motion.hpp"
#include "field/field_view.hpp"
#include "stand/kept_plants.hpp"
#include "stand/placement.hpp"
#include "stand/stand_changes.hpp"

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

namespace undergrowth {

/// A copy of all inputs of a field's build, so that it can run on a worker thread.
struct FieldRecipe {
	bool places = true; ///< False: rebuilds only the looks of `standing`.
	PlacementRequest request;
	FieldGround ground;
	FieldMotion::Prepare prepare = nullptr;
	FieldSettings settings;
	FieldStyle style; ///< Sampled, without meshes.
	bool makes_meshes = true; ///< False: the owner makes them on the main thread.
	FieldWind wind; ///< At the start of the simulation: prototypes already move in it.
	std::vector<int> species_numbers; ///< New species in `style` by old species.
	float tile_size = 16.0f; ///< m.
	bool draws_tiles = false; ///< No multimesh spans more than one tile.
	bool is_of_tiles = false; ///< Builds only `tiles`.
	std::vector<TileKey> tiles;
	std::vector<TileKey> rest; ///< Remaining tiles of the first build, built one by one, the nearest last.
	double rest_plants = 0.0; ///< Approximate number of plants in those tiles.
	bool has_rest = false; ///< More tiles follow: `rest`, or those of FieldTiles.
	StandChanges changes; ///< Their removed plants are not built.
	/// The generated plants before the build. Plants that exist again continue their motion.
	FilledBlocks standing;
};

/// The result of a field's build.
struct FieldResult {
	FieldStyle style;
	double spacing = 1.0; ///< m.
	std::vector<PlantBlock> blocks;
	std::unique_ptr<PreparedMotion> motion; ///< Of `blocks`.
	std::vector<ClumpPlan> plans;
	std::vector<KeptPlant> kept;
	PlacementFault fault = PlacementFault::none;

	/// Describes a fault that is found only when everything is placed. Empty: no fault.
	godot::String describe_fault() const;
};

/// A build of a field on one of the engine's worker threads. It reads only its recipe. Call it from the main thread.
class FieldFill {
public:
	explicit FieldFill(FieldRecipe &&with);
	~FieldFill();
	FieldFill(const FieldFill &) = delete;
	FieldFill &operator=(const FieldFill &) = delete;

	void start();
	/// 0 to 1.
	float progress() const { return done.load(); }
	/// True if its plants need a survey of the ground. go_on() continues.
	bool wants_ground() const { return stage.load() == Stage::placed; }
	const FieldPlants &plants() const { return placed; }
	/// Continues, with heights and normals for all plants.
	void go_on(std::vector<float> &&heights, std::vector<glm::vec3> &&normals);
	/// True if plans can be taken and materials made, while the thread still prepares the motion.
	bool is_planned() const { return stage.load() >= Stage::planned; }
	bool is_done() const { return stage.load() == Stage::done; }
	/// True if it places plants, not only rebuilds their looks.
	bool places() const { return recipe.places; }
	const std::vector<int> &species_numbers() const { return recipe.species_numbers; }
	/// True if the build contains this species of the present field.
	bool knows(int species) const {
		return size_t(species) < recipe.species_numbers.size() && recipe.species_numbers[size_t(species)] >= 0;
	}
	float tile_size() const { return recipe.tile_size; }
	bool is_of_tiles() const { return recipe.is_of_tiles; }
	const std::vector<TileKey> &tiles() const { return recipe.tiles; }
	const PlacementRequest &request() const { return recipe.request; }
	/// Call only if is_planned(): the style of the result, which the thread no longer changes.
	FieldStyle &style() { return result.style; }
	PlacementFault fault() const { return result.fault; }
	/// The next plan of the result, or null.
	std::unique_ptr<ClumpPlan> take_plan();
	/// Discards the result and ends the thread's work early.
	void cancel() { is_cancelled = true; }
	/// Waits for the thread and returns the result.
	FieldResult &finish();
	/// Waits until no worker thread uses it.
	void wait();
	/// True if it is only the first part of a build.
	bool has_rest() const { return recipe.has_rest; }
	double rest_plants() const { return recipe.rest_plants; }
	std::vector<TileKey> take_rest() { return std::move(recipe.rest); }
	/// Returns a function that frees the inputs and the unused parts of the result. Any thread may call it.
	std::function<void()> take_rubbish();
	bool is_dressed = false; ///< Its style has materials.
	bool is_handed_over = false; ///< The transfer of motion has begun.

private:
	enum class Stage { fresh, placing, placed, building, planned, done };

	FieldRecipe recipe;
	FieldResult result;
	FieldPlants placed;
	std::vector<float> heights;
	std::vector<glm::vec3> normals;
	std::atomic<float> done{ 0.0f };
	std::atomic<Stage> stage{ Stage::fresh };
	std::atomic<bool> is_cancelled{ false };
	int64_t task = -1;

	static void work(void *self);
	void launch(Stage next);
	void place();
	void place_rows(const Placement &placement, float share_before, float share_after);
	void stand_on_ground();
	void build();
};

} // namespace undergrowth
