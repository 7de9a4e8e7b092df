// The part of PlantField3D that takes in plants which code adds.

#include "field/plant_field_3d.hpp"

#include "convert.hpp"

#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr float LEAST_TILT = 1e-3f;
static constexpr int FLOATS_PER_TRANSFORM = 12;

// What a transform says about a plant: its place, scale and turn; a tilt becomes a lean to that side.
PlacedPlant PlantField3D::place_transform(const Transform3D &transform, int species_index) const {
	PlacedPlant plant;
	plant.root = to_glm(transform.origin);
	const Vector3 up = transform.basis.get_column(1);
	plant.scale = up.length();
	const float aside = std::sqrt(up.x * up.x + up.z * up.z);
	Vector3 front = transform.basis.get_column(2);
	if (aside > LEAST_TILT * plant.scale) {
		plant.lean = std::atan2(aside, up.y);
		const Vector3 across(up.z / aside, 0.0f, -up.x / aside);
		front = Basis(across, -plant.lean).xform(front);
	}
	plant.turn = std::atan2(front.x, front.z);
	plant.side = plant.lean > 0.0f ? std::atan2(-up.z, up.x) - plant.turn : 0.0f;
	plant.species = species_index;
	return plant;
}

// Index of the look for a function; a new one where none has it yet, -1 where it cannot be built.
int PlantField3D::species_for(const Ref<PlantFunction> &function) {
	for (size_t i = 0; i < style.looks.size(); i++) {
		if (style.looks[i].function == function) {
			return int(i);
		}
	}
	if (style.levels.empty()) {
		start_style(style);
	}
	FieldLook look;
	look.function = function;
	const String fault = look.sample(style.levels, options.variants, options.seed + int64_t(style.looks.size()));
	if (!fault.is_empty()) {
		report_error(this, "cannot add plants of " + undergrowth::describe(function.ptr()) + ": " + fault);
		return -1;
	}
	look.build();
	if (!simulation) {
		FieldSettings settings;
		settings.step = float(clock.step());
		settings.update_interval = options.update_interval;
		settings.prototypes = options.prototypes;
		settings.seed = uint64_t(options.seed);
		simulation = std::make_unique<FieldSimulation>(settings);
	}
	simulation->add_species(look.motion);
	style.looks.push_back(std::move(look));
	return int(style.looks.size()) - 1;
}

static bool read_transforms(const Variant &from, std::vector<Transform3D> &to) {
	if (from.get_type() == Variant::PACKED_FLOAT32_ARRAY) {
		const PackedFloat32Array rows = from;
		const float *f = rows.ptr();
		for (int64_t i = 0; i + FLOATS_PER_TRANSFORM <= rows.size();
				i += FLOATS_PER_TRANSFORM, f += FLOATS_PER_TRANSFORM) {
			to.push_back(
					Transform3D(Basis(Vector3(f[0], f[4], f[8]), Vector3(f[1], f[5], f[9]), Vector3(f[2], f[6], f[10])),
							Vector3(f[3], f[7], f[11])));
		}
		return rows.size() % FLOATS_PER_TRANSFORM == 0;
	}
	if (from.get_type() != Variant::ARRAY) {
		return false;
	}
	const Array list = from;
	for (int64_t i = 0; i < list.size(); i++) {
		if (list[i].get_type() != Variant::TRANSFORM3D) {
			return false;
		}
		to.push_back(list[i]);
	}
	return true;
}

void PlantField3D::add_plants(const Variant &transforms, const Ref<PlantFunction> &function) {
	std::vector<Transform3D> places;
	if (!read_transforms(transforms, places)) {
		report_error(
				this, "add_plants() needs an Array of Transform3D, or a PackedFloat32Array with 12 numbers for each.");
		return;
	}
	if (function.is_null()) {
		report_error(this, "add_plants() needs a PlantFunction: which species?");
		return;
	}
	finish_step();
	const int species_index = species_for(function);
	if (species_index < 0) {
		return;
	}
	if (double(get_plant_count()) + double(places.size()) > PlacementRequest::MOST_PLANTS) {
		report_error(this, "cannot hold more than 4,000,000 plants; none of these is added. Use another field.");
		return;
	}
	std::vector<PlacedPlant> placed;
	for (const Transform3D &place : places) {
		PlacedPlant plant = place_transform(place, species_index);
		plant.variant = (count_pending() + int(placed.size())) % options.variants;
		if (is_valid(plant)) {
			placed.push_back(plant);
		}
	}
	if (placed.size() < places.size()) {
		report_error(this,
				String::num_int64(int64_t(places.size() - placed.size())) +
						" transforms of add_plants() are not finite or of no size; the others are added.");
	}
	add_pending(function, std::move(placed));
	update_processing();
}

void PlantField3D::add_pending(const Ref<PlantFunction> &function, std::vector<PlacedPlant> &&plants) {
	if (plants.empty()) {
		return;
	}
	if (pending.empty() || pending.back().function != function) {
		pending.push_back({ function, std::move(plants) });
	} else {
		pending.back().plants.insert(pending.back().plants.end(), plants.begin(), plants.end());
	}
}

int PlantField3D::count_pending() const {
	int count = 0;
	for (const Pending &group : pending) {
		count += int(group.plants.size());
	}
	return count;
}

// What was added by code outlives a new fill.
void PlantField3D::keep_added() {
	for (size_t i = size_t(filled_patches); i < patches.size(); i++) {
		const FieldPatch &patch = *patches[i];
		std::vector<std::vector<PlacedPlant>> by_species(style.looks.size());
		for (int plant = 0; plant < patch.plants.size(); plant++) {
			if (patch.places[size_t(plant)] != FieldPatch::GONE) {
				by_species[patch.plants.species[size_t(plant)]].push_back(patch.plants.plant(plant));
			}
		}
		for (size_t look = 0; look < by_species.size(); look++) {
			add_pending(style.looks[look].function, std::move(by_species[look]));
		}
	}
}

} // namespace undergrowth
