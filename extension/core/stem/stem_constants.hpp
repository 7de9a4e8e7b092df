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

/// Dependence of a value on a plant's height, relative to the value at StemConstants::length: 1 + (r - 1)·(slope +
/// curve·(r - 1)) at r times that. 0 and 0 if the frequency is declared.
struct StemGrade {
	float slope = 0.0f;
	float curve = 0.0f;

	float at(float ratio) const { return 1.0f + (ratio - 1.0f) * (slope + curve * (ratio - 1.0f)); }
};

/// One oscillator of a stem: half its deflection (m) is q·φ(s), its bend along the stem q·ψ(x), ψ = dφ/ds with a
/// largest size of 1 and above 0 at the tip. Energies are 2·mass·|v|² and 2·stiffness·|q|².
struct StemMode {
	float frequency = 1.0f; ///< rad/s, gravity included.
	float damping = 0.1f; ///< Damping ratio of a small swing in still air.
	float stiffness = 1.0f; ///< N·m, φᵀAφ.
	float mass = 1.0f; ///< kg·m², stiffness/frequency².
	float tip_slope = 1.0f; ///< ψ at the tip.
	float dead_share = 1.0f; ///< Of a load in newtons: static amplitude over the linear slope of the tip.
	float air_share = 1.0f; ///< Of a wind in m/s: the same.
	float air_drag = 0.0f; ///< kg·m/s over m/s: ∫c φ² with the head's, D of the mode.
	float air_lag = 0.0f; ///< m: ∫c φ_1 φ/∫c φ_1, how far the mode moves away from the wind.
	/// The first mode's: about the bend of the straight way from root to tip, over the amplitude, where the second one
	/// has its share of a steady wind; 1 where that brings the tip of an upright stem to the ground. The second one's:
	/// what it takes of that 1 at most with what it has besides. 0: no ground stops it.
	float chord = 0.0f;
	StemGrade period; ///< Of 1/frequency.
};

/// Constants of a species' stem of `length`, for stepping and drawing. For other lengths see `length`.
struct StemConstants {
	/// m, the stem that this is computed for. A plant of another length L has the same frequencies, and its loads count
	/// length/L times as much, where those are declared; where they follow from stiffness, grades say both.
	float length = 1.0f;
	int modes = 1;
	int joints = 4;
	StemMode mode[MAX_STEM_MODES];
	float dead_slope = 1.0f; ///< 1/N: linear slope of the tip under the wind's newtons, weights of joints included.
	float air_slope = 0.0f; ///< s²/m²: the same over the wind's speed squared.
	StemGrade dead_grade; ///< Of either slope.
	StemGrade air_grade;
	float axial_share = 1.0f; ///< What a load along the stem counts beside one across it.
	/// ψ_1, ψ_2 and the shapes of large bends X3, X5: u(x) = Σ_k q_k ψ_k + t·(n·X3 + n²·X5), t = Σ_k q_k·tip_slope and
	/// n = min(|t|², 1), for no steady wind bends a tip farther than level; shape[j] has the four coefficients of
	/// x^(j+1), x from 0 at the root to 1 at the tip.
	float shape[STEM_SHAPE_TERMS][4] = {};
	/// X3 and X5 of a wind in m/s, which acts across the stem and therefore bends it differently from a force;
	/// they replace the last two in such a wind (in_air()).
	float air_shape[STEM_SHAPE_TERMS][2] = {};
	/// φ_k (m) at the joints s_j = j·length/joints, j = 1 … joints, in deflection[j - 1], and at the head's centre in
	/// deflection[joints].
	float deflection[MAX_STEM_JOINTS + 1][MAX_STEM_MODES] = {};

	/// Whether frequencies follow from each plant's own height.
	bool has_grades() const { return mode[0].period.slope != 0.0f; }

	bool operator==(const StemConstants &other) const {
		static_assert(sizeof(StemConstants) ==
						4 * (10 + 12 * MAX_STEM_MODES + 6 * STEM_SHAPE_TERMS) +
								4 * (MAX_STEM_JOINTS + 1) * MAX_STEM_MODES,
				"no padding, so bytes say whether all numbers are the same");
		return std::memcmp(this, &other, sizeof(StemConstants)) == 0;
	}
};

} // namespace undergrowth
