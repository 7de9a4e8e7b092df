// Lasting edits of a field's plants by code: mowing, saving and restoring.

#include "field/plant_queries.hpp"

#include "base/auto_name.hpp"
#include "base/convert.hpp"
#include "base/follow_changes.hpp"
#include "base/messages.hpp"
#include "placement/edit_finder.hpp"

#include <godot_cpp/classes/resource_loader.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr float SAME_SHARE = 1e-4f; // Of a plant's full height.

int PlantQueries::set_height_in_sphere(const Vector3 &center, double radius, double height) {
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
	runtime.repeat_in_first_build({ middle - sphere->radius, middle + sphere->radius }, [mow] { mow(); });
	return mow();
}

int PlantQueries::mow_in(const Sphere &sphere, float height) {
	std::vector<PlantRef> places;
	find_in(sphere, places);
	std::vector<PlantRef> mown;
	std::vector<float> shares;
	for (const PlantRef &place : places) {
		const PlacedPlant plant = runtime.store.chunk(place.chunk).plants.plant(place.slot);
		const float whole = runtime.setup.styles[size_t(plant.species)].length_of(plant);
		const float share = std::clamp(height / whole, EditLog::MIN_SHARE, 1.0f);
		if (std::abs(share - runtime.own_edits.share_of(runtime.store, place)) > SAME_SHARE) {
			mown.push_back(place);
			shares.push_back(share);
		}
	}
	runtime.mow(std::move(mown), shares);
	return int(shares.size());
}

// The name that identifies its species in saved edits: that of the map for listed species, else the file's path.
String PlantQueries::name_of_style(int style) const {
	const Ref<PlantFunction> function = runtime.setup.styles[size_t(style)].function;
	const Ref<PlantFieldSpecies> listed = runtime.listed_entry(function);
	if (listed.is_valid()) {
		return listed->get_layer_name();
	}
	const String path = function->get_path();
	return path.begins_with("res://") && !path.contains("::") ? path : name_of_species(function);
}

Ref<PlantFunction> PlantQueries::species_named(const String &name) const {
	const Ref<PlantFunction> listed = runtime.listed_species(name);
	if (listed.is_valid()) {
		return listed;
	}
	for (size_t style = 0; style < runtime.setup.styles.size(); style++) {
		if (name_of_style(int(style)) == name) {
			return runtime.setup.styles[style].function;
		}
	}
	ResourceLoader *loader = ResourceLoader::get_singleton();
	return name.begins_with("res://") && loader->exists(name) ? loader->load(name) : Ref<Resource>();
}

bool PlantQueries::find_species(const SavedEdits &saved, std::vector<Ref<PlantFunction>> &found) const {
	for (const std::string &name : saved.species) {
		found.push_back(species_named(String::utf8(name.c_str())));
		if (found.back().is_null()) {
			report_error(node,
					"apply_changes(): plants of '" + String::utf8(name.c_str()) +
							"' were added, but the field has no species of that name. Add it to the field's species, "
							"or restore its name. Nothing was changed.");
			return false;
		}
	}
	return true;
}

// Sorted by id, so that the same plants give the same bytes.
static std::vector<AddedPlant> added_plants(const PlantStore &store) {
	std::vector<AddedPlant> added;
	for (int number = 0; number < store.chunk_count(); number++) {
		const PlantChunk &chunk = store.chunk(number);
		for (int slot = 0; chunk.is_added && slot < chunk.size(); slot++) {
			if (!chunk.is_gone(slot)) {
				added.push_back({ chunk.ids[size_t(slot)], chunk.plants.plant(slot) });
			}
		}
	}
	std::sort(added.begin(), added.end(), [](const AddedPlant &a, const AddedPlant &b) { return a.id < b.id; });
	return added;
}

PackedByteArray PlantQueries::changes() const {
	SavedEdits saved;
	saved.edits = runtime.own_edits.known();
	saved.seed = runtime.seed();
	saved.added = added_plants(runtime.store);
	std::vector<int> numbers(runtime.setup.styles.size(), -1);
	for (AddedPlant &one : saved.added) {
		int &species = numbers[size_t(one.plant.species)];
		if (species < 0) {
			species = int(saved.species.size());
			saved.species.push_back(name_of_style(one.plant.species).utf8().get_data());
		}
		one.plant.species = species;
	}
	const std::vector<uint8_t> bytes = write_edits(saved);
	PackedByteArray made;
	made.resize(int64_t(bytes.size()));
	std::copy(bytes.begin(), bytes.end(), made.ptrw());
	return made;
}

bool PlantQueries::has_changes() const {
	return !runtime.own_edits.known().is_empty() || !added_plants(runtime.store).empty();
}

// Restores added plants.
void PlantQueries::bring_back(const SavedEdits &saved, const std::vector<Ref<PlantFunction>> &species) {
	std::vector<PlantRef> others;
	for (int number = 0; number < runtime.store.chunk_count(); number++) {
		for (int slot = 0; runtime.store.chunk(number).is_added && slot < runtime.store.chunk(number).size(); slot++) {
			others.push_back({ number, slot });
		}
	}
	runtime.remove(std::move(others));
	std::vector<int> styles;
	for (const Ref<PlantFunction> &function : species) {
		styles.push_back(runtime.species_for(function));
		follow_changes(function.ptr(), Callable(node, "_on_added_species_changed"));
	}
	std::vector<PlacedPlant> plants;
	std::vector<PlantId> ids;
	for (const AddedPlant &one : saved.added) {
		const int style = styles[size_t(one.plant.species)];
		if (style >= 0) { // Else species_for() has reported the error.
			plants.push_back(one.plant);
			plants.back().species = style;
			ids.push_back(one.id);
		}
	}
	runtime.add(std::move(plants), std::move(ids));
}

bool PlantQueries::apply_changes(const PackedByteArray &bytes) {
	SavedEdits saved;
	const BytesFault fault = read_edits(bytes.ptr(), size_t(bytes.size()), saved);
	if (fault != BytesFault::none) {
		report_error(node, String("apply_changes(): ") + describe_edits_fault(fault) + " Nothing was changed.");
		return false;
	}
	std::vector<Ref<PlantFunction>> species;
	if (!find_species(saved, species)) {
		return false;
	}
	if (saved.seed.value_or(runtime.seed()) != runtime.seed() && !saved.edits.of_generated().empty()) {
		report_warning(node,
				"apply_changes(): these edits were recorded with seed " + String::num_int64(*saved.seed) +
						", but the field has seed " + String::num_int64(runtime.seed()) +
						". They are applied by position to other plants. Set the recorded seed, or apply edits of this "
						"field.");
	}
	runtime.forget_repeated_edits();
	bring_back(saved, species);
	const EditLog before = runtime.own_edits.known();
	runtime.own_edits.replace(std::move(saved.edits), runtime.store, runtime.setup, runtime.motion);
	const EditLog &now = runtime.own_edits.known();
	std::vector<PlantRef> gone;
	EditFinder finder(now);
	for (int number = 0; number < runtime.store.chunk_count(); number++) {
		const PlantChunk &chunk = runtime.store.chunk(number);
		for (int slot = 0; !chunk.is_added && !now.of_generated().empty() && slot < chunk.size(); slot++) {
			if (!chunk.is_gone(slot) && finder.is_gone(chunk.plants.x[size_t(slot)], chunk.plants.z[size_t(slot)])) {
				gone.push_back({ number, slot });
			}
		}
	}
	runtime.remove(std::move(gone));
	runtime.grow_again(before.gone_beside(now));
	runtime.show_soon();
	return true;
}

} // namespace undergrowth
