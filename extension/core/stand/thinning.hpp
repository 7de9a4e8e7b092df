#pragma once

#include "stand/plant_id.hpp"

#include <algorithm>

namespace undergrowth {

constexpr int RANK_BITS = 24;
/// How many different ranks there are: as many as a float holds.
constexpr int RANK_COUNT = 1 << RANK_BITS;

/// A plant's place in the order in which far plants are left away, 0 to below 1: those with a rank below a share are
/// kept. It hangs on the plant's id alone. Plants that were filled have theirs by the golden ratio along Hilbert's
/// curve through their cells, so that of any share what is left stays spread; those that were added by their number.
/// A multiple of 1 / RANK_COUNT.
float plant_rank(PlantId id);

/// How many of a field's plants are kept at which distance from the eye, over one level of detail and the one before
/// it. What the shader says with the same numbers (undergrowth_width.gdshaderinc).
struct Thinning {
	/// A plant goes from its full width to none while the share falls by so much, or by such a part of the share.
	static constexpr float MOST_BAND = 0.1f;
	static constexpr float BAND_SHARE = 0.25f;

	float distances[3] = { 0.0f, 0.0f, 1.0f }; ///< m; ascending.
	float shares[3] = { 1.0f, 1.0f, 1.0f }; ///< 0 to 1: kept at these; linear between them, even beyond them.

	bool operator==(const Thinning &other) const {
		return std::equal(distances, distances + 3, other.distances) && std::equal(shares, shares + 3, other.shares);
	}
	/// Whether anybody is ever left away.
	bool is_any() const { return shares[0] < 1.0f || shares[1] < 1.0f || shares[2] < 1.0f; }
	float share_at(float distance) const;
	/// Whoever has a rank of this or more is drawn without any width at this distance.
	float cut_at(float distance) const;
	/// How wide a plant is drawn at this distance because of its rank: 0 to 1.
	float width_of(float rank, float distance) const;

private:
	static float band(float share);
};

} // namespace undergrowth
