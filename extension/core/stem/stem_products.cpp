#include "stem/stem_products.hpp"

namespace undergrowth {

namespace {

constexpr int CELLS = 64;
constexpr double GAUSS_PLACE[2] = { 0.21132486540518712, 0.78867513459481288 };

} // namespace

double head_deflection(const StemLine &line, const StemCurve &curve) {
	return curve.deflection(1.0) + line.head_centre / line.length * curve.slope(1.0);
}

double air_product(const StemLine &line, const StemCurve &one, const StemCurve *other) {
	const double head = head_deflection(line, one) * (other != nullptr ? head_deflection(line, *other) : 1.0);
	double sum = line.head_air * head;
	for (int i = 0; i < CELLS; i++) {
		for (const double place : GAUSS_PLACE) {
			const double x = (i + place) / CELLS;
			const double value = one.deflection(x) * (other != nullptr ? other->deflection(x) : 1.0);
			sum += 0.5 / CELLS * line.air.at(x) * value;
		}
	}
	for (const StemSpread::Point &point : line.air.points) {
		const double value = one.deflection(point.place);
		sum += point.amount * value * (other != nullptr ? other->deflection(point.place) : 1.0);
	}
	return sum;
}

double axial_share(const StemLine &line, const StemCurve &steady) {
	const double tip = steady.slope(1.0);
	const double arm = line.head_dead * line.head_centre / line.length;
	double above = arm * tip * tip;
	double below = arm * tip;
	for (int i = 0; i < CELLS; i++) {
		for (const double place : GAUSS_PLACE) {
			const double x = (i + place) / CELLS;
			const double slope = steady.slope(x);
			const double weight = 0.5 / CELLS * (line.dead.above(x) + line.head_dead);
			above += weight * slope * slope;
			below += weight * slope;
		}
	}
	return above / (tip * below);
}

} // namespace undergrowth
