#include "stem/stem_along.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"
#include "stem/stem_bones.hpp"
#include "stem/stem_shape.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr double COSINE = 0.8191520442889918; // Of a lean of 35° against the wind.
constexpr double SINE = -0.5735764363510461;
constexpr double SLOPES[2] = { 1.0, 4.0 };
constexpr double NODS[2] = { PI / 9.0, PI / 3.0 }; // Leans.
constexpr double MAX_NOD_EASE = 10.0;
constexpr double MIN_NOD_RISE = 1e-12;
constexpr int LOADS_BETWEEN = 4; // A chain settles from the bend of a smaller load.
constexpr float MAX_SHARE = 1.5f;
constexpr float MAX_EASE = 1.0f;
constexpr double MIN_RISE = 1e-3;

/// Place of a chain's tip, in lengths.
glm::dvec2 tip_of(const StemChain::Angles &angles) {
	glm::dvec2 sum(0.0);
	for (const double angle : angles) {
		sum += glm::dvec2(portable_sin(angle), portable_cos(angle)) / static_cast<double>(StemChain::LINKS);
	}
	return sum;
}

/// The bend of the tip at which a drawn stem's tip is nearest to a place (lengths). `share`: of StemMode.
double nearest_bend(const StemConstants &stem, float StemMode::*share, const glm::dvec2 &place) {
	const auto distance = [&](double bend) {
		glm::vec2 amplitudes[MAX_STEM_MODES] = {};
		for (int k = 0; k < stem.modes; k++) {
			amplitudes[k].x = stem.mode[k].*share * static_cast<float>(bend);
		}
		const glm::vec3 tip = stem_place(stem, amplitudes, 1.0f).centre;
		return glm::distance(place, glm::dvec2(tip.x, tip.y));
	};
	double best = 0.0;
	double least = distance(best);
	double width = static_cast<double>(MAX_STEM_AMPLITUDE);
	for (double step = width / 16.0; step > 1e-5; step *= 0.25) {
		const double from = std::max(best - width, 0.0);
		const double to = std::min(best + width, static_cast<double>(MAX_STEM_AMPLITUDE));
		for (double bend = from; bend <= to; bend += step) {
			const double away = distance(bend);
			best = away < least ? bend : best;
			least = std::min(away, least);
		}
		width = step;
	}
	return best;
}

/// `settle` bends a chain by a load with this linear slope. `share_at` returns the share with which a stem's tip has
/// the place of the chain's.
template <class Settle, class ShareAt> StemAlong fitted(const Settle &settle, const ShareAt &share_at) {
	StemChain::Angles angles = {};
	double shares[2];
	for (int i = 0; i < 2; i++) {
		const double before = i > 0 ? SLOPES[i - 1] : 0.0;
		for (int part = 1; part <= LOADS_BETWEEN; part++) {
			settle(before + (SLOPES[i] - before) * part / LOADS_BETWEEN, angles);
		}
		shares[i] = share_at(SLOPES[i], tip_of(angles));
	}
	const double rise = std::max(shares[1] * SLOPES[1] - shares[0] * SLOPES[0], MIN_RISE);
	StemAlong along;
	along.ease = std::clamp(static_cast<float>((shares[0] - shares[1]) / rise), 0.0f, MAX_EASE);
	const double first = shares[0] * (1.0 + static_cast<double>(along.ease) * SLOPES[0]);
	along.share = std::clamp(static_cast<float>(first), 0.0f, MAX_SHARE);
	return along;
}

} // namespace

// At rest tan θ = across/(1 + along).
StemAlong along_of_newtons(const StemChain &chain, const StemConstants &stem) {
	const auto settle = [&](double slope, StemChain::Angles &angles) {
		chain.settle_dead(slope / static_cast<double>(stem.dead_slope), angles, { COSINE, SINE, false });
	};
	return fitted(settle, [&](double slope, const glm::dvec2 &tip) {
		const double bend = nearest_bend(stem, &StemMode::dead_share, tip);
		const double cotangent = (1.0 - bend * bend) / (2.0 * bend);
		return (slope * COSINE * cotangent - 1.0) / (slope * SINE);
	});
}

// At rest sin θ = slope·v², v being the wind across the tip: cos θ·across - sin θ·along.
StemAlong along_of_air(const StemChain &chain, const StemConstants &stem) {
	const StemConstants bent = in_air(stem);
	const auto settle = [&](double slope, StemChain::Angles &angles) {
		chain.settle_air(slope / static_cast<double>(stem.air_slope), angles, { COSINE, SINE, false });
	};
	return fitted(settle, [&](double slope, const glm::dvec2 &tip) {
		const double bend = nearest_bend(bent, &StemMode::air_share, tip);
		const double sine = 2.0 * bend / (1.0 + bend * bend);
		const double cosine = (1.0 - bend * bend) / (1.0 + bend * bend);
		return (COSINE * cosine - std::sqrt(sine / slope)) / (SINE * sine);
	});
}

// The weight bends a stem by slope·sin(lean) = slope·r·u. Its stiffness is that of an upright stem under its weight,
// which holds a leaning one too little by the part 2 - u.
StemNod nod_of(const StemChain &chain, const StemConstants &stem) {
	double cosines[2];
	double factors[2];
	StemChain::Angles angles = {};
	for (int i = 0; i < 2; i++) {
		const double lean = NODS[i];
		cosines[i] = portable_cos(lean);
		const double sine = portable_sin(lean);
		chain.settle_dead(0.0, angles, { cosines[i], sine, true });
		factors[i] = nearest_bend(stem, &StemMode::dead_share, tip_of(angles)) / sine;
	}
	const double rise = factors[1] * (1.0 - cosines[1]) - factors[0] * (1.0 - cosines[0]);
	const double ease = std::clamp((factors[0] - factors[1]) / std::max(rise, MIN_NOD_RISE), 0.0, MAX_NOD_EASE);
	StemNod nod;
	nod.ease = static_cast<float>(ease);
	nod.share = static_cast<float>(factors[0] * (1.0 + ease * (1.0 - cosines[0])));
	return nod;
}

} // namespace undergrowth
