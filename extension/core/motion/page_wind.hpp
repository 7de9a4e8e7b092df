#pragma once

#include "motion/joint.hpp"
#include "wind/air.hpp"
#include "wind/air_ahead.hpp"
#include "wind/air_drift.hpp"
#include "wind/air_sources.hpp"

#include <glm/vec3.hpp>

namespace undergrowth {

/// Wind at the plants of a block, sized for the first-level cache.
struct BlockWind {
	static constexpr int PLANTS = 512; ///< Plants that are sampled together.

	float strengths[PLANTS]; ///< N.
	float x[PLANTS]; ///< m/s.
	float y[PLANTS]; ///< Only with `is_pressed`.
	float z[PLANTS];
	bool has_newtons = true;
	bool has_air = false;
	bool is_pressed = false; ///< True: air moves up or down, too.
};

/// The wind of one step at the plants of a page.
struct PageWind {
	const WindSnapshot &wind;
	const PlantWinds &along;
	const AirAhead &ahead;
	const float *x, *y, *z; ///< m, roots.
	const float *lengths; ///< m.
	glm::vec3 low, high; ///< m, of the page's box.
	float canopy_height; ///< m; 0: isolated plants.
	TallerPlants taller;
	float drag; ///< kg/m, of a tip of the laws of one joint.
	bool has_stems; ///< Stems take forces and air together. Under the other laws, forces near sources become air.
	SimdLevel level;
	AirMoments moments = wind.is_air ? moments_among(wind.air, canopy_height, taller, along) : AirMoments{};
	bool is_carried = wind.drift && wind.drift->has_effect();
	bool is_stirred = is_carried || any_reaches(wind.sources, low, high);

	/// Samples `count` plants from `begin` on.
	void sample(int begin, int count, BlockWind &block) const;

private:
	void subtract_drift(int begin, int count, BlockWind &block) const;
};

} // namespace undergrowth
