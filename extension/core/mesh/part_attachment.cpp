#include "mesh/part_attachment.hpp"

#include "mesh/branch_frequencies.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float GROUP_PHASE = 0.38196601f; // Separates the phases of neighbours in two groups.
// Fraction of the plant's height: longer parts at a stem's tip are leaves of a crown.
constexpr float MAX_HEAD_SHARE = 0.25f;
constexpr float TIP = 0.999f; // Offset.
constexpr int ROOM_PLACES = 4;
constexpr float MIN_DISTANCE = 1e-4f; // m.
constexpr float MIN_SIDE_OFFSET = 1e-5f; // Fraction of the length: upright parts hang on the side of their back.

float frequency_of(const PlantForm &form, const PlacedPart &part) {
	return form.parts[static_cast<size_t>(part.kind)].frequency;
}

glm::vec2 side_of(const PlantForm &form, const PlacedPart &part) {
	const glm::vec3 way = form.point_of(part, 1.0f) - part.base;
	const glm::vec2 aside(way.x, way.z);
	if (glm::dot(aside, aside) > MIN_SIDE_OFFSET * MIN_SIDE_OFFSET * part.length * part.length) {
		return aside;
	}
	return { part.axes.outward.x, part.axes.outward.z };
}

/// Returns the angle by which a part can turn outward before its midrib meets the ground, to first order, with each
/// point at its weight.
float room_of(const PlantForm &form, const PlacedPart &part) {
	float room = 1.0f;
	for (int i = 1; i <= ROOM_PLACES; i++) {
		const float offset = static_cast<float>(i) / ROOM_PLACES;
		const glm::vec3 point = form.point_of(part, offset);
		const float away = std::max(glm::length(glm::vec2(point.x - part.base.x, point.z - part.base.z)), MIN_DISTANCE);
		room = std::min(room, 0.5f * std::max(point.y, 0.0f) / (away * offset)); // Half, because a bend is half a turn.
	}
	return room;
}

PartMotionCode swing_code(const PlantForm &form, const PlacedPart &part, const glm::vec2 &side, float factor) {
	const Part &kind = form.parts[static_cast<size_t>(part.kind)];
	PartMotion swing;
	swing.frequency = factor * kind.frequency;
	swing.damping_ratio = kind.damping_ratio;
	swing.phase = part.rank + GROUP_PHASE * static_cast<float>(part.group);
	swing.side = side;
	swing.room = swing.is_head() ? 1.0f : room_of(form, part);
	return encode_part_motion(swing);
}

void set_motion_state(const PlantForm &form, const PlacedPart &part, const glm::vec2 &side, float factor,
		PartAttachment &attachment) {
	attachment.code = swing_code(form, part, side, factor);
	attachment.swing = decode_part_motion(attachment.code);
}

/// True if a part belongs to a head and no carrier of it swings.
bool is_of_head(const PlantForm &form, const PlacedPart &part) {
	const Layout layout = form.groups[static_cast<size_t>(part.group)].layout;
	return (layout == Layout::whorl || layout == Layout::disc) && part.offset > TIP &&
			part.length < MAX_HEAD_SHARE * form.height;
}

void let_swing(const PlantForm &form, int index, float factor, PartAttachment &attachment) {
	const PlacedPart &part = form.placed[static_cast<size_t>(index)];
	attachment.swings = attachment.has_swing = true;
	attachment.swinger = index;
	attachment.pivot = part.base;
	set_motion_state(form, part, side_of(form, part), factor, attachment);
}

PartAttachment attachment_on(const PlantForm &form, const PlacedPart &part, const PartAttachment &carrier) {
	const PlacedPart &carries = form.placed[static_cast<size_t>(part.carrier)];
	PartAttachment attachment = carrier;
	attachment.is_root = false;
	attachment.swings = false;
	attachment.stem_offset =
			carrier.is_root ? stem_offset_of(form, form.point_of(carries, part.offset)) : carrier.stem_offset;
	attachment.stem_place = carrier.is_root ? attachment.stem_offset : carrier.stem_place;
	attachment.weight = carrier.weight_at(part.offset);
	attachment.inner = carrier.inner_at(part.offset);
	attachment.rank = std::max(part.rank, carrier.rank);
	return attachment;
}

bool is_axis(const PlantForm &form, const PlacedPart &part) {
	return form.parts[static_cast<size_t>(part.kind)].kind == PartKind::axis;
}

void let_swing_on_branch(const PlantForm &form, int index, float factor, PartAttachment &attachment) {
	const PlacedPart &part = form.placed[static_cast<size_t>(index)];
	InnerSwing &own = attachment.inner[static_cast<size_t>(attachment.inner_count++)];
	own.swings = true;
	own.swinger = index;
	own.pivot = part.base;
	own.code = swing_code(form, part, side_of(form, part), factor);
	own.swing = decode_part_motion(own.code);
}

