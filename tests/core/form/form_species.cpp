#include "form_species.hpp"

#include <doctest/doctest.h>

using namespace undergrowth;

namespace {

glm::vec4 hex(int rgb) {
	return { static_cast<float>(rgb >> 16) / 255.0f, static_cast<float>((rgb >> 8) & 255) / 255.0f,
		static_cast<float>(rgb & 255) / 255.0f, 1.0f };
}

Part colored(Part part, int base, int tip) {
	part.colors.base = hex(base);
	part.colors.tip = hex(tip);
	return part;
}

Part blade(float length_min, float length_max, float width, const Profile &profile, float bend) {
	Part part;
	part.length_min = length_min;
	part.length_max = length_max;
	part.width = width;
	part.widths.profile = profile;
	part.widths.base_width = 0.3f;
	part.curve.bend = bend * DEGREE;
	part.translucency = 0.8f;
	return part;
}

Part axis(float length_min, float length_max, float base, float tip, float bend) {
	Part part;
	part.kind = PartKind::axis;
	part.length_min = length_min;
	part.length_max = length_max;
	part.width = base;
	part.axis.tip_diameter = tip;
	part.widths.profile = EVEN_PROFILE;
	part.curve.bend = bend * DEGREE;
	return part;
}

Part bead(float length, float diameter) {
	Part part;
	part.kind = PartKind::bead;
	part.length_min = part.length_max = length;
	part.width = diameter;
	return part;
}

/// Grows a plant line by line. Every fault fails the test.
class Grower {
public:
	explicit Grower(uint64_t seed) : growth(0.3f, seed) {}

	std::vector<int> add(const Part &part, const Arrangement &arrangement, const std::vector<int> &on = { ON_GROUND }) {
		int kind = 0;
		std::vector<int> handles;
		CHECK(growth.add_kind(part, kind) == "");
		CHECK(growth.arrange(kind, arrangement, on, handles) == "");
		return handles;
	}
	PlantForm finish() { return growth.finish(); }

private:
	Growth growth;
};

Arrangement arranged(Layout layout, int count, Span angle = {}) {
	Arrangement a;
	a.layout = layout;
	a.count_min = a.count_max = count;
	a.angle = { angle.first * DEGREE, angle.last * DEGREE };
	return a;
}

Arrangement tuft(int count, float radius, Span tilt) {
	Arrangement a = arranged(Layout::ground, count);
	a.radius = radius;
	a.tilt = { tilt.first * DEGREE, tilt.last * DEGREE };
	return a;
}

Arrangement along(
		int count, float from, float to, float turn, Span angle, Span scale = { 1.0f, 1.0f }, int per_node = 1) {
	Arrangement a = arranged(Layout::along, count, angle);
	a.from = from;
	a.to = to;
	a.turn = turn * DEGREE;
	a.scale = scale;
	a.per_node = per_node;
	return a;
}

} // namespace

PlantForm grow_grass(uint64_t seed) {
	Part leaf = colored(blade(0.2f, 0.35f, 0.009f, GRASS_PROFILE, 75.0f), 0x3f5a22, 0x8fa44e);
	leaf.curve.power = 2.0f;
	leaf.widths.base_width = 0.6f;
	leaf.blade.fold = 25.0f * DEGREE;
	leaf.blade.twist = 60.0f * DEGREE;
	Grower plant(seed);
	plant.add(leaf, tuft(14, 0.025f, { 3.0f, 30.0f }));
	const std::vector<int> culms = plant.add(
			colored(axis(0.45f, 0.75f, 0.002f, 0.0008f, 12.0f), 0x66803a, 0xa39a5c), tuft(3, 0.012f, { 2.0f, 10.0f }));
	plant.add(leaf, along(2, 0.12f, 0.5f, 180.0f, { 25.0f, 35.0f }), culms);
	const std::vector<int> twigs = plant.add(colored(axis(0.04f, 0.04f, 0.0005f, 0.0003f, 25.0f), 0xa39a5c, 0xa39a5c),
			along(12, 0.82f, 1.0f, 45.0f, { 75.0f, 35.0f }, { 1.0f, 0.3f }, 4), culms);
	plant.add(colored(bead(0.005f, 0.002f), 0x7e8a55, 0x8e7a86), along(2, 0.5f, 1.0f, 180.0f, { 30.0f, 10.0f }), twigs);
	return plant.finish();
}

