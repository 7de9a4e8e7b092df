#include "motion/joint_constants.hpp"

#include "base/portable_math.hpp"
#include "motion/kernel_tables.hpp"
#include "wind/air_profile.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float MIN_LENGTH = 1e-4f; // m.
constexpr float MIN_MASS = 1e-6f; // kg.
constexpr float MIN_FREQUENCY = 1e-4f; // Hz.
constexpr float MAX_FREQUENCY = 1e4f; // Hz.
constexpr float LARGE = 1e6f; // For every other constant, in its own unit.
constexpr float MIN_ELASTICITY = -0.999f;

/// Height at which the ground stops a tip, as a fraction of its length. It is above 0 to leave the projection a
/// horizontal part.
constexpr float GROUND_Y = 0.02f;
constexpr float NO_GROUND_Y = -1e30f;

/// Max swing per step (rad) with the exact frequency of a small swing. More would come close to half a cycle per step;
/// stiffer joints swing at this.
constexpr double MAX_PHASE = 2.4;
/// Half the max of kick·stiffness·step at the stiffest point of the sphere; kick and drift diverge from 2 on.
constexpr double STABLE = 1.75;

float within(float value, float low, float high, float otherwise) {
	return std::isfinite(value) ? std::clamp(value, low, high) : otherwise;
}

/// (1 - exp(-x))/x for x >= 0.
double decay_ratio(double x) {
	if (x < 1e-3) {
		return 1.0 - x * (0.5 - x * (1.0 / 6.0 - x / 24.0));
	}
	return (1.0 - portable_exp(-x)) / x;
}

/// Change of the rate by an acceleration in one kick, divided by the acceleration (s).
///
/// Kick (v' = keep·v - gain·ω²·x, keep = s², s = exp(-β·step), β = c/(2m)) and drift (x' = x + step·v') have
/// determinant s² and trace 1 + s² - gain·ω²·step. A swing that decays exactly as x'' = -ω²·x - 2β·x' has the same
/// determinant and the trace 2·s·cos(μ·step), μ² = ω² - β². Hence gain·ω²·step = (1 - s)² + 4·s·sin²(μ·step/2), which
/// without friction is 4·sin²(ω·step/2). For an overdamped joint, with the decay rates a and b (a + b = 2β, a·b = ω²),
/// it is (1 - exp(-a·step))·(1 - exp(-b·step)). `s` is exp(-beta·step).
double kick_gain(double omega_squared, double beta, double s, double step) {
	const double mu_squared = omega_squared - beta * beta;
	if (mu_squared <= 0.0) {
		const double fast = beta + std::sqrt(-mu_squared);
		const double slow = fast > 0.0 ? omega_squared / fast : 0.0;
		return step * decay_ratio(fast * step) * decay_ratio(slow * step);
	}
	const double phase = std::sqrt(mu_squared) * step;
	const double sine = portable_sin(0.5 * std::min(phase, MAX_PHASE));
	return ((1.0 - s) * (1.0 - s) + 4.0 * s * sine * sine) / (omega_squared * step);
}

/// cos(√z) and sin(√z)/√z, continued to z < 0. Near 0, where the closed forms lose digits, these are series.
struct Series {
	double cosine;
	double sine_ratio;
};

Series near_critical(double z) {
	return { 1.0 - z / 2.0 * (1.0 - z / 12.0 * (1.0 - z / 30.0)), 1.0 - z / 6.0 * (1.0 - z / 20.0 * (1.0 - z / 42.0)) };
}

/// exp(-ζωh)·(cos, sin/μ) of μ·h with μ = ω·√(1 - ζ²), continued to ζ >= 1.
struct Decay {
	double cosine;
	double sine; ///< s.
};

Decay decay(double omega, double damping, double step) {
	const double beta = damping * omega;
	const double mu_squared = omega * omega * (1.0 - damping) * (1.0 + damping);
	const double z = mu_squared * step * step;
	if (std::fabs(z) < 1e-3) {
		const double shrink = portable_exp(-beta * step);
		const Series series = near_critical(z);
		return { shrink * series.cosine, shrink * series.sine_ratio * step };
	}
	if (z > 0.0) {
		const double shrink = portable_exp(-beta * step);
		const double mu = std::sqrt(mu_squared);
		return { shrink * portable_cos(mu * step), shrink * portable_sin(mu * step) / mu };
	}
	const double half_gap = std::sqrt(-mu_squared);
	const double fast = portable_exp(-(beta + half_gap) * step);
	const double slow = portable_exp(-(omega * omega / (beta + half_gap)) * step);
	return { 0.5 * (slow + fast), 0.5 * (slow - fast) / half_gap };
}

