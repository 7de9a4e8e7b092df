#include "card/card_form.hpp"

#include "card/card_strips.hpp"
#include "mesh/form_writer.hpp"
#include "mesh/plan_steps.hpp"

#include <algorithm>
#include <iterator>

namespace undergrowth {

namespace {

constexpr float MAX_CARD_SHARE = 0.75f; // Of the budget.
constexpr float MIN_DRAWN_SHARE = 0.6f; // Of the area of all cards. The drawn heads grow by as much.
constexpr float MIN_GROUP_SHARE = 0.6f; // The same of each group that is this share of all cards or more:
constexpr float LARGE_GROUP = 0.2f;

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

/// Gives the rest the swings that its parts have in the whole form, where twigs on cards make branches slower.
void keep_swings(const FormMeasure &measure, const std::vector<int> &into, CardForm &made) {
	const auto in_rest = [&into](int part) { return part < 0 ? part : into[static_cast<size_t>(part)]; };
	for (size_t i = 0; i < into.size(); i++) {
		if (into[i] >= 0) {
			PartAttachment &own = made.measure.attachments[static_cast<size_t>(into[i])];
			own = measure.attachments[i];
			own.swinger = in_rest(own.swinger);
			for (InnerSwing &inner : own.inner) {
				inner.swinger = in_rest(inner.swinger);
			}
		}
	}
}

/// The finest rows with which all cards fit, or the coarsest ones: a plan draws fewer carriers then.
CardRows rows_for(const CardForm &form, const CardSheet &sheet, int budget) {
	for (const CardRows &rows : CARD_ROWS) {
		int cards = 0;
		for (const CardPlace &place : form.places) {
			cards += count_card(sheet, place, rows);
		}
		if (static_cast<float>(cards) <= MAX_CARD_SHARE * static_cast<float>(budget)) {
			return rows;
		}
	}
	return *(std::end(CARD_ROWS) - 1);
}

CarriedCards carried_cards(const CardForm &form, const CardSheet &sheet, const CardRows &rows) {
	CarriedCards cards;
	cards.vertices.assign(form.rest.placed.size(), 0);
	cards.areas.assign(form.rest.groups.size(), 0.0f);
	cards.colors.assign(form.rest.groups.size(), glm::vec4(0.0f));
	for (size_t i = 0; i < form.places.size(); i++) {
		const CardPlace &place = form.places[i];
		const size_t carrier = static_cast<size_t>(place.carrier);
		const size_t group = static_cast<size_t>(form.rest.placed[carrier].group);
		const CardLayer &layer = sheet.pictures[static_cast<size_t>(sheet.layers[static_cast<size_t>(place.group)])];
		cards.vertices[carrier] += count_card(sheet, place, rows);
		cards.areas[group] += form.shown[i];
		cards.colors[group] += layer.color * form.shown[i];
	}
	for (size_t group = 0; group < cards.areas.size(); group++) {
		cards.colors[group] *= cards.areas[group] > 0.0f ? 1.0f / cards.areas[group] : 0.0f;
	}
	return cards;
}

/// True if a plan draws enough of the cards, by area and colour, and of each large group of them.
bool draws_enough(const CardForm &form, const CardSheet &sheet, const FormPlan &plan) {
	const glm::vec3 &light = form.measure.light;
	const glm::vec3 mean(from_light(light.x), from_light(light.y), from_light(light.z));
	struct Sum {
		float drawn = 0.0f, all = 0.0f, worth_drawn = 0.0f, worth = 0.0f;
	};
	Sum whole;
	std::vector<Sum> groups(sheet.groups.size());
	for (size_t i = 0; i < form.places.size(); i++) {
		const size_t group = static_cast<size_t>(form.places[i].group);
		const glm::vec3 color(sheet.pictures[static_cast<size_t>(sheet.layers[group])].color);
		const bool is_drawn = plan.fates[static_cast<size_t>(form.places[i].carrier)] == FormPlan::drawn;
		const float worth = form.shown[i] * worth_of(color, mean);
		for (Sum *sum : { &whole, &groups[group] }) {
			sum->all += form.shown[i];
			sum->worth += worth;
			sum->drawn += is_drawn ? form.shown[i] : 0.0f;
			sum->worth_drawn += is_drawn ? worth : 0.0f;
		}
	}
	const auto is_enough = [&](const Sum &sum) {
		return sum.all < LARGE_GROUP * whole.all || sum.drawn >= MIN_GROUP_SHARE * sum.all;
	};
	return whole.worth > 0.0f && whole.worth_drawn >= MIN_DRAWN_SHARE * whole.worth &&
			std::all_of(groups.begin(), groups.end(), is_enough);
}

} // namespace

CardForm make_card_form(const PlantForm &form, const FormMeasure &measure, const CardSheet &sheet, CardReach drawn) {
	CardForm made;
	const CardPlaces all = place_cards(form, sheet.groups, drawn);
	if (sheet.is_empty() || all.places.empty()) {
		return made;
	}
	std::vector<float> shown(all.places.size(), 0.0f);
	for (size_t i = 0; i < form.placed.size(); i++) {
		const size_t group = static_cast<size_t>(form.placed[i].group);
		if (all.owners[i] >= 0) {
			shown[static_cast<size_t>(all.owners[i])] +=
					measure.shown[group] / static_cast<float>(form.groups[group].count);
		}
	}
	std::vector<int> into;
	made.rest = copy_rest(form, all.owners, into);
	made.measure = measure_form(made.rest);
	if (has_branched_branches(form)) {
		keep_swings(measure, into, made);
	}
	for (size_t i = 0; i < all.places.size(); i++) {
		const CardPlace &place = all.places[i];
		if (!place.extent.is_empty()) {
			made.places.push_back(place);
			made.places.back().carrier = into[static_cast<size_t>(place.carrier)];
			made.attachments.push_back(measure.attachments[static_cast<size_t>(place.first)]);
			made.shown.push_back(shown[i]);
		}
	}
	return made;
}

CardPlan plan_cards(const CardForm &form, const CardSheet &sheet, int budget, int carrier_rows) {
	CardPlan plan;
	const CardRows rows = rows_for(form, sheet, budget);
	plan.rest = plan_form(form.rest, form.measure, budget, carried_cards(form, sheet, rows));
	if (!draws_enough(form, sheet, plan.rest)) {
		return plan;
	}
	divide_carriers(form.rest, carrier_rows, plan.rest);
	plan.strips = make_strips(form, sheet, plan.rest, rows);
	plan.counts = plan.rest.counts;
	for (const CardStrip &strip : plan.strips) {
		plan.counts.vertices += strip.vertices();
		plan.counts.indices += strip.indices();
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
	for (InnerVertex *&inner : own.inner) {
		inner += inner ? vertex : 0;
	}
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
