#include "field/field_simulation.hpp"

#include "motion/gnomonic.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace undergrowth {

namespace {

constexpr int MAX_INTERVAL = 64;
constexpr int MAX_MULTIPLE = 32;
constexpr int LONGEST_INTERVAL = 64; // Steps: one second, about the swing of a plant.
constexpr float USUAL_STEP = 1.0f / 60.0f; // s.

FieldSettings safe_settings(const FieldSettings &settings) {
	FieldSettings safe = settings;
	safe.step = std::isfinite(settings.step) && settings.step > 0.0f ? settings.step : USUAL_STEP;
	safe.update_interval = std::clamp(settings.update_interval, 1, MAX_INTERVAL);
	safe.prototypes = std::clamp(settings.prototypes, 0, Prototypes::MAX_COUNT);
	return safe;
}

bool are_valid(const MotionPlant *plants, int count) {
	return std::all_of(plants, plants + count, [](const MotionPlant &plant) { return is_valid(plant); });
}

} // namespace

FieldSimulation::FieldSimulation(const FieldSettings &settings) :
		options(safe_settings(settings)), delays(options.step) {
	along = winds_along(blowing);
}

int FieldSimulation::add_species(const MotionSpecies &species) {
	kinds.push_back(species);
	if (options.prototypes > 0) {
		models.emplace_back(species_count() - 1, species, options.prototypes, options.step);
		detached.emplace_back(species_count() - 1, species, options.step);
		stirred.emplace_back();
	}
	return species_count() - 1;
}

void FieldSimulation::set_species(int index, const MotionSpecies &species) {
	kinds[static_cast<std::size_t>(index)] = species;
	for (Entry &entry : entries) {
		if (entry.page.species() == index) {
			const bool had_two = entry.page.modes() == 2;
			entry.page.set_species(species);
			entry.page.set_modes(had_two ? 2 : 1);
		}
	}
	if (!models.empty()) {
		models[static_cast<std::size_t>(index)].set_species(species);
		detached[static_cast<std::size_t>(index)].set_species(species);
	}
}

int FieldSimulation::add_page(int species, const MotionPlant *plants, int count) {
	if (species < 0 || species >= species_count() || count < 0 || count > MotionPage::PAGE_PLANTS) {
		return -1;
	}
	if (!are_valid(plants, count)) {
		return -1;
	}
	const MotionSpecies &kind = kinds[static_cast<std::size_t>(species)];
	const float step_length = options.step * static_cast<float>(options.update_interval);
	return add_page(MotionPage(species, kind, plants, count, step_length, models.empty()), plants);
}

int FieldSimulation::add_page(MotionPage &&page, const MotionPlant *plants) {
	const int count = page.size();
	Entry entry = { std::move(page), {}, false, false };
	const auto is_free = [](const Entry &one) { return one.is_free; };
	const auto place = free_pages > 0 ? std::find_if(entries.begin(), entries.end(), is_free) : entries.end();
	const int number = static_cast<int>(place - entries.begin());
	entry.page.set_modes(1);
	if (place == entries.end()) {
		entries.push_back(std::move(entry));
		beats.emplace_back();
		changed.reserve(entries.size()); // It grows within steps.
	} else {
		free_pages--;
		entry.is_changed = place->is_changed;
		*place = std::move(entry);
	}
	beat(number) = Beat();
	beat(number).interval = options.update_interval;
	beat(number).phase = number;
	take_in(at(number), plants, count);
	return number;
}

bool FieldSimulation::add_to_page(int page, const MotionPlant *plants, int count) {
	if (count < 0 || at(page).page.size() + count > MotionPage::PAGE_PLANTS || !are_valid(plants, count)) {
		return false;
	}
	at(page).page.add(plants, count);
	take_in(at(page), plants, count);
	return true;
}

/// Updates the field's box and assigns prototypes for the new plants of a page.
void FieldSimulation::take_in(Entry &entry, const MotionPlant *plants, int count) {
	if (count > 0) {
		grow_box(entry.page, plant_rows == 0);
		plant_rows += count;
		update_delays();
	}
	if (models.empty()) {
		return;
	}
	entry.followers.reserve(entry.followers.size() + static_cast<std::size_t>(count));
	for (int i = 0; i < count; i++) {
		entry.followers.push_back(pick(plants[i], entry.page.species()));
	}
	detached_of(entry).reserve(count_of_species(entry.page.species()));
}

void FieldSimulation::grow_box(const MotionPage &page, bool is_first) {
	box_low = is_first ? page.low() : glm::min(box_low, page.low());
	box_high = is_first ? page.high() : glm::max(box_high, page.high());
}

/// Updates the box of all plants, and everything that depends on it.
void FieldSimulation::update_box() {
	plant_rows = 0;
	for (const Entry &entry : entries) {
		if (entry.page.size() > 0) {
			grow_box(entry.page, plant_rows == 0);
			plant_rows += entry.page.size();
		}
	}
	update_delays();
}

void FieldSimulation::drop(int page, int index) {
	Entry &entry = at(page);
	if (!entry.followers.empty()) {
		follow_again(entry, index);
	}
	entry.page.drop(index);
}

