#pragma once

#include "base/workers.hpp"
#include "field/build/field_ground.hpp"
#include "field/motion/prepared_motion.hpp"
#include "field/view/batch_plans.hpp"
#include "placement/edit_log.hpp"
#include "placement/placement.hpp"
#include "placement/plant_matches.hpp"

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

namespace undergrowth {

/// A copy of all inputs of a field's build, so that it can run on a worker thread.
struct BuildInput {
	bool places = true; ///< False: rebuilds only the styles of `existing`.
	PlacementRequest request;
	FieldGround ground;
	FieldSettings settings;
	FieldRenderSetup setup; ///< Sampled, without meshes.
	bool makes_meshes = true; ///< False: the owner makes them on the main thread.
	FieldWind wind; ///< At the start of the simulation: prototypes already move in it.
	std::vector<int> species_numbers; ///< New species in `setup` by old species.
	float tile_size = 16.0f; ///< m.
	bool draws_tiles = false; ///< No multimesh spans more than one tile.
	bool is_of_tiles = false; ///< Builds only `tiles`.
	std::vector<TileKey> tiles;
	std::vector<TileKey> rest; ///< Remaining tiles of the first build, built one by one, nearest first.
	double rest_plants = 0.0; ///< Approximate number of plants in those tiles.
	/// Styles are not measured, and have one coarse level: plants are shown early.
	bool is_draft = false;
	bool has_rest = false; ///< More tiles follow: `rest`, or those that a view distance adds.
	EditLog edits; ///< Their removed plants are not built.
	/// The generated plants before the build. Plants that exist again continue their motion.
	GeneratedChunks existing;
};

/// The result of a field's build.
struct FieldResult {
	FieldRenderSetup setup;
	double spacing = 1.0; ///< m.
	std::vector<PlantChunk> chunks;
	std::unique_ptr<PreparedMotion> motion; ///< Of `chunks`.
	std::vector<BatchPlan> plans;
	std::vector<PlantMatch> matches;
	PlacementFault fault = PlacementFault::none;

	/// Describes a fault that is found only when everything is placed. Empty: no fault.
	godot::String describe_fault() const;
};

/// A build of a field on one of the engine's worker threads. It reads only its input. Call it from the main thread.
class FieldBuild {
public:
	explicit FieldBuild(BuildInput &&with);
	~FieldBuild();
	FieldBuild(const FieldBuild &) = delete;
	FieldBuild &operator=(const FieldBuild &) = delete;

	void start();
	/// 0 to 1.
	float progress() const { return done.load(); }
	/// True if its plants need ground queries. resume() continues.
	bool needs_ground() const { return stage.load() == Stage::placed; }
	const FieldPlants &plants() const { return placed; }
	/// Continues, with heights and normals for all plants.
	void resume(std::vector<float> &&heights, std::vector<glm::vec3> &&normals);
	/// True if plans can be taken and materials made, while the thread still prepares the motion.
	bool is_planned() const { return stage.load() >= Stage::planned; }
	bool is_done() const { return stage.load() == Stage::done; }
	/// True if it places plants, not only rebuilds their styles.
	bool places() const { return input.places; }
	const std::vector<int> &species_numbers() const { return input.species_numbers; }
	/// True if the build contains this species of the present field.
	bool includes(int species) const {
		return size_t(species) < input.species_numbers.size() && input.species_numbers[size_t(species)] >= 0;
	}
	float tile_size() const { return input.tile_size; }
	bool is_of_tiles() const { return input.is_of_tiles; }
	const std::vector<TileKey> &tiles() const { return input.tiles; }
	const PlacementRequest &request() const { return input.request; }
	/// Call only if is_planned(): the setup of the result, which the thread no longer changes.
	FieldRenderSetup &setup() { return result.setup; }
	PlacementFault fault() const { return result.fault; }
	/// The next plan of the result, or null.
	const BatchPlan *next_plan() const { return result.plans.empty() ? nullptr : &result.plans.back(); }
	/// Removes the next plan.
	void leave_plan() { result.plans.pop_back(); }
	/// Discards the result and ends the thread's work early.
	void cancel() { is_cancelled = true; }
	/// Waits for the thread and returns the result.
	FieldResult &finish();
	/// Waits until no worker thread uses it.
	void wait();
	/// True if its plants are drafts, and another build refines their styles.
	bool is_draft() const { return input.is_draft; }
	/// True if it is only the first part of a build.
	bool has_rest() const { return input.has_rest; }
	double rest_plants() const { return input.rest_plants; }
	const std::vector<TileKey> &rest() const { return input.rest; }
	/// Adds an object to the garbage.
	void add_garbage(std::shared_ptr<void> object) { garbage.push_back(std::move(object)); }
	/// Returns a function that frees the garbage, the inputs and the unused parts of the result. Any thread may call
	/// it.
	std::function<void()> take_garbage();
	/// How far the owner has prepared the exchange.
	enum class Handover {
		none,
		dressed, ///< Its setup has materials, perhaps not all.
		shown, ///< Its setup has materials, and multimeshes are prepared.
		transferring, ///< The transfer of motion has begun.
	};
	Handover handover = Handover::none;

private:
	enum class Stage { fresh, placing, placed, building, planned, done };

	BuildInput input;
	std::vector<std::shared_ptr<void>> garbage;
	FieldResult result;
	FieldPlants placed;
	std::vector<float> heights;
	std::vector<glm::vec3> normals;
	std::atomic<float> done{ 0.0f };
	std::atomic<Stage> stage{ Stage::fresh };
	std::atomic<bool> is_cancelled{ false };
	int64_t task = Workers::NONE;

	static void work(void *self);
	void launch(Stage next);
	void place();
	void place_rows(const Placement &placement, float share_before, float share_after);
	void place_around();
	void compete_around();
	void apply_heights();
	/// Chooses the levels of all styles.
	void fit();
	void build();
};

} // namespace undergrowth
