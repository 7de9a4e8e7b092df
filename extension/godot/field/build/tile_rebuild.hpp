#pragma once

#include "field/build/field_tiles.hpp"

#include <memory>
#include <vector>

namespace undergrowth {

/// Rebuilds all tiles of a field one by one, while the remaining tiles stay unchanged. A tile is replaced in one frame,
/// when all of it is ready to be drawn. Main thread.
class TileRebuild {
public:
	using Scene = FieldTiles::Scene;

	/// Inputs besides those of FieldTiles.
	struct Way {
		FieldMotion &motion;
		bool joins = false; ///< Multimeshes wider than a tile stay until all tiles are joined.
	};

	/// Returns the tiles to rebuild from a request, nearest to the cameras last: all existing ones, and all new ones.
	/// Returns none if the tiles are too many or too empty, or the plants are too many. It also returns none if two
	/// plants would have the same id.
	static std::vector<TileKey> list(const Scene &scene, const PlacementRequest &request, const FieldTiles &tiles);
	/// Returns all tiles of a field that does not stream and has none yet, the nearest last. Returns none if they are
	/// too many or too empty to be built one by one.
	static std::vector<TileKey> list_first(const Scene &scene, const PlacementRequest &request);
	/// Starts to rebuild these tiles from a request, the last one first.
	void begin(std::vector<TileKey> &&tiles, const PlacementRequest &request);
	bool is_at_work() const { return !waiting.empty() || !jobs.empty(); }
	/// 0 to 1.
	float progress() const;
	/// Continues in a physics frame or another frame, as FieldTiles::resume().
	void resume(const Scene &scene, const Way &way, bool physics);
	/// The ground queries of all tiles.
	GroundQueryQueue &query_queue() { return ground_queue; }
	/// Waits for all worker jobs. The jobs themselves remain.
	void wait_for_jobs();
	/// Cancels all jobs. Their tiles start again later.
	void interrupt(const Scene &scene, FieldMotion &motion);
	/// The same for tiles that meet a box (m, field axes).
	void interrupt(const Scene &scene, FieldMotion &motion, const AreaBox &box);
	/// Cancels everything. Existing plants stay.
	void stop(const Scene &scene, FieldMotion &motion);
	/// Call after plants were removed from this tile.
	void note_removed(const TileKey &tile);

private:
	/// A tile in progress.
	struct PendingTile {
		std::unique_ptr<TileBuild> job;
		bool is_planned = false;
		bool lost_some = false; ///< Plants were removed meanwhile.
	};

	std::vector<TileKey> waiting; ///< Next last.
	size_t tile_count = 0; ///< At begin().
	std::vector<PendingTile> jobs;
	PlacementRequest base; ///< Without its map.
	double placed_at = 1.0; ///< m, spacing.
	std::shared_ptr<const FieldRenderSetup> outline;
	GroundQueryQueue ground_queue;
	const TileBuild *querying = nullptr;

	bool begin_one(const Scene &scene);
	void poll_ground(const Scene &scene, bool physics);
	/// Returns true if the tile is done.
	bool resume(const Scene &scene, const Way &way, PendingTile &pending, double until_usec, const Stopwatch &watch);
	void exchange(const Scene &scene, const Way &way, PendingTile &pending);
	void cancel(const Scene &scene, FieldMotion &motion, size_t number, bool again);
};

} // namespace undergrowth
