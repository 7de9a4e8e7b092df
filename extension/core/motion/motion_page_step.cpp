// MotionPage: constants for the step length, and steps.

#include "motion/motion_page.hpp"

#include "conventions.hpp"
#include "motion/motion_page_columns.hpp"
#include "motion/page_wind.hpp"
#include "motion/part_bend.hpp"
#include "stem/loaded_stem.hpp"
#include "stem/stem_shape.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace undergrowth {

using namespace motion_page_columns;

namespace {

constexpr float MAX_REST_ERROR = 1e-3f; // Of bends as half floats.
constexpr float MAX_REST_RATE = 1e-3f; // 1/s.

/// Seconds of a small swing of the elasticity law.
float swing_of(const Joint &joint, float length) {
	const float stiffness = std::max(joint.elasticity, 1e-3f) * STANDARD_GRAVITY;
	return static_cast<float>(2.0 * PI) * std::sqrt(length / stiffness);
}

/// Amplitude of each mode for a bend of the tip of 1.
void write_shares(const StemConstants &stem, float *shares) {
	glm::vec2 modes[MAX_STEM_MODES];
	divide_tip(stem, { 1.0f, 0.0f }, modes);
	for (int k = 0; k < stem.modes; k++) {
		shares[k] = modes[k].x;
	}
}

} // namespace

void MotionPage::set_step_length(float step) {
	if (is_swinging && kind.law == Law::elasticity) {
		const float ratio = step / step_time;
		for (int i = 0; i < size(); i++) {
			column(TURN_X)[i] *= ratio;
			column(TURN_Y)[i] *= ratio;
			column(TURN_Z)[i] *= ratio;
		}
	}
	step_time = step;
	if (is_swinging) {
		update_constants(0);
	}
}

StemGrades MotionPage::grades(int begin) {
	int next = stem_columns(whole.modes, keeps_directions);
	const auto take = [&] { return column(next++) + begin; };
	StemGrades to = {};
	to.dead_ease = take();
	to.air_ease = take();
	for (int k = 0; k < kind.stem.modes; k++) {
		for (float *&one : to.by_height[k]) {
			one = take();
		}
	}
	return to;
}

void MotionPage::update_stems(int begin, int end) {
	const bool is_all = begin == 0 && end == size();
	stems = stem_step_constants(kind.stem, step_time, kind.joint.above_ground);
	stem_scales(kind.stem, lengths() + begin, end - begin, column(LOAD_SCALE) + begin);
	const float *scales = column(LOAD_SCALE);
	max_load_scale = is_all ? 0.0f : max_load_scale;
	if (is_graded()) {
		const StemGrades own = grades(begin);
		const float quick =
				stem_grades(kind.stem, step_time, { lengths() + begin, owns.data() + begin, end - begin }, own);
		fastest = is_all ? quick : std::max(fastest, quick);
		stems.softness *= fastest * fastest;
		for (int i = begin; i < end; i++) {
			const float ease = std::max(own.dead_ease[i - begin], own.air_ease[i - begin]);
			max_load_scale = std::max(max_load_scale, scales[i] * std::max(ease, 1.0f));
		}
	}
	max_load_scale = std::accumulate(
			scales + begin, scales + end, max_load_scale, [](float max, float scale) { return std::max(max, scale); });
}

void MotionPage::update_constants(int begin, int end) {
	if (kind.law == Law::elasticity) {
		elasticity = elasticity_constants(kind.joint, step_time);
		elasticity_weights(kind.joint, step_time, lengths() + begin, end - begin, column(WEIGHT) + begin);
	} else if (kind.law == Law::stem) {
		update_stems(begin, end);
	} else {
		spring = spring_constants(kind.joint, step_time);
		spring_gains(spring, lengths() + begin, end - begin, column(WIND_GAIN) + begin);
	}
}

ElasticityPage MotionPage::elasticity_page(int begin) {
	ElasticityPage page;
	page.x = column(X) + begin;
	page.y = column(Y) + begin;
	page.z = column(Z) + begin;
	page.turn_x = column(TURN_X) + begin;
	page.turn_y = column(TURN_Y) + begin;
	page.turn_z = column(TURN_Z) + begin;
	page.weight = column(WEIGHT) + begin;
	page.lift_share = elasticity.lift_share;
	page.wind_share = elasticity.wind_share;
	page.keep = elasticity.keep;
	page.lowest_y = elasticity.lowest_y;
	return page;
}

