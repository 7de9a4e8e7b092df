#pragma once

#include "mesh/part_template.hpp"

#include <vector>

namespace undergrowth {

/// Writes triangles between consecutive rows of equal length, clockwise from the front.
class Weaver {
public:
	Weaver(PartTemplate &p_out, int p_columns, bool p_closed) :
			out(p_out), columns(p_columns), spans(p_closed ? p_columns : p_columns - 1) {}

	void band(int lower, int upper) {
		for (int i = 0; i < spans; i++) {
			const int next = (i + 1) % columns;
			add(lower + i, lower + next, upper + next);
			add(lower + i, upper + next, upper + i);
		}
	}
	void fan_to_tip(int row, int tip) {
		for (int i = 0; i < spans; i++) {
			add(row + i, row + (i + 1) % columns, tip);
		}
	}
	void fan_to_base(int row, int base) {
		for (int i = 0; i < spans; i++) {
			add(row + i, base, row + (i + 1) % columns);
		}
	}

private:
	void add(int a, int b, int c) {
		out.indices.push_back(a);
		out.indices.push_back(b);
		out.indices.push_back(c);
	}

	PartTemplate &out;
	const int columns;
	const int spans;
};

/// Returns an empty template with reserved capacity.
inline PartTemplate room_for(const Part &part, const PartDetail &detail) {
	const MeshCounts counts = count_part(part, detail);
	PartTemplate out;
	out.vertices.reserve(static_cast<size_t>(counts.vertices));
	out.indices.reserve(static_cast<size_t>(counts.indices));
	return out;
}

/// Parts of make_part_template(). `has_spike`: ends in a point, and is as wide at its base as a triangle of its area.
PartTemplate make_sheet_template(const Part &part, const Midrib &midrib, const PartDetail &detail, bool has_spike);
PartTemplate make_tube_template(const Part &part, const Midrib &midrib, const PartDetail &detail);
PartTemplate make_bead_template(const Part &part, const Midrib &midrib, const PartDetail &detail);

} // namespace undergrowth
