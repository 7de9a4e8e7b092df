#pragma once

#include "wind/air.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace undergrowth {

/// What grows around a plant.
struct PlantCanopy {
	float height = 0.0f; ///< m, as MotionSpecies::canopy_height; 0: an isolated plant.
	TallerPlants taller;
};

/// Drag area of the plants of a field over the area of its ground, by species, in square cells. Says which canopy
/// shelters the lower plants of a mixed stand. Sums are whole numbers, so that the order of changes has no effect.
class CanopyGrid {
public:
	static constexpr float CELL = 4.0f; ///< m.
	/// Drag area (m²) of taller plants over a square metre of ground from which on their canopy is closed. From about
	/// 0.3 on more plants do not raise the drag of a canopy (Harman and Finnigan 2007). The area of a species is that
	/// of one stem, and its plants have several, so this is half of that.
	static constexpr float CLOSED = 0.15f;

	/// Height (m) of the canopy of a species.
	void set_height(int species, float height);
	/// Adds a plant with this drag area (m²), or removes one with the negative area.
	void add(int species, float x, float z, float drag_area);
	/// Removes all plants.
	void clear();
	/// m; 0 for unknown species.
	float height(int species) const;
	/// The canopy of all species higher than `height` (m) over the box from `low` to `high` and half as much over the
	/// cells around it. So shelter begins and ends over about 8 m.
	TallerPlants higher_than(float height, const glm::vec3 &low, const glm::vec3 &high) const;
	/// The same over all cells with plants.
	TallerPlants higher_than(float height) const;
	/// What grows around a plant that does not belong to the field, at `place` in the field's axes. A plant of one of
	/// the field's species has the canopy of that species where it grows, and `species` is -1 for other plants. They
	/// are isolated unless half the ground is covered by plants of 0.7 times their height (m) or more.
	PlantCanopy around(const glm::vec3 &place, float height, int species) const;
	/// Changes with every plant.
	int64_t version() const { return changes; }
	std::size_t bytes() const;

private:
	using Areas = std::vector<int64_t>; ///< By species, in 1/UNIT m².

	std::unordered_map<uint64_t, Areas> cells; ///< With plants.
	Areas total; ///< Of all cells.
	std::vector<float> heights; ///< m.
	int64_t changes = 0;

	/// A canopy as a sum over cells.
	struct Sum {
		double area = 0.0; ///< In 1/UNIT m².
		double moment = 0.0; ///< Times heights.
		double ground = 0.0; ///< In cells.

		TallerPlants canopy() const;
	};

	void add_higher(float height, const Areas &areas, double weight, Sum &sum) const;
	bool grows_at(int species, const glm::vec3 &place) const;
};

} // namespace undergrowth
