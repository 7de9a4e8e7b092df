#include "field/prototypes.hpp"

#include "base/portable_math.hpp"
#include "base/random.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace undergrowth {

namespace {

constexpr float OWN_DELAY = 1.0f; // s; about one swing, so that followers of one prototype have any phase of it.
/// A plant that leans follows one of the prototypes within this share of the circle.
constexpr int LEAN_SECTORS = 8;
constexpr int TALL_SECTORS = 8;
constexpr int OWN_STRIDE = 37; ///< Odd, so that prototypes of one length or lean have different frequencies.

/// Direction of the lean of `rest`, as a share of the circle from +z towards +x: its octant and the tangent within it.
/// This is even enough and needs no arc tangent.
float lean_share(const glm::vec3 &rest) {
	const float sum = std::fabs(rest.x) + std::fabs(rest.z);
	if (sum <= 0.0f) {
		return 0.0f;
	}
	const float diamond = 1.0f - rest.z / sum; // From 0 at +z to 2 at -z.
	return 0.25f * (rest.x >= 0.0f ? diamond : 4.0f - diamond);
}

std::vector<MotionPlant> spread_plants(const MotionSpecies &species, int count) {
	std::vector<MotionPlant> plants(static_cast<std::size_t>(count));
	const double lean = std::clamp(static_cast<double>(species.lean), 0.0, 1.5);
	for (int i = 0; i < count; i++) {
		MotionPlant &plant = plants[static_cast<std::size_t>(i)];
		// Neighbours on the circle of leans differ in length: the index strides oddly through the lengths.
		const float part = static_cast<float>((i * 29) % count) / static_cast<float>(std::max(count - 1, 1));
		plant.length = species.shortest + part * (species.longest - species.shortest);
		plant.scale = Prototypes::scale_among(species.shortest, species.longest, plant.length);
		plant.own = 2.0f * (static_cast<float>((i * OWN_STRIDE) % count) + 0.5f) / static_cast<float>(count) - 1.0f;
		const double around = 2.0 * PI * (i + 0.5) / count;
		plant.rest = { static_cast<float>(portable_sin(lean) * portable_sin(around)),
			static_cast<float>(portable_cos(lean)), static_cast<float>(portable_sin(lean) * portable_cos(around)) };
	}
	return plants;
}

} // namespace

Prototypes::Prototypes(int species_index, const MotionSpecies &species, int count, float step) :
		page(species_index, species, spread_plants(species, count).data(), count, step, true),
		shortest(species.shortest),
		longest(species.longest),
		lean(species.lean) {
	divide_history();
	remember_rest();
}

void Prototypes::settle() {
	page.settle();
	remember_rest();
}

void Prototypes::remember(int slot) {
	for (int mode = 0; mode < modes(); mode++) {
		std::copy(newest_bends(mode), newest_bends(mode) + 2 * count(), rings[mode].begin() + 2 * slot * MAX_COUNT);
	}
}

void Prototypes::remember_rest() {
	for (int slot = 0; slot < SLOTS; slot++) {
		remember(slot);
	}
}

/// Changes the rings to the current number of modes. The motion of one mode is divided between two as in a steady wind,
/// or that of two is joined, so no follower jumps.
void Prototypes::divide_history() {
	constexpr std::size_t BENDS = 2 * static_cast<std::size_t>(SLOTS * MAX_COUNT);
	const bool had_two = !rings[1].empty();
	rings[0].resize(BENDS);
	if (had_two == (modes() == 2)) {
		return;
	}
	rings[1].resize(BENDS);
	for (std::size_t i = 0; i < BENDS && page.law() == Law::stem; i++) {
		const int prototype = static_cast<int>(i / 2) % MAX_COUNT;
		if (prototype < count()) {
			const StemBends divided =
					bends_in_modes(page.stem_constants(), { rings[0][i], rings[1][i] }, page.rest_bend(prototype));
			rings[0][i] = divided.first;
			rings[1][i] = divided.second;
		}
	}
	if (had_two) {
		rings[1] = {};
	}
}

