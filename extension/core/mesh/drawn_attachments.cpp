#include "mesh/drawn_attachments.hpp"

#include "mesh/part_detail.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <optional>

namespace undergrowth {

DrawnPart::DrawnPart(const PlantForm &p_form, const FormPlan &plan, int part, const glm::vec3 &shift) : form(p_form) {
	const PlacedPart &placed = form.placed[static_cast<size_t>(part)];
	const PartDetail &detail = plan.groups[static_cast<size_t>(placed.group)].detail;
	for (const float offset : row_offsets(form.parts[static_cast<size_t>(placed.kind)], detail)) {
		rows.push_back({ offset, form.point_of(placed, offset) + shift });
	}
}

const DrawnPart::Row &DrawnPart::row_below(float offset) const {
	const auto is_below = [](float value, const Row &row) { return value < row.offset; };
	return *(std::upper_bound(rows.begin() + 1, rows.end() - 1, offset, is_below) - 1);
}

glm::vec3 DrawnPart::point_at(float offset) const {
	const Row *low = &row_below(offset);
	const Row *high = low + 1;
	return glm::mix(low->place, high->place, (offset - low->offset) / (high->offset - low->offset));
}

float DrawnPart::stem_offset_at(float offset) const {
	const Row *low = &row_below(offset);
	const Row *high = low + 1;
	const float t = std::clamp((offset - low->offset) / (high->offset - low->offset), 0.0f, 1.0f);
	const glm::vec3 moved = low->place * (stem_offset_of(form, low->place) * (1.0f - t)) +
			high->place * (stem_offset_of(form, high->place) * t);
	const glm::vec3 place = glm::mix(low->place, high->place, t);
	const float square = glm::dot(place, place);
	return square > 0.0f ? std::clamp(glm::dot(moved, place) / square, 0.0f, 1.0f) : 0.0f;
}

DrawnAttachments::DrawnAttachments(
		const PlantForm &p_form, const FormPlan &p_plan, const std::vector<PartAttachment> &grown) :
		form(p_form), plan(p_plan), attachments(grown), shifts(p_form.placed.size(), glm::vec3(0.0f)) {
	std::optional<DrawnPart> drawn; // Parts of one carrier are consecutive.
	int carrier = ON_GROUND;
	for (size_t i = 0; i < form.placed.size(); i++) {
		const PlacedPart &part = form.placed[i];
		if (part.carrier == ON_GROUND || plan.fates[static_cast<size_t>(part.carrier)] != FormPlan::drawn) {
			continue;
		}
		if (!drawn || part.carrier != carrier) {
			carrier = part.carrier;
			drawn.emplace(form, plan, carrier, shifts[static_cast<size_t>(carrier)]);
		}
		attach(i, *drawn);
	}
}

void DrawnAttachments::attach(size_t i, const DrawnPart &drawn) {
	const PlacedPart &part = form.placed[i];
	const size_t carrier = static_cast<size_t>(part.carrier);
	PartAttachment &attachment = attachments[i];
	const PartAttachment at = attachment_at(attachments[carrier], drawn, part.offset);
	const glm::vec3 place = drawn.point_at(part.offset);
	shifts[i] = place - form.point_of(form.placed[carrier], part.offset);
	attachment.stem_offset = at.stem_offset;
	attachment.stem_place = at.stem_place;
	if (attachment.swings) {
		attachment.pivot = part.base + shifts[i];
	} else if (attachment.has_swing && !attachments[carrier].has_swing) { // A head.
		attachment.pivot += shifts[carrier];
	} else if (attachment.has_swing) {
		attachment.pivot = at.pivot;
	}
	for (size_t k = 0; k < static_cast<size_t>(attachment.inner_count); k++) {
		InnerSwing &own = attachment.inner[k];
		own.pivot = own.swings ? part.base + shifts[i] : at.inner[k].pivot;
	}
}

/// For a carrier without a swing of its own.
PartAttachment DrawnAttachments::attachment_at(
		const PartAttachment &carrier, const DrawnPart &drawn, float offset) const {
	PartAttachment attachment = carrier;
	attachment.is_root = false;
	attachment.swings = false;
	attachment.weight = carrier.weight_at(offset);
	attachment.inner = carrier.inner_at(offset);
	if (carrier.is_root) {
		attachment.stem_offset = drawn.stem_offset_at(offset);
		attachment.stem_place = stem_offset_of(form, drawn.point_at(offset));
	}
	return attachment;
}

PartAttachment DrawnAttachments::attachment_on(size_t carrier, float offset, glm::vec3 &place) const {
	const DrawnPart drawn(form, plan, static_cast<int>(carrier), shifts[carrier]);
	place = drawn.point_at(offset);
	return attachment_at(attachments[carrier], drawn, std::min(offset, 1.0f));
}

void DrawnAttachments::place_rings(FormBody &body) const {
	const size_t first = static_cast<size_t>(body.first);
	const PlacedPart &part = form.placed[first];
	const PartAttachment own = attachments[first].of_body();
	const bool is_along = form.groups[static_cast<size_t>(body.group)].layout == Layout::along;
	for (FormBody::Ring &ring : body.rings) {
		ring.middle = body.origin + shifts[first] + body.axes.along * ring.along;
		ring.axes = body.axes;
		ring.attachment = own;
	}
	if (part.carrier == ON_GROUND || !is_along) {
		return;
	}
	const size_t carrier = static_cast<size_t>(part.carrier);
	const PlacedPart &carries = form.placed[carrier];
	const DrawnPart drawn(form, plan, part.carrier, shifts[carrier]);
	for (FormBody::Ring &ring : body.rings) {
		const float offset = std::max(part.offset + ring.along / carries.length, 0.0f);
		const PartAttachment at = attachment_at(attachments[carrier], drawn, std::min(offset, 1.0f));
		ring.middle = drawn.point_at(offset);
		ring.axes = form.axes_of(carries, std::min(offset, 1.0f));
		ring.attachment.stem_offset = at.stem_offset;
		ring.attachment.stem_place = at.stem_place;
		ring.attachment.weight = at.has_swing ? at.weight : own.weight;
		ring.attachment.inner = at.inner;
		ring.attachment.inner_count = at.inner_count;
	}
}

} // namespace undergrowth
