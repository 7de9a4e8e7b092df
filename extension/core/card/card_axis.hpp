#pragma once

#include "card/card_groups.hpp"

#include <vector>

namespace undergrowth {

/// A point in the plane of a card (m).
struct FlatPoint {
	float across = 0.0f;
	float along = 0.0f; ///< From the origin of the axis.
	float depth = 0.0f; ///< Towards the camera of the picture.
};

/// The axis of a card: the midrib of its carrier from an offset on, extended straight beyond its ends. Heads at the tip
/// of a long carrier have a straight axis.
class CardAxis {
public:
	CardAxis(const PlantForm &form, int carrier, float from);

	FlatPoint flatten(const glm::vec3 &point) const;
	/// Length of the carrier from the origin to its tip (m).
	float length() const { return nodes.back().along; }

private:
	struct Node {
		glm::vec3 point;
		PartAxes axes;
		float along; ///< m from the origin.
	};
	std::vector<Node> nodes;
};

} // namespace undergrowth
