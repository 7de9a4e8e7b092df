#include "card/card_groups.hpp"

#include "card/card_axis.hpp"
#include "card/card_picture.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace undergrowth {

namespace {

constexpr float TIP = 0.75f; // Offset from which parts belong to a head.
constexpr int MIN_PARTS = 16; // Of a card.
constexpr int MIN_HEAD_KIND = 5; // Parts of one kind in a head, with all that they carry; fewer are drawn as parts.
constexpr float MIN_FLAT_SPAN = 0.4f; // Of offsets.
constexpr float MAX_DEPTH_SHARE = 0.25f; // Of the extent across, for flat cards.
constexpr float MIN_STRIP = 1.5f; // Length over width.
constexpr float MIN_BALL = 0.5f;
constexpr float MAX_BALL_BASE = 0.35f; // Distance between the bases of its parts, over its length.
constexpr float MAX_CAPPED = 1.2f; // Length over width of heads that have a picture from above.
constexpr float MIN_FILLED = 0.5f; // Covered share of the outline of heads that have a picture from above.
constexpr int SKETCH = 64; // Texels along the sides of the picture for it.
constexpr int MIDRIB_POINTS = 3;

/// Parts of one kind on carriers of one kind.
struct Candidate {
	int carriers = 0;
	int parts = 0; ///< With all that they carry.
	int direct = 0;
	float low = 1.0f; ///< Offsets.
	float high = 0.0f;
	double across = 0.0; ///< Sums of squares.
	double depth = 0.0;
	float size = 0.0f; ///< Sum of lengths times widths.
	int last_carrier = ON_GROUND;
};
using Key = std::pair<int, int>; ///< Kinds of carrier and part.

const PlacedPart &part_at(const PlantForm &form, int index) {
	return form.placed[static_cast<size_t>(index)];
}

std::map<Key, Candidate> list_candidates(const PlantForm &form) {
	std::map<Key, Candidate> all;
	std::map<int, CardAxis> axes;
	for (size_t i = 0; i < form.placed.size(); i++) {
		const PlacedPart *part = &form.placed[i];
		for (bool is_direct = true; part->carrier != ON_GROUND; is_direct = false) {
			const PlacedPart &carrier = part_at(form, part->carrier);
			Candidate &own = all[{ carrier.kind, part->kind }];
			own.parts++;
			own.size += form.placed[i].length * form.placed[i].width;
			if (is_direct) {
				own.direct++;
				own.carriers += own.last_carrier != part->carrier ? 1 : 0;
				own.last_carrier = part->carrier;
				own.low = std::min(own.low, part->offset);
				own.high = std::max(own.high, part->offset);
				const CardAxis &axis = axes.try_emplace(part->carrier, form, part->carrier, 0.0f).first->second;
				const FlatPoint flat = axis.flatten(form.point_of(*part, 1.0f));
				own.across += static_cast<double>(flat.across) * static_cast<double>(flat.across);
				own.depth += static_cast<double>(flat.depth) * static_cast<double>(flat.depth);
			}
			part = &carrier;
		}
	}
	return all;
}

bool is_flat(const Candidate &own) {
	return own.parts >= MIN_PARTS * own.carriers && own.high - own.low >= MIN_FLAT_SPAN &&
			own.depth <= static_cast<double>(MAX_DEPTH_SHARE * MAX_DEPTH_SHARE) * own.across;
}

/// True if a single axis at the tip continues its carrier, like the rachis of an ear.
bool continues(const PlantForm &form, const Key &key, const Candidate &own) {
	return own.direct == own.carriers && own.low > TIP &&
			form.parts[static_cast<size_t>(key.second)].kind == PartKind::axis && own.parts > own.direct;
}

/// Returns the kinds of flat parts on carriers of a kind, or those of the heads at their tips.
std::vector<int> kinds_on(const PlantForm &form, const std::map<Key, Candidate> &all, int carrier, bool is_head) {
	// A short axis at a tip carries nothing but its head.
	const bool is_ear = std::any_of(all.begin(), all.end(),
			[&](const auto &one) { return one.first.second == carrier && continues(form, one.first, one.second); });
	std::vector<int> kinds;
	for (const auto &[key, own] : all) {
		const bool is_of_head = (own.low > TIP || is_ear) && own.parts >= MIN_HEAD_KIND * own.carriers &&
				!continues(form, key, own) && !is_flat(own);
		if (key.first == carrier && (is_head ? is_of_head : is_flat(own))) {
			kinds.push_back(key.second);
		}
	}
	return kinds;
}

/// Divides kinds into groups that are on the same carriers: fresh and faded flowers have their own pictures.
std::vector<CardGroup> split_by_carriers(const PlantForm &form, int carrier_kind, const std::vector<int> &kinds) {
	std::map<int, std::set<int>> by_carrier;
	for (const PlacedPart &part : form.placed) {
		if (part.carrier != ON_GROUND && part_at(form, part.carrier).kind == carrier_kind &&
				std::binary_search(kinds.begin(), kinds.end(), part.kind)) {
			by_carrier[part.carrier].insert(part.kind);
		}
	}
	std::vector<std::set<int>> sets;
	for (auto &[carrier, own] : by_carrier) {
		for (size_t i = 0; i < sets.size();) {
			const bool is_common =
					std::any_of(own.begin(), own.end(), [&](int kind) { return sets[i].count(kind) > 0; });
			if (is_common) {
				own.insert(sets[i].begin(), sets[i].end());
				sets.erase(sets.begin() + static_cast<std::ptrdiff_t>(i));
			} else {
				i++;
			}
		}
		sets.push_back(own);
	}
	std::vector<CardGroup> groups;
	for (const std::set<int> &own : sets) {
		groups.push_back({ carrier_kind, std::vector<int>(own.begin(), own.end()), CardShape::flat, false });
	}
	return groups;
}

/// Covered share of the picture of a head from the side, in its own outline.
float filled_share(const PlantForm &form, const CardPlaces &all, int place) {
	const CardPicture picture = draw_card(form, all, place, false, SKETCH, SKETCH);
	float covered = 0.0f;
	int inside = 0;
	for (int row = 0; row < SKETCH; row++) {
		int first = SKETCH, last = -1;
		for (int column = 0; column < SKETCH; column++) {
			const float coverage = picture.texels[static_cast<size_t>(row * SKETCH + column)].coverage;
			covered += coverage;
			first = coverage > 0.0f ? std::min(first, column) : first;
			last = coverage > 0.0f ? column : last;
		}
		inside += std::max(last - first + 1, 0);
	}
	return covered / static_cast<float>(std::max(inside, 1));
}

/// Sets the shape of a head from its largest place. Returns false if it stays solid: pictures of a broad, open head of
/// twigs from the side and from above differ too much in colour from the head between these directions.
bool shape_head(const PlantForm &form, CardGroup &group) {
	const CardPlaces all = place_cards(form, { group });
	const CardPlace *largest = nullptr;
	for (const CardPlace &place : all.places) {
		largest = !largest || place.count > largest->count ? &place : largest;
	}
	if (!largest) {
		return true;
	}
	const CardExtent &extent = largest->extent;
	const float ratio = (extent.high - extent.low) / (2.0f * std::max(extent.half, 1e-6f));
	const float base = (1.0f - largest->from) * part_at(form, largest->carrier).length;
	const bool is_round = ratio >= MIN_BALL && ratio < MIN_STRIP && base <= MAX_BALL_BASE * (extent.high - extent.low);
	group.shape = is_round ? CardShape::ball : CardShape::strip;
	group.has_cap = !is_round && ratio < MAX_CAPPED;
	return !group.has_cap || filled_share(form, all, static_cast<int>(largest - all.places.data())) >= MIN_FILLED;
}

void measure_extents(const PlantForm &form, CardPlaces &all) {
	std::vector<CardAxis> axes;
	for (CardPlace &place : all.places) {
		axes.emplace_back(form, place.carrier, place.from);
		place.extent = { 1e9f, -1e9f, 0.0f };
	}
	for (size_t i = 0; i < form.placed.size(); i++) {
		const size_t owner = static_cast<size_t>(all.owners[i]);
		for (int k = 0; k < MIDRIB_POINTS && all.owners[i] >= 0; k++) {
			const float offset = static_cast<float>(k) / (MIDRIB_POINTS - 1);
			const FlatPoint flat = axes[owner].flatten(form.point_of(form.placed[i], offset));
			CardExtent &extent = all.places[owner].extent;
			extent.low = std::min(extent.low, flat.along);
			extent.high = std::max(extent.high, flat.along);
			extent.half = std::max(extent.half, std::abs(flat.across));
		}
	}
}

} // namespace

