#include "wind/air_sources.hpp"

#include "conventions.hpp"
#include "wind/air_profile.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

// Distances at which sources end, so that they cost nothing beyond.
constexpr float EXPLOSION_RADII = 12.0f; // Less than a hundredth of the speed remains.
constexpr float LAST_PHASE = 8.0f; // Durations after the front.
constexpr float FAN_SPREAD = 1.3f;
constexpr float FAN_FADES = 8.0f; // Of its spread radii: it fades from here
constexpr float FAN_ENDS = 16.0f; // to here.
constexpr float FREE_DIAMETERS = 6.0f;
constexpr float DRAG_HEIGHT = 0.75f; // Of a plant.
constexpr float FLOW_RADII = 6.0f; // A five-hundredth of the body's speed remains.
constexpr float WAKE_MEMORY = 4.0f; // s.
constexpr float WAKE_SHARE = 0.6f;
constexpr float WAKE_WIDTHS = 4.0f;
constexpr float WAKE_GROWTH = 4.0f; // Radii after which a wake begins to spread.

/// Cube root of a number >= 1 by Newton's method, with the same bits everywhere.
float cube_root(float value) {
	float root = 0.5f * (1.0f + std::sqrt(value));
	for (int i = 0; i < 6; i++) {
		root -= (root * root * root - value) / (3.0f * root * root);
	}
	return root;
}

glm::vec3 explosion_at(const AirSource &source, const glm::vec3 &away) {
	const float distance = glm::length(away);
	const float phase = (source.age - distance / source.front) / source.duration;
	if (phase <= 0.0f || phase > LAST_PHASE || distance <= 0.0f) {
		return { 0.0f, 0.0f, 0.0f };
	}
	const float far = distance / source.radius;
	const float later = 1.0f + phase * phase;
	const float speed = source.speed / (1.0f + far * far) * (1.0f - phase) / (later * later);
	return away * (speed / distance);
}

/// A sine of parabolas over a turn, by float operations that are the same everywhere.
float wave(float turns) {
	const float part = turns - std::floor(turns) - 0.5f;
	return 8.0f * part * (2.0f * std::fabs(part) - 1.0f);
}

/// Eddies that a fan's air carries outward, of standard deviation 1 along each axis. `x`, `z` and `far` are in radii of
/// the spread jet. A place sees each wave pass a whole number of times in EDDY_TURNS.
glm::vec3 eddies_at(float x, float z, float far, float turns) {
	constexpr float OVER_DEVIATION = 0.968f; // Of the sum of two waves.
	const float along_x = wave(0.5f * far + 0.2f * x - turns) + wave(0.3f * far - 0.31f * z - 0.75f * turns + 0.3f);
	const float along_z =
			wave(0.4f * far + 0.27f * x - 1.25f * turns + 0.6f) + wave(0.25f * far - 0.23f * z - 0.5f * turns);
	return glm::vec3(along_x, 0.0f, along_z) * OVER_DEVIATION;
}

/// `height`: m, of a plant.
glm::vec3 fan_at(const AirSource &source, const glm::vec3 &away, float height) {
	const glm::vec3 flat = { away.x, 0.0f, away.z };
	const float distance = glm::length(flat);
	const float x = distance / (FAN_SPREAD * source.radius);
	if (x >= FAN_ENDS) {
		return { 0.0f, 0.0f, 0.0f };
	}
	const float faded = std::max(x - FAN_FADES, 0.0f) / (FAN_ENDS - FAN_FADES);
	const float kept = 1.0f - faded * faded;
	const float free = FREE_DIAMETERS * 2.0f * source.radius;
	const float arrived = free / std::max(source.height, free);
	const float fastest = 2.0f * source.speed * kept * kept * arrived;
	const float speed = fastest * 2.0f * x / (1.0f + x * x);
	glm::vec3 mean = distance > 0.0f ? flat * (speed / distance) : glm::vec3(0.0f);
	const float narrowed = FAN_SPREAD * source.radius * (1.0f + x * x) * (1.0f + x * x);
	mean.y = -fastest * std::min(4.0f * DRAG_HEIGHT * height / narrowed, 1.0f);
	if (source.unrest <= 0.0f) {
		return mean;
	}
	const float spread = FAN_SPREAD * source.radius;
	const float swirl = source.unrest * (x < 1.0f ? fastest : speed);
	return mean + swirl * eddies_at(flat.x / spread, flat.z / spread, x, source.eddies);
}

