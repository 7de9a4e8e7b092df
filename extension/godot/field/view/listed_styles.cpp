#include "field/view/listed_styles.hpp"

#include "field/build/build_input.hpp"

#include <algorithm>
#include <set>

using namespace godot;

namespace undergrowth {

// Returns the index of a style's species in the list, or -1. If a function is listed twice, each style stays with its
// own entry.
static int listed_number(const FieldRenderSetup &setup, int style, const PlacementOptions &options) {
	const int count = int(options.species.size());
	const auto is_it = [&](int number) {
		const Ref<PlantFieldSpecies> entry = options.species[number];
		return entry.is_valid() && entry->get_species() == setup.styles[size_t(style)].function;
	};
	if (style < std::min(count, setup.listed_count) && is_it(style)) {
		return style;
	}
	return int(number_in_list(options, setup.styles[size_t(style)].function));
}

std::vector<SpeciesStyle> others_of(const FieldRenderSetup &setup, const PlantStore &store,
		const PlacementOptions &options, std::vector<int> &numbers) {
	numbers.clear();
	for (int style = 0; style < int(setup.styles.size()); style++) {
		numbers.push_back(listed_number(setup, style, options));
	}
	std::set<int> used;
	for (int number = 0; number < store.chunk_count(); number++) {
		const PlantChunk &chunk = store.chunk(number);
		if (chunk.is_added && chunk.size() > 0) {
			used.insert(chunk.species);
		}
	}
	std::vector<SpeciesStyle> others;
	for (const int style : used) {
		if (numbers[size_t(style)] < 0) {
			numbers[size_t(style)] = int(options.species.size()) + int(others.size());
			others.emplace_back();
			others.back().function = setup.styles[size_t(style)].function;
			others.back().variant_count = setup.styles[size_t(style)].variant_count;
		}
	}
	return others;
}

bool is_listed_so(const FieldRenderSetup &setup, const PlacementOptions &options) {
	FieldRenderSetup wanted;
	if (!list_styles(nullptr, options, {}, wanted).is_empty() || wanted.listed_count != setup.listed_count) {
		return false;
	}
	return std::equal(wanted.styles.begin(), wanted.styles.end(), setup.styles.begin(),
			[](const SpeciesStyle &one, const SpeciesStyle &other) {
				return (one.is_absent && other.is_absent) ||
						(one.function == other.function && one.variant_count == other.variant_count &&
								one.seed == other.seed && one.detail == other.detail);
			});
}

Ref<PlantFieldSpecies> listed_entry(const PlacementOptions &options, const Ref<PlantFunction> &function) {
	const int64_t number = number_in_list(options, function);
	return number < 0 ? Ref<PlantFieldSpecies>() : Ref<PlantFieldSpecies>(options.species[number]);
}

Ref<PlantFunction> listed_species(const PlacementOptions &options, const String &name) {
	for (int64_t i = 0; i < options.species.size(); i++) {
		const Ref<PlantFieldSpecies> entry = options.species[i];
		if (entry.is_valid() && entry->get_layer_name() == name) {
			return entry->get_species();
		}
	}
	return Ref<PlantFunction>();
}

PackedStringArray layers_of(const PlacementOptions &options) {
	PackedStringArray names;
	for (int64_t i = 0; i < options.species.size(); i++) {
		const Ref<PlantFieldSpecies> entry = options.species[i];
		names.push_back(entry.is_valid() ? entry->get_layer_name() : String());
	}
	return names;
}

PackedStringArray forgotten_layers(const PlacementOptions &options) {
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