std::vector<CardGroup> find_card_groups(const PlantForm &form) {
	const std::map<Key, Candidate> all = list_candidates(form);
	std::vector<std::pair<float, CardGroup>> found;
	std::vector<bool> is_replaced(form.parts.size(), false); // By kind: everything on it is in a card.
	for (int kind = 0; kind < static_cast<int>(form.parts.size()); kind++) {
		if (is_replaced[static_cast<size_t>(kind)]) {
			continue;
		}
		for (const bool is_head : { false, true }) {
			for (CardGroup &group : split_by_carriers(form, kind, kinds_on(form, all, kind, is_head))) {
				int parts = 0;
				float size = 0.0f;
				for (const int carried : group.carried) {
					const Candidate &own = all.at({ kind, carried });
					parts += own.parts / std::max(own.carriers, 1);
					size += own.size;
				}
				if (parts < MIN_PARTS) {
					continue;
				}
				if (is_head && !shape_head(form, group)) {
					continue;
				}
				for (const int carried : group.carried) {
					is_replaced[static_cast<size_t>(carried)] = true;
				}
				found.emplace_back(size, group);
			}
		}
	}
	std::stable_sort(
			found.begin(), found.end(), [](const auto &one, const auto &other) { return one.first > other.first; });
	std::vector<CardGroup> groups;
	for (size_t i = 0; i < std::min(found.size(), MAX_CARD_GROUPS); i++) {
		groups.push_back(found[i].second);
	}
	return groups;
}

