#include "motion/batch.hpp"

#include "motion/gnomonic.hpp"
#include "motion/joint_constants.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

/// Both laws' tables start with this column, 1/(m·L).
constexpr int BLOW_GAIN = 0;

/// Columns of a batch of the elasticity law.
enum ElasticityColumn : int {
	X = 1,
	Y,
	Z,
	TURN_X,
	TURN_Y,
	TURN_Z,
	LAST_X,
	LAST_Y,
	LAST_Z,
	LIFT,
	WEIGHT,
	WIND_GAIN,
	KEEP,
	LOWEST_Y,
	ELASTICITY_COLUMNS,
};

/// Columns of a batch of the spring law.
enum SpringColumn : int {
	FLAT_X = 1,
	FLAT_Z,
	FLAT_RATE_X,
	FLAT_RATE_Z,
	FLAT_LAST_X,
	FLAT_LAST_Z,
	REST_X,
	REST_Z,
	FLAT_WIND_GAIN,
	PLACE_FROM_PLACE,
	PLACE_FROM_RATE,
	RATE_FROM_PLACE,
	RATE_FROM_RATE,
	SPRING_COLUMNS,
};

int column_count(Law law) {
	return law == Law::elasticity ? static_cast<int>(ELASTICITY_COLUMNS) : static_cast<int>(SPRING_COLUMNS);
}

constexpr float MAX_FORCE = 1e9f; // N.

float safe_force(float force) {
	return std::isfinite(force) ? std::clamp(force, -MAX_FORCE, MAX_FORCE) : 0.0f;
}

KernelWind kernel_wind(const glm::vec3 &wind) {
	KernelWind safe = { safe_force(wind.x), safe_force(wind.y), safe_force(wind.z), 0.0f };
	safe.size = std::sqrt(safe.x * safe.x + safe.y * safe.y + safe.z * safe.z);
	return safe;
}

} // namespace

PendulumBatch::PendulumBatch(Law law, float step) : batch_law(law), step_time(step), columns(column_count(law)) {}

Law PendulumBatch::law() const {
	return batch_law;
}

float PendulumBatch::step_length() const {
	return step_time;
}

int PendulumBatch::size() const {
	return columns.size();
}

int PendulumBatch::add(const Joint &joint, const TipState &state) {
	const int index = columns.add_row();
	set_joint(index, joint);
	set_state(index, state);
	return index;
}

void PendulumBatch::remove(int index) {
	columns.remove_row(index);
}

void PendulumBatch::set_joint(int index, const Joint &joint) {
	const Joint safe = safe_joint(joint);
	columns.column(BLOW_GAIN)[index] = 1.0f / (safe.mass * safe.length);
	if (batch_law == Law::elasticity) {
		const ElasticityConstants constants = elasticity_constants(safe, step_time);
		columns.column(LIFT)[index] = constants.lift;
		columns.column(WEIGHT)[index] = constants.weight;
		columns.column(WIND_GAIN)[index] = constants.wind_gain;
		columns.column(KEEP)[index] = constants.keep;
		columns.column(LOWEST_Y)[index] = constants.lowest_y;
		return;
	}
	const SpringConstants constants = spring_constants(safe, step_time);
	columns.column(REST_X)[index] = constants.rest_x;
	columns.column(REST_Z)[index] = constants.rest_z;
	columns.column(FLAT_WIND_GAIN)[index] = constants.wind_gain;
	columns.column(PLACE_FROM_PLACE)[index] = constants.place_from_place;
	columns.column(PLACE_FROM_RATE)[index] = constants.place_from_rate;
	columns.column(RATE_FROM_PLACE)[index] = constants.rate_from_place;
	columns.column(RATE_FROM_RATE)[index] = constants.rate_from_rate;
}

TipState PendulumBatch::state(int index) const {
	const auto at = [this, index](int which) { return columns.column(which)[index]; };
	if (batch_law == Law::elasticity) {
		return safe_state({ { at(X), at(Y), at(Z) }, glm::vec3(at(TURN_X), at(TURN_Y), at(TURN_Z)) / step_time });
	}
	return from_gnomonic({ at(FLAT_X), at(FLAT_Z), at(FLAT_RATE_X), at(FLAT_RATE_Z) });
}

