#pragma once

#include "field/motion/field_motion.hpp"
#include "placement/edit_log.hpp"

#include <vector>

namespace undergrowth {

/// The edits of a field's plants that survive every rebuild: removed plants and mown plants. Existing mown plants grow
/// back, some of them in each frame. Main thread.
class FieldEdits {
public:
	/// For placing plants.
	const EditLog &known() const { return edits; }
	/// Replaces all edits. Existing plants get their new heights at once.
	void replace(EditLog &&others, const PlantStore &store, const FieldRenderSetup &setup, FieldMotion &motion);

	/// Records plants as removed. Call before they are removed from the store.
	void note_removed(const PlantStore &store, const std::vector<PlantRef> &refs);
	/// Sets heights of plants, as fractions of their own heights.
	void mow(const std::vector<PlantRef> &refs, const std::vector<float> &shares, const PlantStore &store,
			const FieldRenderSetup &setup, FieldMotion &motion);
	/// Restores the recorded heights of the plants that an edit created.
	void follow(const ChangeSet &edit, const PlantStore &store, const FieldRenderSetup &setup, FieldMotion &motion);
	/// The same for all plants.
	void follow_all(const PlantStore &store, const FieldRenderSetup &setup, FieldMotion &motion);
	/// Grows all mown plants by a fraction of their own height. Some existing plants show it at once, the remaining
	/// ones in later frames. Returns true if a height changed.
	bool grow_back(double share, const PlantStore &store, const FieldRenderSetup &setup, FieldMotion &motion);

	/// Returns the height of a plant as a fraction of its own height.
	float share_of(const PlantStore &store, const PlantRef &ref) const;
	bool is_mown(const PlantStore &store, const PlantRef &ref) const { return share_of(store, ref) < 1.0f; }

private:
	/// An existing plant with a drawn height that still changes.
	struct Growing {
		PlantRef ref;
		double base = 0.0; ///< See MownPlant::base.
	};

	EditLog edits;
	std::vector<Growing> growing;
	size_t next = 0; ///< Index in `growing` of the next plant to update.

	void read_chunk(int chunk, const PlantStore &store, const FieldRenderSetup &setup, FieldMotion &motion);
	void forget_chunks(const std::vector<int> &chunks);
	void show(const Growing &plant, const PlantStore &store, const FieldRenderSetup &setup, FieldMotion &motion) const;
};

} // namespace undergrowth
