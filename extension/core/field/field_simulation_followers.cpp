// FieldSimulation: plants that follow prototypes, and followers that were pushed or stirred.

#include "field/field_simulation.hpp"

#include "base/random.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace undergrowth {

/// Steps in which all pages are checked once for plants that sources stir.
static constexpr int STIR_TURNS = 3;

/// The prototypes' lead and the delays, for the wind and the box of all plants.
void FieldSimulation::update_delays() {
	const WindSnapshot wind = wind_at_time(blowing, 0.0); // Its delays are the same at all times.
	const float x = wind.delay_x > 0.0f ? box_low.x : box_high.x;
	const float z = wind.delay_z > 0.0f ? box_low.z : box_high.z;
	lead = std::max(-(wind.delay_x * x + wind.delay_z * z), 0.0f);
	const DelayPlane plane = { wind.delay_x / options.step, wind.delay_z / options.step, lead / options.step };
	if (next_step == 0) {
		delays.set(plane);
	} else {
		delays.want(plane);
	}
}

void FieldSimulation::set_rests(int page, int first, const glm::vec3 *rests, int count) {
	Entry &entry = at(page);
	if (entry.page.swings()) {
		entry.page.set_rests(first, rests, count);
		return;
	}
	for (int i = first; i < first + count; i++) {
		Follower &follower = entry.followers[static_cast<std::size_t>(i)];
		const uint16_t number = follower.detached;
		follower = pick({ entry.page.root(i), entry.page.length(i), rests[i - first] }, entry.page.species());
		follower.detached = number;
	}
	follower_changed(entry);
}

/// Prototype of a plant: by its position, so that it does not depend on the order of plants.
Follower FieldSimulation::pick(const MotionPlant &plant, int species) const {
	const uint64_t hash = bits_of_place(options.seed, plant.root.x, plant.root.z);
	return models[static_cast<std::size_t>(species)].pick(plant, hash);
}

void FieldSimulation::follower_changed(Entry &entry) {
	if (!entry.is_changed) {
		entry.is_changed = true;
		changed.push_back(number_of(entry));
	}
}

void FieldSimulation::forget_changed_pages() {
	for (const int page : changed) {
		at(page).is_changed = false;
	}
	changed.clear();
}

DetachedFollowers &FieldSimulation::detached_of(const Entry &entry) {
	return detached[static_cast<std::size_t>(entry.page.species())];
}

int FieldSimulation::count_of_species(int species) const {
	int plants = 0;
	for (const Entry &entry : entries) {
		plants += entry.page.species() == species ? entry.page.live_count() : 0;
	}
	return plants;
}

/// Bend that a plant shows in a mode that does not swing by itself.
BendWay FieldSimulation::followed_way(int mode, const Entry &entry, int index, float fraction) const {
	const Follower &follower = entry.followers[static_cast<std::size_t>(index)];
	const Prototypes &model = models[static_cast<std::size_t>(entry.page.species())];
	const glm::vec3 root = entry.page.root(index);
	const auto own = static_cast<float>(follower.own_delay);
	const BendWay after = model.way(mode, follower.prototype, own + delays.after().at(root.x, root.z), fraction);
	const float share = delays.share(fraction);
	if (share >= 1.0f) {
		return after;
	}
	const BendWay before = model.way(mode, follower.prototype, own + delays.before().at(root.x, root.z), fraction);
	return { glm::mix(before.bend, after.bend, share), glm::mix(before.change, after.change, share) };
}

/// Bends that the plant would show now if it did not swing by itself.
ModeBends FieldSimulation::followed_modes(const Entry &entry, int index) const {
	ModeBends bends = { followed_way(0, entry, index, 1.0f).bend, {} };
	if (shows_seconds(entry)) {
		bends.second = followed_way(1, entry, index, 1.0f).bend;
	}
	return bends;
}

void FieldSimulation::transfer_motion(int page, int index, const FieldSimulation &from, int from_page, int from_index) {
	Entry &entry = at(page);
	const Entry &before = from.at(from_page);
	if (before.page.modes() == 2) {
		wake(page);
	}
	entry.page.transfer_motion(index, before.page, from_index);
	const bool follows = !entry.page.swings() && !before.page.swings();
	if (follows && before.followers[static_cast<std::size_t>(from_index)].detached > 0) {
		push_follower(entry, index, from.motion(from_page, from_index));
	}
}

/// Makes a follower swing by itself; if there are too many, it remains a follower.
void FieldSimulation::push_follower(Entry &entry, int index, const MotionState &state) {
	DetachedFollowers &some = detached_of(entry);
	Follower &follower = entry.followers[static_cast<std::size_t>(index)];
	if (follower.detached > 0) {
		some.push(follower.detached - 1, state);
		return;
	}
	if (some.is_full()) {
		return;
	}
	MotionPlant plant;
	plant.root = entry.page.root(index);
	plant.length = entry.page.length(index);
	const Prototypes &prototypes = models[static_cast<std::size_t>(entry.page.species())];
	plant.rest = prototypes.rest(follower.prototype);
	plant.scale = prototypes.scale_of(plant.length);
	plant.own = own_of_root(plant.root);
	const int page = number_of(entry);
	const int number = some.add(plant, page, index, state, shown_modes(page, index, 0.0f));
	follower.detached = static_cast<uint16_t>(number + 1);
	follower_changed(entry);
}

