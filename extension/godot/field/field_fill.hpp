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

/// All that growing a field needs to know, copied, so that it may run beside the game.
struct FieldRecipe {
	bool places = true; ///< Or dresses anew what stands: `standing`.
	PlacementRequest request;
	FieldGround ground;
	FieldMotion::Prepare prepare = nullptr;
	FieldSettings settings;
	FieldStyle style; ///< Sampled, but without meshes.
	bool makes_meshes = true; ///< Else their owner does, on the main thread.
	FieldWind wind; ///< At the simulation's start: prototypes have felt it before.
	std::vector<int> species_numbers; ///< What species are in `style`, by what they were.
	float tile_size = 16.0f; ///< m.
	bool draws_tiles = false; ///< No multimesh is wider than a tile.
	bool is_of_tiles = false; ///< Only these tiles are filled:
	std::vector<TileKey> tiles;
	std::vector<TileKey> rest; ///< Tiles of the first build that follow one by one, the nearest last.
	double rest_plants = 0.0; ///< About as many plants as those tiles have.
	bool has_rest = false; ///< Other tiles follow: `rest`, or those of FieldTiles.
	StandChanges changes; ///< Whoever is gone by them does not stand.
	/// What was filled before. Plants that stand again go on with their motion.
	FilledBlocks standing;
};

/// A field that is grown.
struct FieldResult {
	FieldStyle style;
	double spacing = 1.0; ///< m.
	std::vector<PlantBlock> blocks;
	std::unique_ptr<PreparedMotion> motion; ///< Of these blocks.
	std::vector<ClumpPlan> plans;
	std::vector<KeptPlant> kept;
	PlacementFault fault = PlacementFault::none;

	/// What only shows when everything is placed.
	godot::String describe_fault() const;
};

/// Grows a field on one of the engine's worker threads, from a recipe and nothing else.
class FieldFill {
public:
	explicit FieldFill(FieldRecipe &&with);
	~FieldFill();
	FieldFill(const FieldFill &) = delete;
	FieldFill &operator=(const FieldFill &) = delete;

	void start();
	/// 0 to 1.
	float progress() const { return done.load(); }
	/// Plants wait for a survey of the ground; go_on() goes on.
	bool wants_ground() const { return stage.load() == Stage::placed; }
	const FieldPlants &plants() const { return placed; }
	/// On with it: heights and normals for all plants.
	void go_on(std::vector<float> &&heights, std::vector<glm::vec3> &&normals);
	/// Whether plans can be taken, and its style dressed, while the thread goes on with how plants move.
	bool is_planned() const { return stage.load() >= Stage::planned; }
	bool is_done() const { return stage.load() == Stage::done; }
	/// Whether what stands is placed anew.
	bool places() const { return recipe.places; }
	const std::vector<int> &species_numbers() const { return recipe.species_numbers; }
	/// Whether a species that the field has goes on in it.
	bool knows(int species) const {
		return size_t(species) < recipe.species_numbers.size() && recipe.species_numbers[size_t(species)] >= 0;
	}
	float tile_size() const { return recipe.tile_size; }
	bool is_of_tiles() const { return recipe.is_of_tiles; }
	const std::vector<TileKey> &tiles() const { return recipe.tiles; }
	const PlacementRequest &request() const { return recipe.request; }
	/// Where it is planned: the result's, which the thread changes no more.
	FieldStyle &style() { return result.style; }
	PlacementFault fault() const { return result.fault; }
	/// The next plan of the result, or null.
	std::unique_ptr<ClumpPlan> take_plan();
	/// Its result is not wanted any more.
	void cancel() { is_cancelled = true; }
	/// Waits for the thread.
	FieldResult &finish();
	/// Until no worker thread has it.
	void wait();
	/// Whether it is the first part of a build.
	bool has_rest() const { return recipe.has_rest; }
	double rest_plants() const { return recipe.rest_plants; }
	std::vector<TileKey> take_rest() { return std::move(recipe.rest); }
	/// Frees, wherever it is called, what was copied for the filling, and what nobody needs of the result.
	std::function<void()> take_rubbish();
	bool is_dressed = false; ///< Its style has materials.
	bool is_handed_over = false; ///< The motion of those who are kept is, or is on its way.

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
