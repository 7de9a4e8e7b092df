#pragma once

#include "conventions.hpp"
#include "stem/stem_beam.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>

/// A stem as 64 rigid links in a plane, with exact kinematics, weight, head, springs and dashpots between the links.
/// Steps use the trapezoidal rule (Newmark's average acceleration), each solved to convergence. It is the reference for
/// the stem law's large motions and is independent of the product's beam.
class ReferenceChain {
public:
	static constexpr int LINKS = 64;
	static constexpr double GRAVITY = 9.81; // m/s².
	static constexpr double HALF_AIR = 0.5 * 1.225; // kg/m³.
	using Row = std::array<double, LINKS>;

	/// `damping`: damping ratio of the slowest small swing. The dashpots are proportional to the springs.
	ReferenceChain(const undergrowth::StemBeam &stem, double youngs_modulus, double damping, double lean = 0.0) :
			h(static_cast<double>(stem.length) / LINKS),
			rest(lean),
			head_arm(static_cast<double>(stem.head_centre)),
			head_inertia(static_cast<double>(stem.head_inertia)) {
		angle.fill(lean);
		for (int i = 0; i < LINKS; i++) {
			const double d = width(stem, i + 0.5);
			const double at_joint = width(stem, i == 0 ? 0.25 : i);
			spring[i] = youngs_modulus * undergrowth::PI / 64.0 * std::pow(at_joint, 4.0) / (i == 0 ? 0.5 * h : h);
			mass[i] = h *
					(static_cast<double>(stem.density) * undergrowth::PI / 4.0 * d * d +
							static_cast<double>(stem.leaf_mass) / static_cast<double>(stem.length));
			air[i] = HALF_AIR * h *
					(static_cast<double>(stem.drag_coefficient) * d +
							static_cast<double>(stem.leaf_drag_area) / static_cast<double>(stem.length));
		}
		head_mass = static_cast<double>(stem.head_mass);
		head_air = HALF_AIR * static_cast<double>(stem.head_drag_area);
		find_masses();
		find_swing(damping);
	}

	double frequency() const { return swing; } ///< rad/s, of the slowest small swing.
	/// kg/m: total drag.
	double all_air() const {
		double sum = head_air;
		for (const double one : air) {
			sum += one;
		}
		return sum;
	}
	/// Newtons to the right, distributed as drag; newtons on the tip; m/s of wind, which presses across each link.
	void set_force(double newtons) { force = newtons; }
	void set_tip_force(double newtons) { tip_force = newtons; }
	void set_wind(double speed) { wind = speed; }

	/// Moves the chain to its equilibrium, without motion.
	void settle() {
		rate.fill(0.0);
		acceleration.fill(0.0);
		for (int n = 0; n < 4000; n++) {
			Row moment = apply_wind();
			Row pivot;
			const double across = std::fabs(force) + std::fabs(tip_force) + all_air() * wind * wind;
			for (int i = 0; i < LINKS; i++) {
				pivot[i] = spring[i] + (i + 1 < LINKS ? spring[i + 1] : 0.0) + h * across * (wind == 0.0 ? 0.3 : 1.0);
			}
			const double max = solve_neighbours(moment, pivot);
			const double share = std::min(1.0, 0.1 / std::max(max, 1e-300));
			for (int i = 0; i < LINKS; i++) {
				angle[i] += share * moment[i];
			}
			if (max < 1e-10) {
				return;
			}
		}
	}

	void step(double dt) {
		const double half = 0.5 * dt;
		for (int i = 0; i < LINKS; i++) {
			angle[i] += dt * rate[i] + half * half * (acceleration[i] + acceleration[i]);
			rate[i] += dt * acceleration[i];
		}
		for (int rounds = 0; rounds < 40; rounds++) {
			if (rounds % 12 == 0 && (rounds > 0 || half != factor_half)) {
				factorise(half); // An old one is sufficient while the stem has moved little.
			}
			const Row change = solved(apply_wind());
			double max = 0.0;
			for (int i = 0; i < LINKS; i++) {
				acceleration[i] += change[i];
				rate[i] += half * change[i];
				angle[i] += half * half * change[i];
				max = std::max(max, std::fabs(half * half * change[i]));
			}
			if (max < 1e-8) {
				return;
			}
		}
	}

