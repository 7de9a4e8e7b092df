#pragma once

#include "mesh/deviation.hpp"
#include "mesh/plant_mesh.hpp"
#include "plant/base_shape.hpp"

namespace undergrowth {

/// Places the rings of one mesh, for both kinds of shading.
class RingPlacer {
public:
	RingPlacer(const PlantSample &sample, const MeshOptions &options);

	int points() const { return count; }
	int lod() const { return sample.lod; }
	bool has_shape_deviation() const { return bends; }

	/// height·level/lod, rounded once: the last ring is at the height itself.
	float level_height(int level) const;
	/// Metres between two levels; above 0 even if rounding leaves nothing between them.
	float rise_between(int below, int above) const;
	/// Change of the width around a ring per metre of height.
	float width_slope(int level) const;
	/// Writes the ring's points, one for each point of the cross-section.
	void place(int level, glm::vec3 *out) const;
	void paint(int level, glm::vec4 *out) const;
	/// Writes the outward unit normals of the ring itself: level, and independent of its width.
	void level_normals(int level, glm::vec2 *out) const;

private:
	Deviation::Ring ring_deviation(int level) const;

	const PlantSample &sample;
	const int count;
	const bool bends;
	const bool tints;
	const Deviation deviation;
	Bearing bearings[MAX_RING_POINTS];
};

} // namespace undergrowth