void FieldSimulation::remove_page(int page) {
	Entry &entry = at(page);
	for (std::size_t i = 0; i < entry.followers.size(); i++) {
		follow_again(entry, static_cast<int>(i));
	}
	entry.followers = {};
	const int species = entry.page.species();
	entry.page =
			MotionPage(species, kinds[static_cast<std::size_t>(species)], nullptr, 0, options.step, models.empty());
	free_pages += entry.is_free ? 0 : 1;
	entry.is_free = true;
	update_box();
}

void FieldSimulation::settle() {
	for (Entry &entry : entries) {
		if (entry.page.swings()) {
			entry.page.settle();
		}
	}
	for (DetachedFollowers &some : detached) {
		while (some.count() > 0) {
			const int last = some.count() - 1;
			follow_again(at(some.page_of(last)), some.index_of(last));
		}
	}
	for (Prototypes &model : models) {
		model.settle();
	}
}

void FieldSimulation::set_wind(const FieldWind &wind) {
	blowing = wind;
	along = winds_along(wind);
	update_delays();
}

void FieldSimulation::set_air_sources(const std::vector<AirSource> &sources) {
	stirring.clear();
	std::copy_if(sources.begin(), sources.end(), std::back_inserter(stirring),
			[&](const AirSource &source) { return reaches(source, box_low, box_high); });
}

void FieldSimulation::set_update_interval(int steps) {
	options.update_interval = std::clamp(steps, 1, MAX_INTERVAL);
}

void FieldSimulation::set_page_multiple(int page, int multiple) {
	beat(page).multiple = std::clamp(multiple, 1, MAX_MULTIPLE);
}

int FieldSimulation::page_interval(int page) const {
	return std::min(options.update_interval * beat(page).multiple, LONGEST_INTERVAL);
}

bool FieldSimulation::is_due(int page, int64_t number) const {
	const int interval = page_interval(page);
	// A page with a shorter interval first finishes the time of its last step, so that no pose jumps.
	const Beat &own = beat(page);
	const bool is_free = own.last_step < 0 || number >= own.last_step + own.interval;
	return is_free && (interval == 1 || number % interval == own.phase % interval);
}

void FieldSimulation::set_bodies(const MovingBody *bodies, int count) {
	pushing.clear();
	std::copy_if(
			bodies, bodies + count, std::back_inserter(pushing), [](const MovingBody &body) { return is_valid(body); });
}

void FieldSimulation::step_prototypes(int64_t number) {
	FieldWind wind = blowing;
	wind.wind.gust_start += static_cast<double>(lead); // A new gust starts at the upwind edge.
	for (Prototypes &model : models) {
		const double moment = static_cast<double>(number) + model.wind_moment();
		const double moment_time = moment * static_cast<double>(options.step) + static_cast<double>(lead);
		WindSnapshot now = wind_at_time(wind, along, moment_time);
		now.drift = &drift;
		model.step(now, along);
	}
}

void FieldSimulation::begin_step() {
	for (int64_t number = next_step == 0 ? -Prototypes::SLOTS : 0; number < 0; number++) {
		step_prototypes(number);
	}
	step_prototypes(next_step);
	choose_modes();
	const bool is_air = blowing.wind.kind == WindKind::air;
	for (int page = 0; page < page_count() && models.empty(); page++) { // Followers have no steps of their own.
		if (is_air) {
			at(page).page.make_room_ahead();
		}
		if (is_due(page, next_step)) {
			beat(page).interval = page_interval(page);
			beat(page).last_step = next_step;
		}
	}
	next_step++;
	delays.step();
	step_detached();
}

void FieldSimulation::step_pages(int begin, int end) {
	for (int page = std::max(begin, 0); page < std::min(end, page_count()) && models.empty(); page++) {
		if (has_stepped(page) && at(page).page.swings() && at(page).page.live_count() > 0) {
			step_page(page);
		}
	}
}

void FieldSimulation::step() {
	begin_step();
	step_pages(0, page_count());
}

void FieldSimulation::step_page(int page) {
	Entry &entry = at(page);
	if (page + 1 < page_count() && has_stepped(page + 1)) {
		at(page + 1).page.prefetch();
	}
	const int interval = beat(page).interval;
	const float step_length = options.step * static_cast<float>(interval);
	if (entry.page.step_length() != step_length) {
		entry.page.set_step_length(step_length);
	}
	const double moment = static_cast<double>(beat(page).last_step) + entry.page.wind_moment() * interval;
	WindSnapshot now = wind_at_time(blowing, along, moment * static_cast<double>(options.step));
	now.sources = { stirring.data(), static_cast<int>(stirring.size()) };
	now.drift = &drift;
	entry.page.sample_air_ahead(blowing, along, moment * static_cast<double>(options.step), page);
	if (entry.page.modes() == 2) {
		entry.page.ease_second(ease_of(page));
	}
	entry.page.step(now, along);
	for (const MovingBody &body : pushing) {
		if (push_plants(entry.page, body) > 0) {
			beat(page).last_push = beat(page).last_step;
		}
	}
}

} // namespace undergrowth
