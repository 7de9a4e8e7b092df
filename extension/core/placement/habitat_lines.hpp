#pragma once

#include "placement/area.hpp"

#include <vector>

namespace undergrowth {

/// Lines in the ground plane. A closed one has the distance 0 inside.
struct HabitatLines {
	std::vector<Polygon> open; ///< Two points or more each.
	std::vector<Polygon> closed; ///< Three points or more each.

	bool is_empty() const { return open.empty() && closed.empty(); }
	/// Box of all points. Precondition: not empty.
	AreaBox box() const;
	/// The lines and areas within `reach` (m) of a box.
	HabitatLines near(const AreaBox &box, float reach) const;
	/// Distance (m) of a point from the nearest line or area, at most `reach`.
	float distance_to(const glm::vec2 &point, float reach) const;
};

} // namespace undergrowth
