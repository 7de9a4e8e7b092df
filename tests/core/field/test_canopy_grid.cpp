#include "../motion/varied.hpp"
#include "../wind/air_series.hpp"
#include "figures.hpp"

#include "field/canopy_grid.hpp"
#include "field/field_simulation.hpp"
#include "wind/air_profile.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>

using namespace undergrowth;

namespace {

constexpr int LOW = 0, TALL = 1, TALLER = 2;
constexpr float LOW_HEIGHT = 0.2f, TALL_HEIGHT = 0.9f, TALLER_HEIGHT = 1.5f;

/// A square of `side` metres from the origin on with `per_metre` plants in a row of a metre.
void plant(CanopyGrid &grid, int species, float side, float per_metre, float drag_area) {
	const int count = static_cast<int>(side * per_metre);
	for (int i = 0; i < count * count; i++) {
		const float x = (static_cast<float>(i % count) + 0.5f) / per_metre;
		const float z = (static_cast<float>(i / count) + 0.5f) / per_metre;
		grid.add(species, x, z, drag_area);
	}
}

CanopyGrid three_species() {
	CanopyGrid grid;
	grid.set_height(LOW, LOW_HEIGHT);
	grid.set_height(TALL, TALL_HEIGHT);
	grid.set_height(TALLER, TALLER_HEIGHT);
	return grid;
}

TallerPlants at(const CanopyGrid &grid, int species, float place) {
	return grid.higher_than(grid.height(species), { place, 0.0f, 20.0f }, { place + 1.0f, 1.0f, 21.0f });
}

MotionSpecies springs_of(float height) {
	MotionSpecies species = species_with(Law::spring, varied_joint(1));
	species.joint.drag_area = 0.03f;
	species.joint.natural_frequency = 4.0f;
	species.canopy_height = height;
	return species;
}

/// Plants of `height` on a square, from `first` on, `count` in a row.
std::vector<MotionPlant> square_of(float height, float first, int count, float distance) {
	std::vector<MotionPlant> plants;
	for (int i = 0; i < count * count; i++) {
		MotionPlant one;
		one.root = { first + distance * static_cast<float>(i % count), 0.0f,
			first + distance * static_cast<float>(i / count) };
		one.length = height;
		plants.push_back(one);
	}
	return plants;
}

std::vector<MotionPlant> low_plants() {
	return square_of(LOW_HEIGHT, 10.0f, 8, 0.2f);
}

std::vector<MotionPlant> tall_plants() {
	return square_of(TALL_HEIGHT, 0.0f, 60, 0.4f);
}

FieldWind steady_air() {
	FieldWind wind;
	wind.wind.kind = WindKind::air;
	wind.air.speed = 8.0f;
	wind.air.turbulence = 0.0f;
	wind.tiles = std::shared_ptr<const AirTiles>(&shared_tiles(), [](const AirTiles *) {});
	return wind;
}

/// Slope of the low plant in the middle of a square after ten seconds.
float slope_of_low(bool has_tall, int prototypes = 0) {
	FieldSettings settings;
	settings.prototypes = prototypes;
	FieldSimulation field(settings);
	const int low = field.add_species(springs_of(LOW_HEIGHT));
	const int tall = field.add_species(springs_of(TALL_HEIGHT));
	const std::vector<MotionPlant> few = low_plants();
	const int page = field.add_page(low, few.data(), static_cast<int>(few.size()));
	if (has_tall) {
		const std::vector<MotionPlant> many = tall_plants();
		field.add_page(tall, many.data(), static_cast<int>(many.size()));
	}
	field.set_wind(steady_air());
	for (int i = 0; i < 600; i++) {
		field.step();
	}
	const glm::vec3 shown = field.shown_direction(page, 27, 1.0f);
	return std::hypot(shown.x, shown.z) / shown.y;
}

} // namespace

TEST_CASE(
		"a canopy is closed from a drag area of 0.15 per area of ground on, and has the height of the taller species") {
	CanopyGrid grid = three_species();
	CHECK(at(grid, LOW, 20.0f) == TallerPlants());
	plant(grid, LOW, 40.0f, 4.0f, 0.1f);
	CHECK(at(grid, LOW, 20.0f) == TallerPlants());
	plant(grid, TALL, 40.0f, 2.0f, 0.075f / 4.0f);
	CHECK(at(grid, LOW, 20.0f).cover == doctest::Approx(0.5));
	CHECK(at(grid, LOW, 20.0f).height == doctest::Approx(TALL_HEIGHT));
	CHECK(at(grid, TALL, 20.0f) == TallerPlants());
	plant(grid, TALLER, 40.0f, 2.0f, 0.225f / 4.0f);
	CHECK(at(grid, LOW, 20.0f).cover == 1.0f);
	CHECK(at(grid, LOW, 20.0f).height == doctest::Approx(0.25 * TALL_HEIGHT + 0.75 * TALLER_HEIGHT));
	CHECK(at(grid, TALL, 20.0f).height == doctest::Approx(TALLER_HEIGHT));
	CHECK(grid.higher_than(LOW_HEIGHT) == at(grid, LOW, 20.0f));
}

TEST_CASE("shelter begins over two cells at the edge of a canopy") {
	CanopyGrid grid = three_species();
	plant(grid, TALL, 40.0f, 2.0f, 0.16f / 4.0f);
	CHECK(at(grid, LOW, -9.0f).cover == 0.0f);
	const float outside = at(grid, LOW, -3.0f).cover;
	const float inside = at(grid, LOW, 1.0f).cover;
	CHECK(outside > 0.1f);
	CHECK(inside > outside + 0.2f);
	CHECK(inside < 0.9f);
	CHECK(at(grid, LOW, 5.0f).cover == doctest::Approx(1.0));
}

