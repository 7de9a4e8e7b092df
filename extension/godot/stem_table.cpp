#include "stem_table.hpp"

#include "form/grown_plant.hpp"
#include "mesh/form_stem.hpp"
#include "stem/stem_shape.hpp"

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr double HEIGHT_RATIO = 1.1; // Of neighbouring classes.
static constexpr float SHORTEST = 0.005f; // m.
static constexpr float LONGEST = 100.0f;

StemBeam StemTable::nothing() {
	StemBeam beam;
	beam.length = 0.0f;
	return beam;
}

void StemTable::forget_stems() {
	solved.clear();
	usual = 0.0f;
	fault = String();
}

void StemTable::learn(const SampledPlant &plant) {
	drawn = StemBeam();
	drawn.length = std::clamp(plant.height, SHORTEST, LONGEST); // One of another length is that one, scaled.
	if (plant.grown) {
		carry_parts(plant.grown->form, drawn);
	} else {
		carry_lathe(plant.cross_section.radius, plant.widths, drawn);
	}
}

std::shared_ptr<const StemConstants> StemTable::of(
		float height, bool in_air, const Motion &motion, const Ref<PlantStem> &stem) {
	const bool is_physical = stem.is_valid() && stem->is_physical();
	const double ratio = height > 0.0f ? double(height) / double(drawn.length) : 1.0;
	const int number = is_physical ? int(std::lround(std::log(ratio) / std::log(HEIGHT_RATIO))) : 0;
	Stem &found = solved[number];
	if (!found.in_newtons) {
		found.in_newtons = std::make_shared<const StemConstants>(solve(number, motion, stem));
		found.in_air = std::make_shared<const StemConstants>(undergrowth::in_air(*found.in_newtons));
	}
	return in_air ? found.in_air : found.in_newtons;
}

// A new wind blows with newtons that suit kilograms, and most stems weigh grams. What the joints weigh counts besides.
static float usual_weight(const StemBeam &beam, const StemSolution &solution) {
	const StemConstants &stem = solution.constants;
	StemBeam plain = beam;
	plain.wind_weights.clear();
	const float slope = beam.wind_weights.empty() ? stem.dead_slope : solve_stem(plain).constants.dead_slope;
	const float frequency = stem.mode[0].frequency;
	return 1.0f / (frequency * frequency * stem.length * slope);
}

StemConstants StemTable::solve(int number, const Motion &motion, const Ref<PlantStem> &stem) {
	const bool is_usual = motion.wind_weight < 0.0f;
	if (is_usual && number != 0 && usual == 0.0f) {
		solve(0, motion, stem);
	}
	StemBeam beam = drawn;
	beam.length *= float(std::pow(HEIGHT_RATIO, number));
	beam.natural_frequency = motion.natural_frequency;
	beam.damping_ratio = motion.damping_ratio;
	if (stem.is_valid()) {
		stem->tell(beam);
	}
	StemSolution solution = solve_stem(beam);
	if (solution.fault != StemFault::none) {
		fault = String::utf8(describe(solution.fault));
		StemBeam bare;
		bare.length = std::clamp(beam.length, SHORTEST, LONGEST);
		bare.joints = beam.joints;
		bare.modes = beam.modes;
		solution = solve_stem(bare);
	}
	if (is_usual && number == 0) {
		usual = usual_weight(beam, solution);
	}
	solution.constants.dead_slope *= is_usual ? usual : motion.wind_weight;
	return solution.constants;
}

} // namespace undergrowth
