#include "form/midrib.hpp"

#include "base/portable_math.hpp"
#include "base/random.hpp"

#include <glm/geometric.hpp>

#include <algorithm>

namespace undergrowth {

namespace {

constexpr int NOISE_SPANS = 4;
constexpr int NOISE_KNOTS = NOISE_SPANS + 3;
// Half of 1/√3: two such points integrate a step exactly up to its cube.
constexpr double GAUSS = 0.28867513459481288225;

/// Smooth noise of one offset, within ±1: a cubic B-spline over equal spans.
double smooth_noise(uint64_t seed, int channel, double s) {
	const double place = s * NOISE_SPANS;
	const int span = std::clamp(static_cast<int>(place), 0, NOISE_SPANS - 1);
	const double t = place - span;
	const double r = 1.0 - t;
	const double share[4] = { r * r * r / 6.0, (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0,
		(4.0 - 6.0 * r * r + 3.0 * r * r * r) / 6.0, t * t * t / 6.0 };
	double sum = 0.0;
	for (int i = 0; i < 4; i++) {
		sum += share[i] * signed_noise(seed, static_cast<uint64_t>(channel * NOISE_KNOTS + span + i));
	}
	return sum;
}

/// Direction of the line at the offset `s`.
glm::dvec3 direction(const MidribCurve &curve, uint64_t seed, double s) {
	double turn = curve.bend == 0.0f ? 0.0 : curve.bend * (curve.power == 1.0f ? s : portable_pow(s, curve.power));
	double aside = 0.0;
	if (curve.wander > 0.0f) {
		turn += curve.wander * s * smooth_noise(seed, 0, s);
		aside = curve.wander * s * smooth_noise(seed, 1, s);
	}
	const double level = portable_cos(aside);
	return { portable_sin(aside), level * portable_cos(turn), level * portable_sin(turn) };
}

/// Turns `across` by the smallest turn from `from` to `to`, and makes it exactly perpendicular to `to` again.
glm::dvec3 carry(glm::dvec3 across, const glm::dvec3 &from, const glm::dvec3 &to) {
	const glm::dvec3 axis = glm::cross(from, to);
	const double scale = 1.0 / (1.0 + std::max(glm::dot(from, to), -0.99));
	const glm::dvec3 turned = across + glm::cross(axis, across) + scale * glm::cross(axis, glm::cross(axis, across));
	return glm::normalize(turned - to * glm::dot(turned, to));
}

} // namespace

Midrib::Midrib(const MidribCurve &curve, uint64_t seed) {
	glm::dvec3 point(0.0);
	glm::dvec3 along = direction(curve, seed, 0.0);
	glm::dvec3 across(1.0, 0.0, 0.0);
	nodes[0] = { point, along, across };
	is_straight = curve.bend == 0.0f && !(curve.wander > 0.0f);
	for (int i = 0; i < STEPS; i++) {
		const double middle = (i + 0.5) / STEPS;
		const glm::dvec3 step = is_straight
				? along + along
				: direction(curve, seed, middle - GAUSS / STEPS) + direction(curve, seed, middle + GAUSS / STEPS);
		point += step * (0.5 / STEPS);
		const glm::dvec3 next = is_straight ? along : direction(curve, seed, (i + 1.0) / STEPS);
		across = carry(across, along, next);
		along = next;
		nodes[static_cast<size_t>(i) + 1] = { point, along, across };
	}
}

/// Hermite's cubic through both points and directions.
glm::vec3 Midrib::between(const Node &a, const Node &b, float t) {
	const float r = 1.0f - t;
	const glm::vec3 ways = (a.along * (r * r * t) - b.along * (t * t * r)) * (1.0f / STEPS);
	return a.point * (r * r * (1.0f + 2.0f * t)) + b.point * (t * t * (1.0f + 2.0f * r)) + ways;
}

const Midrib::Node &Midrib::node_below(float s, float &beyond) const {
	const float place = std::clamp(s, 0.0f, 1.0f) * STEPS;
	const size_t i = std::min(static_cast<size_t>(place), nodes.size() - 2);
	beyond = place - static_cast<float>(i);
	return nodes[i];
}

glm::vec3 Midrib::point_at(float s) const {
	if (is_straight) {
		return { 0.0f, s, 0.0f };
	}
	float t;
	const Node &below = node_below(s, t);
	return between(below, *(&below + 1), t);
}

Midrib::Place Midrib::at(float s) const {
	if (is_straight) {
		return { { 0.0f, s, 0.0f }, { 0.0f, 1.0f, 0.0f }, { 1.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, -1.0f },
			glm::vec3(0.0f) };
	}
	float t;
	const Node &a = node_below(s, t);
	const Node &b = *(&a + 1);
	const float r = 1.0f - t;
	Place result;
	result.point = between(a, b, t);
	result.along = glm::normalize(a.along * r + b.along * t);
	const glm::vec3 across = a.across * r + b.across * t;
	result.across = glm::normalize(across - result.along * glm::dot(across, result.along));
	result.up = glm::cross(result.along, result.across);
	result.curvature = (b.along - a.along) * static_cast<float>(STEPS);
	return result;
}

} // namespace undergrowth
