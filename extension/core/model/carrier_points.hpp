#pragma once

#include "model/model_islands.hpp"

namespace undergrowth {

/// Points on the islands that may carry others, in a grid. Long edges have points between their ends.
class CarrierPoints {
public:
	struct Found {
		int island = -1; ///< -1: there is none.
		float square = 0.0f; ///< m², of the distance.
	};

	/// `carries`: by island. `height`: of the plant (m), which gives the distance of the points.
	CarrierPoints(const std::vector<ModelSurface> &surfaces, const std::vector<glm::vec3> &places,
			const ModelIslands &islands, const std::vector<bool> &carries, float height);

	/// Returns the nearest point on an island that is open.
	Found nearest(const glm::vec3 &place, const std::vector<bool> &is_open) const;

private:
	struct Point {
		glm::vec3 place;
		int island;
	};
	float cell = 1.0f; // m.
	glm::vec3 origin = glm::vec3(0.0f);
	int counts[3] = { 1, 1, 1 };
	std::vector<std::vector<Point>> cells;

	int coordinate(const glm::vec3 &place, int axis) const;
	void look_in(const int (&at)[3], const glm::vec3 &place, const std::vector<bool> &is_open, Found &best) const;
	void look_in_shell(const int (&middle)[3], int ring, const glm::vec3 &place, const std::vector<bool> &is_open,
			Found &best) const;
};

} // namespace undergrowth
