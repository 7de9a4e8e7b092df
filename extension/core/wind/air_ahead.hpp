#pragma once

#include "wind/air.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace undergrowth {

struct FieldWind;

/// Samples the air at the plants of a page ahead of the steps, and interpolates between four samples with the cubic of
/// Keys (1981, a = -1/2).
///
/// Above a canopy the mean wind is that of each step. All other parts of a changed wind arrive within two samples.
class AirAhead {
public:
	/// Maximum sample spacing as a fraction of a plant's period. Interpolation preserves 97 % of the amplitude at that
	/// period; the response of plants to shorter periods is small.
	static constexpr double SWING_SHARE = 0.2;
	/// The same as a fraction of the period of waves; preserves 95 % of their amplitude.
	static constexpr double WAVES_SHARE = 0.25;
	/// Maximum distance (m) that the patterns travel between samples: a texel of turbulence. The error of tips is then
	/// a few hundredths of their motion, in gales too.
	static constexpr double TRAVEL = 0.25;
	static constexpr double SPACING = 4.0 / 60.0; ///< s, maximum.
	static constexpr int MAX_STEPS = 4; ///< Maximum number of steps between samples.

	/// The plants to sample for.
	struct Plants {
		const float *x, *z; ///< m.
		const float *lengths; ///< m.
		int count;
		float canopy_height; ///< m; 0: isolated plants.
		float swing; ///< s, period of the fastest plant.
		TallerPlants taller = {};
	};

	AirAhead() = default;
	AirAhead(AirAhead &&) = default;
	AirAhead &operator=(AirAhead &&) = default;
	/// A copy starts without samples.
	AirAhead(const AirAhead &) {}
	AirAhead &operator=(const AirAhead &) { return *this = AirAhead(); }

	/// Reserves room for `plants`. Allocates only when the number exceeds all earlier ones.
	void make_room(int plants);
	/// Discards the samples: the plants changed.
	void forget() { is_known = is_sampled = false; }

	/// Prepares a step of `step` seconds at the time `moment` (s), in the axes of `along`. Takes a sample in one of
	/// stride_in() steps; `turn` selects which one.
	void prepare(const FieldWind &wind, const PlantWinds &along, double moment, float step, int turn,
			const Plants &plants, SimdLevel level = best_simd_level());
	/// True if interpolate() can interpolate the air of the last prepare(). False if each step must sample.
	bool is_ready() const { return is_sampled; }
	/// Like sample_air() for plants from `begin` on, a multiple of AIR_GROUP, without triggered gusts.
	void interpolate(const AirMoments &moments, int begin, int count, float *out_x, float *out_z,
			SimdLevel level = best_simd_level()) const;
	/// Steps from one sample to the next in `air`; 1: each step samples.
	static int stride_in(const Air &air, float step, float swing, float canopy_height);

	std::size_t bytes() const;

private:
	std::unique_ptr<uint32_t[]> groups; ///< In the layout of WindKernels.
	int room = 0; ///< In groups.
	bool is_known = false;
	bool is_sampled = false;
	bool has_canopy = false;
	int stride = 1;
	int age = 0; ///< Steps since the second sample.
	float step_time = 0.0f; ///< s.
	double last_moment = 0.0; ///< s.
};

} // namespace undergrowth
