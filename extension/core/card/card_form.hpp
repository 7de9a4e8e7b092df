#pragma once

#include "card/card_sheet.hpp"
#include "mesh/card_strip.hpp"
#include "mesh/form_mesh.hpp"

#include <vector>

namespace undergrowth {

/// A plant of which cards replace small parts: all other parts as a form of their own, and the places of the cards.
struct CardForm {
	PlantForm rest;
	FormMeasure measure; ///< Of `rest`.
	std::vector<CardPlace> places; ///< `carrier` is an index in `rest`.
	std::vector<PartAttachment> attachments; ///< By place: of its first part.
	std::vector<float> shown; ///< By place: area of its parts from the side (m², mean), as of FormMeasure.

	bool is_empty() const { return places.empty(); }
};

/// `measure`: of `form`. `sheet`: of the same species, from any seed. `drawn`: near or far. Empty without a place for a
/// card.
CardForm make_card_form(
		const PlantForm &form, const FormMeasure &measure, const CardSheet &sheet, CardReach drawn = CardReach::near);

/// The drawn parts and cards of a plant at one level.
struct CardPlan {
	FormPlan rest;
	std::vector<CardStrip> strips;
	MeshCounts counts; ///< Of both.

	bool is_empty() const { return strips.empty(); }
};

/// Returns a plan of at most `budget` vertices. Empty if it would draw too few of the cards. `carrier_rows`: see
/// divide_carriers(), which may exceed the budget.
CardPlan plan_cards(const CardForm &form, const CardSheet &sheet, int budget, int carrier_rows = 0);

/// build_form_mesh() of a plan with cards, into buffers of plan.counts.
void build_card_mesh(const CardForm &form, const CardPlan &plan, const FormBones &bones, const MeshOptions &options,
		float height, const FormBuffers &buffers);

} // namespace undergrowth
