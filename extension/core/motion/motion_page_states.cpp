// MotionPage: directions, drawn poses, and blows.

#include "motion/gnomonic.hpp"
#include "motion/motion_page.hpp"
#include "motion/motion_page_columns.hpp"
#include "motion/part_bend.hpp"
#include "motion/stem_impulses.hpp"
#include "stem/stem_bones.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace undergrowth {

using namespace motion_page_columns;

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
	put_stem(index, safe_stem(kind.stem, state));
	kernels(best_simd_level()).lift_stems(stem_page(index), 1);
	if (has_bends()) {
		const StemBends now = bends_of(kind.stem, stem(index), rest_bend(index));
		pairs[2 * static_cast<std::size_t>(index) + 1] = now.first;
		if (has_second_bends()) {
			second_pairs[2 * static_cast<std::size_t>(index) + 1] = now.second;
		}
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
