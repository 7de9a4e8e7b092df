#include "../base/sanitized.hpp"
#include "allocations.hpp"
#include "field/contact.hpp"
#include "field_fixture.hpp"

#include <doctest/doctest.h>

using namespace undergrowth;

namespace {

constexpr int STEPS = repetitions(600, 120);

MovingBody walker(int step) {
	MovingBody body;
	body.from = { -20.0f + 0.1f * static_cast<float>(step), 0.3f, 0.0f };
	body.to = { -20.0f + 0.1f * static_cast<float>(step), 1.5f, 3.0f };
	body.velocity = { 6.0f, 0.0f, 0.0f };
	return body;
}

/// Allocations of a field's steps, from the second one on.
long allocations_of_steps(const FieldSettings &settings, bool with_contact) {
	FieldSimulation field = mixed_field(settings, 3000);
	TipContact contact;
	contact.fit(field);
	long before = 0;
	for (int i = 0; i < STEPS; i++) {
		const MovingBody body = walker(i);
		field.set_bodies(&body, 1);
		if (i == 1) {
			before = allocation_count();
		}
		field.set_page_multiple(0, i % 60 < 30 ? 1 : 4);
		field.step();
		if (with_contact) {
			contact.resolve(field);
		}
	}
	return allocation_count() - before;
}

} // namespace

TEST_CASE("allocations are counted" * doctest::skip(!counts_allocations())) {
	const long before = allocation_count();
	const std::vector<int> some(100);
	const Columns table(3); // Aligned.
	CHECK(allocation_count() == before + 2);
}

TEST_CASE("a step of a field allocates nothing") {
	FieldSettings settings;
	CHECK(allocations_of_steps(settings, false) == 0);
	CHECK(allocations_of_steps(settings, true) == 0);
	settings.update_interval = 4;
	CHECK(allocations_of_steps(settings, false) == 0);
}

TEST_CASE("a step of a field with prototypes allocates nothing, while a body pushes plants that follow") {
	FieldSettings settings;
	settings.prototypes = 32;
	CHECK(allocations_of_steps(settings, false) == 0);
}
