#pragma once

#include "field/follow_delays.hpp"
#include "motion/motion_page.hpp"

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// Whose motion a plant shows, and how much later.
struct Follower {
	uint16_t prototype = 0;
	uint16_t own_delay = 0; ///< Steps; the wind's way to the plant comes on top.
	uint16_t loose = 0; ///< One more than its number among the LoosePlants while it swings by itself, or 0.
};

/// The few plants of a species that are simulated for all others (thesis, section 5.3.1), and what they did in the last
/// SLOTS steps, all modes of their stems. Lengths are spread from the species' shortest to its longest, lean directions
/// around the circle.
class Prototypes {
public:
	static constexpr int MOST = 64;
	static constexpr int SLOTS = 1024; ///< A power of two.
	static constexpr int LONGEST_OWN_DELAY = 64; ///< Steps.

	/// `count` from 1 to MOST.
	Prototypes(int species_index, const MotionSpecies &species, int count, float step);

	int count() const { return page.size(); }
	/// m.
	float length(int prototype) const { return page.length(prototype); }
	/// The direction of a prototype in calm air.
	glm::vec3 rest(int prototype) const { return page.rest(prototype); }
	/// Picks a prototype that leans as `plant` does, or is about as tall where stems swing by their height, and a delay
	/// of up to a second, both by `hash`.
	Follower pick(const MotionPlant &plant, uint64_t hash) const;
	/// The motion goes on, about other rest directions where those change.
	void set_species(const MotionSpecies &species);

	/// All at rest, now and in all that is remembered.
	void settle();

	/// One step of all prototypes; what they do is written into the next slot.
	void step(const TravellingWind &wind, const PlantWinds &along);
	/// What a plant that is `late` steps late shows of a mode of a prototype (StemBends), `fraction` of a step after
	/// the newest one began: the same as undergrowth_late() in the shader. `late`: from 0 to the longest way and own
	/// delay together, whose slots are clear of the one that is written next. `mode`: below modes().
	BendWay way(int mode, int prototype, float late, float fraction) const;
	/// Of the first mode, as a stereographic image.
	glm::vec2 bend(int prototype, float late, float fraction) const { return way(0, prototype, late, fraction).bend; }
	/// 2 where a second mode of their stems has a history of its own, else 1.
	int modes() const { return page.has_second_bends() ? 2 : 1; }
	/// Of the modes that are shown.
	const StemConstants &stem_constants() const { return page.stem_constants(); }

	/// All slots of a mode, MOST pairs of bends (before and after that step) each: 16 layers of 64 by 64 texels of four
	/// halves, a row for each slot. One slot changes with each step.
	const Bend *history(int mode) const { return rings[mode].data(); }
	int newest_slot() const { return newest; }
	double wind_moment() const { return page.wind_moment(); }
	std::size_t bytes() const { return (rings[0].capacity() + rings[1].capacity()) * sizeof(Bend) + page.bytes(); }

	static_assert(DelayPlane::LONGEST_WAY + LONGEST_OWN_DELAY < SLOTS - 2, "a slot is read that is written next");

private:
	MotionPage page;
	float shortest, longest, lean; ///< As they were spread.
	int newest = 0;
	std::vector<Bend> rings[MOST_STEM_MODES]; ///< Of one mode: the other is empty.

	const Bend *newest_bends(int mode) const { return mode == 0 ? page.bends() : page.second_bends(); }
	void remember(int slot);
	void remember_rest();
	void divide_history();
	int pick_tall(float length, uint64_t chance) const;
};

} // namespace undergrowth
