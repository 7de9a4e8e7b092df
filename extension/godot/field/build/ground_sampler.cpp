#include "field/build/ground_sampler.hpp"

#include "field/build/build_input.hpp"
#include "field/build/field_ground.hpp"
#include "base/messages.hpp"
#include "base/stopwatch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

using namespace godot;

namespace undergrowth {

// Time per frame: a fraction of the frame's duration, within these limits.
static constexpr double MIN_QUERY_USEC = 3000.0;
static constexpr double MAX_QUERY_USEC = 50000.0;
static constexpr double ASKING_SHARE = 0.2;
static constexpr double MAX_POINTS_PER_PLANT = 0.7; // With more, a grid saves nothing.
static constexpr int PLANTS_AT_ONCE = 4096; // For work without queries.
static constexpr int MAX_PLACES = 256; // Per measure().
static const glm::vec3 UP = { 0.0f, 1.0f, 0.0f };

void GroundSampler::enter(Phase into) {
	phase = into;
	next = 0;
}

void GroundSampler::begin(const FieldPlants &plants) {
	heights.assign(size_t(plants.size()), NAN);
	normals.assign(size_t(plants.size()), UP);
	enter(grid_spacing > 0.0f && grid.prepare(plants, grid_spacing) ? Phase::marking : Phase::finding);
}

void GroundSampler::mark(const FieldPlants &plants) {
	const int end = std::min(next + PLANTS_AT_ONCE, plants.size());
	grid.mark(plants, next, end);
	next = end;
	if (next == plants.size()) {
		point_count = grid.list_points();
		uses_grid = point_count <= MAX_POINTS_PER_PLANT * plants.size();
		enter(uses_grid ? Phase::sampling : Phase::finding);
	}
}

bool GroundSampler::sample() {
	std::array<glm::vec2, MAX_PLACES> places;
	std::array<float, MAX_PLACES> found;
	const int count = std::min({ query->max_places(), MAX_PLACES, point_count - next });
	for (int i = 0; i < count; i++) {
		places[size_t(i)] = grid.point(next + i);
	}
	if (!query->measure(places.data(), count, found.data(), nullptr)) {
		return false;
	}
	for (int i = 0; i < count; i++) {
		grid.set_height(next + i, found[size_t(i)]);
	}
	next += count;
	if (next == point_count) {
		enter(Phase::finding);
	}
	return true;
}

void GroundSampler::find(const FieldPlants &plants) {
	const int end = std::min(next + PLANTS_AT_ONCE, plants.size());
	for (; next < end; next++) {
		const size_t i = size_t(next);
		if (!uses_grid || !grid.find(plants.x[i], plants.z[i], heights[i], normals[i])) {
			single.push_back(next);
		} else if (std::isfinite(heights[i])) {
			found_count++;
		}
	}
	if (next == plants.size()) {
		enter(Phase::querying);
	}
}

bool GroundSampler::query_some(const FieldPlants &plants) {
	std::array<glm::vec2, MAX_PLACES> places;
	std::array<float, MAX_PLACES> found;
	std::array<glm::vec3, MAX_PLACES> up;
	up.fill(UP);
	const int count = std::min({ query->max_places(), MAX_PLACES, int(single.size()) - next });
	for (int i = 0; i < count; i++) {
		const size_t plant = size_t(single[size_t(next + i)]);
		places[size_t(i)] = { plants.x[plant], plants.z[plant] };
	}
	if (count > 0 && !query->measure(places.data(), count, found.data(), up.data())) {
		return false;
	}
	for (int i = 0; i < count; i++) {
		const size_t plant = size_t(single[size_t(next + i)]);
		heights[plant] = found[size_t(i)];
		normals[plant] = up[size_t(i)];
		found_count += std::isfinite(heights[plant]) ? 1 : 0;
	}
	next += count;
	if (next == int(single.size())) {
		enter(Phase::done);
	}
	return true;
}

bool GroundSampler::resume_part(const FieldPlants &plants) {
	switch (phase) {
		case Phase::fresh:
			begin(plants);
			return true;
		case Phase::marking:
			mark(plants);
			return true;
		case Phase::sampling:
			return sample();
		case Phase::finding:
			find(plants);
			return true;
		case Phase::querying:
			return query_some(plants);
		case Phase::done:
			break;
	}
	return true;
}

GroundSampler::State GroundSampler::resume(const FieldPlants &plants, double usec) {
	const Stopwatch watch;
	const GroundQuery::State found = query->begin();
	if (found != GroundQuery::State::ready) {
		return found == GroundQuery::State::failed ? State::failed : State::in_progress;
	}
	while (phase != Phase::done) {
		if (!resume_part(plants)) {
			return State::failed;
		}
		if (watch.usec() > usec) {
			break;
		}
	}
	return phase == Phase::done ? State::done : State::in_progress;
}

double GroundQueryQueue::usual_usec(double delta) {
	return std::clamp(1e6 * ASKING_SHARE * delta, MIN_QUERY_USEC, MAX_QUERY_USEC);
}

GroundSampler::State GroundQueryQueue::resume(
		const FieldPlants &plants, Node3D *field, const FieldProperties &options, double usec, bool physics) {
	if (!sampler) {
		std::unique_ptr<GroundQuery> query = query_ground(field, options);
		sampler = query ? std::make_unique<GroundSampler>(std::move(query), float(options.ground_sample_spacing))
						: nullptr;
	}
	if (!sampler) {
		FieldGround ground;
		why = read_ground(field, options, ground);
		return GroundSampler::State::failed;
	}
	if (sampler->is_of_physics() != physics) {
		return GroundSampler::State::in_progress;
	}
	const GroundSampler::State state = sampler->resume(plants, usec);
	why = sampler->fault();
	return state;
}

void GroundQueryQueue::report_no_ground(const FieldPlants &plants, const Node3D *field) {
	const bool is_missed = !sampler->has_found_any() && plants.size() > 0;
	if (is_missed && missing.is_empty()) {
		report_warning(field, sampler->advice());
	}
	missing = is_missed ? sampler->advice() : String();
}

void GroundQueryQueue::note_ground(const FieldPlants &plants) {
	has_found_some = has_found_some || sampler->has_found_any();
	if (plants.size() > 0) {
		unreported = sampler->advice();
	}
}

void GroundQueryQueue::take_findings(GroundQueryQueue &other) {
	has_found_some = std::exchange(other.has_found_some, false) || has_found_some;
	const String others = std::exchange(other.unreported, String());
	if (unreported.is_empty()) {
		unreported = others;
	}
}

void GroundQueryQueue::report_all(const Node3D *field) {
	missing = has_found_some ? String() : unreported;
	if (!missing.is_empty()) {
		report_warning(field, missing);
	}
	unreported = String();
	has_found_some = false;
}

} // namespace undergrowth
