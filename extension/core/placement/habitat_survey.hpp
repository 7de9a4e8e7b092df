#pragma once

#include "placement/habitat_raster.hpp"

#include <vector>

namespace undergrowth {

/// Rasters of a field's ground that habitats use. An empty raster is 1 everywhere.
struct HabitatSurvey {
	HabitatRaster moisture;
	HabitatRaster light;
	std::vector<HabitatRaster> values; ///< By species.
};

} // namespace undergrowth
