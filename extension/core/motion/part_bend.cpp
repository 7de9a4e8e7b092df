#include "motion/part_bend.hpp"

#include "conventions.hpp"
#include "motion/stem_state.hpp"
#include "stem/stem_bones.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

// undergrowth_swing.gdshaderinc has the same numbers.
constexpr float STIFF = 6.0f; // Hz: such parts yield half as much as soft ones.
constexpr float PRESS = 0.45f; // Fraction of the stem's own bend, for wind from the side.
// Increase on the windward side and decrease on the lee side, as a fraction of PRESS.
constexpr float PRESS_OF_LEE = 0.4f;
constexpr float LAG = 0.8f; // rad of the part's own swing.
constexpr float FLUTTER = 0.12f; // Amplitude in fast air.
constexpr float ONSET = 0.12f; // m/s per Hz: slowest air that makes parts flutter.
// Air at a plant relative to its surroundings: upright plants are in a lull, bent ones in a gust.
constexpr float LULL = 0.75f;
constexpr float GUST = 0.5f;
constexpr float FLUTTER_OF_LEE = 0.5f;
constexpr float CALMED = 4.0f; // Per damping ratio.
constexpr float SLOW = 0.625f; // Frequency of the second swing of a flutter, over the first.
// First mode of an even cantilever on a base that turns: the turn of its chord (Craig and Kurdila 2006).
constexpr float TURNED_BASE = 1.14f;
constexpr float DRAG = 0.15f; // Damping ratio by the air of a part that its carrier drives.
constexpr float ASIDE = 0.4f; // Of the flutter.
constexpr float DROP = 0.12f; // Amplitude after a drop.
// Whether a drop falls in a second: multiples of this number (1 over the plastic number) are spread evenly within 0
// to 1.
constexpr float DROP_STEP = 0.7548777f;
constexpr float DROP_OF_PHASE = 13.7f; // Seconds, so that drops do not fall on all parts at once.
constexpr float INWARD = 0.12f; // About 14°: max bend of a part towards its stem.
constexpr float HEAD = 0.6f; // Heads turn as a whole.
constexpr float CALM = 2e-3f; // A stem with a smaller bend is at rest: the resolution of half floats.
constexpr float EPSILON = 1e-6f;
// From a third of the height on a plant leans as its stem does; same in undergrowth_stem.gdshaderinc.
constexpr float LEANS = 3.0f;

struct PartWind {
	glm::vec2 way = glm::vec2(0.0f); ///< Unit, or zero in calm air.
	float far = 0.0f; ///< Bend of the stem by the wind.
	float air = 0.0f; ///< m/s.
};

float wave(float cycles) {
	return static_cast<float>(std::sin(2.0 * PI * (cycles - std::floor(cycles))));
}

/// Value of a response to a base with this wave.
float response_wave(float cycles, const glm::vec2 &response) {
	const double turn = 2.0 * PI * (cycles - std::floor(cycles));
	return response.x * static_cast<float>(std::sin(turn)) - response.y * static_cast<float>(std::cos(turn));
}

/// Bend of a part by the last drop on it: at most one in each second of the clock.
float bend_by_drops(const PartMotion &part, float clock, float chance) {
	constexpr float SECONDS = static_cast<float>(SWING_PERIOD);
	const float at = clock * SECONDS + DROP_OF_PHASE * part.phase;
	const float second = std::floor(at);
	const float since = at - second;
	const float toss = DROP_STEP * (second - SECONDS * std::floor(second / SECONDS)) + DROP_OF_PHASE * part.phase;
	if (toss - std::floor(toss) >= chance) {
		return 0.0f;
	}
	const float left = (1.0f - since) * (1.0f - since);
	const float turns = part.frequency * since;
	return DROP * left * std::exp(-2.0f * static_cast<float>(PI) * part.damping_ratio * turns) * wave(turns);
}

glm::quat quaternion_of(const glm::vec2 &bend) {
	const float scale = 1.0f / std::sqrt(1.0f + glm::dot(bend, bend));
	return glm::quat(scale, bend.y * scale, 0.0f, -bend.x * scale);
}

/// Wind and air as parts of a stem feel them.
PartWind wind_on(const StemMotion &stem) {
	const glm::vec2 away = stem.bend - stem.rest;
	const float distance = glm::length(away);
	PartWind wind;
	wind.far = std::max(distance - CALM, 0.0f);
	wind.way = distance > CALM ? away / distance : glm::vec2(0.0f);
	const float gust = wind.far / (1.0f + wind.far);
	wind.air = stem.air * (LULL + GUST * gust) + stem.stirred * gust;
	return wind;
}

float softness_of(const PartMotion &part) {
	const float stiffness = part.frequency / STIFF;
	return 1.0f / (1.0f + stiffness * stiffness);
}

/// The two swings of a flutter, each at its own frequency.
struct FlutterWaves {
	float one, other;
};

