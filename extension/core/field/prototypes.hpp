#pragma once

#include "field/follow_delays.hpp"
#include "motion/motion_page.hpp"

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// Prototype of a plant, and its delay.
struct Follower {
	uint16_t prototype = 0;
	uint16_t own_delay = 0; ///< Steps, in addition to the delay of the wind.
	uint16_t detached = 0; ///< 1 + its number in DetachedFollowers while it swings by itself, else 0.
};

/// The simulated plants of a species that all other plants follow (thesis, section 5.3.1), and the history of their
/// last SLOTS steps, for all modes. Lengths are spread from the species' shortest to its longest, lean directions
/// around the circle.
class Prototypes {
public:
	static constexpr int MAX_COUNT = 64;
	static constexpr int SLOTS = 1024; ///< A power of two.
	static constexpr int LONGEST_OWN_DELAY = 64; ///< Steps.

	/// `count` from 1 to MAX_COUNT.
	Prototypes(int species_index, const MotionSpecies &species, int count, float step);

	int count() const { return page.size(); }
	/// m.
	float length(int prototype) const { return page.length(prototype); }
	/// The direction of a prototype in calm air.
	glm::vec3 rest(int prototype) const { return page.rest(prototype); }
	/// MotionPlant::scale of a plant that followed a prototype.
	float scale_of(float plant_length) const { return scale_among(shortest, longest, plant_length); }
	/// The same for a species with lengths between these: they differ mainly by the scale.
	static float scale_among(float shortest, float longest, float length) {
		return 2.0f * length / (shortest + longest);
	}
	/// Picks a prototype with the lean of `plant`, or with about its height if frequencies depend on the height, and a
	/// delay of up to a second, both by `hash`.
	Follower pick(const MotionPlant &plant, uint64_t hash) const;
	/// Does not interrupt the motion; rest directions may change. Prototypes that are all at rest are so afterwards.
	void set_species(const MotionSpecies &species);

	/// As MotionPage::set_taller_plants().
	void set_taller_plants(const TallerPlants &plants) { page.set_taller_plants(plants); }

	/// Sets all prototypes and their history to rest.
	void settle();

	/// Steps all prototypes and writes their bends into the next slot.
	void step(const WindSnapshot &wind, const PlantWinds &along);
	/// Bend of a mode of a prototype (StemBends) `late` steps ago, `fraction` of a step after the newest one started:
	/// the same as undergrowth_late() in the shader. `late`: 0 to LONGEST_WAY + LONGEST_OWN_DELAY; these slots do not
	/// overlap the one that is written next. `mode`: below modes().
	BendWay way(int mode, int prototype, float late, float fraction) const;
	/// The same for the first mode, as a stereographic image.
	glm::vec2 bend(int prototype, float late, float fraction) const { return way(0, prototype, late, fraction).bend; }
	/// 2 if the second mode has a history of its own, else 1.
	int modes() const { return page.has_second_bends() ? 2 : 1; }
	/// Constants of the drawn modes.
	const StemConstants &stem_constants() const { return page.stem_constants(); }

	/// All slots of a mode, each with MAX_COUNT pairs of bends (before and after the step): 16 layers of 64 by 64
	/// texels of four halves, one row per slot. Each step changes one slot.
	const Bend *history(int mode) const { return rings[mode].data(); }
	int newest_slot() const { return newest; }
	double wind_moment() const { return page.wind_moment(); }
	std::size_t bytes() const { return (rings[0].capacity() + rings[1].capacity()) * sizeof(Bend) + page.bytes(); }

	static_assert(DelayPlane::LONGEST_WAY + LONGEST_OWN_DELAY < SLOTS - 2, "a slot is read that is written next");

private:
	MotionPage page;
	float shortest, longest, lean; ///< Values that were used to distribute the prototypes.
	int newest = 0;
	std::vector<Bend> rings[MAX_STEM_MODES]; ///< With one mode the second is empty.

	const Bend *newest_bends(int mode) const { return mode == 0 ? page.bends() : page.second_bends(); }
	void remember(int slot);
	void remember_rest();
	void divide_history();
	bool is_at_rest();
	int pick_tall(float length, uint64_t chance) const;
};

} // namespace undergrowth
