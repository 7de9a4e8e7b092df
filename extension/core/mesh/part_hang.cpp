#include "mesh/part_hang.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float GROUP_PHASE = 0.38196601f; // So that neighbours of two groups are apart, too.

PartHang hang_on_ground(const PlantForm &form, const PlacedPart &part) {
	PartHang hang;
	hang.is_root = true;
	// Stems bend by the plant's own bend alone; what lies on the ground as a leaf swings besides.
	hang.swings = form.parts[static_cast<size_t>(part.kind)].kind == PartKind::blade;
	return hang;
}

PartHang hang_on(const PlantForm &form, const PlacedPart &part, const PartHang &carrier) {
	const PlacedPart &carries = form.placed[static_cast<size_t>(part.carrier)];
	PartHang hang = carrier;
	hang.is_root = false;
	hang.stem_offset =
			carrier.is_root ? stem_offset_of(form, form.point_of(carries, part.offset)) : carrier.stem_offset;
	hang.swings = carrier.is_root && !carrier.swings && form.parts[static_cast<size_t>(part.kind)].frequency > 0.0f;
	hang.weight = carrier.weight_at(part.offset);
	return hang;
}

} // namespace

float stem_offset_of(const PlantForm &form, const glm::vec3 &point) {
	return std::clamp(point.y / form.height, 0.0f, 1.0f);
}

std::vector<PartHang> hang_parts(const PlantForm &form) {
	std::vector<PartHang> hangs;
	hangs.reserve(form.placed.size());
	for (const PlacedPart &part : form.placed) {
		const bool on_ground = part.carrier == ON_GROUND;
		const PartHang *carrier = on_ground ? nullptr : &hangs[static_cast<size_t>(part.carrier)];
		PartHang hang = on_ground ? hang_on_ground(form, part) : hang_on(form, part, *carrier);
		if (hang.swings) {
			const float phase = part.rank + GROUP_PHASE * static_cast<float>(part.group);
			hang.pivot = part.base;
			hang.frequency = form.parts[static_cast<size_t>(part.kind)].frequency;
			hang.phase = phase - std::floor(phase);
		}
		hang.rank = on_ground ? part.rank : std::max(part.rank, carrier->rank);
		hangs.push_back(hang);
	}
	return hangs;
}

} // namespace undergrowth
