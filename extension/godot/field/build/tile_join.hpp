#pragma once

#include "field/build/dirty_tiles.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace undergrowth {

/// Joins the multimeshes of tiles that were built one by one: where a level draws squares wider than a tile, these
/// replace the multimeshes of the tiles. Plants, motion, and chunks of new plants stay. Main thread.
class TileJoin {
public:
	using Scene = DirtyTiles::Scene;

	/// Starts with the present plants. None of their chunks may be dropped before the end, except by stop().
	void begin(const Scene &scene);
	/// Cancels it. What is joined stays joined.
	void stop(const Scene &scene);
	bool is_at_work() const { return stage != Stage::idle; }
	/// 0 to 1.
	float progress() const;
	/// Continues within the budget. Returns true if this call ended it.
	bool resume(const Scene &scene);
	/// Waits until no worker thread uses it.
	void wait() {
		if (task) {
			task->wait();
		}
	}

private:
	enum class Stage { idle, copying, planning, preparing, exchanging };

	Stage stage = Stage::idle;
	std::vector<ChunkToDraw> copies;
	int next = 0; ///< Next chunk, or next pair of level and species.
	std::unique_ptr<TileBuildTask> task;

	void enter(Stage into);
	bool copy_some(const Scene &scene, const Stopwatch &watch);
	bool prepare_some(const Scene &scene, const Stopwatch &watch);
	bool exchange_some(const Scene &scene, const Stopwatch &watch);
};

} // namespace undergrowth
