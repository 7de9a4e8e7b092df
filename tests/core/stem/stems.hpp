#pragma once

#include "conventions.hpp"
#include "stem/stem_beam.hpp"

#include <glm/vec2.hpp>

#include <cmath>

/// kg, of the bare stem.
inline double mass_of(const undergrowth::StemBeam &beam) {
	const double t = beam.taper;
	const double base = beam.density * undergrowth::PI / 4.0 * beam.diameter * beam.diameter;
	return base * beam.length * (1.0 - t + t * t / 3.0);
}

/// m⁴, at the root.
inline double root_bending(const undergrowth::StemBeam &beam) {
	return undergrowth::PI / 64.0 * beam.diameter * beam.diameter * beam.diameter * beam.diameter;
}

/// A stem of 0.6 m with a head of `head` times the mass of the stem.
inline undergrowth::StemBeam stem_of(double taper = 0.0, double head = 0.0, double frequency = 1.5) {
	undergrowth::StemBeam beam;
	beam.taper = static_cast<float>(taper);
	beam.natural_frequency = static_cast<float>(frequency);
	beam.head_mass = static_cast<float>(head * mass_of(beam));
	return beam;
}

/// The solved stem, with `joints` joints and `modes` modes.
inline undergrowth::StemConstants jointed(int joints, double taper, double head, int modes = 2) {
	undergrowth::StemBeam beam = stem_of(taper, head);
	beam.joints = joints;
	beam.modes = modes;
	return solve_stem(beam).constants;
}

/// The same as stem_of(), so stiff that its weight has no effect.
inline undergrowth::StemBeam stiff_stem(double taper = 0.0, double head = 0.0) {
	undergrowth::StemBeam beam = stem_of(taper, head, 0.0);
	beam.length = 1.0f;
	beam.diameter = 0.02f;
	beam.density = 10.0f;
	beam.youngs_modulus = 1e12f;
	beam.head_mass = static_cast<float>(head * mass_of(beam));
	return beam;
}

/// rad/s: √(EI/(m·L³)), the unit of beam frequencies.
inline double beam_rate(const undergrowth::StemBeam &beam, double youngs_modulus) {
	const double l = beam.length;
	return std::sqrt(youngs_modulus * root_bending(beam) / (mass_of(beam) * l * l * l));
}

/// Amplitudes at rest in a wind that gives the linear tip this slope.
struct SteadyStem {
	glm::vec2 amplitudes[undergrowth::MAX_STEM_MODES];
};

inline SteadyStem in_newtons(const undergrowth::StemConstants &stem, double slope) {
	const double tip = slope / (1.0 + std::sqrt(1.0 + slope * slope));
	SteadyStem steady = {};
	for (int k = 0; k < stem.modes; k++) {
		steady.amplitudes[k].x = static_cast<float>(stem.mode[k].dead_share * tip);
	}
	return steady;
}

inline SteadyStem in_wind(const undergrowth::StemConstants &stem, double slope) {
	const double sine = 2.0 * slope / (1.0 + std::sqrt(1.0 + 4.0 * slope * slope));
	SteadyStem steady = {};
	for (int k = 0; k < stem.modes; k++) {
		steady.amplitudes[k].x =
				static_cast<float>(stem.mode[k].air_share * sine / (1.0 + std::sqrt(1.0 - sine * sine)));
	}
	return steady;
}
