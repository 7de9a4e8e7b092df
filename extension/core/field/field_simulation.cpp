#include "field/field_simulation.hpp"

#include "motion/gnomonic.hpp"
#include "stem/stem_bones.hpp"
#include "stem/stem_shape.hpp"

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
	canopy.set_height(species_count() - 1, species.canopy_height);
	return species_count() - 1;
}

void FieldSimulation::set_species(int index, const MotionSpecies &species) {
	const MotionSpecies before = std::exchange(kinds[static_cast<std::size_t>(index)], species);
	rates_changed++;
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
	if (!has_same_drag(before, species)) {
		rebuild_canopy();
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
		due_at.emplace_back();
		changed.reserve(entries.size()); // These grow within steps.
		stepping.reserve(entries.size());
	} else {
		free_pages--;
		entry.is_changed = place->is_changed;
		*place = std::move(entry);
	}
	rates_changed++;
	beat(number) = Beat();
	beat(number).interval = options.update_interval;
	beat(number).phase = number;
	set_due(number);
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
	add_to_canopy(entry.page, entry.page.size() - count, entry.page.size(), 1.0f);
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
	add_to_canopy(entry.page, index, index + 1, -1.0f);
	entry.page.drop(index);
}

void FieldSimulation::set_plant(int page, int index, const MotionPlant &plant) {
	MotionPage &own = at(page).page;
	add_to_canopy(own, index, index + 1, -1.0f);
	own.set_plant(index, plant);
	add_to_canopy(own, index, index + 1, 1.0f);
}

void FieldSimulation::remove_page(int page) {
	Entry &entry = at(page);
	for (std::size_t i = 0; i < entry.followers.size(); i++) {
		follow_again(entry, static_cast<int>(i));
	}
	entry.followers = {};
	add_to_canopy(entry.page, 0, entry.page.size(), -1.0f);
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
	for (int page = 0; page < page_count(); page++) {
		set_due(page);
	}
}

void FieldSimulation::set_page_multiple(int page, int multiple) {
	const int wanted = std::clamp(multiple, 1, MAX_MULTIPLE);
	if (std::exchange(beat(page).multiple, wanted) != wanted) {
		set_due(page);
	}
}

void FieldSimulation::set_page_phase(int page, int phase) {
	beat(page).phase = phase;
	set_due(page);
}

int FieldSimulation::page_interval(int page) const {
	return std::min(options.update_interval * beat(page).multiple, LONGEST_INTERVAL);
}

/// Call it after each change of what page_interval() and a page's next step depend on.
void FieldSimulation::set_due(int page) {
	const int interval = page_interval(page);
	// A page with a shorter interval first finishes the time of its last step, so that no pose jumps.
	const Beat &own = beat(page);
	const int64_t first = own.last_step < 0 ? next_step : std::max(next_step, own.last_step + own.interval);
	const int64_t to_phase = (own.phase - first) % interval;
	due_at[static_cast<std::size_t>(page)] = first + (to_phase < 0 ? to_phase + interval : to_phase);
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
	shelter_prototypes();
	for (int64_t number = next_step == 0 ? -Prototypes::SLOTS : 0; number < 0; number++) {
		step_prototypes(number);
	}
	step_prototypes(next_step);
	begin_pages();
	next_step++;
	delays.step();
	step_detached();
}

