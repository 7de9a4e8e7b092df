#pragma once

#include "form/growth.hpp"

#include "base/random.hpp"

#include <algorithm>
#include <cmath>

/// Random numbers, the same for the same seed.
class Chance {
public:
	explicit Chance(uint64_t p_seed) : seed(p_seed) {}

	/// Often the borders themselves.
	float within(float min, float max) {
		const float share = next_share();
		return one_in(6) ? (one_in(2) ? min : max) : min + (max - min) * share;
	}
	/// The same, distributed over powers of ten.
	float spread(float min, float max) { return std::min(std::max(min * std::pow(max / min, next_share()), min), max); }
	int whole(int min, int max) {
		const uint64_t bits = undergrowth::mix_bits(undergrowth::mix_bits(seed) ^ index++);
		return min + static_cast<int>(bits % static_cast<uint64_t>(max - min + 1));
	}
	bool one_in(int many) { return whole(1, many) == 1; }

private:
	uint64_t seed;
	uint64_t index = 0;

	float next_share() { return 0.5f + 0.5f * undergrowth::signed_noise(seed, index++); }
};

/// Parts and arrangements with random numbers within their limits.
undergrowth::Part any_part(Chance &chance);
undergrowth::Arrangement any_arrangement(Chance &chance);

/// Inserts numbers that authors and scripts should not write: not finite, huge, negative, next to the limits.
void spoil(undergrowth::Part &part, Chance &chance);
void spoil(undergrowth::Arrangement &arrangement, Chance &chance);

/// A few kinds of parts on each other, sometimes too deep or too many.
undergrowth::Recipe any_recipe(Chance &chance);