	/// In stem lengths from the root; x a whole number of links.
	glm::dvec2 place(double x) const {
		glm::dvec2 sum(0.0, 0.0);
		for (int i = 0; i < static_cast<int>(x * LINKS + 0.5); i++) {
			sum += glm::dvec2(std::sin(angle[i]), std::cos(angle[i])) / static_cast<double>(LINKS);
		}
		return sum;
	}
	double tip_angle() const { return 1.5 * angle[LINKS - 1] - 0.5 * angle[LINKS - 2]; }

private:
	double h; ///< m, of a link.
	double rest; ///< rad: direction of the root.
	double head_arm, head_inertia;
	double head_mass = 0.0;
	double head_air = 0.0;
	double force = 0.0;
	double tip_force = 0.0;
	double wind = 0.0;
	double swing = 0.0;
	double dashpot = 0.0; ///< s: of each joint, over its spring.
	Row angle, spring, mass, air;
	Row rate = {};
	Row acceleration = {};
	Row lever; ///< kg·m: first moment of the masses that a link carries, about its lower end.
	Row inertia; ///< kg·m²: second moment of the same masses.
	std::array<Row, LINKS> factor;
	double factor_half = 0.0; ///< s: step for which `factor` is valid.

	static double width(const undergrowth::StemBeam &stem, double link) {
		return static_cast<double>(stem.diameter) * (1.0 - static_cast<double>(stem.taper) * link / LINKS);
	}

	void find_masses() {
		double above = head_mass;
		for (int i = LINKS - 1; i >= 0; i--) {
			const double arm = i == LINKS - 1 ? h + head_arm : h;
			lever[i] = 0.5 * h * mass[i] + arm * above;
			inertia[i] = h * h * mass[i] / 3.0 + arm * arm * above + (i == LINKS - 1 ? head_inertia : 0.0);
			above += mass[i];
		}
	}

	/// Coupling of links i and j, for small angles.
	double mass_between(int i, int j) const { return i == j ? inertia[i] : h * lever[std::max(i, j)]; }

	/// Finds the slowest small swing by inverse iteration, weight included, and the dashpots for its damping.
	void find_swing(double damping) {
		Row shape;
		shape.fill(1.0);
		double kinetic = 1.0;
		for (int n = 0; n < 60; n++) {
			Row pushed = {};
			kinetic = 0.0;
			for (int i = 0; i < LINKS; i++) {
				for (int j = 0; j < LINKS; j++) {
					pushed[i] += mass_between(i, j) * shape[j];
				}
				kinetic += pushed[i] * shape[i];
			}
			for (double &one : pushed) {
				one /= std::sqrt(kinetic);
			}
			Row pivot;
			for (int i = 0; i < LINKS; i++) {
				pivot[i] = spring[i] + (i + 1 < LINKS ? spring[i + 1] : 0.0) - GRAVITY * lever[i];
			}
			solve_neighbours(pushed, pivot);
			shape = pushed;
			swing = 1.0 / std::sqrt(std::sqrt(kinetic_of(shape)));
		}
		double elastic = 0.0;
		for (int i = 0; i < LINKS; i++) {
			const double turn = shape[i] - (i > 0 ? shape[i - 1] : 0.0);
			elastic += spring[i] * turn * turn;
		}
		dashpot = 2.0 * damping * swing * kinetic_of(shape) / elastic;
	}

	double kinetic_of(const Row &shape) const {
		double sum = 0.0;
		for (int i = 0; i < LINKS; i++) {
			for (int j = 0; j < LINKS; j++) {
				sum += mass_between(i, j) * shape[i] * shape[j];
			}
		}
		return sum;
	}

