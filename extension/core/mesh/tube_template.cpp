#include "mesh/template_parts.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"

namespace undergrowth {

namespace {

TemplateVertex pole(const Midrib::Place &place, const glm::vec4 &color, float offset, bool at_base) {
	// Its normal is along the part: across × up = along.
	const SurfacePoint point = { place.point, place.across, glm::vec3(0.0f), glm::vec3(0.0f),
		at_base ? place.up * -1.0f : place.up };
	return { point, color, { 0.5f, 1.0f - offset }, offset, 0.0f };
}

void add_ring(PartTemplate &out, const Part &part, const TubeRing &ring, const std::vector<TubeColumn> &columns) {
	const glm::vec4 color = part.colors.at(ring.offset, 0.0f);
	for (const TubeColumn &column : columns) {
		const float u = column.turn < 0.5f ? 2.0f * column.turn : 2.0f - 2.0f * column.turn;
		out.vertices.push_back({ tube_point(ring, column), color, { u, 1.0f - ring.offset }, ring.offset, 0.0f });
	}
}

} // namespace

PartTemplate make_bead_template(const Part &part, const Midrib &midrib, const PartDetail &detail) {
	PartTemplate out = room_for(part, detail);
	const std::vector<float> offsets = row_offsets(part, detail);
	const std::vector<TubeColumn> columns = make_tube_columns(AxisShape(), detail.columns);
	const int sides = detail.columns;
	const bool has_base = detail.rows > 1; // Otherwise it is a pyramid, open below.
	Weaver weaver(out, sides, true);
	for (size_t i = has_base ? 1 : 0; i + 1 < offsets.size(); i++) {
		const int first = static_cast<int>(out.vertices.size());
		add_ring(out, part, make_tube_ring(part, midrib, offsets[i]), columns);
		if (first > 0) {
			weaver.band(first - sides, first);
		}
	}
	const int tip = static_cast<int>(out.vertices.size());
	out.vertices.push_back(pole(midrib.at(1.0f), part.colors.at(1.0f, 0.0f), 1.0f, false));
	weaver.fan_to_tip(tip - sides, tip);
	if (has_base) {
		out.vertices.push_back(pole(midrib.at(0.0f), part.colors.at(0.0f, 0.0f), 0.0f, true));
		weaver.fan_to_base(0, tip + 1);
	}
	return out;
}

PartTemplate make_tube_template(const Part &part, const Midrib &midrib, const PartDetail &detail) {
	PartTemplate out = room_for(part, detail);
	const std::vector<float> offsets = row_offsets(part, detail);
	const std::vector<TubeColumn> columns = make_tube_columns(part.axis, detail.columns);
	const bool pointed = ends_in_point(part) && !part.axis.open_tip;
	const int sides = detail.columns;
	const int rings = pointed ? detail.rows : detail.rows + 1;
	Weaver weaver(out, sides, true);
	for (int i = 0; i < rings; i++) {
		add_ring(out, part, make_tube_ring(part, midrib, offsets[static_cast<size_t>(i)]), columns);
		if (i > 0) {
			weaver.band(sides * (i - 1), sides * i);
		}
	}
	if (pointed || has_lid(part, detail)) {
		out.vertices.push_back(pole(midrib.at(1.0f), part.colors.at(1.0f, 0.0f), 1.0f, false));
		weaver.fan_to_tip(sides * (rings - 1), sides * rings);
	}
	return out;
}

} // namespace undergrowth
