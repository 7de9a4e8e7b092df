#include "climb/climb_stems.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace undergrowth {

namespace {

constexpr float YOUNG_LENGTH = 0.8f; // m from the tip.
constexpr int LONGEST_GAP = 16; // Points.

class StemWriter {
public:
	StemWriter(const Climb &of, const StemStyle &by, StemMesh &to) : climb(of), style(by), mesh(to) {
		for (int i = 0; i <= style.sides; i++) {
			const double angle = 2.0 * PI * static_cast<double>(i % style.sides) / static_cast<double>(style.sides);
			const SineAndCosine turn = portable_sine_and_cosine(angle);
			corners.push_back({ static_cast<float>(turn.cosine), static_cast<float>(turn.sine) });
		}
	}

	void add(const StemRun &run) {
		const std::vector<int> kept = reduced(run);
		if (point(kept.front()).radius < style.thinnest) {
			return;
		}
		for (std::size_t i = 0; i < kept.size(); i++) {
			const glm::vec3 from = point(kept[i > 0 ? i - 1 : 0]).place;
			const glm::vec3 to = point(kept[std::min(i + 1, kept.size() - 1)]).place;
			add_ring(point(kept[i]), to - from);
			if (i > 0) {
				join();
			}
		}
	}

private:
	const Climb &climb;
	const StemStyle &style;
	StemMesh &mesh;
	std::vector<glm::vec2> corners;

	const ClimbPoint &point(int i) const { return climb.points[static_cast<std::size_t>(i)]; }

	float distance_to_line(const glm::vec3 &from, const glm::vec3 &to, const glm::vec3 &place) const {
		const glm::vec3 way = to - from;
		const float square = std::max(glm::dot(way, way), 1e-12f);
		const float share = std::clamp(glm::dot(place - from, way) / square, 0.0f, 1.0f);
		return glm::distance(place, from + share * way);
	}

	bool is_straight(int from, int to) const {
		for (int i = from + 1; i < to; i++) {
			if (distance_to_line(point(from).place, point(to).place, point(i).place) > style.tolerance) {
				return false;
			}
		}
		return true;
	}

	std::vector<int> reduced(const StemRun &run) const {
		std::vector<int> kept = { run.first };
		const int last = run.first + run.count - 1;
		for (int i = run.first + 1; i < last; i++) {
			if (i + 1 - kept.back() > LONGEST_GAP || !is_straight(kept.back(), i + 1)) {
				kept.push_back(i);
			}
		}
		kept.push_back(last);
		return kept;
	}

	void add_ring(const ClimbPoint &at, const glm::vec3 &way) {
		const float length = glm::length(way);
		const glm::vec3 along = length > 1e-8f ? way / length : glm::vec3(0.0f, 1.0f, 0.0f);
		glm::vec3 across = glm::cross(along, at.normal);
		const float size = glm::length(across);
		across = size > 1e-4f ? across / size : glm::normalize(glm::cross(along, glm::vec3(0.3f, 0.5f, 0.8f)));
		const glm::vec3 up = glm::cross(across, along);
		const float young = 1.0f - std::min(at.to_tip / YOUNG_LENGTH, 1.0f);
		for (std::size_t i = 0; i < corners.size(); i++) {
			const glm::vec3 out = across * corners[i].x + up * corners[i].y;
			mesh.positions.push_back(at.place + out * at.radius);
			mesh.normals.push_back(out);
			mesh.colors.push_back(glm::mix(style.old_wood, style.young_wood, young));
			mesh.uvs.push_back({ static_cast<float>(i) / static_cast<float>(style.sides), at.to_tip });
		}
	}

	void join() {
		const int ring = style.sides + 1;
		const int to = static_cast<int>(mesh.positions.size()) - ring;
		const int from = to - ring;
		for (int i = 0; i < style.sides; i++) {
			const int quad[6] = { from + i, from + i + 1, to + i, to + i, from + i + 1, to + i + 1 };
			mesh.indices.insert(mesh.indices.end(), quad, quad + 6);
		}
	}
};

} // namespace

StemMesh build_stems(const Climb &climb, const std::vector<StemRun> &runs, const StemStyle &style) {
	StemMesh mesh;
	StemWriter writer(climb, style, mesh);
	for (const StemRun &run : runs) {
		writer.add(run);
	}
	return mesh;
}

} // namespace undergrowth
