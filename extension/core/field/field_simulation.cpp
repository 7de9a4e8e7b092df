#include "field/field_simulation.hpp"

#include "base/random.hpp"
#include "pendulum/gnomonic.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

namespace undergrowth {

namespace {

constexpr int MAX_INTERVAL = 64;
constexpr int MAX_MULTIPLE = 8;
constexpr int FOLLOWER_BLOCK = 256;
constexpr float MOST_STEPS = 1e9f; // Of a delay.
constexpr float USUAL_STEP = 1.0f / 60.0f; // s.

FieldSettings safe_settings(const FieldSettings &settings) {
	FieldSettings safe = settings;
	safe.step = std::isfinite(settings.step) && settings.step > 0.0f ? settings.step : USUAL_STEP;
	safe.update_interval = std::clamp(settings.update_interval, 1, MAX_INTERVAL);
	safe.prototypes = std::clamp(settings.prototypes, 0, Prototypes::MOST);
	return safe;
}

/// By the place, so that it does not depend on the order in which plants came.
uint64_t place_hash(uint64_t seed, const glm::vec3 &root) {
	uint32_t place[2];
	std::memcpy(&place[0], &root.x, sizeof place[0]);
	std::memcpy(&place[1], &root.z, sizeof place[1]);
	return mix_bits(mix_bits(seed ^ place[0]) ^ place[1]);
}

bool contains(const FieldPage &page, const glm::vec3 &point, float margin) {
	return point.x >= page.low().x - margin && point.x <= page.high().x + margin && point.y >= page.low().y - margin &&
			point.y <= page.high().y + margin && point.z >= page.low().z - margin && point.z <= page.high().z + margin;
}

bool are_valid(const FieldPlant *plants, int count) {
	return std::all_of(plants, plants + count, [](const FieldPlant &plant) { return is_valid(plant); });
}

} // namespace

FieldSimulation::FieldSimulation(const FieldSettings &settings) : options(safe_settings(settings)) {
	along = winds_along(blowing);
}

int FieldSimulation::add_species(const FieldSpecies &species) {
	kinds.push_back(species);
	if (options.prototypes > 0) {
		models.emplace_back(species_count() - 1, species, options.prototypes, options.step);
	}
	return species_count() - 1;
}

void FieldSimulation::set_species(int index, const FieldSpecies &species) {
	kinds[static_cast<std::size_t>(index)] = species;
	for (Entry &entry : entries) {
		if (entry.page.species() == index) {
			entry.page.set_species(species);
		}
	}
	if (!models.empty()) {
		models[static_cast<std::size_t>(index)].set_species(species);
	}
}

int FieldSimulation::add_page(int species, const FieldPlant *plants, int count) {
	if (species < 0 || species >= species_count() || count < 0 || count > FieldPage::PAGE_PLANTS) {
		return -1;
	}
	if (!are_valid(plants, count)) {
		return -1;
	}
	const FieldSpecies &kind = kinds[static_cast<std::size_t>(species)];
	const float step_length = options.step * static_cast<float>(options.update_interval);
	entries.push_back({ FieldPage(species, kind, plants, count, step_length, models.empty()), {}, 1, 1, -1 });
	entries.back().interval = options.update_interval;
	take_in(entries.back(), plants, count);
	return page_count() - 1;
}

bool FieldSimulation::add_to_page(int page, const FieldPlant *plants, int count) {
	if (count < 0 || at(page).page.size() + count > FieldPage::PAGE_PLANTS || !are_valid(plants, count)) {
		return false;
	}
	at(page).page.add(plants, count);
	take_in(at(page), plants, count);
	return true;
}

/// What plants that a page has just got mean for the field: its box, and whom they follow.
void FieldSimulation::take_in(Entry &entry, const FieldPlant *plants, int count) {
	const bool first = page_count() == 1;
	box_low = first ? entry.page.low() : glm::min(box_low, entry.page.low());
	box_high = first ? entry.page.high() : glm::max(box_high, entry.page.high());
	update_lead();
	if (models.empty()) {
		return;
	}
	const Prototypes &model = models[static_cast<std::size_t>(entry.page.species())];
	entry.followers.reserve(entry.followers.size() + static_cast<std::size_t>(count));
	const TravellingWind now = wind_at_time(blowing, time());
	for (int i = 0; i < count; i++) {
		Follower follower = model.pick(plants[i], place_hash(options.seed, plants[i].root));
		follower.delay = static_cast<uint16_t>(wanted_delay(follower, plants[i].root.x, plants[i].root.z, now));
		entry.followers.push_back(follower);
	}
}

void FieldSimulation::remove(int page, int index) {
	Entry &entry = at(page);
	entry.page.remove(index);
	if (!entry.followers.empty()) {
		entry.followers[static_cast<std::size_t>(index)] = entry.followers.back();
		entry.followers.pop_back();
	}
}

void FieldSimulation::clear() {
	entries.clear();
}

int FieldSimulation::plant_count() const {
	int plants = 0;
	for (const Entry &entry : entries) {
		plants += entry.page.size();
	}
	return plants;
}

int FieldSimulation::simulated_count() const {
	if (models.empty()) {
		return plant_count();
	}
	return static_cast<int>(models.size()) * options.prototypes;
}

void FieldSimulation::set_wind(const FieldWind &wind) {
	blowing = wind;
	along = winds_along(wind);
	update_lead();
}

void FieldSimulation::set_update_interval(int steps) {
	options.update_interval = std::clamp(steps, 1, MAX_INTERVAL);
}

void FieldSimulation::set_page_multiple(int page, int multiple) {
	at(page).multiple = std::clamp(multiple, 1, MAX_MULTIPLE);
}

int FieldSimulation::page_interval(int page) const {
	return options.update_interval * at(page).multiple;
}

bool FieldSimulation::is_due(int page, int64_t number) const {
	const int interval = page_interval(page);
	return number % interval == page % interval;
}

void FieldSimulation::set_bodies(const FieldBody *bodies, int count) {
	pushing.clear();
	std::copy_if(
			bodies, bodies + count, std::back_inserter(pushing), [](const FieldBody &body) { return is_valid(body); });
}

void FieldSimulation::step_prototypes(int64_t number) {
	for (Prototypes &model : models) {
		const double moment = static_cast<double>(number) + model.wind_moment();
		const double moment_time = moment * static_cast<double>(options.step) + static_cast<double>(lead);
		model.step(wind_at_time(blowing, moment_time), along);
	}
}

void FieldSimulation::begin_step() {
	for (int64_t number = next_step == 0 ? -Prototypes::SLOTS : 0; number < 0; number++) {
		step_prototypes(number);
	}
	step_prototypes(next_step);
	next_step++;
}

int FieldSimulation::due_count() const {
	// The first step simulates what prototypes did before it.
	const int rounds = next_step == 0 ? Prototypes::SLOTS + 1 : 1;
	int due = 0;
	for (const Prototypes &model : models) {
		due += rounds * model.count();
	}
	for (int page = 0; page < page_count(); page++) {
		const bool steps = at(page).page.swings() || options.write_followers;
		due += steps && is_due(page, next_step) ? at(page).page.size() : 0;
	}
	return due;
}

void FieldSimulation::step_pages(int begin, int end) {
	for (int page = std::max(begin, 0); page < std::min(end, page_count()); page++) {
		if (is_due(page, next_step - 1)) {
			step_page(at(page), page_interval(page));
		}
	}
}

void FieldSimulation::step() {
	begin_step();
	step_pages(0, page_count());
}

void FieldSimulation::step_page(Entry &entry, int interval) {
	entry.last_step = next_step - 1;
	entry.interval = interval;
	if (!entry.page.swings()) {
		if (options.write_followers) {
			show_followers(entry, std::max(interval / 2, 1));
		}
		return;
	}
	const float step_length = options.step * static_cast<float>(interval);
	if (entry.page.step_length() != step_length) {
		entry.page.set_step_length(step_length);
	}
	const double moment = static_cast<double>(entry.last_step) + entry.page.wind_moment() * interval;
	entry.page.step(wind_at_time(blowing, moment * static_cast<double>(options.step)), along);
	for (const FieldBody &body : pushing) {
		push_plants(entry.page, body);
	}
}

int FieldSimulation::wanted_delay(const Follower &follower, float x, float z, const TravellingWind &wind) const {
	const float late = (lead + (wind.delay_x * x + wind.delay_z * z)) * (1.0f / options.step);
	const int steps = static_cast<int>(std::min(std::max(late, 0.0f), MOST_STEPS)) + follower.own_delay;
	return static_cast<int>(static_cast<uint32_t>(steps) % Prototypes::LONGEST_DELAY);
}

void FieldSimulation::show_followers(Entry &entry, int most_change) {
	const Prototypes &model = models[static_cast<std::size_t>(entry.page.species())];
	const TravellingWind wind = wind_at_time(blowing, 0.0); // For the delays, which are the same at all times.
	const float *__restrict x = entry.page.roots_x();
	const float *__restrict z = entry.page.roots_z();
	Follower *followers = entry.followers.data();
	Bend *pairs = entry.page.bends();
	int wanted[FOLLOWER_BLOCK];
	for (int begin = 0; begin < entry.page.size(); begin += FOLLOWER_BLOCK) {
		const int count = std::min(FOLLOWER_BLOCK, entry.page.size() - begin);
		for (int i = 0; i < count; i++) {
			wanted[i] = wanted_delay(followers[begin + i], x[begin + i], z[begin + i], wind);
		}
		for (int i = 0; i < count; i++) {
			Follower &follower = followers[begin + i];
			const int change = wanted[i] - follower.delay;
			follower.delay = static_cast<uint16_t>(follower.delay + std::clamp(change, -most_change, most_change));
			Bend *pair = pairs + 2 * (begin + i);
			pair[0] = pair[1];
			pair[1] = model.bend(follower.prototype, follower.delay);
		}
	}
}

void FieldSimulation::update_lead() {
	const TravellingWind wind = wind_at_time(blowing, 0.0);
	const float x = wind.delay_x > 0.0f ? box_low.x : box_high.x;
	const float z = wind.delay_z > 0.0f ? box_low.z : box_high.z;
	lead = std::max(-(wind.delay_x * x + wind.delay_z * z), 0.0f);
}

float FieldSimulation::alpha(int page, float fraction) const {
	const Entry &entry = at(page);
	const float steps = static_cast<float>(next_step - 1 - entry.last_step) + fraction;
	return std::clamp(steps / static_cast<float>(entry.interval), 0.0f, 1.0f);
}

TipState FieldSimulation::state(int page, int index) const {
	const Entry &entry = at(page);
	if (entry.page.swings()) {
		return entry.page.state(index);
	}
	const Prototypes &model = models[static_cast<std::size_t>(entry.page.species())];
	const Follower &shown = entry.followers[static_cast<std::size_t>(index)];
	const glm::vec3 now = decode_bend(model.bend(shown.prototype, shown.delay));
	const glm::vec3 before = decode_bend(model.bend(shown.prototype, shown.delay + 1));
	return safe_state({ now, (now - before) / options.step });
}

void FieldSimulation::apply_impulse(int page, int index, const glm::vec3 &impulse) {
	FieldPage &plants = at(page).page;
	if (!plants.swings()) {
		return;
	}
	TipState state = plants.state(index);
	state.rate += impulse / (plants.mass() * plants.length(index));
	plants.set_state(index, state);
}

const Prototypes *FieldSimulation::prototypes(int species) const {
	return models.empty() ? nullptr : &models[static_cast<std::size_t>(species)];
}

bool FieldSimulation::is_point_in_plants(const glm::vec3 &point, float margin) const {
	for (const Entry &entry : entries) {
		if (!contains(entry.page, point, margin)) {
			continue;
		}
		const float *x = entry.page.roots_x();
		const float *z = entry.page.roots_z();
		const float radius = entry.page.collision_radius() + margin;
		for (int i = 0; i < entry.page.size(); i++) {
			const float reach = entry.page.length(i) + radius;
			if (std::fabs(x[i] - point.x) > reach || std::fabs(z[i] - point.z) > reach) {
				continue;
			}
			const glm::vec3 nearest = nearest_on_segment(entry.page.root(i), entry.page.tip(i), point);
			if (glm::distance(nearest, point) <= radius) {
				return true;
			}
		}
	}
	return false;
}

double FieldSimulation::bytes_per_plant() const {
	const int plants = plant_count();
	std::size_t bytes = entries.capacity() * sizeof(Entry);
	for (const Entry &entry : entries) {
		bytes += entry.page.bytes() - sizeof(FieldPage) + entry.followers.capacity() * sizeof(Follower);
	}
	for (const Prototypes &model : models) {
		bytes += model.bytes();
	}
	return plants > 0 ? static_cast<double>(bytes) / plants : 0.0;
}

} // namespace undergrowth
