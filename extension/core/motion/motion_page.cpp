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

bool is_finite(const glm::vec3 &vector) {
	return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

} // namespace

bool is_valid(const MotionPlant &plant) {
	return is_finite(plant.root) && std::isfinite(plant.length) && plant.length > 0.0f && is_finite(plant.rest) &&
			plant.rest.y > 0.0f;
}

MotionPage::MotionPage(int species_index, const MotionSpecies &species, const MotionPlant *plants, int count,
		float step, bool swings) :
		species_number(species_index),
		is_swinging(swings),
		step_time(step),
		kind(species),
		rows(swings ? static_cast<int>(SWINGING_COLUMNS) : static_cast<int>(STILL_COLUMNS)) {
	kind.joint = safe_joint(species.joint);
	add(plants, count);
}

void MotionPage::reserve(int plants) {
	rows.reserve(plants);
	pairs.reserve(is_swinging ? 2 * static_cast<std::size_t>(std::max(plants, 0)) : 0);
}

void MotionPage::add(const MotionPlant *plants, int count) {
	const int before = size();
	rows.reserve(before + count);
	pairs.resize(is_swinging ? 2 * static_cast<std::size_t>(before + count) : 0);
	for (int i = before; i < before + count; i++) {
		const MotionPlant &plant = plants[i - before];
		rows.add_row();
		column(ROOT_X)[i] = plant.root.x;
		column(ROOT_Y)[i] = plant.root.y;
		column(ROOT_Z)[i] = plant.root.z;
		column(LENGTH)[i] = plant.length;
		if (is_swinging && kind.law == Law::spring) {
			column(REST_X)[i] = std::clamp(plant.rest.x / plant.rest.y, -MAX_GNOMONIC, MAX_GNOMONIC);
			column(REST_Z)[i] = std::clamp(plant.rest.z / plant.rest.y, -MAX_GNOMONIC, MAX_GNOMONIC);
		}
		grow_box(plant);
		settle(i);
	}
	if (is_swinging) {
		update_constants(before);
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
		pairs[2 * static_cast<std::size_t>(index) + 1] = encode_bend(safe_state(state).direction);
	}
}

void MotionPage::take_motion(int index, const MotionPage &other, int from) {
	if (is_swinging && other.is_swinging) {
		put_state(index, other.state(from));
	}
	std::copy_n(other.pairs.begin() + 2 * from, 2, pairs.begin() + 2 * index);
}

void MotionPage::set_rest(int index, const glm::vec3 &rest) {
	if (is_swinging && kind.law == Law::spring) {
		column(REST_X)[index] = std::clamp(rest.x / rest.y, -MAX_GNOMONIC, MAX_GNOMONIC);
		column(REST_Z)[index] = std::clamp(rest.z / rest.y, -MAX_GNOMONIC, MAX_GNOMONIC);
	}
}

void MotionPage::settle(int index) {
	set_state(index, { rest(index), {} });
	if (is_swinging) {
		pairs[2 * static_cast<std::size_t>(index)] = pairs[2 * static_cast<std::size_t>(index) + 1];
	}
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
	if (!is_swinging) {
		return;
	}
	pairs[2 * static_cast<std::size_t>(index)] = pairs[2 * last];
	pairs[2 * static_cast<std::size_t>(index) + 1] = pairs[2 * last + 1];
	pairs.resize(2 * last);
}

void MotionPage::set_species(const MotionSpecies &species) {
	if (is_swinging && species.law != kind.law) {
		std::vector<TipState> states;
		for (int i = 0; i < size(); i++) {
			states.push_back(state(i));
		}
		kind.law = species.law;
		for (int i = 0; i < size(); i++) {
			if (kind.law == Law::spring) {
				column(REST_X)[i] = 0.0f;
				column(REST_Z)[i] = 0.0f;
			}
			put_state(i, states[static_cast<std::size_t>(i)]);
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

void MotionPage::grow_box(const MotionPlant &plant) {
	const glm::vec3 reach = glm::vec3(plant.length + std::max(kind.collision_radius, 0.0f));
	const bool first = size() == 1;
	box_low = first ? plant.root - reach : glm::min(box_low, plant.root - reach);
	box_high = first ? plant.root + reach : glm::max(box_high, plant.root + reach);
}

void MotionPage::update_box() {
	const float radius = std::max(kind.collision_radius, 0.0f);
	for (int i = 0; i < size(); i++) {
		const glm::vec3 reach = glm::vec3(length(i) + radius);
		box_low = i == 0 ? root(i) - reach : glm::min(box_low, root(i) - reach);
		box_high = i == 0 ? root(i) + reach : glm::max(box_high, root(i) + reach);
	}
}

std::size_t MotionPage::bytes() const {
	return rows.bytes() + pairs.capacity() * sizeof(Bend) + sizeof(MotionPage);
}

} // namespace undergrowth
