#include "field_fixture.hpp"

#include <doctest/doctest.h>

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
