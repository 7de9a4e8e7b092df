#pragma once

#include "card/card_form.hpp"

namespace undergrowth {

/// Rows of the strips of one detail.
struct CardRows {
	int of_carrier; ///< Of cards along most of a carrier.
	int of_head;
};
/// From fine to coarse.
inline constexpr CardRows CARD_ROWS[] = { { 7, 4 }, { 5, 3 }, { 3, 2 }, { 2, 2 } };

/// Returns the vertices of the cards of a place.
int count_card(const CardSheet &sheet, const CardPlace &place, const CardRows &rows);

/// Returns the cards of a plant on carriers as a plan draws them. Carriers that it does not draw have none.
std::vector<CardStrip> make_strips(
		const CardForm &form, const CardSheet &sheet, const FormPlan &plan, const CardRows &rows);

} // namespace undergrowth
