#include "mesh/part_detail.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float POINT = 0.02f; // Fraction of the width: narrower tips are points.
constexpr float LID = 0.0015f; // m: narrower tips stay open.
constexpr int PYRAMID_ROWS = 1;
constexpr float SLENDER = 8.0f; // Length over width.
constexpr float SPIKE_ERROR = 0.06f;

const std::vector<PartDetail> BEAD_DETAILS = { { 4, 3 }, { 4, 2 }, { 3, PYRAMID_ROWS } };
const std::vector<PartDetail> BLADE_DETAILS = { { 5, 8 }, { 5, 6 }, { 3, 6 }, { 3, 4 }, { 3, 3 }, { 2, 4 }, { 2, 3 },
	{ 2, 2 }, { 2, 1 } };
const std::vector<PartDetail> AXIS_DETAILS = { { 10, 10 }, { 8, 8 }, { 6, 8 }, { 6, 6 }, { 5, 5 }, { 5, 4 }, { 4, 3 },
	{ 3, 3 }, { 3, 2 }, { 3, 1 }, { 2, 2 }, { 2, 1 } };

const std::vector<PartDetail> CLOSE_BLADE_DETAILS = { { 9, 18 }, { 7, 14 }, { 3, 12 } };
constexpr float TO_THE_ENDS = 0.8f; // 1: the row distances go to 0 at the ends.
constexpr int CLOSE_ROWS[] = { 12, 8, 6 }; // For parts with a wide mouth.
constexpr int MOUTH_SIDES = 20;
constexpr int LOBE_SIDES = 4;

float square(float value) {
	return value * value;
}

/// For close-ups: petals and leaves as sheets, bells and cups as tubes.
std::vector<PartDetail> close_details(const Part &part) {
	if (part.kind == PartKind::blade) {
		return CLOSE_BLADE_DETAILS;
	}
	std::vector<PartDetail> details;
	if (part.kind == PartKind::axis && (part.axis.open_tip || part.axis.lobes > 0)) {
		const int sides = part.axis.lobes > 0 ? LOBE_SIDES * part.axis.lobes : MOUTH_SIDES;
		for (const int rows : CLOSE_ROWS) {
			details.push_back({ sides, rows });
		}
	}
	return details;
}

float blade_error(const Part &part, const PartDetail &detail) {
	const BladeShape &blade = part.blade;
	const float curl = square(blade.fold) + square(blade.roll);
	float across = 0.0f;
	if (detail.columns < 5) {
		across = detail.columns == 3 ? 0.003f + 0.02f * square(blade.roll) : 0.015f + 0.06f * curl + 0.05f * blade.wave;
	}
	return across + (blade.teeth > 0 && !shows_teeth(part, detail) ? 0.03f : 0.0f);
}

float round_error(const PartDetail &detail) {
	return detail.columns == 2 ? 0.1f : 0.3f / static_cast<float>(detail.columns * detail.columns);
}

std::vector<float> blade_offsets(const Part &part, const PartDetail &detail) {
	std::vector<float> offsets;
	if (shows_teeth(part, detail)) {
		for (int i = 0; i < part.blade.teeth; i++) { // At the corners of the teeth (form/surface.cpp).
			const float teeth = static_cast<float>(part.blade.teeth);
			offsets.push_back(static_cast<float>(i) / teeth);
			offsets.push_back((static_cast<float>(i) + 0.75f) / teeth);
		}
		offsets.push_back(1.0f);
	} else if (detail.rows == 2) {
		offsets = { 0.0f, std::clamp(part.widths.widest(), 0.35f, 0.75f), 1.0f };
	} else if (detail.rows >= CLOSE_BLADE_DETAILS.back().rows) { // Closer together where an edge is round.
		for (int i = 0; i <= detail.rows; i++) {
			const float share = static_cast<float>(i) / static_cast<float>(detail.rows);
			const float ended = share * share * (3.0f - 2.0f * share);
			offsets.push_back(share + TO_THE_ENDS * (ended - share));
		}
	}
	return offsets;
}

} // namespace

bool is_even(const Part &part) {
	return part.widths.samples.empty() && part.widths.profile.rise == 0.0f && part.widths.profile.fall == 0.0f;
}

bool ends_in_point(const Part &part) {
	return part.kind == PartKind::bead || part.width_at(1.0f) <= POINT;
}

