#include "climb/shoot_step.hpp"

#include "base/random.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float MIN_STEP = 0.012f; // m.
constexpr float MAX_STEP = 0.04f;
constexpr float TURNING_LENGTH = 0.3f; // m, over which weights of 1 turn a shoot.
constexpr float PATH_WEIGHT = 4.0f;
constexpr float PATH_NEAR = 0.15f; // m, at which a shoot has reached a point of the path,
constexpr float PATH_SEEN = 6.0f; // and steps within which it is reached at the latest.
constexpr float OVERHANG = 0.35f; // Sine of the slope from which a shoot lets go at an edge.
constexpr float TO_SURFACE = 0.7f; // Approach, in steps.

} // namespace

glm::vec3 along_surface(const glm::vec3 &v, const glm::vec3 &normal) {
	const glm::vec3 along = v - normal * glm::dot(v, normal);
	const float square = glm::dot(along, along);
	if (square > 1e-8f) {
		return along / std::sqrt(square);
	}
	const glm::vec3 other = std::fabs(normal.y) < 0.7f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
	return glm::normalize(glm::cross(normal, other));
}

float ShootStep::length_of(const ClimbSettings &settings) {
	return std::clamp(0.5f * settings.leaf_spacing, MIN_STEP, MAX_STEP);
}

glm::vec3 ShootStep::way_to_path(GrowingShoot &shoot) const {
	const int count = static_cast<int>(settings.path.size());
	if (shoot.is.order > 0 || shoot.next_on_path >= count) {
		return glm::vec3(0.0f);
	}
	const float near = std::max(PATH_NEAR, PATH_SEEN * length());
	while (shoot.next_on_path < count) {
		const glm::vec3 goal = settings.path[static_cast<std::size_t>(shoot.next_on_path)];
		const glm::vec3 way = goal - shoot.tip().place;
		const float far = glm::length(way);
		if (far > near) {
			return way / far;
		}
		shoot.next_on_path++;
	}
	return glm::vec3(0.0f);
}

glm::vec3 ShootStep::steer(GrowingShoot &shoot) const {
	const ClimbPoint &tip = shoot.tip();
	const float step = length();
	const auto number = static_cast<uint64_t>(shoot.points.size());
	const glm::vec3 chance(signed_noise(shoot.is.seed, 3 * number), signed_noise(shoot.is.seed, 3 * number + 1),
			signed_noise(shoot.is.seed, 3 * number + 2));
	const glm::vec3 to_path = way_to_path(shoot);
	const bool is_led = to_path != glm::vec3(0.0f);
	const float light_length = glm::length(settings.light);
	glm::vec3 wish = PATH_WEIGHT * to_path;
	if (light_length > 0.0f && !is_led) {
		wish += settings.light * (settings.light_weight / light_length);
	}
	if (!tip.is_attached) {
		const float share = settings.max_hanging > 0.0f ? shoot.hanging / settings.max_hanging : 1.0f;
		wish += settings.down * (settings.gravity_weight * (1.0f + 6.0f * share));
	}
	// A random walk turns as far over a length for any step.
	const float walk = settings.random_weight * std::sqrt(step / TURNING_LENGTH);
	glm::vec3 turned = shoot.direction + wish * (step / TURNING_LENGTH) + chance * walk;
	if (tip.is_attached) {
		return along_surface(turned, tip.normal);
	}
	const float size = glm::length(turned);
	return size > 1e-4f ? turned / size : shoot.direction;
}

/// True if the way to `to` meets a surface: an inner corner, or the ground.
bool ShootStep::meet(
		const GrowingShoot &shoot, const glm::vec3 &to, ClimbPoint &next, const ClimbSupport &support) const {
	const glm::vec3 from = shoot.tip().place;
	const glm::vec3 beyond = to + (to - from) * (GAP / length());
	const SurfaceHit hit = grid.crossing(from, beyond);
	if (!hit.is_valid()) {
		return false;
	}
	glm::vec3 normal = grid.normal_of(hit.triangle);
	normal = glm::dot(normal, from - hit.point) < 0.0f ? -normal : normal;
	next.normal = normal;
	next.place = hit.point + normal * GAP;
	next.body = support.body_of(hit.triangle);
	next.is_attached = true;
	return true;
}

/// True at the edge of a surface that faces down: the shoot hangs from there, unless a path leads it on.
bool ShootStep::lets_go(const GrowingShoot &shoot, const glm::vec3 &out) const {
	const ClimbPoint &tip = shoot.tip();
	const bool is_led = shoot.is.order == 0 && shoot.next_on_path < static_cast<int>(settings.path.size());
	const bool was_below = tip.is_attached && glm::dot(tip.normal, settings.down) > OVERHANG;
	return glm::dot(out, settings.down) > OVERHANG && !was_below && !is_led && settings.max_hanging > 0.0f;
}

/// True if a surface is within the adhesion distance. Moves the point towards it.
bool ShootStep::approach(
		const GrowingShoot &shoot, const glm::vec3 &to, ClimbPoint &next, const ClimbSupport &support) const {
	SurfaceHit hit = grid.nearest(to, std::min(2.0f * length(), settings.adhesion_distance));
	if (!hit.is_valid()) {
		hit = grid.nearest(to, settings.adhesion_distance);
	}
	if (!hit.is_valid()) {
		return false;
	}
	glm::vec3 out = to - hit.point;
	if (hit.distance > 1e-5f) {
		out /= hit.distance;
	} else {
		out = grid.normal_of(hit.triangle);
		out = glm::dot(out, shoot.tip().normal) < 0.0f ? -out : out;
	}
	if (lets_go(shoot, out)) {
		return false;
	}
	const float left = std::max(hit.distance - GAP - TO_SURFACE * length(), 0.0f);
	next.place = hit.point + out * (GAP + left);
	next.is_attached = left <= 0.0f;
	next.normal = out;
	next.body = support.body_of(hit.triangle);
	return true;
}

void ShootStep::advance(GrowingShoot &shoot, const ClimbSupport &support) const {
	const ClimbPoint from = shoot.tip();
	shoot.direction = steer(shoot);
	const glm::vec3 to = from.place + shoot.direction * length();
	ClimbPoint next = from;
	next.place = to;
	next.is_attached = false;
	if (!meet(shoot, to, next, support)) {
		approach(shoot, to, next, support);
	}
	const glm::vec3 way = next.place - from.place;
	const float gone = glm::length(way);
	const bool is_stuck = gone < 0.1f * length();
	if (is_stuck || grid.crossing(from.place, next.place).is_valid()) {
		shoot.is_over = true; // A crack that is narrower than the stem.
		return;
	}
	shoot.hanging = next.is_attached ? 0.0f : shoot.hanging + gone;
	shoot.direction = next.is_attached ? along_surface(shoot.direction, next.normal) : way / gone;
	shoot.length += gone;
	shoot.since_fork += gone;
	shoot.points.push_back(next);
	shoot.is_over = shoot.length >= shoot.goal || shoot.hanging > settings.max_hanging;
}

std::optional<ClimbPoint> ShootStep::begin_at(const glm::vec3 &place, float reach, const ClimbSupport &support) const {
	const SurfaceHit hit = grid.nearest(place, reach);
	if (!hit.is_valid()) {
		return {};
	}
	ClimbPoint point;
	const glm::vec3 out = place - hit.point;
	point.normal = hit.distance > 1e-4f ? out / hit.distance : grid.normal_of(hit.triangle);
	point.place = hit.point + point.normal * GAP;
	point.body = support.body_of(hit.triangle);
	return point;
}

} // namespace undergrowth
