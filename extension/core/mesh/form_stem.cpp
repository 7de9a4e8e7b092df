#include "mesh/form_stem.hpp"

#include "conventions.hpp"
#include "mesh/part_attachment.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace undergrowth {

namespace {

constexpr int BINS = 8; // Bins along the stem: loads within one bin are combined.
constexpr int SAMPLES = 8; // Samples of a part's width.
constexpr float MAX_TAPER = 0.9f;
constexpr float MIN_DIAMETER = 2e-4f; // m.
constexpr float HEAD_FROM = 0.95f; // Stem offset from which parts belong to the head.

// Values for fresh plants.
constexpr float SHEET_MASS = 0.2f; // kg/m²: a leaf 0.25 mm thick.
constexpr float AXIS_DENSITY = 800.0f; // kg/m³.
constexpr float BEAD_DENSITY = 500.0f;
constexpr float LATHE_DENSITY = 300.0f; // kg/m³: of a head drawn as one body, with petals and air.
constexpr float THINNEST_SHEET = 2.5e-4f; // m.
constexpr float SHEET_SLENDERNESS = 20.0f; // Width divided by thickness.
// Drag coefficients for the drawn area; leaves have any angle to the wind.
constexpr float SHEET_DRAG = 0.7f;
constexpr float AXIS_DRAG = 1.1f;
constexpr float BEAD_DRAG = 0.6f;
constexpr float BLADE_STEM_DRAG = 1.5f;
constexpr float WIDER = 1.5f; // Ratio of the stem's width at which a ring of a lathe belongs to the head.

struct Carried {
	float mass; // kg.
	float drag_area; // m².
};

float mean_width(const Part &part, const PlacedPart &placed) {
	float sum = 0.0f;
	for (int i = 0; i < SAMPLES; i++) {
		sum += part.width_at((static_cast<float>(i) + 0.5f) / SAMPLES);
	}
	return placed.width * sum / SAMPLES;
}

Carried carried_by(const Part &part, const PlacedPart &placed) {
	const float width = mean_width(part, placed);
	const float area = width * placed.length;
	const float round = static_cast<float>(PI) / 4.0f * width;
	switch (part.kind) {
		case PartKind::blade:
			return { SHEET_MASS * area, SHEET_DRAG * area };
		case PartKind::axis:
			return { AXIS_DENSITY * round * area, AXIS_DRAG * area };
		default:
			return { BEAD_DENSITY * round * area, BEAD_DRAG * area };
	}
}

/// Returns the index of the placed part that is the stem; -1 if no part is on the ground.
int stem_of(const PlantForm &form) {
	int longest = form.stem;
	for (size_t i = 0; form.stem == PlantForm::NO_STEM && i < form.placed.size(); i++) {
		const bool is_longer = longest < 0 || form.placed[i].length > form.placed[static_cast<size_t>(longest)].length;
		longest = form.placed[i].carrier == ON_GROUND && is_longer ? static_cast<int>(i) : longest;
	}
	return longest;
}

void measure_stem(const Part &part, const PlacedPart &placed, StemBeam &beam) {
	const float base = std::max(part.width_at(0.1f), part.width_at(0.0f)); // Some stems begin with a point.
	const float tip = part.width_at(0.9f);
	const bool is_sheet = part.kind == PartKind::blade;
	const float widest = is_sheet ? std::max(base, part.width_at(0.4f)) : base;
	beam.diameter = std::max(placed.width * widest, MIN_DIAMETER);
	beam.taper = std::clamp(1.0f - tip / std::max(widest, 1e-6f), 0.0f, MAX_TAPER);
	if (is_sheet) {
		beam.section = StemBeam::Section::blade;
		beam.thickness = std::max(THINNEST_SHEET, beam.diameter / SHEET_SLENDERNESS);
		beam.drag_coefficient = BLADE_STEM_DRAG;
	}
}

/// Limits sizes, because drawn plants may have any: a stem is not wider than long and not heavier than a tree.
void keep_sound(StemBeam &beam) {
	constexpr float MAX_MASS = 1000.0f; // kg, also for the next one: describe(StemFault).
	constexpr float MAX_AREA = 100.0f; // m².
	beam.diameter = std::clamp(beam.diameter, std::min(MIN_DIAMETER, beam.length), beam.length);
	beam.thickness = std::min(beam.thickness, beam.diameter);
	beam.head_mass = std::min(beam.head_mass, MAX_MASS);
	beam.head_drag_area = std::min(beam.head_drag_area, MAX_AREA);
	beam.head_centre = std::min(beam.head_centre, beam.length);
	for (StemBeam::Load &load : beam.loads) {
		load.mass = std::min(load.mass, MAX_MASS);
		load.drag_area = std::min(load.drag_area, MAX_AREA);
	}
}

} // namespace

