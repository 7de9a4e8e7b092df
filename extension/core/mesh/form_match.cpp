#include "mesh/form_match.hpp"

#include "mesh/outline_fit.hpp"
#include "mesh/plan_steps.hpp"

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
constexpr float VIVID_WORTH = 1.0f; // Additional worth of a colour that changes least.
constexpr float MIN_PLAINNESS = 0.5f;
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

/// By vertex: 1 for colours near the mean of the plant, as of leaves, and less for conspicuous ones. A white flower
/// that took on the difference of the leaves would become green, which is seen in a whole field of coarse plants.
std::vector<float> plainness(const std::vector<glm::vec3> &light, const glm::vec3 &mean) {
	if (light.size() >= COARSE_VERTICES) {
		return std::vector<float>(light.size(), 1.0f);
	}
	const auto color_of = [](const glm::vec3 &one) {
		return glm::vec3(from_light(one.x), from_light(one.y), from_light(one.z));
	};
	std::vector<float> plain;
	plain.reserve(light.size());
	for (const glm::vec3 &own : light) {
		const float worth = worth_of(color_of(own), color_of(mean)) - 1.0f;
		plain.push_back(1.0f - (1.0f - MIN_PLAINNESS) * std::min(worth / VIVID_WORTH, 1.0f));
	}
	return plain;
}

void match_colors(const FormMeasure &measure, const std::vector<WrittenUnit> &units, const FormBuffers &mesh) {
	const std::vector<float> shares = seen_shares(seen(mesh, units), measure.box);
	std::vector<glm::vec3> light;
	light.reserve(static_cast<size_t>(units.back().vertex));
	for (int i = 0; i < units.back().vertex; i++) {
		const glm::vec4 &color = mesh.colors[i];
		light.emplace_back(to_light(color.x), to_light(color.y), to_light(color.z));
	}
	const std::vector<float> plain = plainness(light, measure.light);
	glm::vec3 gains(1.0f);
	const auto scaled = [&](size_t i) {
		return glm::min(light[i] * (glm::vec3(1.0f) + (gains - 1.0f) * plain[i]), glm::vec3(1.0f));
	};
	for (int step = 0; step < COLOR_STEPS; step++) { // Several steps, because no colour can exceed white.
		glm::vec3 plain_light(0.0f), mean(0.0f);
		for (size_t i = 0; i < shares.size(); i++) {
			mean += scaled(i) * shares[i];
			plain_light += light[i] * gains * plain[i] * shares[i];
		}
		const glm::vec3 wanted = glm::max(plain_light + measure.light - mean, glm::vec3(0.0f));
		gains = glm::clamp(gains * (wanted + 1e-4f) / (plain_light + 1e-4f), 1.0f / MAX_GAIN, MAX_GAIN);
	}
	glm::vec3 more(0.0f); // If a component is too dark to be scaled.
	const auto shifted = [&](size_t i) { return glm::clamp(scaled(i) + more * plain[i], 0.0f, 1.0f); };
	for (int step = 0; step < COLOR_STEPS; step++) {
		glm::vec3 mean(0.0f);
		for (size_t i = 0; i < shares.size(); i++) {
			mean += shifted(i) * shares[i];
		}
		more = glm::clamp(more + measure.light - mean, -MAX_REMOVED_LIGHT, MAX_ADDED_LIGHT);
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
