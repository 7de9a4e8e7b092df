#pragma once

#include "placement/lod_density.hpp"

#include <algorithm>
#include <tuple>

namespace undergrowth {

/// One level of detail of a field.
struct FieldLevel {
	int lod = 12; ///< Vertical segments.
	float begin = 0.0f; ///< Distance from the camera (m).
	float end = 0.0f; ///< m; 0: no end.
	float margin = 2.0f; ///< Length of the transition from the previous level (m), > 0.
	float end_margin = 2.0f; ///< Length of the transition to the next level (m), > 0.
	int halvings = 0; ///< How often the number of variants is halved.
	int min_variants = 1; ///< Minimum number of variants, if the species has as many.
	bool is_used = true; ///< False: the species skips this level.
	bool is_near = false; ///< True: its plants are drawn one by one around the cameras (NearPlants), not in squares.
	int tile_factor = 1; ///< Width of its multimeshes, in tiles.
	int tile_cuts = 1; ///< Number of multimeshes along a tile's side. tile_factor or tile_cuts is 1.
	LodDensity lod_density;
	bool affects_lathes = false; ///< True: thins all plants. False: only plants of parts.
	bool casts_shadows = true;
	float shadow_end = 0.0f; ///< m: plants farther away cast no shadows.

	bool operator==(const FieldLevel &other) const {
		return std::tie(lod, begin, end, margin, end_margin, tile_factor, tile_cuts, affects_lathes, casts_shadows,
					   shadow_end) ==
				std::tie(other.lod, other.begin, other.end, other.margin, other.end_margin, other.tile_factor,
						other.tile_cuts, other.affects_lathes, other.casts_shadows, other.shadow_end) &&
				lod_density == other.lod_density && has_form_of(other);
	}
	/// True if both are drawn with the same meshes and multimeshes.
	bool has_form_of(const FieldLevel &other) const {
		return std::tie(lod, halvings, min_variants, is_used, is_near) ==
				std::tie(other.lod, other.halvings, other.min_variants, other.is_used, other.is_near);
	}
	/// Returns the number of meshes at this level for a species of `variants` plants, at least 1.
	int groups(int variants) const { return std::max({ 1, variants >> halvings, std::min(variants, min_variants) }); }
	/// Returns the density of plants with or without parts.
	LodDensity lod_density_of(bool has_parts) const { return has_parts || affects_lathes ? lod_density : LodDensity(); }
};

} // namespace undergrowth
