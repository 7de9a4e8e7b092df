#include "motion/motion_page.hpp"

#include "motion/gnomonic.hpp"
#include "motion/motion_page_columns.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

using namespace motion_page_columns;

namespace {

int column_count(bool swings, bool keeps_directions) {
	if (!swings) {
		return static_cast<int>(STILL_COLUMNS);
	}
	return keeps_directions ? static_cast<int>(REMEMBERING_COLUMNS) : static_cast<int>(SWINGING_COLUMNS);
}

} // namespace

/// A state as it would be about another rest direction: as far from it in the plane that the spring law lives in.
static TipState moved_rest(const TipState &state, const glm::vec3 &from, const glm::vec3 &to) {
	if (from == to) {
		return state;
	}
	GnomonicState flat = to_gnomonic(state);
	flat.x += to.x / to.y - from.x / from.y;
	flat.z += to.z / to.y - from.z / from.y;
	return from_gnomonic(flat);
}

MotionPage::MotionPage(int species_index, const MotionSpecies &species, const MotionPlant *plants, int count,
		float step, bool swings, Keeps keeps) :
		species_number(species_index),
		is_swinging(swings),
		keeps_directions(swings && keeps == Keeps::directions),
		step_time(step),
		kind(species),
		rows(column_count(swings, keeps_directions)) {
	kind.joint = safe_joint(species.joint);
	add(plants, count);
}

void MotionPage::reserve(int plants) {
	rows.reserve(plants);
	pairs.reserve(has_bends() ? 2 * static_cast<std::size_t>(std::max(plants, 0)) : 0);
}

void MotionPage::add(const MotionPlant *plants, int count) {
	const int before = size();
	rows.reserve(before + count);
	pairs.resize(has_bends() ? 2 * static_cast<std::size_t>(before + count) : 0);
	for (int i = before; i < before + count; i++) {
		rows.add_row();
		put_place(i, plants[i - before]);
		settle(i);
	}
	if (is_swinging) {
		update_constants(before);
	}
}

void MotionPage::put_place(int index, const MotionPlant &plant) {
	column(ROOT_X)[index] = plant.root.x;
	column(ROOT_Y)[index] = plant.root.y;
	column(ROOT_Z)[index] = plant.root.z;
	column(LENGTH)[index] = plant.length;
	put_rest(index, plant.rest);
	grow_box(index, size() == 1);
}

void MotionPage::put_rest(int index, const glm::vec3 &rest) {
	if (is_swinging && kind.law == Law::spring) {
		column(REST_X)[index] = std::clamp(rest.x / rest.y, -MAX_GNOMONIC, MAX_GNOMONIC);
		column(REST_Z)[index] = std::clamp(rest.z / rest.y, -MAX_GNOMONIC, MAX_GNOMONIC);
	}
}

void MotionPage::set_plant(int index, const MotionPlant &plant) {
	put_place(index, plant);
	if (is_swinging) {
		update_constants(index, index + 1);
	}
}

void MotionPage::set_rests(int first, const glm::vec3 *rests, int count) {
	for (int i = 0; i < count; i++) {
		put_rest(first + i, rests[i]);
	}
}

glm::vec3 MotionPage::root(int index) const {
	return { column(ROOT_X)[index], column(ROOT_Y)[index], column(ROOT_Z)[index] };
}

float MotionPage::length(int index) const {
	return column(LENGTH)[index];
}

glm::vec3 MotionPage::rest(int index) const {
	if (!is_swinging || kind.law == Law::elasticity) {
		return { 0.0f, 1.0f, 0.0f };
	}
	return glm::normalize(glm::vec3(column(REST_X)[index], 1.0f, column(REST_Z)[index]));
}

glm::vec3 MotionPage::tip(int index) const {
	return root(index) + length(index) * direction(index);
}

glm::vec3 MotionPage::direction(int index) const {
	if (!is_swinging) {
		return rest(index);
	}
	if (kind.law == Law::elasticity) {
		return { column(X)[index], column(Y)[index], column(Z)[index] };
	}
	return glm::normalize(glm::vec3(column(FLAT_X)[index], 1.0f, column(FLAT_Z)[index]));
}

TipState MotionPage::state(int index) const {
	const auto at = [this, index](int which) { return column(which)[index]; };
	if (!is_swinging) {
		return { rest(index), {} };
	}
	if (kind.law == Law::elasticity) {
		return safe_state({ { at(X), at(Y), at(Z) }, glm::vec3(at(TURN_X), at(TURN_Y), at(TURN_Z)) / step_time });
	}
	return from_gnomonic({ at(FLAT_X), at(FLAT_Z), at(FLAT_RATE_X), at(FLAT_RATE_Z) });
}

void MotionPage::put_state(int index, const TipState &state) {
	if (kind.law == Law::elasticity) {
		const TipState safe = safe_state(state);
		column(X)[index] = safe.direction.x;
		column(Y)[index] = safe.direction.y;
		column(Z)[index] = safe.direction.z;
		column(TURN_X)[index] = safe.rate.x * step_time;
		column(TURN_Y)[index] = safe.rate.y * step_time;
		column(TURN_Z)[index] = safe.rate.z * step_time;
		return;
	}
	const GnomonicState flat = to_gnomonic(state);
	column(FLAT_X)[index] = flat.x;
	column(FLAT_Z)[index] = flat.z;
	column(FLAT_RATE_X)[index] = flat.rate_x;
	column(FLAT_RATE_Z)[index] = flat.rate_z;
}

