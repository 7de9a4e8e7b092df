#pragma once

namespace undergrowth {

/// What the plants of one clump share. Clumps are cells of 0.6 to 1.2 m around scattered centres (Voronoi). A slow flow
/// over 10 m aligns neighbouring clumps. They depend only on the place, so that fields in one place share them.
/// `undergrowth_clump()` of the shaders has the same cells.
struct Clump {
	static constexpr double SPACING = 1.0 / 1.1; ///< m, between centres.

	double turn = 0.0; ///< rad, around +y from +z: the direction in which its plants lean and face.
	double lean = 0.0; ///< 0.4 to 1, share of a species' max lean.
	double height = 0.0; ///< -1 to 1.
};

/// The clump at (x, z) (m, field axes).
Clump clump_at(double x, double z);

} // namespace undergrowth
