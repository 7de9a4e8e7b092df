#include "climb/climb_growth.hpp"

#include "base/portable_math.hpp"
#include "base/random.hpp"
#include "climb/leaf_placement.hpp"
#include "climb/shoot_step.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace undergrowth {

namespace {

constexpr int MAX_ORDER = 4;
constexpr float MAX_ROOT_DISTANCE = 1.0f; // m, from the root to the support; more with a larger adhesion distance.
constexpr float MIN_BRANCH = 0.08f; // m; shorter branches do not grow.
constexpr float FAN = 1.6f; // rad, between the outer main shoots.
constexpr float MIN_FORK = 0.6f; // rad, between a branch and its parent,
constexpr float MAX_FORK = 1.4f;
constexpr float MIN_RADIUS = 0.0008f; // m.
constexpr int CROWD = 4; // Shoots in a cell of the stem spacing.
constexpr float FREE = 4.0f; // Stem spacings that a branch grows among others.

glm::vec3 rotated(const glm::vec3 &v, const glm::vec3 &axis, float angle) {
	const SineAndCosine turn = portable_sine_and_cosine(static_cast<double>(angle));
	const auto sine = static_cast<float>(turn.sine);
	const auto cosine = static_cast<float>(turn.cosine);
	return v * cosine + glm::cross(axis, v) * sine + axis * (glm::dot(axis, v) * (1.0f - cosine));
}

/// Number of shoots in each cell of the stem spacing.
class Crowding {
public:
	explicit Crowding(float spacing) : over(1.0f / spacing) {}

	/// Adds a point of shoot `shoot`. Returns the number of other shoots that came there before.
	int enter(const glm::vec3 &place, int shoot) {
		Cell &cell = cells[key_of(place)];
		if (cell.last != shoot) {
			cell.last = shoot;
			cell.before = cell.shoots++;
		}
		return cell.before;
	}
	int at(const glm::vec3 &place) const {
		const auto found = cells.find(key_of(place));
		return found == cells.end() ? 0 : found->second.shoots;
	}

private:
	struct Cell {
		int last = -1;
		int before = 0;
		int shoots = 0;
	};
	float over;
	std::unordered_map<uint64_t, Cell> cells; ///< Never iterated: its order is not portable.

	uint64_t key_of(const glm::vec3 &place) const {
		uint64_t key = 0;
		for (int axis = 0; axis < 3; axis++) {
			const auto at = static_cast<int64_t>(std::floor(place[axis] * over));
			key = (key << 21) | (static_cast<uint64_t>(at) & 0x1fffff);
		}
		return key;
	}
};

class Grower {
public:
	Grower(const ClimbSupport &on, const ClimbSettings &by, const SurfaceGrid &surfaces) :
			support(on), settings(by), step(surfaces, by), crowding(by.stem_spacing) {}

	bool begin() {
		const float reach = std::max(settings.adhesion_distance, MAX_ROOT_DISTANCE);
		const std::optional<ClimbPoint> root = step.begin_at(settings.root, reach, support);
		for (int i = 0; root && i < settings.shoots; i++) {
			add_main(*root, i);
		}
		return root.has_value();
	}

	// All shoots grow at the same time, so that early ones do not take all the space.
	void grow() {
		for (bool is_growing = true; is_growing && points < MAX_CLIMB_POINTS;) {
			is_growing = false;
			const std::size_t count = growing.size();
			for (std::size_t i = 0; i < count; i++) {
				if (!growing[i].is_over) {
					is_growing = true;
					advance(static_cast<int>(i));
				}
			}
		}
	}

	void finish(Climb &into) {
		for (const GrowingShoot &shoot : growing) {
			if (shoot.points.size() >= 2) {
				add(shoot, into);
			}
		}
	}

private:
	const ClimbSupport &support;
	const ClimbSettings &settings;
	const ShootStep step;
	Crowding crowding;
	std::vector<GrowingShoot> growing;
	int points = 0;

	void add_main(const ClimbPoint &root, int number) {
		GrowingShoot shoot;
		shoot.is.seed = mix_bits(mix_bits(settings.seed) ^ static_cast<uint64_t>(number));
		shoot.points.push_back(root);
		shoot.goal = settings.length;
		const glm::vec3 first = settings.path.empty() ? -settings.down : settings.path.front() - root.place;
		const glm::vec3 up = along_surface(first, root.normal);
		const float side = settings.shoots > 1
				? static_cast<float>(number) / static_cast<float>(settings.shoots - 1) - 0.5f
				: 0.0f;
		const float chance = 0.15f * signed_noise(shoot.is.seed, 1);
		const float fan = settings.path.empty() ? FAN : 0.3f * FAN;
		shoot.direction = rotated(up, root.normal, fan * (side + chance));
		growing.push_back(shoot);
	}

