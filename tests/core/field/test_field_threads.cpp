#include "field/contact.hpp"
#include "field_fixture.hpp"

#include <doctest/doctest.h>

#include <initializer_list>
#include <thread>

using namespace undergrowth;

namespace {

constexpr int PLANTS_OF_EACH = 3000;
constexpr int STEPS = 24;

FieldSimulation threaded_field(int prototypes) {
	FieldSettings settings;
	settings.update_interval = 2;
	settings.prototypes = prototypes;
	FieldSimulation field = mixed_field(settings, PLANTS_OF_EACH);
	MovingBody body;
	body.from = { -20.0f, 0.3f, 0.0f };
	body.to = { 20.0f, 0.3f, 5.0f };
	body.velocity = { 0.0f, 0.0f, 1.0f };
	field.set_bodies(&body, 1);
	return field;
}

/// Calls work(begin, end) for `threads` ranges of pages in parallel.
template <class Work> void split(int threads, int pages, const Work &work) {
	std::vector<std::thread> running;
	for (int i = 0; i < threads; i++) {
		running.emplace_back([&work, i, threads, pages] { work(pages * i / threads, pages * (i + 1) / threads); });
	}
	for (std::thread &thread : running) {
		thread.join();
	}
}

uint64_t run(int prototypes, int threads, bool with_contact) {
	FieldSimulation field = threaded_field(prototypes);
	TipContact contact;
	contact.fit(field);
	const int pages = field.page_count();
	for (int i = 0; i < STEPS; i++) {
		field.begin_step();
		split(threads, pages, [&field](int begin, int end) { field.step_pages(begin, end); });
		if (with_contact) {
			split(threads, pages, [&](int begin, int end) { contact.gather(field, begin, end); });
			contact.sort();
			split(threads, pages, [&](int begin, int end) { contact.count(field, begin, end); });
			split(threads, pages, [&](int begin, int end) { contact.separate(field, begin, end); });
		}
	}
	return hash_field(field);
}

} // namespace

TEST_CASE("a field has the same bits on 1, 2, 3, 4 and 7 threads") {
	for (const int prototypes : { 0, 32 }) {
		for (const bool with_contact : { false, true }) {
			const uint64_t single = run(prototypes, 1, with_contact);
			for (const int threads : { 2, 3, 4, 7 }) {
				CHECK(run(prototypes, threads, with_contact) == single);
			}
		}
	}
}
