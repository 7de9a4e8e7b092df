#include "field/plant_access.hpp"

#include "convert.hpp"
#include "messages.hpp"

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr float LEAST_TILT = 1e-3f;
static constexpr int FLOATS_PER_TRANSFORM = 12;
static constexpr int FLOATS_PER_STATE = 6; // Direction and rate.

bool read_transforms(const Variant &from, std::vector<Transform3D> &to) {
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

PlacedPlant place_transform(const Transform3D &transform) {
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
	return plant;
}

PlantPlace PlantAccess::find(int64_t id) const {
	const PlantPlace place = meadow.store.find(id);
	if (place.block < 0) {
		report_error(node,
				"has no plant " + String::num_int64(id) + ". Ids are those of get_plant_ids(), until a plant is removed.");
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
	const glm::vec3 blown = to_glm(axes_of(node).basis.inverse().xform(impulse));
	const std::vector<PlantPlace> places = in_sphere(center, radius);
	for (const PlantPlace &place : places) {
		meadow.motion.apply_impulse(place, blown);
	}
	return int(places.size());
}

} // namespace undergrowth
