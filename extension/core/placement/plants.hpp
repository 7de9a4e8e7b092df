#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace undergrowth {

/// One placed plant of a field.
struct PlacedPlant {
	glm::vec3 root = { 0.0f, 0.0f, 0.0f }; ///< m, field axes.
	float scale = 1.0f; ///< Of the whole plant, 1e-6 to 1e6.
	float turn = 0.0f; ///< rad, around +y; any, stored from 0 to 2π.
	float height = 1.0f; ///< Times the species' height, beside `scale`; above 0, to FieldPlants::MAX_HEIGHT.
	float lean = 0.0f; ///< rad, from upright; 0 to π/2.
	float side = 0.0f; ///< rad, side of the lean: around +y from the plant's own +x; any, stored from 0 to 2π.
	int species = 0; ///< 0 to 255.
	int variant = 0; ///< 0 to 255, in the species' pool of meshes.
	float lightness = 0.0f; ///< -1 to 1, of a painted jitter of its color; 0: that of its species.
	float warmth = 0.0f; ///< The same, from bluish to yellowish.
};

/// True if all numbers are finite, and scale, species and variant are in range.
bool is_valid(const PlacedPlant &plant);

/// Placed plants in struct-of-arrays: 28 bytes a plant. Columns have equal lengths.
///
/// Turn, side, height and lean have 16 bits each, with resolutions of 1e-4 rad, 1e-4 rad, 1.3e-4 and 2.4e-5 rad.
/// Lightness and warmth have 8 bits. Values out of range are clamped.
struct FieldPlants {
	static constexpr float MAX_HEIGHT = 8.0f;
	static constexpr std::size_t PLANT_BYTES = 28;

	std::vector<float> x; ///< m, field axes, of roots; y and z alike.
	std::vector<float> y;
	std::vector<float> z;
	std::vector<float> scale;
	std::vector<uint16_t> turn; ///< 2π/65536 rad.
	std::vector<uint16_t> height; ///< MAX_HEIGHT/65536; 8192 is 1.
	std::vector<uint16_t> lean; ///< (π/2)/65535 rad.
	std::vector<uint16_t> side; ///< 2π/65536 rad.
	std::vector<uint8_t> species;
	std::vector<uint8_t> variant;
	std::vector<int8_t> lightness; ///< 1/127.
	std::vector<int8_t> warmth; ///< 1/127.

	int size() const { return static_cast<int>(x.size()); }
	void reserve(std::size_t count);
	/// Truncates, or appends plants with all values 0.
	void resize(std::size_t count);
	void clear() { resize(0); }

	/// Appends a plant. Returns false and adds nothing if it is invalid.
	bool add(const PlacedPlant &plant);
	/// Appends all plants of `other`, in their order.
	void append(const FieldPlants &other);
	PlacedPlant plant(int index) const;
	/// Returns the angle (rad) of a value of `turn` or `side`.
	static float angle_of(uint16_t code);
	/// Returns the number, -1 to 1, of a value of `lightness` or `warmth`.
	static float color_of(int8_t code);
	/// Plant `to` becomes equal to plant `from`.
	void copy(int from, int to);
	/// The plants order[0], order[1], … to order[size() - 1].
	FieldPlants reordered(const std::vector<int> &order) const;
	/// Removes plants; the order of the rest does not change. Indices ascend and do not repeat.
	void remove(const std::vector<int> &ascending);

	/// Heap bytes, by capacity.
	std::size_t bytes() const;
};

/// Limits of the ground on which plants grow.
struct GroundLimits {
	float lowest = -3.4e38f; ///< m, field axes.
	float highest = 3.4e38f;
	float flattest = 0.0f; ///< rad, slope; 0 is level, π/2 a wall.
	float steepest = 3.2f; ///< rad.
	float alignment = 0.0f; ///< 0: plants lean as on level ground; 1: with the ground's normal, too.
};

/// Sets each plant's y to heights[i], leans it by the alignment with the slope, and removes plants with a height or
/// slope out of the (inclusive) limits or not finite; NaN means no ground. Preserves the order and returns the number
/// of remaining plants. `heights` (m) and `normals` (of any length > 0) have one entry per plant; null normals mean
/// level ground.
int apply_ground(FieldPlants &plants, const float *heights, const glm::vec3 *normals, const GroundLimits &limits);

} // namespace undergrowth
