#pragma once

#include "stand/placement.hpp"

#include <optional>
#include <vector>

namespace undergrowth {

/// The shapes that plants stand by: what gives them room, and what is kept free of them.
class StandingArea {
public:
	/// They were placed by it.
	void stand_by(const PlacementRequest &request);
	/// Whether nothing but these shapes need be compared to know where others stand by `now`: plants stand by some
	/// already, and no shape came or went. (All else in a request is its caller's to compare.)
	bool can_follow(const PlacementRequest &now) const;
	/// Where that is so: around all places that may be otherwise by `now`, which they stand by from now on, with a
	/// margin; nothing where none is. An area that is painted is not compared: the map tells of itself.
	std::optional<AreaBox> follow(const PlacementRequest &now);

private:
	Polygon area; ///< Empty: nothing was placed yet.
	std::vector<Polygon> exclusions;
};

} // namespace undergrowth
