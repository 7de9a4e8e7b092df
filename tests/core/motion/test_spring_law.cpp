#include "swing.hpp"

#include "motion/fixed_step.hpp"
#include "motion/joint_constants.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <vector>

using namespace undergrowth;

namespace {

constexpr double FREQUENCY_TOLERANCE = 1e-3; // Relative.
constexpr double DAMPING_TOLERANCE = 0.01; // Relative; resolution of peaks between samples.
constexpr double ANGLE_TOLERANCE = 1e-5; // rad.
constexpr double SAME_MOTION = 1e-4; // Of the length, between frame rates.
constexpr double CLOSED_FORM_TOLERANCE = 2e-5; // Of the first deflection.

Joint joint_of(double frequency, double damping) {
	Joint joint;
	joint.natural_frequency = static_cast<float>(frequency);
	joint.damping_ratio = static_cast<float>(damping);
	return joint;
}

MotionPage one_plant(const Joint &joint, const TipState &state, float step = FRAME_STEP) {
	return plant_page(Law::spring, joint, state, step);
}

/// x/y of the drawn direction after each frame, at `rate` frames per second.
std::vector<double> drawn_motion(const Joint &joint, int rate, double seconds) {
	MotionPage page = one_plant(joint, leaning(0.3));
	FixedStep clock(1.0 / 60.0);
	std::vector<double> places;
	for (int frame = 0; frame < static_cast<int>(seconds * rate); frame++) {
		const int steps = clock.advance(1.0 / rate);
		for (int i = 0; i < steps; i++) {
			step_in(page, { 0.0f, 0.0f, 0.0f });
		}
		glm::vec3 direction;
		page.interpolate(clock.alpha(), &direction);
		places.push_back(static_cast<double>(direction.x / direction.y));
	}
	return places;
}

/// t'' = -ω²·t - 2·ζ·ω·t' from (1, 0), the textbook's three cases.
double closed_form(double omega, double damping, double time) {
	if (damping < 1.0) {
		const double mu = omega * std::sqrt(1.0 - damping * damping);
		return std::exp(-damping * omega * time) * (std::cos(mu * time) + damping * omega / mu * std::sin(mu * time));
	}
	if (damping == 1.0) {
		return std::exp(-omega * time) * (1.0 + omega * time);
	}
	const double gap = omega * std::sqrt(damping * damping - 1.0);
	const double slow = -damping * omega + gap;
	const double fast = -damping * omega - gap;
	return (fast * std::exp(slow * time) - slow * std::exp(fast * time)) / (fast - slow);
}

} // namespace

TEST_CASE("the spring law is the damped oscillator's closed form at any step and damping") {
	for (const float step : { FRAME_STEP, LONG_STEP, 0.25f }) {
		for (const double damping : { 0.0, 0.1, 0.7, 0.999, 1.0, 1.001, 3.0, 50.0 }) {
			const Joint joint = joint_of(1.3, damping);
			const double omega = 2.0 * PI * static_cast<double>(joint.natural_frequency);
			MotionPage page = one_plant(joint, leaning(0.4), step);
			double worst = 0.0;
			for (int i = 1; i <= 40; i++) {
				step_in(page, { 0.0f, 0.0f, 0.0f });
				const TipState tip = page.state(0);
				const double place = static_cast<double>(tip.direction.x / tip.direction.y) / std::tan(0.4);
				const double exact =
						closed_form(omega, static_cast<double>(joint.damping_ratio), i * static_cast<double>(step));
				worst = std::fmax(worst, std::fabs(place - exact));
			}
			CAPTURE(step);
			CAPTURE(damping);
			CHECK(worst < CLOSED_FORM_TOLERANCE);
		}
	}
}

TEST_CASE("the step's coefficients are continuous through critical damping") {
	const SpringConstants critical = spring_constants(joint_of(2.0, 1.0), FRAME_STEP);
	for (const double damping : { 0.9999, 0.999999, 1.000001, 1.0001 }) {
		const SpringConstants close = spring_constants(joint_of(2.0, damping), FRAME_STEP);
		CHECK(close.place_from_rate == doctest::Approx(critical.place_from_rate).epsilon(1e-3));
		CHECK(close.rate_from_place == doctest::Approx(critical.rate_from_place).epsilon(1e-3));
	}
}

TEST_CASE("a constant wind bends an upright plant to tan φ = F·w/(m·ω²·L)") {
	for (const double force : { 0.1, 1.0, 8.0 }) {
		Joint joint = joint_of(0.8, 0.5);
		joint.length = 1.4f;
		joint.mass = 0.25f;
		joint.wind_weight = 0.7f;
		MotionPage page = one_plant(joint, leaning(0.0));
		for (int i = 0; i < 3600; i++) {
			step_in(page, { static_cast<float>(force), 0.0f, 0.0f });
		}
		const double omega = 2.0 * PI * 0.8;
		const double expected = std::atan(force * 0.7 / (0.25 * omega * omega * 1.4));
		CHECK(std::fabs(deflection(page.state(0)) - expected) < ANGLE_TOLERANCE);
	}
}

