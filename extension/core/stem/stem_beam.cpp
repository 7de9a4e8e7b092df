#include "stem/stem_beam.hpp"

#include "conventions.hpp"
#include "stem/stem_along.hpp"
#include "stem/stem_elements.hpp"
#include "stem/stem_grade.hpp"
#include "stem/stem_ground.hpp"
#include "stem/stem_large.hpp"
#include "stem/stem_products.hpp"
#include "stem/stem_shape.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr double MIN_REST = 1e-16; // Of the energy of the static shape: a smaller rest is rounding.
constexpr int CELLS = STEM_SAMPLES - 1;

/// A shape with its scalar products. The deflection is scaled to a max slope of 1.
struct Shape {
	StemCurve curve;
	double frequency = 0.0;
	double stiffness = 0.0;
	double dead = 0.0; ///< φᵀf/κ; finally its fraction of a bend with tip slope 1.
	double air = 0.0;
};

/// Every `step`-th number from `first` on becomes a term.
void write_terms(const StemSamples &samples, float *first, int step) {
	const StemTerms terms = fit_shape(samples);
	for (int j = 0; j < STEM_SHAPE_TERMS; j++) {
		first[j * step] = static_cast<float>(terms[j]);
	}
}

/// Intermediate results from a sound stem to its constants.
class Solver {
public:
	Solver(const StemBeam &stem, StemSolution &result) : beam(stem), line(stem), elements(line), solution(result) {}

	StemFault solve();

private:
	const StemBeam &beam;
	const StemLine line;
	const StemElements elements;
	StemSolution &solution;
	StemMatrix stiff;
	StemCurve dead_load;
	StemCurve air_load;
	StemCurve dead_curve; ///< Under one newton.
	double dead_slope = 0.0; ///< 1/N.
	double air_slope = 0.0; ///< s²/m².
	Shape shapes[MAX_STEM_MODES];

	double find_modulus() const;
	void find_shapes(const StemFactors &factors);
	void choose_shapes(const StemEigen &first, const StemEigen &second);
	void divide_loads();
	Shape shape_of(StemCurve curve, double frequency) const;
	void write_mode(int k);
	void write_deflections();
	void write_shapes();
	void write_chords();
	StemSamples slopes_of(const StemCurve &curve) const;
};

double Solver::find_modulus() const {
	const double turns = 2.0 * PI * beam.natural_frequency;
	if (turns == 0.0) {
		return beam.youngs_modulus;
	}
	const StemMatrix needed = elements.gravity.mixed(1.0, elements.mass, turns * turns);
	return 1.0 / smallest_eigen(StemFactors(elements.stiffness), needed).value;
}

StemFault Solver::solve() {
	solution.youngs_modulus = find_modulus();
	const double share =
			1.0 / smallest_eigen(StemFactors(elements.stiffness), elements.gravity).value / solution.youngs_modulus;
	solution.buckling_share = share;
	stiff = elements.stiffness.mixed(solution.youngs_modulus, elements.gravity, -1.0);
	const StemFactors factors(stiff);
	if (!factors.is_sound() || share >= 1.0) {
		return StemFault::falls;
	}
	find_shapes(factors);
	StemConstants &constants = solution.constants;
	constants.length = beam.length;
	constants.modes = beam.modes;
	constants.joints = beam.joints;
	constants.dead_slope = static_cast<float>(dead_slope);
	constants.air_slope = static_cast<float>(air_slope);
	constants.axial_share = static_cast<float>(axial_share(line, dead_curve));
	for (int k = 0; k < beam.modes; k++) {
		write_mode(k);
		constants.mode[k].dead_share = static_cast<float>(shapes[k].dead);
		constants.mode[k].air_share = static_cast<float>(shapes[k].air);
	}
	write_deflections();
	write_shapes();
	write_chords();
	return StemFault::none;
}

void Solver::find_shapes(const StemFactors &factors) {
	const StemEigen first = smallest_eigen(factors, elements.mass);
	const StemEigen second = smallest_eigen(factors, elements.mass, &first.curve);
	solution.frequencies[0] = std::sqrt(first.value);
	solution.frequencies[1] = std::sqrt(second.value);
	dead_load = load_of(line, line.dead, line.head_dead);
	air_load = load_of(line, line.air, line.head_air);
	dead_curve = factors.solve(dead_load);
	dead_slope = dead_curve.slope(1.0) / line.length;
	air_slope = factors.solve(air_load).slope(1.0) / line.length;
	choose_shapes(first, second);
	divide_loads();
}

// The last shape is the static one minus the modes before it. If that is nothing but rounding, as under a heavy head
// with wind on the head alone, the next mode replaces it.
void Solver::choose_shapes(const StemEigen &first, const StemEigen &second) {
	if (beam.modes == 1) {
		shapes[0] = shape_of(dead_curve, solution.frequencies[0]);
		return;
	}
	shapes[0] = shape_of(first.curve, solution.frequencies[0]);
	StemCurve rest = dead_curve;
	rest.add(shapes[0].curve, -shapes[0].dead);
	const bool is_something = rest.dot(stiff.times(rest)) > MIN_REST * dead_curve.dot(dead_load);
	shapes[1] = shape_of(is_something ? rest : second.curve, solution.frequencies[1]);
}

