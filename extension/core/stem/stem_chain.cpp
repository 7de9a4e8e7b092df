#include "stem/stem_chain.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr int LINKS = StemChain::LINKS;
constexpr double H = 1.0 / LINKS;
constexpr double MAX_TURN = 0.2; // rad per iteration.
constexpr double SETTLED = 1e-10; // rad.
constexpr int MAX_ITERATIONS = 60;
constexpr double MIN_PIVOT = 1e-3; // Of the joints' own stiffness: a chain never gives way completely.
constexpr double GAUSS_PLACE[2] = { 0.21132486540518712, 0.78867513459481288 };

/// The moment of a distributed load about a level link's lower end, in link lengths, over the whole stem's.
double moment_of(const StemSpread &spread, double head, double head_arm, int link) {
	const double start = link * H;
	double sum = 0.5 * H * (spread.beyond(start + H * GAUSS_PLACE[0]) + spread.beyond(start + H * GAUSS_PLACE[1]));
	for (const StemSpread::Point &point : spread.points) {
		sum += point.amount * std::clamp(point.place - start, 0.0, H);
	}
	return sum + head * (H + (link == LINKS - 1 ? head_arm : 0.0));
}

/// ∫ dx/I.
double compliance(const StemLine &line, double from, double to) {
	double sum = 0.0;
	for (const double place : GAUSS_PLACE) {
		sum += 0.5 * (to - from) / line.bending(from + (to - from) * place);
	}
	return sum;
}

/// Cosine and sine of an angle from upright.
struct Direction {
	double across, along;
};

/// Of a link at `angle` from the foot's direction.
Direction turned(const StemChain::Lean &lean, double angle) {
	const double cosine = portable_cos(angle);
	const double sine = portable_sin(angle);
	return { lean.cosine * cosine - lean.sine * sine, lean.sine * cosine + lean.cosine * sine };
}

} // namespace

StemChain::StemChain(const StemLine &line, double youngs_modulus) :
		length(line.length), head_centre(line.head_centre), head_air(line.head_air) {
	const double pull = STANDARD_GRAVITY * length;
	const double arm = head_centre / length;
	for (int i = 0; i < LINKS; i++) {
		const double x = i * H;
		const double bend = compliance(line, std::max(x - 0.5 * H, 0.0), x) + compliance(line, x, x + 0.5 * H);
		joint[i] = youngs_modulus / (length * bend);
		weight[i] = pull * moment_of(line.mass, line.head_mass, arm, i);
		dead[i] = length * moment_of(line.dead, line.head_dead, arm, i);
		air[i] = line.air.beyond(x) - line.air.beyond(x + H);
	}
	for (const StemSpread::Point &point : line.air.points) {
		air[std::clamp(static_cast<int>(point.place * LINKS), 0, LINKS - 1)] += point.amount;
	}
}

double StemChain::elastic(const Angles &angles, int link) const {
	const double below = link > 0 ? angles[link - 1] : 0.0;
	const double above = link < LINKS - 1 ? joint[link + 1] * (angles[link + 1] - angles[link]) : 0.0;
	return above - joint[link] * (angles[link] - below);
}

double StemChain::turn(Angles &angles, const Angles &moments, const Angles &diagonal) const {
	Angles pivot;
	Angles change;
	for (int i = 0; i < LINKS; i++) {
		const double own = joint[i] + (i < LINKS - 1 ? joint[i + 1] : 0.0);
		const double share = i > 0 ? joint[i] / pivot[i - 1] : 0.0;
		pivot[i] = std::max(own + diagonal[i] - share * joint[i], MIN_PIVOT * own);
		change[i] = moments[i] + (i > 0 ? share * change[i - 1] : 0.0);
	}
	double max = 0.0;
	for (int i = LINKS - 1; i >= 0; i--) {
		change[i] = (change[i] + (i < LINKS - 1 ? joint[i + 1] * change[i + 1] : 0.0)) / pivot[i];
		max = std::max(max, std::fabs(change[i]));
	}
	const double factor = max > MAX_TURN ? MAX_TURN / max : 1.0;
	for (int i = 0; i < LINKS; i++) {
		angles[i] += factor * change[i];
	}
	return max;
}

void StemChain::settle_dead(double newtons, Angles &angles, const Lean &lean) const {
	const double balanced = lean.nods ? 0.0 : lean.sine;
	Angles moments;
	Angles diagonal;
	for (int n = 0; n < MAX_ITERATIONS; n++) {
		for (int i = 0; i < LINKS; i++) {
			const auto [across, along] = turned(lean, angles[i]);
			moments[i] = newtons * dead[i] * across + weight[i] * (along - balanced) + elastic(angles, i);
			diagonal[i] = newtons * dead[i] * along - weight[i] * across;
		}
		if (turn(angles, moments, diagonal) < SETTLED) {
			return;
		}
	}
}

// The pressure on a link depends only on that link's turns, so three sums represent everything above a link. The
// derivative treats the links as if they turned one by one. This is stable and nearly as fast as the full one.
void StemChain::settle_air(double speed_squared, Angles &angles, const Lean &lean) const {
	const double balanced = lean.nods ? 0.0 : lean.sine;
	Angles moments;
	Angles diagonal;
	for (int n = 0; n < MAX_ITERATIONS; n++) {
		double sideways = 0.0;
		double upward = 0.0;
		double softer = 0.0;
		for (int i = LINKS - 1; i >= 0; i--) {
			const auto [across, along] = turned(lean, angles[i]);
			const double press = speed_squared * std::fabs(across) * across;
			const double head = i == LINKS - 1 ? press * head_air : 0.0;
			const double own = press * air[i];
			const double reach = length * H;
			moments[i] = reach * (sideways * across - upward * along + 0.5 * own) + head * (reach + head_centre) +
					weight[i] * (along - balanced) + elastic(angles, i);
			softer += speed_squared * (air[i] + (i == LINKS - 1 ? head_air : 0.0)) * std::fabs(2.0 * across * along);
			diagonal[i] = reach * (std::max(sideways * along + upward * across, 0.0) + softer) - weight[i] * across;
			sideways += (own + head) * across;
			upward -= (own + head) * along;
		}
		if (turn(angles, moments, diagonal) < SETTLED) {
			return;
		}
	}
}

} // namespace undergrowth
