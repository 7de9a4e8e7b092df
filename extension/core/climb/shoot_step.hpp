#pragma once

#include "climb/climb_growth.hpp"
#include "climb/surface_grid.hpp"

#include <optional>

namespace undergrowth {

/// A shoot that grows.
struct GrowingShoot {
	ClimbShoot is;
	std::vector<ClimbPoint> points;
	glm::vec3 direction = { 0.0f, 1.0f, 0.0f }; ///< Unit.
	float length = 0.0f; ///< m, that it has.
	float goal = 1.0f; ///< m, at which it ends.
	float hanging = 0.0f; ///< m, since it left its support.
	float since_fork = 0.0f; ///< m.
	int forks = 0;
	int next_on_path = 0;
	bool is_over = false;

	const ClimbPoint &tip() const { return points.back(); }
};

/// One step of a shoot along the surfaces of a grid.
class ShootStep {
public:
	static constexpr float GAP = 0.004f; ///< m, from the surface to the stem's axis.

	/// Both must outlive it.
	ShootStep(const SurfaceGrid &on, const ClimbSettings &by) : grid(on), settings(by), step_length(length_of(by)) {}

	/// m, with these settings.
	static float length_of(const ClimbSettings &settings);
	float length() const { return step_length; }
	/// Adds a point to `shoot`, or ends it.
	void advance(GrowingShoot &shoot, const ClimbSupport &support) const;
	/// The nearest point beside a surface, from which a shoot can start; none within `reach`.
	std::optional<ClimbPoint> begin_at(const glm::vec3 &place, float reach, const ClimbSupport &support) const;

private:
	const SurfaceGrid &grid;
	const ClimbSettings &settings;
	const float step_length; ///< m.

	glm::vec3 steer(GrowingShoot &shoot) const;
	glm::vec3 way_to_path(GrowingShoot &shoot) const;
	bool lets_go(const GrowingShoot &shoot, const glm::vec3 &out) const;
	bool meet(const GrowingShoot &shoot, const glm::vec3 &to, ClimbPoint &next, const ClimbSupport &support) const;
	bool approach(const GrowingShoot &shoot, const glm::vec3 &to, ClimbPoint &next, const ClimbSupport &support) const;
};

/// The part of `v` across `normal`, of length 1; any perpendicular direction if there is none.
glm::vec3 along_surface(const glm::vec3 &v, const glm::vec3 &normal);

} // namespace undergrowth
