#include "card/card_form.hpp"

#include "card/card_strips.hpp"
#include "mesh/form_writer.hpp"

#include <algorithm>

namespace undergrowth {

namespace {

constexpr float MAX_CARD_SHARE = 0.75f; // Of the budget.

/// Copies everything that is not in a card. `into`: index in the copy, by placed part; -1: in a card.
PlantForm copy_rest(const PlantForm &form, const std::vector<int> &owners, std::vector<int> &into) {
	PlantForm rest = form;
	rest.placed.clear();
	rest.groups.clear();
	into.assign(form.placed.size(), -1);
	std::vector<int> groups(form.groups.size(), -1);
	for (size_t g = 0; g < form.groups.size(); g++) {
		PartGroup group = form.groups[g];
		group.first = static_cast<int>(rest.placed.size());
		for (int i = form.groups[g].first; i < form.groups[g].first + form.groups[g].count; i++) {
			const size_t at = static_cast<size_t>(i);
			if (owners[at] < 0) {
				into[at] = static_cast<int>(rest.placed.size());
				PlacedPart part = form.placed[at];
				part.group = static_cast<int>(rest.groups.size());
				part.carrier = part.carrier == ON_GROUND ? ON_GROUND : into[static_cast<size_t>(part.carrier)];
				rest.placed.push_back(part);
			}
		}
		group.count = static_cast<int>(rest.placed.size()) - group.first;
		if (group.count > 0) {
			groups[g] = static_cast<int>(rest.groups.size());
			const int carrier = group.carrier_group;
			group.carrier_group = carrier == ON_GROUND ? ON_GROUND : groups[static_cast<size_t>(carrier)];
			rest.groups.push_back(group);
		}
	}
	rest.stem = form.stem < 0 ? PlantForm::NO_STEM : into[static_cast<size_t>(form.stem)];
	return rest;
}

} // namespace

CardForm make_card_form(const PlantForm &form, const CardSheet &sheet) {
	CardForm made;
	const CardPlaces all = place_cards(form, sheet.groups);
	if (sheet.is_empty() || all.places.empty()) {
		return made;
	}
	const std::vector<PartAttachment> attachments = attach_parts(form);
	std::vector<int> into;
	made.rest = copy_rest(form, all.owners, into);
	made.measure = measure_form(made.rest);
	for (const CardPlace &place : all.places) {
		if (!place.extent.is_empty()) {
			made.places.push_back(place);
			made.places.back().carrier = into[static_cast<size_t>(place.carrier)];
			made.attachments.push_back(attachments[static_cast<size_t>(place.first)]);
		}
	}
	return made;
}

CardPlan plan_cards(const CardForm &form, const CardSheet &sheet, int budget, int carrier_rows) {
	CardPlan plan;
	for (const CardRows &rows : CARD_ROWS) {
		int cards = 0;
		for (const CardPlace &place : form.places) {
			cards += count_card(sheet, place, rows);
		}
		if (static_cast<float>(cards) > MAX_CARD_SHARE * static_cast<float>(budget) || budget - cards < 12) {
			continue;
		}
		plan.rest = plan_form(form.rest, form.measure, budget - cards);
		divide_carriers(form.rest, carrier_rows, plan.rest);
		plan.strips = make_strips(form, sheet, plan.rest, rows);
		plan.counts = plan.rest.counts;
		for (const CardStrip &strip : plan.strips) {
			plan.counts.vertices += strip.vertices();
			plan.counts.indices += strip.indices();
		}
		break;
	}
	return plan;
}

void build_card_mesh(const CardForm &form, const CardPlan &plan, const FormBones &bones, const MeshOptions &options,
		float height, const FormBuffers &buffers) {
	build_form_mesh(form.rest, form.measure, plan.rest, bones, options, height, buffers);
	const int vertex = plan.rest.counts.vertices;
	FormBuffers own = buffers;
	own.positions += vertex;
	own.normals += vertex;
	own.tangents += vertex;
	own.colors += vertex;
	own.uvs += vertex;
	own.custom0 += vertex;
	own.custom1 += vertex;
	own.custom2 += vertex;
	own.bones += 4 * vertex;
	own.weights += 4 * vertex;
	own.stem_places += vertex;
	own.indices += plan.rest.counts.indices;
	FormWriter writer(form.rest, bones, options, own);
	for (const CardStrip &strip : plan.strips) {
		writer.add_strip(strip);
	}
	writer.stretch(height / form.rest.height);
	for (int i = 0; i < plan.counts.indices - plan.rest.counts.indices; i++) {
		own.indices[i] += vertex;
	}
}

} // namespace undergrowth
