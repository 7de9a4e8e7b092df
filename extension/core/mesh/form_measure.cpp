#include "mesh/form_measure.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"
#include "mesh/openness.hpp"
#include "mesh/part_template.hpp"
#include "mesh/shown_tone.hpp"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr int COLOR_SAMPLES = 12;
constexpr float SMALL = 0.07f; // Fraction of a plant's height.

/// True if a part is so small that the shape of its edges is not visible.
bool is_small(const Part &part, float height) {
	return std::max(part.mean_length(), part.width) < SMALL * height;
}

bool is_curled(const BladeShape &blade) {
	return blade.fold != 0.0f || blade.roll != 0.0f || blade.wave != 0.0f;
}

/// Fine enough to measure the true surface, except for the factors in fill_of().
PartDetail measured_detail(const Part &part, float height) {
	if (part.kind == PartKind::bead) {
		return { 4, 2 };
	}
	if (part.kind == PartKind::blade) {
		const PartDetail small = is_curled(part.blade) ? PartDetail{ 3, 4 } : PartDetail{ 2, 3 };
		return is_small(part, height) ? small : details_of(part).front();
	}
	const PartDetail small = is_even(part) ? PartDetail{ 3, 2 } : PartDetail{ 4, 4 };
	return is_small(part, height) ? small : PartDetail{ part.axis.lobes > 0 ? 10 : 5, 6 };
}

/// Area of a part of mean size; both sides count as one.
float area_of(const Part &part, const PartTemplate &shape) {
	float twice = 0.0f;
	for (size_t i = 0; i < shape.indices.size(); i += 3) {
		glm::vec3 corners[3];
		for (size_t k = 0; k < 3; k++) {
			const SurfacePoint &point = shape.vertices[static_cast<size_t>(shape.indices[i + k])].point;
			corners[k] = point.middle * part.mean_length() + point.aside * part.width;
		}
		twice += glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
	}
	return 0.5f * twice;
}

/// Correction of the mean area from the side. A circle is wider than the polygon in it, and a bead is larger than its
/// two cones. The outline of a small leaf is rounder than its mesh.
float fill_of(const Part &part, const Midrib &midrib, const PartTemplate &shape, float height, float mean_width,
		const glm::vec4 &color) {
	const PartDetail detail = measured_detail(part, height);
	if (part.kind == PartKind::blade) {
		const PartDetail fine = details_of(part).front();
		const float area = detail == fine ? 0.0f : area_of(part, shape);
		return area > 0.0f ? area_of(part, make_part_template(part, midrib, fine, color)) / area : 1.0f;
	}
	const double half_turn = PI / detail.columns;
	const double round = half_turn / portable_sin(half_turn);
	const float cones = std::max(part.widths.at(0.5f), 0.1f); // Their widest position is in the middle.
	return static_cast<float>(round) * (part.kind == PartKind::bead ? 2.0f * mean_width / cones : 1.0f);
}

/// All parts as they grew, in one mesh.
struct Whole {
	std::vector<glm::vec3> points;
	std::vector<glm::vec3> light; ///< As materials show it.
	std::vector<float> tones;
	std::vector<int32_t> indices;

	explicit Whole(const PlantForm &form) : openness(form) {}
	/// Adds a part; returns its shown area (m²), of both sides.
	float add(const PlacedPart &part, const PartTemplate &shape, float fill, Venation veins) {
		const int32_t first = static_cast<int32_t>(points.size());
		for (const TemplateVertex &vertex : shape.vertices) {
			points.push_back(part.base +
					PlantForm::turned(
							part.axes, vertex.point.middle * part.length + vertex.point.aside * (part.width * fill)));
			const float tone = tone_of(openness.at(points.back())) * petal_tone(veins, vertex.uv.y);
			const glm::vec3 own(to_light(vertex.color.x), to_light(vertex.color.y), to_light(vertex.color.z));
			light.push_back(own * tone);
			tones.push_back(tone);
		}
		float twice = 0.0f;
		for (size_t i = 0; i < shape.indices.size(); i += 3) {
			const int32_t *corner = shape.indices.data() + i;
			const glm::vec3 *own = points.data() + first;
			twice += twice_shown(own[corner[0]], own[corner[1]], own[corner[2]]);
			indices.insert(indices.end(), { first + corner[0], first + corner[1], first + corner[2] });
		}
		return 0.5f * twice;
	}

private:
	const Openness openness;
};