SpringPage MotionPage::spring_page(int begin) {
	SpringPage page;
	page.x = column(FLAT_X) + begin;
	page.z = column(FLAT_Z) + begin;
	page.rate_x = column(FLAT_RATE_X) + begin;
	page.rate_z = column(FLAT_RATE_Z) + begin;
	page.rest_x = column(REST_X) + begin;
	page.rest_z = column(REST_Z) + begin;
	page.wind_gain = column(WIND_GAIN) + begin;
	page.place_from_place = spring.place_from_place;
	page.place_from_rate = spring.place_from_rate;
	page.rate_from_place = spring.rate_from_place;
	page.rate_from_rate = spring.rate_from_rate;
	page.max = MAX_GNOMONIC;
	return page;
}

StemPage MotionPage::stem_page(int begin) {
	StemPage page = {};
	for (int k = 0; k < kind.stem.modes; k++) {
		const int first = first_of_mode(k);
		page.x[k] = column(first) + begin;
		page.z[k] = column(first + 1) + begin;
		page.rate_x[k] = column(first + 2) + begin;
		page.rate_z[k] = column(first + 3) + begin;
	}
	page.rest_x = column(STEM_REST_X) + begin;
	page.rest_z = column(STEM_REST_Z) + begin;
	page.scale = column(LOAD_SCALE) + begin;
	if (is_graded()) {
		const StemGrades own = grades(begin);
		page.dead_ease = own.dead_ease;
		page.air_ease = own.air_ease;
		for (int k = 0; k < kind.stem.modes; k++) {
			std::copy_n(own.by_height[k], 4, page.by_height[k]);
		}
	}
	page.max_scale = max_load_scale > 0.0f ? max_load_scale : 1.0f;
	page.max_lean = max_lean;
	page.step = stems;
	return page;
}

void MotionPage::prefetch() const {
#if defined(__GNUC__)
	constexpr int FLOATS = 64; // Of each column: enough for the processor's own prefetching to continue.
	for (int i = ROOT_X; is_swinging && i < SWINGING_COLUMNS; i++) {
		for (int j = 0; j < FLOATS; j += 16) {
			__builtin_prefetch(column(i) + j);
		}
	}
#endif
}

/// Stores the direction before a step for drawing.
void MotionPage::remember() {
	const auto copy = [this](int from, int to) { std::copy(column(from), column(from) + size(), column(to)); };
	if (kind.law == Law::elasticity) {
		copy(X, LAST_X);
		copy(Y, LAST_Y);
		copy(Z, LAST_Z);
	} else if (kind.law == Law::stem) {
		for (int k = 0; k < kind.stem.modes; k++) {
			copy(first_of_mode(k), last_of_mode(kind.stem.modes, k));
			copy(first_of_mode(k) + 1, last_of_mode(kind.stem.modes, k) + 1);
		}
	} else {
		copy(FLAT_X, FLAT_LAST_X);
		copy(FLAT_Z, FLAT_LAST_Z);
	}
}

/// Period (s) of the fastest plant in the fastest of its modes.
float MotionPage::quickest_swing() const {
	if (kind.law == Law::stem) {
		const float frequency = kind.stem.mode[kind.stem.modes - 1].frequency * fastest;
		return static_cast<float>(2.0 * PI) / frequency;
	}
	return kind.law == Law::spring ? 1.0f / kind.joint.natural_frequency : swing_of(kind.joint, kind.shortest);
}

void MotionPage::sample_air_ahead(
		const FieldWind &wind, const PlantWinds &along, double moment, int turn, SimdLevel level) {
	const AirAhead::Plants plants = { column(ROOT_X), column(ROOT_Z), lengths(), size(), kind.canopy_height,
		quickest_swing(), taller };
	ahead.prepare(wind, along, moment, step_time, turn, plants, level);
}

/// Stems are perfectly plastic beyond the yield: what is beyond it lasts.
void MotionPage::lodge(int begin, int count) {
	const float yield = kind.trampling.yield;
	if (!(yield > 0.0f)) {
		return;
	}
	const bool has_two = kind.stem.modes == 2;
	const float slope = kind.stem.mode[0].tip_slope;
	const float second_slope = has_two ? kind.stem.mode[1].tip_slope : 0.0f;
	const float *x = column(first_of_mode(0)) + begin;
	const float *z = column(first_of_mode(0) + 1) + begin;
	const float *second_x = has_two ? column(first_of_mode(1)) + begin : x;
	const float *second_z = has_two ? column(first_of_mode(1) + 1) + begin : z;
	const auto tip_x = [&](int i) { return slope * x[i] + second_slope * second_x[i]; };
	const auto tip_z = [&](int i) { return slope * z[i] + second_slope * second_z[i]; };
	uint32_t is_any = 0;
	for (int i = 0; i < count; i++) { // Without branches, so that it is vectorised.
		is_any |= tip_x(i) * tip_x(i) + tip_z(i) * tip_z(i) > yield * yield ? 1u : 0u;
	}
	has_yielded = has_yielded || (is_any != 0u && !lasting.has_room());
	for (int i = 0; is_any != 0u && lasting.has_room() && i < count; i++) {
		const glm::vec2 now = lasting.at(begin + i);
		const glm::vec2 elastic = glm::vec2(tip_x(i), tip_z(i)) - now;
		const float size = glm::length(elastic);
		if (size > yield) {
			lasting.set(begin + i, now + elastic * (1.0f - yield / size));
		}
	}
}

