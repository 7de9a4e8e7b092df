#include "field/plant_access.hpp"

#include "convert.hpp"
#include "field/plant_transforms.hpp"
#include "follow_changes.hpp"
#include "messages.hpp"

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr int FLOATS_PER_STATE = 6; // Direction and rate.

PlantPlace PlantAccess::find(int64_t id) const {
	const PlantPlace place = meadow.store.find(id);
	if (place.block < 0) {
		report_error(node,
				"has no plant " + String::num_int64(id) +
						". Ids are those of get_plant_ids(), until a plant is removed.");
	}
	return place;
}

PlacedPlant PlantAccess::plant(const PlantPlace &place) const {
	return meadow.store.block(place.block).plants.plant(place.slot);
}

PackedInt64Array PlantAccess::ids_of(const std::vector<PlantPlace> &places) const {
	PackedInt64Array ids;
	ids.resize(int64_t(places.size()));
	int64_t *to = ids.ptrw();
	for (size_t i = 0; i < places.size(); i++) {
		to[i] = meadow.store.id(places[i]);
	}
	return ids;
}

PackedInt64Array PlantAccess::all() const {
	PackedInt64Array ids;
	const std::vector<PlantId> standing = meadow.store.ids();
	ids.resize(int64_t(standing.size()));
	std::copy(standing.begin(), standing.end(), ids.ptrw());
	return ids;
}

std::vector<PlantPlace> PlantAccess::in_sphere(const Vector3 &center, double radius) const {
	std::vector<PlantPlace> found;
	const Transform3D to_field = axes_of(node).affine_inverse();
	const float reach = float(radius) * to_field.basis.get_column(1).length();
	meadow.store.find_in_sphere(to_glm(to_field.xform(center)), reach, found);
	return found;
}

std::vector<PlantPlace> PlantAccess::in_box(const AABB &box) const {
	const Transform3D placed = axes_of(node);
	const Transform3D to_field = placed.affine_inverse();
	AABB around(to_field.xform(box.position), Vector3());
	for (int i = 1; i < 8; i++) {
		around.expand_to(to_field.xform(box.position + box.size * Vector3(i & 1, i >> 1 & 1, i >> 2)));
	}
	std::vector<PlantPlace> near, found;
	meadow.store.find_in_box(to_glm(around.position), to_glm(around.get_end()), near);
	for (const PlantPlace &place : near) {
		// A field that is turned has another box around it.
		if (box.has_point(placed.xform(to_godot(meadow.store.block(place.block).root(place.slot))))) {
			found.push_back(place);
		}
	}
	return found;
}

Transform3D PlantAccess::transform(int64_t id) const {
	const PlantPlace place = find(id);
	if (place.block < 0) {
		return Transform3D();
	}
	const PlacedPlant one = plant(place);
	const Vector3 scale(one.scale, one.scale, one.scale);
	return Transform3D(Basis(Vector3(0.0f, 1.0f, 0.0f), one.turn).scaled(scale), to_godot(one.root));
}

TypedArray<Transform3D> PlantAccess::transforms(const PackedInt64Array &ids) const {
	TypedArray<Transform3D> found;
	for (const int64_t id : ids) {
		found.push_back(transform(id));
	}
	return found;
}

Ref<PlantFunction> PlantAccess::species(int64_t id) const {
	const PlantPlace place = find(id);
	return place.block < 0 ? Ref<PlantFunction>() : look_of(plant(place)).function;
}

double PlantAccess::height(int64_t id) const {
	const PlantPlace place = find(id);
	if (place.block < 0) {
		return 0.0;
	}
	PlacedPlant one = plant(place);
	one.scale = 1.0f;
	return look_of(one).length_of(one);
}

PackedFloat32Array PlantAccess::heights(const PackedInt64Array &ids) const {
	PackedFloat32Array found;
	for (const int64_t id : ids) {
		found.push_back(float(height(id)));
	}
	return found;
}

int64_t PlantAccess::seed(int64_t id) const {
	const PlantPlace place = find(id);
	if (place.block < 0) {
		return 0;
	}
	const PlacedPlant one = plant(place);
	return look_of(one).variant_of(one).seed;
}

Vector3 PlantAccess::tip_now(int64_t id) {
	const PlantPlace place = find(id);
	if (place.block < 0) {
		return Vector3();
	}
	const PlacedPlant one = plant(place);
	return to_godot(one.root + look_of(one).length_of(one) * meadow.motion.read_state_now(place).direction);
}

PackedVector3Array PlantAccess::tips_now(const PackedInt64Array &ids) {
	PackedVector3Array found;
	for (const int64_t id : ids) {
		found.push_back(tip_now(id));
	}
	return found;
}

PackedFloat32Array PlantAccess::motion_now(const PackedInt64Array &ids) {
	PackedFloat32Array found;
	for (const int64_t id : ids) {
		const PlantPlace place = find(id);
		const TipState state = place.block < 0 ? TipState() : meadow.motion.read_state_now(place);
		for (const glm::vec3 &part : { state.direction, state.rate }) {
			found.push_back(part.x);
			found.push_back(part.y);
			found.push_back(part.z);
		}
	}
	return found;
}

