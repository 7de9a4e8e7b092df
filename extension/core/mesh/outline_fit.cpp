#include "mesh/outline_fit.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float TURNED = 0.35f; // Weight of growing in one direction relative to growing in all.
constexpr float MAX_TURN = 0.5f; // Tangent of half the angle.
constexpr float MAX_STEP = 0.5f;
constexpr float STIFFNESS = 1e-3f; // Stabilizes outlines that the numbers cannot change independently.
constexpr float MIN_AREA = 1e-20f; // m²; smaller areas have no effect.
// The same if the widths reduced all areas to 0, by the float precision of the matrix.
constexpr float ROUNDING = 1e-5f;

} // namespace

void solve_outlines(float (&a)[OUTLINES][OUTLINES], float (&b)[OUTLINES]) {
	for (size_t i = 0; i < OUTLINES; i++) {
		for (size_t k = 0; k <= i; k++) {
			float rest = a[i][k];
			for (size_t j = 0; j < k; j++) {
				rest -= a[i][j] * a[k][j];
			}
			a[i][k] = i == k ? std::sqrt(std::max(rest, 1e-12f)) : rest / a[k][k];
		}
	}
	for (size_t i = 0; i < OUTLINES; i++) {
		for (size_t j = 0; j < i; j++) {
			b[i] -= a[i][j] * b[j];
		}
		b[i] /= a[i][i];
	}
	for (size_t i = OUTLINES; i-- > 0;) {
		for (size_t j = i + 1; j < OUTLINES; j++) {
			b[i] -= a[j][i] * b[j];
		}
		b[i] /= a[i][i];
	}
}

OutlineFit::OutlineFit(const std::vector<WrittenUnit> &p_written, const FormBuffers &p_mesh) :
		written(p_written), mesh(p_mesh), units(p_written.size() - 1) {
	for (int i = 0; i < written.back().vertex; i++) {
		asides.emplace_back(mesh.custom2[i]);
	}
	for (size_t u = 0; u < units.size(); u++) {
		look_at(u);
	}
}

/// A triangle's area in a picture is half the cross product of two edges; its change is that of the edges.
void OutlineFit::look_at(size_t number) {
	Unit &unit = units[number];
	const float share = 0.5f * written[number].near_share;
	for (int i = written[number].index; i < written[number + 1].index; i += 3) {
		const int32_t *corner = mesh.indices + i;
		for (size_t side = 0; side < OUTLINES; side++) {
			const float c = OUTLINE_COSINES[side];
			const float s = OUTLINE_SINES[side];
			float x[3];
			float y[3];
			float dx[3][STRETCHES];
			float dy[3];
			for (int k = 0; k < 3; k++) {
				const glm::vec3 &point = mesh.positions[corner[k]];
				const glm::vec4 &aside = mesh.custom2[corner[k]];
				x[k] = point.x * c + point.z * s;
				y[k] = point.y;
				dx[k][0] = aside.x * c + aside.z * s;
				dx[k][1] = aside.x * c - aside.z * s;
				dx[k][2] = aside.z * c + aside.x * s;
				dy[k] = aside.y;
			}
			const float twice = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
			const float sign = twice < 0.0f ? -share : share;
			unit.area[side] += twice * sign;
			for (size_t way = 0; way < STRETCHES; way++) {
				float change = (dx[1][way] - dx[0][way]) * (y[2] - y[0]) - (dx[2][way] - dx[0][way]) * (y[1] - y[0]);
				if (way == 0) {
					change += (x[1] - x[0]) * (dy[2] - dy[0]) - (x[2] - x[0]) * (dy[1] - dy[0]);
				}
				unit.change[side][way] += change * sign;
			}
		}
	}
	float mean = 0.0f;
	for (const float area : unit.area) {
		mean += area / OUTLINES;
	}
	for (size_t way = 0; way < WAYS; way++) {
		unit.weight[way] = mean > MIN_AREA ? (way == 0 ? 1.0f : TURNED) / mean : 0.0f;
	}
}

