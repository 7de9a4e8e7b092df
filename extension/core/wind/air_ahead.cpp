#include "wind/air_ahead.hpp"

#include "wind/field_wind.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

/// Number of plants that are sampled together.
constexpr int BLOCK = 512;
/// Of a step: a moment farther than this from the end of the last step is a jump in time.
constexpr double SAME_MOMENT = 0.25;

uint32_t in_word(double low, double high) {
	const auto part = [](double weight) { return static_cast<uint32_t>(std::lround(4096.0 * weight)) & 0xffffu; };
	return part(low) | (part(high) << 16);
}

/// Keys' cubic at the fraction t between the second sample and the third.
AirWeights weights_at(double t) {
	const double first = t * (-0.5 + t * (1.0 - 0.5 * t));
	const double second = 1.0 + t * t * (1.5 * t - 2.5);
	const double third = t * (0.5 + t * (2.0 - 1.5 * t));
	return { in_word(first, second), in_word(third, 1.0 - first - second - third), 0.0f, 0.0f };
}

} // namespace

int AirAhead::stride_in(const Air &air, float step, float swing, float canopy_height) {
	constexpr double STILL = 1e-6; // m/s.
	constexpr double ROUNDING = 1e-3; // Of a step.
	double spacing = std::min(SPACING, SWING_SHARE * static_cast<double>(swing));
	const double carried = std::max(canopy_height > 0.0f ? canopy_pattern_speed(air) : turbulence_speed(air), STILL);
	spacing = std::min(spacing, TRAVEL / carried);
	if (canopy_height > 0.0f && air.canopy_wave_amount > 0.0f && air.canopy_height > 0.0f) {
		spacing = std::min(spacing, WAVES_SHARE * waves_length(air) / carried);
	}
	const double steps = spacing / static_cast<double>(step) + ROUNDING;
	return static_cast<int>(std::clamp(steps, 1.0, static_cast<double>(MAX_STEPS)));
}

void AirAhead::make_room(int plants) {
	const int wanted = (plants + AIR_GROUP - 1) / AIR_GROUP;
	if (wanted > room) {
		// Without initial values, so that the sampling threads touch the memory first.
		groups.reset(new uint32_t[AIR_GROUP_WORDS * static_cast<std::size_t>(wanted)]);
		room = wanted;
		forget();
	}
}

void AirAhead::prepare(const FieldWind &wind, const PlantWinds &along, double moment, float step, int turn,
		const Plants &plants, SimdLevel level) {
	const auto length = static_cast<double>(step);
	const bool blows = wind.wind.kind == WindKind::air && wind.tiles && wind.air.speed > 0.0f;
	const int steps = blows ? stride_in(wind.air, step, plants.swing, plants.canopy_height) : 1;
	is_sampled = steps > 1 && plants.count <= AIR_GROUP * room;
	if (!is_sampled) {
		is_known = false;
		return;
	}
	const bool goes_on = std::fabs(moment - last_moment - length) < SAME_MOMENT * length;
	is_known = is_known && goes_on && steps == stride && step == step_time;
	age = is_known ? age + 1 : turn % steps;
	const int first = is_known ? 2 : -1; // The first sample to take.
	const int last = is_known && age < steps ? 1 : 2;
	age = age < steps ? age : 0;
	stride = steps;
	step_time = step;
	last_moment = moment;
	has_canopy = plants.canopy_height > 0.0f;
	is_known = true;
	float x[BLOCK], z[BLOCK];
	for (int sample = first; sample <= last; sample++) {
		WindSnapshot then = {};
		then.air = air_at_time(wind.air, wind.axes, wind.tiles.get(), moment + length * (sample * stride - age));
		AirMoments moments = moments_among(then.air, plants.canopy_height, plants.taller, along);
		moments.mean = 0.0f; // Above a canopy interpolate() adds it; isolated plants use another member.
		for (int begin = 0; begin < plants.count; begin += BLOCK) {
			const int some = std::min(BLOCK, plants.count - begin);
			const float *alone = has_canopy ? nullptr : plants.lengths + begin;
			sample_air(then, moments, plants.x + begin, plants.z + begin, alone, some, x, z, level);
			wind_kernels(level).keep_samples(x, z, some, groups.get() + 4 * begin);
		}
	}
}

void AirAhead::interpolate(
		const AirMoments &moments, int begin, int count, float *out_x, float *out_z, SimdLevel level) const {
	AirWeights weights = weights_at(static_cast<double>(age) / static_cast<double>(stride));
	weights.x = has_canopy ? moments.mean * moments.along_x : 0.0f;
	weights.z = has_canopy ? moments.mean * moments.along_z : 0.0f;
	wind_kernels(level).between_samples(groups.get() + 4 * begin, weights, count, out_x, out_z);
}

std::size_t AirAhead::bytes() const {
	return AIR_GROUP_WORDS * sizeof(uint32_t) * static_cast<std::size_t>(room);
}

} // namespace undergrowth
