#pragma once

#include "field/meadow.hpp"

#include <godot_cpp/variant/aabb.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int64_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <vector>

namespace undergrowth {

/// What a field tells of its plants, and how they are pushed, by their ids. An id that does not stand is one error and
/// an empty answer. Places within the field are in its own axes, spheres and boxes in the world's. Main thread.
class PlantAccess {
public:
	PlantAccess(const godot::Node3D *field, Meadow &of) : node(field), meadow(of) {}

	/// The block is -1 where no such plant stands, which is told.
	PlantPlace find(int64_t id) const;
	godot::PackedInt64Array ids_of(const std::vector<PlantPlace> &places) const;
	godot::PackedInt64Array all() const;
	std::vector<PlantPlace> in_sphere(const godot::Vector3 &center, double radius) const;
	std::vector<PlantPlace> in_box(const godot::AABB &box) const;

	/// Where its mesh is drawn, before it bends.
	godot::Transform3D transform(int64_t id) const;
	godot::TypedArray<godot::Transform3D> transforms(const godot::PackedInt64Array &ids) const;
	godot::Ref<PlantFunction> species(int64_t id) const;
	double height(int64_t id) const;
	godot::PackedFloat32Array heights(const godot::PackedInt64Array &ids) const;
	int64_t seed(int64_t id) const;

	godot::Vector3 tip_now(int64_t id);
	godot::PackedVector3Array tips_now(const godot::PackedInt64Array &ids);
	/// Six numbers for each plant: its direction and its rate.
	godot::PackedFloat32Array motion_now(const godot::PackedInt64Array &ids);
	void set_motion(const godot::PackedInt64Array &ids, const godot::PackedFloat32Array &state);
	/// What transforms say, plants of `function`; tells their ids. `changed` hears of a species that the field does not
	/// list.
	godot::PackedInt64Array add(const godot::Variant &transforms, const godot::Ref<PlantFunction> &function,
			const godot::Callable &changed);
	bool remove(int64_t id);
	/// Those of them that stand; tells how many they were.
	int remove_all(const godot::PackedInt64Array &ids);
	int remove_in_sphere(const godot::Vector3 &center, double radius);
	godot::PackedInt64Array find_in_sphere(const godot::Vector3 &center, double radius) const;
	godot::PackedInt64Array find_in_box(const godot::AABB &box) const;
	/// Tells how many were blown.
	int blow(const godot::Vector3 &center, double radius, const godot::Vector3 &impulse);

private:
	const godot::Node3D *node;
	Meadow &meadow;

	PlacedPlant plant(const PlantPlace &place) const;
	const FieldLook &look_of(const PlacedPlant &plant) const { return meadow.style.looks[size_t(plant.species)]; }
};

} // namespace undergrowth
