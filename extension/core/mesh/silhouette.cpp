#include "mesh/silhouette.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace undergrowth {

namespace {

constexpr int DOTS = 256; // Across and up.
constexpr int SIDES = 4;
constexpr float HALF = 0.70710678f;
constexpr float COSINES[SIDES] = { 1.0f, HALF, 0.0f, -HALF };
constexpr float SINES[SIDES] = { 0.0f, HALF, 1.0f, HALF };

/// Dots in rows of bits.
class Picture {
public:
	/// A triangle in dots, corners at (x[i], y[i]).
	void draw(const float (&x)[3], const float (&y)[3]) {
		const int low = std::max(0, static_cast<int>(std::ceil(std::min({ y[0], y[1], y[2] }) - 0.5f)));
		const int high = std::min(DOTS - 1, static_cast<int>(std::floor(std::max({ y[0], y[1], y[2] }) - 0.5f)));
		for (int row = low; row <= high; row++) {
			draw_row(x, y, row);
		}
	}
	int count() const {
		int sum = 0;
		for (const auto &row : rows) {
			for (uint64_t word : row) {
				for (; word != 0; word &= word - 1) {
					sum++;
				}
			}
		}
		return sum;
	}

private:
	std::array<std::array<uint64_t, DOTS / 64>, DOTS> rows = {};

	/// From where to where the triangle crosses the middle of a row.
	void draw_row(const float (&x)[3], const float (&y)[3], int row) {
		const float level = static_cast<float>(row) + 0.5f;
		float left = 1e9f;
		float right = -1e9f;
		for (int i = 0; i < 3; i++) {
			const int k = (i + 1) % 3;
			if ((y[i] <= level) != (y[k] <= level)) {
				const float at = x[i] + (x[k] - x[i]) * ((level - y[i]) / (y[k] - y[i]));
				left = std::min(left, at);
				right = std::max(right, at);
			}
		}
		const int first = std::max(0, static_cast<int>(std::ceil(std::max(left, 0.0f) - 0.5f)));
		const int last = static_cast<int>(std::floor(std::min(right, static_cast<float>(DOTS)) - 0.5f));
		for (int word = 0; word < DOTS / 64 && first <= last; word++) {
			const int from = std::max(first - 64 * word, 0);
			const int to = std::min(last - 64 * word, 63);
			if (from <= to) {
				rows[static_cast<size_t>(row)][static_cast<size_t>(word)] |= (~uint64_t(0) >> (63 - to + from)) << from;
			}
		}
	}
};

} // namespace

float silhouette_area(const glm::vec3 *positions, const int32_t *indices, int index_count, float reach, float height) {
	const float across = DOTS / (2.0f * reach);
	const float up = DOTS / height;
	int dots = 0;
	for (int side = 0; side < SIDES; side++) {
		Picture picture;
		for (int i = 0; i < index_count; i += 3) {
			float x[3];
			float y[3];
			for (int k = 0; k < 3; k++) {
				const glm::vec3 &point = positions[indices[i + k]];
				x[k] = (point.x * COSINES[side] + point.z * SINES[side] + reach) * across;
				y[k] = point.y * up;
			}
			picture.draw(x, y);
		}
		dots += picture.count();
	}
	return static_cast<float>(dots) / (SIDES * across * up);
}

} // namespace undergrowth
