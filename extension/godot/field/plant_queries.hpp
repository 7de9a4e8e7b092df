#pragma once

#include "field/field_runtime.hpp"
#include "placement/edit_log_bytes.hpp"

#include <godot_cpp/classes/skeleton3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace undergrowth {

/// Queries and edits of single plants of a field. Implements the methods of PlantField3D of these names; owns no state.
/// An unknown id gives one error and an empty result. Results are in the field's own axes (m) unless noted. Positions,
/// spheres and boxes are in world axes; they contain no plants while the node is outside a tree. Invalid arguments give
/// an error that names the node and the method, and change nothing. Main thread.
class PlantQueries {
public:
	PlantQueries(godot::GeometryInstance3D *p_node, FieldRuntime &p_runtime) : node(p_node), runtime(p_runtime) {}

	bool has(int64_t id) const;
	godot::PackedInt64Array ids() const;
	godot::PackedInt64Array find_in_box(const godot::AABB &box) const;
	godot::PackedInt64Array find_in_sphere(const godot::Vector3 &center, double radius) const;
	/// Returns the transform of the plant's mesh without lean and bend.
	godot::Transform3D transform(int64_t id) const;
	/// Returns the plant with the nearest root within `max_distance` (m), or NO_PLANT.
	int64_t find_nearest(const godot::Vector3 &point, double max_distance) const;
	/// Returns the species of find_nearest(), or null.
	godot::Ref<PlantFunction> species_at(const godot::Vector3 &point, double max_distance) const;
	godot::Ref<PlantFunction> species(int64_t id) const;
	/// Returns the height of a plant in the world (m), mowing included.
	double height(int64_t id) const;
	int64_t seed(int64_t id) const;
	godot::TypedArray<godot::Transform3D> transforms(const godot::PackedInt64Array &ids) const;
	godot::PackedFloat32Array heights(const godot::PackedInt64Array &ids) const;
	godot::Skeleton3D *skeleton(int64_t id) const;

	/// True if a position is within `margin` (m) of a plant in its present pose.
	bool is_point_in(const godot::Vector3 &point, double margin);
	/// Applies an impulse (N·s, world axes) to the tips of all plants in a sphere. Returns their number.
	int apply_impulse_in_sphere(const godot::Vector3 &center, double radius, const godot::Vector3 &impulse);
	/// Applies impulses away from `center`: `impulse` (N·s) at the centre, decreasing to 0 at `radius` (m). Returns the
	/// number of plants.
	int apply_blast(const godot::Vector3 &center, double radius, double impulse);
	/// Bends all plants in a sphere away from `center`, by `angle` (rad) from upright, lastingly. Returns the number of
	/// plants.
	int trample_in_sphere(const godot::Vector3 &center, double radius, double angle);
	godot::Vector3 tip_position(int64_t id);
	godot::PackedVector3Array tip_positions(const godot::PackedInt64Array &ids);
	/// Returns twelve numbers per plant: direction and rate of the tip, and the same of a stem's second mode.
	godot::PackedFloat32Array motion_state(const godot::PackedInt64Array &ids);
	void set_motion_state(const godot::PackedInt64Array &ids, const godot::PackedFloat32Array &state);

	/// Adds plants and returns their ids. Later changes of the species call the node's _on_added_species_changed().
	godot::PackedInt64Array add(const godot::Variant &transforms, const godot::Ref<PlantFunction> &function);
	bool remove(int64_t id);
	int remove_all(const godot::PackedInt64Array &ids);
	int remove_in_sphere(const godot::Vector3 &center, double radius);
	int remove_in_box(const godot::AABB &box);
	/// Removes plants with roots in a polygon, seen from above, at any height. Returns their number.
	int remove_in_polygon(const godot::PackedVector3Array &points);
	/// Removes plants with roots within half of `width` (m) of a line through these points. Returns their number.
	int remove_along(const godot::PackedVector3Array &points, double width);

	/// Mows all plants in a sphere to `height` (m), at most to their full height. Returns the number of changed plants.
	int set_height_in_sphere(const godot::Vector3 &center, double radius, double height);
	/// Returns the edits of code (removed, mown and added plants) and the trodden plants in the format of
	/// write_edits().
	godot::PackedByteArray changes() const;
	/// Replaces all edits by these. Returns false, with one error and no change, if the bytes are not valid.
	bool apply_changes(const godot::PackedByteArray &bytes);
	/// True if there are edits.
	bool has_changes() const;

private:
	/// A plant that was found by its id.
	struct FoundPlant {
		PlantRef place;
		PlacedPlant plant;
		const SpeciesStyle &style;
	};
	godot::GeometryInstance3D *node;
	FieldRuntime &runtime;

	godot::String name_of_style(int style) const;
	godot::Ref<PlantFunction> species_named(const godot::String &name) const;
	bool find_species(const SavedEdits &saved, std::vector<godot::Ref<PlantFunction>> &found) const;
	void bring_back(const SavedEdits &saved, const std::vector<godot::Ref<PlantFunction>> &species);
	template <class Read> auto query(int64_t id, const Read &read) const;
	godot::PackedInt64Array ids_of(const std::vector<PlantRef> &places) const;
	std::vector<PlantRef> in_box(const char *method, const godot::AABB &box) const;
	std::vector<PlantRef> in_sphere(const char *method, const godot::Vector3 &center, double radius) const;
	/// A sphere of the world, and its bounding sphere in the field's axes (m).
	struct Sphere {
		glm::vec3 center; ///< Field axes, like `radius`.
		float radius;
		godot::Vector3 world_center;
		float world_radius;
		godot::Transform3D placed; ///< The field's axes.
		bool is_even; ///< The field's scale is uniform, so that both spheres are equal.
	};
	using Find = std::function<void(std::vector<PlantRef> &)>;
	/// Returns nothing outside a tree, or with an error of `method` if the sphere is invalid.
	std::optional<Sphere> sphere_of(const char *method, const godot::Vector3 &center, double radius) const;
	/// Appends the plants with roots in the sphere.
	void find_in(const Sphere &sphere, std::vector<PlantRef> &found) const;
	/// Removes the plants that `find` returns now, and those that a first build adds later, in a box (m, field axes).
	/// Returns the number of plants removed now.
	int remove_found(const AreaBox &box, const Find &find);
	/// `height`: m, field axes. Returns the number of changed plants.
	int mow_in(const Sphere &sphere, float height);
};

} // namespace undergrowth