/// True if a part gets a swing on that of its carrier.
bool swings_on_branch(const PlantForm &form, const PlacedPart &part, const PartAttachment &attachment) {
	return attachment.has_swing && !attachment.swing.is_head() && attachment.inner_count < MAX_INNER_SWINGS &&
			frequency_of(form, part) > 0.0f && is_axis(form, form.placed[static_cast<size_t>(part.carrier)]);
}

/// Returns for each placed part the softest part of a head on it, or -1.
std::vector<int> find_heads(const PlantForm &form) {
	std::vector<int> softest(form.placed.size(), -1);
	for (size_t i = 0; i < form.placed.size(); i++) {
		const PlacedPart &part = form.placed[i];
		if (part.carrier == ON_GROUND || !is_of_head(form, part) || !(frequency_of(form, part) > 0.0f)) {
			continue;
		}
		int &found = softest[static_cast<size_t>(part.carrier)];
		if (found < 0 || frequency_of(form, part) < frequency_of(form, form.placed[static_cast<size_t>(found)])) {
			found = static_cast<int>(i);
		}
	}
	return softest;
}

/// All of the head moves with its carrier and turns about the carrier's tip.
void join_head(const PlantForm &form, int softest, PartAttachment &attachment) {
	const PlacedPart &part = form.placed[static_cast<size_t>(softest)];
	attachment.has_swing = true;
	attachment.swinger = softest;
	attachment.weight = 1.0f;
	attachment.pivot = form.point_of(form.placed[static_cast<size_t>(part.carrier)], 1.0f);
	set_motion_state(form, part, glm::vec2(0.0f), 1.0f, attachment);
}

} // namespace

std::array<InnerSwing, MAX_INNER_SWINGS> PartAttachment::inner_at(float offset) const {
	std::array<InnerSwing, MAX_INNER_SWINGS> all = inner;
	for (InnerSwing &one : all) {
		one.weight = one.weight_at(offset);
		one.swings = false;
	}
	return all;
}

PartAttachment PartAttachment::of_body() const {
	PartAttachment attachment = *this;
	if (inner_count > 0 && inner[static_cast<size_t>(inner_count - 1)].swings) {
		attachment.inner[static_cast<size_t>(--attachment.inner_count)] = InnerSwing();
	}
	if (swings) {
		attachment.swings = attachment.has_swing = false;
		attachment.swinger = -1;
		attachment.weight = 0.0f;
	}
	return attachment;
}

bool has_branched_branches(const PlantForm &form) {
	std::vector<bool> is_on_branch(form.placed.size(), false); // Or is one itself.
	for (size_t i = 0; i < form.placed.size(); i++) {
		const PlacedPart &part = form.placed[i];
		const bool is_branch = part.carrier != ON_GROUND && is_axis(form, part) && frequency_of(form, part) > 0.0f;
		const bool is_carried = part.carrier != ON_GROUND && is_on_branch[static_cast<size_t>(part.carrier)];
		if (is_branch && is_carried) {
			return true;
		}
		is_on_branch[i] = is_branch || is_carried;
	}
	return false;
}

float stem_offset_of(const PlantForm &form, const glm::vec3 &point) {
	return std::clamp(point.y / form.height, 0.0f, 1.0f);
}

std::vector<PartAttachment> attach_parts(const PlantForm &form) {
	const std::vector<int> heads = find_heads(form);
	const bool is_branched = has_branched_branches(form);
	const std::vector<float> factors =
			is_branched ? branch_frequency_factors(form) : std::vector<float>(form.parts.size(), 1.0f);
	const PartMotionCode still = encode_part_motion(PartMotion());
	std::vector<PartAttachment> attachments;
	attachments.reserve(form.placed.size());
	for (const PlacedPart &part : form.placed) {
		const bool on_ground = part.carrier == ON_GROUND;
		const float factor = factors[static_cast<size_t>(part.kind)];
		PartAttachment attachment;
		if (on_ground) {
			attachment.is_root = true;
			attachment.code = still;
			attachment.rank = part.rank;
		} else {
			attachment = attachment_on(form, part, attachments[static_cast<size_t>(part.carrier)]);
		}
		// Stems have only the plant's own bend; leaves on the ground also swing.
		const bool is_stem = on_ground && form.parts[static_cast<size_t>(part.kind)].kind != PartKind::blade;
		const int head = on_ground || !is_of_head(form, part) ? -1 : heads[static_cast<size_t>(part.carrier)];
		if (!attachment.has_swing && head >= 0) {
			join_head(form, head, attachment);
		} else if (!attachment.has_swing && !is_stem && frequency_of(form, part) > 0.0f) {
			let_swing(form, static_cast<int>(attachments.size()), factor, attachment);
		} else if (is_branched && !on_ground && swings_on_branch(form, part, attachment)) {
			let_swing_on_branch(form, static_cast<int>(attachments.size()), factor, attachment);
		}
		attachments.push_back(attachment);
	}
	return attachments;
}

} // namespace undergrowth
