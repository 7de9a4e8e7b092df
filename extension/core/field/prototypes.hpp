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
/// SLOTS steps. Stems of two modes show one, in the shape of a steady wind: a second one's history would take as much
/// again of the texture and of what the graphics card reads for each vertex. Lengths are spread from the species'
/// shortest to its longest, lean directions around the circle.
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
	/// What a plant that is `late` steps late shows of a prototype, `fraction` of a step after the newest one began, as
	/// a stereographic image: the same as undergrowth_late() in the shader. `late`: from 0 to the longest way and own
	/// delay together, whose slots are clear of the one that is written next.
	BendWay way(int prototype, float late, float fraction) const;
	glm::vec2 bend(int prototype, float late, float fraction) const { return way(prototype, late, fraction).bend; }

	/// All slots, MOST pairs of bends (before and after that step) each: 16 layers of 64 by 64 texels of four halves, a
	/// row for each slot. One slot changes with each step.
	const Bend *history() const { return ring.data(); }
	int newest_slot() const { return newest; }
	double wind_moment() const { return page.wind_moment(); }
	std::size_t bytes() const { return ring.capacity() * sizeof(Bend) + page.bytes(); }

	static_assert(DelayPlane::LONGEST_WAY + LONGEST_OWN_DELAY < SLOTS - 2, "a slot is read that is written next");

private:
	MotionPage page;
	float shortest, longest, lean; ///< As they were spread.
	int newest = 0;
	std::vector<Bend> ring;

	void remember_rest();
	int pick_tall(float length, uint64_t chance) const;
};

} // namespace undergrowth
