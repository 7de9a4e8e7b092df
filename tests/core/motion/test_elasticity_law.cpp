#include "swing.hpp"

#include "motion/joint_constants.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

using namespace undergrowth;

namespace {

constexpr double GRAVITY = 9.81;
constexpr double FREQUENCY_TOLERANCE = 2e-4; // Relative; resolution of zero crossings of a few dozen swings.
constexpr double DECAY_TOLERANCE = 0.01; // Relative; resolution of peaks between samples.
constexpr double ANGLE_TOLERANCE = 2e-5; // rad.
constexpr double LENGTH_TOLERANCE = 1e-6; // Of 1; floats near 1 are 6e-8 apart.
constexpr double SMALL = 2e-3; // rad; the law's own amplitude term is below 1e-5 here.

Joint joint_of(double elasticity, double length, double friction = 0.0) {
	Joint joint;
	joint.elasticity = static_cast<float>(elasticity);
	joint.length = static_cast<float>(length);
	joint.inner_friction = static_cast<float>(friction);
	return joint;
}

MotionPage one_plant(const Joint &joint, const TipState &state, float step = FRAME_STEP) {
	return plant_page(Law::elasticity, joint, state, step);
}

void run(MotionPage &page, double seconds, const glm::vec3 &wind = { 0.0f, 0.0f, 0.0f }) {
	const int steps = static_cast<int>(seconds / static_cast<double>(page.step_length()));
	for (int i = 0; i < steps; i++) {
		step_in(page, wind);
	}
}

/// The stable root of F·w = m·g·tan φ·((1 + e)·cos φ - 1), by bisection up to the slope's maximum.
double equilibrium_angle(double force, double mass, double elasticity) {
	double low = 0.0;
	double high = std::acos(std::cbrt(1.0 / (1.0 + elasticity)));
	for (int i = 0; i < 100; i++) {
		const double middle = 0.5 * (low + high);
		const double held = mass * GRAVITY * std::tan(middle) * ((1.0 + elasticity) * std::cos(middle) - 1.0);
		(held < force ? low : high) = middle;
	}
	return low;
}

/// Per m·L²: half the squared rate plus the potential of gravity and the upward force.
double energy(const TipState &state, double elasticity, double length) {
	const double y = static_cast<double>(state.direction.y);
	const double x = static_cast<double>(state.rate.x);
	const double z = static_cast<double>(state.rate.z);
	const double w = static_cast<double>(state.rate.y);
	const double top = 0.5 * (1.0 + elasticity) - 1.0;
	const double potential = GRAVITY / length * (top - (0.5 * (1.0 + elasticity) * y * std::fabs(y) - y));
	return 0.5 * (x * x + w * w + z * z) + potential;
}

} // namespace

TEST_CASE("a small swing has the square of its angular frequency at e·g/L, at any step") {
	for (const float step : { FRAME_STEP, LONG_STEP, 1.0f / 144.0f }) {
		for (const double elasticity : { 0.25, 1.0, 4.0, 20.0 }) {
			for (const double length : { 0.3, 1.0, 2.5 }) {
				const double expected = std::sqrt(elasticity * GRAVITY / length) / (2.0 * PI);
				MotionPage page = one_plant(joint_of(elasticity, length), leaning(SMALL), step);
				const int steps = static_cast<int>(40.0 / expected / static_cast<double>(step));
				const double measured = frequency_of(record_x(page, steps), static_cast<double>(step));
				CAPTURE(step);
				CAPTURE(elasticity);
				CAPTURE(length);
				CHECK(measured == doctest::Approx(expected).epsilon(FREQUENCY_TOLERANCE));
			}
		}
	}
}

TEST_CASE("friction slows a small swing and shrinks it at c/(2m), at any step") {
	constexpr double FRICTION = 0.8;
	constexpr double MASS = 0.5;
	const double beta = FRICTION / (2.0 * MASS);
	const double omega = std::sqrt(4.0 * GRAVITY / 0.7 - beta * beta);
	for (const float step : { FRAME_STEP, LONG_STEP }) {
		Joint joint = joint_of(4.0, 0.7, FRICTION);
		joint.mass = static_cast<float>(MASS);
		MotionPage page = one_plant(joint, leaning(0.02), step);
		const std::vector<double> places = record_x(page, static_cast<int>(6.0 / static_cast<double>(step)));
		CHECK(frequency_of(places, static_cast<double>(step)) == doctest::Approx(omega / (2.0 * PI)).epsilon(1e-3));
		CHECK(decay_rate_of(places, static_cast<double>(step)) == doctest::Approx(beta).epsilon(DECAY_TOLERANCE));
	}
}

