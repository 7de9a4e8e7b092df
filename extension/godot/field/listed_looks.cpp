#include "field/listed_looks.hpp"

#include "field/field_recipe.hpp"

#include <algorithm>
#include <set>

using namespace godot;

namespace undergrowth {

// Returns the index of a look's species in the list, or -1. If a function is listed twice, each look stays with its own
// entry.
static int listed_number(const FieldStyle &style, int look, const StandOptions &options) {
	const int count = int(options.species.size());
	const auto is_it = [&](int number) {
		const Ref<PlantFieldSpecies> entry = options.species[number];
		return entry.is_valid() && entry->get_species() == style.looks[size_t(look)].function;
	};
	if (look < std::min(count, style.listed_count) && is_it(look)) {
		return look;
	}
	return int(number_in_list(options, style.looks[size_t(look)].function));
}

std::vector<FieldLook> others_of(
		const FieldStyle &style, const PlantStore &store, const StandOptions &options, std::vector<int> &numbers) {
	numbers.clear();
	for (int look = 0; look < int(style.looks.size()); look++) {
		numbers.push_back(listed_number(style, look, options));
	}
	std::set<int> used;
	for (int number = 0; number < store.block_count(); number++) {
		const PlantBlock &block = store.block(number);
		if (block.is_added && block.size() > 0) {
			used.insert(block.species);
		}
	}
	std::vector<FieldLook> others;
	for (const int look : used) {
		if (numbers[size_t(look)] < 0) {
			numbers[size_t(look)] = int(options.species.size()) + int(others.size());
			others.emplace_back();
			others.back().function = style.looks[size_t(look)].function;
			others.back().variant_count = style.looks[size_t(look)].variant_count;
		}
	}
	return others;
}

bool is_listed_so(const FieldStyle &style, const StandOptions &options) {
	FieldStyle wanted;
	if (!list_looks(nullptr, options, {}, wanted).is_empty() || wanted.listed_count != style.listed_count) {
		return false;
	}
	return std::equal(wanted.looks.begin(), wanted.looks.end(), style.looks.begin(),
			[](const FieldLook &one, const FieldLook &other) {
				return (one.is_absent && other.is_absent) ||
						(one.function == other.function && one.variant_count == other.variant_count &&
								one.seed == other.seed && one.detail == other.detail);
			});
}

Ref<PlantFieldSpecies> listed_entry(const StandOptions &options, const Ref<PlantFunction> &function) {
	const int64_t number = number_in_list(options, function);
	return number < 0 ? Ref<PlantFieldSpecies>() : Ref<PlantFieldSpecies>(options.species[number]);
}

Ref<PlantFunction> listed_species(const StandOptions &options, const String &name) {
	for (int64_t i = 0; i < options.species.size(); i++) {
		const Ref<PlantFieldSpecies> entry = options.species[i];
		if (entry.is_valid() && entry->get_layer_name() == name) {
			return entry->get_species();
		}
	}
	return Ref<PlantFunction>();
}

PackedStringArray layers_of(const StandOptions &options) {
	PackedStringArray names;
	for (int64_t i = 0; i < options.species.size(); i++) {
		const Ref<PlantFieldSpecies> entry = options.species[i];
		names.push_back(entry.is_valid() ? entry->get_layer_name() : String());
	}
	return names;
}

PackedStringArray forgotten_layers(const StandOptions &options) {
	const PackedStringArray painted = options.map.is_valid() ? options.map->get_painted_species() : PackedStringArray();
	const PackedStringArray read = layers_of(options);
	PackedStringArray names;
	for (const String &name : painted) {
		if (!read.has(name)) {
			names.push_back(name);
		}
	}
	return names;
}

} // namespace undergrowth
