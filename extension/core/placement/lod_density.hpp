#pragma once

#include "placement/plant_id.hpp"

#include <algorithm>

namespace undergrowth {

constexpr int RANK_BITS = 24;
/// Number of distinct ranks: the precision of a float.
constexpr int RANK_COUNT = 1 << RANK_BITS;

/// Rank of a plant in the order of removal by distance, in [0, 1): a density d keeps plants with a rank below d. It
/// depends on the id alone. Generated plants: golden ratio along Hilbert's curve through their cells, so that each
/// density is spread evenly. Added plants: by their number. A multiple of 1 / RANK_COUNT.
float plant_rank(PlantId id);

/// Density of a field by distance from the camera, over one level of detail and the one before it. The shader computes
/// the same (undergrowth_width.gdshaderinc).
struct LodDensity {
	/// A plant fades from full width to none while the density falls by MAX_BAND, or by BAND_SHARE of itself.
	static constexpr float MAX_BAND = 0.1f;
	static constexpr float BAND_SHARE = 0.25f;

	float distances[3] = { 0.0f, 0.0f, 1.0f }; ///< m; ascending.
	float densities[3] = { 1.0f, 1.0f,
		1.0f }; ///< 0 to 1: density at these distances; linear between them, constant beyond.

	bool operator==(const LodDensity &other) const {
		return std::equal(distances, distances + 3, other.distances) &&
				std::equal(densities, densities + 3, other.densities);
	}
	/// The same densities at `factor` times the distances.
	LodDensity scaled(float factor) const;
	/// True if any plant is ever removed.
	bool is_any() const { return densities[0] < 1.0f || densities[1] < 1.0f || densities[2] < 1.0f; }
	float density_at(float distance) const;
	/// Plants with at least this rank have no width at this distance.
	float cut_at(float distance) const;
	/// Width factor of a plant by its rank at this distance: 0 to 1.
	float width_of(float rank, float distance) const;

private:
	static float band(float density);
};

} // namespace undergrowth
