// What a PlantField3D is asked and told about its plants. They are named by ids.

#include "field/plant_field_3d.hpp"

#include "convert.hpp"
#include "follow_changes.hpp"

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr float LEAST_TILT = 1e-3f;
static constexpr int FLOATS_PER_TRANSFORM = 12;
static constexpr int FLOATS_PER_STATE = 6; // Direction and rate.

PlantPlace PlantField3D::find(int64_t id) const {
	const PlantPlace place = meadow.store.find(id);
	if (place.block < 0) {
		report_error(this,
				"has no plant " + String::num_int64(id) +
						". Ids are those of get_plant_ids(), until a plant is removed.");
	}
	return place;
}

std::vector<PlantPlace> PlantField3D::find_all(const PackedInt64Array &ids) const {
	std::vector<PlantPlace> places;
	for (const int64_t id : ids) {
		places.push_back(find(id));
	}
	return places;
}

PackedInt64Array PlantField3D::ids_of(const std::vector<PlantPlace> &places) const {
	PackedInt64Array ids;
	ids.resize(int64_t(places.size()));
	int64_t *to = ids.ptrw();
	for (size_t i = 0; i < places.size(); i++) {
		to[i] = meadow.store.id(places[i]);
	}
	return ids;
}

// What a transform says about a plant: its place, scale and turn; a tilt becomes a lean to that side.
PlacedPlant PlantField3D::place_transform(const Transform3D &transform, int species_index, int number) const {
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
	plant.variant = number % int(meadow.style.looks[size_t(species_index)].variants.size());
	return plant;
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
	std::vector<PlacedPlant> placed;
	for (const Transform3D &place : places) {
		const PlacedPlant plant = place_transform(place, species_index, get_plant_count() + int(placed.size()));
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
	const PlantPlace place = find(id);
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

// Points and boxes are the world's.
std::vector<PlantPlace> PlantField3D::places_in_sphere(const Vector3 &center, double radius) const {
	std::vector<PlantPlace> found;
	const Transform3D to_field = axes_of(this).affine_inverse();
	const float reach = float(radius) * to_field.basis.get_column(1).length();
	meadow.store.find_in_sphere(to_glm(to_field.xform(center)), reach, found);
	return found;
}

int PlantField3D::remove_in_sphere(const Vector3 &center, double radius) {
	if (!center.is_finite() || !std::isfinite(radius) || radius < 0.0) {
		report_error(this, "remove_in_sphere() needs a finite centre and a radius of 0 or more.");
		return 0;
	}
	if (!is_inside_tree()) {
		return 0;
	}
	std::vector<PlantPlace> places = places_in_sphere(center, radius);
	const int count = int(places.size());
	if (count > 0) {
		meadow.remove(std::move(places));
	}
	return count;
}

int PlantField3D::get_plant_count() const {
	return meadow.store.plant_count();
}

PackedInt64Array PlantField3D::get_plant_ids() const {
	PackedInt64Array ids;
	const std::vector<PlantId> all = meadow.store.ids();
	ids.resize(int64_t(all.size()));
	std::copy(all.begin(), all.end(), ids.ptrw());
	return ids;
}

bool PlantField3D::has_plant(int64_t id) const {
	return meadow.store.find(id).block >= 0;
}

PackedInt64Array PlantField3D::find_plants_in_sphere(const Vector3 &center, double radius) const {
	if (!center.is_finite() || !std::isfinite(radius) || radius < 0.0) {
		report_error(this, "find_plants_in_sphere() needs a finite centre and a radius of 0 or more.");
		return PackedInt64Array();
	}
	return is_inside_tree() ? ids_of(places_in_sphere(center, radius)) : PackedInt64Array();
}

PackedInt64Array PlantField3D::find_plants_in_box(const AABB &box) const {
	if (!box.is_finite()) {
		report_error(this, "find_plants_in_box() needs a finite box.");
		return PackedInt64Array();
	}
	if (!is_inside_tree()) {
		return PackedInt64Array();
	}
	const Transform3D placed = axes_of(this);
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
	return ids_of(found);
}

// Where its mesh is drawn, before it bends. Field axes.
static Transform3D drawn_transform(const PlacedPlant &plant) {
	const Vector3 scale(plant.scale, plant.scale, plant.scale);
	return Transform3D(Basis(Vector3(0.0f, 1.0f, 0.0f), plant.turn).scaled(scale), to_godot(plant.root));
}

Transform3D PlantField3D::get_plant_transform(int64_t id) const {
	const PlantPlace place = find(id);
	return place.block < 0 ? Transform3D() : drawn_transform(meadow.store.block(place.block).plants.plant(place.slot));
}

TypedArray<Transform3D> PlantField3D::get_plant_transforms(const PackedInt64Array &ids) const {
	TypedArray<Transform3D> all;
	for (const int64_t id : ids) {
		all.push_back(get_plant_transform(id));
	}
	return all;
}

Ref<PlantFunction> PlantField3D::get_plant_species(int64_t id) const {
	const PlantPlace place = find(id);
	return place.block < 0 ? Ref<PlantFunction>()
						   : meadow.style.looks[size_t(meadow.store.block(place.block).species)].function;
}

double PlantField3D::get_plant_height(int64_t id) const {
	const PlantPlace place = find(id);
	if (place.block < 0) {
		return 0.0;
	}
	PlacedPlant plant = meadow.store.block(place.block).plants.plant(place.slot);
	plant.scale = 1.0f;
	return meadow.style.looks[size_t(plant.species)].length_of(plant);
}

PackedFloat32Array PlantField3D::get_plant_heights(const PackedInt64Array &ids) const {
	PackedFloat32Array all;
	for (const int64_t id : ids) {
		all.push_back(float(get_plant_height(id)));
	}
	return all;
}

int64_t PlantField3D::get_plant_seed(int64_t id) const {
	const PlantPlace place = find(id);
	if (place.block < 0) {
		return 0;
	}
	const PlacedPlant plant = meadow.store.block(place.block).plants.plant(place.slot);
	return meadow.style.looks[size_t(plant.species)].variant_of(plant).seed;
}

float PlantField3D::length_of(const PlantPlace &place) const {
	const PlacedPlant plant = meadow.store.block(place.block).plants.plant(place.slot);
	return meadow.style.looks[size_t(plant.species)].length_of(plant);
}

Vector3 PlantField3D::get_tip_position(int64_t id) {
	const PlantPlace place = find(id);
	if (place.block < 0) {
		return Vector3();
	}
	const glm::vec3 root = meadow.store.block(place.block).root(place.slot);
	return to_godot(root + length_of(place) * meadow.motion.read_state_now(place).direction);
}

PackedVector3Array PlantField3D::get_tip_positions(const PackedInt64Array &ids) {
	PackedVector3Array all;
	for (const int64_t id : ids) {
		all.push_back(get_tip_position(id));
	}
	return all;
}

PackedFloat32Array PlantField3D::get_motion_state(const PackedInt64Array &ids) {
	PackedFloat32Array all;
	for (const PlantPlace &place : find_all(ids)) {
		const TipState state = place.block < 0 ? TipState() : meadow.motion.read_state_now(place);
		for (const glm::vec3 &part : { state.direction, state.rate }) {
			all.append_array(PackedFloat32Array({ part.x, part.y, part.z }));
		}
	}
	return all;
}

void PlantField3D::set_motion_state(const PackedInt64Array &ids, const PackedFloat32Array &state) {
	if (state.size() != ids.size() * FLOATS_PER_STATE) {
		report_error(this, "set_motion_state() needs six numbers for each id, as get_motion_state() gives them.");
		return;
	}
	const std::vector<PlantPlace> places = find_all(ids);
	const float *from = state.ptr();
	for (size_t i = 0; i < places.size(); i++, from += FLOATS_PER_STATE) {
		if (places[i].block >= 0) {
			meadow.motion.write_state(places[i], { { from[0], from[1], from[2] }, { from[3], from[4], from[5] } });
		}
	}
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
	if (!is_inside_tree()) {
		return 0;
	}
	const glm::vec3 blow = to_glm(axes_of(this).basis.inverse().xform(impulse));
	const std::vector<PlantPlace> places = places_in_sphere(center, radius);
	for (const PlantPlace &place : places) {
		meadow.motion.apply_impulse(place, blow);
	}
	return int(places.size());
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
	const PlantPlace place = find(id);
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