TEST_CASE("a leaning plant returns to its rest direction") {
	Joint joint = joint_of(1.0, 0.3);
	joint.rest = { 0.6f, 0.8f, 0.0f };
	MotionPage page = one_plant(joint, { { -0.9f, 0.1f, 0.2f }, {} });
	for (int i = 0; i < 1800; i++) {
		step_in(page, { 0.0f, 0.0f, 0.0f });
	}
	CHECK(page.state(0).direction.x == doctest::Approx(0.6f).epsilon(ANGLE_TOLERANCE));
	CHECK(page.state(0).direction.y == doctest::Approx(0.8f).epsilon(ANGLE_TOLERANCE));
	CHECK(std::fabs(page.state(0).direction.z) < 1e-5f);
}

TEST_CASE("frequency and damping ratio show in the drawn motion at 30, 60 and 144 frames a second") {
	for (const int rate : { 30, 60, 144 }) {
		const Joint joint = joint_of(1.25, 0.05);
		const std::vector<double> places = drawn_motion(joint, rate, 10.0);
		const double damped = 1.25 * std::sqrt(1.0 - 0.05 * 0.05);
		const double frequency = frequency_of(places, 1.0 / rate);
		CAPTURE(rate);
		CHECK(frequency == doctest::Approx(damped).epsilon(FREQUENCY_TOLERANCE));
		const double ratio = decay_rate_of(places, 1.0 / rate) / (2.0 * PI * 1.25);
		CHECK(ratio == doctest::Approx(0.05).epsilon(DAMPING_TOLERANCE));
	}
}

TEST_CASE("30, 60 and 144 frames a second draw the same motion") {
	const Joint joint = joint_of(1.25, 0.05);
	const std::vector<double> at_30 = drawn_motion(joint, 30, 60.0);
	const std::vector<double> at_60 = drawn_motion(joint, 60, 60.0);
	const std::vector<double> at_144 = drawn_motion(joint, 144, 60.0);
	double worst = 0.0;
	for (std::size_t sixth = 1; sixth <= 360; sixth++) {
		worst = std::fmax(worst, std::fabs(at_30[5 * sixth - 1] - at_60[10 * sixth - 1]));
		worst = std::fmax(worst, std::fabs(at_144[24 * sixth - 1] - at_60[10 * sixth - 1]));
	}
	CHECK(worst < SAME_MOTION);
}

TEST_CASE("an undamped swing preserves its size for an hour") {
	MotionPage page = one_plant(joint_of(0.4, 0.0), leaning(0.2));
	record_x(page, 3600 * 60 - 600);
	const std::vector<double> peaks = peaks_of(record_x(page, 600));
	CHECK(peaks.back() == doctest::Approx(std::sin(0.2)).epsilon(0.02));
}

TEST_CASE("a tip of the spring law never reaches the ground") {
	Joint joint = joint_of(0.5, 0.0);
	joint.mass = 0.01f;
	MotionPage page = one_plant(joint, leaning(0.0));
	float lowest = 1.0f;
	for (int i = 0; i < 3000; i++) {
		if (i % 100 == 0) {
			page.apply_impulse(0, { 3.0f, -10.0f, 0.0f });
		}
		step_in(page, { i % 120 < 60 ? 1e4f : 0.0f, 0.0f, 0.0f });
		const glm::vec3 tip = page.state(0).direction;
		lowest = std::fmin(lowest, tip.y);
		CHECK(std::fabs(glm::length(tip) - 1.0f) < 1e-6f);
	}
	CHECK(lowest > 0.0f);
}

TEST_CASE("an impulse upwards straightens a bent plant and does nothing to an upright one") {
	for (const Law law : { Law::elasticity, Law::spring }) {
		Joint joint = joint_of(1.0, 0.1);
		joint.mass = 0.5f;
		MotionPage bent = plant_page(law, joint, leaning(0.6));
		bent.apply_impulse(0, { 0.0f, 0.2f, 0.0f });
		// J/(m·L) along the sphere: the upward blow times the sine of the bend.
		CHECK(glm::length(bent.state(0).rate) == doctest::Approx(0.4 * std::sin(0.6)).epsilon(1e-5));
		CHECK(bent.state(0).rate.y > 0.0f);
		CHECK(bent.state(0).rate.x < 0.0f);
		MotionPage upright = plant_page(law, joint, leaning(0.0));
		upright.apply_impulse(0, { 0.0f, 0.2f, 0.0f });
		CHECK(glm::length(upright.state(0).rate) == 0.0f);
	}
}
