#include "any_species.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"

#include <iterator>
#include <limits>

using namespace undergrowth;

namespace {

constexpr float LARGEST = std::numeric_limits<float>::max();
constexpr float ENDLESS = std::numeric_limits<float>::infinity();
constexpr float ODD_NUMBERS[] = { std::numeric_limits<float>::quiet_NaN(), ENDLESS, -ENDLESS, LARGEST, -LARGEST, 1e10f,
	-1e10f, 1e-40f, -1e-40f, 1e-9f, -0.0f, 0.0f, -1e-3f, 1e-5f, 1e-4f, 1e-3f, 0.9f, 1.0f, 1.5f, 3.15f, 4.0f, 8.0f,
	10.0f, 12.6f, -12.6f, 20.0f, 100.0f, 100.00001f, 1e3f, 1.0000001f };
constexpr int ODD_COUNTS[] = { 0, -1, 1, 2, 32, 33, 64, 65, 4096, 4097, 1 << 20, std::numeric_limits<int>::max(),
	std::numeric_limits<int>::min() };

template <class T, size_t N> T any_of(const T (&values)[N], Chance &chance) {
	return values[chance.whole(0, static_cast<int>(N) - 1)];
}

std::vector<float> any_samples(Chance &chance, float min, float max) {
	std::vector<float> samples(static_cast<size_t>(chance.whole(2, 33)));
	for (float &sample : samples) {
		sample = chance.within(min, max);
	}
	return samples;
}

/// A closed line around the middle.
std::vector<glm::vec2> any_ring(Chance &chance) {
	std::vector<glm::vec2> ring(static_cast<size_t>(chance.whole(3, 40)));
	const float size = chance.spread(1e-4f, 10.0f);
	for (size_t i = 0; i < ring.size(); i++) {
		const double turn = 2.0 * PI * static_cast<double>(i) / static_cast<double>(ring.size());
		const float radius = size * chance.within(0.2f, 1.0f);
		ring[i] = { radius * static_cast<float>(portable_cos(turn)), -radius * static_cast<float>(portable_sin(turn)) };
	}
	return ring;
}

/// Mostly a few, sometimes none or many: parts carry parts, and the cost of a species grows with their product.
int any_count(Chance &chance) {
	if (chance.one_in(48)) {
		return chance.whole(20, 200);
	}
	return chance.one_in(4) ? chance.whole(0, 8) : chance.whole(1, 3);
}

glm::vec4 any_color(Chance &chance) {
	const float max = chance.one_in(6) ? 16.0f : 1.0f;
	return { chance.within(0.0f, max), chance.within(0.0f, max), chance.within(0.0f, max), chance.within(0.0f, 1.0f) };
}

void color(Part &part, Chance &chance) {
	part.colors.base = any_color(chance);
	part.colors.tip = any_color(chance);
	for (int i = 0; i < PartColors::ROWS * PartColors::COLUMNS && chance.one_in(6); i++) {
		part.colors.samples.resize(PartColors::ROWS * PartColors::COLUMNS, any_color(chance));
		part.colors.samples[static_cast<size_t>(i)] = any_color(chance);
	}
}

void spoil_samples(std::vector<float> &samples, Chance &chance) {
	samples.resize(static_cast<size_t>(chance.whole(0, 3)), any_of(ODD_NUMBERS, chance));
}

} // namespace

Part any_part(Chance &chance) {
	Part part;
	part.kind = static_cast<PartKind>(chance.whole(0, 2));
	part.length_min = chance.spread(1e-4f, 50.0f);
	part.length_max = part.length_min * chance.spread(1.0f, 2.0f);
	part.width = chance.spread(1e-5f, 5.0f);
	part.widths.profile = { chance.within(0.0f, 8.0f), chance.within(0.0f, 8.0f) };
	part.widths.base_width = chance.within(0.0f, 1.0f);
	if (chance.one_in(6)) {
		part.widths.samples = any_samples(chance, 0.0f, chance.one_in(4) ? 100.0f : 1.0f);
	}
	part.curve = { chance.within(-12.0f, 12.0f), chance.within(0.5f, 4.0f),
		chance.one_in(3) ? chance.within(0.0f, 1.5f) : 0.0f };
	part.axis.tip_diameter = chance.one_in(4) ? 0.0f : chance.spread(1e-5f, 5.0f);
	part.axis.open_tip = chance.one_in(4);
	part.axis.lobes = chance.one_in(4) ? chance.whole(0, 64) : 0;
	part.axis.lobe_depth = chance.within(0.0f, 0.9f);
	if (chance.one_in(10)) {
		part.axis.ring = any_ring(chance);
	}
	part.blade.fold = chance.within(-1.5f, 1.5f);
	part.blade.roll = chance.within(-6.0f, 6.0f);
	part.blade.twist = chance.within(-20.0f, 20.0f);
	part.blade.wave = chance.within(0.0f, 1.0f);
	part.blade.wave_count = chance.within(0.0f, 32.0f);
	part.blade.teeth = chance.one_in(4) ? chance.whole(1, 32) : 0;
	part.blade.tooth_depth = chance.within(0.0f, 0.9f);
	part.blade.roundness = chance.within(0.0f, 1.0f);
	part.translucency = chance.within(0.0f, 1.0f);
	part.frequency = chance.one_in(4) ? 0.0f : chance.spread(1e-3f, 100.0f);
	part.damping_ratio = chance.within(0.0f, 100.0f);
	color(part, chance);
	return part;
}