bool is_spike(const Part &part, const PartDetail &detail) {
	return part.kind == PartKind::blade && detail.columns == 2 && detail.rows == 1 && !ends_in_point(part) &&
			part.mean_length() >= SLENDER * part.width;
}

bool has_lid(const Part &part, const PartDetail &detail) {
	return part.kind == PartKind::axis && detail.columns > 3 && !part.axis.open_tip &&
			part.width_at(1.0f) * part.width > LID;
}

bool shows_teeth(const Part &part, const PartDetail &detail) {
	return part.kind == PartKind::blade && part.blade.teeth > 0 && detail.rows == 2 * part.blade.teeth;
}

std::vector<PartDetail> details_of(const Part &part, bool is_close) {
	if (part.kind == PartKind::bead) {
		return BEAD_DETAILS;
	}
	std::vector<PartDetail> details = is_close ? close_details(part) : std::vector<PartDetail>();
	const std::vector<PartDetail> &usual = part.kind == PartKind::axis ? AXIS_DETAILS : BLADE_DETAILS;
	details.insert(details.end(), usual.begin(), usual.end());
	if (part.kind == PartKind::blade && part.blade.teeth > 0) {
		details.insert(details.begin(), { 3, 2 * part.blade.teeth });
	}
	if (part.kind == PartKind::blade && part.blade.roll == 0.0f &&
			part.blade.wave == 0.0f) { // Five columns look the same as three.
		const auto is_fine = [](const PartDetail &detail) { return detail.columns > 3; };
		details.erase(std::remove_if(details.begin(), details.end(), is_fine), details.end());
	}
	// Removes details that do not cost less than a finer one.
	for (size_t i = 1; i < details.size();) {
		if (count_part(part, details[i]).vertices < count_part(part, details[i - 1]).vertices) {
			i++;
		} else {
			details.erase(details.begin() + static_cast<std::ptrdiff_t>(i));
		}
	}
	return details;
}

MeshCounts count_part(const Part &part, const PartDetail &detail) {
	const int c = detail.columns;
	const int rows = detail.rows;
	if (part.kind == PartKind::bead) { // Two poles, or a ring and a pole.
		return rows == PYRAMID_ROWS ? MeshCounts{ c + 1, 3 * c } : MeshCounts{ c * (rows - 1) + 2, 6 * c * (rows - 1) };
	}
	const bool is_sheet = part.kind == PartKind::blade || c == 2;
	const int spans = is_sheet ? c - 1 : c;
	const bool pointed = (ends_in_point(part) && !part.axis.open_tip) || is_spike(part, detail);
	const bool lid = has_lid(part, detail);
	const int rings = pointed ? rows : rows + 1;
	const int triangles = 2 * spans * (rings - 1) + (pointed || lid ? spans : 0);
	return { c * rings + (pointed || lid ? 1 : 0), 3 * triangles };
}

float error_of(const Part &part, const PartDetail &detail) {
	if (part.kind == PartKind::bead) {
		return detail.rows == PYRAMID_ROWS ? 0.06f : 0.02f * static_cast<float>(3 - detail.rows);
	}
	const float span = 1.0f / static_cast<float>(detail.rows);
	// A single row runs from the base's width to the tip's and omits a wider middle.
	const bool is_one = detail.rows == 1 && part.kind == PartKind::blade;
	const float inside = is_one ? 0.6f * std::max(part.widths.widest() - 0.2f, 0.0f) : 0.0f;
	const float edge = is_spike(part, detail) ? SPIKE_ERROR : is_even(part) ? 0.0f : 0.06f * square(span) + inside;
	const float chord = (is_one ? 0.06f : 0.04f) * square(std::abs(part.curve.bend) * span) +
			0.2f * square(part.curve.wander * span);
	return edge + chord + (part.kind == PartKind::blade ? blade_error(part, detail) : round_error(detail));
}

std::vector<float> row_offsets(const Part &part, const PartDetail &detail) {
	if (part.kind == PartKind::bead && detail.rows == PYRAMID_ROWS) {
		return { std::clamp(part.widths.widest() - 0.2f, 0.0f, 0.8f), 1.0f };
	}
	std::vector<float> offsets = part.kind == PartKind::axis ? std::vector<float>() : blade_offsets(part, detail);
	for (int i = 0; i <= detail.rows && static_cast<int>(offsets.size()) <= detail.rows; i++) {
		offsets.push_back(static_cast<float>(i) / static_cast<float>(detail.rows));
	}
	return offsets;
}

} // namespace undergrowth
