// Lasting edits of a field's plants by code: mowing, saving and restoring.

#include "field/named_plants.hpp"

#include "convert.hpp"
#include "follow_changes.hpp"
#include "given_name.hpp"
#include "messages.hpp"
#include "stand/changes_finder.hpp"

#include <godot_cpp/classes/resource_loader.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr float SAME_SHARE = 1e-4f; // Of a plant's full height.

int NamedPlants::set_height_in_sphere(const Vector3 &center, double radius, double height) {
	if (!std::isfinite(height) || height < 0.0) {
		report_error(node, "set_height_in_sphere() needs a height of 0 m or more.");
		return 0;
	}
	const std::optional<Sphere> sphere = sphere_of("set_height_in_sphere", center, radius);
	if (!sphere) {
		return 0;
	}
	const float own_height = float(height) / axes_of(node).basis.get_column(1).length();
	const auto mow = [this, one = *sphere, own_height] { return mow_in(one, own_height); };
	const glm::vec2 middle = { sphere->center.x, sphere->center.z };
	meadow.repeat_in_first_build({ middle - sphere->radius, middle + sphere->radius }, [mow] { mow(); });
	return mow();
}

int NamedPlants::mow_in(const Sphere &sphere, float height) {
	std::vector<PlantPlace> places;
	find_in(sphere, places);
	std::vector<PlantPlace> mown;
	std::vector<float> shares;
	for (const PlantPlace &place : places) {
		const PlacedPlant plant = meadow.store.block(place.block).plants.plant(place.slot);
		const float whole = meadow.style.looks[size_t(plant.species)].length_of(plant);
		const float share = std::clamp(height / whole, StandChanges::LEAST_SHARE, 1.0f);
		if (std::abs(share - meadow.own_changes.share_of(meadow.store, place)) > SAME_SHARE) {
			mown.push_back(place);
			shares.push_back(share);
		}
	}
	meadow.mow(std::move(mown), shares);
	return int(shares.size());
}

// The name that identifies its species in saved edits: that of the map for listed species, else the file's path.
String NamedPlants::name_of_look(int look) const {
	const Ref<PlantFunction> function = meadow.style.looks[size_t(look)].function;
	const Ref<PlantFieldSpecies> listed = meadow.listed_entry(function);
	if (listed.is_valid()) {
		return listed->get_layer_name();
	}
	const String path = function->get_path();
	return path.begins_with("res://") && !path.contains("::") ? path : name_of_species(function);
}

Ref<PlantFunction> NamedPlants::species_named(const String &name) const {
	const Ref<PlantFunction> listed = meadow.listed_species(name);
	if (listed.is_valid()) {
		return listed;
	}
	for (size_t look = 0; look < meadow.style.looks.size(); look++) {
		if (name_of_look(int(look)) == name) {
			return meadow.style.looks[look].function;
		}
	}
	ResourceLoader *loader = ResourceLoader::get_singleton();
	return name.begins_with("res://") && loader->exists(name) ? loader->load(name) : Ref<Resource>();
}

bool NamedPlants::find_species(const SavedChanges &saved, std::vector<Ref<PlantFunction>> &found) const {
	for (const std::string &name : saved.species) {
		found.push_back(species_named(String::utf8(name.c_str())));
		if (found.back().is_null()) {
			report_error(node,
					"apply_changes(): plants of '" + String::utf8(name.c_str()) +
							"' were added, and the field knows no such species. Add it to its species, or give it its "
							"name again. Nothing is changed.");
			return false;
		}
	}
	return true;
}

// Sorted by id, so that the same plants give the same bytes.
static std::vector<AddedPlant> added_plants(const PlantStore &store) {
	std::vector<AddedPlant> added;
	for (int number = 0; number < store.block_count(); number++) {
		const PlantBlock &block = store.block(number);
		for (int slot = 0; block.is_added && slot < block.size(); slot++) {
			if (!block.is_gone(slot)) {
				added.push_back({ block.ids[size_t(slot)], block.plants.plant(slot) });
			}
		}
	}
	std::sort(added.begin(), added.end(), [](const AddedPlant &a, const AddedPlant &b) { return a.id < b.id; });
	return added;
}

