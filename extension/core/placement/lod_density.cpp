#include "placement/lod_density.hpp"

#include "placement/curve_key.hpp"

#include <algorithm>

namespace undergrowth {

namespace {

constexpr uint64_t GOLDEN_RATIO = 0x9E3779B97F4A7C15u; ///< Its fraction, in 2^-64.

} // namespace

float plant_rank(PlantId id) {
	int column = 0;
	int row = 0;
	uint64_t number = static_cast<uint64_t>(id);
	if (!is_added(id)) {
		generated_plant_cell(id, column, row);
		number = curve_key(column, row);
	}
	return static_cast<float>((number * GOLDEN_RATIO) >> (64 - RANK_BITS)) / static_cast<float>(RANK_COUNT);
}

LodDensity LodDensity::scaled(float factor) const {
	LodDensity made = *this;
	for (float &distance : made.distances) {
		distance *= factor;
	}
	return made;
}

float LodDensity::density_at(float distance) const {
	const int first = distance < distances[1] ? 0 : 1;
	const float length = distances[first + 1] - distances[first];
	const float way = length > 0.0f ? (distance - distances[first]) / length : 1.0f;
	return densities[first] + (densities[first + 1] - densities[first]) * std::clamp(way, 0.0f, 1.0f);
}

float LodDensity::band(float density) {
	return std::min(MAX_BAND, BAND_SHARE * density);
}

float LodDensity::cut_at(float distance) const {
	const float density = density_at(distance);
	return density + band(density);
}

float LodDensity::width_of(float rank, float distance) const {
	const float density = density_at(distance);
	if (density <= 0.0f) {
		return 0.0f;
	}
	return std::clamp(1.0f - (rank - density) / band(density), 0.0f, 1.0f);
}

} // namespace undergrowth
