#include "form/arrangement.hpp"
#include "form_species.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include <cmath>

using namespace undergrowth;

namespace {

constexpr double PI = 3.14159265358979;

Arrangement layout(Layout kind) {
	Arrangement a;
	a.layout = kind;
	return a;
}

double around(double angle) {
	return angle - 2.0 * PI * std::floor(angle / (2.0 * PI) + 0.5);
}

/// Distance of the closest two seats of a flat disc from `first` on, in units of its radius.
double closest(const Arrangement &a, int count, int first) {
	double min = 1e9;
	for (int i = first; i < count; i++) {
		for (int k = first; k < i; k++) {
			const Seat p = seat_of(a, i, count, 0);
			const Seat q = seat_of(a, k, count, 0);
			const glm::dvec2 way = { p.away * std::cos(p.azimuth) - q.away * std::cos(q.azimuth),
				p.away * std::sin(p.azimuth) - q.away * std::sin(q.azimuth) };
			min = std::fmin(min, glm::length(way));
		}
	}
	return min / a.radius;
}

} // namespace

TEST_CASE("parts along an axis are at the centres of their sections, turned from node to node") {
	Arrangement a = layout(Layout::along);
	a.from = 0.2f;
	a.to = 0.8f;
	a.angle = { 1.0f, 0.4f };
	for (int i = 0; i < 6; i++) {
		const Seat seat = seat_of(a, i, 6, 0);
		CHECK(std::abs(seat.offset - (0.2 + 0.6 * (i + 0.5) / 6)) < 1e-6);
		CHECK(std::abs(around(seat.azimuth - i * 137.50776 * PI / 180.0)) < 1e-5);
		CHECK(std::abs(seat.tilt - (1.0 - 0.6 * (i + 0.5) / 6)) < 1e-6);
	}
}

TEST_CASE("crosswise pairs: two at a node, a quarter turn from node to node") {
	Arrangement a = layout(Layout::along);
	a.per_node = 2;
	a.turn = 90.0f * DEGREE;
	const double expected[] = { 0.0, 180.0, 90.0, 270.0, 180.0, 360.0 };
	for (int i = 0; i < 6; i++) {
		const Seat seat = seat_of(a, i, 6, 0);
		CHECK(std::abs(around(seat.azimuth - expected[i] * PI / 180.0)) < 1e-5);
		CHECK(std::abs(seat.offset - (i / 2 + 0.5) / 3.0) < 1e-6);
	}
}

TEST_CASE("samples of angle and scale replace their ranges, from the first part to the last") {
	Arrangement a = layout(Layout::along);
	a.angle = a.scale = { 1.0f, 1.0f };
	a.angles = { 0.2f, 0.4f, 1.0f };
	a.scales = { 0.5f, 2.0f, 1.0f };
	CHECK(a.angle_at(0.0f) == doctest::Approx(0.2));
	CHECK(a.angle_at(0.75f) == doctest::Approx(0.7));
	CHECK(a.scale_at(0.0f) == doctest::Approx(0.5));
	CHECK(a.scale_at(0.25f) == doctest::Approx(1.25));
	CHECK(a.scale_at(1.0f) == doctest::Approx(1.0));
}

TEST_CASE("a whorl is evenly distributed around the circle") {
	Arrangement a = layout(Layout::whorl);
	a.radius = 0.01f;
	a.phase = 0.5f;
	for (int i = 0; i < 7; i++) {
		const Seat seat = seat_of(a, i, 7, 0);
		CHECK(std::abs(around(seat.azimuth - 0.5 - 2.0 * PI * i / 7)) < 1e-5);
		CHECK(seat.away == 0.01f);
		CHECK(seat.offset == 1.0f);
	}
}

TEST_CASE("a flat disc is Vogel's: equal areas, innermost seats 1.55 R/sqrt(N) apart, all other seats 1.67 or more") {
	Arrangement a = layout(Layout::disc);
	a.radius = 0.02f;
	for (const int count : { 100, 400 }) {
		for (int i = 0; i < count; i += 13) {
			const Seat seat = seat_of(a, i, count, 0);
			CHECK(std::abs(seat.away - 0.02 * std::sqrt((i + 0.5) / count)) < 1e-8);
			CHECK(seat.lift == 0.0f);
		}
		CHECK(std::abs(closest(a, count, 0) * std::sqrt(count) - 1.546) < 0.002);
		CHECK(std::abs(closest(a, count, 20) * std::sqrt(count) - 1.671) < 0.002);
	}
}

TEST_CASE("a dome has equal areas on its sphere, and its rim on the disc's radius") {
	Arrangement a = layout(Layout::disc);
	a.radius = 0.01f;
	for (const float dome : { 0.5f, 1.2f, 3.14159f }) {
		a.dome = dome;
		const int count = 200;
		for (int i = 0; i < count; i += 7) {
			const Seat seat = seat_of(a, i, count, 0);
			const double cosine = 1.0 - (1.0 - std::cos(dome)) * (i + 0.5) / count;
			CHECK(std::abs(std::cos(seat.tilt) - cosine) < 1e-5);
			const double sphere = a.radius / (dome < 1.57f ? std::sin(dome) : 1.0);
			CHECK(std::abs(seat.away - sphere * std::sqrt(1.0 - cosine * cosine)) < 1e-7);
			CHECK(std::abs(seat.lift - sphere * (cosine - std::cos(dome))) < 1e-7);
		}
	}
}