PackedByteArray NamedPlants::changes() const {
	SavedChanges saved;
	saved.changes = meadow.own_changes.known();
	saved.seed = meadow.seed();
	saved.added = added_plants(meadow.store);
	std::vector<int> numbers(meadow.style.looks.size(), -1);
	for (AddedPlant &one : saved.added) {
		int &species = numbers[size_t(one.plant.species)];
		if (species < 0) {
			species = int(saved.species.size());
			saved.species.push_back(name_of_look(one.plant.species).utf8().get_data());
		}
		one.plant.species = species;
	}
	const std::vector<uint8_t> bytes = write_changes(saved);
	PackedByteArray made;
	made.resize(int64_t(bytes.size()));
	std::copy(bytes.begin(), bytes.end(), made.ptrw());
	return made;
}

bool NamedPlants::has_changes() const {
	return !meadow.own_changes.known().is_empty() || !added_plants(meadow.store).empty();
}

// Restores added plants.
void NamedPlants::bring_back(const SavedChanges &saved, const std::vector<Ref<PlantFunction>> &species) {
	std::vector<PlantPlace> others;
	for (int number = 0; number < meadow.store.block_count(); number++) {
		for (int slot = 0; meadow.store.block(number).is_added && slot < meadow.store.block(number).size(); slot++) {
			others.push_back({ number, slot });
		}
	}
	meadow.remove(std::move(others));
	std::vector<int> looks;
	for (const Ref<PlantFunction> &function : species) {
		looks.push_back(meadow.species_for(function));
		follow_changes(function.ptr(), Callable(node, "_on_added_species_changed"));
	}
	std::vector<PlacedPlant> plants;
	std::vector<PlantId> ids;
	for (const AddedPlant &one : saved.added) {
		const int look = looks[size_t(one.plant.species)];
		if (look >= 0) { // Else species_for() has reported the error.
			plants.push_back(one.plant);
			plants.back().species = look;
			ids.push_back(one.id);
		}
	}
	meadow.add(std::move(plants), std::move(ids));
}

bool NamedPlants::apply_changes(const PackedByteArray &bytes) {
	SavedChanges saved;
	const BytesFault fault = read_changes(bytes.ptr(), size_t(bytes.size()), saved);
	if (fault != BytesFault::none) {
		report_error(node, String("apply_changes(): ") + describe_changes_fault(fault) + " Nothing is changed.");
		return false;
	}
	std::vector<Ref<PlantFunction>> species;
	if (!find_species(saved, species)) {
		return false;
	}
	if (saved.seed.value_or(meadow.seed()) != meadow.seed() && !saved.changes.of_filled().empty()) {
		report_warning(node,
				"apply_changes(): these are changes of a field of seed " + String::num_int64(*saved.seed) +
						", and this one has " + String::num_int64(meadow.seed()) +
						": other plants stand here, and whoever stands where one was removed or mown is so, too. Apply "
						"what get_changes() of this field gave, or set the seed.");
	}
	meadow.forget_repeated_edits();
	bring_back(saved, species);
	const StandChanges before = meadow.own_changes.known();
	meadow.own_changes.replace(std::move(saved.changes), meadow.store, meadow.style, meadow.motion);
	const StandChanges &now = meadow.own_changes.known();
	std::vector<PlantPlace> gone;
	ChangesFinder finder(now);
	for (int number = 0; number < meadow.store.block_count(); number++) {
		const PlantBlock &block = meadow.store.block(number);
		for (int slot = 0; !block.is_added && !now.of_filled().empty() && slot < block.size(); slot++) {
			if (!block.is_gone(slot) && finder.is_gone(block.plants.x[size_t(slot)], block.plants.z[size_t(slot)])) {
				gone.push_back({ number, slot });
			}
		}
	}
	meadow.remove(std::move(gone));
	meadow.grow_again(before.gone_beside(now));
	meadow.show_soon();
	return true;
}

} // namespace undergrowth