void OutlineFit::approach(const Outlines &areas, const Outlines &wanted) {
	float matrix[OUTLINES][OUTLINES] = {};
	float right[OUTLINES];
	float all = 0.0f;
	for (size_t i = 0; i < OUTLINES; i++) {
		float whole = 0.0f;
		for (const Unit &unit : units) {
			whole += unit.area[i];
			for (size_t way = 0; way < STRETCHES; way++) {
				whole += unit.change[i][way] * unit.widths[way];
				for (size_t k = 0; k < OUTLINES; k++) {
					matrix[i][k] += unit.change[i][way] * unit.weight[way] * unit.change[k][way];
				}
			}
		}
		all += whole;
		// Assumes that the hidden fraction does not change.
		right[i] = (wanted[i] / std::max(areas[i], 0.05f * wanted[i]) - 1.0f) * whole;
	}
	const float trace = matrix[0][0] + matrix[1][1] + matrix[2][2] + matrix[3][3];
	for (size_t i = 0; i < OUTLINES; i++) {
		matrix[i][i] += std::max({ STIFFNESS * all, ROUNDING * trace, 1e-15f });
	}
	solve_outlines(matrix, right);
	for (size_t u = 0; u < units.size(); u++) {
		Unit &unit = units[u];
		for (size_t way = 0; way < STRETCHES; way++) {
			float change = 0.0f;
			for (size_t i = 0; i < OUTLINES; i++) {
				change += unit.weight[way] * unit.change[i][way] * right[i];
			}
			change = std::clamp(change, -MAX_STEP, MAX_STEP);
			unit.widths[way] += change;
		}
		limit(u, unit.widths);
		apply(u, unit.widths);
	}
}

void OutlineFit::limit(size_t number, Ways &widths) const {
	const bool is_flower = written[number].is_flower;
	const float min = (is_flower ? limits.min_flower : limits.min) - 1.0f;
	const float max = std::min(is_flower ? limits.max_flower : limits.max, written[number].max) - 1.0f;
	widths[0] = std::clamp(widths[0], min, max);
	widths[TURN] = std::clamp(widths[TURN], -MAX_TURN, MAX_TURN);
	float turned = is_flower ? limits.turned_flower : limits.turned;
	if (limits.by_width) { // In combination they never turn a sheet over.
		turned *= 1.0f + widths[0];
		const float both = std::sqrt(widths[1] * widths[1] + widths[2] * widths[2]);
		const float share = both > turned ? turned / both : 1.0f;
		widths[1] *= share;
		widths[2] *= share;
		return;
	}
	widths[1] = std::clamp(widths[1], -turned, turned);
	widths[2] = std::clamp(widths[2], -turned, turned);
}

void OutlineFit::keep() {
	for (Unit &unit : units) {
		unit.saved = unit.widths;
	}
}

void OutlineFit::finish() {
	for (size_t u = 0; u < units.size(); u++) {
		units[u].widths = units[u].saved;
		apply(u, units[u].saved);
	}
}

void OutlineFit::apply(size_t number, const Ways &widths) {
	const float width = 1.0f + widths[0];
	const HalfTurn turn(widths[TURN]);
	for (int i = written[number].vertex; i < written[number + 1].vertex; i++) {
		const glm::vec3 &was = asides[static_cast<size_t>(i)];
		const glm::vec3 wide = { (width + widths[1]) * was.x + widths[2] * was.z, was.y * width,
			(width - widths[1]) * was.z + widths[2] * was.x };
		const glm::vec3 now = widths[TURN] == 0.0f ? wide : turn.of(wide);
		mesh.positions[i] += now - glm::vec3(mesh.custom2[i]);
		mesh.custom2[i] = glm::vec4(now, mesh.custom2[i].w);
	}
}

} // namespace undergrowth
