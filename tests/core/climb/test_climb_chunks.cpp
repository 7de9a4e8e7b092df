#include "climb/climb_chunks.hpp"

#include "climb/climb_stems.hpp"

#include <doctest/doctest.h>

#include "climb_fixture.hpp"

#include <set>

namespace {

Climb house() {
	ClimbSupport support;
	add_box(support, { -2.0f, 0.0f, -1.0f }, { 2.0f, 2.0f, 0.0f }, 0);
	add_box(support, { 0.5f, -0.1f, -0.5f }, { 1.0f, 3.0f, 0.4f }, 1);
	ClimbSettings settings;
	settings.seed = 3;
	settings.root = { 0.0f, 0.1f, 0.01f };
	settings.length = 6.0f;
	settings.branching = 5.0f;
	return grown_on(support, settings);
}

} // namespace

TEST_CASE("every leaf and every segment of a climber is in one chunk of its body") {
	const Climb climb = house();
	std::set<int> leaves;
	std::set<int> segments;
	for (const ClimbChunk &chunk : divide_climb(climb, 1.0f)) {
		for (const int leaf : chunk.leaves) {
			CHECK(leaves.insert(leaf).second);
			CHECK(climb.leaves[static_cast<std::size_t>(leaf)].body == chunk.body);
		}
		for (const StemRun &run : chunk.stems) {
			for (int i = run.first; i + 1 < run.first + run.count; i++) {
				CHECK(segments.insert(i).second);
				CHECK(climb.points[static_cast<std::size_t>(i)].body == chunk.body);
			}
		}
	}
	CHECK(leaves.size() == climb.leaves.size());
	CHECK(segments.size() == climb.points.size() - climb.shoots.size());
}

TEST_CASE("leaves that move alike are near each other on the same side") {
	const Climb climb = house();
	const ClimbCells found = find_cells(climb, 0.5f, 1000);
	REQUIRE(found.of_leaves.size() == climb.leaves.size());
	for (std::size_t i = 0; i < climb.leaves.size(); i++) {
		const ClimbCell &cell = found.cells[static_cast<std::size_t>(found.of_leaves[i])];
		CHECK(cell.body == climb.leaves[i].body);
		CHECK(glm::distance(cell.place, climb.leaves[i].place) < 0.9f);
		CHECK(glm::dot(cell.normal, climb.leaves[i].out) > 0.4f);
	}
	CHECK(found.cells.size() > 20);
	CHECK(find_cells(climb, 0.5f, 20).cells.size() <= 20);
}

TEST_CASE("stems are closed around their axis and face outward") {
	const Climb climb = house();
	std::size_t all = 0, coarse = 0;
	for (const ClimbChunk &chunk : divide_climb(climb, 2.0f)) {
		StemStyle style;
		const StemMesh fine = build_stems(climb, chunk.stems, style);
		REQUIRE(fine.indices.size() % 3 == 0);
		int inward = 0;
		for (std::size_t i = 0; i < fine.indices.size(); i += 3) {
			const auto a = static_cast<std::size_t>(fine.indices[i]);
			const auto b = static_cast<std::size_t>(fine.indices[i + 1]);
			const auto c = static_cast<std::size_t>(fine.indices[i + 2]);
			const glm::vec3 clockwise =
					glm::cross(fine.positions[c] - fine.positions[a], fine.positions[b] - fine.positions[a]);
			inward += glm::dot(clockwise, fine.normals[a] + fine.normals[b] + fine.normals[c]) < 0.0f ? 1 : 0;
		}
		CHECK(inward * 50 < static_cast<int>(fine.indices.size() / 3));
		style.sides = 3;
		style.tolerance = 0.02f;
		coarse += build_stems(climb, chunk.stems, style).indices.size();
		all += fine.indices.size();
	}
	CHECK(coarse * 2 < all);
}
