#pragma once

#include <glm/vec4.hpp>

namespace undergrowth {

/// Asks a species (plant/species/) for the lod + 1 widths and colours of a mesh: entry k at offset k/lod.
template <class Species> void sample_species(const Species &species, int lod, float *widths, glm::vec4 *colors) {
	for (int k = 0; k <= lod; k++) {
		const float offset = static_cast<float>(k) / static_cast<float>(lod);
		widths[k] = species.width(offset);
		colors[k] = species.color(offset);
	}
}

} // namespace undergrowth
