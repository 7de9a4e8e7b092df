#include "form/midrib.hpp"
#include "form_species.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include <cmath>

using namespace undergrowth;

namespace {

constexpr int POINTS = 4000;

double length_of(const Midrib &midrib) {
	double sum = 0.0;
	glm::dvec3 before = midrib.at(0.0f).point;
	for (int i = 1; i <= POINTS; i++) {
		const glm::dvec3 point = midrib.at(static_cast<float>(i) / POINTS).point;
		sum += glm::length(point - before);
		before = point;
	}
	return sum;
}

} // namespace

TEST_CASE("a midrib is as long as its part, with any bend and noise") {
	for (const float bend : { -3.0f, -1.0f, 0.0f, 0.8f, 1.3f, 3.0f }) {
		for (const float power : { 0.5f, 1.0f, 2.0f, 4.0f }) {
			for (const float wander : { 0.0f, 0.7f }) {
				CHECK(std::abs(length_of(Midrib({ bend, power, wander }, 5)) - 1.0) < 1e-4);
			}
		}
	}
}

TEST_CASE("a midrib with an even bend is an arc of a circle") {
	const float bend = 1.2f;
	const Midrib midrib({ bend, 1.0f, 0.0f });
	for (int i = 0; i <= 50; i++) {
		const float s = static_cast<float>(i) / 50.0f;
		const Midrib::Place place = midrib.at(s);
		CHECK(place.point.x == 0.0f);
		CHECK(std::abs(place.point.y - std::sin(bend * s) / bend) < 1e-5);
		CHECK(std::abs(place.point.z - (1.0f - std::cos(bend * s)) / bend) < 1e-5);
		CHECK(std::abs(place.along.z - std::sin(bend * s)) < 2e-4);
	}
}

TEST_CASE("the axes along a midrib stay perpendicular and never turn about it") {
	for (const float wander : { 0.0f, 1.0f }) {
		const Midrib midrib({ 2.0f, 1.5f, wander }, 11);
		glm::vec3 before = midrib.at(0.0f).across;
		for (int i = 1; i <= 400; i++) {
			const Midrib::Place place = midrib.at(static_cast<float>(i) / 400.0f);
			CHECK(std::abs(glm::dot(place.along, place.across)) < 1e-6);
			CHECK(std::abs(glm::length(place.up) - 1.0f) < 1e-6);
			CHECK(glm::dot(glm::cross(place.along, place.across), place.up) > 0.999999f);
			// The change of `across` has no part along `up`, so it is not a turn about `along`.
			CHECK(std::abs(glm::dot(place.across - before, place.up)) < 4e-4f);
			before = place.across;
		}
	}
}

TEST_CASE("from node to node the axes turn by the smallest possible turn") {
	constexpr int NODES = 48;
	const Midrib midrib({ 1.0f, 1.0f, 1.5f }, 3);
	Midrib::Place before = midrib.at(0.0f);
	for (int i = 1; i <= NODES; i++) {
		const Midrib::Place place = midrib.at(static_cast<float>(i) / NODES);
		const glm::dvec3 axis = glm::normalize(glm::cross(glm::dvec3(before.along), glm::dvec3(place.along)));
		CHECK(std::abs(glm::dot(axis, glm::dvec3(place.across)) - glm::dot(axis, glm::dvec3(before.across))) < 2e-5);
		before = place;
	}
}

TEST_CASE("the noise of a midrib differs between aside and along") {
	constexpr int SEEDS = 400;
	for (const float later : { 0.0f, 0.25f, 0.5f }) {
		double sum = 0.0;
		double squares = 0.0;
		for (uint64_t seed = 0; seed < SEEDS; seed++) {
			const Midrib midrib({ 0.0f, 1.0f, 0.2f }, seed);
			const double aside = static_cast<double>(midrib.at(0.4f).along.x) / 0.4;
			const double along =
					static_cast<double>(midrib.at(0.4f + later).along.z) / (0.4 + static_cast<double>(later));
			sum += aside * along;
			squares += 0.5 * (aside * aside + along * along);
		}
		CHECK(std::abs(sum) < 0.15 * squares); // Three deviations of the sum of 400 pairs of independent noise.
	}
}

