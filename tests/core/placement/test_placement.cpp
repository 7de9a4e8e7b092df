#include "placement/placement.hpp"
#include "test_placement_fixture.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <thread>

using namespace undergrowth;

namespace {

using Root = std::array<float, 2>;

/// Position of a plant, with a hash of all its other values.
std::map<Root, uint64_t> by_root(const FieldPlants &plants) {
	std::map<Root, uint64_t> found;
	for (int i = 0; i < plants.size(); i++) {
		FieldPlants single;
		single.add(plants.plant(i));
		found[{ single.x[0], single.z[0] }] = hash_of(single);
	}
	return found;
}

/// Min distance of any two plants (m) that are closer than `spacing`.
double min_distance(const FieldPlants &plants, double spacing) {
	std::map<std::pair<int, int>, std::vector<int>> cells;
	const auto cell = [&](float place) { return static_cast<int>(std::floor(static_cast<double>(place) / spacing)); };
	double min = 1.0e9;
	for (int i = 0; i < plants.size(); i++) {
		const auto at = static_cast<std::size_t>(i);
		const int column = cell(plants.x[at]);
		const int row = cell(plants.z[at]);
		for (int k = 0; k < 9; k++) {
			for (const int other : cells[{ column + k % 3 - 1, row + k / 3 - 1 }]) {
				const auto o = static_cast<std::size_t>(other);
				min = std::min(min,
						std::hypot(static_cast<double>(plants.x[at] - plants.x[o]),
								static_cast<double>(plants.z[at] - plants.z[o])));
			}
		}
		cells[{ column, row }].push_back(i);
	}
	return min;
}

} // namespace

TEST_CASE("the count is density times area, except for chance in the cells on the border") {
	// A cell on the border has a plant or not, with a variance of at most 1/4. Four standard deviations.
	constexpr double DEVIATIONS = 4.0;
	const Polygon triangle = { { -20, -30 }, { 45, 3 }, { 1, 28 } };
	const Polygon u_shape = { { 0, 0 }, { 50, 0 }, { 50, 50 }, { 40, 50 }, { 40, 10 }, { 10, 10 }, { 10, 50 },
		{ 0, 50 } };
	for (const Polygon &area : { rectangle({ 40, 25 }), rectangle({ 0.5f, 200 }, { 33, 5 }), triangle, u_shape }) {
		for (const float density : { 0.5f, 7.0f, 40.0f }) {
			for (uint64_t seed = 0; seed < 5; seed++) {
				PlacementRequest request = square_field(1.0f, density, 1);
				request.area = area;
				request.seed = seed;
				const double border_cells = 2.0 * perimeter(area) * std::sqrt(static_cast<double>(density)) + 4.0;
				const double expected = std::abs(signed_area(area)) * static_cast<double>(density);
				const int count = placed(request).size();
				CAPTURE(count);
				CHECK(std::abs(count - expected) <= DEVIATIONS * 0.5 * std::sqrt(border_cells));
			}
		}
	}
}

TEST_CASE("plants are in the area and in no exclusion") {
	PlacementRequest request = square_field(30.0f, 20.0f, 2);
	request.exclusions = { rectangle({ 4, 40 }), { { 5, 5 }, { 12, 8 }, { 6, 11 } }, {}, { { 1, 1 }, { 2, 2 } } };
	const FieldPlants plants = placed(request);
	REQUIRE(plants.size() > 10000);
	for (std::size_t i = 0; i < plants.x.size(); i++) {
		const glm::vec2 root = { plants.x[i], plants.z[i] };
		CHECK(is_inside(request.area, root));
		CHECK_FALSE(is_inside(request.exclusions[0], root));
		CHECK_FALSE(is_inside(request.exclusions[1], root));
		CHECK(plants.y[i] == 0.0f);
	}
}

TEST_CASE("no two plants are closer than the stated fraction of the spacing") {
	for (const float density : { 0.3f, 10.0f, 1000.0f }) {
		const double spacing = 1.0 / std::sqrt(static_cast<double>(density));
		PlacementRequest request = square_field(1.0f, density, 1);
		const auto side = static_cast<float>(150.0 * spacing);
		request.area = rectangle({ side, side });
		const double min = min_distance(placed(request), spacing);
		CHECK(min >= Placement::MIN_DISTANCE * spacing * 0.999);
		CHECK(min < 0.5 * spacing);
	}
}

TEST_CASE("plants are spread evenly and their columns do not show the grid") {
	const FieldPlants plants = placed(square_field(100.0f, 4.0f, 1));
	std::array<int, 100> blocks = {};
	std::array<int, 10> phases = {};
	for (std::size_t i = 0; i < plants.x.size(); i++) {
		const int column = static_cast<int>((plants.x[i] + 50.0f) / 10.0f);
		const int row = static_cast<int>((plants.z[i] + 50.0f) / 10.0f);
		blocks[static_cast<std::size_t>(std::min(row, 9) * 10 + std::min(column, 9))]++;
		const float cell = plants.x[i] * 2.0f;
		phases[static_cast<std::size_t>((cell - std::floor(cell)) * 9.999f)]++;
	}
	for (const int block : blocks) {
		CHECK(std::abs(block - 400) <= 40);
	}
	for (const int phase : phases) {
		CHECK(std::abs(phase - 4000) <= 0.5 * 4000);
	}
}

