#include "motion/motion_page.hpp"

#include "motion/gnomonic.hpp"
#include "motion/motion_page_columns.hpp"
#include "stem/stem_shape.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace undergrowth {

using namespace motion_page_columns;

namespace {

int column_count(bool swings, bool keeps_directions, const MotionSpecies &species) {
	if (!swings) {
		return static_cast<int>(STILL_COLUMNS);
	}
	if (species.law == Law::stem) {
		const int modes = species.stem.modes;
		return stem_columns(modes, keeps_directions) + (species.stem.has_grades() ? graded_columns(modes) : 0);
	}
	return keeps_directions ? static_cast<int>(REMEMBERING_COLUMNS) : static_cast<int>(SWINGING_COLUMNS);
}

} // namespace

MotionPage::MotionPage(int species_index, const MotionSpecies &species, const MotionPlant *plants, int count,
		float step, bool swings, Keeps keeps) :
		species_number(species_index),
		is_swinging(swings),
		keeps_directions(swings && keeps == Keeps::directions),
		step_time(step),
		kind(species),
		whole(species.stem),
		rows(column_count(swings, keeps_directions, species)) {
	kind.joint = safe_joint(species.joint);
	add(plants, count);
}

void MotionPage::reserve(int plants) {
	rows.reserve(plants);
	blocks.reserve(static_cast<std::size_t>((std::max(plants, 0) + BLOCK_ROWS - 1) / BLOCK_ROWS));
	pairs.reserve(has_bends() ? 2 * static_cast<std::size_t>(std::max(plants, 0)) : 0);
	second_pairs.reserve(has_room_for_second() ? pairs.capacity() : 0);
}

void MotionPage::add(const MotionPlant *plants, int count) {
	const int before = size();
	ahead.forget();
	rows.reserve(before + count);
	pairs.resize(has_bends() ? 2 * static_cast<std::size_t>(before + count) : 0);
	second_pairs.resize(has_room_for_second() ? pairs.size() : 0);
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
	} else if (is_swinging && kind.law == Law::stem) {
		const glm::vec2 bend = stereographic(encode_bend(rest));
		column(STEM_REST_X)[index] = bend.x;
		column(STEM_REST_Z)[index] = bend.y;
		max_lean = std::max(max_lean, glm::length(bend));
	}
}

void MotionPage::set_plant(int index, const MotionPlant &plant) {
	if (plant.root != root(index) || kind.canopy_height <= 0.0f) { // Isolated plants have the wind at their tops.
		ahead.forget();
	}
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
	ahead.forget();
	rows.remove_row(index);
	if (index < size()) {
		grow_box(index, false); // The last plant is in this block now.
	}
	for (std::vector<Bend> *some : { &pairs, &second_pairs }) {
		if (!some->empty()) {
			std::copy_n(some->begin() + static_cast<std::ptrdiff_t>(2 * last), 2, some->begin() + 2 * index);
			some->resize(2 * last);
		}
	}
}

/// True if both species store the same data in the columns.
bool MotionPage::has_same_columns(const MotionSpecies &species) const {
	return species.law == kind.law &&
			(kind.law != Law::stem ||
					(species.stem.modes == whole.modes && species.stem.has_grades() == whole.has_grades() &&
							species.stem.mode[0].tip_slope == whole.mode[0].tip_slope));
}

void MotionPage::set_species(const MotionSpecies &species) {
	const bool has_other_radius = species.collision_radius != kind.collision_radius;
	const bool has_one_of_two = modes() < max_modes();
	set_modes(max_modes());
	if (is_swinging && !has_same_columns(species)) {
		change_columns(species);
	}
	kind = species;
	kind.joint = safe_joint(species.joint);
	whole = species.stem;
	ahead.forget();
	if (is_swinging) {
		update_constants(0);
	}
	set_modes(has_one_of_two ? 1 : max_modes());
	if (has_other_radius) {
		update_box();
	}
}

