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
	/// Forgets everything: the species looks different.
	void clear() { *this = StemTable(); }
	/// Forgets what it solved, but not what its plants look like: they move otherwise.
	void forget_stems();
	/// Whether it knows what its plants look like. It has to, before it is asked.
	bool knows_plants() const { return drawn.length > 0.0f; }
	/// Takes over what one of them, of the species' own height, says of its stem.
	void learn(const SampledPlant &plant);

	/// The stem of a plant of `height` metres, one of the species' own where that is 0; `stem` may be null. Where
	/// nothing can stand so, that of a bare stem that swings at about 1.5 Hz, and problem() says what is wrong.
	/// `in_air`: a wind in m/s bends it, which gives it another shape than newtons do.
	std::shared_ptr<const StemConstants> of(
			float height, bool in_air, const Motion &motion, const godot::Ref<PlantStem> &stem);
	/// In English; empty where all stems stand.
	const godot::String &problem() const { return fault; }

private:
	struct Stem {
		std::shared_ptr<const StemConstants> in_newtons, in_air;
	};
	std::map<int, Stem> solved; ///< By class of height; 0 is that of `drawn`.
	StemBeam drawn = nothing();
	godot::String fault;
	float usual = 0.0f; ///< What the usual wind weight comes to, that of `drawn` for all heights; 0: not known yet.

	static StemBeam nothing();
	StemConstants solve(int number, const Motion &motion, const godot::Ref<PlantStem> &stem);
};

} // namespace undergrowth
