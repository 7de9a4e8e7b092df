#pragma once

#include "form/midrib.hpp"
#include "form/profile.hpp"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <string>
#include <vector>

namespace undergrowth {

// What parts plants are made of, as a species describes them: three shapes. This is plain
// data; form/arrangement.hpp places parts, form/surface.hpp evaluates their surfaces.

enum class PartKind {
	axis, ///< Round and long: stem, twig, petiole, rachis, awn; with an open tip a bell or a trumpet.
	blade, ///< An open sheet on a midrib: leaf, petal, ray, bract, pinna.
	bead, ///< Small, closed and straight: floret, spikelet, anther, seed.
};

/// Veins that materials draw on a part.
enum class Venation {
	automatic, ///< By the shape and the colour: see venation_of().
	none,
	parallel, ///< Along the part: grasses, lilies.
	pinnate, ///< From the midrib to the edges: most leaves.
	palmate, ///< From the base in all directions: ivy, clover.
	radial, ///< Fine and forked, from the base to the tip: petals.
};

/// What only an axis has.
struct AxisShape {
	float tip_diameter = 0.001f; ///< m at the tip, 0 to 10. In between it runs evenly, times the width function.
	bool open_tip = false; ///< Nothing closes it, and both of its sides are seen.
	int lobes = 0; ///< Ridges around it, 0 to 64.
	float lobe_depth = 0.0f; ///< 0 to 0.9, of the radius.
	/// A ring (conventions.hpp) of any size that is not round; the width is that of a circle around it. Empty: round.
	std::vector<glm::vec2> ring;
};

/// What only a blade has. Cross-section and folds after the frond of SpeedTree and Infinigen's leaves.
struct BladeShape {
	float fold = 0.0f; ///< rad, ±1.5: how far each half is lifted about the midrib.
	float roll = 0.0f; ///< rad, ±6: how far each half curls up from midrib to edge.
	float twist = 0.0f; ///< rad, ±20: how far the tip is turned about the midrib.
	float wave = 0.0f; ///< 0 to 1: how high the edges wave, in shares of the half-width.
	float wave_count = 3.0f; ///< Waves along the blade, 0 to 32.
	int teeth = 0; ///< Along each edge, 0 to 32.
	float tooth_depth = 0.25f; ///< 0 to 0.9, of the half-width.
	float roundness = 0.35f; ///< rad, 0 to 1: how far normals lean out at the edges, so that a flat sheet looks full.
};

/// The colours of a part along it and, where a script says so, from its midrib to its edges.
struct PartColors {
	static constexpr int ROWS = 17; ///< At equal offsets from base to tip.
	static constexpr int COLUMNS = 3; ///< At the midrib, half way, at the edge.

	glm::vec4 base = glm::vec4(0.25f, 0.4f, 0.15f, 1.0f);
	glm::vec4 tip = glm::vec4(0.55f, 0.65f, 0.3f, 1.0f);
	std::vector<glm::vec4> samples; ///< Replaces base and tip: ROWS · COLUMNS colours, row by row; or empty.

	/// At the offset `s` from 0 to 1 and `across` from 0 (midrib) to 1 (edge).
	glm::vec4 at(float s, float across) const;
};

struct Part {
	PartKind kind = PartKind::blade;
	float length_min = 0.1f; ///< m, 1e-4 to 100; each seed draws its length from this range.
	float length_max = 0.1f; ///< m, from length_min on.
	float width = 0.02f; ///< m, 1e-5 to 10: of a blade from edge to edge, of an axis at its base, else the diameter.
	WidthFunction widths;
	MidribCurve curve;
	AxisShape axis;
	BladeShape blade;
	PartColors colors;
	float translucency = 0.0f; ///< 0 to 1: fraction of the light from behind that passes through.
	Venation venation = Venation::automatic;
	float frequency = 3.0f; ///< Hz, 0 to 100: of its small swing on its carrier; 0: rigid.
	float damping_ratio = 0.12f; ///< 0 to 100, 1 is critical.

	float mean_length() const { return 0.5f * (length_min + length_max); }
	/// Tip diameter relative to `width`; 1 for blades and beads.
	float taper() const { return kind == PartKind::axis ? axis.tip_diameter / width : 1.0f; }
	/// Diameter or width at the offset, relative to `width`.
	float width_at(float s) const { return widths.at(s) * (1.0f + (taper() - 1.0f) * s); }
};

/// The veins of a part; never `automatic`. Stems and beads have none. Blades of a colour other than green, and open
/// tubes, are petals with radial veins. Long narrow blades have parallel veins, all others pinnate ones.
Venation venation_of(const Part &part);

/// Why a part cannot grow and the remedy, in one sentence that begins with the property; empty if it can.
std::string find_part_fault(const Part &part);

} // namespace undergrowth
