#pragma once

#include "field/motion/field_motion.hpp"
#include "field/trodden_plants.hpp"

#include <vector>

namespace undergrowth {

/// The trodden plants of a field. The motion contains the lasting bends of existing plants; this class keeps those of
/// plants whose tile is not loaded, carries them over edits of tiles, and collects all for saving. Main thread.
class FieldTrampling {
public:
	/// Lets absent plants recover for `seconds` of simulated time.
	void advance(double seconds) { absent.advance(seconds); }
	/// Keeps the bends of chunks that an edit drops. Call after the store's apply() and before the motion's.
	void leave(const ChangeSet &changes, const FieldRenderSetup &setup, FieldMotion &motion);
	/// Restores the bends of plants that an edit or a build created.
	void arrive(const ChangeSet &changes, const PlantStore &store, FieldMotion &motion);
	/// Lets all absent plants recover at once.
	void forget_absent() { absent = TroddenPlants(); }
	/// All trodden plants, with ascending ids.
	std::vector<TroddenPlant> all(const PlantStore &store, const FieldRenderSetup &setup, FieldMotion &motion) const;
	/// Replaces all lasting bends. Plants that do not exist yet recover at the pace of the slowest species.
	void replace(const std::vector<TroddenPlant> &trodden, const PlantStore &store, const FieldRenderSetup &setup,
			FieldMotion &motion);

private:
	TroddenPlants absent;

	static void keep_chunk(
			int number, const PlantChunk &chunk, const FieldRenderSetup &setup, FieldMotion &motion, TroddenPlants &to);
	void restore(int number, int first, const PlantStore &store, FieldMotion &motion);
};

} // namespace undergrowth
