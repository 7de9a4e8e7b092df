// What a PlantField3D is asked and told about its plants.

#include "field/plant_field_3d.hpp"

#include "convert.hpp"
#include "follow_changes.hpp"

#include <cmath>

using namespace godot;

namespace undergrowth {

PackedInt64Array PlantField3D::add_plants(const Variant &transforms, const Ref<PlantFunction> &function) {
	std::vector<Transform3D> places;
	if (!read_transforms(transforms, places)) {
		report_error(
				this, "add_plants() needs an Array of Transform3D, or a PackedFloat32Array with 12 numbers for each.");
		return PackedInt64Array();
	}
	if (function.is_null()) {
		report_error(this, "add_plants() needs a PlantFunction: which species?");
		return PackedInt64Array();
	}
	if (double(get_plant_count()) + double(places.size()) > PlacementRequest::MOST_PLANTS) {
		report_error(this, "cannot hold more than 4,000,000 plants; none of these is added. Use another field.");
		return PackedInt64Array();
	}
	const int species_index = meadow.species_for(function);
	if (species_index < 0) {
		return PackedInt64Array();
	}
	if (species_index >= meadow.style.listed) {
		follow_changes(function.ptr(), Callable(this, "_on_added_species_changed"));
	}
	const int variants = int(meadow.style.looks[size_t(species_index)].variants.size());
	std::vector<PlacedPlant> placed;
	for (const Transform3D &place : places) {
		PlacedPlant plant = place_transform(place);
		plant.species = species_index;
		plant.variant = (get_plant_count() + int(placed.size())) % variants;
		if (is_valid(plant)) {
			placed.push_back(plant);
		}
	}
	if (placed.size() < places.size()) {
		report_error(this,
				String::num_int64(int64_t(places.size() - placed.size())) +
						" transforms of add_plants() are not finite or of no size; the others are added.");
	}
	PackedInt64Array ids;
	for (const PlantId id : meadow.add(std::move(placed))) {
		ids.push_back(id);
	}
	return ids;
}

bool PlantField3D::remove_plant(int64_t id) {
	const PlantPlace place = plants.find(id);
	if (place.block >= 0) {
		meadow.remove({ place });
	}
	return place.block >= 0;
}

int PlantField3D::remove_plants(const PackedInt64Array &ids) {
	std::vector<PlantPlace> places;
	for (const int64_t id : ids) {
		const PlantPlace place = meadow.store.find(id);
		if (place.block >= 0) {
			places.push_back(place);
		}
	}
	const int before = get_plant_count();
	meadow.remove(std::move(places));
	return before - get_plant_count();
}

int PlantField3D::remove_in_sphere(const Vector3 &center, double radius) {
	if (!center.is_finite() || !std::isfinite(radius) || radius < 0.0) {
		report_error(this, "remove_in_sphere() needs a finite centre and a radius of 0 or more.");
		return 0;
	}
	if (!is_inside_tree()) {
		return 0;
	}
	std::vector<PlantPlace> places = plants.in_sphere(center, radius);
	const int count = int(places.size());
	if (count > 0) {
		meadow.remove(std::move(places));
	}
	return count;
}

bool PlantField3D::has_plant(int64_t id) const {
	return meadow.store.find(id).block >= 0;
}

PackedInt64Array PlantField3D::find_plants_in_sphere(const Vector3 &center, double radius) const {
	if (!center.is_finite() || !std::isfinite(radius) || radius < 0.0) {
		report_error(this, "find_plants_in_sphere() needs a finite centre and a radius of 0 or more.");
		return PackedInt64Array();
	}
	return is_inside_tree() ? plants.ids_of(plants.in_sphere(center, radius)) : PackedInt64Array();
}

PackedInt64Array PlantField3D::find_plants_in_box(const AABB &box) const {
	if (!box.is_finite()) {
		report_error(this, "find_plants_in_box() needs a finite box.");
		return PackedInt64Array();
	}
	return is_inside_tree() ? plants.ids_of(plants.in_box(box)) : PackedInt64Array();
}

bool PlantField3D::is_point_in_plants(const Vector3 &point) {
	if (!point.is_finite() || !is_inside_tree()) {
		return false;
	}
	return meadow.motion.is_point_in_plants_now(
			to_glm(axes_of(this).affine_inverse().xform(point)), float(properties.motion.touch_margin));
}

int PlantField3D::apply_impulse_in_sphere(const Vector3 &center, double radius, const Vector3 &impulse) {
	if (!center.is_finite() || !impulse.is_finite() || !std::isfinite(radius) || radius < 0.0) {
		report_error(this, "apply_impulse_in_sphere() needs a finite centre, radius and impulse.");
		return 0;
	}
	return is_inside_tree() ? plants.blow(center, radius, impulse) : 0;
}

void PlantField3D::reset_motion() {
	meadow.settle();
}

void PlantField3D::preview(double delta, const Ref<PlantWind> &blowing) {
	static constexpr double MOST_FRAME = 3600.0; // s.
	// Called in every frame, as Plant3D's: what cannot move stays still without a word.
	if (std::isfinite(delta) && delta >= 0.0 && delta <= MOST_FRAME && is_inside_tree() && get_plant_count() > 0 &&
			!may_simulate()) {
		meadow.preview(delta, blowing);
	}
}

Skeleton3D *PlantField3D::get_skeleton(int64_t id) const {
	const PlantPlace place = plants.find(id);
	return place.block < 0 ? nullptr : meadow.skeletons.find(place);
}

int64_t PlantField3D::get_skeleton_plant(const Skeleton3D *skeleton) const {
	const PlantPlace place = meadow.skeletons.find(skeleton);
	return place.block < 0 ? NO_PLANT : meadow.store.id(place);
}

TypedArray<Skeleton3D> PlantField3D::get_skeletons() const {
	TypedArray<Skeleton3D> nodes;
	for (Skeleton3D *skeleton : meadow.skeletons.skeletons()) {
		nodes.push_back(skeleton);
	}
	return nodes;
}

Polygon PlantField3D::outline_polygon() const {
	return read_outline(this, properties.stand);
}

PackedVector3Array PlantField3D::get_outline_points() const {
	PackedVector3Array points;
	for (const glm::vec2 &point : outline_polygon()) {
		points.push_back(Vector3(point.x, 0.0f, point.y));
	}
	return points;
}

} // namespace undergrowth
