#include "any_plant.hpp"

using namespace undergrowth;

namespace {

constexpr int SPOILT = 4; // One species in so many has numbers that nothing should have.
constexpr int LARGE = 24; // One in so many grows as large as it comes; the others have few parts of each kind.

/// What a species costs goes with how many parts it has, what it can break with how many species are tried.
void make_few(Arrangement &arrangement, Chance &chance) {
	const int max = chance.whole(1, 3);
	if (arrangement.count_min <= MAX_PARTS &&
			arrangement.count_max <= MAX_PARTS) { // Others are refused, and are to be.
		arrangement.count_min = std::min(arrangement.count_min, max);
		arrangement.count_max = std::min(arrangement.count_max, max);
	}
}

int any_stem(Chance &chance, bool is_spoilt, Growth &growth) {
	int stem = ON_GROUND;
	if (chance.one_in(3)) {
		Part part = any_part(chance);
		if (is_spoilt && chance.one_in(4)) {
			spoil(part, chance);
		}
		growth.add_stem(part, stem);
		if (chance.one_in(8)) {
			int other = ON_GROUND;
			growth.add_stem(part, other); // Refused.
		}
	}
	return stem;
}

void grow_recipe(Chance &chance, bool is_spoilt, bool is_large, Growth &growth) {
	Recipe recipe = any_recipe(chance);
	if (!is_large) {
		recipe.lines.resize(std::min(recipe.lines.size(), static_cast<size_t>(chance.whole(1, 3))));
	}
	if (is_spoilt) {
		spoil(recipe.kinds[static_cast<size_t>(chance.whole(0, static_cast<int>(recipe.kinds.size()) - 1))], chance);
		for (RecipeLine &line : recipe.lines) {
			if (chance.one_in(4)) {
				spoil(line.arrangement, chance);
				line.on = chance.whole(-2, static_cast<int>(recipe.lines.size()));
				line.kind = chance.whole(-1, static_cast<int>(recipe.kinds.size()));
			}
		}
	}
	for (RecipeLine &line : recipe.lines) {
		if (!is_large) {
			make_few(line.arrangement, chance);
		}
	}
	grow(recipe, any_stem(chance, is_spoilt, growth), growth);
}

/// Some of what stands, of one group or of many.
std::vector<int> any_carriers(Chance &chance, bool is_spoilt, const Growth &growth) {
	const int max = static_cast<int>(growth.form().placed.size());
	std::vector<int> carriers;
	if (is_spoilt && chance.one_in(10)) {
		return { chance.whole(-3, 2 * max + 2) };
	}
	const int first = chance.whole(ON_GROUND, max - 1);
	for (int i = chance.one_in(3) ? chance.whole(0, 20) : 0; i >= 0; i--) {
		carriers.push_back(chance.one_in(3) ? chance.whole(ON_GROUND, max - 1) : std::min(first + i, max - 1));
	}
	return carriers;
}

/// As a script that loops over its parts: many arrangements of a few parts each.
void grow_by_hand(Chance &chance, bool is_spoilt, bool is_large, Growth &growth) {
	any_stem(chance, is_spoilt, growth);
	const int usual = is_large ? chance.whole(1, chance.one_in(8) ? 30 : 8) : chance.whole(1, 3);
	const int steps = is_large && chance.one_in(20) ? chance.whole(100, 700) : usual;
	const bool is_alike = chance.one_in(2); // One kind for all.
	int kind = -1;
	for (int i = 0; i < steps; i++) {
		if (!is_alike || kind < 0) {
			Part part = any_part(chance);
			if (is_spoilt && chance.one_in(6)) {
				spoil(part, chance);
			}
			growth.add_kind(part, kind);
		}
		Arrangement arrangement = any_arrangement(chance);
		if (steps > 40) {
			arrangement.count_min = arrangement.count_max = 1;
		}
		if (is_spoilt && chance.one_in(6)) {
			spoil(arrangement, chance);
		}
		if (!is_large) {
			make_few(arrangement, chance);
		}
		std::vector<int> handles;
		growth.arrange(kind, arrangement, any_carriers(chance, is_spoilt, growth), handles);
	}
}

} // namespace

bool grow_any_plant(Chance &chance, uint64_t seed, PlantForm &form) {
	Growth growth(chance.spread(1e-2f, 50.0f), seed);
	const bool is_spoilt = chance.one_in(SPOILT);
	const bool is_large = chance.one_in(LARGE);
	if (chance.one_in(4)) {
		grow_by_hand(chance, is_spoilt, is_large, growth);
	} else {
		grow_recipe(chance, is_spoilt, is_large, growth);
	}
	form = growth.finish();
	return !form.placed.empty();
}
