#include "card/card_groups.hpp"

#include "card/card_axis.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace undergrowth {

namespace {

constexpr float TIP = 0.75f; // Offset from which parts belong to a head.
constexpr int MIN_PARTS = 16; // Of a flat card.
constexpr int MIN_TWIG_PARTS = 48; // Of a twig, with all that they carry.
constexpr int MIN_TWIGS = 8; // On a plant.
constexpr float MAX_BUD = 0.015f; // m, mean length of the parts on a twig: from 2 m on, larger ones are single shapes.
constexpr int MIN_HEAD_PARTS = 3; // Of a head, and of each kind in it, with all that they carry.
constexpr float MIN_FLAT_SPAN = 0.4f; // Of offsets.
constexpr float MAX_DEPTH_SHARE = 0.25f; // Of the extent across, for flat cards.
constexpr float MIN_STRIP = 1.5f; // Length over width.
constexpr float MIN_BALL = 0.5f;
constexpr float MAX_BALL_BASE = 0.35f; // Distance between the bases of its parts, over its length.
constexpr float MAX_BROAD = 1.2f; // Length over width of heads that are not strips.
constexpr int MIDRIB_POINTS = 3;

/// Parts of one kind on carriers of one kind.
struct Candidate {
	int carriers = 0;
	int parts = 0; ///< With all that they carry.
	/// The same, where each lobe of an open tube counts: a bell is five petals that have grown together.
	int petals = 0;
	int direct = 0;
	float low = 1.0f; ///< Offsets.
	float high = 0.0f;
	double across = 0.0; ///< Sums of squares.
	double depth = 0.0;
	float size = 0.0f; ///< Sum of lengths times widths.
	double length = 0.0; ///< Sum (m) of parts that carry nothing.
	int bare = 0; ///< Number of these.
	int last_carrier = ON_GROUND;
};
using Key = std::pair<int, int>; ///< Kinds of carrier and part.

const PlacedPart &part_at(const PlantForm &form, int index) {
	return form.placed[static_cast<size_t>(index)];
}

int petals_of(const Part &part) {
	return part.kind == PartKind::axis && part.axis.open_tip ? std::max(part.axis.lobes, 1) : 1;
}

std::map<Key, Candidate> list_candidates(const PlantForm &form) {
	std::map<Key, Candidate> all;
	std::map<int, CardAxis> axes;
	std::vector<bool> carries(form.placed.size(), false);
	for (const PlacedPart &part : form.placed) {
		if (part.carrier != ON_GROUND) {
			carries[static_cast<size_t>(part.carrier)] = true;
		}
	}
	for (size_t i = 0; i < form.placed.size(); i++) {
		const PlacedPart *part = &form.placed[i];
		for (bool is_direct = true; part->carrier != ON_GROUND; is_direct = false) {
			const PlacedPart &carrier = part_at(form, part->carrier);
			Candidate &own = all[{ carrier.kind, part->kind }];
			own.parts++;
			own.petals += petals_of(form.parts[static_cast<size_t>(form.placed[i].kind)]);
			own.size += form.placed[i].length * form.placed[i].width;
			own.length += carries[i] ? 0.0 : static_cast<double>(form.placed[i].length);
			own.bare += carries[i] ? 0 : 1;
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

bool is_in_plane(const Candidate &own) {
	return own.depth <= static_cast<double>(MAX_DEPTH_SHARE * MAX_DEPTH_SHARE) * own.across;
}

bool is_flat(const Candidate &own) {
	return own.parts >= MIN_PARTS * own.carriers && own.high - own.low >= MIN_FLAT_SPAN && is_in_plane(own);
}

/// True if a single axis at the tip continues its carrier, like the rachis of an ear. A bell with lobes does not.
bool continues(const PlantForm &form, const Key &key, const Candidate &own) {
	const Part &part = form.parts[static_cast<size_t>(key.second)];
	return own.direct == own.carriers && own.low > TIP && part.kind == PartKind::axis && !part.axis.open_tip &&
			own.parts > own.direct;
}

/// Returns the kinds of flat parts on carriers of a kind, or those of the heads at their tips.
std::vector<int> kinds_on(const PlantForm &form, const std::map<Key, Candidate> &all, int carrier, bool is_head) {
	// A short axis at a tip carries nothing but its head.
	const bool is_ear = std::any_of(all.begin(), all.end(),
			[&](const auto &one) { return one.first.second == carrier && continues(form, one.first, one.second); });
	std::vector<int> kinds;
	for (const auto &[key, own] : all) {
		const bool is_of_head = (own.low > TIP || is_ear) && own.petals >= MIN_HEAD_PARTS * own.carriers &&
				!continues(form, key, own) && !is_flat(own);
		if (key.first == carrier && (is_head ? is_of_head : is_flat(own))) {
			kinds.push_back(key.second);
		}
	}
	return kinds;
}

using Kinds = std::set<int>;

/// By placed part: the kinds of the parts on it.
std::vector<Kinds> carried_kinds(const PlantForm &form) {
	std::vector<Kinds> carried(form.placed.size());
	for (const PlacedPart &part : form.placed) {
		if (part.carrier != ON_GROUND) {
			carried[static_cast<size_t>(part.carrier)].insert(part.kind);
		}
	}
	return carried;
}

size_t count_common(const Kinds &one, const std::vector<int> &other) {
	return static_cast<size_t>(
			std::count_if(other.begin(), other.end(), [&](int kind) { return one.count(kind) > 0; }));
}

/// True if both are from heads of one sort, of which some have no parts of a kind. Fresh and faded flowers only have
/// some kinds in common, like their bracts.
bool are_alike(const Kinds &one, const Kinds &other) {
	const size_t common = count_common(one, std::vector<int>(other.begin(), other.end()));
	const size_t all = one.size() + other.size() - common;
	return common > 0 && (common == std::min(one.size(), other.size()) || 2 * common >= all);
}

/// Divides kinds into groups that are on the same carriers: fresh and faded flowers have their own pictures.
std::vector<CardGroup> split_by_carriers(const PlantForm &form, int carrier_kind, const std::vector<int> &kinds) {
	std::vector<Kinds> sets;
	const std::vector<Kinds> carried = carried_kinds(form);
	for (size_t carrier = 0; carrier < carried.size(); carrier++) {
		Kinds own;
		std::set_intersection(carried[carrier].begin(), carried[carrier].end(), kinds.begin(), kinds.end(),
				std::inserter(own, own.end()));
		if (form.placed[carrier].kind != carrier_kind || own.empty()) {
			continue;
		}
		for (size_t i = 0; i < sets.size();) {
			if (are_alike(own, sets[i])) {
				own.insert(sets[i].begin(), sets[i].end());
				sets.erase(sets.begin() + static_cast<std::ptrdiff_t>(i));
			} else {
				i++;
			}
		}
		sets.push_back(own);
	}
	std::vector<CardGroup> groups;
	for (const Kinds &own : sets) {
		groups.push_back({ carrier_kind, std::vector<int>(own.begin(), own.end()), CardShape::flat });
	}
	return groups;
}

/// Returns the group of a part on a carrier with parts of these kinds: the one that has most of them in common, or -1.
int group_of(const std::vector<CardGroup> &groups, CardReach drawn, int carrier_kind, int kind, const Kinds &carried) {
	int best = -1;
	size_t most = 0;
	for (size_t g = 0; g < groups.size(); g++) {
		const std::vector<int> &own = groups[g].carried;
		const size_t common = count_common(carried, own);
		if (groups[g].is_drawn(drawn) && groups[g].carrier_kind == carrier_kind &&
				std::binary_search(own.begin(), own.end(), kind) && common > most && 2 * common >= own.size()) {
			best = static_cast<int>(g);
			most = common;
		}
	}
	return best;
}

/// Returns the shape of a head, from its largest place.
CardShape shape_of_head(const PlantForm &form, CardGroup group) {
	group.shape = CardShape::leaf; // Its axis begins at its lowest part, and its extent is that of one side.
	const CardPlaces all = place_cards(form, { group });
	const CardPlace *largest = nullptr;
	for (const CardPlace &place : all.places) {
		largest = !largest || place.count > largest->count ? &place : largest;
	}
	if (!largest) {
		return CardShape::strip;
	}
	const CardExtent &extent = largest->extent;
	const float ratio = (extent.high - extent.low) / (2.0f * std::max(extent.half, 1e-6f));
	const float base = (1.0f - largest->from) * part_at(form, largest->carrier).length;
	const bool is_round = ratio >= MIN_BALL && ratio < MIN_STRIP && base <= MAX_BALL_BASE * (extent.high - extent.low);
	return is_round || ratio < MAX_BROAD ? CardShape::head : CardShape::strip;
}

void measure_extents(const PlantForm &form, const std::vector<CardGroup> &groups, CardPlaces &all) {
	std::vector<CardAxis> axes;
	for (CardPlace &place : all.places) {
		axes.emplace_back(form, place.carrier, place.from);
		place.extent = { 1e9f, -1e9f };
	}
	for (size_t i = 0; i < form.placed.size(); i++) {
		const size_t owner = static_cast<size_t>(all.owners[i]);
		for (int k = 0; k < MIDRIB_POINTS && all.owners[i] >= 0; k++) {
			const float offset = static_cast<float>(k) / (MIDRIB_POINTS - 1);
			const FlatPoint flat = axes[owner].flatten(form.point_of(form.placed[i], offset));
			CardExtent &extent = all.places[owner].extent;
			const CardShape shape = groups[static_cast<size_t>(all.places[owner].group)].shape;
			const bool is_turned = shape == CardShape::head || shape == CardShape::strip;
			const float away = is_turned ? flat.depth : 0.0f;
			extent.low = std::min(extent.low, flat.along);
			extent.high = std::max(extent.high, flat.along);
			const float distance = std::sqrt(flat.across * flat.across + away * away);
			const Part &part = form.parts[static_cast<size_t>(form.placed[i].kind)];
			const float width = form.placed[i].width * part.width_at(offset);
			extent.half = std::max(extent.half, distance);
			extent.reach = std::max(extent.reach, distance + 0.5f * width);
		}
	}
}

/// Returns the kinds directly on a twig with many tiny parts around it, as of heather. Empty if it is no such twig.
std::vector<int> kinds_on_twig(const std::map<Key, Candidate> &all, int carrier) {
	std::vector<int> kinds;
	Candidate whole;
	for (const auto &[key, own] : all) {
		if (key.first != carrier) {
			continue;
		}
		whole.parts += own.parts;
		whole.length += own.length;
		whole.bare += own.bare;
		if (own.direct > 0) {
			kinds.push_back(key.second);
			whole.carriers = std::max(whole.carriers, own.carriers);
			whole.low = std::min(whole.low, own.low);
			whole.high = std::max(whole.high, own.high);
			whole.across += own.across;
			whole.depth += own.depth;
		}
	}
	const bool is_twig = whole.carriers >= MIN_TWIGS && whole.parts >= MIN_TWIG_PARTS * whole.carriers &&
			whole.high - whole.low >= MIN_FLAT_SPAN && !is_in_plane(whole) &&
			whole.length <= static_cast<double>(MAX_BUD) * whole.bare;
	return is_twig ? kinds : std::vector<int>();
}

/// Adds the twigs that carry no others, and those that no others carry.
void add_twigs(const PlantForm &form, const std::map<Key, Candidate> &all, std::vector<CardGroup> &groups) {
	const auto carries = [&all](int kind, const CardGroup &group) {
		return all.count({ kind, group.carrier_kind }) > 0;
	};
	std::vector<CardGroup> twigs;
	for (int kind = 0; kind < static_cast<int>(form.parts.size()); kind++) {
		const std::vector<int> kinds = kinds_on_twig(all, kind);
		const bool has_others = std::any_of(groups.begin(), groups.end(),
				[&](const CardGroup &group) { return group.carrier_kind == kind || carries(kind, group); });
		if (!kinds.empty() && !has_others) {
			twigs.push_back({ kind, kinds, CardShape::strip });
		}
	}
	for (CardGroup twig : twigs) {
		const bool is_near = std::none_of(
				twigs.begin(), twigs.end(), [&](const CardGroup &other) { return carries(twig.carrier_kind, other); });
		const bool is_far = std::none_of(
				twigs.begin(), twigs.end(), [&](const CardGroup &other) { return carries(other.carrier_kind, twig); });
		twig.reach = is_near && is_far ? CardReach::any : is_near ? CardReach::near : CardReach::far;
		if ((is_near || is_far) && groups.size() < MAX_CARD_GROUPS) {
			groups.push_back(twig);
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
				int petals = 0;
				float size = 0.0f;
				for (const int carried : group.carried) {
					const Candidate &own = all.at({ kind, carried });
					parts += own.parts / std::max(own.carriers, 1);
					petals += own.petals / std::max(own.carriers, 1);
					size += own.size;
				}
				if (is_head ? petals < MIN_HEAD_PARTS : parts < MIN_PARTS) {
					continue;
				}
				const bool is_leaf = std::all_of(group.carried.begin(), group.carried.end(),
						[&](int carried) { return is_in_plane(all.at({ kind, carried })); });
				group.shape = !is_head ? CardShape::flat : is_leaf ? CardShape::leaf : shape_of_head(form, group);
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
	add_twigs(form, all, groups);
	return groups;
}

CardPlaces place_cards(const PlantForm &form, const std::vector<CardGroup> &groups, CardReach drawn) {
	CardPlaces all;
	all.owners.assign(form.placed.size(), -1);
	std::map<Key, int> known; // Carrier and group.
	const std::vector<Kinds> carried = carried_kinds(form);
	for (size_t i = 0; i < form.placed.size(); i++) {
		const PlacedPart &part = form.placed[i];
		if (part.carrier == ON_GROUND) {
			continue;
		}
		const int inherited = all.owners[static_cast<size_t>(part.carrier)];
		const int group = inherited >= 0 ? -1
										 : group_of(groups, drawn, part_at(form, part.carrier).kind, part.kind,
												   carried[static_cast<size_t>(part.carrier)]);
		if (group >= 0) {
			const Key key = { part.carrier, group };
			const auto [place, is_new] = known.emplace(key, static_cast<int>(all.places.size()));
			if (is_new) {
				all.places.push_back({ group, part.carrier, static_cast<int>(i), 0, 1.0f, {} });
			}
			all.owners[i] = place->second;
			float &from = all.places[static_cast<size_t>(place->second)].from;
			from = groups[static_cast<size_t>(group)].shape == CardShape::flat ? 0.0f : std::min(from, part.offset);
		}
		all.owners[i] = inherited >= 0 ? inherited : all.owners[i];
		if (all.owners[i] >= 0) {
			all.places[static_cast<size_t>(all.owners[i])].count++;
		}
	}
	measure_extents(form, groups, all);
	return all;
}

} // namespace undergrowth
