#include "field_fixture.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

using namespace undergrowth;

TEST_CASE("the phase of a page, not its number, selects the step of its interval") {
	FieldSettings settings;
	settings.update_interval = 4;
	FieldSimulation field = mixed_field(settings, 1024);
	REQUIRE(field.page_count() == 8);
	const int phases[] = { 2, 2, 2, 2, 1, 7, 3, 0 };
	for (int page = 0; page < 8; page++) {
		field.set_page_phase(page, phases[page]);
	}
	for (int i = 0; i < 12; i++) {
		int due = 0;
		for (int page = 0; page < 8; page++) {
			due += i % 4 == phases[page] % 4 ? field.page(page).live_count() : 0;
		}
		CHECK(field.due_count() == due);
		field.step();
		for (int page = 0; page < 8; page++) {
			CHECK(field.has_stepped(page) == (i % 4 == phases[page] % 4));
		}
	}
	field.set_update_interval(1); // Phases have no effect then.
	for (int i = 0; i < 8; i++) {
		field.step();
	}
	for (int page = 0; page < 8; page++) {
		CHECK(field.has_stepped(page));
	}
}

TEST_CASE("a page with a reused number is due by that number again") {
	FieldSettings settings;
	settings.update_interval = 4;
	FieldSimulation field = mixed_field(settings, 512);
	field.set_page_phase(1, 2);
	field.remove_page(1);
	const MotionPlant plant = chance_plant(1);
	REQUIRE(field.add_page(0, &plant, 1) == 1);
	for (int i = 0; i < 8; i++) {
		field.step();
		CHECK(field.has_stepped(1) == (i % 4 == 1));
	}
}

TEST_CASE("changed intervals take effect at the first step of the phase after the present interval") {
	FieldSimulation field = mixed_field({}, 1024);
	const int pages = field.page_count();
	const auto count = static_cast<std::size_t>(pages);
	std::vector<int> multiples(count, 1), intervals(count, 1), phases(count, 0);
	std::vector<int64_t> last_steps(count, -1);
	for (int page = 0; page < pages; page++) {
		phases[static_cast<std::size_t>(page)] = page;
	}
	int of_field = 1;
	for (int64_t step = 0; step < 400; step++) {
		const auto chance = [step](uint64_t which) { return mix_bits(static_cast<uint64_t>(step) * 8 + which) >> 8; };
		const int changed = static_cast<int>(chance(0) % static_cast<uint64_t>(pages));
		if (step % 3 == 0) {
			multiples[static_cast<std::size_t>(changed)] = 1 << chance(1) % 5;
			field.set_page_multiple(changed, multiples[static_cast<std::size_t>(changed)]);
		}
		if (step % 17 == 0) {
			of_field = 1 + static_cast<int>(chance(2) % 5);
			field.set_update_interval(of_field);
		}
		if (step % 29 == 0) {
			phases[static_cast<std::size_t>(changed)] = static_cast<int>(chance(3) % 64);
			field.set_page_phase(changed, phases[static_cast<std::size_t>(changed)]);
		}
		std::vector<int> due;
		for (int page = 0; page < pages; page++) {
			const auto i = static_cast<std::size_t>(page);
			const int interval = std::min(of_field * multiples[i], 64);
			if ((last_steps[i] < 0 || step >= last_steps[i] + intervals[i]) && (step - phases[i]) % interval == 0) {
				due.push_back(page);
				last_steps[i] = step;
				intervals[i] = interval;
			}
		}
		field.step();
		REQUIRE(field.due_pages() == due);
		for (int page = 0; page < pages; page++) {
			CHECK(field.has_stepped(page) == (last_steps[static_cast<std::size_t>(page)] == step));
		}
	}
}