void MotionPage::carry(const Precipitation &precipitation) {
	if (precipitation == load || !is_swinging || kind.law != Law::stem) {
		return;
	}
	load = precipitation;
	if (unloaded.empty()) {
		unloaded.push_back(whole);
	}
	const StemConstants bare = unloaded.front();
	whole = loaded_stem(bare, load);
	kind.stem = modes() == whole.modes ? whole : in_one_mode(whole);
	weight = { slope_of_load(bare, load), bare.axial_share };
	if (!load.has_load()) {
		unloaded.clear();
	}
	update_constants(0);
	if (!has_stepped) {
		settle_under_weight(0, size());
	}
}

/// Returns false if all plants return to their rest.
bool MotionPage::find_calm_bends(
		const KernelSet &set, const StemPage &block, int begin, int count, const CalmBends &calm) const {
	const bool is_any = lasting.is_any(begin, count);
	if (!is_any && weight.is_none()) {
		return false;
	}
	if (weight.is_none()) {
		std::fill_n(calm.x, count, 0.0f);
		std::fill_n(calm.z, count, 0.0f);
	} else {
		set.weigh_stems(block, column(ROOT_X) + begin, column(ROOT_Z) + begin, count, weight, calm.x, calm.z);
	}
	for (int i = 0; is_any && i < count; i++) {
		const glm::vec2 bend = lasting.at(begin + i);
		calm.x[i] += bend.x;
		calm.z[i] += bend.y;
	}
	return true;
}

glm::vec2 MotionPage::nod(int row) {
	if (!is_swinging || kind.law != Law::stem || kind.stem.nod.share == 0.0f) {
		return glm::vec2(0.0f);
	}
	const StemPage page = stem_page(0);
	const glm::vec2 rest(page.rest_x[row], page.rest_z[row]);
	const float lean = 2.0f / (1.0f + glm::dot(rest, rest));
	const float scale = page.scale[row] * (page.air_ease ? page.air_ease[row] : 1.0f);
	return rest * (0.5f * scale * lean * page.step.nod.share / (1.0f + scale * page.step.nod.ease * (2.0f - lean)));
}

static bool is_still(const StemState &state) {
	return glm::length(state.rate[0]) + glm::length(state.rate[1]) <= MAX_REST_RATE;
}

bool MotionPage::is_at_rest(int index) {
	const TipState tip = state(index);
	if (kind.law != Law::stem || !is_swinging) {
		return glm::length(tip.rate) <= MAX_REST_RATE && glm::distance(tip.direction, rest(index)) < MAX_REST_ERROR;
	}
	StemState calm;
	divide_tip(kind.stem, nod(index), calm.place);
	calm = safe_stem(kind.stem, calm);
	const StemState now = stem(index);
	return is_still(now) && weight.is_none() && lasting.at(index) == glm::vec2(0.0f) &&
			glm::distance(tip_bend(kind.stem, now), tip_bend(kind.stem, calm)) < MAX_REST_ERROR;
}

/// Plants from `begin` to `end` that do not move and are straight, or have the bend of their own weight alone, begin
/// with the bend under all weights.
void MotionPage::settle_under_weight(int begin, int end) {
	constexpr int TRIES = 64;
	const bool nods = kind.law == Law::stem && max_lean > 0.0f && kind.stem.nod.share != 0.0f;
	if (!is_swinging || (weight.is_none() && !nods)) {
		return;
	}
	const KernelSet &set = kernels(best_simd_level());
	float share[MAX_STEM_MODES];
	write_shares(kind.stem, share);
	for (int row = begin; row < end; row++) {
		StemState state = stem(row);
		const glm::vec2 own = nod(row);
		const glm::vec2 tip = tip_bend(kind.stem, state);
		const bool begins = is_still(state) && std::min(glm::length(tip), glm::length(tip - own)) < MAX_REST_ERROR;
		for (int i = 0; begins && i < (weight.is_none() ? 1 : TRIES); i++) {
			glm::vec2 bend(0.0f);
			if (!weight.is_none()) {
				set.weigh_stems(stem_page(row), roots_x() + row, roots_z() + row, 1, weight, &bend.x, &bend.y);
			}
			for (int k = 0; k < kind.stem.modes; k++) {
				state.place[k] = share[k] * (bend + own);
			}
			put_stem(row, state);
		}
		if (begins) {
			set_stem(row, state);
			set_before(row, direction(row));
			set_stem_before(row, stem(row));
		}
	}
}

