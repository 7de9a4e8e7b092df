#include "stem/stem_bones.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float GAUSS_SIDE = 0.288675135f; // Of two quadrature points, from the middle.
constexpr float GAUSS_LOW = 0.11270167f; // Of three, from 0 to 1.
constexpr float GAUSS_HIGH = 0.88729833f;

/// The bend along a stem as a polynomial without a constant term.
class BendCurve {
public:
	BendCurve(const StemConstants &stem, const glm::vec2 *amplitudes) {
		glm::vec2 tip(0.0f);
		for (int k = 0; k < stem.modes; k++) {
			tip += stem.mode[k].tip_slope * amplitudes[k];
		}
		const float square = std::min(glm::dot(tip, tip), 1.0f);
		const glm::vec2 third = tip * square;
		const glm::vec2 fifth = third * square;
		for (int j = 0; j < STEM_SHAPE_TERMS; j++) {
			terms[j] = third * stem.shape[j][2] + fifth * stem.shape[j][3];
			for (int k = 0; k < stem.modes; k++) {
				terms[j] += stem.shape[j][k] * amplitudes[k];
			}
		}
	}

	glm::vec2 at(float x) const {
		glm::vec2 sum(0.0f);
		for (int j = STEM_SHAPE_TERMS - 1; j >= 0; j--) {
			sum = (sum + terms[j]) * x;
		}
		return sum;
	}

private:
	glm::vec2 terms[STEM_SHAPE_TERMS];
};

glm::vec3 direction_of(const glm::vec2 &bend) {
	const float square = glm::dot(bend, bend);
	const float share = 1.0f / (1.0f + square);
	return { 2.0f * share * bend.x, (1.0f - square) * share, 2.0f * share * bend.y };
}

/// For straight down, where the shortest turn has no axis of its own, it turns about z.
glm::vec4 turn_to(const glm::vec3 &direction) {
	const float w = std::sqrt(std::max(0.5f * (1.0f + direction.y), 0.0f));
	if (w < 1e-4f) {
		return { 0.0f, 0.0f, 1.0f, 0.0f };
	}
	const float half = 0.5f / w;
	return glm::normalize(glm::vec4(direction.z * half, 0.0f, -direction.x * half, w));
}

glm::vec3 normalised(const glm::vec3 &v, const glm::vec3 &otherwise) {
	const float square = glm::dot(v, v);
	return square > 1e-12f ? v / std::sqrt(square) : otherwise;
}

} // namespace

glm::vec2 stem_bend(const StemConstants &stem, const glm::vec2 *amplitudes, float x) {
	return BendCurve(stem, amplitudes).at(std::clamp(x, 0.0f, 1.0f));
}

static glm::vec3 centre_at(const BendCurve &curve, float place) {
	const glm::vec3 sides = direction_of(curve.at(GAUSS_LOW * place)) + direction_of(curve.at(GAUSS_HIGH * place));
	const glm::vec3 middle = direction_of(curve.at(0.5f * place));
	return place * (0.27777778f * sides + 0.44444444f * middle);
}

StemPlace stem_place(const StemConstants &stem, const glm::vec2 *amplitudes, float x) {
	const BendCurve curve(stem, amplitudes);
	const float place = std::clamp(x, 0.0f, 1.0f);
	return { centre_at(curve, place), curve.at(place) };
}

glm::vec3 stem_links(const StemConstants &stem, const glm::vec2 *amplitudes, StemLink *links) {
	const BendCurve curve(stem, amplitudes);
	const float share = 1.0f / static_cast<float>(stem.joints);
	glm::vec3 start(0.0f);
	for (int j = 0; j < stem.joints; j++) {
		const float middle = static_cast<float>(j) + 0.5f;
		const glm::vec3 before = direction_of(curve.at((middle - GAUSS_SIDE) * share));
		const glm::vec3 after = direction_of(curve.at((middle + GAUSS_SIDE) * share));
		const glm::vec3 direction = normalised(before + after, before);
		links[j] = { start, direction, turn_to(direction) };
		start += share * direction;
	}
	return start;
}

StemBinding bind_to_stem(int joints, float x) {
	if (!(x <= 1.0f)) {
		return { { joints, 0, 0, 0 }, { 1.0f, 0.0f, 0.0f, 0.0f } };
	}
	const float t = std::max(x, 0.0f) * static_cast<float>(joints) - 0.5f;
	const float whole = std::floor(t);
	const float f = t - whole;
	const float g = 1.0f - f;
	StemBinding binding;
	for (int i = 0; i < 4; i++) {
		binding.bones[i] = std::clamp(static_cast<int>(whole) + i, 0, joints);
	}
	binding.weights[0] = g * g * g / 6.0f;
	binding.weights[2] = (1.0f + 3.0f * f * (1.0f + f * g)) / 6.0f;
	binding.weights[3] = f * f * f / 6.0f;
	if (whole < 0.0f) { // Below the first link's middle the influence of the second link fades, completely at the root.
		const float moved = (2.0f - 2.0f * f) * binding.weights[3];
		binding.weights[2] += moved;
		binding.weights[3] -= moved;
	}
	binding.weights[1] = 1.0f - binding.weights[0] - binding.weights[2] - binding.weights[3];
	return binding;
}

} // namespace undergrowth
