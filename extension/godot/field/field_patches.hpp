#pragma once

#include "field/field_patch.hpp"

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

	/// What grows in a box (m, field axes) is to be placed anew, by tiles of `tile_size`.
	void touch(const AreaBox &box, float tile_size);
	/// The whole field is placed anew, from what is painted now.
	void forget_touched() { touched.clear(); }
	/// The whole field is drawn anew.
	void forget_unseen() { unseen.clear(); }
	/// Ends the job; what it was about is yet to be done.
	void interrupt();
	bool is_at_work() const { return job || !touched.empty() || !unseen.empty(); }
	size_t touched_tiles() const { return touched.size(); }
	/// Leaves away what is in tiles that do not stand.
	template <class Stands> void keep_only(const Stands &stands) {
		for (auto entry = touched.begin(); entry != touched.end();) {
			entry = stands(entry->first) ? std::next(entry) : touched.erase(entry);
		}
	}
	/// The next boxes to be placed, where there are any: so many that they hold no more than some thousand plants that
	/// stand.
	std::vector<AreaBox> take_boxes(const PlantStore &store, StandingPlants &standing);

	/// The job, or null.
	FieldPatch *current() const { return job.get(); }
	void start(PatchRecipe &&recipe);
	void finish() { job.reset(); }
	/// After each edit of the store: who is yet to be drawn, and whether the job has to begin anew.
	void follow(const ChangeSet &changes, const PlantStore &store);
	/// Draws all newcomers who are yet to be drawn, in the job, or in one that is for that only. False: there are none.
	bool draw(const FieldStyle &style, const PlantStore &store, const FieldMotion &motion);
	/// Whether a block that was to be drawn still stands.
	bool is_there(int block) const { return dropped.count(block) == 0; }

private:
	std::map<TileKey, AreaBox> touched;
	std::set<int> unseen; ///< Blocks.
	std::set<int> dropped; ///< While they were planned.
	std::unique_ptr<FieldPatch> job;
	float tile = 16.0f; ///< m.
};

} // namespace undergrowth
