#pragma once

#include "form/arrangement.hpp"
#include "form/midrib.hpp"
#include "form/part.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

inline constexpr int MAX_PARTS = 4096; ///< Of one plant.
/// Levels of parts on parts: a stem, three orders of branches, stalk, floret.
inline constexpr int MAX_DEPTH = 6;
inline constexpr int ON_GROUND = -1;

/// One placed part of one plant.
struct PlacedPart {
	int kind = 0; ///< Index of its PartKind in PlantForm::parts.
	int group = 0; ///< Parts that one arrangement placed (PlantForm::groups).
	int carrier = ON_GROUND; ///< Index of the placed part that carries it, always below its own.
	int own_midrib = -1; ///< Index in PlantForm::wanderers; -1: that of its kind.
	PartAxes axes;
	glm::vec3 base; ///< m, where it is attached.
	float length; ///< m.
	float width; ///< m.
	float offset; ///< Of its base on the carrier.
	float rank; ///< 0 to 1, in golden-ratio order within its group: any prefix by rank is spread evenly.
	float tint; ///< -1 to 1, the part's colour deviation.
};

/// All parts that one arrangement placed.
struct PartGroup {
	int kind = 0; ///< Kind of all its parts.
	int carrier_group = ON_GROUND; ///< Group of the carriers; ON_GROUND also if they belong to several groups.
	Layout layout = Layout::along;
	float radius = 0.0f; ///< m, as arranged.
	float dome = 0.0f;
	int depth = 1; ///< 1 on the ground.
	int first = 0; ///< Placed parts first … first + count - 1 are its own.
	int count = 0;
	bool is_rod = false; ///< True if they are a head along its axis and close to it, as an ear.
};

/// One plant of one seed, independent of the level of detail. A flat list; carriers precede the parts that they
/// carry.
struct PlantForm {
	static constexpr int NO_STEM = -1;

	std::vector<Part> parts; ///< Each kind of part once.
	std::vector<Midrib> midribs; ///< Of each kind of part, without its wander.
	std::vector<Midrib> wanderers; ///< Of parts that wander, each its own.
	std::vector<PartGroup> groups;
	std::vector<PlacedPart> placed;
	int stem = NO_STEM; ///< Index of the placed part that is the stem of the four functions, if it has one.
	float height = 1.0f; ///< m. With parts alone it is the height of the highest.
	float reach = 0.0f; ///< m, the farthest that a midrib goes from the plant's axis.

	const Midrib &midrib_of(const PlacedPart &part) const {
		return part.own_midrib < 0 ? midribs[static_cast<size_t>(part.kind)]
								   : wanderers[static_cast<size_t>(part.own_midrib)];
	}
	/// A place on the midrib of a placed part, in the plant's axes (m).
	glm::vec3 point_of(const PlacedPart &part, float offset) const;
	/// Its axes there: outward is the lower side of a blade.
	PartAxes axes_of(const PlacedPart &part, float offset) const;
	/// A vector of a part's own axes in the plant's.
	static glm::vec3 turned(const PartAxes &axes, const glm::vec3 &own) {
		return axes.x * own.x + axes.along * own.y + axes.outward * own.z;
	}
};

} // namespace undergrowth
