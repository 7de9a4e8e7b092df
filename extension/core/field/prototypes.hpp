#pragma once

#include "motion/motion_page.hpp"

#include <cstdint>
#include <vector>

namespace undergrowth {

/// Whose motion a plant shows, and how much later.
struct Follower {
	uint16_t prototype = 0;
	uint16_t own_delay = 0; ///< Steps; the wind's way to the plant comes on top.
	uint16_t delay = 0; ///< Steps that it is shown late now; goes to where it should be without a jump.
	uint16_t loose = 0; ///< One more than its number among the LoosePlants while it swings by itself, or 0.
};

/// The few plants of a species that are simulated for all others (thesis, section 5.3.1), and what they did in the last
/// SLOTS steps. Lengths are spread from the species' shortest to its longest, lean directions around the circle.
class Prototypes {
public:
	static constexpr int MOST = 64;
	static constexpr int SLOTS = 1024; ///< A power of two.
	/// Delays from here on start over: they stay clear of the slot that is written next.
	static constexpr int LONGEST_DELAY = SLOTS - 64;

	/// `count` from 1 to MOST.
	Prototypes(int species_index, const MotionSpecies &species, int count, float step);

	int count() const { return page.size(); }
	/// The direction of a prototype in calm air.
	glm::vec3 rest(int prototype) const { return page.rest(prototype); }
	/// Picks a prototype that leans as `plant` does and a delay of up to OWN_DELAY, both by `hash`.
	Follower pick(const MotionPlant &plant, uint64_t hash) const;
	void set_species(const MotionSpecies &species) { page.set_species(species); }

	/// One step of all prototypes; what they do is written into the next slot.
	void step(const TravellingWind &wind, const PlantWinds &along);
	/// The bend after the step `delay` steps ago, 0 to LONGEST_DELAY.
	Bend bend(int prototype, int delay) const {
		const int slot = (newest - delay) & (SLOTS - 1);
		return ring[2 * static_cast<std::size_t>(slot * MOST + prototype) + 1];
	}

	/// All slots, MOST pairs of bends (before and after that step) each: 16 layers of 64 by 64 texels of four halves, a
	/// row for each slot. One slot changes with each step.
	const Bend *history() const { return ring.data(); }
	int newest_slot() const { return newest; }
	double wind_moment() const { return page.wind_moment(); }
	std::size_t bytes() const { return ring.capacity() * sizeof(Bend) + page.bytes(); }

private:
	MotionPage page;
	bool leans;
	int newest = 0;
	std::vector<Bend> ring;
};

} // namespace undergrowth
