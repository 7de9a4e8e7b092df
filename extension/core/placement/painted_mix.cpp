#include "placement/painted_mix.hpp"

#include "base/random.hpp"
#include "placement/placement.hpp"

#include <algorithm>

namespace undergrowth {

namespace {

DensityCell cell_of(const PlacementRequest &request, int species, const glm::vec2 &root) {
	const int layer = request.species[static_cast<std::size_t>(species)].layer;
	return layer < 0 ? DensityCell() : request.map->cell_at(layer, root);
}

bool is_kept(const DensityCell &cell, double drawn) {
	return drawn * DensityCell::MAX_DENSITY < cell.density;
}

} // namespace

PaintedMix::PaintedMix(const PlacementRequest &request) {
	double all = 0.0;
	std::vector<double> layer_weights(static_cast<std::size_t>(request.map ? request.map->layer_count() : 0), 0.0);
	std::vector<int> layer_species(layer_weights.size(), 0);
	for (const PlacementSpecies &species : request.species) {
		all += static_cast<double>(species.weight);
		if (request.map && species.layer >= 0) {
			layer_weights[static_cast<std::size_t>(species.layer)] += static_cast<double>(species.weight);
			layer_species[static_cast<std::size_t>(species.layer)]++;
		}
	}
	for (std::size_t i = 0; i < request.species.size() && request.map; i++) {
		const PlacementSpecies &species = request.species[i];
		const auto weight = static_cast<double>(species.weight);
		fractions.push_back(weight / all);
		if (species.layer < 0 || !request.map->may_have_plants(species.layer)) {
			continue;
		}
		const double shared = layer_weights[static_cast<std::size_t>(species.layer)];
		const double part =
				shared > 0.0 ? weight / shared : 1.0 / layer_species[static_cast<std::size_t>(species.layer)];
		counted.push_back({ static_cast<int>(i), part });
	}
}

double PaintedMix::plants_at(const PlacementRequest &request, const Counted &one, const glm::vec2 &root) const {
	return one.part * static_cast<double>(cell_of(request, one.species, root).plant_density());
}

/// Species of `counted` at `plants` on the running sum of all plants/m² there.
int PaintedMix::pick_counted(const PlacementRequest &request, const glm::vec2 &root, double plants) const {
	int last = -1;
	for (const Counted &one : counted) {
		const double own = plants_at(request, one, root);
		last = own > 0.0 ? one.species : last;
		if (own > 0.0 && plants < own) {
			break;
		}
		plants -= own;
	}
	return last;
}

/// Draws a species of the mix without plants/m² there. Returns -1 if the drawn one has some, or if its density rejects
/// it.
int PaintedMix::pick_other(const PlacementRequest &request, const glm::vec2 &root, double drawn, double keep) const {
	for (std::size_t i = 0; i < fractions.size(); i++) {
		if (drawn < fractions[i]) {
			const DensityCell cell = cell_of(request, static_cast<int>(i), root);
			return cell.plants == 0 && is_kept(cell, keep) ? static_cast<int>(i) : -1;
		}
		drawn -= fractions[i];
	}
	return -1;
}

/// Probability that the mix has a plant there, without drifts.
double PaintedMix::filled_chance(const PlacementRequest &request, const glm::vec2 &root, bool without_counted) const {
	double chance = 0.0;
	for (std::size_t i = 0; i < fractions.size(); i++) {
		const DensityCell cell = cell_of(request, static_cast<int>(i), root);
		chance += without_counted && cell.plants > 0 ? 0.0 : fractions[i] * static_cast<double>(cell.share());
	}
	return chance;
}

int PaintedMix::choose(
		const PlacementRequest &request, const Drawn &drawn, const glm::vec2 &root, uint64_t bits) const {
	const DensityCell cell = cell_of(request, drawn.species, root);
	int species = is_kept(cell, unit16(bits, 0)) ? drawn.species : -1;
	double plants = 0.0;
	for (const Counted &one : counted) {
		plants += plants_at(request, one, root);
	}
	if (plants <= 0.0) {
		return species;
	}
	double filled = drawn.is_in_drift ? static_cast<double>(cell.share()) : filled_chance(request, root, false);
	if (drawn.is_in_drift && cell.plants > 0) { // The drift ends here. All other species take its positions.
		filled += (1.0 - filled) * filled_chance(request, root, true);
		species = species >= 0 ? species : pick_other(request, root, unit16(bits, 1), unit16(bits, 2));
	}
	const double wanted = std::min(plants / static_cast<double>(request.density), 1.0);
	const double bare = 1.0 - filled;
	const double chance =
			species < 0 ? (wanted < bare ? wanted / bare : 1.0) : (wanted > bare ? (wanted - bare) / filled : 0.0);
	if (unit16(bits, 3) >= chance) {
		return species;
	}
	return pick_counted(request, root, unit16(mix_bits(bits), 0) * plants);
}

} // namespace undergrowth
