#pragma once

#include "stem/stem_constants.hpp"

#include <vector>

namespace undergrowth {

/// Stem of a species: a slender, tapered beam, fixed in the ground, with a head and leaves.
/// SI units; lengths are those of a plant of mean height. Ranges: describe(StemFault).
struct StemBeam {
	enum class Section {
		round, ///< Diameter, taper and how hollow.
		blade ///< Flat; its width is the diameter, tapers, and bends across its thickness, which is the same all along.
	};
	/// A load on the stem.
	struct Load {
		float place = 1.0f; ///< 0 at the root, 1 at the tip.
		float mass = 0.0f; ///< kg.
		float drag_area = 0.0f; ///< m², drag coefficient included.
	};

	float length = 0.6f; ///< m.
	int joints = 4; ///< For drawing only; frequencies and bends do not depend on it.
	int modes = 1;
	Section section = Section::round;
	float diameter = 0.004f; ///< m, at the root.
	float thickness = 0.0005f; ///< m, of a blade.
	float taper = 0.5f; ///< Share of the diameter that is lost from root to tip.
	float hollow = 0.0f; ///< Of a round stem: diameter of the hole inside over its own.
	float density = 1000.0f; ///< kg/m³, of what is solid.
	float drag_coefficient = 1.1f; ///< Of the bare stem, over diameter times length.

	/// Hz, of the slowest small swing, gravity included; 0: it follows from `youngs_modulus`.
	float natural_frequency = 1.5f;
	float youngs_modulus = 4e9f; ///< Pa, where no frequency is declared.
	/// True: a declared frequency is that of stems of `length`; stems of other lengths have the same stiffness.
	bool frequency_by_length = false;
	float frequency_deviation = 0.0f; ///< Standard deviation of plants of one length, as a fraction; 0 to 0.3.
	/// True: straight without its weight, under which it nods where it leans (StemNod). False: straight at rest.
	bool nods = false;
	float damping_ratio = 0.06f; ///< Of a small swing in still air, all modes.

	float head_mass = 0.0f; ///< kg.
	float head_centre = 0.0f; ///< m above the tip.
	float head_inertia = 0.0f; ///< kg·m², about its centre.
	float head_drag_area = 0.0f; ///< m², drag coefficient included.
	float leaf_mass = 0.0f; ///< kg, spread evenly along the stem.
	float leaf_drag_area = 0.0f; ///< m², spread evenly, drag coefficient included.
	std::vector<Load> loads; ///< Besides, each at its place.

	/// Fractions of a wind force that act on the joints at s_j = j·length/joints, j = 1 … joints; the last acts on the
	/// head. Empty: the force is distributed like the drag area. Not empty: one value per joint.
	std::vector<float> wind_weights;
};

enum class StemFault {
	none,
	length,
	joints,
	modes,
	diameter,
	thickness,
	taper,
	hollow,
	density,
	drag,
	frequency,
	stiffness,
	deviation,
	damping,
	head,
	leaves,
	loads,
	weights,
	falls,
};

/// Error and remedy, in English.
const char *describe(StemFault fault);

/// The first invalid parameter; does not check `falls`.
StemFault find_fault(const StemBeam &beam);

/// Solution for one stem.
struct StemSolution {
	StemFault fault = StemFault::none;
	StemConstants constants; ///< With a fault: the default ones.
	double youngs_modulus = 0.0; ///< Pa: as given, or what the declared frequency needs.
	double buckling_share = 0.0; ///< Its weight over the weight under which it would fall.
	double frequencies[2] = {}; ///< rad/s, of the two slowest modes.
};

/// The oscillators and shapes of a stem. The linear beam is that of Euler and Bernoulli with the weight above each
/// place pressing on it, as 32 finite elements with cubic (Hermite) shapes: the two slowest frequencies are within 0.02
/// %. The last mode is not an eigenmode: it carries all that the wind's static shape has beyond the modes before it, so
/// that steady wind is exact. What large bends do to the static shape comes from a chain of 64 links. Takes
/// milliseconds; the same bits on every build.
StemSolution solve_stem(const StemBeam &beam);

} // namespace undergrowth
