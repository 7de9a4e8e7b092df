#include "form/surface.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float ROLL_FROM = 1e-3f; // rad: a smaller roll is a line.
constexpr float TOOTH_RISE = 0.75f; // Of a tooth: beyond it the edge returns.

/// A saw of teeth that point to the tip, from 0 to 1 and back.
float saw(float teeth) {
	const float t = teeth - std::floor(teeth);
	return t < TOOTH_RISE ? t / TOOTH_RISE : (1.0f - t) / (1.0f - TOOTH_RISE);
}

float edge_share(const BladeShape &blade, float offset, bool with_teeth) {
	if (blade.teeth == 0) {
		return 1.0f;
	}
	const float depth = with_teeth ? saw(static_cast<float>(blade.teeth) * offset) : 0.5f;
	return 1.0f - blade.tooth_depth * depth;
}

/// Rotates across and up by `angle` about along, and returns their derivatives by the offset.
void twist(BladeRow &row, float angle, float rate) {
	const float c = static_cast<float>(portable_cos(angle));
	const float s = static_cast<float>(portable_sin(angle));
	Midrib::Place &place = row.place;
	const glm::vec3 across = place.across * c + place.up * s;
	place.up = place.up * c - place.across * s;
	place.across = across;
	// Axes without a turn about the line change only towards it: as much as the line bends towards them.
	row.across_slope = place.up * rate - place.along * glm::dot(place.curvature, place.across);
	row.up_slope = place.across * -rate - place.along * glm::dot(place.curvature, place.up);
}

TubeColumn round_column(const AxisShape &axis, float turn) {
	const double angle = 2.0 * PI * turn;
	const double c = portable_cos(angle);
	const double s = portable_sin(angle);
	const double reach = 1.0 + axis.lobe_depth * (axis.lobes > 0 ? portable_cos(axis.lobes * angle) : 0.0);
	const double slope = -axis.lobe_depth * axis.lobes * portable_sin(axis.lobes * angle);
	return { turn, static_cast<float>(c * reach), static_cast<float>(s * reach),
		static_cast<float>(c * slope - s * reach), static_cast<float>(s * slope + c * reach) };
}

/// Rings run in the opposite direction.
TubeColumn ring_column(const std::vector<glm::vec2> &ring, float turn, float scale) {
	const size_t n = ring.size();
	const size_t i = (n - static_cast<size_t>(turn * static_cast<float>(n))) % n;
	const glm::vec2 way = ring[(i + n - 1) % n] - ring[(i + 1) % n];
	return { turn, ring[i].x * scale, ring[i].y * scale, way.x * scale, way.y * scale };
}

} // namespace

glm::vec3 surface_normal(const SurfacePoint &point, float length, float width) {
	return glm::normalize(glm::cross(point.along * length + point.aside_slope * width, point.around));
}

BladeRow make_blade_row(const Part &part, const Midrib &midrib, float offset, bool with_teeth) {
	const BladeShape &blade = part.blade;
	BladeRow row;
	row.offset = offset;
	row.place = midrib.at(offset);
	twist(row, blade.twist * offset, blade.twist);
	const float edge = edge_share(blade, offset, with_teeth);
	const float width = part.widths.at(offset);
	row.half_width = 0.5f * edge * width;
	row.half_width_slope =
			0.5f * edge * part.widths.slope(offset, width); // Teeth are too small for shading of their own.
	const double way = 2.0 * PI * blade.wave_count;
	row.wave = blade.wave * static_cast<float>(portable_sin(way * offset));
	row.wave_slope = blade.wave * static_cast<float>(way * portable_cos(way * offset));
	return row;
}

BladeColumn make_blade_column(const BladeShape &blade, float u) {
	const float a = std::abs(u);
	const float side = u < 0.0f ? -1.0f : 1.0f;
	const double fold = blade.fold;
	const double edge = fold + static_cast<double>(blade.roll) * a;
	const double c = portable_cos(edge);
	const double s = portable_sin(edge);
	BladeColumn column = { u, static_cast<float>(a * c) * side, static_cast<float>(a * s), static_cast<float>(c),
		static_cast<float>(s) * side };
	if (std::abs(blade.roll) > ROLL_FROM) {
		column.x = static_cast<float>((s - portable_sin(fold)) / blade.roll) * side;
		column.y = static_cast<float>((portable_cos(fold) - c) / blade.roll);
	}
	if (u == 0.0f) { // Both halves meet here: the surface is level.
		column.x_slope = 1.0f;
		column.y_slope = 0.0f;
	}
	return column;
}

SurfacePoint blade_point(const BladeRow &row, const BladeColumn &column) {
	const float u = column.u;
	const float y = column.y + row.wave * u * u;
	const glm::vec3 section = row.place.across * column.x + row.place.up * y;
	SurfacePoint point;
	point.middle = row.place.point;
	point.along = row.place.along;
	point.aside = section * row.half_width;
	point.aside_slope = section * row.half_width_slope +
			(row.across_slope * column.x + row.up_slope * y + row.place.up * (row.wave_slope * u * u)) * row.half_width;
	point.around = row.place.across * column.x_slope + row.place.up * (column.y_slope + 2.0f * row.wave * u);
	return point;
}

TubeRing make_tube_ring(const Part &part, const Midrib &midrib, float offset) {
	const float taper = part.taper();
	const float even = 1.0f + (taper - 1.0f) * offset;
	TubeRing ring;
	ring.offset = offset;
	ring.place = midrib.at(offset);
	const float width = part.widths.at(offset);
	ring.radius = 0.5f * (width * even);
	ring.radius_slope = 0.5f * (part.widths.slope(offset, width) * even + width * (taper - 1.0f));
	return ring;
}

std::vector<TubeColumn> make_tube_columns(const AxisShape &axis, int sides) {
	std::vector<TubeColumn> columns;
	float farthest = 0.0f;
	for (const glm::vec2 &point : axis.ring) {
		farthest = std::max(farthest, glm::length(point));
	}
	for (int i = 0; i < sides; i++) {
		const float turn = static_cast<float>(i) / static_cast<float>(sides);
		columns.push_back(farthest > 0.0f ? ring_column(axis.ring, turn, 1.0f / farthest) : round_column(axis, turn));
	}
	return columns;
}

SurfacePoint tube_point(const TubeRing &ring, const TubeColumn &column) {
	const Midrib::Place &place = ring.place;
	const glm::vec3 outward = place.across * column.x - place.up * column.z;
	SurfacePoint point;
	point.middle = place.point;
	point.along = place.along;
	point.aside = outward * ring.radius;
	point.aside_slope = outward * ring.radius_slope - place.along * (glm::dot(place.curvature, outward) * ring.radius);
	point.around = place.across * column.x_slope - place.up * column.z_slope;
	return point;
}

} // namespace undergrowth
