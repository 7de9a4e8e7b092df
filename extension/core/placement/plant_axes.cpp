#include "placement/plant_axes.hpp"

#include "base/portable_math.hpp"

#include <glm/geometric.hpp>

#include <cmath>

namespace undergrowth {

namespace {

constexpr double MAX_LEAN = 1.4; // rad.
constexpr double MIN_TILT = 1e-3; // rad, about; a plant with less tilt is upright.

double length_aside(const glm::dvec3 &vector) {
	return std::sqrt(vector.x * vector.x + vector.z * vector.z);
}

/// `vector` turned by `angle` (rad) about a unit axis.
glm::dvec3 turned(const glm::dvec3 &vector, const glm::dvec3 &axis, double angle) {
	const auto [s, c] = portable_sine_and_cosine(angle);
	return c * vector + s * glm::cross(axis, vector) + (1.0 - c) * glm::dot(axis, vector) * axis;
}

glm::dvec3 above_ground(const glm::dvec3 &rest) {
	static const double min = portable_cos(MAX_LEAN);
	const double aside = length_aside(rest);
	if (rest.y >= min) {
		return rest;
	}
	const double shrink = aside > 0.0 ? portable_sin(MAX_LEAN) / aside : 0.0;
	return aside > 0.0 ? glm::dvec3(rest.x * shrink, min, rest.z * shrink) : glm::dvec3(0.0, 1.0, 0.0);
}

} // namespace

PlacedPlant plant_of_axes(const glm::vec3 &root, const glm::vec3 &up, const glm::vec3 &front) {
	PlacedPlant plant;
	plant.root = root;
	plant.scale = glm::length(up);
	const double aside = length_aside(up);
	glm::dvec3 level_front = front;
	if (aside > MIN_TILT * static_cast<double>(plant.scale)) {
		const double lean = portable_atan2(aside, static_cast<double>(up.y));
		level_front = turned(front, glm::dvec3(up.z, 0.0, -up.x) / aside, -lean);
		plant.lean = static_cast<float>(lean);
	}
	const double turn = portable_atan2(level_front.x, level_front.z);
	const double side = portable_atan2(static_cast<double>(-up.z), static_cast<double>(up.x)) - turn;
	plant.turn = static_cast<float>(turn);
	plant.side = plant.lean > 0.0f ? static_cast<float>(side) : 0.0f;
	return plant;
}

RestDirections::RestDirections(float species_lean) {
	const SineAndCosine lean = portable_sine_and_cosine(species_lean);
	own = { 0.0, lean.cosine, lean.sine };
}

glm::vec3 RestDirections::of(const PlacedPlant &plant) const {
	const SineAndCosine side = portable_sine_and_cosine(plant.side);
	const glm::dvec3 across(-side.sine, 0.0, -side.cosine);
	const glm::dvec3 leaned = above_ground(turned(own, across, plant.lean));
	return glm::vec3(turned(leaned, { 0.0, 1.0, 0.0 }, plant.turn));
}

glm::vec3 rest_direction(const PlacedPlant &plant, float species_lean) {
	return RestDirections(species_lean).of(plant);
}

} // namespace undergrowth
