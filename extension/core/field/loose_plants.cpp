#include "field/loose_plants.hpp"

#include "motion/bend_encoding.hpp"
#include "motion/gnomonic.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace undergrowth {

LoosePlants::LoosePlants(int species_index, const MotionSpecies &species, float step) :
		swinging(species_index, species, nullptr, 0, step, true), step_time(step) {
	swinging.set_modes(1);
}

void LoosePlants::reserve(int plants) {
	room = std::max(room, std::min(plants, MOST));
	swinging.reserve(room);
	places.reserve(static_cast<std::size_t>(room));
}

int LoosePlants::add(const MotionPlant &plant, int page, int index, const TipState &state, const glm::vec3 &before) {
	const int number = count();
	swinging.add(&plant, 1);
	swinging.set_state(number, state);
	swinging.bends()[2 * number] = encode_bend(before);
	places.push_back({ page, static_cast<uint16_t>(index), 0 });
	return number;
}

void LoosePlants::remove(int number) {
	swinging.remove(number);
	places[static_cast<std::size_t>(number)] = places.back();
	places.pop_back();
}

float LoosePlants::grow_older(int number, const glm::vec3 &followed) {
	Place &place = places[static_cast<std::size_t>(number)];
	place.age = static_cast<uint16_t>(std::min(place.age + 1, 0xffff));
	const float gone = (static_cast<float>(place.age) * step_time - ALONE) / GOING_BACK;
	const float share = glm::smoothstep(0.0f, 1.0f, gone); // Without a jerk at either end.
	if (share <= 0.0f) {
		return 0.0f;
	}
	const glm::vec3 own = swinging.direction(number);
	swinging.bends()[2 * number + 1] = encode_bend(glm::normalize(own + share * (followed - own)));
	return share;
}

void LoosePlants::hold(int number) {
	Place &place = places[static_cast<std::size_t>(number)];
	if (static_cast<float>(place.age) * step_time > ALONE) {
		swinging.set_state(number, shown_state(number));
	}
	place.age = 0;
}

void LoosePlants::push(int number, const TipState &state) {
	places[static_cast<std::size_t>(number)].age = 0;
	swinging.set_state(number, state);
}

TipState LoosePlants::shown_state(int number) const {
	TipState state = swinging.state(number);
	if (static_cast<float>(places[static_cast<std::size_t>(number)].age) * step_time > ALONE) {
		const Bend *pair = swinging.bends() + 2 * number;
		const glm::vec3 now = decode_bend(pair[1]);
		state = safe_state({ now, (now - decode_bend(pair[0])) / step_time });
	}
	return state;
}

} // namespace undergrowth
