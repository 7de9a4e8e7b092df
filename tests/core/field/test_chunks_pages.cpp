#include "field/chunks.hpp"
#include "motion/motion_page.hpp"
#include "test_placement_fixture.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

using namespace undergrowth;

namespace {

FieldChunks chunks_of(FieldPlants &plants, float size) {
	return sort_into_chunks(plants, size, nullptr, 0);
}

/// Each plant is in one page, where find() tells.
void check_cover(const PagePlan &plan, const FieldPlants &plants, int most) {
	std::vector<int> seen(plants.x.size(), 0);
	for (std::size_t page = 0; page < plan.pages.size(); page++) {
		const std::vector<int> members = plan.plants(static_cast<int>(page));
		CHECK(static_cast<int>(members.size()) == plan.pages[page].count);
		CHECK(members.size() <= static_cast<std::size_t>(most));
		CHECK(!members.empty());
		for (std::size_t i = 0; i < members.size(); i++) {
			seen[static_cast<std::size_t>(members[i])]++;
			CHECK(plants.species[static_cast<std::size_t>(members[i])] == plan.pages[page].species);
			const PagePlace place = plan.find(members[i]);
			CHECK(place.page == static_cast<int>(page));
			CHECK(place.index == static_cast<int>(i));
		}
	}
	CHECK(std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; }));
}

} // namespace

TEST_CASE("pages are of one species, of no more plants than a page holds, and cover all plants once") {
	FieldPlants plants = placed(square_field(70.0f, 5.0f, 5));
	const FieldChunks field = chunks_of(plants, 10.0f);
	for (const int most : { MotionPage::PAGE_PLANTS, 1000, 1 }) {
		check_cover(plan_pages(field, most), plants, most);
	}
}

TEST_CASE("a species has as few pages as can be, all but its last full") {
	FieldPlants plants = placed(square_field(100.0f, 5.0f, 3));
	const PagePlan plan = plan_pages(chunks_of(plants, 16.0f));
	for (std::size_t i = 0; i < plan.pages.size(); i++) {
		const bool is_last = i + 1 == plan.pages.size() || plan.pages[i + 1].species != plan.pages[i].species;
		CHECK((is_last || plan.pages[i].count == MotionPage::PAGE_PLANTS));
		CHECK((i == 0 || plan.pages[i - 1].species <= plan.pages[i].species));
	}
	CHECK(plan.pages.back().species == 2);
}

TEST_CASE("plants of a page are neighbours") {
	FieldPlants plants = placed(square_field(256.0f, 2.0f, 2));
	const PagePlan plan = plan_pages(chunks_of(plants, 16.0f));
	for (std::size_t page = 0; page < plan.pages.size(); page++) {
		const std::vector<int> members = plan.plants(static_cast<int>(page));
		double x = 0.0;
		double z = 0.0;
		for (const int plant : members) {
			x += static_cast<double>(plants.x[static_cast<std::size_t>(plant)]) / static_cast<double>(members.size());
			z += static_cast<double>(plants.z[static_cast<std::size_t>(plant)]) / static_cast<double>(members.size());
		}
		double spread = 0.0;
		for (const int plant : members) {
			const double dx = static_cast<double>(plants.x[static_cast<std::size_t>(plant)]) - x;
			const double dz = static_cast<double>(plants.z[static_cast<std::size_t>(plant)]) - z;
			spread += (dx * dx + dz * dz) / static_cast<double>(members.size());
		}
		// 4096 plants at one a square metre are a square of 64 m: a mean square distance of 64²/6. Twice that, as
		// pieces of the curve are not square; the whole field would have 256²/6.
		CHECK(spread < 2.0 * 64.0 * 64.0 / 6.0);
	}
}

TEST_CASE("one plant is a page, and a page may be cut in the middle of a chunk") {
	FieldPlants plants;
	plants.add({});
	check_cover(plan_pages(chunks_of(plants, 16.0f)), plants, 4096);
	for (int i = 0; i < 9999; i++) {
		plants.add({});
	}
	const PagePlan plan = plan_pages(chunks_of(plants, 16.0f));
	REQUIRE(plan.pages.size() == 3);
	CHECK(plan.pages[2].count == 10000 - 2 * 4096);
	check_cover(plan, plants, 4096);
}

TEST_CASE("a million plants are sorted and divided") {
	FieldPlants plants = placed(square_field(1000.0f, 1.0f, 5));
	const FieldChunks field = chunks_of(plants, 16.0f);
	const PagePlan plan = plan_pages(field);
	int count = 0;
	for (const PagePlants &page : plan.pages) {
		count += page.count;
	}
	CHECK(count == plants.size());
	CHECK(field.chunks.back().end == plants.size());
	CHECK(plan.pages.size() <= 1000000 / 4096 + 6);
}
