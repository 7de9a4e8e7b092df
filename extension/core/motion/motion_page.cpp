#include "motion/motion_page.hpp"

#include "motion/gnomonic.hpp"
#include "motion/motion_page_columns.hpp"
#include "motion/part_bend.hpp"
#include "motion/stem_impulses.hpp"
#include "stem/stem_bones.hpp"
#include "stem/stem_shape.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

using namespace motion_page_columns;

namespace {

int column_count(bool swings, bool keeps_directions, const MotionSpecies &species) {
	if (!swings) {
		return static_cast<int>(STILL_COLUMNS);
	}
	if (species.law == Law::stem) {
		const int modes = species.stem.modes;
		return stem_columns(modes, keeps_directions) + (species.stem.has_own_frequencies() ? graded_columns(modes) : 0);
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
	owns.reserve(is_graded() ? static_cast<std::size_t>(std::max(plants, 0)) : 0);
}

/// Adds rows for `plants`, or default ones.
void MotionPage::add_owns(const MotionPlant *plants) {
	if (!is_graded()) {
		owns = {};
		return;
	}
	const int before = static_cast<int>(owns.size());
	owns.resize(static_cast<std::size_t>(size()));
	if (plants) {
		put_owns(before, plants, size() - before);
	}
}

void MotionPage::put_owns(int first, const MotionPlant *plants, int count) {
	for (int i = 0; i < count; i++) {
		owns[static_cast<std::size_t>(first + i)] = { plants[i].scale, plants[i].own };
	}
}

void MotionPage::set_owns(int first, const MotionPlant *plants, int count) {
	if (is_graded()) {
		put_owns(first, plants, count);
		update_constants(first, first + count);
	}
}

void MotionPage::add(const MotionPlant *plants, int count) {
	const int before = size();
	ahead.forget();
	rows.reserve(before + count);
	lasting.resize(before + count);
	pairs.resize(has_bends() ? 2 * static_cast<std::size_t>(before + count) : 0);
	second_pairs.resize(has_room_for_second() ? pairs.size() : 0);
	for (int i = before; i < before + count; i++) {
		rows.add_row();
		put_place(i, plants[i - before]);
		straighten(i);
	}
	add_owns(plants);
	if (is_swinging) {
		update_constants(before);
		settle_under_weight(before, size());
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

static void shift_tip(MotionPage &page, int index, const glm::vec2 &by) {
	if (by == glm::vec2(0.0f)) {
		return;
	}
	glm::vec2 modes[MAX_STEM_MODES];
	divide_tip(page.stem_constants(), by, modes);
	StemState state = page.stem(index);
	for (int k = 0; k < page.stem_constants().modes; k++) {
		state.place[k] += modes[k];
	}
	page.set_stem(index, state);
}

// The deflection from the bend under its own weight is preserved.
void MotionPage::set_plant(int index, const MotionPlant &plant) {
	const glm::vec2 before = nod(index);
	if (plant.root != root(index) || kind.canopy_height <= 0.0f) { // Isolated plants have the wind at their tops.
		ahead.forget();
	}
	put_place(index, plant);
	if (is_graded()) {
		put_owns(index, &plant, 1);
	}
	if (is_swinging) {
		update_constants(index, index + 1);
	}
	shift_tip(*this, index, nod(index) - before);
}

void MotionPage::set_rests(int first, const glm::vec3 *rests, int count) {
	for (int i = first; i < first + count; i++) {
		const glm::vec2 before = nod(i);
		put_rest(i, rests[i - first]);
		shift_tip(*this, i, nod(i) - before);
	}
}

void MotionPage::straighten(int index) {
	const glm::vec3 calm = rest(index);
	set_state(index, { calm, {} });
	set_before(index, calm);
}

void MotionPage::settle() {
	forget_lasting_bends();
	for (int i = 0; i < size(); i++) {
		straighten(i);
	}
	settle_under_weight(0, size());
}

void MotionPage::settle(int index) {
	lasting.set(index, { 0.0f, 0.0f });
	straighten(index);
	settle_under_weight(index, index + 1);
}

void MotionPage::drop(int index) {
	if (is_gone(index)) {
		return;
	}
	column(LENGTH)[index] = 0.0f;
	lasting.set(index, { 0.0f, 0.0f });
	straighten(index);
	gone++;
}

void MotionPage::remove(int index) {
	gone -= is_gone(index) ? 1 : 0;
	const std::size_t last = static_cast<std::size_t>(size()) - 1;
	ahead.forget();
	lasting.set(index, lasting.at(static_cast<int>(last)));
	lasting.resize(static_cast<int>(last));
	rows.remove_row(index);
	if (is_graded()) {
		owns[static_cast<std::size_t>(index)] = owns.back();
		owns.pop_back();
	}
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
					(species.stem.modes == whole.modes &&
							species.stem.has_own_frequencies() == whole.has_own_frequencies() &&
							species.stem.mode[0].tip_slope == whole.mode[0].tip_slope));
}

void MotionPage::set_species(const MotionSpecies &species) {
	const bool has_other_radius = species.collision_radius != kind.collision_radius;
	const bool has_one_of_two = modes() < max_modes();
	std::vector<int> at_rest; // These plants get the bend of their new weight.
	for (int i = 0; (kind.stem.nod.share != 0.0f || species.stem.nod.share != 0.0f) && i < size(); i++) {
		if (is_at_rest(i)) {
			at_rest.push_back(i);
		}
	}
	const Precipitation carried = load;
	carry({});
	set_modes(max_modes());
	if (is_swinging && !has_same_columns(species)) {
		change_columns(species);
	}
	kind = species;
	kind.joint = safe_joint(species.joint);
	whole = species.stem;
	add_owns(nullptr);
	ahead.forget();
	if (is_swinging) {
		update_constants(0);
	}
	for (const int row : at_rest) {
		settle(row);
	}
	set_modes(has_one_of_two ? 1 : max_modes());
	carry(carried);
	if (has_other_radius) {
		update_box();
	}
}

/// Converts the columns to another law; the motion of tips continues.
void MotionPage::change_columns(const MotionSpecies &species) {
	const bool keeps_rests = species.law == kind.law;
	lasting = species.law == Law::stem ? std::move(lasting) : LastingBends();
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
			(pairs.capacity() + second_pairs.capacity()) * sizeof(Bend) + owns.capacity() * sizeof(OwnStem) +
			unloaded.capacity() * sizeof(StemConstants) + ahead.bytes() + lasting.bytes() + sizeof(MotionPage);
}

/// Moves a state to another rest direction, at the same distance from it in the plane of the spring law.
static TipState moved_rest(const TipState &state, const glm::vec3 &from, const glm::vec3 &to) {
	if (from == to) {
		return state;
	}
	GnomonicState flat = to_gnomonic(state);
	flat.x += to.x / to.y - from.x / from.y;
	flat.z += to.z / to.y - from.z / from.y;
	return from_gnomonic(flat);
}

glm::vec3 MotionPage::root(int index) const {
	return { column(ROOT_X)[index], column(ROOT_Y)[index], column(ROOT_Z)[index] };
}

float MotionPage::length(int index) const {
	return column(LENGTH)[index];
}

float MotionPage::drag_area(int index) const {
	constexpr float USUAL = 0.05f; // m² of a plant of 1 m, for joints without a drag area.
	const float length = column(LENGTH)[index];
	if (kind.law != Law::stem && kind.joint.drag_area < 0.0f) {
		return USUAL * length * length;
	}
	const float mean = kind.canopy_height > 0.0f ? kind.canopy_height : 1.0f;
	const float ratio = length / mean;
	return ratio * ratio * (kind.law == Law::stem ? whole.drag_area : kind.joint.drag_area);
}

glm::vec3 MotionPage::rest(int index) const {
	if (!is_swinging || kind.law == Law::elasticity) {
		return { 0.0f, 1.0f, 0.0f };
	}
	if (kind.law == Law::stem) {
		return from_stereographic(rest_bend(index));
	}
	return glm::normalize(glm::vec3(column(REST_X)[index], 1.0f, column(REST_Z)[index]));
}

glm::vec2 MotionPage::rest_bend(int index) const {
	return { column(STEM_REST_X)[index], column(STEM_REST_Z)[index] };
}

glm::vec3 MotionPage::arm(int index, float share) const {
	if (!is_swinging || kind.law != Law::stem) {
		return share * length(index) * direction(index);
	}
	const StemState now = stem(index);
	return length(index) * turned(stem_place(kind.stem, now.place, share).centre, rest_bend(index));
}

glm::vec3 MotionPage::direction(int index) const {
	if (!is_swinging) {
		return rest(index);
	}
	if (kind.law == Law::stem) {
		return turned(from_stereographic(tip_bend(kind.stem, stem(index))), rest_bend(index));
	}
	if (kind.law == Law::elasticity) {
		return { column(X)[index], column(Y)[index], column(Z)[index] };
	}
	return glm::normalize(glm::vec3(column(FLAT_X)[index], 1.0f, column(FLAT_Z)[index]));
}

StemState MotionPage::stem(int index) const {
	StemState state;
	for (int k = 0; k < kind.stem.modes; k++) {
		const int first = first_of_mode(k);
		state.place[k] = { column(first)[index], column(first + 1)[index] };
		state.rate[k] = { column(first + 2)[index], column(first + 3)[index] };
	}
	return state;
}

void MotionPage::put_stem(int index, const StemState &state) {
	for (int k = 0; k < kind.stem.modes; k++) {
		const int first = first_of_mode(k);
		column(first)[index] = state.place[k].x;
		column(first + 1)[index] = state.place[k].y;
		column(first + 2)[index] = state.rate[k].x;
		column(first + 3)[index] = state.rate[k].y;
	}
}

void MotionPage::set_stem(int index, const StemState &state) {
	MovedStems one;
	one.add(index, state);
	set_stems(one);
}

void MotionPage::set_stems(MovedStems &moved) {
	if (moved.count == 0) {
		return;
	}
	StemPage page = stem_page(0);
	float rests[2][MovedStems::MAX];
	for (int i = 0; i < moved.count; i++) {
		moved.put(i, safe_stem(kind.stem, moved.at(i)));
		rests[0][i] = page.rest_x[moved.index[i]];
		rests[1][i] = page.rest_z[moved.index[i]];
	}
	for (int k = 0; k < kind.stem.modes; k++) {
		page.x[k] = moved.place_x[k];
		page.z[k] = moved.place_z[k];
		page.rate_x[k] = moved.rate_x[k];
		page.rate_z[k] = moved.rate_z[k];
	}
	page.rest_x = rests[0];
	page.rest_z = rests[1];
	kernels(best_simd_level()).lift_stems(page, moved.count);
	for (int i = 0; i < moved.count; i++) {
		const StemState lifted = moved.at(i);
		put_stem(moved.index[i], lifted);
		put_bends(moved.index[i], bends_of(kind.stem, lifted, { rests[0][i], rests[1][i] }));
	}
}

/// The drawn bends after the last step.
void MotionPage::put_bends(int index, const StemBends &bends) {
	const std::size_t now = 2 * static_cast<std::size_t>(index) + 1;
	if (has_bends()) {
		pairs[now] = bends.first;
	}
	if (has_bends() && has_second_bends()) {
		second_pairs[now] = bends.second;
	}
}

TipState MotionPage::state(int index) const {
	const auto at = [this, index](int which) { return column(which)[index]; };
	if (!is_swinging) {
		return { rest(index), {} };
	}
	if (kind.law == Law::stem) {
		return tip_state(kind.stem, stem(index), rest_bend(index));
	}
	if (kind.law == Law::elasticity) {
		return safe_state({ { at(X), at(Y), at(Z) }, glm::vec3(at(TURN_X), at(TURN_Y), at(TURN_Z)) / step_time });
	}
	return from_gnomonic({ at(FLAT_X), at(FLAT_Z), at(FLAT_RATE_X), at(FLAT_RATE_Z) });
}

void MotionPage::put_state(int index, const TipState &state) {
	if (kind.law == Law::stem) {
		put_stem(index, stem_state(kind.stem, state, rest_bend(index)));
		kernels(best_simd_level()).lift_stems(stem_page(index), 1);
		return;
	}
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

StemSecond MotionPage::second(int index) const {
	return is_swinging && modes() == 2 ? second_of(kind.stem, stem(index), rest_bend(index)) : StemSecond();
}

void MotionPage::set_state(int index, const TipState &state, const StemSecond &second) {
	if (!is_swinging) {
		return;
	}
	if (kind.law == Law::stem) {
		set_stem(index, stem_state(kind.stem, state, rest_bend(index), second));
		return;
	}
	put_state(index, state);
	if (has_bends()) {
		pairs[2 * static_cast<std::size_t>(index) + 1] = encode_bend(safe_state(state).direction);
	}
}

void MotionPage::transfer_motion(int index, const MotionPage &other, int from) {
	if (!is_swinging || !other.is_swinging) {
		return; // A follower has no motion of its own.
	}
	const glm::vec3 was = other.rest(from);
	const glm::vec3 is = rest(index);
	set_lasting_bend(index, other.lasting_bend(from));
	if (kind.law == Law::stem && other.kind.law == Law::stem && kind.stem.modes == other.kind.stem.modes) {
		set_stem(index, other.stem(from)); // Relative to its own rest.
	} else {
		set_state(index, moved_rest(other.state(from), was, is));
	}
	set_before(index, moved_rest({ other.before(from), {} }, was, is).direction);
	if (was == is && has_bends() && other.has_bends() && modes() == other.modes()) { // Bit by bit.
		std::copy_n(other.pairs.begin() + 2 * from, 2, pairs.begin() + 2 * index);
		if (has_second_bends() && other.has_second_bends()) {
			std::copy_n(other.second_pairs.begin() + 2 * from, 2, second_pairs.begin() + 2 * index);
		}
	}
}

glm::vec3 MotionPage::before(int index) const {
	if (!is_swinging) {
		return rest(index);
	}
	if (!keeps_directions) {
		return decode_bend(pairs[2 * static_cast<std::size_t>(index)]);
	}
	if (kind.law == Law::stem) {
		return turned(from_stereographic(tip_bend(kind.stem, stem_before(index))), rest_bend(index));
	}
	if (kind.law == Law::elasticity) {
		return { column(LAST_X)[index], column(LAST_Y)[index], column(LAST_Z)[index] };
	}
	return glm::normalize(glm::vec3(column(FLAT_LAST_X)[index], 1.0f, column(FLAT_LAST_Z)[index]));
}

StemState MotionPage::stem_before(int index) const {
	StemState state;
	for (int k = 0; k < kind.stem.modes; k++) {
		const int first = last_of_mode(kind.stem.modes, k);
		state.place[k] = { column(first)[index], column(first + 1)[index] };
	}
	return state;
}

glm::vec3 MotionPage::second_bend(int index, float alpha) const {
	if (kind.law != Law::stem || kind.stem.modes < 2) {
		return { 0.0f, 0.0f, 0.0f };
	}
	const glm::vec2 last = keeps_directions ? stem_before(index).place[1] : stem(index).place[1];
	const glm::vec2 bend = glm::mix(last, stem(index).place[1], alpha) * kind.stem.mode[1].tip_slope;
	return turned({ bend.x, 0.0f, bend.y }, rest_bend(index));
}

void MotionPage::set_before(int index, const glm::vec3 &direction) {
	const TipState safe = safe_state({ direction, {} });
	if (!is_swinging) {
		return;
	}
	if (!keeps_directions) {
		pairs[2 * static_cast<std::size_t>(index)] = encode_bend(safe.direction);
		if (has_second_bends()) {
			second_pairs[2 * static_cast<std::size_t>(index)] = 0;
		}
	} else if (kind.law == Law::stem) {
		set_stem_before(index, stem_state(kind.stem, safe, rest_bend(index)));
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

void MotionPage::set_stem_before(int index, const StemState &state) {
	for (int k = 0; keeps_directions && k < kind.stem.modes; k++) {
		const int first = last_of_mode(kind.stem.modes, k);
		column(first)[index] = state.place[k].x;
		column(first + 1)[index] = state.place[k].y;
	}
}

glm::vec3 MotionPage::tip_velocity(int index) const {
	if (!is_swinging || kind.law != Law::stem) {
		return length(index) * state(index).rate;
	}
	return turned(stem_velocity(kind.stem, stem(index), 1.0f, kind.stem.length / length(index)), rest_bend(index));
}

void MotionPage::move_tip(int index, const glm::vec3 &way, const glm::vec3 &faster) {
	was_moved = true;
	const glm::vec2 back = -rest_bend(index);
	const float scale = kind.stem.length / length(index);
	StemState moved = stem(index);
	push_stem(kind.stem, moved, 1.0f, turned(way, back), scale);
	apply_stem_impulse(kind.stem, moved, 1.0f, turned(faster * stem_mass(kind.stem, 1.0f), back), scale);
	set_stem(index, moved);
}

void MotionPage::set_lasting_bend(int index, const glm::vec2 &bend) {
	if (is_swinging && kind.law == Law::stem && bend != lasting.at(index)) {
		lasting.make_room(size());
		lasting.set(index, bend);
	}
}

void MotionPage::let_last(int index, const glm::vec2 &bend, float share) {
	const glm::vec2 now = lasting.at(index);
	if (glm::dot(bend, bend) > glm::dot(now, now)) { // A body that leaves lets plants rise, which undoes nothing.
		lasting.set(index, now + share * (bend - now));
	}
}

void MotionPage::make_room_for_lasting_bends(bool is_trodden) {
	const bool may_last = std::exchange(has_yielded, false) || is_trodden;
	if (may_last && is_swinging && kind.law == Law::stem) {
		lasting.make_room(size());
	} else if (lasting.has_room() && !lasting.is_any()) {
		forget_lasting_bends();
	}
}

void MotionPage::apply_impulse_at(int index, int joint, const glm::vec3 &impulse) {
	StemState pushed = stem(index);
	const float x =
			joint > kind.stem.joints ? ON_HEAD : static_cast<float>(joint) / static_cast<float>(kind.stem.joints);
	apply_stem_impulse(kind.stem, pushed, x, turned(impulse, -rest_bend(index)), kind.stem.length / length(index));
	set_stem(index, pushed);
}

void MotionPage::apply_impulse(int index, const glm::vec3 &impulse) {
	if (is_swinging && kind.law == Law::stem) {
		apply_impulse_at(index, kind.stem.joints, impulse);
		return;
	}
	TipState pushed = state(index);
	pushed.rate += impulse / (kind.joint.mass * length(index));
	set_state(index, pushed);
}

} // namespace undergrowth
