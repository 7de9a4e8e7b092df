#include "card/card_strips.hpp"

#include "mesh/drawn_attachments.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float LONG_FROM = 0.5f; // Offset: cards from here on are heads.
constexpr float MARGIN = 0.02f; // Of the rows of a picture.
constexpr float MAX_LARGER = 1.3f;
constexpr float MAX_WIDER = 1.15f; // Of strips: wider ones cover too much from above.

int rows_of(const CardGroup &group, const CardPlace &place, const CardRows &rows) {
	if (group.shape == CardShape::head || group.shape == CardShape::leaf) {
		return 2;
	}
	return place.from > LONG_FROM ? rows.of_head : rows.of_carrier;
}

/// Largest covered part of a layer between two shares of its height, from the base.
glm::vec2 edge_between(const CardLayer &layer, float low, float high) {
	const int count = static_cast<int>(layer.edges.size());
	const int first = std::clamp(static_cast<int>(low * static_cast<float>(count)), 0, count - 1);
	const int last = std::clamp(static_cast<int>(high * static_cast<float>(count)), 0, count - 1);
	glm::vec2 edge(0.0f);
	for (int i = first; i <= last; i++) {
		const glm::vec2 &own = layer.edges[static_cast<size_t>(i)];
		edge = own.x <= own.y ? glm::vec2(std::min(edge.x, own.x), std::max(edge.y, own.y)) : edge;
	}
	return edge;
}

/// Share of the height of the first and the last covered row.
glm::vec2 covered_rows(const CardLayer &layer) {
	const float count = static_cast<float>(layer.edges.size());
	glm::vec2 covered(1.0f, 0.0f);
	for (size_t i = 0; i < layer.edges.size(); i++) {
		if (layer.edges[i].x <= layer.edges[i].y) {
			covered.x = std::min(covered.x, static_cast<float>(i) / count - MARGIN);
			covered.y = std::max(covered.y, static_cast<float>(i + 1) / count + MARGIN);
		}
	}
	return { std::max(covered.x, 0.0f), std::min(covered.y, 1.0f) };
}

/// Makes the cards of one place.
class StripMaker {
public:
	/// `larger`: factor of the size of heads and leaves, and of the width of strips.
	StripMaker(const CardForm &p_form, const CardSheet &p_sheet, const DrawnAttachments &p_drawn, size_t place,
			float p_larger) :
			form(p_form),
			sheet(p_sheet),
			drawn(p_drawn),
			own(p_form.places[place]),
			grown(p_form.attachments[place]),
			part(p_form.rest.placed[static_cast<size_t>(own.carrier)]),
			layer(sheet.pictures[static_cast<size_t>(layer_of(own.group))]),
			larger(p_larger) {
		across = own.extent.reach / layer.extent.reach;
		lengthwise = (own.extent.high - own.extent.low) / (layer.extent.high - layer.extent.low);
	}

	CardStrip make_strip(int rows) const {
		const CardShape shape = sheet.groups[static_cast<size_t>(own.group)].shape;
		const bool is_flat = shape != CardShape::strip;
		const float wider = shape == CardShape::leaf ? larger : std::min(larger, MAX_WIDER);
		const float longer = shape == CardShape::leaf ? larger : 1.0f;
		CardStrip strip = begin(is_flat ? CardTurn::fixed : CardTurn::turned);
		const glm::vec2 covered = covered_rows(layer);
		for (int i = 0; i < rows; i++) {
			const float step = 1.0f / static_cast<float>(rows - 1);
			const float way = covered.x + (covered.y - covered.x) * step * static_cast<float>(i);
			const float reach = (covered.y - covered.x) * step;
			const glm::vec2 edge = edge_between(layer, way - reach, way + reach);
			const float along = along_of(way) * longer;
			CardStrip::Row row = row_at(along);
			const PartAxes axes = axes_at(along);
			const float half = layer.box.half * across * wider;
			row.left = axes.x * (edge.x * half);
			row.right = axes.x * (edge.y * half);
			row.normal = is_flat ? axes.outward * -1.0f : axes.along;
			row.left_uv = { 0.5f + 0.5f * edge.x, 1.0f - way };
			row.right_uv = { 0.5f + 0.5f * edge.y, 1.0f - way };
			strip.rows.push_back(row);
		}
		return strip;
	}

