#pragma once

#include "form/plant_form.hpp"
#include "mesh/card_strip.hpp"

#include <vector>

namespace undergrowth {

enum class CardShape {
	flat, ///< Along the midrib of its carrier, in the plane of the carrier: fronds, feathered leaves.
	leaf, ///< At the tip of its carrier, in the plane of the carrier: palmate leaves.
	strip, ///< Along an axis, turned about it to the camera: ears, spikes, panicles, twigs of a shrub.
	head, ///< Turned to the camera in both directions, with pictures from several heights: flowers, umbels, balls.
};

/// Twigs on twigs are in two groups, of which a form draws one.
enum class CardReach {
	any, ///< All forms draw it.
	near, ///< Forms with the vertices for many small cards.
	far, ///< All others: one card for several of the near ones.
};

/// Parts that one picture replaces: parts of some kinds on carriers of one kind, and everything on these parts. Kinds
/// are indices of PlantForm::parts, which are the same for all seeds of a species.
struct CardGroup {
	int carrier_kind = 0;
	std::vector<int> carried; ///< Kinds of the parts on the carrier, ascending.
	CardShape shape = CardShape::flat;
	CardReach reach = CardReach::any;

	bool is_drawn(CardReach drawn) const { return reach == CardReach::any || reach == drawn; }
	int layers() const { return shape == CardShape::head ? HEAD_VIEW_COUNT : 1; }
};

/// Extent of the parts of a card along its axis and across it (m).
struct CardExtent {
	float low = 0.0f; ///< Along the axis, from its origin.
	float high = 0.0f;
	float half = 0.0f; ///< Largest distance across; of cards that turn, from the axis.
	float reach = 0.0f; ///< The same with the widths of the parts, which is more than 0 for buds on the axis.

	bool is_empty() const { return !(high > low) || !(half > 0.0f); }
};

/// A card group on one carrier.
struct CardPlace {
	int group = 0;
	int carrier = 0; ///< Index of the placed part.
	int first = 0; ///< Its first part.
	int count = 0; ///< Number of its parts.
	float from = 0.0f; ///< Offset of the axis's origin on the carrier.
	CardExtent extent; ///< Of the midribs of its parts.
};

/// The parts of a form that are in cards.
struct CardPlaces {
	std::vector<CardPlace> places;
	std::vector<int> owners; ///< By placed part: its place, or -1.
};

/// Returns the groups of small parts that pictures can replace: many flat parts on a midrib, heads of many parts at the
/// tip of a stem, and many tiny parts around a twig. The largest groups first, then twigs; at most MAX_CARD_GROUPS.
std::vector<CardGroup> find_card_groups(const PlantForm &form);

/// Returns where the parts of the drawn groups are in a form of any seed. `drawn`: near or far.
CardPlaces place_cards(const PlantForm &form, const std::vector<CardGroup> &groups, CardReach drawn = CardReach::near);

inline constexpr size_t MAX_CARD_GROUPS = 4;

} // namespace undergrowth
