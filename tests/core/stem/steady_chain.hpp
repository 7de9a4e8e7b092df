#pragma once

#include "stem/stem_beam.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

/// A stem as very many rigid links under steady loads, in a plane: the reference for stems. It is independent of the
/// product's beam. Heads are points at their centre; loads at positions are not supported.
class SteadyChain {
public:
	static constexpr double HALF_AIR = 0.5 * 1.225; // kg/m³.

	explicit SteadyChain(const undergrowth::StemBeam &stem, double youngs_modulus, int links = 128) :
			beam(stem),
			modulus(youngs_modulus),
			count(links),
			h(static_cast<double>(stem.length) / links),
			angles(links, 0.0),
			sideways(links, 0.0),
			upward(links, 0.0) {}

	/// Turns the foot by `angle` (rad) from upright, with the wind. At rest the stem is straight under its own weight,
	/// or nods if it is straight without it. Angles and places are then from the foot's direction.
	void lean(double angle, bool nods = false) {
		cosine = std::cos(angle);
		sine = std::sin(angle);
		balanced = nods ? 0.0 : sine;
	}

	/// Equilibrium under `newtons`, distributed as the drag area.
	void settle_dead(double newtons) {
		for (int i = 0; i < count; i++) {
			sideways[i] = cosine * newtons * drag(i) / all_drag();
			upward[i] = sine * newtons * drag(i) / all_drag();
		}
		head_sideways = cosine * newtons * head_drag() / all_drag();
		head_upward = sine * newtons * head_drag() / all_drag();
		relax();
	}

	/// Equilibrium in air of `speed` (m/s), which presses across each link and also moves `down` (m/s).
	void settle_air(double speed, double down = 0.0) {
		wind = { speed, down };
		constexpr double SHARE = 0.15; // Share of each correction that is applied; the whole one would oscillate.
		for (int n = 0; n < 2000; n++) {
			const std::vector<double> before = angles;
			for (int i = 0; i < count; i++) {
				press(angles[i], drag(i), sideways[i], upward[i]);
			}
			press(angles[count - 1], head_drag(), head_sideways, head_upward);
			relax();
			double max = 0.0;
			for (int i = 0; i < count; i++) {
				max = std::max(max, std::abs(angles[i] - before[i]));
				angles[i] = before[i] + SHARE * (angles[i] - before[i]);
			}
			if (max < 1e-6) {
				return;
			}
		}
	}

	/// Equilibrium of a stem whose foot leans by `lean` (rad), under `mass` kg per m² of drag area. Angles are from the
	/// foot's direction.
	void settle_load(double mass, double lean) {
		const auto weight_of = [&](double air) { return 9.81 * mass * air / HALF_AIR; };
		for (int i = 0; i < count; i++) {
			sideways[i] = weight_of(drag(i)) * std::sin(lean);
			upward[i] = -weight_of(drag(i)) * std::cos(lean);
		}
		head_sideways = weight_of(head_drag()) * std::sin(lean);
		head_upward = -weight_of(head_drag()) * std::cos(lean);
		relax();
	}

	/// In stem lengths; x a whole number of links.
	glm::dvec2 place(double x) const {
		glm::dvec2 sum(0.0);
		for (int i = 0; i < static_cast<int>(x * count + 0.5); i++) {
			sum += glm::dvec2(std::sin(angles[i]), std::cos(angles[i])) / static_cast<double>(count);
		}
		return sum;
	}

	double tip_angle() const { return 1.5 * angles[count - 1] - 0.5 * angles[count - 2]; }

	/// Force of the wind relative to that on an upright stem: ∫c cos³θ/∫c.
	double reconfiguration() const {
		double sum = head_drag() * std::pow(std::cos(angles[count - 1]), 3.0);
		for (int i = 0; i < count; i++) {
			sum += drag(i) * std::pow(std::cos(angles[i]), 3.0);
		}
		return sum / all_drag();
	}

private:
	undergrowth::StemBeam beam;
	double modulus;
	int count;
	double h;
	std::vector<double> angles;
	std::vector<double> sideways;
	std::vector<double> upward;
	double head_sideways = 0.0;
	double head_upward = 0.0;
	glm::dvec2 wind = { 0.0, 0.0 };
	double cosine = 1.0; // Of the foot's lean.
	double sine = 0.0;
	double balanced = 0.0; ///< Sine of the lean whose weight is balanced at rest.

