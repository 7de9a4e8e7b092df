#include "mesh/form_match.hpp"

#include "mesh/outline_fit.hpp"
#include "mesh/shown_tone.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr int STEPS = 7;
constexpr int FEW_STEPS = 1; // From FINE_VERTICES on, where meshes are nearly exact.
constexpr int LOOSE_STEPS = 20; // Below COARSE_VERTICES, where parts are not recognizable.
constexpr int FINE_VERTICES = 400;
constexpr int COARSE_VERTICES = 60;
constexpr float MATCHED = 0.015f; // Error of each outline.
constexpr float TOLERATED = 0.03f; // A larger error starts a search.
constexpr int COLOR_STEPS = 4;
constexpr float MAX_GAIN = 1.8f; // Maximum factor of a colour in linear light; the minimum is its reciprocal.
constexpr float MAX_ADDED_LIGHT = 0.15f; // Maximum of linear light that is added to all colours.
constexpr float MAX_REMOVED_LIGHT = 0.06f; // Maximum that is subtracted: white stays white.

SeenMesh seen(const FormBuffers &mesh, const std::vector<WrittenUnit> &units) {
	return { mesh.positions, units.back().vertex, mesh.indices, units.back().index };
}

float worst_of(const Outlines &areas, const Outlines &wanted) {
	float worst = 0.0f;
	for (size_t side = 0; side < OUTLINES; side++) {
		worst = std::max(worst, std::abs(areas[side] / wanted[side] - 1.0f));
	}
	return worst;
}

void match_outlines(const FormMeasure &measure, const std::vector<WrittenUnit> &units, const FormBuffers &mesh) {
	Outlines areas = outline_areas(seen(mesh, units), measure.box);
	float best = worst_of(areas, measure.outlines);
	if (best < MATCHED) {
		return;
	}
	OutlineFit fit(units, mesh);
	const auto go = [&](int steps) {
		for (int step = 0; step < steps && best >= MATCHED; step++) {
			fit.approach(areas, measure.outlines);
			areas = outline_areas(seen(mesh, units), measure.box);
			const float worst = worst_of(areas, measure.outlines);
			if (worst < best) {
				best = worst;
				fit.keep();
			}
		}
		fit.finish();
	};
	go(units.back().vertex < FINE_VERTICES ? STEPS : FEW_STEPS);
	if (best >= MATCHED && units.back().vertex < COARSE_VERTICES) {
		fit.detach();
		areas = outline_areas(seen(mesh, units), measure.box);
		go(LOOSE_STEPS);
	}
	if (best >= TOLERATED) {
		fit.search(measure.box, measure.outlines, MATCHED, best);
	}
}

/// Venation of a vertex by its code (mesh/vertex_format.hpp).
Venation veins_of(const glm::vec4 &custom0) {
	return static_cast<Venation>(static_cast<int>(custom0.z) + static_cast<int>(Venation::none));
}

/// Weights of all colours in the mean that materials show.
std::vector<float> shown_shares(
		const FormMeasure &measure, const std::vector<WrittenUnit> &units, const FormBuffers &mesh) {
	std::vector<float> shares = seen_shares(seen(mesh, units), measure.box);
	for (size_t i = 0; i < shares.size(); i++) {
		shares[i] *= tone_of(mesh.colors[i].w) * petal_tone(veins_of(mesh.custom0[i]), mesh.uvs[i].y);
	}
	return shares;
}

void match_colors(const FormMeasure &measure, const std::vector<WrittenUnit> &units, const FormBuffers &mesh) {
	const std::vector<float> shares = shown_shares(measure, units, mesh);
	float tone = 0.0f; // Mean.
	std::vector<glm::vec3> light;
	light.reserve(static_cast<size_t>(units.back().vertex));
	for (int i = 0; i < units.back().vertex; i++) {
		const glm::vec4 &color = mesh.colors[i];
		light.emplace_back(to_light(color.x), to_light(color.y), to_light(color.z));
		tone += shares[static_cast<size_t>(i)];
	}
	glm::vec3 gains(1.0f);
	for (int step = 0; step < COLOR_STEPS; step++) { // Several steps, because no colour can exceed white.
		glm::vec3 mean(0.0f);
		for (size_t i = 0; i < shares.size(); i++) {
			mean += glm::min(light[i] * gains, glm::vec3(1.0f)) * shares[i];
		}
		gains = glm::clamp(gains * (measure.light + 1e-4f) / (mean + 1e-4f), 1.0f / MAX_GAIN, MAX_GAIN);
	}
	glm::vec3 more(0.0f); // If a component is too dark to be scaled.
	const auto shifted = [&](size_t i) { return glm::clamp(light[i] * gains + more, 0.0f, 1.0f); };
	for (int step = 0; step < COLOR_STEPS; step++) {
		glm::vec3 mean(0.0f);
		for (size_t i = 0; i < shares.size(); i++) {
			mean += shifted(i) * shares[i];
		}
		more += (measure.light - mean) / std::max(tone, 1e-4f);
		more = glm::clamp(more, -MAX_REMOVED_LIGHT, MAX_ADDED_LIGHT);
	}
	for (size_t i = 0; i < light.size(); i++) {
		light[i] = shifted(i);
	}
	from_light(reinterpret_cast<float *>(light.data()), 3 * units.back().vertex);
	for (size_t i = 0; i < light.size(); i++) {
		mesh.colors[i] = { light[i].x, light[i].y, light[i].z, mesh.colors[i].w };
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