glm::vec3 wake_at(const AirSource &source, const glm::vec3 &away) {
	const float speed = glm::length(source.velocity);
	if (speed <= 0.0f) {
		return { 0.0f, 0.0f, 0.0f };
	}
	const float a = source.radius;
	const float distance = glm::length(away);
	const glm::vec3 ahead = source.velocity / speed;
	const glm::vec3 out = distance > 0.0f ? away / distance : ahead;
	glm::vec3 moved = { 0.0f, 0.0f, 0.0f };
	if (distance < FLOW_RADII * a) {
		const float near = a / std::max(distance, a);
		moved = 0.5f * near * near * near * (3.0f * glm::dot(source.velocity, out) * out - source.velocity);
	}
	const float behind = -glm::dot(away, ahead);
	if (behind > 0.0f && behind < speed * WAKE_MEMORY) {
		const float root = cube_root(1.0f + behind / (WAKE_GROWTH * a));
		const float beside = glm::length(away + behind * ahead) / (a * root);
		const float narrow = 1.0f + beside * beside;
		const float end = 1.0f - behind / (speed * WAKE_MEMORY);
		if (beside < WAKE_WIDTHS) {
			moved += source.velocity * (WAKE_SHARE * std::min(4.0f * end, 1.0f) / (root * root * narrow * narrow));
		}
	}
	moved.y = 0.0f;
	return moved;
}

} // namespace

float induced_speed(float thrust, float radius) {
	const auto area = 2.0f * AIR_DENSITY * static_cast<float>(PI) * radius * radius;
	return std::sqrt(std::max(thrust, 0.0f) / area);
}

float eddy_rate(float speed, float radius) {
	return speed / (FAN_SPREAD * radius);
}

float reach_of(const AirSource &source) {
	switch (source.kind) {
		case AirSource::Kind::explosion:
			return EXPLOSION_RADII * source.radius;
		case AirSource::Kind::fan:
			return FAN_ENDS * FAN_SPREAD * source.radius + source.height;
		case AirSource::Kind::wake:
			break;
	}
	return std::max(
			FLOW_RADII * source.radius, glm::length(source.velocity) * WAKE_MEMORY + WAKE_WIDTHS * source.radius);
}

bool reaches(const AirSource &source, const glm::vec3 &low, const glm::vec3 &high) {
	const bool is_over = source.kind == AirSource::Kind::explosion &&
			source.age > LAST_PHASE * source.duration + reach_of(source) / source.front;
	const glm::vec3 away = (source.place - glm::clamp(source.place, low, high)) * source.scale;
	return !is_over && glm::length(away) <= reach_of(source);
}

glm::vec3 velocity_at(const AirSource &source, const glm::vec3 &root, float height) {
	const float y = std::clamp(source.place.y, root.y, root.y + std::max(height, 0.0f));
	const glm::vec3 away = (glm::vec3(root.x, y, root.z) - source.place) * source.scale;
	if (glm::length(away) > reach_of(source)) {
		return { 0.0f, 0.0f, 0.0f };
	}
	switch (source.kind) {
		case AirSource::Kind::explosion:
			return explosion_at(source, away);
		case AirSource::Kind::fan:
			return fan_at(source, away, std::max(height, 0.0f) * source.scale);
		case AirSource::Kind::wake:
			break;
	}
	return wake_at(source, away);
}

bool any_reaches(const AirSources &sources, const glm::vec3 &low, const glm::vec3 &high) {
	return std::any_of(sources.all, sources.all + sources.count,
			[&](const AirSource &source) { return reaches(source, low, high); });
}

void add_sources(const AirSources &sources, const glm::vec3 &low, const glm::vec3 &high, const float *x, const float *y,
		const float *z, const float *heights, int count, float *out_x, float *out_y, float *out_z) {
	for (int k = 0; k < sources.count; k++) {
		const AirSource &source = sources.all[k];
		if (!reaches(source, low, high)) {
			continue;
		}
		for (int i = 0; i < count; i++) {
			const glm::vec3 added = velocity_at(source, { x[i], y[i], z[i] }, heights[i]);
			out_x[i] += sources.x_x * added.x + sources.z_x * added.z;
			out_z[i] += sources.x_z * added.x + sources.z_z * added.z;
			if (out_y) {
				out_y[i] += added.y;
			}
		}
	}
}

} // namespace undergrowth
