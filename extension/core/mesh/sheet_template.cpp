#include "mesh/template_parts.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"

namespace undergrowth {

namespace {

std::vector<BladeColumn> blade_columns(const BladeShape &blade, int count) {
	std::vector<BladeColumn> columns;
	for (int i = 0; i < count; i++) {
		columns.push_back(
				make_blade_column(blade, 2.0f * static_cast<float>(i) / static_cast<float>(count - 1) - 1.0f));
	}
	return columns;
}

void add_sheet_row(PartTemplate &out, const Part &part, const BladeRow &row, const std::vector<BladeColumn> &columns) {
	const float lean = static_cast<float>(portable_tan(part.blade.roundness));
	for (const BladeColumn &column : columns) {
		const glm::vec4 color = part.colors.at(row.offset, column.u < 0.0f ? -column.u : column.u);
		const glm::vec2 uv = { 0.5f + 0.5f * column.u, 1.0f - row.offset };
		out.vertices.push_back({ blade_point(row, column), color, uv, row.offset, lean * column.u });
	}
}

} // namespace

PartTemplate make_sheet_template(const Part &part, const Midrib &midrib, const PartDetail &detail, bool has_spike) {
	PartTemplate out = room_for(part, detail);
	const std::vector<float> offsets = row_offsets(part, detail);
	const std::vector<BladeColumn> columns = blade_columns(part.blade, detail.columns);
	const bool pointed = has_spike || (ends_in_point(part) && !part.axis.open_tip);
	const bool teeth = shows_teeth(part, detail);
	Weaver weaver(out, detail.columns, false);
	for (int i = 0; i <= detail.rows; i++) {
		const int first = static_cast<int>(out.vertices.size());
		BladeRow row = make_blade_row(part, midrib, offsets[static_cast<size_t>(i)], teeth);
		const bool is_tip = pointed && i == detail.rows;
		if (has_spike) {
			row.half_width = is_tip ? 0.0f : part.widths.mean();
			row.half_width_slope = -part.widths.mean();
		}
		add_sheet_row(
				out, part, row, is_tip ? std::vector<BladeColumn>{ make_blade_column(part.blade, 0.0f) } : columns);
		if (is_tip) {
			weaver.fan_to_tip(first - detail.columns, first);
		} else if (i > 0) {
			weaver.band(first - detail.columns, first);
		}
	}
	return out;
}

} // namespace undergrowth
