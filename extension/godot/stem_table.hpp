#pragma once

#include "motion/motion_species.hpp"
#include "plant_stem.hpp"
#include "sampled_plant.hpp"

#include <map>
#include <memory>

namespace undergrowth {

/// The stems of one species, solved once for each height that needs its own: where frequency is declared, for one
/// height, and where it follows from stiffness, for heights a tenth apart. Main thread.
class StemTable {
public:
	/// Forgets what was solved: the species changed.
	void clear();
	/// Whether `problem()` was told of.
	bool is_empty() const { return solved.empty(); }

	/// The stem of a plant of `height` metres. `drawn`: one of the species as it was sampled; `stem` may be null. Where
	/// nothing can stand so, that of a stem without load that swings as declared, and problem() says what is wrong.
	std::shared_ptr<const StemConstants> of(
			float height, const SampledPlant &drawn, const Motion &motion, const godot::Ref<PlantStem> &stem);
	/// In English; empty where all stems stand.
	const godot::String &problem() const { return fault; }

private:
	std::map<int, std::shared_ptr<const StemConstants>> solved; ///< By class of height.
	float reference = 0.0f; ///< m, the height of class 0.
	godot::String fault;

	int class_of(float height, bool is_physical) const;
};

} // namespace undergrowth