	double width(double link) const { return beam.diameter * (1.0 - beam.taper * link / count); }

	/// kg/m of the link: half the air's density times drag area.
	double drag(int link) const {
		return HALF_AIR * h * (beam.drag_coefficient * width(link + 0.5) + beam.leaf_drag_area / beam.length);
	}
	double head_drag() const { return HALF_AIR * beam.head_drag_area; }
	double all_drag() const {
		double sum = head_drag();
		for (int i = 0; i < count; i++) {
			sum += drag(i);
		}
		return sum;
	}

	double weight(int link) const {
		const double d = width(link + 0.5);
		return 9.81 * h * (beam.density * 0.785398163 * d * d + beam.leaf_mass / beam.length);
	}

	/// Bend of a joint: half of the links beside it.
	double joint(int link) const {
		const double d = width(link == 0 ? 0.25 : link);
		return modulus * 0.0490873852 * d * d * d * d / (link == 0 ? 0.5 * h : h);
	}

	void press(double angle, double air, double &aside, double &up) const {
		const glm::dvec2 way(
				cosine * std::cos(angle) - sine * std::sin(angle), sine * std::cos(angle) + cosine * std::sin(angle));
		const double seen = glm::dot(wind, way);
		const double across = air * std::abs(seen) * seen;
		aside = across * std::cos(angle);
		up = -across * std::sin(angle);
	}

	/// Newton's method for loads with constant directions.
	void relax() {
		for (int n = 0; n < 100; n++) {
			std::vector<double> moment(count);
			std::vector<double> pivot(count);
			const double head_weight = 9.81 * beam.head_mass;
			// Of the weight, in the foot's axes. What acts on the straight stem is balanced at rest.
			double below = head_weight;
			double aside = head_sideways;
			double up = head_upward;
			for (int i = count - 1; i >= 0; i--) {
				const double arm = i == count - 1 ? beam.head_centre : 0.0;
				const double heavy = h * (below + 0.5 * weight(i)) + arm * head_weight;
				const double x = h * (aside + 0.5 * sideways[i]) + arm * head_sideways + heavy * sine;
				const double y = h * (up + 0.5 * upward[i]) + arm * head_upward - heavy * cosine;
				const double across = std::cos(angles[i]);
				const double along = std::sin(angles[i]);
				moment[i] = x * across - y * along - heavy * balanced -
						joint(i) * (angles[i] - (i > 0 ? angles[i - 1] : 0.0));
				pivot[i] = x * along + y * across + joint(i);
				if (i < count - 1) {
					moment[i] += joint(i + 1) * (angles[i + 1] - angles[i]);
					pivot[i] += joint(i + 1);
				}
				below += weight(i);
				aside += sideways[i];
				up += upward[i];
			}
			if (turn(moment, pivot) < 1e-11) {
				return;
			}
		}
	}

	double turn(std::vector<double> &moment, std::vector<double> &pivot) {
		for (int i = 1; i < count; i++) {
			const double share = joint(i) / pivot[i - 1];
			pivot[i] -= share * joint(i);
			moment[i] += share * moment[i - 1];
		}
		double max = 0.0;
		for (int i = count - 1; i >= 0; i--) {
			moment[i] = (moment[i] + (i < count - 1 ? joint(i + 1) * moment[i + 1] : 0.0)) / pivot[i];
			max = std::max(max, std::abs(moment[i]));
		}
		for (int i = 0; i < count; i++) {
			angles[i] += moment[i] * std::min(1.0, 0.1 / std::max(max, 1e-300));
		}
		return max;
	}
};
