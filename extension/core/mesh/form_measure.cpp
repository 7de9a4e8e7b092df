#include "mesh/form_measure.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"
#include "mesh/part_template.hpp"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr int COLOR_SAMPLES = 12;

/// Fine enough that what is measured is the true surface's, but for what fill_of() makes good.
PartDetail measured_detail(const Part &part) {
	if (part.kind == PartKind::blade) {
		return details_of(part).front();
	}
	return part.kind == PartKind::bead ? PartDetail{ 4, 2 } : PartDetail{ part.axis.lobes > 0 ? 10 : 5, 6 };
}

/// From the side, on the mean, a circle is so much wider than the polygon in it; and a bead larger than its two cones.
float fill_of(const Part &part, float mean_width) {
	if (part.kind == PartKind::blade) {
		return 1.0f;
	}
	const double half_turn = PI / measured_detail(part).columns;
	const double round = half_turn / portable_sin(half_turn);
	const float cones = std::max(part.widths.at(0.5f), 0.1f); // Their widest place is in the middle.
	return static_cast<float>(round) * (part.kind == PartKind::bead ? 2.0f * mean_width / cones : 1.0f);
}

/// All parts as they grew, in one mesh.
struct Whole {
	std::vector<glm::vec3> points;
	std::vector<glm::vec3> light;
	std::vector<int32_t> indices;

	/// Adds a part; tells what it shows (m²), both sides.
	float add(const PlacedPart &part, const PartTemplate &shape, float fill) {
		const int32_t first = static_cast<int32_t>(points.size());
		for (const TemplateVertex &vertex : shape.vertices) {
			points.push_back(part.base +
					PlantForm::turned(
							part.axes, vertex.point.middle * part.length + vertex.point.aside * (part.width * fill)));
			light.emplace_back(to_light(vertex.color.x), to_light(vertex.color.y), to_light(vertex.color.z));
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
};

void measure_whole(const Whole &whole, FormMeasure &measure) {
	for (const glm::vec3 &point : whole.points) {
		measure.box.take_in(point);
	}
	if (!measure.box.is_empty()) {
		const SeenMesh seen = { whole.points.data(), static_cast<int>(whole.points.size()), whole.indices.data(),
			static_cast<int>(whole.indices.size()) };
		measure.outlines = outline_areas(seen, measure.box);
		const std::vector<float> shares = seen_shares(seen, measure.box);
		for (size_t i = 0; i < shares.size(); i++) {
			measure.light += whole.light[i] * shares[i];
		}
	}
}

} // namespace

float twice_shown(const glm::vec3 &a, const glm::vec3 &b, const glm::vec3 &c) {
	const glm::vec3 twice_area = glm::cross(b - a, c - a);
	return std::sqrt(twice_area.x * twice_area.x + twice_area.z * twice_area.z) * static_cast<float>(2.0 / PI);
}

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
	std::vector<PartTemplate> shapes(form.parts.size());
	Whole whole;
	measure.shown.resize(form.groups.size(), 0.0f);
	for (const Part &part : form.parts) {
		measure.colors.push_back(mean_color(part));
		measure.mean_widths.push_back(part.widths.mean());
	}
	for (const PlacedPart &placed : form.placed) {
		const Part &part = form.parts[static_cast<size_t>(placed.kind)];
		PartTemplate &shape = shapes[static_cast<size_t>(placed.kind)];
		if (shape.vertices.empty() || placed.own_midrib >= 0) {
			shape = make_part_template(part, form.midrib_of(placed), measured_detail(part));
		}
		measure.shown[static_cast<size_t>(placed.group)] += near_share(part.kind) *
				whole.add(placed, shape, fill_of(part, measure.mean_widths[static_cast<size_t>(placed.kind)]));
	}
	measure_whole(whole, measure);
	return measure;
}

} // namespace undergrowth