TEST_CASE("just inside acos(1/(1 + e)) a plant rises, just outside it falls to the ground") {
	constexpr double MARGIN = 0.005;
	for (const double elasticity : { 0.5, 1.0, 4.0 }) {
		const double border = std::acos(1.0 / (1.0 + elasticity));
		for (const bool above_ground : { true, false }) {
			Joint joint = joint_of(elasticity, 1.0, 2.0);
			joint.above_ground = above_ground;
			MotionPage inside = one_plant(joint, leaning(border - MARGIN));
			MotionPage outside = one_plant(joint, leaning(border + MARGIN));
			run(inside, 60.0);
			run(outside, 60.0);
			CAPTURE(elasticity);
			CHECK(deflection(inside.state(0)) < 1e-3);
			const double height = static_cast<double>(outside.state(0).direction.y);
			// Without ground the upward force increases again below it, and supports the tip at y = -1/(1 + e).
			CHECK(height == doctest::Approx(above_ground ? 0.02 : -1.0 / (1.0 + elasticity)).epsilon(1e-3));
		}
	}
}

TEST_CASE("with ground a tip is never below it, at any velocity") {
	Joint joint = joint_of(2.0, 0.5, 0.1);
	MotionPage page = one_plant(joint, leaning(0.3));
	float lowest = 1.0f;
	for (int i = 0; i < 5000; i++) {
		if (i % 50 == 0) {
			page.apply_impulse(0, { 5.0f, -40.0f, 3.0f });
		}
		step_in(page, { 2.0f, 0.0f, 0.0f });
		lowest = std::min(lowest, page.state(0).direction.y);
	}
	CHECK(lowest > 0.0f);
}

TEST_CASE("a tip on the ground gains no rate downwards") {
	MotionPage page = one_plant(joint_of(1.0, 1.0, 0.0), leaning(1.5));
	run(page, 30.0);
	CHECK(page.state(0).direction.y < 0.03f);
	CHECK(std::fabs(page.state(0).rate.y) < 0.1f);
	page.apply_impulse(0, { 0.0f, 5.0f, 0.0f });
	run(page, 0.1);
	CHECK(page.state(0).direction.y > 0.1f);
}

TEST_CASE("a joint faster than one cycle per step still rises, and bends correctly in wind") {
	// Without a limit of the swing per step, sin²(ω·step/2) would leave no force here.
	const double omega = 2.0 * PI / static_cast<double>(FRAME_STEP);
	const double elasticity = omega * omega * 0.01 / GRAVITY;
	MotionPage stiff = one_plant(joint_of(elasticity, 0.01), leaning(SMALL));
	CHECK(frequency_of(record_x(stiff, 60), static_cast<double>(FRAME_STEP)) > 15.0);
	MotionPage page = one_plant(joint_of(elasticity, 0.01, 5.0), leaning(0.3));
	run(page, 20.0);
	CHECK(deflection(page.state(0)) < 1e-3);
	run(page, 20.0, { 200.0f, 0.0f, 0.0f });
	CHECK(std::fabs(deflection(page.state(0)) - equilibrium_angle(200.0, 1.0, elasticity)) < ANGLE_TOLERANCE);
}

TEST_CASE("a stiff joint without ground also comes to rest hanging, where its law is stiffer than upright") {
	Joint joint = joint_of(0.3, 1.42e-4, 5.0);
	joint.above_ground = false;
	MotionPage page = one_plant(joint, leaning(2.0));
	run(page, 60.0);
	CHECK(page.state(0).direction.y == doctest::Approx(-1.0 / 1.3).epsilon(1e-4));
	CHECK(glm::length(page.state(0).rate) < 0.1f);
}

TEST_CASE("a storm flattens a light plant with the wind and does not shake it") {
	for (const float force : { 30.0f, 1e3f, 1e6f }) {
		Joint joint = joint_of(5.0, 0.1, 1e-3);
		joint.mass = 1e-3f;
		joint.above_ground = false;
		MotionPage page = one_plant(joint, leaning(0.0));
		run(page, 60.0, { force, 0.0f, 0.0f });
		CAPTURE(force);
		CHECK(page.state(0).direction.x > 0.9999f);
		CHECK(glm::length(page.state(0).rate) < 0.1f);
	}
}

TEST_CASE("a constant wind bends a plant to F·w = m·g·tan φ·((1 + e)·cos φ - 1)") {
	for (const float step : { FRAME_STEP, LONG_STEP }) {
		for (const double elasticity : { 1.0, 4.0, 12.0 }) {
			for (const double force : { 0.5, 2.0 }) {
				Joint joint = joint_of(elasticity, 0.8, 2.0);
				joint.mass = 0.6f;
				joint.wind_weight = 0.5f;
				MotionPage page = one_plant(joint, leaning(0.0), step);
				run(page, 60.0, { 0.0f, 0.0f, static_cast<float>(force) });
				const double expected = equilibrium_angle(0.5 * force, static_cast<double>(joint.mass), elasticity);
				CHECK(std::fabs(deflection(page.state(0)) - expected) < ANGLE_TOLERANCE);
				CHECK(page.state(0).direction.z > 0.0f);
				CHECK(page.state(0).direction.x == 0.0f);
			}
		}
	}
}

