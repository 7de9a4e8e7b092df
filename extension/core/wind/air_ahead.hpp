#pragma once

#include "wind/wind_kernels.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace undergrowth {

struct Air;
struct FieldWind;

/// Air at the plants of a page, sampled now and then and ahead of the steps: between samples it goes along the cubic of
/// Keys (1981, a = -1/2) through four of them, as smoothly as plants follow.
///
/// Over a stand, the mean wind is that of each step. What blows otherwise changes, when the wind does, within the time
/// of two samples.
class AirAhead {
public:
	/// Samples are no farther apart than such a share of a plant's swing, of whose amplitude 97 % are left then; beyond
	/// it plants answer to less and less.
	static constexpr double SWING_SHARE = 0.2;
	/// Of the time in which one wave goes over a plant: 95 % of the waves' amplitude are left.
	static constexpr double WAVES_SHARE = 0.25;
	static constexpr double SPACING = 4.0 / 60.0; ///< s, at most: tips are within some hundredths of how far they move.
	static constexpr int MOST_STEPS = 4; ///< Between samples.

	/// Who feels it.
	struct Plants {
		const float *x, *z; ///< m.
		const float *lengths; ///< m.
		int count;
		float stand_height; ///< m; 0: they stand alone.
		float swing; ///< s, of the quickest.
	};

	AirAhead() = default;
	AirAhead(AirAhead &&) = default;
	AirAhead &operator=(AirAhead &&) = default;
	/// A copy samples anew.
	AirAhead(const AirAhead &) {}
	AirAhead &operator=(const AirAhead &) { return *this = AirAhead(); }

	/// For so many plants. Allocates where they are more than ever before; without room nothing is ready.
	void make_room(int plants);
	/// Plants came, went or moved, or stand otherwise: what is known is not of them.
	void forget() { is_known = is_told = false; }

	/// Before a step of `step` seconds whose air is that of `moment` (s), in the axes of `along`. Samples what is due:
	/// in one of so many steps, which of them by `turn`.
	void look(const FieldWind &wind, const PlantWinds &along, double moment, float step, int turn, const Plants &plants,
			SimdLevel level = best_simd_level());
	/// Whether tell() knows the air of the moment that was looked at last. Not where each step is to sample by itself.
	bool is_ready() const { return is_told; }
	/// As sample_air() of plants from `begin` on, a multiple of AIR_GROUP, without a gust that was called for.
	void tell(const AirBlow &blow, int begin, int count, float *out_x, float *out_z,
			SimdLevel level = best_simd_level()) const;
	/// Steps from one sample to the next, in such air; 1: each step's is sampled.
	static int stride_in(const Air &air, float step, float swing);

	std::size_t bytes() const;

private:
	std::unique_ptr<uint32_t[]> groups; ///< As WindKernels has them.
	int room = 0; ///< In groups.
	bool is_known = false;
	bool is_told = false;
	bool has_stand = false;
	int stride = 1;
	int age = 0; ///< Steps since the second sample.
	float step_time = 0.0f; ///< s.
	double last_moment = 0.0; ///< s.
};

} // namespace undergrowth
