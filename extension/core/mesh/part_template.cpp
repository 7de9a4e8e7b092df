#include "mesh/part_template.hpp"

#include "mesh/template_parts.hpp"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

namespace undergrowth {

namespace {

constexpr float RIBBON_ROUNDNESS = 0.9f; // rad: a ribbon is lit like the round stem that it replaces.

constexpr float RIBBON_TWIST = 1.75f; // rad: so that no view shows it edge-on everywhere.

/// A distant stem: a twisted ribbon. Its widths are samples, because blades do not taper by themselves.
PartTemplate make_ribbon_template(const Part &part, const Midrib &midrib, const PartDetail &detail) {
	constexpr int SAMPLES = 9;
	Part flat = part;
	flat.kind = PartKind::blade;
	flat.blade = BladeShape();
	flat.blade.roundness = RIBBON_ROUNDNESS;
	flat.blade.twist = RIBBON_TWIST;
	flat.widths.samples.clear();
	for (int i = 0; i < SAMPLES; i++) {
		flat.widths.samples.push_back(part.width_at(static_cast<float>(i) / (SAMPLES - 1)));
	}
	return make_sheet_template(flat, midrib, detail, false);
}

/// Returns the squared mean colour of a template's triangles, weighted by area for the part's length and width.
glm::vec3 drawn_squares(const PartTemplate &shape, const Part &part) {
	glm::vec3 sum(0.0f);
	float whole = 0.0f;
	for (size_t i = 0; i < shape.indices.size(); i += 3) {
		glm::vec3 points[3];
		glm::vec3 squares(0.0f);
		for (size_t k = 0; k < 3; k++) {
			const TemplateVertex &vertex = shape.vertices[static_cast<size_t>(shape.indices[i + k])];
			const glm::vec3 color(vertex.color);
			points[k] = vertex.point.middle * part.mean_length() + vertex.point.aside * part.width;
			squares += color * color;
		}
		const float area = glm::length(glm::cross(points[1] - points[0], points[2] - points[0]));
		sum += squares * area;
		whole += 3.0f * area;
	}
	return whole > 0.0f ? sum / whole : glm::vec3(0.0f);
}

/// With few vertices, base and tip would have too much weight.
void keep_mean_color(PartTemplate &shape, const Part &part, const glm::vec3 &mean) {
	const glm::vec3 more = mean * mean - drawn_squares(shape, part);
	for (TemplateVertex &vertex : shape.vertices) {
		const glm::vec3 color(vertex.color);
		vertex.color = glm::vec4(glm::sqrt(glm::max(color * color + more, glm::vec3(0.0f))), vertex.color.w);
	}
}

} // namespace

PartTemplate make_part_template(
		const Part &part, const Midrib &midrib, const PartDetail &detail, const glm::vec4 &mean_color) {
	PartTemplate out;
	if (part.kind == PartKind::bead) {
		out = make_bead_template(part, midrib, detail);
	} else if (part.kind == PartKind::blade) {
		out = make_sheet_template(part, midrib, detail, is_spike(part, detail));
	} else if (detail.columns == 2) {
		out = make_ribbon_template(part, midrib, detail);
	} else {
		out = make_tube_template(part, midrib, detail);
	}
	keep_mean_color(out, part, glm::vec3(mean_color));
	return out;
}

} // namespace undergrowth
