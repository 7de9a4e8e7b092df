#include "form/arrangement.hpp"

#include "base/portable_math.hpp"
#include "base/random.hpp"
#include "conventions.hpp"
#include "form/limits.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float FLAT_DOME = 0.02f; // rad: a flatter cap is a disc.
constexpr double MIN_LEVEL_COSINE = 0.2; // Min cosine for stalks that end at one height.
constexpr float MIN_HORIZONTAL = 1e-3f; // Of a unit vector.
constexpr uint64_t COUNT_INDEX = 3;

float sample_at(const std::vector<float> &samples, float t) {
	const float place = t * static_cast<float>(samples.size() - 1);
	const size_t before = std::min(static_cast<size_t>(place), samples.size() - 2);
	const float share = place - static_cast<float>(before);
	return samples[before] * (1.0f - share) + samples[before + 1] * share;
}

std::string find_samples_fault(const char *name, const std::vector<float> &samples, double min, double max) {
	for (const float sample : samples) {
		const std::string fault = find_limit_fault({ { name, sample, min, max } });
		if (!fault.empty()) {
			return fault;
		}
	}
	return samples.size() == 1 ? std::string(name) + " has one sample only. Give two or more." : std::string();
}

Seat seat_along(const Arrangement &a, int i, int count) {
	const int node = i / a.per_node;
	const int nodes = (count + a.per_node - 1) / a.per_node;
	Seat seat;
	seat.way = (static_cast<float>(node) + 0.5f) / static_cast<float>(nodes);
	seat.offset = a.from + (a.to - a.from) * seat.way;
	const double round = 2.0 * PI * (i % a.per_node) / a.per_node;
	seat.azimuth = static_cast<float>(a.phase + node * static_cast<double>(a.turn) + round);
	seat.tilt = a.angle_at(seat.way);
	return seat;
}

Seat seat_on_whorl(const Arrangement &a, int i, int count) {
	Seat seat;
	seat.way = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
	seat.azimuth = static_cast<float>(a.phase + 2.0 * PI * i / count);
	seat.tilt = a.angle_at(seat.way);
	seat.away = a.radius;
	return seat;
}

/// Equal areas: r = R·√((i + ½)/N) on a disc, cos τ = 1 - (1 - cos dome)·(i + ½)/N on a cap.
Seat seat_on_disc(const Arrangement &a, int i, int count) {
	Seat seat;
	const double share = (i + 0.5) / count;
	seat.way = static_cast<float>(std::sqrt(share));
	seat.azimuth = static_cast<float>(a.phase + i * static_cast<double>(GOLDEN_ANGLE));
	seat.tilt = a.angle_at(seat.way);
	if (a.dome < FLAT_DOME) {
		seat.away = a.radius * seat.way;
		return seat;
	}
	const double rim = portable_cos(a.dome);
	const double cosine = 1.0 - (1.0 - rim) * share;
	const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
	const double sphere = a.radius / (rim > 0.0 ? portable_sin(a.dome) : 1.0);
	seat.away = static_cast<float>(sphere * sine);
	seat.lift = static_cast<float>(sphere * (cosine - rim));
	seat.tilt += static_cast<float>(portable_atan2(sine, cosine));
	seat.stretch = a.level_tops ? static_cast<float>(1.0 / std::max(cosine, MIN_LEVEL_COSINE)) : 1.0f;
	return seat;
}

Seat seat_on_ground(const Arrangement &a, int i, int count) {
	Seat seat;
	seat.way = static_cast<float>(std::sqrt((i + 0.5) / count));
	seat.azimuth = static_cast<float>(a.phase + i * static_cast<double>(GOLDEN_ANGLE));
	if (a.swept > 0.0f) {
		const double turns = static_cast<double>(seat.azimuth) / (2.0 * PI);
		seat.azimuth =
				static_cast<float>((1.0 - static_cast<double>(a.swept)) * 2.0 * PI * (turns - std::floor(turns + 0.5)));
	}
	seat.away = a.radius * seat.way;
	seat.tilt = a.tilt.at(seat.way);
	return seat;
}

} // namespace

float Arrangement::angle_at(float t) const {
	return angles.empty() ? angle.at(t) : sample_at(angles, t);
}

float Arrangement::scale_at(float t) const {
	return scales.empty() ? scale.at(t) : sample_at(scales, t);
}

std::string find_arrangement_fault(const Arrangement &a) {
	std::string fault = find_limit_fault({ { "count", static_cast<double>(a.count_min), 0.0, 4096.0 },
			{ "count", static_cast<double>(a.count_max), std::max(1.0, static_cast<double>(a.count_min)), 4096.0 },
			{ "per_node", static_cast<double>(a.per_node), 1.0, 64.0 }, { "from", a.from, 0.0, 1.0 },
			{ "to", a.to, 0.0, 1.0 }, { "turn", a.turn, -1e3, 1e3 }, { "phase", a.phase, -1e3, 1e3 },
			{ "angle", a.angle.first, -12.6, 12.6 }, { "angle", a.angle.last, -12.6, 12.6 },
			{ "scale", a.scale.first, 1e-3, 1e3 }, { "scale", a.scale.last, 1e-3, 1e3 },
			{ "radius", a.radius, 0.0, 10.0 }, { "dome", a.dome, 0.0, 3.15 }, { "tilt", a.tilt.first, -3.15, 3.15 },
			{ "tilt", a.tilt.last, -3.15, 3.15 }, { "swept", a.swept, 0.0, 1.0 },
			{ "deviation", a.deviation, 0.0, 1.5 } });
	if (fault.empty()) {
		fault = find_samples_fault("angle", a.angles, -12.6, 12.6);
	}
	return fault.empty() ? find_samples_fault("scale", a.scales, 1e-3, 1e3) : fault;
}

Seat seat_of(const Arrangement &arrangement, int i, int count, uint64_t seed) {
	Seat (*const layouts[])(
			const Arrangement &, int, int) = { seat_along, seat_on_whorl, seat_on_disc, seat_on_ground };
	Seat seat = layouts[static_cast<int>(arrangement.layout)](arrangement, i, count);
	if (arrangement.deviation > 0.0f) {
		seat.azimuth += arrangement.deviation * signed_noise(seed, 0);
		seat.tilt += arrangement.deviation * signed_noise(seed, 1);
	}
	return seat;
}

int count_of(const Arrangement &arrangement, uint64_t seed) {
	const int more = arrangement.count_max - arrangement.count_min;
	const double share = 0.5 + 0.5 * signed_noise(seed, COUNT_INDEX);
	return arrangement.count_min + std::min(more, static_cast<int>(share * (more + 1)));
}

PartAxes turn_into(const PartAxes &carrier, float azimuth, float tilt) {
	const float ca = static_cast<float>(portable_cos(azimuth));
	const float sa = static_cast<float>(portable_sin(azimuth));
	const float ct = static_cast<float>(portable_cos(tilt));
	const float st = static_cast<float>(portable_sin(tilt));
	const glm::vec3 outward = carrier.outward * ca + carrier.x * sa;
	const glm::vec3 x = carrier.x * ca - carrier.outward * sa;
	return { x, carrier.along * ct + outward * st, outward * ct - carrier.along * st };
}

PartAxes turn_level(const PartAxes &part, const PartAxes &carrier) {
	const glm::vec3 outward = carrier.outward - part.along * glm::dot(carrier.outward, part.along);
	const float length = glm::length(outward);
	if (length < MIN_HORIZONTAL) { // The part points straight up or down: every turn is equivalent.
		return part;
	}
	return { glm::cross(part.along, outward) / length, part.along, outward / length };
}

} // namespace undergrowth
