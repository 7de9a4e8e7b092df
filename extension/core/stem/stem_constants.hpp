#pragma once

#include <cstring>

namespace undergrowth {

/// Maximum number of oscillators of a stem: the swing in the wind, and a second mode excited by gusts and pushes.
constexpr int MAX_STEM_MODES = 2;
/// Maximum amplitude of a mode; 113° at the tip for a mode that bends most there.
inline constexpr float MAX_STEM_AMPLITUDE = 1.5f;
/// Maximum number of joints of a stem.
constexpr int MAX_STEM_JOINTS = 8;
/// Coefficients of a shape along the stem, those of x, x², … x⁶.
constexpr int STEM_SHAPE_TERMS = 6;

/// Dependence of a value on the length of a plant, as a factor of the value at StemConstants::length. At r times that
/// length the factor is 1 + (r - 1)·(slope + curve·(r - 1)). Both are 0 if frequencies do not depend on the length.
struct StemGrade {
	float slope = 0.0f;
	float curve = 0.0f;

	float at(float ratio) const { return 1.0f + (ratio - 1.0f) * (slope + curve * (ratio - 1.0f)); }
};

/// Effect of the part of a load along a stem, relative to the part across it: share/(1 + ease·s). s is the linear slope
/// of the tip if the whole load acts across the stem.
struct StemAlong {
	float share = 1.0f;
	float ease = 0.0f;
};

/// Bend of the tip of a leaning stem under its own weight, with the lean's stereographic image r
/// (motion/bend_encoding.hpp) and u = 1 + cos(lean): r·u·share/(1 + ease·(2 - u)), in the frame of the rest
/// direction. Share and ease scale as `air_slope` does.
struct StemNod {
	float share = 0.0f;
	float ease = 0.0f;
};

/// One oscillator of a stem, with the amplitude q (a vector in the horizontal plane, without unit). Half the deflection
/// (m) at the distance s from the root is q·φ(s). The bend along the stem is q·ψ(x) with ψ = dφ/ds; |ψ| is at most 1,
/// and ψ is positive at the tip. Energies are 2·mass·|v|² and 2·stiffness·|q|².
struct StemMode {
	float frequency = 1.0f; ///< rad/s, gravity included.
	float damping = 0.1f; ///< Damping ratio of a small swing in still air.
	float stiffness = 1.0f; ///< N·m, φᵀAφ.
	float mass = 1.0f; ///< kg·m², stiffness/frequency².
	float tip_slope = 1.0f; ///< ψ at the tip.
	float dead_share = 1.0f; ///< Static amplitude under a load in newtons, over the linear slope of the tip.
	float air_share = 1.0f; ///< The same for a wind in m/s.
	float air_drag = 0.0f; ///< kg·m/s per m/s: ∫c φ², head included; the drag coefficient D of the mode.
	float air_lag = 0.0f; ///< m: ∫c φ_1 φ/∫c φ_1, the distance that the mode moves away from the wind.
	/// Limits the amplitudes so that the tip stays above the ground; 0: no ground. First mode: bend of the straight
	/// line from root to tip per amplitude, with the second mode's part of a steady wind. At 1 the tip of an upright
	/// stem reaches the ground. Second mode: the maximum part of that 1 that its remaining amplitude may use.
	float chord = 0.0f;
	StemGrade period; ///< Factor of 1/frequency.
};

/// The constants of a species' stem, for stepping and drawing. They are computed once per species (solve_recipe) for a
/// stem of `length`, and are valid for plants of all lengths. Immutable; any thread may read them. Comparable by bytes.
struct StemConstants {
	/// m. Without grades a plant of another length L has the same frequencies, and its loads are scaled by length/L.
	/// If frequencies follow from the stiffness, grades scale both.
	float length = 1.0f;
	int modes = 1;
	int joints = 4;
	StemMode mode[MAX_STEM_MODES];
	float dead_slope = 1.0f; ///< 1/N: linear slope of the tip per newton of wind force, weights of joints included.
	float air_slope = 0.0f; ///< s²/m²: the same per squared speed of the wind.
	StemGrade dead_grade; ///< Factor of dead_slope.
	StemGrade air_grade; ///< Factor of air_slope.
	/// Maximum difference of a plant's own frequency from that of others of its length, as a fraction: plant `own` of
	/// MotionPlant has 1 + own·spread times their frequency.
	float spread = 0.0f;
	float drag_area = 0.0f; ///< m², of the whole stem, drag coefficient included.
	float axial_share = 1.0f; ///< Effect of a small load along the stem, relative to one across it.
	StemAlong dead_along; ///< The same for a wind force of any size.
	StemAlong air_along; ///< For a wind in m/s.
	/// Of stems of `length`. Zero: rest directions contain the bend.
	StemNod nod;
	/// ψ_1, ψ_2 and the shapes of large bends X3, X5: u(x) = Σ_k q_k ψ_k + t·(n·X3 + n²·X5), t = Σ_k q_k·tip_slope and
	/// n = min(|t|², 1), because no steady wind bends a tip below level. shape[j] has the four coefficients of
	/// x^(j+1), x from 0 at the root to 1 at the tip.
	float shape[STEM_SHAPE_TERMS][4] = {};
	/// X3 and X5 of a wind in m/s, which acts across the stem and therefore bends it differently from a force;
	/// they replace the last two in such a wind (in_air()).
	float air_shape[STEM_SHAPE_TERMS][2] = {};
	/// φ_k (m) at the joints s_j = j·length/joints, j = 1 … joints, in deflection[j - 1], and at the head's centre in
	/// deflection[joints].
	float deflection[MAX_STEM_JOINTS + 1][MAX_STEM_MODES] = {};

	/// True if frequencies depend on each plant's length.
	bool has_grades() const { return mode[0].period.slope != 0.0f; }
	/// True if plants have different frequencies.
	bool has_own_frequencies() const { return has_grades() || spread > 0.0f; }

	bool operator==(const StemConstants &other) const {
		static_assert(sizeof(StemConstants) ==
						4 * (18 + 12 * MAX_STEM_MODES + 6 * STEM_SHAPE_TERMS) +
								4 * (MAX_STEM_JOINTS + 1) * MAX_STEM_MODES,
				"no padding, so bytes say whether all numbers are the same");
		return std::memcmp(this, &other, sizeof(StemConstants)) == 0;
	}
};

} // namespace undergrowth