TEST_CASE("the noise of a midrib depends on its seed and is 0 at its base") {
	const Midrib one({ 0.0f, 1.0f, 0.8f }, 1);
	const Midrib other({ 0.0f, 1.0f, 0.8f }, 2);
	CHECK(one.at(0.0f).along == glm::vec3(0.0f, 1.0f, 0.0f));
	CHECK(glm::length(one.at(1.0f).point - other.at(1.0f).point) > 0.01f);
	CHECK(one.at(1.0f).point == Midrib({ 0.0f, 1.0f, 0.8f }, 1).at(1.0f).point);
}

TEST_CASE("profiles have the measured areas of leaves") {
	const struct {
		Profile profile;
		float area;
	} leaves[] = { { GRASS_PROFILE, 0.80f }, { STRAP_PROFILE, 0.86f }, { LANCEOLATE_PROFILE, 0.69f },
		{ OVATE_PROFILE, 0.67f }, { ELLIPTIC_PROFILE, 0.785f }, { OBOVATE_PROFILE, 0.64f },
		{ SPATULATE_PROFILE, 0.52f }, { TEPAL_PROFILE, 0.75f }, { RAY_PROFILE, 0.78f }, { EVEN_PROFILE, 1.0f } };
	for (const auto &leaf : leaves) {
		WidthFunction widths;
		widths.profile = leaf.profile;
		CHECK(std::abs(widths.mean() - leaf.area) < 0.006f);
		CHECK(std::abs(widths.at(widths.widest()) - 1.0f) < 1e-6f);
	}
}

TEST_CASE("a width function's slope is its difference") {
	for (const Profile &profile : { GRASS_PROFILE, OVATE_PROFILE, SPATULATE_PROFILE, ELLIPTIC_PROFILE }) {
		WidthFunction widths;
		widths.profile = profile;
		for (float s = 0.05f; s < 0.95f; s += 0.05f) {
			const float slope = (widths.at(s + 0.002f) - widths.at(s - 0.002f)) / 0.004f;
			CHECK(std::abs(widths.slope(s) - slope) < 0.02f * (1.0f + std::abs(slope)));
		}
	}
}

TEST_CASE("a width function has the same slope with and without a given width") {
	for (const Profile &profile : { GRASS_PROFILE, OVATE_PROFILE, SPATULATE_PROFILE, ELLIPTIC_PROFILE }) {
		WidthFunction widths;
		widths.profile = profile;
		widths.base_width = 0.4f;
		for (float s = 0.0f; s <= 1.0f; s += 0.0625f) {
			CHECK(widths.slope(s, widths.at(s)) == widths.slope(s));
		}
		// Near the ends it is that of 1 % inside, independent of the width at the end itself.
		CHECK(widths.slope(1.0f, widths.at(1.0f)) == widths.slope(0.99f));
	}
}

TEST_CASE("samples can replace a profile") {
	WidthFunction widths;
	widths.samples = { 0.5f, 1.0f, 0.0f };
	CHECK(widths.at(0.25f) == 0.75f);
	CHECK(widths.at(1.0f) == 0.0f);
	CHECK(widths.widest() == 0.5f);
	CHECK(std::abs(widths.slope(0.25f) - 1.0f) < 1e-4f);
}

TEST_CASE("a midrib's point alone has the bits of its full place") {
	for (const MidribCurve &curve :
			{ MidribCurve{}, MidribCurve{ 1.2f, 2.0f, 0.0f }, MidribCurve{ -2.0f, 0.5f, 0.4f } }) {
		const Midrib midrib(curve, 7);
		for (int i = -1; i <= 101; i++) {
			const float s = static_cast<float>(i) / 100.0f;
			CHECK(midrib.point_at(s) == midrib.at(s).point);
		}
	}
}