/// Cycles of both swings at the time of `stem`.
FlutterWaves flutter_cycles(const PartMotion &part, const StemMotion &stem) {
	const float swings = part.frequency * static_cast<float>(SWING_PERIOD);
	const float slow = std::floor(SLOW * swings + 0.5f); // Also a whole number.
	return { stem.clock * swings + part.phase + stem.turns, stem.clock * slow + 2.618f * part.phase + stem.turns };
}

/// Bend of a part by its flutter, for these values of its waves.
glm::vec2 flutter_bend(const PartMotion &part, const PartWind &wind, const FlutterWaves &waves) {
	const float lee = glm::dot(part.side, wind.way);
	const float strength = std::sqrt(std::max(1.0f - ONSET * part.frequency / std::max(wind.air, EPSILON), 0.0f));
	const float flutter = FLUTTER * softness_of(part) / (1.0f + CALMED * part.damping_ratio) *
			(1.0f + FLUTTER_OF_LEE * lee) * strength;
	const glm::vec2 flap = part.is_head() ? wind.way : part.side;
	return flap * (flutter * (0.7f * waves.one + 0.3f * waves.other)) +
			glm::vec2(-flap.y, flap.x) * (flutter * ASIDE * waves.other);
}

/// Bend of a part by the flutter of one of its carriers.
glm::vec2 driven_bend(
		const PartMotion &part, const StemMotion &stem, const PartWind &wind, const CarrierSwing &carrier) {
	const float ratio = carrier.swing.frequency / part.frequency;
	const float damping = part.damping_ratio + DRAG;
	const glm::vec2 fast = response_to_base(ratio, damping);
	const glm::vec2 slow = response_to_base(SLOW * ratio, damping);
	const FlutterWaves cycles = flutter_cycles(carrier.swing, stem);
	const FlutterWaves waves = { response_wave(cycles.one, fast), response_wave(cycles.other, slow) };
	return (TURNED_BASE * carrier.weight) * flutter_bend(carrier.swing, wind, waves);
}

} // namespace

glm::vec2 response_to_base(float ratio, float damping_ratio) {
	const float square = ratio * ratio;
	const float off = 1.0f - square;
	const float lost = 2.0f * damping_ratio * ratio;
	const float share = square / std::max(off * off + lost * lost, EPSILON);
	return { share * off, share * lost };
}

glm::vec2 part_bend(const PartMotion &part, const StemMotion &stem) {
	return part_bend(part, stem, nullptr, 0);
}

glm::vec2 part_bend(const PartMotion &part, const StemMotion &stem, const CarrierSwing *carriers, int count) {
	const PartWind wind = wind_on(stem);
	const float lee = glm::dot(part.side, wind.way);
	const float soft = softness_of(part);
	float faster = 1.0f;
	glm::vec2 driven(0.0f);
	for (int i = 0; i < count; i++) {
		faster += carriers[i].weight * PRESS * softness_of(carriers[i].swing);
		driven += driven_bend(part, stem, wind, carriers[i]);
	}
	const float lag = faster * (LAG + 2.0f * part.damping_ratio) / (2.0f * static_cast<float>(PI) * part.frequency);
	glm::vec2 bend = wind.way * (wind.far * PRESS * soft * (1.0f - PRESS_OF_LEE * lee)) -
			stem.rate * (lag / (1.0f + glm::dot(stem.bend, stem.bend)));

	const FlutterWaves cycles = flutter_cycles(part, stem);
	bend += flutter_bend(part, wind, { wave(cycles.one), wave(cycles.other) });
	bend += driven;

	if (stem.drops > 0.0f) {
		bend += part.side * (soft * bend_by_drops(part, stem.clock, stem.drops));
	}

	const float inward = std::max(-glm::dot(bend, part.side), 0.0f);
	const float outward = std::max(glm::dot(bend, part.side), 0.0f);
	bend += part.side * (inward - inward / (1.0f + inward / INWARD) - outward + outward / (1.0f + outward / part.room));
	bend *= part.is_head() ? HEAD : 1.0f;
	const float size = glm::length(bend) / MAX_PART_BEND;
	return bend / std::sqrt(1.0f + size * size);
}

glm::vec3 turned(const glm::vec3 &v, const glm::vec2 &bend) {
	const glm::vec3 axis(bend.y, 0.0f, -bend.x);
	return v + 2.0f / (1.0f + glm::dot(bend, bend)) * glm::cross(axis, glm::cross(axis, v) + v);
}

// A point that has turned by the angle a = 2·atan|s| about the pivot is on an arc that has turned by 2·a. The chord of
// this arc is sin(a)/a times its length.
float arc_share(const glm::vec2 &bend) {
	const float q = glm::dot(bend, bend);
	const float tangent = 1.0f - q * (0.33333333f - q * (0.2f - q * (0.14285714f - q * 0.11111111f)));
	return 1.0f / ((1.0f + q) * tangent);
}

// tan(weight · atan|s|)/|s|, as a series.
glm::vec2 bend_at(const glm::vec2 &tip, float weight) {
	const float q = glm::dot(tip, tip);
	const float w = weight * weight;
	return tip * (weight * (1.0f - q * (1.0f - w) * (0.33333333f - q * (0.2f - 0.13333333f * w))));
}

