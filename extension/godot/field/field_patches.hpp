#pragma once

#include "field/field_patch.hpp"
#include "field/field_tiles.hpp"

#include <map>
#include <memory>
#include <set>
#include <vector>

namespace undergrowth {

/// Where a field that stands is no longer as it is painted, which newcomers are yet to be drawn, and the job that goes
/// on for some of them. Main thread.
class FieldPatches {
public:
	/// More tiles than this are placed sooner by filling the whole field.
	static constexpr size_t MOST_TILES = 64;

	/// When it goes on.
	enum class Moment {
		physics, ///< The ground may be asked by rays.
		begun, ///< In a frame, while plants do not move: newcomers may stand.
		ending, ///< While the next step goes on, for which nothing is to wait.
	};

	/// What grows in a box (m, field axes) is to be placed anew, by tiles of `tile_size`.
	void touch(const AreaBox &box, float tile_size);
	/// The whole field is placed anew, from what is painted now.
	void forget_touched() { touched.clear(); }
	/// The whole field is drawn anew.
	void forget_unseen() { unseen.clear(); }
	/// Ends the job; what it was about is yet to be done.
	void interrupt();
	/// Until no worker thread has its job.
	void wait_for_job() {
		if (job) {
			job->wait();
		}
	}
	bool is_at_work() const { return job || !touched.empty() || !unseen.empty(); }
	size_t touched_tiles() const { return touched.size(); }
	/// Leaves away what is in tiles that do not stand.
	template <class Stands> void keep_only(const Stands &stands) {
		for (auto entry = touched.begin(); entry != touched.end();) {
			entry = stands(entry->first) ? std::next(entry) : touched.erase(entry);
		}
	}
	/// Whether the store may be edited without the job's having to begin anew.
	bool lets_others_edit() const { return !job || job->is_drawing(); }
	/// Goes on as far as it gets: what is ready is shown, and what is next begins. Only in the end of a frame it waits
	/// for what is being planned, for a part of a millisecond. Grounds are asked for about `ground_usec`. Whether
	/// plants came or went.
	bool go_on(const FieldTiles::Scene &scene, Moment moment, double ground_usec);
	/// After each edit of the store: who is yet to be drawn, and whether the job has to begin anew.
	void follow(const ChangeSet &changes, const PlantStore &store);

private:
	std::map<TileKey, AreaBox> touched;
	std::set<int> unseen; ///< Blocks.
	std::set<int> dropped; ///< While they were planned.
	std::unique_ptr<FieldPatch> job;
	GroundAsker asker;
	float tile = 16.0f; ///< m.

	/// The next boxes to be placed, where there are any: so many that they hold no more than some thousand plants that
	/// stand.
	std::vector<AreaBox> take_boxes(const PlantStore &store, StandingPlants &standing);
	void begin(const FieldTiles::Scene &scene);
	void ask_ground(const FieldTiles::Scene &scene, bool physics, double usec);
	void stand(const FieldTiles::Scene &scene);
	void draw(const FieldTiles::Scene &scene);
	void show(const FieldTiles::Scene &scene);
};

} // namespace undergrowth
