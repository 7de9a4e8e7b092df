#include "mesh/ear_clipping.hpp"

#include <algorithm>
#include <numeric>

namespace undergrowth {

namespace {

/// Twice the area of abc, positive if it is counter-clockwise from above. Doubles represent float coordinates exactly.
double area(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
	return (b.y - a.y) * (c.x - a.x) - (b.x - a.x) * (c.y - a.y);
}

/// The part of the ring that has no triangles yet.
class Remainder {
public:
	explicit Remainder(const std::vector<glm::vec2> &p_ring) : ring(p_ring), left(p_ring.size()) {
		std::iota(left.begin(), left.end(), 0);
	}

	int size() const { return static_cast<int>(left.size()); }
	int32_t before(int i) const { return left[(i + size() - 1) % size()]; }
	int32_t here(int i) const { return left[i]; }
	int32_t after(int i) const { return left[(i + 1) % size()]; }
	void remove(int i) { left.erase(left.begin() + i); }

	/// True if the triangle at position `i` is inside and contains no other point, not even on its border.
	bool is_ear(int i) const {
		const glm::vec2 a = ring[before(i)];
		const glm::vec2 b = ring[here(i)];
		const glm::vec2 c = ring[after(i)];
		if (area(a, b, c) <= 0.0) {
			return false;
		}
		return std::none_of(left.begin(), left.end(), [&](int32_t other) {
			const glm::vec2 p = ring[other];
			const bool corner = other == before(i) || other == here(i) || other == after(i);
			return !corner && area(a, b, p) >= 0.0 && area(b, c, p) >= 0.0 && area(c, a, p) >= 0.0;
		});
	}

private:
	const std::vector<glm::vec2> &ring;
	std::vector<int32_t> left;
};

/// Returns the first ear from `start` on. Without an ear the rest is a line, and any point will do.
int find_ear(const Remainder &rest, int start) {
	for (int i = 0; i < rest.size(); i++) {
		const int place = (start + i) % rest.size();
		if (rest.is_ear(place)) {
			return place;
		}
	}
	return start % rest.size();
}

} // namespace

std::vector<int32_t> clip_ears(const std::vector<glm::vec2> &ring) {
	std::vector<int32_t> triangles;
	triangles.reserve(3 * (ring.size() - 2));
	Remainder rest(ring);
	int place = 1;
	while (rest.size() >= 3) {
		place = find_ear(rest, place);
		triangles.insert(triangles.end(), { rest.before(place), rest.here(place), rest.after(place) });
		rest.remove(place);
		// Advancing by one point prevents slivers in round rings.
		place++;
	}
	return triangles;
}

} // namespace undergrowth
