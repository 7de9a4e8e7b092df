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

constexpr int STEPS = Midrib::STEPS;
/// At each node, and at two points before it.
constexpr int SAMPLES = 3 * STEPS + 1;

/// An offset at which the line's direction is computed, and the weights of the noise there: a cubic B-spline over
/// equal spans.
struct Sample {
	double offset = 0.0;
	int span = 0;
	double weights[4] = {};

	Sample() = default;
	explicit Sample(double s) : offset(s), span(std::clamp(static_cast<int>(s * NOISE_SPANS), 0, NOISE_SPANS - 1)) {
		const double t = s * NOISE_SPANS - span;
		const double r = 1.0 - t;
		weights[0] = r * r * r / 6.0;
		weights[1] = (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0;
		weights[2] = (4.0 - 6.0 * r * r + 3.0 * r * r * r) / 6.0;
		weights[3] = t * t * t / 6.0;
	}
};

std::array<Sample, SAMPLES> make_samples() {
	std::array<Sample, SAMPLES> all;
	all[0] = Sample(0.0);
	for (int i = 0; i < STEPS; i++) {
		const double middle = (i + 0.5) / STEPS;
		all[static_cast<std::size_t>(3 * i + 1)] = Sample(middle - GAUSS / STEPS);
		all[static_cast<std::size_t>(3 * i + 2)] = Sample(middle + GAUSS / STEPS);
		all[static_cast<std::size_t>(3 * i + 3)] = Sample((i + 1.0) / STEPS);
	}
	return all;
}

const std::array<Sample, SAMPLES> &samples() {
	static const std::array<Sample, SAMPLES> all = make_samples();
	return all;
}

/// Smooth noise of a plant's part, within ±1, in two channels: turns along and aside.
class Noise {
public:
	explicit Noise(uint64_t seed) {
		for (std::size_t i = 0; i < 2 * NOISE_KNOTS; i++) {
			knots[i] = signed_noise(seed, static_cast<uint64_t>(i));
		}
	}

	double at(const Sample &sample, int channel) const {
		double sum = 0.0;
		for (int i = 0; i < 4; i++) {
			sum += sample.weights[i] * knots[static_cast<std::size_t>(channel * NOISE_KNOTS + sample.span + i)];
		}
		return sum;
	}

private:
	double knots[2 * NOISE_KNOTS];
};

glm::dvec3 direction(double turn, double aside) {
	const SineAndCosine side = portable_sine_and_cosine(aside);
	const SineAndCosine up = portable_sine_and_cosine(turn);
	return { side.sine, side.cosine * up.cosine, side.cosine * up.sine };
}

/// Turns `across` by the smallest turn from `from` to `to`, and makes it exactly perpendicular to `to` again.
glm::dvec3 carry(glm::dvec3 across, const glm::dvec3 &from, const glm::dvec3 &to) {
	const glm::dvec3 axis = glm::cross(from, to);
	const double scale = 1.0 / (1.0 + std::max(glm::dot(from, to), -0.99));
	const glm::dvec3 turned = across + glm::cross(axis, across) + scale * glm::cross(axis, glm::cross(axis, across));
	return glm::normalize(turned - to * glm::dot(turned, to));
}

} // namespace

Midrib::Family::Family(const MidribCurve &of) : curve(of), turns(SAMPLES, 0.0) {
	for (std::size_t i = 0; curve.bend != 0.0f && i < turns.size(); i++) {
		const double s = samples()[i].offset;
		turns[i] = curve.bend * (curve.power == 1.0f ? s : portable_pow(s, curve.power));
	}
}

Midrib::Midrib(const Family &family) : is_straight(family.curve.bend == 0.0f) {
	follow([&](int number) { return direction(family.turns[static_cast<std::size_t>(number)], 0.0); });
}

Midrib::Midrib(const Family &family, uint64_t seed) {
	const double wander = family.curve.wander;
	if (!(wander > 0.0)) {
		*this = Midrib(family);
		return;
	}
	is_straight = false;
	const Noise noise(seed);
	follow([&](int number) {
		const Sample &sample = samples()[static_cast<std::size_t>(number)];
		const double turn = family.turns[static_cast<std::size_t>(number)];
		const double max = wander * sample.offset;
		return direction(turn + max * noise.at(sample, 0), max * noise.at(sample, 1));
	});
}

template <class Directions> void Midrib::follow(const Directions &direction_at) {
	glm::dvec3 point(0.0);
	glm::dvec3 along = direction_at(0);
	glm::dvec3 across(1.0, 0.0, 0.0);
	nodes[0] = { point, along, across };
	for (int i = 0; i < STEPS; i++) {
		const glm::dvec3 step = is_straight ? along + along : direction_at(3 * i + 1) + direction_at(3 * i + 2);
		point += step * (0.5 / STEPS);
		const glm::dvec3 next = is_straight ? along : direction_at(3 * i + 3);
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
