#pragma once

#include "field/build/field_tiles.hpp"
#include "field/build/region_build.hpp"

#include <map>
#include <memory>
#include <set>
#include <vector>

namespace undergrowth {

/// The parts of an existing field that differ from what is painted, and the new plants that are not drawn yet. It owns
/// the job for some of them. Main thread.
class RegionBuilds {
public:
	/// For more tiles than this, building the whole field is faster.
	static constexpr size_t MAX_TILES = 64;

	/// The time of a call of resume().
	enum class Moment {
		physics, ///< In a physics frame: rays may be cast at the ground.
		begun, ///< In a frame, while plants do not move: new plants may be added to the store.
		ending, ///< During the next step, for which nothing may wait.
	};

	/// Marks a box (m, field axes) to be placed again, in tiles of `tile_size`.
	void touch(const AreaBox &box, float tile_size);
	/// Call if the whole field is placed again.
	void forget_touched() { touched.clear(); }
	/// Call if all multimeshes are made again.
	void forget_unseen() { unseen.clear(); }
	/// Cancels the job. Its boxes and chunks are processed again later.
	void interrupt();
	/// Waits until no worker thread uses the job.
	void wait_for_job() {
		if (job) {
			job->wait();
		}
	}
	bool is_at_work() const { return job || !touched.empty() || !unseen.empty(); }
	size_t touched_tiles() const { return touched.size(); }
	/// Removes marked boxes in tiles for which `exists` returns false.
	template <class Exists> void keep_only(const Exists &exists) {
		for (auto entry = touched.begin(); entry != touched.end();) {
			entry = exists(entry->first) ? std::next(entry) : touched.erase(entry);
		}
	}
	/// True if an edit of the store does not restart the job.
	bool allows_edits() const { return !job || job->is_drawing(); }
	/// Continues as far as possible: shows what is ready, and begins what is next. Only at the end of a frame it waits
	/// a part of a millisecond for plans. Ground queries take about `ground_usec`. Returns true if plants were added or
	/// removed.
	bool resume(const FieldTiles::Scene &scene, Moment moment, double ground_usec);
	/// Call after each edit of the store. Updates the chunks to draw, and restarts the job if necessary.
	void follow(const ChangeSet &changes, const PlantStore &store);

private:
	std::map<TileKey, AreaBox> touched;
	std::set<int> unseen; ///< Chunks.
	std::set<int> dropped; ///< Chunks dropped during the job.
	std::unique_ptr<RegionBuild> job;
	GroundQueryQueue ground_queue;
	float tile = 16.0f; ///< m.

	/// Takes the next boxes to place, until they contain a few thousand existing plants.
	std::vector<AreaBox> take_boxes(const PlantStore &store, ExistingPlants &existing);
	void begin(const FieldTiles::Scene &scene);
	void poll_ground(const FieldTiles::Scene &scene, bool physics, double usec);
	void apply_edit(const FieldTiles::Scene &scene);
	void draw(const FieldTiles::Scene &scene);
	void show(const FieldTiles::Scene &scene);
};

} // namespace undergrowth