TEST_CASE("a large swing in wind follows a finely stepped reference, closer with a shorter step") {
	constexpr double SECONDS = 3.0;
	constexpr int FINE = 200000;
	const double fall = GRAVITY / 1.2;
	double angle = 0.9;
	double rate = 0.0;
	for (int i = 0; i < FINE; i++) {
		const double h = SECONDS / FINE;
		const double up = fall * (5.0 * std::cos(angle) - 1.0);
		rate += h * (-up * std::sin(angle) + 3.0 / 1.2 * std::cos(angle) - 0.3 * rate);
		angle += h * rate;
	}
	const auto error = [&](float step) {
		MotionPage page = one_plant(joint_of(4.0, 1.2, 0.3), leaning(0.9), step);
		run(page, SECONDS + 1e-4, { 3.0f, 0.0f, 0.0f });
		const glm::vec3 tip = page.state(0).direction;
		return std::fabs(std::atan2(static_cast<double>(tip.x), static_cast<double>(tip.y)) - angle);
	};
	CHECK(error(FRAME_STEP) < 0.08); // Half a step of delay at the highest rate, and the same from the large angle.
	CHECK(error(1.0f / 960.0f) < 0.005);
}

TEST_CASE("the tip preserves its distance from the root over an hour") {
	MotionPage page = one_plant(joint_of(4.0, 1.0), leaning(0.7));
	page.apply_impulse(0, { 0.0f, 0.0f, 1.5f });
	double worst = 0.0;
	double slope = 0.0;
	for (int i = 0; i < 3600 * 60; i++) {
		step_in(page, { 0.0f, 0.0f, 0.0f });
		const TipState tip = page.state(0);
		const glm::dvec3 direction = tip.direction;
		worst = std::fmax(worst, std::fabs(glm::dot(direction, direction) - 1.0));
		slope = std::fmax(slope, std::fabs(glm::dot(direction, glm::dvec3(tip.rate))));
	}
	CHECK(worst < LENGTH_TOLERANCE);
	CHECK(slope < 1e-5); // 1/s: the rate stays in the tangent plane.
}

TEST_CASE("without friction the energy is constant over an hour") {
	MotionPage page = one_plant(joint_of(4.0, 1.0), leaning(0.5));
	page.apply_impulse(0, { 0.0f, 0.0f, 1.0f });
	constexpr int MINUTE = 3600;
	double first = 0.0;
	double last = 0.0;
	double max = 0.0;
	for (int i = 0; i < 60 * MINUTE; i++) {
		step_in(page, { 0.0f, 0.0f, 0.0f });
		const double now = energy(page.state(0), 4.0, 1.0);
		first += i < MINUTE ? now / MINUTE : 0.0;
		last += i >= 59 * MINUTE ? now / MINUTE : 0.0;
		max = std::fmax(max, now);
	}
	CHECK(last == doctest::Approx(first).epsilon(0.005));
	CHECK(max < 1.15 * first);
}

TEST_CASE("tall plants swing slower and wider and, being heavier, lose energy more slowly") {
	const auto swing = [](double length) {
		Joint joint = joint_of(4.0, length, 0.2);
		joint.mass = static_cast<float>(0.3 * length);
		MotionPage page = one_plant(joint, leaning(0.0));
		page.apply_impulse(0, { 0.05f * joint.mass / 0.3f, 0.0f, 0.0f });
		return record_x(page, 600);
	};
	const double step = static_cast<double>(FRAME_STEP);
	const std::vector<double> tall = swing(2.0);
	const std::vector<double> low = swing(0.4);
	CHECK(frequency_of(tall, step) < 0.5 * frequency_of(low, step));
	CHECK(2.0 * peaks_of(tall).front() > 1.5 * 0.4 * peaks_of(low).front());
	CHECK(decay_rate_of(tall, step) < 0.5 * decay_rate_of(low, step));
}

TEST_CASE("waves move a tall plant less than a low one") {
	const auto share = [](double length) {
		MotionPage page = one_plant(joint_of(4.0, length, 0.5), leaning(0.0));
		double min = 10.0;
		double max = -10.0;
		for (int i = 0; i < 6000; i++) {
			const double phase = 2.0 * PI * 1.2 * i / 60.0;
			step_in(page, { static_cast<float>(2.0 * (1.0 + std::sin(phase))), 0.0f, 0.0f });
			if (i > 3000) {
				min = std::fmin(min, static_cast<double>(page.state(0).direction.x));
				max = std::fmax(max, static_cast<double>(page.state(0).direction.x));
			}
		}
		return (max - min) / (max + min);
	};
	CHECK(share(3.0) < 0.5 * share(0.3));
}

TEST_CASE("weights of many lengths have the bits of those of single lengths") {
	const float lengths[] = { 0.05f, 0.3f, 1.0f, 2.5f, 1e-9f, 1e9f };
	for (const float step : { FRAME_STEP, LONG_STEP, 8.0f * FRAME_STEP }) {
		float weights[6];
		elasticity_weights({}, step, lengths, 6, weights);
		for (int i = 0; i < 6; i++) {
			float weight = 0.0f;
			elasticity_weights({}, step, lengths + i, 1, &weight);
			CHECK(weights[i] == weight);
		}
	}
}