float mean_translucency(const PlantForm &form, const std::vector<float> &shown) {
	float sum = 0.0f;
	float whole = 1e-12f;
	for (size_t g = 0; g < shown.size(); g++) {
		sum += shown[g] * form.parts[static_cast<size_t>(form.groups[g].kind)].translucency;
		whole += shown[g];
	}
	return sum / whole;
}

SeenMesh seen(const Whole &whole) {
	return { whole.points.data(), static_cast<int>(whole.points.size()), whole.indices.data(),
		static_cast<int>(whole.indices.size()) };
}

void measure_whole(const Whole &whole, FormMeasure &measure) {
	for (const glm::vec3 &point : whole.points) {
		measure.box.take_in(point);
	}
	if (!measure.box.is_empty()) {
		const SeenMesh mesh = seen(whole);
		measure.outlines = outline_areas(mesh, measure.box);
		measure.from_above = area_from_above(mesh);
		const std::vector<float> shares = seen_shares(mesh, measure.box);
		measure.tone = 0.0f;
		for (size_t i = 0; i < shares.size(); i++) {
			measure.light += whole.light[i] * shares[i];
			measure.tone += whole.tones[i] * shares[i];
		}
	}
}

/// Adds all parts, and sets the colours, widths and shown areas of `measure`.
Whole grow_whole(const PlantForm &form, FormMeasure &measure) {
	std::vector<PartTemplate> shapes(form.parts.size());
	std::vector<float> fills(form.parts.size());
	Whole whole(form);
	measure.shown.resize(form.groups.size(), 0.0f);
	for (const Part &part : form.parts) {
		measure.colors.push_back(mean_color(part));
		measure.mean_widths.push_back(part.widths.mean());
	}
	for (const PlacedPart &placed : form.placed) {
		const size_t kind = static_cast<size_t>(placed.kind);
		const Part &part = form.parts[kind];
		PartTemplate &shape = shapes[kind];
		const bool is_first = shape.vertices.empty();
		if (is_first || placed.own_midrib >= 0) {
			shape = make_part_template(
					part, form.midrib_of(placed), measured_detail(part, form.height), measure.colors[kind]);
		}
		if (is_first) {
			fills[kind] = fill_of(
					part, form.midrib_of(placed), shape, form.height, measure.mean_widths[kind], measure.colors[kind]);
		}
		measure.shown[static_cast<size_t>(placed.group)] +=
				near_share(part.kind) * whole.add(placed, shape, fills[kind], venation_of(part));
	}
	return whole;
}

} // namespace

float near_share(PartKind kind) {
	return kind == PartKind::blade ? 1.0f : 0.5f;
}

glm::vec4 mean_color(const Part &part) {
	glm::vec3 squares(0.0f);
	float alpha = 0.0f;
	float weight = 0.0f;
	for (int i = 0; i < COLOR_SAMPLES; i++) {
		const float s = (static_cast<float>(i) + 0.5f) / COLOR_SAMPLES;
		const glm::vec4 color = part.colors.at(s, 0.5f);
		const float width = part.width_at(s) + 1e-6f;
		squares += glm::vec3(color) * glm::vec3(color) * width;
		alpha += color.w * width;
		weight += width;
	}
	return glm::vec4(glm::sqrt(squares / weight), alpha / weight);
}

FormMeasure measure_form(const PlantForm &form) {
	FormMeasure measure;
	measure.attachments = attach_parts(form);
	const Whole whole = grow_whole(form, measure);
	measure.translucency = mean_translucency(form, measure.shown);
	measure_whole(whole, measure);
	return measure;
}

LevelError measure_outline(const PlantForm &form) {
	FormMeasure measure;
	return LevelError(seen(grow_whole(form, measure)));
}

} // namespace undergrowth
