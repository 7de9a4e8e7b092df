#pragma once

#include "stem/stem_beam.hpp"

#include <vector>

namespace undergrowth {

/// A quantity along a stem: spread smoothly, as a polynomial of x from 0 at the root to 1 at the tip, and at places.
struct StemSpread {
	struct Point {
		double place; ///< x.
		double amount;
	};
	double terms[3] = {}; ///< Per x, of 1, x, x².
	std::vector<Point> points; ///< On the stem; the head's is not among them.

	/// The smooth part: per x, and from x to the tip.
	double at(double x) const { return terms[0] + x * (terms[1] + x * terms[2]); }
	double beyond(double x) const;
	/// All that is farther up than x.
	double above(double x) const;
	double total() const;
};

/// A stem as its sections say it, along x = s/length.
class StemLine {
public:
	explicit StemLine(const StemBeam &beam);

	double length = 1.0; ///< m.
	StemSpread mass; ///< kg.
	StemSpread air; ///< kg/m: newtons of a wind over its speed squared, that is half the air's density times drag area.
	StemSpread dead; ///< Shares of a wind in newtons.
	double head_mass = 0.0; ///< kg.
	double head_centre = 0.0; ///< m above the tip.
	double head_inertia = 0.0; ///< kg·m².
	double head_air = 0.0; ///< kg/m.
	double head_dead = 0.0;

	/// m⁴, second moment of area: bending stiffness over Young's modulus.
	double bending(double x) const;

private:
	StemBeam::Section section;
	double diameter;
	double thickness;
	double taper;
	double hole; ///< Over the diameter, squared.

	void spread_mass(const StemBeam &beam);
	void spread_drag(const StemBeam &beam);
	void spread_dead(const StemBeam &beam);
};

} // namespace undergrowth
