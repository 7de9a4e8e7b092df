#include "mesh/cross_section.hpp"
#include "mesh_fixture.hpp"
#include "plant/base_shape.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace undergrowth;

TEST_CASE("a circle's normals point away from its centre, and its reach is its radius") {
	const CrossSection section = make_cross_section(circle_ring(24));
	for (size_t i = 0; i < section.points.size(); i++) {
		const glm::vec2 outward = section.points[i] / glm::length(section.points[i]);
		CHECK(glm::length(section.normals[i] - outward) < 1e-6f);
		CHECK(section.reach[i] == doctest::Approx(0.3).epsilon(1e-6));
	}
	CHECK(section.radius == doctest::Approx(0.3).epsilon(1e-6));
}

TEST_CASE("normals of a concave ring have length 1 and face away from both edges") {
	const CrossSection section = make_cross_section(star_ring());
	const int n = static_cast<int>(section.points.size());
	for (int i = 0; i < n; i++) {
		CHECK(glm::length(section.normals[i]) == doctest::Approx(1.0).epsilon(1e-6));
		CHECK(glm::dot(section.normals[i], edge_normal(section.points[i], section.points[(i + 1) % n])) > 0.0f);
		CHECK(glm::dot(section.normals[i], edge_normal(section.points[(i + n - 1) % n], section.points[i])) > 0.0f);
	}
}

TEST_CASE("a needle's point has the normal along the needle") {
	const CrossSection section =
			make_cross_section({ { -1.0f, 0.0f }, { 0.0f, 1e-5f }, { 1.0f, 0.0f }, { 0.0f, -1e-5f } });
	CHECK(section.normals[0].x == doctest::Approx(-1.0));
	CHECK(section.normals[2].x == doctest::Approx(1.0));
}

TEST_CASE("an edge without length has no normal instead of NaN") {
	CHECK(edge_normal({ 1.0f, 2.0f }, { 1.0f, 2.0f }) == glm::vec2(0.0f));
}