void PlantAccess::set_motion(const PackedInt64Array &ids, const PackedFloat32Array &state) {
	if (state.size() != ids.size() * FLOATS_PER_STATE) {
		report_error(node, "set_motion_state() needs six numbers for each id, as get_motion_state() gives them.");
		return;
	}
	const float *from = state.ptr();
	for (int64_t i = 0; i < ids.size(); i++, from += FLOATS_PER_STATE) {
		const PlantPlace place = find(ids[i]);
		if (place.block >= 0) {
			meadow.motion.write_state(place, { { from[0], from[1], from[2] }, { from[3], from[4], from[5] } });
		}
	}
}

int PlantAccess::blow(const Vector3 &center, double radius, const Vector3 &impulse) {
	if (!center.is_finite() || !impulse.is_finite() || !std::isfinite(radius) || radius < 0.0) {
		report_error(node, "apply_impulse_in_sphere() needs a finite centre, radius and impulse.");
		return 0;
	}
	if (!node->is_inside_tree()) {
		return 0;
	}
	const glm::vec3 blown = to_glm(axes_of(node).basis.inverse().xform(impulse));
	const std::vector<PlantPlace> places = in_sphere(center, radius);
	for (const PlantPlace &place : places) {
		meadow.motion.apply_impulse(place, blown);
	}
	return int(places.size());
}

PackedInt64Array PlantAccess::add(
		const Variant &transforms, const Ref<PlantFunction> &function, const Callable &changed) {
	std::vector<Transform3D> places;
	if (!read_transforms(transforms, places)) {
		report_error(
				node, "add_plants() needs an Array of Transform3D, or a PackedFloat32Array with 12 numbers for each.");
		return PackedInt64Array();
	}
	if (function.is_null()) {
		report_error(node, "add_plants() needs a PlantFunction: which species?");
		return PackedInt64Array();
	}
	if (double(meadow.store.plant_count()) + double(places.size()) > PlacementRequest::MOST_PLANTS) {
		report_error(node, "cannot hold more than 4,000,000 plants; none of these is added. Use another field.");
		return PackedInt64Array();
	}
	const int species_index = meadow.species_for(function);
	if (species_index < 0) {
		return PackedInt64Array();
	}
	follow_changes(function.ptr(), changed); // Also a listed one: it may leave the list, and they stay.
	const int variants = int(meadow.style.looks[size_t(species_index)].variants.size());
	std::vector<PlacedPlant> placed;
	for (const Transform3D &place : places) {
		PlacedPlant plant = place_transform(place);
		plant.species = species_index;
		plant.variant = (meadow.store.plant_count() + int(placed.size())) % variants;
		if (is_valid(plant)) {
			placed.push_back(plant);
		}
	}
	if (placed.size() < places.size()) {
		report_error(node,
				String::num_int64(int64_t(places.size() - placed.size())) +
						" transforms of add_plants() are not finite or of no size; the others are added.");
	}
	PackedInt64Array ids;
	for (const PlantId id : meadow.add(std::move(placed))) {
		ids.push_back(id);
	}
	return ids;
}

bool PlantAccess::remove(int64_t id) {
	const PlantPlace place = meadow.store.find(id);
	if (place.block >= 0) {
		meadow.remove({ place });
	}
	return place.block >= 0;
}

int PlantAccess::remove_all(const PackedInt64Array &ids) {
	std::vector<PlantPlace> places;
	for (const int64_t id : ids) {
		const PlantPlace place = meadow.store.find(id);
		if (place.block >= 0) {
			places.push_back(place);
		}
	}
	const int before = meadow.store.plant_count();
	meadow.remove(std::move(places));
	return before - meadow.store.plant_count();
}

int PlantAccess::remove_in_sphere(const Vector3 &center, double radius) {
	if (!center.is_finite() || !std::isfinite(radius) || radius < 0.0) {
		report_error(node, "remove_in_sphere() needs a finite centre and a radius of 0 or more.");
		return 0;
	}
	if (!node->is_inside_tree()) {
		return 0;
	}
	std::vector<PlantPlace> places = in_sphere(center, radius);
	const int count = int(places.size());
	if (count > 0) {
		meadow.remove(std::move(places));
	}
	return count;
}

PackedInt64Array PlantAccess::find_in_sphere(const Vector3 &center, double radius) const {
	if (!center.is_finite() || !std::isfinite(radius) || radius < 0.0) {
		report_error(node, "find_plants_in_sphere() needs a finite centre and a radius of 0 or more.");
		return PackedInt64Array();
	}
	return node->is_inside_tree() ? ids_of(in_sphere(center, radius)) : PackedInt64Array();
}

PackedInt64Array PlantAccess::find_in_box(const AABB &box) const {
	if (!box.is_finite()) {
		report_error(node, "find_plants_in_box() needs a finite box.");
		return PackedInt64Array();
	}
	return node->is_inside_tree() ? ids_of(in_box(box)) : PackedInt64Array();
}

} // namespace undergrowth
