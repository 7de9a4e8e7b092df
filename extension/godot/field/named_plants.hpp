#pragma once

#include "field/meadow.hpp"
#include "stand/changes_bytes.hpp"

#include <godot_cpp/classes/skeleton3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace undergrowth {

/// What a field's node tells of single plants, and how they are pushed, added and removed, in the words of scripts. An
/// id that does not stand is one error and an empty answer. What a plant tells of its place is in the field's own axes;
/// spheres and boxes are in the world's, and nobody stands in them while the node is outside of a tree. Errors name the
/// node and PlantField3D's methods. Main thread.
class NamedPlants {
public:
	NamedPlants(godot::GeometryInstance3D *p_node, Meadow &p_meadow) : node(p_node), meadow(p_meadow) {}

	bool has(int64_t id) const;
	godot::PackedInt64Array ids() const;
	godot::PackedInt64Array find_in_box(const godot::AABB &box) const;
	godot::PackedInt64Array find_in_sphere(const godot::Vector3 &center, double radius) const;
	/// Where its mesh is drawn, before it bends.
	godot::Transform3D transform(int64_t id) const;
	/// NO_PLANT where nobody's root is within that distance (m) of a place in the world.
	int64_t find_nearest(const godot::Vector3 &point, double max_distance) const;
	/// Of that plant; null where there is none.
	godot::Ref<PlantFunction> species_at(const godot::Vector3 &point, double max_distance) const;
	godot::Ref<PlantFunction> species(int64_t id) const;
	/// As it stands in the world (m).
	double height(int64_t id) const;
	int64_t seed(int64_t id) const;
	godot::TypedArray<godot::Transform3D> transforms(const godot::PackedInt64Array &ids) const;
	godot::PackedFloat32Array heights(const godot::PackedInt64Array &ids) const;
	godot::Skeleton3D *skeleton(int64_t id) const;

	/// `margin`: m from a plant that still counts as in it.
	bool is_point_in(const godot::Vector3 &point, double margin);
	/// N·s, world axes, at the tips of all plants in a sphere; tells how many they are.
	int apply_impulse_in_sphere(const godot::Vector3 &center, double radius, const godot::Vector3 &impulse);
	/// Blows (N·s at the centre, weaker to the radius) away from a place; tells how many they hit.
	int apply_blast(const godot::Vector3 &center, double radius, double impulse);
	godot::Vector3 tip_position(int64_t id);
	godot::PackedVector3Array tip_positions(const godot::PackedInt64Array &ids);
	/// Six numbers for each plant: its direction and its rate.
	godot::PackedFloat32Array motion_state(const godot::PackedInt64Array &ids);
	void set_motion_state(const godot::PackedInt64Array &ids, const godot::PackedFloat32Array &state);

	/// The node's _on_added_species_changed() hears of what their species changes from now on.
	godot::PackedInt64Array add(const godot::Variant &transforms, const godot::Ref<PlantFunction> &function);
	bool remove(int64_t id);
	int remove_all(const godot::PackedInt64Array &ids);
	int remove_in_sphere(const godot::Vector3 &center, double radius);
	int remove_in_box(const godot::AABB &box);
	/// Seen from above, however high.
	int remove_in_polygon(const godot::PackedVector3Array &points);
	/// At most half of `width` (m) from a line through these points.
	int remove_along(const godot::PackedVector3Array &points, double width);

	/// All plants in a sphere are so high (m), or as high as they grow where that is less; tells how many changed.
	int set_height_in_sphere(const godot::Vector3 &center, double radius, double height);
	/// What code removed, mowed and added, as write_changes() has it.
	godot::PackedByteArray changes() const;
	/// Makes it so, and nothing else. False, with one error, where the bytes are not sound: nothing changes then.
	bool apply_changes(const godot::PackedByteArray &bytes);
	/// Whether changes() tells of any.
	bool has_changes() const;

private:
	/// A plant that an id names.
	struct Standing {
		PlantPlace place;
		PlacedPlant plant;
		const FieldLook &look;
	};
	godot::GeometryInstance3D *node;
	Meadow &meadow;

	godot::String name_of_look(int look) const;
	godot::Ref<PlantFunction> species_named(const godot::String &name) const;
	bool find_species(const SavedChanges &saved, std::vector<godot::Ref<PlantFunction>> &found) const;
	void bring_back(const SavedChanges &saved, const std::vector<godot::Ref<PlantFunction>> &species);
	template <class Say> auto ask(int64_t id, const Say &say) const;
	godot::PackedInt64Array ids_of(const std::vector<PlantPlace> &places) const;
	std::vector<PlantPlace> in_box(const char *method, const godot::AABB &box) const;
	std::vector<PlantPlace> in_sphere(const char *method, const godot::Vector3 &center, double radius) const;
	/// A sphere of the world, and the sphere around it in the field's axes (m).
	struct Sphere {
		glm::vec3 center; ///< Field axes, like `radius`.
		float radius;
		godot::Vector3 world_center;
		float world_radius;
		godot::Transform3D placed; ///< The field's axes.
		bool is_even; ///< The field is scaled alike along all axes, so that both spheres are the same.
	};
	using Find = std::function<void(std::vector<PlantPlace> &)>;
	/// Nothing outside of a tree, and where that is no sphere, which is an error of `method`.
	std::optional<Sphere> sphere_of(const char *method, const godot::Vector3 &center, double radius) const;
	/// Appends the plants with roots in the sphere.
	void find_in(const Sphere &sphere, std::vector<PlantPlace> &found) const;
	/// Removes what `find` finds, and what it finds later of a first build, in a box (m, field axes). Returns how many
	/// plants are removed now.
	int remove_found(const AreaBox &box, const Find &find);
	/// `height`: m, field axes. Returns how many plants changed.
	int mow_in(const Sphere &sphere, float height);
};

} // namespace undergrowth
