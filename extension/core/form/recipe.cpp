// Species without code: a list of lines, each an arrangement on the ground, on the stem or on an earlier line's parts.

#include "form/growth.hpp"

namespace undergrowth {

namespace {

std::string find_line_fault(const Recipe &recipe, size_t index, bool has_stem, std::vector<int> &depths,
		std::vector<double> &counts, double &total) {
	const RecipeLine &line = recipe.lines[index];
	if (line.kind < 0 || static_cast<size_t>(line.kind) >= recipe.kinds.size()) {
		return "its part is unknown. Set a part.";
	}
	if (line.on < ON_GROUND || line.on >= static_cast<int>(index)) {
		return "it carries itself. A part can only carry parts that are farther from the ground.";
	}
	const std::string fault = find_arrangement_fault(line.arrangement);
	if (!fault.empty()) {
		return fault;
	}
	const bool on_line = line.on != ON_GROUND;
	const bool on_stem = !on_line && has_stem && line.arrangement.layout != Layout::ground;
	depths[index] = on_line ? depths[static_cast<size_t>(line.on)] + 1 : (on_stem ? 2 : 1);
	counts[index] = line.arrangement.count_max * (on_line ? counts[static_cast<size_t>(line.on)] : 1.0);
	total += counts[index];
	if (depths[index] > MAX_DEPTH) {
		return "parts carry parts in more than " + std::to_string(MAX_DEPTH) + " levels. Remove a level.";
	}
	return total <= MAX_PARTS ? std::string()
							  : "it may have " + std::to_string(static_cast<long long>(total)) +
					" parts. Lower the counts: a plant has at most " + std::to_string(MAX_PARTS) + ".";
}

} // namespace

std::string find_recipe_fault(const Recipe &recipe, bool has_stem) {
	for (const Part &part : recipe.kinds) {
		const std::string fault = find_part_fault(part);
		if (!fault.empty()) {
			return fault;
		}
	}
	std::vector<int> depths(recipe.lines.size());
	std::vector<double> counts(recipe.lines.size());
	double total = has_stem ? 1.0 : 0.0;
	for (size_t i = 0; i < recipe.lines.size(); i++) {
		const std::string fault = find_line_fault(recipe, i, has_stem, depths, counts, total);
		if (!fault.empty()) {
			return fault;
		}
	}
	return {};
}

std::string grow(const Recipe &recipe, int stem, Growth &growth) {
	std::string fault = find_recipe_fault(recipe, stem != ON_GROUND);
	std::vector<int> kinds(recipe.kinds.size());
	for (size_t i = 0; i < kinds.size() && fault.empty(); i++) {
		fault = growth.add_kind(recipe.kinds[i], kinds[i]);
	}
	std::vector<std::vector<int>> handles(recipe.lines.size());
	for (size_t i = 0; i < recipe.lines.size() && fault.empty(); i++) {
		const RecipeLine &line = recipe.lines[i];
		const bool on_ground = line.arrangement.layout == Layout::ground;
		const std::vector<int> carriers = line.on == ON_GROUND ? std::vector<int>{ on_ground ? ON_GROUND : stem }
															   : handles[static_cast<size_t>(line.on)];
		if (carriers.empty()) {
			continue; // This plant has no carrier for them.
		}
		fault = growth.arrange(kinds[static_cast<size_t>(line.kind)], line.arrangement, carriers, handles[i]);
	}
	return fault;
}

} // namespace undergrowth
