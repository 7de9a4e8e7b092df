#pragma once

#include "form/plant_form.hpp"
#include "stem/stem_beam.hpp"

#include <vector>

namespace undergrowth {

// What a plant as it is drawn says about its stem as a beam: how thick it is, and what mass and drag area hang on it.
// Mass of what is drawn follows from usual densities and thicknesses of plants, drag from usual coefficients; a species
// that knows better says so (PlantStem). Lengths are those of a plant of `beam.length` metres.

/// Of a plant of parts, the stem is that of the four functions, or else what stands longest on the ground. Everything
/// that it carries loads it where it is attached; what is on its tip is the head.
void carry_parts(const PlantForm &form, StemBeam &beam);

/// Of a lathe with so many rings of a radius (m) times `widths`, from bottom to top: what is much wider than its lower
/// half is the head, at the tip.
void carry_lathe(float radius, const std::vector<float> &widths, StemBeam &beam);

} // namespace undergrowth