void PendulumBatch::set_state(int index, const TipState &state) {
	if (batch_law == Law::elasticity) {
		set_elasticity_state(index, state);
		const ElasticityTable table = elasticity_table();
		table.last_x[index] = table.x[index];
		table.last_y[index] = table.y[index];
		table.last_z[index] = table.z[index];
		return;
	}
	set_spring_state(index, state);
	const SpringTable table = spring_table();
	table.last_x[index] = table.x[index];
	table.last_z[index] = table.z[index];
}

void PendulumBatch::apply_impulse(int index, const glm::vec3 &impulse) {
	TipState blown = state(index);
	blown.rate += impulse * columns.column(BLOW_GAIN)[index];
	if (batch_law == Law::elasticity) {
		set_elasticity_state(index, blown);
	} else {
		set_spring_state(index, blown);
	}
}

void PendulumBatch::step(int begin, int end, const glm::vec3 &wind, SimdLevel level) {
	const int first = std::max(begin, 0);
	const int last = std::min(end, size());
	if (batch_law == Law::elasticity) {
		kernels(level).step_elasticity(elasticity_table(), first, last, kernel_wind(wind));
	} else {
		kernels(level).step_spring(spring_table(), first, last, MAX_GNOMONIC, kernel_wind(wind));
	}
}

void PendulumBatch::step(const glm::vec3 &wind) {
	step(0, size(), wind, best_simd_level());
}

void PendulumBatch::interpolate(float alpha, glm::vec3 *out) const {
	static_assert(sizeof(glm::vec3) == 3 * sizeof(float), "the kernels write three floats for each plant");
	if (size() == 0) {
		return;
	}
	const auto at = [this](int which) { return columns.column(which); };
	const KernelSet &set = kernels(best_simd_level());
	if (batch_law == Law::elasticity) {
		const DirectionView view = { at(X), at(Y), at(Z), at(LAST_X), at(LAST_Y), at(LAST_Z) };
		set.interpolate_elasticity(view, size(), alpha, &out->x);
	} else {
		const GnomonicView view = { at(FLAT_X), at(FLAT_Z), at(FLAT_LAST_X), at(FLAT_LAST_Z) };
		set.interpolate_spring(view, size(), alpha, &out->x);
	}
}

ElasticityTable PendulumBatch::elasticity_table() {
	const auto at = [this](int which) { return columns.column(which); };
	return { at(X), at(Y), at(Z), at(TURN_X), at(TURN_Y), at(TURN_Z), at(LAST_X), at(LAST_Y), at(LAST_Z), at(LIFT),
		at(WEIGHT), at(WIND_GAIN), at(KEEP), at(LOWEST_Y) };
}

SpringTable PendulumBatch::spring_table() {
	const auto at = [this](int which) { return columns.column(which); };
	return { at(FLAT_X), at(FLAT_Z), at(FLAT_RATE_X), at(FLAT_RATE_Z), at(FLAT_LAST_X), at(FLAT_LAST_Z), at(REST_X),
		at(REST_Z), at(FLAT_WIND_GAIN), at(PLACE_FROM_PLACE), at(PLACE_FROM_RATE), at(RATE_FROM_PLACE),
		at(RATE_FROM_RATE) };
}

void PendulumBatch::set_elasticity_state(int index, const TipState &state) {
	const TipState safe = safe_state(state);
	const ElasticityTable table = elasticity_table();
	table.x[index] = safe.direction.x;
	table.y[index] = safe.direction.y;
	table.z[index] = safe.direction.z;
	table.turn_x[index] = safe.rate.x * step_time;
	table.turn_y[index] = safe.rate.y * step_time;
	table.turn_z[index] = safe.rate.z * step_time;
}

void PendulumBatch::set_spring_state(int index, const TipState &state) {
	const GnomonicState flat = to_gnomonic(state);
	const SpringTable table = spring_table();
	table.x[index] = flat.x;
	table.z[index] = flat.z;
	table.rate_x[index] = flat.rate_x;
	table.rate_z[index] = flat.rate_z;
}

} // namespace undergrowth