// Divides the bends by the loads so that the tip's is right in both winds. The shapes are computed for a wind in
// newtons. If a wind in m/s acts elsewhere, the first shape takes the rest.
void Solver::divide_loads() {
	double dead_rest = 1.0;
	double air_rest = 1.0;
	for (int k = 0; k < beam.modes; k++) {
		const double tip = shapes[k].curve.slope(1.0) / line.length;
		shapes[k].dead /= dead_slope;
		shapes[k].air /= air_slope;
		dead_rest -= tip * shapes[k].dead;
		air_rest -= tip * shapes[k].air;
	}
	shapes[0].dead += dead_rest / (shapes[0].curve.slope(1.0) / line.length);
	shapes[0].air += air_rest / (shapes[0].curve.slope(1.0) / line.length);
}

Shape Solver::shape_of(StemCurve curve, double frequency) const {
	double max = 0.0;
	for (int i = 0; i < STEM_SAMPLES; i++) {
		max = std::max(max, std::fabs(curve.slope(static_cast<double>(i) / CELLS)));
	}
	curve.scale((curve.slope(1.0) < 0.0 ? -1.0 : 1.0) * line.length / max);
	Shape shape;
	shape.curve = curve;
	shape.frequency = frequency;
	shape.stiffness = curve.dot(stiff.times(curve));
	shape.dead = curve.dot(dead_load) / shape.stiffness;
	shape.air = curve.dot(air_load) / shape.stiffness;
	return shape;
}

void Solver::write_mode(int k) {
	const Shape &shape = shapes[k];
	StemMode &mode = solution.constants.mode[k];
	mode.frequency = static_cast<float>(shape.frequency);
	mode.damping = beam.damping_ratio;
	mode.stiffness = static_cast<float>(shape.stiffness);
	mode.mass = static_cast<float>(shape.stiffness / (shape.frequency * shape.frequency));
	mode.tip_slope = static_cast<float>(shape.curve.slope(1.0) / line.length);
	mode.air_drag = static_cast<float>(air_product(line, shape.curve, &shape.curve));
	mode.air_lag = static_cast<float>(
			air_product(line, shape.curve, &shapes[0].curve) / air_product(line, shapes[0].curve, nullptr));
}

void Solver::write_deflections() {
	for (int k = 0; k < beam.modes; k++) {
		for (int j = 1; j <= beam.joints; j++) {
			solution.constants.deflection[j - 1][k] =
					static_cast<float>(shapes[k].curve.deflection(static_cast<double>(j) / beam.joints));
		}
		solution.constants.deflection[beam.joints][k] = static_cast<float>(head_deflection(line, shapes[k].curve));
	}
}

StemSamples Solver::slopes_of(const StemCurve &curve) const {
	StemSamples slopes;
	for (int i = 0; i < STEM_SAMPLES; i++) {
		slopes[i] = curve.slope(static_cast<double>(i) / CELLS) / line.length;
	}
	return slopes;
}

void Solver::write_shapes() {
	StemSamples dead_shape = {};
	StemSamples air_shape = {};
	StemConstants &constants = solution.constants;
	for (int k = 0; k < beam.modes; k++) {
		const StemSamples slopes = slopes_of(shapes[k].curve);
		write_terms(slopes, constants.shape[0] + k, 4);
		for (int i = 0; i < STEM_SAMPLES; i++) {
			dead_shape[i] += slopes[i] * shapes[k].dead;
			air_shape[i] += slopes[i] * shapes[k].air;
		}
	}
	const StemChain chain(line, solution.youngs_modulus);
	const LargeBends dead = large_bends_of_newtons(chain, dead_shape, 1.0 / dead_slope);
	write_terms(dead.x3, constants.shape[0] + 2, 4);
	write_terms(dead.x5, constants.shape[0] + 3, 4);
	const LargeBends air = large_bends_of_air(chain, air_shape, 1.0 / air_slope);
	write_terms(air.x3, constants.air_shape[0], 2);
	write_terms(air.x5, constants.air_shape[0] + 1, 2);
	constants.dead_along = along_of_newtons(chain, constants);
	constants.air_along = along_of_air(chain, constants);
	constants.nod = beam.nods ? nod_of(chain, constants) : StemNod{};
}

void Solver::write_chords() {
	StemConstants &constants = solution.constants;
	const StemChords dead = chords_of(constants);
	const StemChords air = chords_of(in_air(constants));
	constants.mode[0].chord = std::max(dead.first, air.first);
	constants.mode[1].chord = std::max(dead.second, air.second);
}

} // namespace

/// Of a uniform distribution with a standard deviation of 1: √3.
static constexpr float UNIFORM_HALF_WIDTH = 1.7320508f;

/// m², drag coefficients included.
static float drag_area_of(const StemBeam &beam) {
	const float bare = beam.drag_coefficient * beam.diameter * beam.length * (1.0f - 0.5f * beam.taper);
	float area = bare + beam.head_drag_area + beam.leaf_drag_area;
	for (const StemBeam::Load &load : beam.loads) {
		area += load.drag_area;
	}
	return area;
}

StemSolution solve_stem(const StemBeam &beam) {
	StemSolution solution;
	solution.fault = find_fault(beam);
	if (solution.fault == StemFault::none) {
		solution.fault = Solver(beam, solution).solve();
	}
	if (solution.fault != StemFault::none) {
		solution.constants = StemConstants();
		return solution;
	}
	if (beam.natural_frequency == 0.0f || beam.frequency_by_length) {
		StemBeam stiff = beam;
		stiff.youngs_modulus = static_cast<float>(solution.youngs_modulus);
		grade_by_height(stiff, solution.constants);
	}
	solution.constants.drag_area = drag_area_of(beam);
	solution.constants.spread = UNIFORM_HALF_WIDTH * beam.frequency_deviation;
	return solution;
}

} // namespace undergrowth