TEST_CASE("a canopy of removed plants is that before they were added, in any order") {
	CanopyGrid grid = three_species();
	plant(grid, TALL, 40.0f, 2.0f, 0.01f);
	const TallerPlants before = at(grid, LOW, 20.0f);
	plant(grid, TALLER, 40.0f, 3.0f, 0.0123f);
	CHECK(!(at(grid, LOW, 20.0f) == before));
	plant(grid, TALLER, 40.0f, 3.0f, -0.0123f);
	CHECK(at(grid, LOW, 20.0f) == before);
	grid.clear();
	CHECK(at(grid, LOW, 20.0f) == TallerPlants());
}

TEST_CASE("low plants in a closed canopy feel the wind of the extinction law") {
	const float alone = slope_of_low(false);
	const float among = slope_of_low(true);
	const double sheltered = canopy_speed(static_cast<double>(LOW_HEIGHT), static_cast<double>(TALL_HEIGHT));
	const double open = canopy_top_speed(static_cast<double>(LOW_HEIGHT));
	CHECK(open / sheltered > 5.0); // 27 times the force.
	CHECK(static_cast<double>(among / alone) == doctest::Approx(sheltered * sheltered / (open * open)).epsilon(0.03));
	figures::record(figures::WIND, "force on plants of 0.2 m below a closed canopy of 0.9 m, of that in the open",
			sheltered * sheltered / (open * open), static_cast<double>(among / alone), 4);
	CHECK(static_cast<double>(slope_of_low(true, 8) / slope_of_low(false, 8)) ==
			doctest::Approx(sheltered * sheltered / (open * open)).epsilon(0.03));
}

TEST_CASE("low plants feel more wind when the taller ones are removed or mown") {
	const auto slope_after = [](bool is_mown) {
		FieldSimulation field(FieldSettings{});
		const int low = field.add_species(springs_of(LOW_HEIGHT));
		const int tall = field.add_species(springs_of(TALL_HEIGHT));
		const std::vector<MotionPlant> few = low_plants();
		std::vector<MotionPlant> many = tall_plants();
		const int page = field.add_page(low, few.data(), static_cast<int>(few.size()));
		const int others = field.add_page(tall, many.data(), static_cast<int>(many.size()));
		field.set_wind(steady_air());
		field.step();
		CHECK(field.page(page).taller_plants().cover == 1.0f);
		CHECK(field.air_speed(low) < 0.5f * field.air_speed(tall));
		for (int i = 0; i < static_cast<int>(many.size()); i++) {
			if (is_mown) {
				many[static_cast<std::size_t>(i)].length = 0.05f;
				field.set_plant(others, i, many[static_cast<std::size_t>(i)]);
			} else {
				field.drop(others, i);
			}
		}
		for (int i = 0; i < 120; i++) {
			field.step();
		}
		return field.page(page).taller_plants().cover;
	};
	CHECK(slope_after(false) == 0.0f);
	CHECK(slope_after(true) < 0.02f);
}

TEST_CASE("a plant beside a field's own has their canopy, and other plants a canopy if they are not much higher") {
	CanopyGrid grid = three_species();
	const glm::vec3 place = { 20.0f, 0.0f, 20.0f };
	plant(grid, LOW, 40.0f, 2.0f, 0.16f / 4.0f);
	CHECK(grid.around(place, 0.25f, LOW).height == LOW_HEIGHT);
	CHECK(grid.around({ 60.0f, 0.0f, 20.0f }, 0.25f, LOW).height == 0.0f);
	CHECK(grid.around(place, 0.25f, -1).height == 0.25f);
	CHECK(grid.around(place, 0.5f, -1).height == 0.0f);
	CHECK(grid.around(place, 0.5f, TALL).height == 0.0f);
	plant(grid, TALL, 40.0f, 2.0f, 0.16f / 4.0f);
	CHECK(grid.around(place, 0.5f, -1).taller == TallerPlants{ TALL_HEIGHT, 1.0f });
	CHECK(grid.around(place, 0.25f, LOW).taller == TallerPlants{ TALL_HEIGHT, 1.0f });
}

TEST_CASE("a box of any size is read at once") {
	CanopyGrid grid = three_species();
	plant(grid, TALL, 40.0f, 2.0f, 0.15f / 4.0f);
	const glm::vec3 far(1e9f, 0.0f, 1e9f);
	CHECK(grid.higher_than(LOW_HEIGHT, -far, far) == grid.higher_than(LOW_HEIGHT));
	CHECK(grid.higher_than(LOW_HEIGHT, far, far) == TallerPlants());
}

TEST_CASE("shelter follows a species whose drag or height changes") {
	FieldSimulation field(FieldSettings{});
	const int low = field.add_species(springs_of(LOW_HEIGHT));
	const int tall = field.add_species(springs_of(TALL_HEIGHT));
	const std::vector<MotionPlant> few = low_plants();
	const std::vector<MotionPlant> many = tall_plants();
	const int page = field.add_page(low, few.data(), static_cast<int>(few.size()));
	field.add_page(tall, many.data(), static_cast<int>(many.size()));
	const auto shelter_with = [&](const MotionSpecies &species) {
		field.set_species(tall, species);
		for (int i = 0; i < 120; i++) {
			field.step();
		}
		return field.page(page).taller_plants();
	};
	MotionSpecies thin = springs_of(TALL_HEIGHT);
	thin.joint.drag_area = 0.005f;
	MotionSpecies lowest = springs_of(0.5f * LOW_HEIGHT);
	CHECK(shelter_with(springs_of(TALL_HEIGHT)) == TallerPlants{ TALL_HEIGHT, 1.0f });
	CHECK(shelter_with(thin).cover < 0.5f);
	CHECK(shelter_with(lowest) == TallerPlants());
}