/// Picks among the prototypes with a length within this fraction of the range.
int Prototypes::pick_tall(float length, uint64_t chance) const {
	const int all = count();
	const int near = std::max(all / TALL_SECTORS, 1);
	const float part = std::clamp((length - shortest) / (longest - shortest), 0.0f, 1.0f);
	const int wanted = static_cast<int>(part * static_cast<float>(all - 1) + 0.5f) - near / 2 +
			static_cast<int>(chance % static_cast<uint64_t>(near));
	const float best = shortest +
			(longest - shortest) * static_cast<float>(std::clamp(wanted, 0, all - 1)) /
					static_cast<float>(std::max(all - 1, 1));
	int nearest = 0;
	for (int i = 1; i < all; i++) {
		nearest = std::fabs(page.length(i) - best) < std::fabs(page.length(nearest) - best) ? i : nearest;
	}
	return nearest;
}

Follower Prototypes::pick(const MotionPlant &plant, uint64_t hash) const {
	const uint64_t mixed = mix_bits(hash);
	const uint64_t low = mixed & 0xffffffffull;
	const int all = count();
	Follower follower;
	if (page.law() == Law::spring && lean > 0.0f) {
		const int sector = std::max(all / LEAN_SECTORS, 1);
		const int first = static_cast<int>(lean_share(plant.rest) * static_cast<float>(all)) - sector / 2 + all;
		follower.prototype =
				static_cast<uint16_t>((first + static_cast<int>(low % static_cast<uint64_t>(sector))) % all);
	} else if (page.law() == Law::stem && page.stem_constants().has_grades() && longest > shortest) {
		follower.prototype = static_cast<uint16_t>(pick_tall(plant.length, low));
	} else {
		follower.prototype = static_cast<uint16_t>(low % static_cast<uint64_t>(all));
	}
	const float steps = std::min(OWN_DELAY / page.step_length(), static_cast<float>(LONGEST_OWN_DELAY));
	follower.own_delay = static_cast<uint16_t>((mixed >> 32) % static_cast<uint64_t>(std::max(steps, 1.0f)));
	return follower;
}

void Prototypes::set_species(const MotionSpecies &species) {
	const bool respread = species.law != page.law() || species.shortest != shortest || species.longest != longest ||
			species.lean != lean;
	const bool was_calm = is_at_rest();
	if (respread) {
		const int all = count();
		MotionPage spread(page.species(), species, spread_plants(species, all).data(), all, page.step_length(), true);
		for (int i = 0; i < all && !was_calm; i++) {
			spread.set_state(i, page.state(i), page.second(i));
		}
		page = std::move(spread);
		shortest = species.shortest;
		longest = species.longest;
		lean = species.lean;
	} else {
		page.set_species(species);
	}
	divide_history();
	if (was_calm) {
		remember_rest();
	}
}

bool Prototypes::is_at_rest() {
	int row = 0;
	while (row < count() && page.is_at_rest(row)) {
		row++;
	}
	return row == count();
}

BendWay Prototypes::way(int mode, int prototype, float late, float fraction) const {
	const float ago = late + 1.0f - fraction; // Time since the step after which it looked like that.
	const float whole = std::floor(ago);
	const int slot = (newest - static_cast<int>(whole)) & (SLOTS - 1);
	const Bend *pair = &rings[mode][2 * static_cast<std::size_t>(slot * MAX_COUNT + prototype)];
	return bend_way(pair, 1.0f - (ago - whole));
}

void Prototypes::step(const WindSnapshot &wind, const PlantWinds &along) {
	WindSnapshot here = wind;
	here.cycles_x = here.cycles_z = here.delay_x = here.delay_z = 0.0f;
	for (AirMap *map : { &here.air.open.turbulence, &here.air.open.eddies, &here.air.canopy.turbulence,
				 &here.air.canopy.eddies, &here.air.waves }) {
		map->s_x = map->s_z = map->n_x = map->n_z = map->turn_x = map->turn_z = 0.0f;
	}
	page.step(here, along);
	newest = (newest + 1) & (SLOTS - 1);
	remember(newest);
}

} // namespace undergrowth
