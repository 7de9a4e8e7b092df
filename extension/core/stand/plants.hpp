#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace undergrowth {

/// One plant as it stands in a field.
struct PlacedPlant {
	glm::vec3 root = { 0.0f, 0.0f, 0.0f }; ///< m, field axes.
	float scale = 1.0f; ///< Of the whole plant, 1e-6 to 1e6.
	float turn = 0.0f; ///< rad, around +y; any, kept from 0 to 2π.
	float height = 1.0f; ///< Times the species' height, beside `scale`; above 0, to FieldPlants::MOST_HEIGHT.
	float lean = 0.0f; ///< rad, from upright; 0 to π/2.
	float side = 0.0f; ///< rad, to which side it leans: around +y from the plant's own +x; any, kept from 0 to 2π.
	int species = 0; ///< 0 to 255.
	int variant = 0; ///< 0 to 255, in the species' pool of meshes.
};

/// Whether all numbers are finite, and the scale, the species and the variant in range.
bool is_valid(const PlacedPlant &plant);

/// What was placed in a field, in struct-of-arrays: 26 bytes a plant. Columns have equal lengths.
///
/// Turn, side, height and lean are kept in 16 bits each: to 1e-4 rad, 1e-4 rad, 1.3e-4 and 2.4e-5 rad; heights and
/// leans out of range become the nearest in range.
struct FieldPlants {
	static constexpr float MOST_HEIGHT = 8.0f;
	static constexpr std::size_t PLANT_BYTES = 26;

	std::vector<float> x; ///< m, field axes, of roots; y and z alike.
	std::vector<float> y;
	std::vector<float> z;
	std::vector<float> scale;
	std::vector<uint16_t> turn; ///< 2π/65536 rad.
	std::vector<uint16_t> height; ///< MOST_HEIGHT/65536; 8192 stands for 1.
	std::vector<uint16_t> lean; ///< (π/2)/65535 rad.
	std::vector<uint16_t> side; ///< 2π/65536 rad.
	std::vector<uint8_t> species;
	std::vector<uint8_t> variant;

	int size() const { return static_cast<int>(x.size()); }
	void reserve(std::size_t count);
	/// Cuts the end off, or appends plants of which all values are 0.
	void resize(std::size_t count);
	void clear() { resize(0); }

	/// Appends a plant; one that is not valid is left out and tells false.
	bool add(const PlacedPlant &plant);
	/// Appends all plants of `other`, in their order.
	void append(const FieldPlants &other);
	PlacedPlant plant(int index) const;
	/// Plant `to` becomes equal to plant `from`.
	void copy(int from, int to);
	/// The plants order[0], order[1], … to order[size() - 1].
	FieldPlants reordered(const std::vector<int> &order) const;
	/// Removes plants, those left keep their order. Indices ascend and do not repeat.
	void remove(const std::vector<int> &ascending);

	/// Of the heap, by capacity.
	std::size_t bytes() const;
};

/// What ground plants stand on.
struct GroundLimits {
	float lowest = -3.4e38f; ///< m, field axes.
	float highest = 3.4e38f;
	float flattest = 0.0f; ///< rad, slope; 0 is level, π/2 a wall.
	float steepest = 3.2f; ///< rad.
	float alignment = 0.0f; ///< 0: plants lean as on level ground; 1: with the ground's normal, too.
};

/// Sets each plant's y to heights[i], leans it by the alignment with the slope, and removes those whose height or slope
/// is beyond the limits (which are included) or not finite: NaN stands for no ground. Those left keep their order;
/// tells how many they are. `heights` (m) and `normals` (of any length > 0) have an entry for each plant; null normals
/// stand for level ground.
int apply_ground(FieldPlants &plants, const float *heights, const glm::vec3 *normals, const GroundLimits &limits);

} // namespace undergrowth
