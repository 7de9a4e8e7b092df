#include "mesh/form_match.hpp"

#include "mesh/outline_fit.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr int STEPS = 6;
constexpr float MATCHED = 0.01f; // Of each outline.
constexpr int COLOR_STEPS = 2;
constexpr float MOST_GAIN = 1.8f; // Of a colour in linear light, and the least's reciprocal.

SeenMesh seen(const FormBuffers &mesh, const std::vector<WrittenUnit> &units, const glm::vec3 *light) {
	return { mesh.positions, light, units.back().vertex, mesh.indices, units.back().index };
}

void match_outlines(const FormMeasure &measure, const std::vector<WrittenUnit> &units, const FormBuffers &mesh) {
	OutlineFit fit(units, mesh);
	for (int step = 0; step < STEPS; step++) {
		const Outlines areas = outline_areas(seen(mesh, units, nullptr), measure.box);
		float worst = 0.0f;
		for (size_t side = 0; side < OUTLINES; side++) {
			worst = std::max(worst, std::abs(areas[side] - measure.outlines[side]) / measure.outlines[side]);
		}
		if (worst < MATCHED) {
			return;
		}
		fit.approach(areas, measure.outlines);
	}
}

void match_colors(const FormMeasure &measure, const std::vector<WrittenUnit> &units, const FormBuffers &mesh) {
	std::vector<glm::vec3> light;
	for (int i = 0; i < units.back().vertex; i++) {
		const glm::vec4 &color = mesh.colors[i];
		light.emplace_back(to_light(color.x), to_light(color.y), to_light(color.z));
	}
	for (int step = 0; step < COLOR_STEPS; step++) {
		glm::vec3 mean;
		if (!seen_light(seen(mesh, units, light.data()), measure.box, mean)) {
			return;
		}
		const glm::vec3 gain = glm::clamp((measure.light + 1e-4f) / (mean + 1e-4f), 1.0f / MOST_GAIN, MOST_GAIN);
		for (glm::vec3 &own : light) {
			own = glm::min(own * gain, glm::vec3(1.0f));
		}
	}
	for (int i = 0; i < units.back().vertex; i++) {
		const glm::vec3 &own = light[static_cast<size_t>(i)];
		mesh.colors[i] = { from_light(own.x), from_light(own.y), from_light(own.z), mesh.colors[i].w };
	}
}

} // namespace

void match_form(const FormMeasure &measure, const std::vector<WrittenUnit> &units, const FormBuffers &mesh) {
	if (units.size() < 2 || measure.box.is_empty() ||
			!(*std::min_element(measure.outlines.begin(), measure.outlines.end()) > 0.0f)) {
		return;
	}
	match_outlines(measure, units, mesh);
	match_colors(measure, units, mesh);
}

} // namespace undergrowth