void carry_parts(const PlantForm &form, StemBeam &beam) {
	const int stem = stem_of(form);
	if (stem < 0) {
		return;
	}
	measure_stem(form.parts[static_cast<size_t>(form.placed[static_cast<size_t>(stem)].kind)],
			form.placed[static_cast<size_t>(stem)], beam);
	const std::vector<PartAttachment> attachments = attach_parts(form);
	std::vector<bool> is_on_stem(form.placed.size(), false);
	is_on_stem[static_cast<size_t>(stem)] = true;
	std::array<StemBeam::Load, BINS> bins = {};
	float head_height = 0.0f; // kg·m, above the tip.
	for (size_t i = 0; i < form.placed.size(); i++) {
		const PlacedPart &placed = form.placed[i];
		if (placed.carrier == ON_GROUND || !is_on_stem[static_cast<size_t>(placed.carrier)]) {
			continue;
		}
		is_on_stem[i] = true;
		const Carried load = carried_by(form.parts[static_cast<size_t>(placed.kind)], placed);
		const float x = std::clamp(attachments[i].stem_offset, 0.0f, 1.0f);
		if (x >= HEAD_FROM) {
			beam.head_mass += load.mass;
			beam.head_drag_area += load.drag_area;
			head_height += load.mass * std::max(form.point_of(placed, 0.5f).y - form.height, 0.0f);
		} else {
			StemBeam::Load &bin = bins[static_cast<size_t>(x * BINS)];
			bin.mass += load.mass;
			bin.drag_area += load.drag_area;
		}
	}
	beam.head_centre = beam.head_mass > 0.0f ? head_height / beam.head_mass : 0.0f;
	for (size_t i = 0; i < BINS; i++) {
		if (bins[i].mass > 0.0f) {
			bins[i].place = (static_cast<float>(i) + 0.5f) / BINS;
			beam.loads.push_back(bins[i]);
		}
	}
	keep_sound(beam);
}

void carry_lathe(float radius, const std::vector<float> &widths, StemBeam &beam) {
	const size_t rings = widths.size();
	if (rings == 0) {
		return;
	}
	float lower = 0.0f;
	const size_t half = std::max<size_t>(rings / 2, 1);
	for (size_t i = 0; i < half; i++) {
		lower += widths[i] / static_cast<float>(half);
	}
	beam.diameter = std::max(2.0f * radius * lower, MIN_DIAMETER);
	const float step = beam.length / static_cast<float>(std::max<size_t>(rings - 1, 1));
	float narrowest = lower;
	for (size_t i = half; i < rings; i++) {
		const float width = 2.0f * radius * widths[i];
		if (widths[i] > WIDER * lower) {
			beam.head_mass += LATHE_DENSITY * static_cast<float>(PI) / 4.0f * width * width * step;
			beam.head_drag_area += BEAD_DRAG * width * step;
		} else {
			narrowest = std::min(narrowest, widths[i]);
		}
	}
	beam.taper = std::clamp(1.0f - narrowest / std::max(lower, 1e-6f), 0.0f, MAX_TAPER);
	keep_sound(beam);
}

} // namespace undergrowth