	/// The pictures of a head from all heights, about its middle.
	CardStrip make_head() const {
		CardStrip strip = begin(CardTurn::head);
		const HeadOutline &head = layer.head;
		const float middle = own.extent.low + (head.middle - layer.extent.low) * lengthwise;
		const PartAxes axes = axes_at(middle);
		for (const glm::vec2 &edge : { head.low, head.high }) {
			CardStrip::Row row = row_at(middle);
			const glm::vec3 rise = axes.along * (edge.x * lengthwise) + axes.outward * (edge.y * across);
			row.left = (rise - axes.x * (head.half * across)) * larger;
			row.right = (rise + axes.x * (head.half * across)) * larger;
			row.normal = axes.along;
			row.along = axes.outward;
			const float v = edge == head.low ? 1.0f : 0.0f;
			row.left_uv = { 0.0f, v };
			row.right_uv = { 1.0f, v };
			strip.rows.push_back(row);
		}
		return strip;
	}

private:
	const CardForm &form;
	const CardSheet &sheet;
	const DrawnAttachments &drawn;
	const CardPlace &own;
	const PartAttachment &grown;
	const PlacedPart &part;
	const CardLayer &layer;
	const float larger;
	float across, lengthwise; ///< Of the place, relative to the picture.

	int layer_of(int group) const { return sheet.layers[static_cast<size_t>(group)]; }
	/// Position along the axis (m) of a share of the picture's height.
	float along_of(float share) const {
		const float along = layer.box.low + (layer.box.high - layer.box.low) * share;
		return own.extent.low + (along - layer.extent.low) * lengthwise;
	}
	float offset_of(float along) const { return own.from + along / part.length; }

	CardStrip begin(CardTurn turn) const {
		CardStrip strip;
		strip.color = layer.color;
		strip.leafiness = layer.leafiness;
		strip.tint = part.tint;
		strip.layer = layer_of(own.group);
		strip.turn = turn;
		return strip;
	}

	PartAxes axes_at(float along) const { return form.rest.axes_of(part, std::clamp(offset_of(along), 0.0f, 1.0f)); }

	CardStrip::Row row_at(float along) const {
		CardStrip::Row row;
		const size_t carrier = static_cast<size_t>(own.carrier);
		const PartAttachment &of_carrier = drawn.attachment_of(carrier);
		const float offset = offset_of(along);
		row.attachment = drawn.attachment_on(carrier, offset, row.middle);
		row.along = axes_at(along).along;
		row.offset = std::clamp(offset, 0.0f, 1.0f);
		if (of_carrier.is_root && own.from <= LONG_FROM) {
			row.attachment = of_carrier; // It bends as the carrier does.
		} else if (grown.has_swing && !grown.swings && !of_carrier.has_swing) { // A head.
			const PartAttachment at = row.attachment;
			row.attachment = grown;
			row.attachment.stem_offset = at.stem_offset;
			row.attachment.stem_place = at.stem_place;
			row.attachment.rank = at.rank;
			row.attachment.pivot += drawn.shift_of(carrier);
		}
		return row;
	}
};

/// By group: factor of the size of cards, which then cover as much as all cards, also those on carriers that are not
/// drawn.
std::vector<float> enlargements(const CardForm &form, const CardSheet &sheet, const FormPlan &plan) {
	std::vector<float> all(sheet.groups.size(), 0.0f);
	std::vector<float> drawn = all;
	for (const CardPlace &place : form.places) {
		const float area = place.extent.half * place.extent.half;
		all[static_cast<size_t>(place.group)] += area;
		if (plan.fates[static_cast<size_t>(place.carrier)] == FormPlan::drawn) {
			drawn[static_cast<size_t>(place.group)] += area;
		}
	}
	for (size_t i = 0; i < all.size(); i++) {
		all[i] = drawn[i] > 0.0f ? std::min(std::sqrt(all[i] / drawn[i]), MAX_LARGER) : 1.0f;
	}
	return all;
}

} // namespace

int count_card(const CardSheet &sheet, const CardPlace &place, const CardRows &rows) {
	const CardGroup &group = sheet.groups[static_cast<size_t>(place.group)];
	return 2 * rows_of(group, place, rows);
}

std::vector<CardStrip> make_strips(
		const CardForm &form, const CardSheet &sheet, const FormPlan &plan, const CardRows &rows) {
	std::vector<CardStrip> strips;
	const DrawnAttachments drawn(form.rest, plan, form.measure.attachments);
	const std::vector<float> larger = enlargements(form, sheet, plan);
	for (size_t i = 0; i < form.places.size(); i++) {
		const CardPlace &place = form.places[i];
		if (plan.fates[static_cast<size_t>(place.carrier)] != FormPlan::drawn) {
			continue;
		}
		const StripMaker maker(form, sheet, drawn, i, larger[static_cast<size_t>(place.group)]);
		const CardGroup &group = sheet.groups[static_cast<size_t>(place.group)];
		const bool is_head = group.shape == CardShape::head;
		strips.push_back(is_head ? maker.make_head() : maker.make_strip(rows_of(group, place, rows)));
	}
	return strips;
}

} // namespace undergrowth