	void advance(int number) {
		const auto index = static_cast<std::size_t>(number);
		step.advance(growing[index], support);
		points++;
		const GrowingShoot &shoot = growing[index];
		const int others = crowding.enter(shoot.tip().place, number);
		if (shoot.is.order > 0 && others >= CROWD && shoot.tip().is_attached &&
				shoot.length > FREE * settings.stem_spacing) {
			growing[index].is_over = true;
		}
		if (!growing[index].is_over) {
			fork(number);
		}
	}

	void fork(int number) {
		GrowingShoot &parent = growing[static_cast<std::size_t>(number)];
		if (settings.branching <= 0.0f || parent.is.order >= MAX_ORDER || !parent.tip().is_attached) {
			return;
		}
		const uint64_t seed = mix_bits(parent.is.seed ^ (0x5eedull + static_cast<uint64_t>(parent.forks)));
		const float wait = (1.0f + 0.6f * signed_noise(seed, 0)) / settings.branching;
		if (parent.since_fork < wait) {
			return;
		}
		parent.since_fork = 0.0f;
		parent.forks++;
		const float left = parent.goal - parent.length;
		const float goal = settings.branch_length * left * (1.0f + 0.4f * signed_noise(seed, 1));
		if (goal < MIN_BRANCH || crowding.at(parent.tip().place) > CROWD) {
			return;
		}
		GrowingShoot branch;
		branch.is.order = parent.is.order + 1;
		branch.is.seed = seed;
		branch.goal = goal;
		branch.points.push_back(parent.tip());
		const float angle = 0.5f * ((MAX_FORK + MIN_FORK) + (MAX_FORK - MIN_FORK) * signed_noise(seed, 2));
		const bool is_left = (parent.forks & 1) == (static_cast<int>(parent.is.seed >> 32) & 1);
		branch.direction = rotated(parent.direction, parent.tip().normal, is_left ? angle : -angle);
		growing.push_back(branch);
	}

	float radius_at(float to_tip) const {
		const float share = std::min(to_tip / std::max(settings.length, 1.0f), 1.0f);
		return std::max(0.5f * settings.stem_diameter * std::sqrt(share), MIN_RADIUS);
	}

	void add(const GrowingShoot &shoot, Climb &into) const {
		ClimbShoot made = shoot.is;
		made.first = static_cast<int>(into.points.size());
		made.count = static_cast<int>(shoot.points.size());
		into.points.insert(into.points.end(), shoot.points.begin(), shoot.points.end());
		float to_tip = 0.0f;
		for (std::size_t i = shoot.points.size(); i-- > 0;) {
			ClimbPoint &point = into.points[static_cast<std::size_t>(made.first) + i];
			if (i + 1 < shoot.points.size()) {
				to_tip += glm::distance(point.place, shoot.points[i + 1].place);
			}
			point.to_tip = to_tip;
			point.radius = radius_at(to_tip);
		}
		into.total_length += to_tip;
		into.shoots.push_back(made);
	}
};

} // namespace

std::string grow_climb(const ClimbSupport &support, const ClimbSettings &settings, Climb &into) {
	into = Climb();
	std::string fault = find_climb_fault(settings);
	fault = fault.empty() ? find_support_fault(support) : fault;
	if (!fault.empty()) {
		return fault;
	}
	const float reach = settings.length * (1.0f + settings.branch_length) + settings.max_hanging + MAX_ROOT_DISTANCE +
			settings.adhesion_distance;
	const float finest = 2.0f * ShootStep::length_of(settings);
	const SurfaceGrid grid(support, settings.root - glm::vec3(reach), settings.root + glm::vec3(reach), finest,
			std::max(settings.adhesion_distance, finest));
	Grower grower(support, settings, grid);
	if (grid.is_empty() || !grower.begin()) {
		return "no support is within a metre of the root. Move the node to the wall, or add the wall to supports.";
	}
	grower.grow();
	grower.finish(into);
	place_leaves(grid, settings, into);
	return {};
}

} // namespace undergrowth
