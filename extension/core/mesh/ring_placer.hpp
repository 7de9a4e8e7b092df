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

	/// height·level/lod, rounded once: the last ring is exactly at the height.
	float level_height(int level) const;
	/// Metres between two levels; above 0 even if rounding makes their heights equal.
	float rise_between(int below, int above) const;
	/// Change of the width around a ring per metre of height.
	float width_slope(int level) const;
	/// Writes the ring's points, as many as the cross-section has.
	void place(int level, glm::vec3 *out) const;
	void paint(int level, glm::vec4 *out) const;
	/// Writes the ring's outward unit normals, horizontal, for any width.
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
