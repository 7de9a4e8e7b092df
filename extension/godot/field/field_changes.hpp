#pragma once

#include "field/field_motion.hpp"
#include "stand/stand_changes.hpp"

#include <vector>

namespace undergrowth {

/// The edits of a field's plants that survive every rebuild: removed plants and mown plants. Existing mown plants grow
/// back, some of them in each frame. Main thread.
class FieldChanges {
public:
	/// For placing plants.
	const StandChanges &known() const { return changes; }
	/// Replaces all edits. Existing plants get their new heights at once.
	void replace(StandChanges &&others, const PlantStore &store, const FieldStyle &style, FieldMotion &motion);

	/// Records plants as removed. Call before they are removed from the store.
	void note_removed(const PlantStore &store, const std::vector<PlantPlace> &places);
	/// Sets heights of plants, as fractions of their own heights.
	void mow(const std::vector<PlantPlace> &places, const std::vector<float> &shares, const PlantStore &store,
			const FieldStyle &style, FieldMotion &motion);
	/// Restores the recorded heights of the plants that an edit created.
	void follow(const ChangeSet &edit, const PlantStore &store, const FieldStyle &style, FieldMotion &motion);
	/// The same for all plants.
	void follow_all(const PlantStore &store, const FieldStyle &style, FieldMotion &motion);
	/// Grows all mown plants by a fraction of their own height. Some existing plants show it at once, the remaining
	/// ones in later frames. Returns true if a height changed.
	bool grow_back(double share, const PlantStore &store, const FieldStyle &style, FieldMotion &motion);

	/// Returns the height of a plant as a fraction of its own height.
	float share_of(const PlantStore &store, const PlantPlace &place) const;
	bool is_mown(const PlantStore &store, const PlantPlace &place) const { return share_of(store, place) < 1.0f; }

private:
	/// An existing plant with a drawn height that still changes.
	struct Growing {
		PlantPlace place;
		double base = 0.0; ///< See MownPlant::base.
	};

	StandChanges changes;
	std::vector<Growing> growing;
	size_t next = 0; ///< Index in `growing` of the next plant to update.

	void look_at(int block, const PlantStore &store, const FieldStyle &style, FieldMotion &motion);
	void forget_blocks(const std::vector<int> &blocks);
	void show(const Growing &plant, const PlantStore &store, const FieldStyle &style, FieldMotion &motion) const;
};

} // namespace undergrowth
