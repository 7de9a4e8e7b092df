#include "placement/lod_density.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace undergrowth;

namespace {

constexpr int SIDE = 64; // Cells.

// Ranks of the cells of a grid, row by row.
std::vector<float> ranks_of_cells() {
	std::vector<float> ranks;
	for (int row = 0; row < SIDE; row++) {
		for (int column = 0; column < SIDE; column++) {
			// Away from a cell's side, since rows are shifted.
			const float shift = row % 2 == 0 ? 0.25f : 0.75f;
			ranks.push_back(plant_rank(
					generated_plant_id(static_cast<float>(column) + shift, static_cast<float>(row) + 0.5f, 1.0)));
		}
	}
	return ranks;
}

// Number of cells of a square with ranks below a density.
int count_matches(const std::vector<float> &ranks, int column, int row, int side, float share) {
	int count = 0;
	for (int i = 0; i < side * side; i++) {
		count += ranks[static_cast<size_t>((row + i / side) * SIDE + column + i % side)] < share ? 1 : 0;
	}
	return count;
}

LodDensity falling() {
	LodDensity lod_density;
	const float distances[3] = { 0.0f, 10.0f, 30.0f };
	const float densities[3] = { 1.0f, 0.8f, 0.2f };
	std::copy(distances, distances + 3, lod_density.distances);
	std::copy(densities, densities + 3, lod_density.densities);
	return lod_density;
}

} // namespace

TEST_CASE("the remaining plants stay evenly spread at any density") {
	const std::vector<float> ranks = ranks_of_cells();
	for (const float share : { 0.1f, 0.25f, 0.5f, 0.8f }) {
		double squares = 0.0;
		constexpr int BLOCK = 8;
		for (int row = 0; row < SIDE; row += BLOCK) {
			for (int column = 0; column < SIDE; column += BLOCK) {
				const double off = count_matches(ranks, column, row, BLOCK, share) - share * BLOCK * BLOCK;
				CHECK(std::abs(off) <= 3.0);
				squares += off * off;
			}
		}
		// Independent ranks would give share·(1 - share)·64 in each square: 5.8 to 16.
		CHECK(squares / 64.0 < 2.0);
	}
}

TEST_CASE("ranks of added plants are spread, for any plants added before") {
	int kept = 0;
	for (int64_t number = 500; number < 600; number++) {
		const float rank = plant_rank(added_plant_id(number));
		CHECK(rank >= 0.0f);
		CHECK(rank < 1.0f);
		kept += rank < 0.3f ? 1 : 0;
	}
	CHECK(std::abs(kept - 30) <= 2);
}

TEST_CASE("density changes linearly from one level's end to the next") {
	const LodDensity lod_density = falling();
	CHECK(lod_density.density_at(-5.0f) == doctest::Approx(1.0f));
	CHECK(lod_density.density_at(5.0f) == doctest::Approx(0.9f));
	CHECK(lod_density.density_at(10.0f) == doctest::Approx(0.8f));
	CHECK(lod_density.density_at(20.0f) == doctest::Approx(0.5f));
	CHECK(lod_density.density_at(1000.0f) == doctest::Approx(0.2f));
	CHECK(lod_density.is_any());
	CHECK_FALSE(LodDensity().is_any());
	CHECK(LodDensity().density_at(500.0f) == 1.0f);
	CHECK(LodDensity().width_of(0.99f, 500.0f) == 1.0f);
}

TEST_CASE("a plant loses its width gradually and completely before its removal") {
	const LodDensity lod_density = falling();
	for (const float rank : { 0.15f, 0.3f, 0.55f, 0.85f, 0.97f }) {
		float before = lod_density.width_of(rank, 0.0f);
		CHECK(before == 1.0f);
		for (float away = 0.0f; away < 40.0f; away += 0.05f) {
			const float width = lod_density.width_of(rank, away);
			CHECK(width <= before);
			CHECK(before - width < 0.05f);
			CHECK((width == 0.0f || rank < lod_density.cut_at(away)));
			CHECK((width > 0.0f || rank >= lod_density.cut_at(away) - 1e-5f));
			before = width;
		}
	}
}

TEST_CASE("a level with a density of 0 draws nothing") {
	LodDensity none;
	std::fill(none.densities, none.densities + 3, 0.0f);
	CHECK(none.width_of(0.0f, 3.0f) == 0.0f);
	CHECK(none.cut_at(3.0f) == 0.0f);
}
