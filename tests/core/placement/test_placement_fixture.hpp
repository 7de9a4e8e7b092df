#pragma once

#include "../golden.hpp"
#include "placement/placement.hpp"

#include <cstdint>
#include <vector>

/// A square field around the origin with some species of equal weights and all deviations.
inline undergrowth::PlacementRequest square_field(float side, float density, int species) {
	undergrowth::PlacementRequest request;
	request.area = undergrowth::rectangle({ side, side });
	request.density = density;
	request.seed = 7;
	for (int i = 0; i < species; i++) {
		undergrowth::PlacementSpecies kind;
		kind.variants = 8;
		kind.min_scale = 0.8f;
		kind.max_scale = 1.25f;
		kind.height_deviation = 0.3f;
		kind.max_lean = 0.2f;
		request.species.push_back(kind);
	}
	return request;
}

inline undergrowth::FieldPlants placed(const undergrowth::PlacementRequest &request) {
	undergrowth::FieldPlants plants;
	undergrowth::place_plants(request, plants);
	return plants;
}

inline uint64_t hash_of(const undergrowth::FieldPlants &plants) {
	GoldenHash hash;
	hash.add(plants.x).add(plants.y).add(plants.z).add(plants.scale).add(plants.turn);
	hash.add(plants.height).add(plants.lean).add(plants.species).add(plants.variant);
	return hash.value();
}
