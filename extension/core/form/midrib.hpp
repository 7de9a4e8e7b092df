#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace undergrowth {

/// Shape of a midrib from its base.
struct MidribCurve {
	float bend = 0.0f; ///< rad: turn of the tip relative to the base. Negative: towards the parent.
	float power = 1.0f; ///< 0.5 to 4. The turn at offset s is bend·s^power: above 1 the turn concentrates at the tip.
	float wander = 0.0f; ///< rad, 0 to 1.5: maximum random turn of the tip, sideways and along.
};

/// The line along which a part runs, of length 1: by arc length, so that bending never makes it longer (a Bézier's
/// length changes as it bends). Its own axes: it begins at the origin along +y and bends towards +z.
class Midrib {
public:
	static constexpr int STEPS = 48; ///< Between the points that are stored.

	/// A point on the line and its axes: across = (1, 0, 0) at the base, along × across = up.
	/// They never turn about the line (rotation-minimising: Wang, Jüttler, Zheng and Liu 2008).
	struct Place {
		glm::vec3 point;
		glm::vec3 along; ///< Unit length.
		glm::vec3 across; ///< Unit length, towards the right edge of a blade.
		glm::vec3 up; ///< Unit length, the upper (adaxial) side of a blade.
		glm::vec3 curvature; ///< Change of `along` per length.
	};

	/// What all midribs of a curve have in common, computed once: their turns without noise.
	class Family {
	public:
		explicit Family(const MidribCurve &curve);

	private:
		friend class Midrib;
		MidribCurve curve;
		std::vector<double> turns; ///< rad, at the sampled offsets.
	};

	/// `seed` chooses the noise; without `wander` it is unused.
	Midrib(const Family &family, uint64_t seed);
	/// Without noise.
	explicit Midrib(const Family &family);
	explicit Midrib(const MidribCurve &curve, uint64_t seed = 0) : Midrib(Family(curve), seed) {}

	/// The place at the offset `s` from 0 to 1. Points lie within 1e-4 of the exact curve.
	Place at(float s) const;
	/// Only the point.
	glm::vec3 point_at(float s) const;

private:
	struct Node {
		glm::vec3 point;
		glm::vec3 along;
		glm::vec3 across;
	};
	std::array<Node, STEPS + 1> nodes;
	bool is_straight = true;

	/// `direction_at(number)` returns the direction at a sampled offset.
	template <class Directions> void follow(const Directions &direction_at);
	/// The last node at or below an offset, never the very last; `beyond`: the fraction of the way to the
	/// next node.
	const Node &node_below(float s, float &beyond) const;
	static glm::vec3 between(const Node &a, const Node &b, float t);
};

} // namespace undergrowth
