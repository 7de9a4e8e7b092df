#pragma once

#include "stem/stem_elements.hpp"

namespace undergrowth {

/// m: of the head's centre, which the tip's slope moves as well.
double head_deflection(const StemLine &line, const StemCurve &curve);
/// ∫ c·one·other with the head's, c being the air's share of each place; without `other` ∫ c·one.
double air_product(const StemLine &line, const StemCurve &one, const StemCurve *other);
/// What a load along the stem counts beside one across it: ∫V ψ²/(ψ_tip ∫V ψ), V being the wind in newtons above a
/// place and ψ the slope of what it bends.
double axial_share(const StemLine &line, const StemCurve &steady);

} // namespace undergrowth
