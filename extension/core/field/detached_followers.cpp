#include "field/detached_followers.hpp"

#include "motion/bend_encoding.hpp"
#include "motion/gnomonic.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace undergrowth {

DetachedFollowers::DetachedFollowers(int species_index, const MotionSpecies &species, float step) :
		swinging(species_index, species, nullptr, 0, step, true), step_time(step) {}

void DetachedFollowers::reserve(int plants) {
	room = std::max(room, std::min(plants, MAX_COUNT));
	swinging.reserve(room);
	places.reserve(static_cast<std::size_t>(room));
}

int DetachedFollowers::add(
		const MotionPlant &plant, int page, int index, const MotionState &state, const ModeBends &before) {
	const int number = count();
	swinging.add(&plant, 1);
	swinging.set_state(number, state.tip, state.second);
	swinging.bends()[2 * number] = pack_bend(before.first);
	if (swinging.has_second_bends()) {
		swinging.second_bends()[2 * number] = pack_bend(before.second);
	}
	places.push_back({ page, static_cast<uint16_t>(index), 0 });
	return number;
}

void DetachedFollowers::remove(int number) {
	swinging.remove(number);
	places[static_cast<std::size_t>(number)] = places.back();
	places.pop_back();
}

float DetachedFollowers::grow_older(int number, const ModeBends &followed) {
	Place &place = places[static_cast<std::size_t>(number)];
	place.age = static_cast<uint16_t>(std::min(place.age + 1, 0xffff));
	const float gone = (static_cast<float>(place.age) * step_time - ALONE) / GOING_BACK;
	const float share = glm::smoothstep(0.0f, 1.0f, gone); // Without a jerk at either end.
	if (share <= 0.0f) {
		return 0.0f;
	}
	const auto go_over = [share](Bend &shown, const glm::vec2 &to) {
		shown = pack_bend(glm::mix(stereographic(shown), to, share));
	};
	go_over(swinging.bends()[2 * number + 1], followed.first);
	if (swinging.has_second_bends()) {
		go_over(swinging.second_bends()[2 * number + 1], followed.second);
	}
	return share;
}

void DetachedFollowers::hold(int number) {
	Place &place = places[static_cast<std::size_t>(number)];
	if (static_cast<float>(place.age) * step_time > ALONE) {
		const MotionState shown = shown_state(number);
		swinging.set_state(number, shown.tip, shown.second);
	}
	place.age = 0;
}

void DetachedFollowers::push(int number, const MotionState &state) {
	places[static_cast<std::size_t>(number)].age = 0;
	swinging.set_state(number, state.tip, state.second);
}

MotionState DetachedFollowers::shown_state(int number) const {
	if (static_cast<float>(places[static_cast<std::size_t>(number)].age) * step_time <= ALONE) {
		return { swinging.state(number), swinging.second(number) };
	}
	const Bend *pair = swinging.bends() + 2 * number;
	if (swinging.has_second_bends()) {
		const Bend *second = swinging.second_bends() + 2 * number;
		const ModeBends before = { stereographic(pair[0]), stereographic(second[0]) };
		const ModeBends now = { stereographic(pair[1]), stereographic(second[1]) };
		return motion_between(swinging.stem_constants(), before, now, swinging.rest_bend(number), step_time);
	}
	const glm::vec3 now = decode_bend(pair[1]);
	return { safe_state({ now, (now - decode_bend(pair[0])) / step_time }), {} };
}

} // namespace undergrowth
