#pragma once

#include "motion/motion_page.hpp"

#include <cstdint>
#include <vector>

namespace undergrowth {

/// The detached followers of one species: plants that normally replay a prototype's motion, but are simulated for some
/// seconds after a push or in disturbed air. Each starts from its drawn pose. ALONE seconds after the last push it
/// blends back to its prototype over GOING_BACK seconds. Owns a MotionPage with these plants. MAX_COUNT bounds the
/// cost.
///
/// A plant has a number from 0 to count() - 1; remove() changes the number of the last plant. No function but reserve()
/// allocates. Not thread-safe.
class DetachedFollowers {
public:
	/// Maximum number of plants, a layer of 64 by 64 texels. Pushes on further plants have no effect.
	static constexpr int MAX_COUNT = MotionPage::PAGE_PLANTS;
	static constexpr float ALONE = 3.0f; ///< s from the last push until blending back starts.
	static constexpr float GOING_BACK = 1.5f; ///< s.

	DetachedFollowers(int species_index, const MotionSpecies &species, float step);

	/// Reserves room for `plants`, at most MAX_COUNT, so that add() does not allocate.
	void reserve(int plants);
	bool is_full() const { return count() == room; }
	int count() const { return swinging.size(); }
	void set_species(const MotionSpecies &species) { swinging.set_species(species); }
	/// Adds plant `index` of page `page` in `state`, with its bends `before` the last step. Returns its number, the
	/// former count(). Precondition: not is_full().
	int add(const MotionPlant &plant, int page, int index, const MotionState &state, const ModeBends &before);
	/// Removes a plant. The last plant gets its number.
	void remove(int number);

	/// Advances all plants by one step in `wind`. `along`: the wind's directions in the field's axes.
	void step(const WindSnapshot &wind, const PlantWinds &along) { swinging.step(wind, along); }
	/// True if the plant starts to blend back at the next grow_older().
	bool goes_back(int number) const {
		return static_cast<float>(places[static_cast<std::size_t>(number)].age + 1) * step_time > ALONE;
	}
	/// Ages a plant by one step. Returns the weight (0 to 1) of its prototype's bends `followed`, and blends them in.
	float grow_older(int number, const ModeBends &followed);
	/// Restarts the time of a plant that is still pushed, from its drawn pose.
	void hold(int number);
	/// Sets the state of a pushed plant.
	void push(int number, const MotionState &state);

	/// The drawn state, which includes the blend to the prototype.
	MotionState shown_state(int number) const;
	int page_of(int number) const { return places[static_cast<std::size_t>(number)].page; }
	int index_of(int number) const { return places[static_cast<std::size_t>(number)].index; }
	/// The simulated plants with their drawn bends.
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