CardPlaces place_cards(const PlantForm &form, const std::vector<CardGroup> &groups) {
	CardPlaces all;
	all.owners.assign(form.placed.size(), -1);
	std::map<Key, int> known; // Carrier and group.
	for (size_t i = 0; i < form.placed.size(); i++) {
		const PlacedPart &part = form.placed[i];
		if (part.carrier == ON_GROUND) {
			continue;
		}
		const int inherited = all.owners[static_cast<size_t>(part.carrier)];
		const int carrier_kind = part_at(form, part.carrier).kind;
		for (size_t g = 0; g < groups.size() && inherited < 0; g++) {
			const std::vector<int> &carried = groups[g].carried;
			if (groups[g].carrier_kind == carrier_kind &&
					std::binary_search(carried.begin(), carried.end(), part.kind)) {
				const Key key = { part.carrier, static_cast<int>(g) };
				const auto [place, is_new] = known.emplace(key, static_cast<int>(all.places.size()));
				if (is_new) {
					all.places.push_back({ key.second, part.carrier, static_cast<int>(i), 0, 1.0f, {} });
				}
				all.owners[i] = place->second;
				float &from = all.places[static_cast<size_t>(place->second)].from;
				from = groups[g].shape == CardShape::flat ? 0.0f : std::min(from, part.offset);
			}
		}
		all.owners[i] = inherited >= 0 ? inherited : all.owners[i];
		if (all.owners[i] >= 0) {
			all.places[static_cast<size_t>(all.owners[i])].count++;
		}
	}
	measure_extents(form, all);
	return all;
}

} // namespace undergrowth