void MotionPage::step_block(const KernelSet &set, int begin, int count, const PlantWinds &winds, const PlantAir &air) {
	Bend *block_pairs = keeps_directions ? nullptr : pairs.data() + 2 * static_cast<std::size_t>(begin);
	if (kind.law == Law::elasticity) {
		const ElasticityPage block = elasticity_page(begin);
		air.x ? set.step_elasticity_in_air(block, count, air) : set.step_elasticity(block, count, winds);
		if (block_pairs) {
			set.encode_elasticity(block.x, block.y, block.z, count, block_pairs);
		}
	} else if (kind.law == Law::stem) {
		const StemPage block = stem_page(begin);
		float calm_x[BlockWind::PLANTS];
		float calm_z[BlockWind::PLANTS];
		CalmBends calm = { calm_x, calm_z, {} };
		const bool has_calm = find_calm_bends(set, block, begin, count, calm);
		set.step_stem(block, count, winds, air);
		if (has_calm) {
			write_shares(kind.stem, calm.share);
			set.move_calm(block, count, calm);
			set.lift_stems(block, count);
		}
		lodge(begin, count);
		if (easing > 0.0f && modes() == 2) {
			ease_modes(begin, count);
		}
		if (block_pairs) {
			Bend *seconds = second_pairs.empty() ? nullptr : second_pairs.data() + 2 * static_cast<std::size_t>(begin);
			set.encode_stem(block, count, block_pairs, seconds);
		}
	} else {
		const SpringPage block = spring_page(begin);
		air.x ? set.step_spring_in_air(block, count, air) : set.step_spring(block, count, winds);
		if (block_pairs) {
			set.encode_spring(block.x, block.z, count, block_pairs);
		}
	}
}

void MotionPage::step(const WindSnapshot &wind, const PlantWinds &along, SimdLevel level) {
	const KernelSet &set = kernels(level);
	carry(rounded(wind.precipitation));
	has_stepped = true;
	if (keeps_directions) {
		remember();
	}
	const float drag = air_drag(kind.joint);
	const float slowing = step_time * drag * kind.joint.wind_weight / kind.joint.mass;
	const bool has_stems = kind.law == Law::stem;
	const PageWind over = { wind, along, ahead, column(ROOT_X), column(ROOT_Y), column(ROOT_Z), lengths(), box_low,
		box_high, kind.canopy_height, taller, drag, has_stems, level };
	BlockWind block;
	for (int begin = 0; begin < size(); begin += BlockWind::PLANTS) {
		const int count = std::min(BlockWind::PLANTS, size() - begin);
		over.sample(begin, count, block);
		const PlantWinds winds = { block.has_newtons ? block.strengths : nullptr, along.x, along.z };
		PlantAir air = { nullptr, nullptr, nullptr, lengths() + begin, drag, slowing, 1.0f / step_time };
		if (block.has_air) {
			air.x = block.x;
			air.y = block.is_pressed ? block.y : nullptr;
			air.z = block.z;
		}
		step_block(set, begin, count, winds, air);
	}
	easing = 0.0f;
	if (lasting.is_any()) {
		lasting.shrink(kind.trampling.kept(step_time));
	}
}

void MotionPage::interpolate(float alpha, glm::vec3 *out) const {
	static_assert(sizeof(glm::vec3) == 3 * sizeof(float), "the kernels write three floats for each plant");
	if (size() == 0 || !keeps_directions) {
		return;
	}
	const auto at = [this](int which) { return column(which); };
	const KernelSet &set = kernels(best_simd_level());
	if (kind.law == Law::elasticity) {
		const DirectionView view = { at(X), at(Y), at(Z), at(LAST_X), at(LAST_Y), at(LAST_Z) };
		set.interpolate_elasticity(view, size(), alpha, &out->x);
	} else if (kind.law == Law::stem) {
		for (int i = 0; i < size(); i++) {
			const StemState last = stem_before(i);
			StemState shown = stem(i);
			for (int k = 0; k < kind.stem.modes; k++) {
				shown.place[k] = glm::mix(last.place[k], shown.place[k], alpha);
			}
			out[i] = turned(from_stereographic(tip_bend(kind.stem, shown)), rest_bend(i));
		}
	} else {
		const GnomonicView view = { at(FLAT_X), at(FLAT_Z), at(FLAT_LAST_X), at(FLAT_LAST_Z) };
		set.interpolate_spring(view, size(), alpha, &out->x);
	}
}

} // namespace undergrowth
