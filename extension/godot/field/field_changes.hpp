#pragma once

#include "field/field_motion.hpp"
#include "stand/stand_changes.hpp"

#include <vector>

namespace undergrowth {

/// What code changed of a field's plants and stays changed, however they are placed anew: who is gone, and who is mown.
/// Those of them who stand grow back, some in each frame. Main thread.
class FieldChanges {
public:
	/// For those who place plants.
	const StandChanges &known() const { return changes; }
	/// Everything is otherwise from now on; who stands is so high at once.
	void replace(StandChanges &&others, const PlantStore &store, const FieldStyle &style, FieldMotion &motion);

	/// Before these plants are taken out of the store.
	void note_removed(const PlantStore &store, const std::vector<PlantPlace> &places);
	/// Plants are so high, each as a share of its own height.
	void mow(const std::vector<PlantPlace> &places, const std::vector<float> &shares, const PlantStore &store,
			const FieldStyle &style, FieldMotion &motion);
	/// Who came by an edit is as high as it was left.
	void follow(const ChangeSet &edit, const PlantStore &store, const FieldStyle &style, FieldMotion &motion);
	/// The same of all plants.
	void follow_all(const PlantStore &store, const FieldStyle &style, FieldMotion &motion);
	/// All that is mown grows by a share of its own height; a part of those who stand show it at once, the others in
	/// later frames. Tells whether any did.
	bool grow_back(double share, const PlantStore &store, const FieldStyle &style, FieldMotion &motion);

	/// How high a plant is, as a share of its own height.
	float share_of(const PlantStore &store, const PlantPlace &place) const;
	bool is_mown(const PlantStore &store, const PlantPlace &place) const { return share_of(store, place) < 1.0f; }

private:
	/// Who stands and is not shown as high as it is yet.
	struct Growing {
		PlantPlace place;
		double base = 0.0; ///< As MownPlant's.
	};

	StandChanges changes;
	std::vector<Growing> growing;
	size_t next = 0; ///< Of those, who is shown next.

	void look_at(int block, const PlantStore &store, const FieldStyle &style, FieldMotion &motion);
	void forget_blocks(const std::vector<int> &blocks);
	void show(const Growing &plant, const PlantStore &store, const FieldStyle &style, FieldMotion &motion) const;
};

} // namespace undergrowth
