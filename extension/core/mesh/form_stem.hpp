#pragma once

#include "form/plant_form.hpp"
#include "stem/stem_beam.hpp"

#include <vector>

namespace undergrowth {

// Derives the beam of a stem from the drawn plant: its thickness, and the mass and drag area attached to it. Masses use
// common densities and thicknesses of plants; drag uses common coefficients. A species with better values sets them
// (PlantStem). Lengths are for a plant of `beam.length` metres.

/// For a plant of parts. The stem is that of the four functions, or else the longest part on the ground. Each carried
/// part is a load at its attachment; parts at the tip are the head.
void carry_parts(const PlantForm &form, StemBeam &beam);

/// For a lathe with rings of `radius` (m) times `widths`, from bottom to top. Rings much wider than its lower half are
/// the head, at the tip.
void carry_lathe(float radius, const std::vector<float> &widths, StemBeam &beam);

} // namespace undergrowth
