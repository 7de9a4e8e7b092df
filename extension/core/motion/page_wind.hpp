#pragma once

#include "motion/joint.hpp"
#include "wind/air.hpp"
#include "wind/air_ahead.hpp"
#include "wind/air_drift.hpp"
#include "wind/air_sources.hpp"

#include <glm/vec3.hpp>

namespace undergrowth {

/// What blows over the plants of a block, in the first-level cache.
struct BlockWind {
	static constexpr int PLANTS = 512; ///< Whose winds are sampled together.

	float strengths[PLANTS]; ///< N.
	float x[PLANTS]; ///< m/s.
	float z[PLANTS];
	bool has_newtons = true;
	bool has_air = false;
};

/// The wind of one step as the plants of a page feel it.
struct PageWind {
	const TravellingWind &wind;
	const PlantWinds &along;
	const AirAhead &ahead;
	const float *x, *y, *z; ///< m, roots.
	const float *lengths; ///< m.
	glm::vec3 low, high; ///< m, of the page's box.
	float stand_height; ///< m; 0: plants stand alone.
	float drag; ///< kg/m, of a tip of the laws of one joint.
	bool has_stems; ///< Under which newtons and air blow together; under the other laws, newtons that sources stir
					///< become air.
	SimdLevel level;
	AirBlow blow = wind.is_air ? blow_over(wind.air, stand_height, along) : AirBlow{};
	bool is_carried = wind.drift && wind.drift->is_felt();
	bool is_stirred = is_carried || any_reaches(wind.sources, low, high);

	/// Of `count` plants from `begin` on.
	void sample(int begin, int count, BlockWind &block) const;

private:
	void subtract_drift(int begin, int count, BlockWind &block) const;
};

} // namespace undergrowth