glm::vec3 bent_way(const glm::vec3 &way, const glm::vec2 &bend, float weight) {
	const glm::vec2 own = bend_at(bend, weight);
	return turned(way, own) * arc_share(own);
}

// Puts the swing of a bone under the pose of what carries its part.
static PartPose carried_pose(const PartPose &carrier, const PartBone &bone, const glm::vec2 &own) {
	const glm::quat of_carrier(carrier.turn.w, carrier.turn.x, carrier.turn.y, carrier.turn.z);
	const glm::quat turn = quaternion_of(own);
	const float size = bone.swing.is_head() ? 1.0f : arc_share(own);
	const glm::quat whole = of_carrier * turn;
	PartPose pose;
	pose.turn = { whole.x, whole.y, whole.z, whole.w };
	pose.size = carrier.size * size;
	pose.shift = carrier.shift + carrier.size * (of_carrier * (bone.pivot - size * (turn * bone.pivot)));
	return pose;
}

// A bone at the place on the branch that carries the part of `bone`.
static PartBone bone_of_carrier(const PartBone &bone) {
	PartBone made = bone;
	made.pivot = bone.carrier.pivot;
	made.weight = bone.carrier.weight;
	made.swing = bone.carrier.swing;
	made.carried_by = -1;
	return made;
}

static glm::vec2 carried_bend(const PartBone &bone, const StemMotion &stem) {
	return bend_at(part_bend(bone.swing, stem, &bone.carrier, 1), bone.weight);
}

// The stem moves a point at its offset x by the share x of its bend: (1 - x)·v + x·turned(v). In the plane of the bend
// this turns and shrinks the part. A bone cannot shrink in one plane alone, so it uses the turn and the mean size.
PartPose pose_of(const PartBone &bone, const StemMotion &stem) {
	if (bone.carried_by >= 0) {
		return carried_pose(pose_of(bone_of_carrier(bone), stem), bone, carried_bend(bone, stem));
	}
	const glm::vec2 own = bend_at(part_bend(bone.swing, stem), bone.weight);
	const float n = glm::dot(stem.bend, stem.bend);
	const float x = bone.stem_offset;
	const float along = 1.0f - x + x * (1.0f - n) / (1.0f + n);
	const float aside = 2.0f * x / (1.0f + n);
	const float shrink = std::sqrt(along * along + aside * aside * n);
	const glm::quat turn = quaternion_of(stem.bend * (aside / std::max(shrink + along, EPSILON))) * quaternion_of(own);
	PartPose pose;
	pose.turn = { turn.x, turn.y, turn.z, turn.w };
	pose.size = (1.0f + 2.0f * shrink) / 3.0f * (bone.swing.is_head() ? 1.0f : arc_share(own));
	pose.shift = glm::mix(bone.pivot, turned(bone.pivot, stem.bend), x) - pose.size * (turn * bone.pivot);
	return pose;
}

PosedStem::PosedStem(const StemConstants &stem, float plant_height, const StemMotion &motion) :
		constants(stem), height(plant_height), rest(motion.rest) {
	amplitudes[0] = (into_rest(motion.bend, motion.rest) - motion.second) / stem.mode[0].tip_slope;
	amplitudes[1] = stem.modes == 2 ? motion.second / stem.mode[1].tip_slope : glm::vec2(0.0f);
}

// A leaning stem is straight from its root on; parts on the ground around the root do not move.
glm::vec2 PosedStem::lean_at(float x) const {
	return rest * std::clamp(LEANS * x, 0.0f, 1.0f);
}

glm::vec3 PosedStem::place_of(const glm::vec3 &place, float x) const {
	const StemPlace on_stem = stem_place(constants, amplitudes, x);
	const glm::vec3 aside = turned(place - glm::vec3(0.0f, x * height, 0.0f), on_stem.bend);
	return turned(on_stem.centre * height, rest) + turned(aside, lean_at(x));
}

glm::vec4 PosedStem::turn_at(float x) const {
	const glm::quat turn = quaternion_of(lean_at(x)) * quaternion_of(stem_bend(constants, amplitudes, x));
	return { turn.x, turn.y, turn.z, turn.w };
}

PartPose pose_of(const PartBone &bone, const StemMotion &motion, const PosedStem &stem) {
	if (bone.carried_by >= 0) {
		return carried_pose(pose_of(bone_of_carrier(bone), motion, stem), bone, carried_bend(bone, motion));
	}
	const glm::vec2 own = bend_at(part_bend(bone.swing, motion), bone.weight);
	const glm::vec4 of_stem = stem.turn_at(bone.stem_offset);
	const glm::quat turn = glm::quat(of_stem.w, of_stem.x, of_stem.y, of_stem.z) * quaternion_of(own);
	PartPose pose;
	pose.turn = { turn.x, turn.y, turn.z, turn.w };
	pose.size = bone.swing.is_head() ? 1.0f : arc_share(own);
	pose.shift = stem.place_of(bone.pivot, bone.stem_offset) - pose.size * (turn * bone.pivot);
	return pose;
}

} // namespace undergrowth