TEST_CASE("equal seeds give equal fields on every platform, other seeds other fields") {
	PlacementRequest request = square_field(25.0f, 8.0f, 3);
	request.clumping = 0.6f;
	request.exclusions = { rectangle({ 2, 30 }, { 3, 0 }) };
	const uint64_t hash = hash_of(placed(request));
	CHECK(hash == hash_of(placed(request)));
	CHECK(hash == 11999920369941407008ull);
	std::set<uint64_t> hashes = { hash };
	for (uint64_t seed = 100; seed < 120; seed++) {
		request.seed = seed;
		hashes.insert(hash_of(placed(request)));
	}
	CHECK(hashes.size() == 21);
}

TEST_CASE("exclusions and a smaller area remove plants but change none") {
	PlacementRequest request = square_field(40.0f, 3.0f, 4);
	request.clumping = 0.5f;
	const std::map<Root, uint64_t> all = by_root(placed(request));
	SUBCASE("exclusions") {
		request.exclusions = { rectangle({ 10, 10 }, { 4, 2 }), rectangle({ 3, 50 }) };
	}
	SUBCASE("a smaller area") {
		request.area = { { -20, -20 }, { 20, -15 }, { 1, 17 } };
	}
	const std::map<Root, uint64_t> fewer = by_root(placed(request));
	CHECK(fewer.size() > 1000);
	CHECK(fewer.size() < all.size());
	std::size_t found = 0;
	for (const auto &entry : all) {
		const glm::vec2 root = { entry.first[0], entry.first[1] };
		bool stays = is_inside(request.area, root);
		for (const Polygon &exclusion : request.exclusions) {
			stays = stays && !is_inside(exclusion, root);
		}
		const auto same = fewer.find(entry.first);
		CHECK((same != fewer.end()) == stays);
		if (same != fewer.end()) {
			found++;
			CHECK(same->second == entry.second);
		}
	}
	CHECK(found == fewer.size());
}

TEST_CASE("rows placed by several threads give the same bytes as all at once") {
	PlacementRequest request = square_field(40.0f, 12.0f, 3);
	request.clumping = 0.7f;
	request.exclusions = { rectangle({ 7, 9 }) };
	const uint64_t whole = hash_of(placed(request));
	const Placement placement(request);
	for (const int parts : { 1, 2, 3, 4, 7 }) {
		std::vector<FieldPlants> pieces(static_cast<std::size_t>(parts));
		std::vector<std::thread> threads;
		for (int i = 0; i < parts; i++) {
			threads.emplace_back([&, i] {
				const int rows = placement.row_count();
				placement.place_rows(i * rows / parts, (i + 1) * rows / parts, pieces[static_cast<std::size_t>(i)]);
			});
		}
		FieldPlants all;
		for (int i = 0; i < parts; i++) {
			threads[static_cast<std::size_t>(i)].join();
			all.append(pieces[static_cast<std::size_t>(i)]);
		}
		CHECK(hash_of(all) == whole);
	}
}

TEST_CASE("candidates are slightly more than the plants") {
	PlacementRequest request = square_field(50.0f, 6.0f, 1);
	request.area = { { 0, 0 }, { 50, 0 }, { 50, 50 }, { 49, 50 }, { 49, 1 }, { 1, 1 }, { 1, 50 }, { 0, 50 } };
	const Placement placement(request);
	FieldPlants plants;
	placement.place_rows(3, 60, plants);
	const std::size_t candidates = placement.candidate_count(3, 60);
	CHECK(candidates >= plants.x.size());
	// Two arms, with two or three cells of border on each side.
	CHECK(candidates <= plants.x.size() + 57 * 12);
}

TEST_CASE("an area can contain one plant, none, or a million") {
	CHECK(placed(square_field(40.0f, 0.0f, 1)).size() == 0);
	CHECK(placed(square_field(1.0e-3f, 1.0f, 1)).size() == 0);
	CHECK(placed(square_field(10.0f, 1.0e-30f, 1)).size() <= 1);
	// A cell of the grid and the range of its neighbours' jitter.
	int single = 0;
	for (uint64_t seed = 0; seed < 50; seed++) {
		PlacementRequest request = square_field(1.0f, 1.0f, 1);
		request.seed = seed;
		const int count = placed(request).size();
		CHECK(count <= 4);
		single += count == 1;
	}
	CHECK(single > 15);
	CHECK(std::abs(placed(square_field(1000.0f, 1.0f, 5)).size() - 1000000) < 1000);
}