void FieldSimulation::follow_again(Entry &entry, int index) {
	Follower &follower = entry.followers[static_cast<std::size_t>(index)];
	if (follower.detached == 0) {
		return;
	}
	DetachedFollowers &some = detached_of(entry);
	const int number = follower.detached - 1;
	some.remove(number);
	follower.detached = 0;
	follower_changed(entry);
	if (number < some.count()) {
		Entry &moved = at(some.page_of(number));
		moved.followers[static_cast<std::size_t>(some.index_of(number))].detached = static_cast<uint16_t>(number + 1);
		follower_changed(moved);
	}
}

/// Detached followers step before bodies detach more of them, so each new one begins with the bend that it showed.
void FieldSimulation::step_detached() {
	for (DetachedFollowers &some : detached) {
		if (some.count() == 0) {
			continue;
		}
		const double moment = static_cast<double>(next_step - 1) + some.page().wind_moment();
		WindSnapshot now = wind_at_time(blowing, along, moment * static_cast<double>(options.step));
		now.sources = { stirring.data(), static_cast<int>(stirring.size()) };
		now.drift = &drift;
		some.step(now, along);
		for (int number = some.count() - 1; number >= 0; number--) {
			Entry &entry = at(some.page_of(number));
			const int index = some.index_of(number);
			const ModeBends followed = some.goes_back(number) ? followed_modes(entry, index) : ModeBends();
			if (some.grow_older(number, followed) >= 1.0f) {
				follow_again(entry, index);
			}
		}
	}
	for (const MovingBody &body : pushing) {
		for (int page = 0; page < page_count() && !models.empty(); page++) {
			push_followers(page, body);
		}
	}
	stir_followers();
}

/// Visits every `stride`th page from `first` on. Calls visit(entry, index, speed) for each follower where sources add
/// at least SpeedHistogram::MIN_SPEED to the wind.
template <class Visit> void FieldSimulation::for_each_stirred(int first, int stride, const Visit &visit) {
	for (int number = first; number < page_count(); number += stride) {
		Entry &entry = at(number);
		const MotionPage &page = entry.page;
		const auto is_near = [&](const AirSource &source) { return reaches(source, page.low(), page.high()); };
		if (!std::any_of(stirring.begin(), stirring.end(), is_near)) {
			continue;
		}
		for (int i = 0; i < page.size(); i++) {
			const glm::vec3 root = page.root(i);
			glm::vec2 sum(0.0f);
			for (const AirSource &source : stirring) {
				const glm::vec3 added = velocity_at(source, root, page.length(i));
				sum += glm::vec2(added.x, added.z);
			}
			const float speed = glm::length(sum);
			if (speed >= SpeedHistogram::MIN_SPEED && !page.is_gone(i)) {
				visit(entry, i, speed);
			}
		}
	}
}

void FieldSimulation::choose_stirred() {
	for (SpeedHistogram &counts : stirred) {
		counts.choose(DetachedFollowers::MAX_COUNT);
		counts.clear();
	}
}

/// Makes the followers with the strongest source wind swing by themselves. Each step checks some of the pages. The
/// counts of the last round determine the threshold.
void FieldSimulation::stir_followers() {
	if (stirring.empty() || models.empty()) {
		stir_turn = -1;
		return;
	}
	const auto counts_of = [&](const Entry &entry) -> SpeedHistogram & {
		return stirred[static_cast<std::size_t>(entry.page.species())];
	};
	if (stir_turn < 0) {
		for_each_stirred(0, 1, [&](const Entry &entry, int, float speed) { counts_of(entry).add(speed); });
		choose_stirred();
		stir_turn = 0;
	}
	for_each_stirred(stir_turn, STIR_TURNS, [&](Entry &entry, int index, float speed) {
		counts_of(entry).add(speed);
		const uint16_t own = entry.followers[static_cast<std::size_t>(index)].detached;
		if (speed < counts_of(entry).chosen()) {
			return;
		}
		if (own > 0) {
			detached_of(entry).hold(own - 1);
		} else {
			push_follower(entry, index, motion(number_of(entry), index));
		}
	});
	stir_turn = (stir_turn + 1) % STIR_TURNS;
	if (stir_turn == 0) {
		choose_stirred();
	}
}

void FieldSimulation::push_followers(int page, const MovingBody &body) {
	Entry &entry = at(page);
	const float thickness = std::max(entry.page.collision_radius(), 0.0f);
	for_each_in_reach(entry.page, body, [&](int index) {
		MotionState pushed = motion(page, index);
		if (entry.page.law() == Law::stem) {
			const StemConstants &stem = models[static_cast<std::size_t>(entry.page.species())].stem_constants();
			const glm::vec2 calm = rest_bend(page, index);
			StemState bent = stem_state(stem, pushed.tip, calm, pushed.second);
			if (push_plant(stem, bent, calm, entry.page.root(index), entry.page.length(index), thickness, body)) {
				push_follower(entry, index, { tip_state(stem, bent, calm), second_of(stem, bent, calm) });
			}
			return;
		}
		if (push_plant(pushed.tip, entry.page.root(index), entry.page.length(index), thickness, body)) {
			push_follower(entry, index, pushed);
		}
	});
}

} // namespace undergrowth