Arrangement any_arrangement(Chance &chance) {
	Arrangement a;
	a.layout = static_cast<Layout>(chance.whole(0, 3));
	a.count_min = any_count(chance);
	a.count_max = std::max(1, a.count_min + (chance.one_in(3) ? chance.whole(0, 4) : 0));
	a.from = chance.within(0.0f, 1.0f);
	a.to = chance.within(0.0f, 1.0f);
	a.per_node = chance.whole(1, 5);
	a.turn = chance.within(-7.0f, 7.0f);
	a.phase = chance.within(-7.0f, 7.0f);
	a.angle = { chance.within(-4.0f, 4.0f), chance.within(-4.0f, 4.0f) };
	a.scale = { chance.spread(1e-3f, 10.0f), chance.spread(1e-3f, 10.0f) };
	if (chance.one_in(8)) {
		a.angles = any_samples(chance, -12.6f, 12.6f);
		a.scales = any_samples(chance, 1e-3f, 10.0f);
	}
	a.radius = chance.one_in(3) ? 0.0f : chance.spread(1e-4f, 3.0f);
	a.dome = chance.within(0.0f, 3.14f);
	a.level_tops = chance.one_in(3);
	a.flat = chance.one_in(3);
	a.tilt = { chance.within(-3.0f, 3.0f), chance.within(-3.0f, 3.0f) };
	a.deviation = chance.within(0.0f, 1.5f);
	a.swept = chance.one_in(3) ? chance.within(0.0f, 1.0f) : 0.0f;
	return a;
}

void spoil(Part &part, Chance &chance) {
	float *const numbers[] = { &part.length_min, &part.length_max, &part.width, &part.widths.profile.rise,
		&part.widths.profile.fall, &part.widths.base_width, &part.curve.bend, &part.curve.power, &part.curve.wander,
		&part.axis.tip_diameter, &part.axis.lobe_depth, &part.blade.fold, &part.blade.roll, &part.blade.twist,
		&part.blade.wave, &part.blade.wave_count, &part.blade.tooth_depth, &part.blade.roundness, &part.translucency,
		&part.frequency, &part.damping_ratio, &part.colors.base.x, &part.colors.tip.w };
	int *const counts[] = { &part.axis.lobes, &part.blade.teeth };
	for (int i = chance.whole(0, 2); i >= 0; i--) {
		*any_of(numbers, chance) = any_of(ODD_NUMBERS, chance);
	}
	if (chance.one_in(4)) {
		*any_of(counts, chance) = any_of(ODD_COUNTS, chance);
	}
	if (chance.one_in(6)) {
		spoil_samples(part.widths.samples, chance);
	}
	if (chance.one_in(6)) {
		const float odd = any_of(ODD_NUMBERS, chance);
		part.colors.samples.resize(static_cast<size_t>(chance.one_in(2) ? 51 : chance.whole(0, 60)), glm::vec4(odd));
	}
	part.length_max = chance.one_in(3) ? part.length_min : part.length_max;
}

void spoil(Arrangement &a, Chance &chance) {
	float *const numbers[] = { &a.from, &a.to, &a.turn, &a.phase, &a.angle.first, &a.angle.last, &a.scale.first,
		&a.scale.last, &a.radius, &a.dome, &a.tilt.first, &a.tilt.last, &a.deviation };
	int *const counts[] = { &a.count_min, &a.count_max, &a.per_node };
	for (int i = chance.whole(0, 2); i >= 0; i--) {
		*any_of(numbers, chance) = any_of(ODD_NUMBERS, chance);
	}
	if (chance.one_in(3)) {
		*any_of(counts, chance) = any_of(ODD_COUNTS, chance);
	}
	if (chance.one_in(6)) {
		spoil_samples(chance.one_in(2) ? a.angles : a.scales, chance);
	}
}

Recipe any_recipe(Chance &chance) {
	Recipe recipe;
	const int kinds = chance.whole(1, 5);
	for (int i = 0; i < kinds; i++) {
		recipe.kinds.push_back(any_part(chance));
	}
	const int lines = chance.whole(1, 6);
	for (int i = 0; i < lines; i++) {
		const int kind = chance.whole(0, kinds - 1);
		const Arrangement arrangement = any_arrangement(chance);
		recipe.lines.push_back({ kind, arrangement, chance.whole(-1, i - 1) });
	}
	return recipe;
}
