// Whole steps of fields of plants, with the ways to save time, and contact; on one thread and on four.

#include "base/random.hpp"
#include "field/contact.hpp"
#include "field/field_simulation.hpp"
#include "page_workers.hpp"
#include "report.hpp"
#include "stem/stem_beam.hpp"

#include <cmath>

using namespace undergrowth;

namespace {

constexpr int PLANTS_OF_TILE = 400; // Of one species, in a meadow of five.
constexpr float PLANTS_PER_SQUARE_METRE = 10.0f;

/// Half of each law, under waves.
FieldSimulation waving_field(const FieldSettings &settings, int plants, int max_in_page = MotionPage::PAGE_PLANTS) {
	FieldSimulation field(settings);
	const int page_size = std::clamp(plants / 16, 256, max_in_page);
	const float side = std::sqrt(static_cast<float>(page_size) / PLANTS_PER_SQUARE_METRE); // A page is one place.
	constexpr int PAGES_IN_ROW = 8;
	for (const Law law : { Law::elasticity, Law::spring }) {
		MotionSpecies species;
		species.law = law;
		species.canopy_height = 0.75f;
		const int kind = field.add_species(species);
		std::vector<MotionPlant> page;
		for (int i = 0; i < plants / 2; i++) {
			const auto noise = [i, kind](uint64_t which) {
				return signed_noise(which + 100 * static_cast<uint64_t>(kind), static_cast<uint64_t>(i));
			};
			MotionPlant plant;
			const int number = i / page_size;
			const auto column = static_cast<float>(number % PAGES_IN_ROW);
			const auto row = static_cast<float>(number / PAGES_IN_ROW);
			plant.root = { side * (column + 0.5f * noise(1)), 0.0f, side * (row + 0.5f * noise(2)) };
			plant.length = 0.75f + 0.25f * noise(3);
			page.push_back(plant);
			if (static_cast<int>(page.size()) == page_size || i == plants / 2 - 1) {
				field.add_page(kind, page.data(), static_cast<int>(page.size()));
				page.clear();
			}
		}
	}
	FieldWind wind;
	wind.wind.kind = WindKind::waves;
	wind.wind.strength = 2.0f;
	field.set_wind(wind);
	return field;
}

void step(FieldSimulation &field, PageWorkers &workers) {
	field.begin_step();
	workers.for_pages(field.page_count(), [&field](int begin, int end) { field.step_pages(begin, end); });
}

void time_field(Report &report, const char *name, const FieldSettings &settings, int plants, int threads,
		int max_in_page = MotionPage::PAGE_PLANTS, const FieldWind *wind = nullptr) {
	FieldSimulation field = waving_field(settings, plants, max_in_page);
	if (wind) {
		field.set_wind(*wind);
	}
	PageWorkers workers(threads);
	// Whole turns of the interval, so that every run does the same.
	const int repeats = std::max(PLANTS_PER_RUN / plants, 1) * settings.update_interval;
	const double run = median_ms(
							   [&] {
								   for (int i = 0; i < repeats; i++) {
									   step(field, workers);
								   }
							   },
							   FEW_RUNS) /
			repeats;
	report.row(name, plants, threads, run, best_simd_level(), member("bytes_per_plant", field.bytes_per_plant()));
}

void time_ladder(Report &report) {
	FieldSettings interval_4;
	interval_4.update_interval = 4;
	FieldSettings prototypes_64;
	prototypes_64.prototypes = 64;
	const bool has_four = std::thread::hardware_concurrency() >= 4;
	for (const int plants : { 1000, 10000, 100000, 1000000 }) {
		for (const int threads : { 1, 4 }) {
			if (threads == 1 || has_four) {
				time_field(report, "field_step", {}, plants, threads);
				time_field(report, "field_step_tiles", {}, plants, threads, PLANTS_OF_TILE);
				time_field(report, "field_step_interval_4", interval_4, plants, threads);
				time_field(report, "field_step_prototypes_64", prototypes_64, plants, threads);
			}
		}
	}
}

/// Beside field_step, which blows in waves of newtons.
void time_air_fields(Report &report) {
	FieldWind wind;
	wind.wind.kind = WindKind::air;
	wind.air.speed = 9.0f;
	wind.tiles = make_air_tiles(0);
	time_field(report, "field_step_air", {}, 100000, 1, MotionPage::PAGE_PLANTS, &wind);
}

void time_contact(Report &report, int threads) {
	constexpr int PLANTS = 100000;
	FieldSimulation field = waving_field({}, PLANTS);
	TipContact contact;
	contact.fit(field);
	for (int i = 0; i < 60; i++) {
		field.step();
	}
	PageWorkers workers(threads);
	const int pages = field.page_count();
	const auto resolve = [&] {
		workers.for_pages(pages, [&](int begin, int end) { contact.gather(field, begin, end); });
		contact.sort();
		workers.for_pages(pages, [&](int begin, int end) { contact.count(field, begin, end); });
		workers.for_pages(pages, [&](int begin, int end) { contact.separate(field, begin, end); });
	};
	report.row("field_contact", PLANTS, threads, median_ms(resolve, FEW_RUNS), best_simd_level());
}

constexpr int WALKERS = 60;
constexpr float GRASS_PER_SQUARE_METRE = 40.0f;
constexpr int GRASS_PAGES_IN_ROW = 5;
constexpr float GRASS_PAGE_SIDE = 10.0f; // m.

/// A page of grass, square metre by square metre, so that rows that follow each other are near each other.
std::vector<MotionPlant> grass_page(int page) {
	const auto side = static_cast<int>(GRASS_PAGE_SIDE);
	std::vector<MotionPlant> plants;
	for (int i = 0; i < side * side * static_cast<int>(GRASS_PER_SQUARE_METRE); i++) {
		const int square = i / static_cast<int>(GRASS_PER_SQUARE_METRE);
		const auto noise = [i, page](uint64_t which) {
			return 0.5f + 0.5f * signed_noise(which, static_cast<uint64_t>(i + 10000 * page));
		};
		MotionPlant plant;
		plant.root.x = GRASS_PAGE_SIDE * static_cast<float>(page % GRASS_PAGES_IN_ROW) +
				static_cast<float>(square % side) + noise(1);
		plant.root.z = GRASS_PAGE_SIDE * static_cast<float>(page / GRASS_PAGES_IN_ROW) +
				static_cast<float>(square / side) + noise(2);
		plant.length = 0.4f + 0.3f * noise(3);
		plants.push_back(plant);
	}
	return plants;
}

FieldSimulation grass_field() {
	FieldSimulation field({});
	MotionSpecies species;
	species.law = Law::stem;
	StemBeam beam;
	beam.length = 0.55f;
	beam.diameter = 0.005f; // Upright by its own stiffness.
	species.stem = solve_stem(beam).constants;
	field.add_species(species);
	for (int page = 0; page < GRASS_PAGES_IN_ROW * GRASS_PAGES_IN_ROW; page++) {
		const std::vector<MotionPlant> plants = grass_page(page);
		field.add_page(0, plants.data(), static_cast<int>(plants.size()));
	}
	return field;
}

/// As high as people, all on ways of their own.
std::vector<MovingBody> walkers_at(float time) {
	constexpr float SPEED = 1.4f; // m/s.
	std::vector<MovingBody> walkers;
	for (int i = 0; i < WALKERS; i++) {
		MovingBody body;
		const float x = 3.0f + 5.0f * static_cast<float>(i % 10);
		const float z = 3.0f + 8.0f * static_cast<float>(i / 10);
		body.from = { x + SPEED * time, 0.4f, z };
		body.to = body.from + glm::vec3(0.0f, 1.0f, 0.0f);
		body.radius = 0.4f;
		body.velocity = { SPEED, 0.0f, 0.0f };
		walkers.push_back(body);
	}
	return walkers;
}

/// What 60 bodies in grass of 40 plants/m² add to a step; us_per_plant is the time per body.
void time_bodies(Report &report) {
	FieldSimulation field = grass_field();
	float time = 0.0f;
	const auto step = [&](bool is_pushed) {
		time = time < 1.0f ? time + field.settings().step : 0.0f;
		const std::vector<MovingBody> walkers = walkers_at(time);
		field.set_bodies(walkers.data(), is_pushed ? WALKERS : 0);
		field.step();
	};
	const double calm = median_ms([&] { step(false); });
	const double pushed = median_ms([&] { step(true); });
	report.row("field_bodies", WALKERS, 1, pushed - calm, best_simd_level());
}

} // namespace

void undergrowth::time_fields(Report &report) {
	time_ladder(report);
	time_air_fields(report);
	time_bodies(report);
	time_contact(report, 1);
	if (std::thread::hardware_concurrency() >= 4) {
		time_contact(report, 4);
	}
}
