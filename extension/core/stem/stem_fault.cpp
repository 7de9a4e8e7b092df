#include "stem/stem_beam.hpp"

#include <algorithm>

namespace undergrowth {

namespace {

/// False for NaN.
bool lies(double value, double min, double max) {
	return value >= min && value <= max;
}

bool is_sound(const StemBeam::Load &load) {
	return lies(load.place, 0.0, 1.0) && lies(load.mass, 0.0, 1000.0) && lies(load.drag_area, 0.0, 100.0);
}

bool is_head_sound(const StemBeam &beam) {
	return lies(beam.head_mass, 0.0, 1000.0) && lies(beam.head_centre, 0.0, beam.length) &&
			lies(beam.head_inertia, 0.0, 1000.0) && lies(beam.head_drag_area, 0.0, 100.0);
}

bool are_weights_sound(const StemBeam &beam) {
	const std::vector<float> &weights = beam.wind_weights;
	return weights.empty() ||
			(static_cast<int>(weights.size()) == beam.joints &&
					std::all_of(weights.begin(), weights.end(), [](float w) { return lies(w, 0.0, 1000.0); }) &&
					std::any_of(weights.begin(), weights.end(), [](float w) { return w >= 1e-6f; }));
}

} // namespace

StemFault find_fault(const StemBeam &beam) {
	const bool is_blade = beam.section == StemBeam::Section::blade;
	const bool is_declared = beam.natural_frequency != 0.0f;
	const struct {
		bool sound;
		StemFault fault;
	} checks[] = {
		{ lies(beam.length, 0.00499, 100.0), StemFault::length }, // 0.005 as a float is slightly less.
		{ lies(beam.joints, 1, MAX_STEM_JOINTS), StemFault::joints },
		{ lies(beam.modes, 1, MAX_STEM_MODES), StemFault::modes },
		{ lies(beam.diameter, 2e-5, beam.length), StemFault::diameter },
		{ !is_blade || lies(beam.thickness, 1e-5, beam.diameter), StemFault::thickness },
		{ lies(beam.taper, 0.0, 0.9001), StemFault::taper },
		{ is_blade || lies(beam.hollow, 0.0, 0.95), StemFault::hollow },
		{ lies(beam.density, 1.0, 20000.0), StemFault::density },
		{ lies(beam.drag_coefficient, 0.01, 10.0), StemFault::drag },
		{ !is_declared || lies(beam.natural_frequency, 0.02, 100.0), StemFault::frequency },
		{ is_declared || lies(beam.youngs_modulus, 1e4, 1e12), StemFault::stiffness },
		{ lies(beam.frequency_deviation, 0.0, 0.3001), StemFault::deviation },
		{ lies(beam.damping_ratio, 0.0, 1.0), StemFault::damping },
		{ is_head_sound(beam), StemFault::head },
		{ lies(beam.leaf_mass, 0.0, 1000.0) && lies(beam.leaf_drag_area, 0.0, 100.0), StemFault::leaves },
		{ std::all_of(beam.loads.begin(), beam.loads.end(), is_sound), StemFault::loads },
		{ are_weights_sound(beam), StemFault::weights },
	};
	for (const auto &check : checks) {
		if (!check.sound) {
			return check.fault;
		}
	}
	return StemFault::none;
}

const char *describe(StemFault fault) {
	switch (fault) {
		case StemFault::none:
			return "The stem is sound.";
		case StemFault::length:
			return "The stem's length is out of range: use 0.005 to 100 m.";
		case StemFault::joints:
			return "The stem's number of joints is out of range: use 1 to 8.";
		case StemFault::modes:
			return "The stem's number of modes is out of range: use 1 or 2.";
		case StemFault::diameter:
			return "The stem's diameter is out of range: use 0.00002 m to the stem's length.";
		case StemFault::thickness:
			return "The blade's thickness is out of range: use 0.00001 m to its width.";
		case StemFault::taper:
			return "The stem's taper is out of range: use 0 to 0.9.";
		case StemFault::hollow:
			return "The stem's hole is out of range: use 0 to 0.95 of its diameter.";
		case StemFault::density:
			return "The stem's density is out of range: use 1 to 20000 kg/m³.";
		case StemFault::drag:
			return "The stem's drag coefficient is out of range: use 0.01 to 10.";
		case StemFault::frequency:
			return "The stem's natural frequency is out of range: use 0.02 to 100 Hz, or set youngs_modulus of its "
				   "PlantStem instead.";
		case StemFault::stiffness:
			return "The stem's Young's modulus is out of range: use 10000 Pa to 1e12 Pa.";
		case StemFault::deviation:
			return "The deviation of the stem's frequency is out of range: use 0 to 0.3.";
		case StemFault::damping:
			return "The stem's damping ratio is out of range: use 0 to 1.";
		case StemFault::head:
			return "The stem's head is out of range: use a mass of 0 to 1000 kg, a centre 0 m to the stem's length "
				   "above "
				   "the tip, an inertia of 0 to 1000 kg·m² and a drag area of 0 to 100 m².";
		case StemFault::leaves:
			return "The stem's leaves are out of range: use a mass of 0 to 1000 kg and a drag area of 0 to 100 m².";
		case StemFault::loads:
			return "A load on the stem is out of range: use a place from 0 to 1, a mass of 0 to 1000 kg and a drag "
				   "area of "
				   "0 to 100 m².";
		case StemFault::weights:
			return "The stem's wind weights do not match its joints: set one from 0 to 1000 for each joint, not all 0, "
				   "or set none.";
		case StemFault::falls:
			return "The stem buckles under its own weight: increase its Young's modulus or diameter, reduce its head "
				   "and leaves, or set a natural frequency.";
	}
	return "";
}

} // namespace undergrowth