/// Converts the columns to another law; the motion of tips continues.
void MotionPage::change_columns(const MotionSpecies &species) {
	const bool keeps_rests = species.law == kind.law;
	std::vector<TipState> states;
	std::vector<glm::vec3> last, rests;
	for (int i = 0; i < size(); i++) {
		states.push_back(state(i));
		last.push_back(before(i));
		rests.push_back(keeps_rests ? rest(i) : glm::vec3(0.0f, 1.0f, 0.0f));
	}
	Columns others(column_count(is_swinging, keeps_directions, species));
	others.reserve(size());
	for (int i = 0; i < size(); i++) {
		others.add_row();
	}
	for (int which = 0; which < STILL_COLUMNS; which++) {
		std::copy(column(which), column(which) + size(), others.column(which));
	}
	rows = std::move(others);
	kind = species;
	whole = species.stem;
	stems = {}; // Constants of other columns: update_constants() restores the ground.
	second_pairs.assign(has_room_for_second() ? pairs.size() : 0, 0);
	for (int i = 0; i < size(); i++) {
		put_rest(i, rests[static_cast<std::size_t>(i)]);
		put_state(i, states[static_cast<std::size_t>(i)]);
		if (keeps_directions) {
			set_before(i, last[static_cast<std::size_t>(i)]);
		}
	}
}

void MotionPage::set_modes(int count) {
	if (kind.law != Law::stem || keeps_directions || count == kind.stem.modes || count < 1 || count > whole.modes) {
		return;
	}
	const StemConstants from = kind.stem;
	kind.stem = count == whole.modes ? whole : in_one_mode(whole);
	for (int i = 0; i < size() && is_swinging; i++) {
		put_modes(i, from);
	}
	if (is_swinging) {
		update_constants(0);
	}
}

void MotionPage::put_modes(int index, const StemConstants &from) {
	StemState was, is;
	for (int k = 0; k < from.modes; k++) {
		const int first = first_of_mode(k);
		was.place[k] = { column(first)[index], column(first + 1)[index] };
		was.rate[k] = { column(first + 2)[index], column(first + 3)[index] };
	}
	glm::vec2 rate(0.0f);
	for (int k = 0; k < from.modes; k++) {
		rate += was.rate[k] * from.mode[k].tip_slope;
	}
	divide_tip(kind.stem, tip_bend(from, was), is.place);
	divide_tip(kind.stem, rate, is.rate);
	put_stem(index, safe_stem(kind.stem, is));
	for (std::size_t bend = 2 * static_cast<std::size_t>(index); bend < 2 * static_cast<std::size_t>(index) + 2;
			bend++) {
		put_pair_of_modes(bend, rest_bend(index));
	}
}

/// Converts one drawn bend to the current modes.
void MotionPage::put_pair_of_modes(std::size_t bend, const glm::vec2 &rest) {
	const StemBends now = bends_in_modes(kind.stem, { pairs[bend], second_pairs[bend] }, rest);
	pairs[bend] = now.first;
	second_pairs[bend] = now.second;
}

/// Does not change the first mode: a correction through both would amplify itself.
void MotionPage::ease_modes(int begin, int count) {
	const float share = kind.stem.mode[1].dead_share / kind.stem.mode[0].dead_share;
	for (int part = 0; part < 4; part++) { // Both positions and both rates.
		const float *first = column(first_of_mode(0) + part) + begin;
		float *second = column(first_of_mode(1) + part) + begin;
		for (int i = 0; i < count; i++) {
			second[i] += easing * (share * first[i] - second[i]);
		}
	}
}

void MotionPage::grow_box(int index, bool is_first) {
	const glm::vec3 place = root(index);
	const glm::vec3 reach = glm::vec3(length(index) + std::max(kind.collision_radius, 0.0f));
	box_low = is_first ? place - reach : glm::min(box_low, place - reach);
	box_high = is_first ? place + reach : glm::max(box_high, place + reach);
	grow_block(index, place - reach, place + reach);
}

void MotionPage::grow_block(int index, const glm::vec3 &low, const glm::vec3 &high) {
	const std::size_t block = static_cast<std::size_t>(index / BLOCK_ROWS);
	if (block >= blocks.size()) {
		blocks.push_back({ low.x, high.x, low.z, high.z });
		return;
	}
	BlockBox &box = blocks[block];
	box = { std::min(box.low_x, low.x), std::max(box.high_x, high.x), std::min(box.low_z, low.z),
		std::max(box.high_z, high.z) };
}

void MotionPage::update_box() {
	for (int i = 0; i < size(); i++) {
		grow_box(i, i == 0);
	}
}

std::size_t MotionPage::bytes() const {
	return rows.bytes() + blocks.capacity() * sizeof(BlockBox) +
			(pairs.capacity() + second_pairs.capacity()) * sizeof(Bend) + ahead.bytes() + sizeof(MotionPage);
}

} // namespace undergrowth