/// Common constants of the elasticity law for joints that differ only in length. `joint` must be safe.
class ElasticityStep {
public:
	ElasticityStep(const Joint &joint, float step) :
			h(static_cast<double>(step)),
			elasticity(static_cast<double>(joint.elasticity)),
			beta(0.5 * static_cast<double>(joint.inner_friction) / static_cast<double>(joint.mass)),
			keep(portable_exp(-2.0 * beta * h)),
			shrink(portable_exp(-beta * h)) {}

	double kept() const { return keep; }
	double fall(float length) const { return static_cast<double>(STANDARD_GRAVITY) / static_cast<double>(length); }
	double gain(float length) const {
		const double stiffest = (1.0 + std::fabs(elasticity)) * fall(length);
		const double max = STABLE * (1.0 + keep) / (stiffest * h);
		return std::min(kick_gain(std::fabs(elasticity) * fall(length), beta, shrink, h), max);
	}
	float weight(float length) const { return static_cast<float>(fall(length) * gain(length) * h); }

private:
	double h; ///< s.
	double elasticity;
	double beta; ///< 1/s.
	double keep;
	double shrink;
};

} // namespace

Joint safe_joint(const Joint &joint) {
	const Joint usual;
	Joint safe = joint;
	safe.length = within(joint.length, MIN_LENGTH, LARGE, usual.length);
	safe.mass = within(joint.mass, MIN_MASS, LARGE, usual.mass);
	safe.wind_weight = within(joint.wind_weight, 0.0f, LARGE, usual.wind_weight);
	safe.drag_area = within(joint.drag_area, usual.drag_area, LARGE, usual.drag_area);
	safe.elasticity = within(joint.elasticity, MIN_ELASTICITY, LARGE, usual.elasticity);
	safe.inner_friction = within(joint.inner_friction, 0.0f, LARGE, usual.inner_friction);
	safe.natural_frequency = within(joint.natural_frequency, MIN_FREQUENCY, MAX_FREQUENCY, usual.natural_frequency);
	safe.damping_ratio = within(joint.damping_ratio, 0.0f, LARGE, usual.damping_ratio);
	safe.rest.x = within(joint.rest.x, -1.0f, 1.0f, usual.rest.x);
	safe.rest.y = within(joint.rest.y, 1.0f / MAX_GNOMONIC, 1.0f, usual.rest.y);
	safe.rest.z = within(joint.rest.z, -1.0f, 1.0f, usual.rest.z);
	return safe;
}

ElasticityConstants elasticity_constants(const Joint &joint, float step) {
	ElasticityConstants constants;
	constants.lift_share = 1.0f + joint.elasticity;
	constants.wind_share = joint.wind_weight / (joint.mass * STANDARD_GRAVITY);
	constants.keep = static_cast<float>(ElasticityStep(joint, step).kept());
	constants.lowest_y = joint.above_ground ? GROUND_Y : NO_GROUND_Y;
	return constants;
}

void elasticity_weights(const Joint &joint, float step, const float *lengths, int count, float *weights) {
	const ElasticityStep common(joint, step);
	for (int i = 0; i < count; i++) {
		weights[i] = common.weight(within(lengths[i], MIN_LENGTH, LARGE, joint.length));
	}
}

SpringConstants spring_constants(const Joint &joint, float step) {
	const double omega = 2.0 * PI * static_cast<double>(joint.natural_frequency);
	const double damping = static_cast<double>(joint.damping_ratio);
	const Decay part = decay(omega, damping, static_cast<double>(step));
	const double stiffness = static_cast<double>(joint.mass) * omega * omega; // N per metre and unit of t.

	SpringConstants constants;
	constants.wind_gain = static_cast<float>(static_cast<double>(joint.wind_weight) / stiffness);
	constants.place_from_place = static_cast<float>(part.cosine + damping * omega * part.sine - 1.0);
	constants.place_from_rate = static_cast<float>(part.sine);
	constants.rate_from_place = static_cast<float>(-omega * omega * part.sine);
	constants.rate_from_rate = static_cast<float>(part.cosine - damping * omega * part.sine - 1.0);
	return constants;
}

void spring_gains(const SpringConstants &constants, const float *lengths, int count, float *gains) {
	for (int i = 0; i < count; i++) {
		gains[i] = constants.wind_gain / std::max(lengths[i], MIN_LENGTH);
	}
}

float air_drag(const Joint &joint) {
	if (joint.drag_area < 0.0f || joint.wind_weight <= 0.0f) {
		return joint.wind_weight > 0.0f ? 0.5f * AIR_DENSITY : 0.0f;
	}
	return 0.5f * AIR_DENSITY * joint.drag_area / joint.wind_weight;
}

} // namespace undergrowth
