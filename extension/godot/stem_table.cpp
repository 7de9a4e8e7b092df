#include "stem_table.hpp"

#include "form/grown_plant.hpp"
#include "mesh/form_stem.hpp"

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr double HEIGHT_RATIO = 1.1; // Of neighbouring classes.

void StemTable::clear() {
	solved.clear();
	reference = 0.0f;
	fault = String();
}

int StemTable::class_of(float height, bool is_physical) const {
	return is_physical ? int(std::lround(std::log(double(height) / reference) / std::log(HEIGHT_RATIO))) : 0;
}

static StemBeam beam_of(float height, const SampledPlant &drawn, const Motion &motion) {
	StemBeam beam;
	beam.length = height;
	beam.natural_frequency = motion.natural_frequency;
	beam.damping_ratio = motion.damping_ratio;
	if (drawn.grown) {
		carry_parts(drawn.grown->form, beam);
	} else {
		carry_lathe(drawn.cross_section.radius, drawn.widths, beam);
	}
	return beam;
}

std::shared_ptr<const StemConstants> StemTable::of(
		float height, const SampledPlant &drawn, const Motion &motion, const Ref<PlantStem> &stem) {
	if (reference <= 0.0f) {
		reference = height;
	}
	const int number = class_of(height, stem.is_valid() && stem->is_physical());
	std::shared_ptr<const StemConstants> &found = solved[number];
	if (found) {
		return found;
	}
	StemBeam beam = beam_of(float(reference * std::pow(HEIGHT_RATIO, number)), drawn, motion);
	if (stem.is_valid()) {
		stem->tell(beam);
	}
	StemSolution solution = solve_stem(beam);
	if (solution.fault != StemFault::none) {
		fault = describe(solution.fault);
		StemBeam bare;
		bare.length = beam.length;
		bare.joints = beam.joints;
		bare.modes = beam.modes;
		solution = solve_stem(bare);
	}
	solution.constants.dead_slope *= motion.wind_weight;
	found = std::make_shared<const StemConstants>(solution.constants);
	return found;
}

} // namespace undergrowth
