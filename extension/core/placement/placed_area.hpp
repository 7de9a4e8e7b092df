#pragma once

#include "placement/placement.hpp"

#include <optional>
#include <vector>

namespace undergrowth {

/// The shapes of the current placement: its area and its exclusions.
class PlacedArea {
public:
	/// Stores the shapes of a placement.
	void store_shapes(const PlacementRequest &request);
	/// True if follow() can compare the shapes: there is a placement, and no shape was added or removed. The caller
	/// compares all other parts of the request.
	bool can_follow(const PlacementRequest &now) const;
	/// Precondition: can_follow(). Stores the shapes of `now` and returns a box, with a margin, around everything that
	/// may differ, the edge falloff included; nothing if they are equal. Ignores painted areas; the map reports its
	/// changes itself.
	std::optional<AreaBox> follow(const PlacementRequest &now);

private:
	Polygon area; ///< Empty: no placement.
	std::vector<Polygon> exclusions;
};

} // namespace undergrowth
