#pragma once

#include "stem/stem_line.hpp"

#include <array>

namespace undergrowth {

/// The same stem as rigid links that turn against each other, to see where large steady bends leave the linear beam's
/// shape. In a plane, weight included.
class StemChain {
public:
	static constexpr int LINKS = 64;
	using Angles = std::array<double, LINKS>; ///< rad from the foot's direction, of each link.
	/// Cosine and sine of the foot's angle from upright; above 0 it leans with the wind.
	struct Lean {
		double cosine, sine;
		/// True: straight without weight, so that it nods at rest. False: straight at rest, under its own weight.
		bool nods;
	};

	StemChain(const StemLine &line, double youngs_modulus);

	/// Solves the equilibrium under `newtons`, starting from `angles` of a smaller load.
	void settle_dead(double newtons, Angles &angles, const Lean &lean = { 1.0, 0.0, false }) const;
	/// The same in air of `speed_squared` (m²/s²). The pressure on each link is the square of the velocity across it.
	void settle_air(double speed_squared, Angles &angles, const Lean &lean = { 1.0, 0.0, false }) const;

private:
	Angles joint; ///< N·m a radian, of the joint below each link.
	Angles weight; ///< N·m: moment of the weight about a level link's lower end.
	Angles dead; ///< m: the same of one newton of wind.
	Angles air; ///< kg/m: of the air on each link.
	double length;
	double head_centre;
	double head_air;

	double elastic(const Angles &angles, int link) const;
	/// Adds (K + diagonal)⁻¹·moments, or as much of it as is safe; the largest change.
	double turn(Angles &angles, const Angles &moments, const Angles &diagonal) const;
};

} // namespace undergrowth
