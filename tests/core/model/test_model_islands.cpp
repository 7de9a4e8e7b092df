#include "model/model_islands.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace undergrowth;

namespace {

/// Two squares of two triangles each, 1 m wide, with vertices of their own at the seam. The second one begins `gap` (m)
/// beside the first.
struct Squares {
	std::vector<glm::vec3> places;
	std::vector<int32_t> indices;

	explicit Squares(float gap) {
		for (const float left : { 0.0f, 1.0f + gap }) {
			const int first = static_cast<int>(places.size());
			places.insert(
					places.end(), { { left, 0, 0 }, { left + 1.0f, 0, 0 }, { left, 1, 0 }, { left + 1.0f, 1, 0 } });
			for (const int corner : { 0, 1, 2, 2, 1, 3 }) {
				indices.push_back(first + corner);
			}
		}
	}

	ModelIslands find() const {
		ModelSurface surface;
		surface.positions = places.data();
		surface.vertices = static_cast<int>(places.size());
		surface.indices = indices.data();
		surface.index_count = static_cast<int>(indices.size());
		return find_islands({ surface }, places);
	}
};

} // namespace

TEST_CASE("vertices at one place connect the parts of a model") {
	const ModelIslands found = Squares(0.0f).find();
	REQUIRE(found.islands.size() == 1);
	CHECK(found.islands[0].count == 8);
	CHECK(found.islands[0].area == doctest::Approx(2.0f));
	CHECK(found.islands[0].greatest == glm::vec3(2, 1, 0));
}

TEST_CASE("a gap of a ten thousandth of the model separates its parts") {
	const ModelIslands found = Squares(3e-4f).find();
	REQUIRE(found.islands.size() == 2);
	CHECK(found.islands[0].count == 4);
	CHECK(found.of_vertex == std::vector<int>{ 0, 0, 0, 0, 1, 1, 1, 1 });
	CHECK(found.islands[1].centre().x == doctest::Approx(1.5f + 3e-4f));
}

TEST_CASE("vertices without a triangle belong to no part") {
	Squares squares(1.0f);
	squares.places.emplace_back(0.5f, 0.5f, 0.5f);
	const ModelIslands found = squares.find();
	CHECK(found.islands.size() == 2);
	CHECK(found.of_vertex.back() == -1);
	CHECK(found.members.size() == 8);
}
