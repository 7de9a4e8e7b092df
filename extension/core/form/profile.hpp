#pragma once

#include <vector>

namespace undergrowth {

/// How the width of a part runs along it: w(s) = (s/s0)^rise · ((1 - s)/(1 - s0))^fall with its widest place at
/// s0 = rise/(rise + fall), where w is 1. Both exponents from 0 to 8; with both 0 it is 1 everywhere.
struct Profile {
	float rise = 0.5f; ///< 0: full width at the base.
	float fall = 0.5f; ///< 0: full width at the tip.
};

// Leaves and petals by their outlines. The area of each, in shares of length times width, is in brackets; wheat
// measures 0.80 (Dornbusch et al. 2011).
inline constexpr Profile GRASS_PROFILE = { 0.12f, 0.45f }; ///< [0.80]
inline constexpr Profile STRAP_PROFILE = { 0.1f, 0.3f }; ///< [0.86]
inline constexpr Profile LANCEOLATE_PROFILE = { 0.6f, 1.0f }; ///< [0.69]
inline constexpr Profile OVATE_PROFILE = { 0.4f, 1.1f }; ///< [0.67]
inline constexpr Profile ELLIPTIC_PROFILE = { 0.5f, 0.5f }; ///< [0.79], an ellipse.
inline constexpr Profile OBOVATE_PROFILE = { 1.2f, 0.35f }; ///< [0.64]
inline constexpr Profile SPATULATE_PROFILE = { 2.0f, 0.4f }; ///< [0.52]
inline constexpr Profile TEPAL_PROFILE = { 0.7f, 0.55f }; ///< [0.75]
inline constexpr Profile RAY_PROFILE = { 0.6f, 0.25f }; ///< [0.78]
inline constexpr Profile EVEN_PROFILE = { 0.0f, 0.0f }; ///< [1], stems.

/// A width as a function of the offset: a profile, or what a script or a curve said of it.
struct WidthFunction {
	Profile profile;
	float base_width = 0.0f; ///< 0 to 1: below the widest place never narrower than this share.
	/// Replaces the profile: samples at equal offsets from 0 to 1, each finite, 0 to 100. Empty, or at least 2.
	std::vector<float> samples;

	/// Offset of the widest place, 0 to 1.
	float widest() const;
	/// Whether the tip is cut off instead of running out into a point: where the profile falls by 0.4 or less.
	bool is_blunt() const;
	/// Width at `s` from 0 to 1, as a share of the part's width.
	float at(float s) const;
	/// How fast the width changes per unit of offset. Next to both ends it is that of 1 % inside, for roots have no
	/// finite slope at 0.
	float slope(float s) const;
	/// The same with a given width at `s`.
	float slope(float s, float width) const;
	/// The mean width: the area of a flat part in shares of its length times its width. Within 1e-3.
	float mean() const;
};

} // namespace undergrowth