PlantForm grow_tulip(uint64_t seed) {
	Part leaf = colored(blade(0.22f, 0.32f, 0.05f, LANCEOLATE_PROFILE, 45.0f), 0x7c9a84, 0x5f8670);
	leaf.blade.fold = 30.0f * DEGREE;
	leaf.blade.wave = 0.15f;
	Part tepal = colored(blade(0.065f, 0.065f, 0.046f, TEPAL_PROFILE, -55.0f), 0xf0c52e, 0xc4161c);
	tepal.blade.roll = 50.0f * DEGREE;
	Part stamen = colored(axis(0.02f, 0.02f, 0.001f, 0.003f, 0.0f), 0xe0c040, 0x2a1a2e);
	Grower plant(seed);
	const std::vector<int> stems = plant.add(
			colored(axis(0.35f, 0.5f, 0.008f, 0.006f, 6.0f), 0x6f8f62, 0x86a06a), arranged(Layout::ground, 1));
	plant.add(leaf, along(2, 0.03f, 0.2f, 180.0f, { 18.0f, 28.0f }), stems);
	Arrangement outer = arranged(Layout::whorl, 3, { 57.0f, 57.0f });
	outer.radius = 0.004f;
	Arrangement inner = arranged(Layout::whorl, 3, { 51.0f, 51.0f });
	inner.radius = 0.003f;
	inner.phase = 60.0f * DEGREE;
	inner.scale = { 0.96f, 0.96f };
	plant.add(tepal, outer, stems);
	plant.add(tepal, inner, stems);
	plant.add(stamen, arranged(Layout::whorl, 6, { 14.0f, 14.0f }), stems);
	return plant.finish();
}

PlantForm grow_daisy(uint64_t seed) {
	Part basal = colored(blade(0.08f, 0.08f, 0.018f, SPATULATE_PROFILE, 40.0f), 0x4c6b2c, 0x7d9a4a);
	basal.blade.teeth = 5;
	Part leaf = colored(blade(0.05f, 0.05f, 0.009f, STRAP_PROFILE, 0.0f), 0x4c6b2c, 0x7d9a4a);
	leaf.blade.teeth = 4;
	leaf.blade.fold = 15.0f * DEGREE;
	Grower plant(seed);
	plant.add(basal, tuft(8, 0.008f, { 45.0f, 75.0f }));
	const std::vector<int> stems = plant.add(colored(axis(0.35f, 0.7f, 0.003f, 0.0022f, 10.0f), 0x4c6b2c, 0x7d9a4a),
			tuft(static_cast<int>(seed % 3) + 1, 0.01f, { 2.0f, 12.0f }));
	plant.add(leaf, along(9, 0.05f, 0.75f, 137.508f, { 35.0f, 25.0f }, { 1.0f, 0.35f }), stems);
	Arrangement disc = arranged(Layout::disc, 130);
	disc.radius = 0.0075f;
	disc.dome = 50.0f * DEGREE;
	plant.add(colored(bead(0.003f, 0.001f), 0xc98a12, 0xf6d64a), disc, stems);
	Arrangement rays = arranged(Layout::whorl, 22, { 80.0f, 80.0f });
	rays.radius = 0.007f;
	rays.deviation = 6.0f * DEGREE;
	plant.add(colored(blade(0.016f, 0.016f, 0.0045f, RAY_PROFILE, 12.0f), 0xeeece0, 0xfafaf5), rays, stems);
	return plant.finish();
}