void MotionPage::set_state(int index, const TipState &state) {
	if (is_swinging) {
		put_state(index, state);
	}
	if (has_bends()) {
		pairs[2 * static_cast<std::size_t>(index) + 1] = encode_bend(safe_state(state).direction);
	}
}

void MotionPage::take_motion(int index, const MotionPage &other, int from) {
	if (!is_swinging || !other.is_swinging) {
		return; // Who follows a prototype has no motion of its own.
	}
	const glm::vec3 was = other.rest(from);
	const glm::vec3 is = rest(index);
	set_state(index, moved_rest(other.state(from), was, is));
	set_before(index, moved_rest({ other.before(from), {} }, was, is).direction);
	if (was == is && has_bends() && other.has_bends()) {
		std::copy_n(other.pairs.begin() + 2 * from, 2, pairs.begin() + 2 * index); // To the bit.
	}
}

glm::vec3 MotionPage::before(int index) const {
	if (!is_swinging) {
		return rest(index);
	}
	if (!keeps_directions) {
		return decode_bend(pairs[2 * static_cast<std::size_t>(index)]);
	}
	if (kind.law == Law::elasticity) {
		return { column(LAST_X)[index], column(LAST_Y)[index], column(LAST_Z)[index] };
	}
	return glm::normalize(glm::vec3(column(FLAT_LAST_X)[index], 1.0f, column(FLAT_LAST_Z)[index]));
}

void MotionPage::set_before(int index, const glm::vec3 &direction) {
	const TipState safe = safe_state({ direction, {} });
	if (!is_swinging) {
		return;
	}
	if (!keeps_directions) {
		pairs[2 * static_cast<std::size_t>(index)] = encode_bend(safe.direction);
	} else if (kind.law == Law::elasticity) {
		column(LAST_X)[index] = safe.direction.x;
		column(LAST_Y)[index] = safe.direction.y;
		column(LAST_Z)[index] = safe.direction.z;
	} else {
		const GnomonicState flat = to_gnomonic(safe);
		column(FLAT_LAST_X)[index] = flat.x;
		column(FLAT_LAST_Z)[index] = flat.z;
	}
}

void MotionPage::apply_impulse(int index, const glm::vec3 &impulse) {
	TipState blown = state(index);
	blown.rate += impulse / (kind.joint.mass * length(index));
	set_state(index, blown);
}

void MotionPage::settle(int index) {
	const glm::vec3 calm = rest(index);
	set_state(index, { calm, {} });
	set_before(index, calm);
}

void MotionPage::settle() {
	for (int i = 0; i < size(); i++) {
		settle(i);
	}
}

void MotionPage::drop(int index) {
	if (is_gone(index)) {
		return;
	}
	column(LENGTH)[index] = 0.0f;
	settle(index);
	gone++;
}

void MotionPage::remove(int index) {
	gone -= is_gone(index) ? 1 : 0;
	const std::size_t last = static_cast<std::size_t>(size()) - 1;
	rows.remove_row(index);
	if (has_bends()) {
		pairs[2 * static_cast<std::size_t>(index)] = pairs[2 * last];
		pairs[2 * static_cast<std::size_t>(index) + 1] = pairs[2 * last + 1];
		pairs.resize(2 * last);
	}
}

void MotionPage::set_species(const MotionSpecies &species) {
	if (is_swinging && species.law != kind.law) {
		std::vector<TipState> states;
		std::vector<glm::vec3> last;
		for (int i = 0; i < size(); i++) {
			states.push_back(state(i));
			last.push_back(before(i));
		}
		kind.law = species.law;
		for (int i = 0; i < size(); i++) {
			put_rest(i, { 0.0f, 1.0f, 0.0f });
			put_state(i, states[static_cast<std::size_t>(i)]);
			if (keeps_directions) {
				set_before(i, last[static_cast<std::size_t>(i)]);
			}
		}
	}
	const bool has_other_radius = species.collision_radius != kind.collision_radius;
	kind = species;
	kind.joint = safe_joint(species.joint);
	if (is_swinging) {
		update_constants(0);
	}
	if (has_other_radius) {
		update_box();
	}
}

void MotionPage::grow_box(int index, bool is_first) {
	const glm::vec3 place = root(index);
	const glm::vec3 reach = glm::vec3(length(index) + std::max(kind.collision_radius, 0.0f));
	box_low = is_first ? place - reach : glm::min(box_low, place - reach);
	box_high = is_first ? place + reach : glm::max(box_high, place + reach);
}

void MotionPage::update_box() {
	for (int i = 0; i < size(); i++) {
		grow_box(i, i == 0);
	}
}

std::size_t MotionPage::bytes() const {
	return rows.bytes() + pairs.capacity() * sizeof(Bend) + sizeof(MotionPage);
}

} // namespace undergrowth
