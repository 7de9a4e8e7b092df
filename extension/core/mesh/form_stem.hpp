#pragma once

#include "form/plant_form.hpp"
#include "stem/stem_beam.hpp"

#include <vector>

namespace undergrowth {

// Derives the stem of a plant as a beam from its drawn form: thickness, mass and drag area. Mass follows from usual
// densities and thicknesses of plants, drag from usual coefficients. A species can state its own values (PlantStem).
// Lengths are those of a plant of `beam.length` metres.

/// For a plant of parts: the stem is that of the four functions, or the longest part on the ground. Everything that it
/// carries loads it at the attachment; the load on its tip is the head.
void carry_parts(const PlantForm &form, StemBeam &beam);

/// For a lathe with rings of `radius` (m) times `widths`, from bottom to top: rings much wider than its lower half are
/// the head, at the tip.
void carry_lathe(float radius, const std::vector<float> &widths, StemBeam &beam);

} // namespace undergrowth