PlantForm grow_fern(uint64_t seed) {
	Part leaflet = colored(blade(0.1f, 0.1f, 0.03f, LANCEOLATE_PROFILE, 20.0f), 0x4e7a2e, 0x86a84a);
	leaflet.blade.teeth = 9;
	Grower plant(seed);
	const std::vector<int> fronds = plant.add(
			colored(axis(0.6f, 0.9f, 0.006f, 0.0012f, 55.0f), 0xa5713a, 0x4e7a2e), tuft(7, 0.03f, { 15.0f, 40.0f }));
	Arrangement leaflets = along(40, 0.2f, 1.0f, 0.0f, { 70.0f, 40.0f }, { 1.0f, 0.2f }, 2);
	leaflets.flat = true;
	leaflets.phase = 90.0f * DEGREE;
	plant.add(leaflet, leaflets, fronds);
	return plant.finish();
}

PlantForm grow_cereal(uint64_t seed) {
	Part leaf = colored(blade(0.17f, 0.26f, 0.012f, GRASS_PROFILE, 75.0f), 0x8a9648, 0xc9b060);
	leaf.blade.twist = 80.0f * DEGREE;
	Grower plant(seed);
	const std::vector<int> culms = plant.add(
			colored(axis(0.6f, 0.8f, 0.0036f, 0.002f, 7.0f), 0xa89c4c, 0xc9a850), tuft(4, 0.018f, { 1.0f, 9.0f }));
	plant.add(leaf, along(4, 0.14f, 0.76f, 180.0f, { 26.0f, 34.0f }), culms);
	const std::vector<int> ears = plant.add(colored(axis(0.08f, 0.1f, 0.0022f, 0.0014f, 14.0f), 0xc9a850, 0xcfae58),
			along(1, 1.0f, 1.0f, 0.0f, {}), culms);
	const Part spikelet = colored(bead(0.0135f, 0.0072f), 0xb89a48, 0xdfc47a);
	plant.add(spikelet, along(22, 0.0f, 1.0f, 180.0f, { 32.0f, 12.0f }), ears);
	plant.add(spikelet, along(22, 0.0f, 1.0f, 180.0f, { 24.0f, 10.0f }), ears);
	return plant.finish();
}

PlantForm grow_alone(const Part &part, uint64_t seed) {
	Grower plant(seed);
	plant.add(part, arranged(Layout::ground, 1));
	return plant.finish();
}

PlantForm grow_shrub(uint64_t seed) {
	Part stem = colored(axis(0.9f, 1.1f, 0.016f, 0.006f, 4.0f), 0x5f513f, 0x756449);
	stem.frequency = 0.0f;
	Part branch = colored(axis(0.35f, 0.5f, 0.007f, 0.003f, 20.0f), 0x66543f, 0x74643f);
	branch.frequency = 1.4f;
	Part twig = colored(axis(0.15f, 0.22f, 0.003f, 0.0015f, 12.0f), 0x6a5a42, 0x7d7a4c);
	twig.frequency = 2.2f;
	Part leaf = colored(blade(0.05f, 0.08f, 0.04f, GRASS_PROFILE, 30.0f), 0x466a2e, 0x6b8c3e);
	leaf.frequency = 2.6f;
	Grower plant(seed);
	const std::vector<int> stems = plant.add(stem, tuft(2, 0.05f, { 2.0f, 12.0f }));
	const std::vector<int> branches = plant.add(branch, along(4, 0.3f, 0.95f, 137.5f, { 60.0f, 35.0f }), stems);
	const std::vector<int> twigs = plant.add(twig, along(3, 0.3f, 1.0f, 180.0f, { 50.0f, 20.0f }), branches);
	plant.add(leaf, along(4, 0.2f, 1.0f, 180.0f, { 60.0f, 30.0f }), twigs);
	plant.add(leaf, along(2, 0.3f, 0.9f, 180.0f, { 60.0f, 40.0f }), branches);
	return plant.finish();
}
