#include "field/resources/species_list.hpp"

#include "field/resources/default_species.hpp"

using namespace godot;

namespace undergrowth {

bool SpeciesList::set(const TypedArray<PlantFieldSpecies> &entries) {
	const bool are_others = followed.differ(entries);
	listed = entries.duplicate();
	if (are_others) {
		follow();
	}
	return are_others;
}

void SpeciesList::follow() {
	followed.follow(listed, Callable(node, "_on_species_changed"));
	options.species = listed.duplicate();
}

void SpeciesList::choose_grass() {
	if (listed.is_empty() && options.species.is_empty()) {
		options.species.push_back(PlantFieldSpecies::of(default_species(node)));
	}
}

Ref<PlantFieldSpecies> SpeciesList::find_emitter() const {
	for (int64_t i = 0; i < options.species.size(); i++) {
		const Ref<PlantFieldSpecies> entry = options.species[i];
		if (entry.is_null() || entry->get_change_kind() != PlantFieldSpecies::CHANGE_NONE) {
			return entry;
		}
	}
	return {};
}

} // namespace undergrowth
