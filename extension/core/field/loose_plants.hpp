#pragma once

#include "motion/motion_page.hpp"

#include <cstdint>
#include <vector>

namespace undergrowth {

/// Plants of one species that follow a prototype, but were pushed or stirred: each swings by itself from what it
/// showed, and goes back bit by bit to what its prototype shows when it has rung down. How much they cost is bounded by
/// their number.
class LoosePlants {
public:
	/// At a time; whoever comes then is not moved. A layer of 64 by 64 texels.
	static constexpr int MOST = MotionPage::PAGE_PLANTS;
	static constexpr float ALONE = 3.0f; ///< s after the last push until it begins to go back.
	static constexpr float GOING_BACK = 1.5f; ///< s.

	LoosePlants(int species_index, const MotionSpecies &species, float step);

	/// Makes room for that many, MOST at most, so that add() does not allocate.
	void reserve(int plants);
	bool is_full() const { return count() == room; }
	int count() const { return swinging.size(); }
	void set_species(const MotionSpecies &species) { swinging.set_species(species); }
	/// Plant `index` of page `page`, in `state`, which showed the bends `before` a step ago; tells its number, which is
	/// the former count(). Only where it is not full.
	int add(const MotionPlant &plant, int page, int index, const MotionState &state, const ModeBends &before);
	/// The last one takes its number.
	void remove(int number);

	/// One step of all under `wind`.
	void step(const TravellingWind &wind, const PlantWinds &along) { swinging.step(wind, along); }
	/// Whether it will, at the next grow_older(), no longer swing alone.
	bool goes_back(int number) const {
		return static_cast<float>(places[static_cast<std::size_t>(number)].age + 1) * step_time > ALONE;
	}
	/// A step later than at the last push. Tells how much of `followed`, which its prototype shows, it shows from now
	/// on (0 to 1), and shows it.
	float grow_older(int number, const ModeBends &followed);
	/// A plant that is still moved swings on by itself, from what it shows.
	void hold(int number);
	/// Puts a plant that was pushed into a state.
	void push(int number, const MotionState &state);

	/// What it shows, which is not its own motion alone while it goes back.
	MotionState shown_state(int number) const;
	int page_of(int number) const { return places[static_cast<std::size_t>(number)].page; }
	int index_of(int number) const { return places[static_cast<std::size_t>(number)].index; }
	/// Swinging plants with their pairs of bends as they are shown.
	const MotionPage &page() const { return swinging; }
	std::size_t bytes() const { return swinging.bytes() + places.capacity() * sizeof(Place); }

private:
	struct Place {
		int page;
		uint16_t index;
		uint16_t age; ///< Steps since the last push.
	};

	MotionPage swinging;
	std::vector<Place> places;
	int room = 0;
	float step_time; ///< s.
};

} // namespace undergrowth
