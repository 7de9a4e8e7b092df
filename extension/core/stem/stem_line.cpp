#include "stem/stem_line.hpp"

#include "conventions.hpp"
#include "wind/air_profile.hpp"

namespace undergrowth {

double StemSpread::beyond(double x) const {
	const double all = terms[0] + terms[1] / 2.0 + terms[2] / 3.0;
	return all - x * (terms[0] + x * (terms[1] / 2.0 + x * (terms[2] / 3.0)));
}

double StemSpread::above(double x) const {
	double sum = beyond(x);
	for (const Point &point : points) {
		sum += point.place > x ? point.amount : 0.0;
	}
	return sum;
}

double StemSpread::total() const {
	double sum = beyond(0.0);
	for (const Point &point : points) {
		sum += point.amount;
	}
	return sum;
}

StemLine::StemLine(const StemBeam &beam) :
		length(beam.length),
		head_mass(beam.head_mass),
		head_centre(beam.head_centre),
		head_inertia(beam.head_inertia),
		section(beam.section),
		diameter(beam.diameter),
		thickness(beam.thickness),
		taper(beam.taper),
		hole(static_cast<double>(beam.hollow) * beam.hollow) {
	spread_mass(beam);
	spread_drag(beam);
	spread_dead(beam);
}

double StemLine::bending(double x) const {
	const double d = diameter * (1.0 - taper * x);
	return section == StemBeam::Section::round ? PI / 64.0 * d * d * d * d * (1.0 - hole * hole)
											   : d * thickness * thickness * thickness / 12.0;
}

void StemLine::spread_mass(const StemBeam &beam) {
	if (section == StemBeam::Section::round) {
		const double base = beam.density * PI / 4.0 * diameter * diameter * (1.0 - hole) * length;
		mass.terms[0] = base + beam.leaf_mass;
		mass.terms[1] = -2.0 * taper * base;
		mass.terms[2] = taper * taper * base;
	} else {
		const double base = beam.density * diameter * thickness * length;
		mass.terms[0] = base + beam.leaf_mass;
		mass.terms[1] = -taper * base;
	}
	for (const StemBeam::Load &load : beam.loads) {
		mass.points.push_back({ load.place, load.mass });
	}
}

void StemLine::spread_drag(const StemBeam &beam) {
	const double half = 0.5 * static_cast<double>(AIR_DENSITY);
	const double base = half * beam.drag_coefficient * diameter * length;
	air.terms[0] = base + half * beam.leaf_drag_area;
	air.terms[1] = -taper * base;
	for (const StemBeam::Load &load : beam.loads) {
		air.points.push_back({ load.place, half * load.drag_area });
	}
	head_air = half * beam.head_drag_area;
}

void StemLine::spread_dead(const StemBeam &beam) {
	if (beam.wind_weights.empty()) {
		const double all = air.total() + head_air;
		for (int i = 0; i < 3; i++) {
			dead.terms[i] = air.terms[i] / all;
		}
		for (const StemSpread::Point &point : air.points) {
			dead.points.push_back({ point.place, point.amount / all });
		}
		head_dead = head_air / all;
		return;
	}
	for (int j = 1; j < beam.joints; j++) {
		dead.points.push_back({ static_cast<double>(j) / beam.joints, beam.wind_weights[j - 1] });
	}
	head_dead = beam.wind_weights[beam.joints - 1];
}

} // namespace undergrowth