	/// Residual of all moments about the lower ends of the links at the current angles, rates and accelerations.
	Row apply_wind() const {
		Row result;
		Row side, up; // Forces on each link, with its inertia.
		glm::dvec2 point(0.0, 0.0); // Acceleration of the link's lower end.
		glm::dvec2 speed(0.0, 0.0);
		glm::dvec2 tip(0.0, 0.0); // On the head.
		for (int i = 0; i < LINKS; i++) {
			const glm::dvec2 along(std::sin(angle[i]), std::cos(angle[i]));
			const glm::dvec2 across(along.y, -along.x);
			const glm::dvec2 turn = acceleration[i] * across - rate[i] * rate[i] * along; // Over the distance.
			const glm::dvec2 pull = mass[i] * (glm::dvec2(0.0, -GRAVITY) - point - 0.5 * h * turn) +
					pressed(air[i], speed + 0.5 * h * rate[i] * across, across);
			side[i] = pull.x + force * air[i] / all_air();
			up[i] = pull.y;
			if (i == LINKS - 1) {
				const double arm = h + head_arm;
				tip = head_mass * (glm::dvec2(0.0, -GRAVITY) - point - arm * turn) +
						pressed(head_air, speed + arm * rate[i] * across, across) +
						glm::dvec2(force * head_air / all_air(), 0.0);
			}
			point += h * turn;
			speed += h * rate[i] * across;
		}
		glm::dvec2 above = tip + glm::dvec2(tip_force, 0.0);
		for (int i = LINKS - 1; i >= 0; i--) {
			const glm::dvec2 across(std::cos(angle[i]), -std::sin(angle[i]));
			const glm::dvec2 own(side[i], up[i]);
			const double own_inertia = mass[i] * h * h / 12.0 + (i == LINKS - 1 ? head_inertia : 0.0);
			result[i] = h * glm::dot(across, above + 0.5 * own) - own_inertia * acceleration[i] + joint(i) -
					(i + 1 < LINKS ? joint(i + 1) : 0.0) + (i == LINKS - 1 ? head_arm * glm::dot(across, tip) : 0.0);
			above += own;
		}
		return result;
	}

	glm::dvec2 pressed(double share, const glm::dvec2 &speed, const glm::dvec2 &across) const {
		const double seen = wind == 0.0 ? 0.0 : glm::dot(glm::dvec2(wind, 0.0) - speed, across);
		return share * std::fabs(seen) * seen * across;
	}

	/// Moment of the joint below a link.
	double joint(int i) const {
		const double turn = angle[i] - (i > 0 ? angle[i - 1] : rest);
		const double turning = rate[i] - (i > 0 ? rate[i - 1] : 0.0);
		return -spring[i] * (turn + dashpot * turning);
	}

	/// Solves the system of the springs' matrix with this diagonal in place. Returns the largest component.
	double solve_neighbours(Row &right, Row &pivot) const {
		for (int i = 1; i < LINKS; i++) {
			const double share = spring[i] / pivot[i - 1];
			pivot[i] -= share * spring[i];
			right[i] += share * right[i - 1];
		}
		double max = 0.0;
		for (int i = LINKS - 1; i >= 0; i--) {
			right[i] = (right[i] + (i + 1 < LINKS ? spring[i + 1] * right[i + 1] : 0.0)) / pivot[i];
			max = std::max(max, std::fabs(right[i]));
		}
		return max;
	}

	/// Cholesky factors of masses, dashpots and springs for an acceleration in a step of twice `half`.
	void factorise(double half) {
		const double stiff = half * half + half * dashpot;
		factor_half = half;
		for (int i = 0; i < LINKS; i++) {
			for (int j = 0; j <= i; j++) {
				double sum = mass_between(i, j) * std::cos(angle[i] - angle[j]);
				if (i == j) {
					sum += stiff * (spring[i] + (i + 1 < LINKS ? spring[i + 1] : 0.0));
				} else if (i == j + 1) {
					sum -= stiff * spring[i];
				}
				for (int k = 0; k < j; k++) {
					sum -= factor[i][k] * factor[j][k];
				}
				factor[i][j] = i == j ? std::sqrt(sum) : sum / factor[j][j];
			}
		}
	}

	Row solved(Row right) const {
		for (int i = 0; i < LINKS; i++) {
			for (int k = 0; k < i; k++) {
				right[i] -= factor[i][k] * right[k];
			}
			right[i] /= factor[i][i];
		}
		for (int i = LINKS - 1; i >= 0; i--) {
			for (int k = i + 1; k < LINKS; k++) {
				right[i] -= factor[k][i] * right[k];
			}
			right[i] /= factor[i][i];
		}
		return right;
	}
};