TEST_CASE("a corymb's stalks end at one height") {
	Arrangement a = layout(Layout::disc);
	a.dome = 0.9f;
	a.level_tops = true;
	for (int i = 0; i < 30; i++) {
		const Seat seat = seat_of(a, i, 30, 0);
		CHECK(std::abs(seat.stretch * std::cos(seat.tilt) - 1.0) < 1e-5);
	}
}

TEST_CASE("a tuft's parts lean out more towards its rim") {
	Arrangement a = layout(Layout::ground);
	a.radius = 0.05f;
	a.tilt = { 0.1f, 0.6f };
	for (int i = 0; i < 20; i++) {
		const Seat seat = seat_of(a, i, 20, 0);
		const double way = std::sqrt((i + 0.5) / 20);
		CHECK(std::abs(seat.away - 0.05 * way) < 1e-7);
		CHECK(std::abs(seat.tilt - (0.1 + 0.5 * way)) < 1e-6);
	}
}

TEST_CASE("a swept tuft's parts point to its front") {
	Arrangement a = layout(Layout::ground);
	a.radius = 0.05f;
	a.tilt = { 0.3f, 0.3f };
	for (const float swept : { 0.0f, 0.5f, 1.0f }) {
		a.swept = swept;
		float max = 0.0f;
		double sum = 0.0;
		for (int i = 0; i < 40; i++) {
			const float azimuth = seat_of(a, i, 40, 0).azimuth;
			max = std::max(max, swept > 0.0f ? std::abs(azimuth) : 3.2f);
			sum += std::cos(azimuth) / 40.0;
		}
		const double reach = PI * (1.0 - swept);
		CHECK(max <= reach + 0.1);
		CHECK(std::abs(sum - (reach > 0.0 ? std::sin(reach) / reach : 1.0)) < 0.1);
	}
}

TEST_CASE("deviations turn parts by at most their limit") {
	Arrangement a = layout(Layout::whorl);
	a.deviation = 0.2f;
	float max = 0.0f;
	for (int i = 0; i < 200; i++) {
		const Seat seat = seat_of(a, 0, 8, static_cast<uint64_t>(i));
		CHECK(std::abs(seat.tilt) <= 0.2f);
		CHECK(std::abs(seat.azimuth) <= 0.2f);
		max = std::max(max, std::abs(seat.tilt));
	}
	CHECK(max > 0.15f);
}

TEST_CASE("counts fill their range evenly by the seed") {
	Arrangement a;
	a.count_min = 3;
	a.count_max = 6;
	int counts[10] = {};
	for (uint64_t seed = 0; seed < 4000; seed++) {
		counts[count_of(a, seed)]++;
	}
	for (int i = 3; i <= 6; i++) {
		CHECK(std::abs(counts[i] - 1000) < 150);
	}
}

TEST_CASE("a part's axes turn outward from its carrier's and stay right-handed") {
	const PartAxes upright = { { 1.0f, 0.0f, 0.0f }, { 0.0f, 1.0f, 0.0f }, { 0.0f, 0.0f, 1.0f } };
	const PartAxes off = turn_into(upright, 0.0f, 90.0f * DEGREE);
	CHECK(glm::length(off.along - glm::vec3(0.0f, 0.0f, 1.0f)) < 1e-6f);
	const PartAxes side = turn_into(upright, 90.0f * DEGREE, 0.3f);
	CHECK(glm::length(side.along - glm::vec3(std::sin(0.3f), std::cos(0.3f), 0.0f)) < 1e-6f);
	CHECK(glm::length(glm::cross(side.along, side.outward) - side.x) < 1e-6f);
}

TEST_CASE("a flat part has its carrier's upper side, and a part straight up has its own") {
	const PartAxes carrier =
			turn_into({ { 1.0f, 0.0f, 0.0f }, { 0.0f, 1.0f, 0.0f }, { 0.0f, 0.0f, 1.0f } }, 0.7f, 0.9f);
	for (const float side : { 90.0f, -90.0f, 30.0f }) {
		const PartAxes part = turn_into(carrier, side * DEGREE, 80.0f * DEGREE);
		const PartAxes level = turn_level(part, carrier);
		CHECK(level.along == part.along);
		CHECK(std::abs(glm::dot(level.along, level.outward)) < 1e-6f);
		CHECK(glm::length(glm::cross(level.along, level.outward) - level.x) < 1e-6f);
		CHECK(glm::dot(level.outward, carrier.outward) >= glm::dot(part.outward, carrier.outward) - 1e-6f);
	}
	const PartAxes aside = turn_level(turn_into(carrier, 90.0f * DEGREE, 80.0f * DEGREE), carrier);
	CHECK(glm::length(aside.outward - carrier.outward) < 1e-6f);
	const PartAxes up = turn_into(carrier, 0.0f, 90.0f * DEGREE);
	CHECK(turn_level(up, carrier).outward == up.outward);
}
