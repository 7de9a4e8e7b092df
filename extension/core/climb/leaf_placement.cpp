#include "climb/leaf_placement.hpp"

#include "base/portable_math.hpp"
#include "base/random.hpp"
#include "climb/shoot_step.hpp"
#include "conventions.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float YOUNG_LENGTH = 0.3f; // m, from the tip of a shoot, on which leaves still grow.
constexpr float YOUNG_SIZE = 0.35f; // Of the last leaf.
constexpr float SIDE = 0.55f; // Of a leaf's direction: to the side of its shoot,
constexpr float AHEAD = 0.25f; // along the shoot,
constexpr float CHANCE = 0.35f; // and at random, beside 1 for down.
constexpr float LEAN = 0.22f; // Maximum random slope of a leaf's own normal.
constexpr float LIFT = 0.012f; // m, maximum random height over the stem, so that leaves overlap.
constexpr float CLEAR = 0.25f; // Of a leaf's length: height of its probes over the surface.

class LeafPlacer {
public:
	LeafPlacer(const SurfaceGrid &on, const ClimbSettings &by, Climb &to) : grid(on), settings(by), climb(to) {}

	void place_on(const ClimbShoot &shoot) {
		float gone = 0.0f;
		float next = settings.leaf_spacing * (0.5f + 0.5f * signed_noise(shoot.seed, 99));
		next = shoot.order == 0 ? next : next + 0.5f * settings.leaf_spacing;
		int number = 0;
		for (int i = 1; i < shoot.count; i++) {
			const ClimbPoint &before = climb.points[static_cast<std::size_t>(shoot.first + i - 1)];
			const ClimbPoint &point = climb.points[static_cast<std::size_t>(shoot.first + i)];
			const glm::vec3 way = point.place - before.place;
			const float length = glm::length(way);
			while (next <= gone + length && length > 0.0f) {
				const float share = (next - gone) / length;
				add(shoot, before, point, share, number++);
				next += settings.leaf_spacing *
						(1.0f + 0.4f * signed_noise(shoot.seed, 100 + 7 * static_cast<uint64_t>(number)));
			}
			gone += length;
		}
	}

private:
	const SurfaceGrid &grid;
	const ClimbSettings &settings;
	Climb &climb;

	void add(const ClimbShoot &shoot, const ClimbPoint &before, const ClimbPoint &after, float share, int number) {
		if (static_cast<int>(climb.leaves.size()) >= MAX_CLIMB_LEAVES) {
			return;
		}
		const uint64_t seed = mix_bits(shoot.seed ^ (0x1eafull + static_cast<uint64_t>(number)));
		const float to_tip = glm::mix(before.to_tip, after.to_tip, share);
		const float grown = std::min(to_tip / YOUNG_LENGTH, 1.0f);
		ClimbLeaf leaf;
		leaf.age = grown * grown * (3.0f - 2.0f * grown);
		leaf.size = (YOUNG_SIZE + (1.0f - YOUNG_SIZE) * leaf.age) * (1.0f + 0.35f * signed_noise(seed, 0));
		leaf.phase = 0.5f + 0.5f * signed_noise(seed, 1);
		leaf.body = after.body;
		const glm::vec3 normal = glm::normalize(glm::mix(before.normal, after.normal, share) + 1e-3f * after.normal);
		const glm::vec3 along = glm::normalize(after.place - before.place);
		const float lift = LIFT * leaf.size * (0.5f + 0.5f * signed_noise(seed, 2));
		leaf.place = glm::mix(before.place, after.place, share) + normal * lift;
		turn(leaf, normal, along, (number & 1) == 0 ? 1.0f : -1.0f, seed);
		if (find_room(leaf)) {
			climb.leaves.push_back(leaf);
		}
	}

	void turn(ClimbLeaf &leaf, const glm::vec3 &normal, const glm::vec3 &along, float side, uint64_t seed) const {
		const glm::vec3 beside = along_surface(glm::cross(along, normal), normal) * side;
		const glm::vec3 chance(signed_noise(seed, 3), signed_noise(seed, 4), signed_noise(seed, 5));
		const glm::vec3 down = settings.down - normal * glm::dot(settings.down, normal);
		leaf.down = along_surface(down + SIDE * beside + AHEAD * along + CHANCE * chance, normal);
		const glm::vec3 lean(signed_noise(seed, 6), signed_noise(seed, 7), signed_noise(seed, 8));
		leaf.out = glm::normalize(normal + LEAN * lean);
		leaf.down = along_surface(leaf.down, leaf.out);
	}

	bool is_free(const ClimbLeaf &leaf) const {
		const float reach = settings.leaf_reach * leaf.size;
		const glm::vec3 side = glm::cross(leaf.out, leaf.down) * (0.5f * reach);
		const glm::vec3 raised = leaf.place + leaf.out * (CLEAR * reach);
		const glm::vec3 tip = raised + leaf.down * reach;
		const glm::vec3 middle = raised + leaf.down * (0.6f * reach);
		const auto is_hit = [&](const glm::vec3 &to) { return grid.crossing(leaf.place, to).is_valid(); };
		return !is_hit(tip) && !is_hit(middle + side) && !is_hit(middle - side);
	}

	/// Turns a leaf about its stalk until it is free.
	bool find_room(ClimbLeaf &leaf) const {
		constexpr int TURNS = 6;
		const glm::vec3 first = leaf.down;
		for (int i = 0; i < TURNS; i++) {
			const int turns = (i & 1) == 1 ? (i + 1) / 2 : -i / 2;
			const SineAndCosine turn = portable_sine_and_cosine(static_cast<double>(turns) * (PI / 3.0));
			const glm::vec3 aside = glm::cross(leaf.out, first);
			leaf.down = first * static_cast<float>(turn.cosine) + aside * static_cast<float>(turn.sine);
			if (is_free(leaf)) {
				return true;
			}
		}
		return false;
	}
};

} // namespace

void place_leaves(const SurfaceGrid &grid, const ClimbSettings &settings, Climb &climb) {
	LeafPlacer placer(grid, settings, climb);
	for (const ClimbShoot &shoot : climb.shoots) {
		placer.place_on(shoot);
	}
}

} // namespace undergrowth
