#pragma once

#include "field/build/field_ground.hpp"
#include "field/motion/field_motion.hpp"
#include "field/view/field_view.hpp"
#include "placement/edit_log.hpp"
#include "placement/placement.hpp"
#include "placement/plant_matches.hpp"

#include <atomic>
#include <memory>
#include <vector>

namespace undergrowth {

/// A copy of all inputs of a tile's build, so that it can run on a worker thread.
struct TileBuildInput {
	TileKey tile;
	float tile_size = 16.0f; ///< m.
	PlacementRequest request; ///< Within the tile.
	FieldGround ground;
	double spacing = 1.0; ///< m, of the placement.
	EditLog edits; ///< Their removed plants are not built.
	GeneratedChunks existing; ///< The generated plants before the build. Plants that exist again continue their motion.
	FieldMotion::PrepareChunk prepare = nullptr;
	FieldSettings settings;
	std::shared_ptr<const FieldRenderSetup> setup; ///< For the plans.
};

/// The build of one tile. Owns its input and its result: chunks, prepared motion, and plans of multimeshes. Worker
/// threads do the work; the main thread calls all methods.
///
/// 1. start() places plants. If needs_ground(), resume() continues with the heights.
/// 2. A new tile, when is_placed(): take_chunk() and set_texels() for each chunk, then draw().
///    A tile that replaces another one: reserve(), then draw().
/// 3. When is_drawn(): next_plan() returns the plans. A replaced tile is exchanged with take_all() in one frame.
class TileBuild {
public:
	static constexpr int MAX_WORKING = 4; ///< Jobs of an owner on worker threads at the same time.
	static constexpr size_t MAX_JOBS = 16; ///< Jobs of an owner, including those that wait for the main thread.

	explicit TileBuild(TileBuildInput &&with);
	~TileBuild();
	TileBuild(const TileBuild &) = delete;
	TileBuild &operator=(const TileBuild &) = delete;

	const TileKey &tile() const { return input.tile; }
	void start();
	/// True if a worker thread uses it, or will.
	bool is_at_work() const;
	/// Waits until no worker thread uses it.
	void wait();
	/// True if its plants need ground queries. resume() continues.
	bool needs_ground() const { return stage.load() == Stage::grounding; }
	const FieldPlants &plants() const { return placed; }
	void resume(std::vector<float> &&heights, std::vector<glm::vec3> &&normals);

	/// True if its chunks may be taken.
	bool is_placed() const { return stage.load() == Stage::placed; }
	bool has_more_chunks() const { return taken < chunks.size(); }
	/// True if at least one chunk was taken.
	bool has_begun() const { return taken > 0; }
	/// Returns the next chunk for the store, with the chunk that the motion prepared.
	PlantChunk take_chunk(std::unique_ptr<PreparedChunk> &prepared);
	/// Sets the texels of the chunk that was taken last.
	void set_texels(const PoseTexels &texels) { places.push_back(texels); }
	/// Alternative to take_chunk() and set_texels(): reserve() takes texels for all chunks before draw(), take_all()
	/// moves all chunks into one edit, and release_texels() returns the texels if that does not happen.
	void reserve(FieldMotion &motion);
	void release_texels(FieldMotion &motion);
	void take_all(StoreEdit &edit, ArrivingChunks &arriving);
	/// Plans how the chunks are drawn. All of them must have texels.
	void draw();
	bool is_drawn() const { return stage.load() == Stage::drawn; }
	/// Returns the next plan, or null.
	const BatchPlan *next_plan() { return shown < plans.size() ? &plans[shown++] : nullptr; }

private:
	enum class Stage { fresh, placing, grounding, finishing, placed, drawing, drawn };

	TileBuildInput input;
	FieldPlants placed;
	std::vector<float> heights;
	std::vector<glm::vec3> normals;
	std::vector<PlantChunk> chunks;
	std::vector<PlantChunk> copies; ///< Copies of `chunks`, for the plans.
	std::vector<std::unique_ptr<PreparedChunk>> prepared;
	std::vector<PlantMatch> matches;
	size_t taken = 0;
	std::vector<PoseTexels> places;
	std::vector<BatchPlan> plans;
	size_t shown = 0;
	std::atomic<Stage> stage{ Stage::fresh };
	int64_t task = -1;

	static void work(void *self);
	void launch(Stage next);
	void make_chunks();
	void plan();
};

} // namespace undergrowth