void FieldSimulation::begin_pages() {
	stepping.clear();
	for (int page = 0; page < page_count() && models.empty(); page++) { // Followers have no steps of their own.
		if (!is_due(page)) {
			continue;
		}
		choose_modes(page);
		if (blowing.wind.kind == WindKind::air) {
			at(page).page.make_room_ahead();
		}
		make_room_for_lasting_bends(at(page).page, pushing);
		Beat &own = beat(page);
		rates_changed += own.interval != page_interval(page) ? 1 : 0;
		own.interval = page_interval(page);
		own.last_step = next_step;
		set_due(page);
		stepping.push_back(page);
	}
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
	shelter_page(page);
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

namespace {

bool contains(const MotionPage &page, const glm::vec3 &point, float margin) {
	return point.x >= page.low().x - margin && point.x <= page.high().x + margin && point.y >= page.low().y - margin &&
			point.y <= page.high().y + margin && point.z >= page.low().z - margin && point.z <= page.high().z + margin;
}

} // namespace

int FieldSimulation::plant_count() const {
	int plants = 0;
	for (const Entry &entry : entries) {
		plants += entry.page.live_count();
	}
	return plants;
}

int FieldSimulation::simulated_count() const {
	if (models.empty()) {
		return plant_count();
	}
	int plants = static_cast<int>(models.size()) * options.prototypes;
	for (const DetachedFollowers &some : detached) {
		plants += some.count();
	}
	return plants;
}

int FieldSimulation::due_count() const {
	// The first step simulates the earlier motion of prototypes.
	const int rounds = next_step == 0 ? Prototypes::SLOTS + 1 : 1;
	int due = 0;
	for (const Prototypes &model : models) {
		due += rounds * model.count();
	}
	for (const DetachedFollowers &some : detached) {
		due += some.count();
	}
	for (int page = 0; page < page_count() && models.empty(); page++) {
		due += due_count(page);
	}
	return due;
}

int FieldSimulation::due_count(int page) const {
	return is_due(page) && at(page).page.swings() ? at(page).page.live_count() : 0;
}

float FieldSimulation::alpha(int page, float fraction) const {
	const Beat &own = beat(page);
	const float steps = static_cast<float>(next_step - 1 - own.last_step) + fraction;
	return std::clamp(steps / static_cast<float>(own.interval), 0.0f, 1.0f);
}

bool FieldSimulation::shows_seconds(const Entry &entry) const {
	return entry.page.swings() ? entry.page.has_second_bends()
							   : models[static_cast<std::size_t>(entry.page.species())].modes() == 2;
}

BendWay FieldSimulation::mode_way(int mode, int page, int index, float fraction) const {
	const Entry &entry = at(page);
	const MotionPage *swinging = &entry.page;
	int row = index;
	float share = fraction;
	if (entry.page.swings()) {
		share = alpha(page, fraction);
	} else {
		row = entry.followers[static_cast<std::size_t>(index)].detached - 1;
		if (row < 0) {
			return followed_way(mode, entry, index, fraction);
		}
		swinging = &detached[static_cast<std::size_t>(entry.page.species())].page();
	}
	return bend_way((mode == 0 ? swinging->bends() : swinging->second_bends()) + 2 * row, share);
}

ModeBends FieldSimulation::shown_modes(int page, int index, float fraction) const {
	const bool has_second = shows_seconds(at(page));
	return { mode_way(0, page, index, fraction).bend,
		has_second ? mode_way(1, page, index, fraction).bend : glm::vec2(0.0f) };
}

BendWay FieldSimulation::shown_way(int page, int index, float fraction) const {
	BendWay way = mode_way(0, page, index, fraction);
	if (shows_seconds(at(page))) { // The tip's bend combines both modes.
		const BendWay second = mode_way(1, page, index, fraction);
		const glm::vec2 calm = rest_bend(page, index);
		way.bend = out_of_rest(into_rest(way.bend, calm) + second.bend, calm);
		way.change += second.change;
	}
	return way;
}

StemMotion FieldSimulation::shown_stem(int page, int index, float fraction) const {
	const BendWay way = shown_way(page, index, fraction);
	StemMotion stem;
	stem.bend = way.bend;
	stem.rate = way.change / rate_time(page);
	stem.rest = rest_bend(page, index);
	const MotionPage &plants = at(page).page;
	if (shows_seconds(at(page))) {
		stem.second = mode_way(1, page, index, fraction).bend;
	} else if (plants.max_modes() == 2) {
		stem.second = (1.0f - first_share(plants.whole_stem())) * into_rest(stem.bend, stem.rest);
	}
	return stem;
}

glm::vec3 FieldSimulation::rest(int page, int index) const {
	const Entry &entry = at(page);
	return entry.page.swings() ? entry.page.rest(index)
							   : models[static_cast<std::size_t>(entry.page.species())].rest(
										 entry.followers[static_cast<std::size_t>(index)].prototype);
}

glm::vec2 FieldSimulation::rest_bend(int page, int index) const {
	return stereographic(encode_bend(rest(page, index)));
}

MotionState FieldSimulation::motion(int page, int index) const {
	const Entry &entry = at(page);
	if (entry.page.swings()) {
		return { entry.page.state(index), entry.page.second(index) };
	}
	const auto species = static_cast<std::size_t>(entry.page.species());
	const Follower &shown = entry.followers[static_cast<std::size_t>(index)];
	if (shown.detached > 0) {
		return detached[species].shown_state(shown.detached - 1);
	}
	if (shows_seconds(entry)) {
		return motion_between(models[species].stem_constants(), shown_modes(page, index, 0.0f),
				shown_modes(page, index, 1.0f), rest_bend(page, index), options.step);
	}
	const glm::vec3 now = shown_direction(page, index, 1.0f);
	return { safe_state({ now, (now - shown_direction(page, index, 0.0f)) / options.step }), {} };
}

void FieldSimulation::apply_impulse(int page, int index, const glm::vec3 &impulse) {
	MotionPage &plants = at(page).page;
	if (plants.is_gone(index)) {
		return;
	}
	if (plants.swings()) {
		wake(page);
		plants.apply_impulse(index, impulse);
		return;
	}
	MotionState pushed = motion(page, index);
	if (plants.law() == Law::stem) {
		const StemConstants &stem = models[static_cast<std::size_t>(plants.species())].stem_constants();
		const glm::vec2 calm = rest_bend(page, index);
		StemState state = stem_state(stem, pushed.tip, calm, pushed.second);
		apply_stem_impulse(stem, state, 1.0f, turned(impulse, -calm), stem.length / plants.length(index));
		pushed = { tip_state(stem, state, calm), second_of(stem, state, calm) };
	} else {
		pushed.tip.rate += impulse / (plants.mass() * plants.length(index));
	}
	push_follower(at(page), index, pushed);
}

/// Chooses the number of stepped modes from now on, the same for a whole page. For a page that is due: a change between
/// its steps would move both drawn ends of the last one.
void FieldSimulation::choose_modes(int page) {
	MotionPage &plants = at(page).page;
	if (plants.max_modes() < 2) {
		return;
	}
	Beat &own = beat(page);
	own.last_push = plants.take_moved() ? next_step : own.last_push;
	own.last_near = own.is_near ? next_step : own.last_near;
	const int64_t alone = next_step - std::max(own.last_push, own.last_near);
	if (alone <= steps_in(DetachedFollowers::ALONE)) {
		show_modes(page, 2);
	} else if (alone > steps_in(DetachedFollowers::ALONE + DetachedFollowers::GOING_BACK)) {
		show_modes(page, 1);
	}
}

/// Share of a second mode that the page's step removes, so that nothing of it remains when its stems change to one
/// mode.
float FieldSimulation::ease_of(int page) const {
	const Beat &own = beat(page);
	const auto back = static_cast<float>(steps_in(DetachedFollowers::GOING_BACK));
	const int64_t alone = own.last_step - std::max(own.last_push, own.last_near) - steps_in(DetachedFollowers::ALONE);
	const float leaving = static_cast<float>(alone + own.interval - 1) / back;
	const float here = static_cast<float>(own.last_step - own.two_since) / back;
	const float coming = own.last_push < own.two_since ? 1.0f - here : 0.0f;
	return std::clamp(std::max(leaving, coming), 0.0f, 1.0f);
}

void FieldSimulation::show_modes(int page, int count) {
	if (at(page).page.modes() != count && at(page).page.max_modes() >= count) {
		at(page).page.set_modes(count);
		rates_changed++;
		beat(page).two_since = next_step;
		follower_changed(at(page));
	}
}

/// Call before a plant of the page is pushed between two steps.
void FieldSimulation::wake(int page) {
	if (at(page).page.swings() && at(page).page.max_modes() == 2) {
		beat(page).last_push = next_step;
		show_modes(page, 2);
	}
}

void FieldSimulation::set_state(int page, int index, const TipState &state, const StemSecond &second) {
	if (second.bend != glm::vec3(0.0f) || second.rate != glm::vec3(0.0f)) {
		wake(page);
	}
	at(page).page.set_state(index, state, second);
}

const Prototypes *FieldSimulation::prototypes(int species) const {
	return models.empty() ? nullptr : &models[static_cast<std::size_t>(species)];
}

const DetachedFollowers *FieldSimulation::detached_followers(int species) const {
	return detached.empty() ? nullptr : &detached[static_cast<std::size_t>(species)];
}

glm::vec3 FieldSimulation::shown_point(int page, int index, float share, float fraction) const {
	const MotionPage &plants = at(page).page;
	const float reach = plants.length(index);
	if (plants.law() != Law::stem) {
		return plants.root(index) + share * reach * shown_direction(page, index, fraction);
	}
	const StemConstants &stem = plants.whole_stem();
	const StemMotion now = shown_stem(page, index, fraction);
	return plants.root(index) + PosedStem(stem, reach, now).place_of({ 0.0f, share * reach, 0.0f }, share);
}

/// On the plant's straight line, or on the lines between the joints of its stem.
glm::vec3 FieldSimulation::nearest_on_plant(int page, int index, const glm::vec3 &point) const {
	const MotionPage &plants = at(page).page;
	const int parts = plants.law() == Law::stem ? plants.stem_constants().joints : 1;
	glm::vec3 from = plants.root(index);
	glm::vec3 nearest = from;
	for (int part = 1; part <= parts; part++) {
		const glm::vec3 to = shown_point(page, index, static_cast<float>(part) / static_cast<float>(parts), 1.0f);
		const glm::vec3 here = nearest_on_segment(from, to, point);
		nearest = glm::distance(here, point) < glm::distance(nearest, point) ? here : nearest;
		from = to;
	}
	return nearest;
}

bool FieldSimulation::is_point_in_plants(const glm::vec3 &point, float margin) const {
	for (int page = 0; page < page_count(); page++) {
		const Entry &entry = at(page);
		if (!contains(entry.page, point, margin)) {
			continue;
		}
		const float *x = entry.page.roots_x();
		const float *z = entry.page.roots_z();
		const float radius = entry.page.collision_radius() + margin;
		for (int i = 0; i < entry.page.size(); i++) {
			const float reach = entry.page.length(i) + radius;
			if (entry.page.is_gone(i) || std::fabs(x[i] - point.x) > reach || std::fabs(z[i] - point.z) > reach) {
				continue;
			}
			if (glm::distance(nearest_on_plant(page, i, point), point) <= radius) {
				return true;
			}
		}
	}
	return false;
}

double FieldSimulation::bytes_per_plant() const {
	const int plants = plant_count();
	std::size_t bytes = entries.capacity() * sizeof(Entry) + beats.capacity() * sizeof(Beat) +
			due_at.capacity() * sizeof(int64_t) + stepping.capacity() * sizeof(int) + canopy.bytes();
	for (const Entry &entry : entries) {
		bytes += entry.page.bytes() - sizeof(MotionPage) + entry.followers.capacity() * sizeof(Follower);
	}
	for (const Prototypes &model : models) {
		bytes += model.bytes();
	}
	for (const DetachedFollowers &some : detached) {
		bytes += some.bytes();
	}
	return plants > 0 ? static_cast<double>(bytes) / plants : 0.0;
}

} // namespace undergrowth
