#pragma once

#include "field/field_monitors.hpp"
#include "field/meadow.hpp"
#include "field/node_watch.hpp"
#include "field/plant_access.hpp"
#include "messages.hpp"

#include <godot_cpp/classes/geometry_instance3d.hpp>
#include <godot_cpp/classes/skeleton3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <vector>

namespace undergrowth {

/// Thousands of plants, each with its own motion, drawn as multimeshes that bend in the vertex shader. The node holds
/// what users set and tells its Meadow of it; every change is one of the stand, of the motion or of the view, and
/// touches nothing else.
class PlantField3D : public godot::GeometryInstance3D {
	GDCLASS(PlantField3D, godot::GeometryInstance3D)

public:
	enum GroundMode : int64_t {
		GROUND_NONE = int(FieldGround::Kind::none),
		GROUND_COLLIDERS = int(FieldGround::Kind::colliders),
		GROUND_MESH = int(FieldGround::Kind::mesh),
	};

private:
	/// What a change of a property is about.
	enum class About {
		stand, ///< Plants grow anew.
		view, ///< What stands is dressed anew.
		nothing, ///< It is read when it is needed.
	};
	FieldProperties properties;
	godot::TypedArray<PlantFieldSpecies> listed; ///< By users. Where it is empty, grass grows.
	Meadow meadow;
	PlantAccess plants;
	NodeWatch watched;
	std::vector<uint64_t> seen_species; ///< Of the list, as it was read: scripts may append to it.
	godot::TypedArray<godot::NodePath> seen_exclusions;
	godot::TypedArray<PlantFieldLevel> seen_levels;
	float seen_range = 0.0f;
	uint64_t seen_material = 0;
	godot::String problem;
	bool stand_is_stale = true;
	bool look_is_stale = true;
	bool fill_is_queued = false;
	bool has_told_of_crowd = false;
	double main_usec = 0.0; ///< Of the last frame, without wait_usec.
	double wait_usec = 0.0; ///< For the worker threads, where they took longer than the frame.
	int frames_since_look = 0;

	void set_number(double &slot, const char *name, double value, const Range &range, About about);
	void set_whole(int &slot, const char *name, int value, const Range &range, About about);
	void set_span(godot::Vector2 &slot, const char *name, const godot::Vector2 &value, const Range &range);
	void changed(About about);
	void mark_stale(bool stand);
	void report_problem(const godot::String &what);
	bool may_simulate() const;
	void follow_frames(bool on);
	void poll(double delta, bool physics);
	void process_frame();
	void look_around();
	void follow_species();
	void watch_nodes();
	void tell_of_bodies();
	void tell_of_skeleton(godot::Skeleton3D *skeleton, bool is_shown);

protected:
	static void _bind_methods();
	void _notification(int what);
	void _validate_property(godot::PropertyInfo &property) const;

public:
	PlantField3D();
	~PlantField3D() override;
	static PlantField3D *from_species(const godot::Array &functions, const godot::PackedFloat32Array &shares);
	godot::PackedStringArray _get_configuration_warnings() const override;
	godot::AABB _get_aabb() const override;

	// What stands.
	void fill();
	bool is_filling() const;
	godot::PackedInt64Array add_plants(const godot::Variant &transforms, const godot::Ref<PlantFunction> &function) {
		return plants.add(transforms, function, godot::Callable(this, "_on_added_species_changed"));
	}
	bool remove_plant(int64_t id) { return plants.remove(id); }
	int remove_plants(const godot::PackedInt64Array &ids) { return plants.remove_all(ids); }
	int remove_in_sphere(const godot::Vector3 &center, double radius) {
		return plants.remove_in_sphere(center, radius);
	}
	int get_plant_count() const { return meadow.store.plant_count(); }
	godot::PackedInt64Array get_plant_ids() const { return plants.all(); }
	bool has_plant(int64_t id) const;
	godot::PackedInt64Array find_plants_in_box(const godot::AABB &box) const { return plants.find_in_box(box); }
	godot::PackedInt64Array find_plants_in_sphere(const godot::Vector3 &center, double radius) const {
		return plants.find_in_sphere(center, radius);
	}
	godot::Transform3D get_plant_transform(int64_t id) const { return plants.transform(id); }
	godot::Ref<PlantFunction> get_plant_species(int64_t id) const { return plants.species(id); }
	double get_plant_height(int64_t id) const { return plants.height(id); }
	int64_t get_plant_seed(int64_t id) const { return plants.seed(id); }
	godot::TypedArray<godot::Transform3D> get_plant_transforms(const godot::PackedInt64Array &ids) const {
		return plants.transforms(ids);
	}
	godot::PackedFloat32Array get_plant_heights(const godot::PackedInt64Array &ids) const {
		return plants.heights(ids);
	}
	/// The field's outline in its own axes.
	Polygon outline_polygon() const;
	godot::PackedVector3Array get_outline_points() const;

	// How it moves.
	bool is_point_in_plants(const godot::Vector3 &point);
	int apply_impulse_in_sphere(const godot::Vector3 &center, double radius, const godot::Vector3 &impulse) {
		return plants.blow(center, radius, impulse);
	}
	godot::Vector3 get_tip_position(int64_t id) { return plants.tip_now(id); }
	godot::PackedVector3Array get_tip_positions(const godot::PackedInt64Array &ids) { return plants.tips_now(ids); }
	godot::PackedFloat32Array get_motion_state(const godot::PackedInt64Array &ids) { return plants.motion_now(ids); }
	void set_motion_state(const godot::PackedInt64Array &ids, const godot::PackedFloat32Array &state) {
		plants.set_motion(ids, state);
	}
	void reset_motion();
	/// Moves the field by `delta` seconds under `blowing` where it does not move by itself, as in the editor.
	void preview(double delta, const godot::Ref<PlantWind> &blowing);

	// How it is seen.
	godot::Skeleton3D *get_skeleton(int64_t id) const;
	int64_t get_skeleton_plant(const godot::Skeleton3D *skeleton) const;
	godot::TypedArray<godot::Skeleton3D> get_skeletons() const;
	godot::Dictionary get_statistics();

	// Called by the engine.
	void on_species_changed();
	bool lists(const godot::Ref<PlantFunction> &function) const;
	void on_added_species_changed();
	void on_levels_changed();
	void on_area_changed();
	void on_wind_changed();
	void on_fill_queued();
	void on_tree_frame();
	void on_physics_frame();
	double monitor(int which) const { return FieldMonitors::sum(which); }

	void set_species(const godot::TypedArray<PlantFieldSpecies> &entries);
	godot::TypedArray<PlantFieldSpecies> get_species() const { return listed; }
	void set_density(double plants);
	double get_density() const { return properties.stand.density; }
	void set_seed(int64_t seed);
	int64_t get_seed() const { return properties.stand.seed; }
	void set_clumping(double share);
	double get_clumping() const { return properties.stand.clumping; }
	void set_clump_size(double metres);
	double get_clump_size() const { return properties.stand.clump_size; }
	void set_size(const godot::Vector2 &metres);
	godot::Vector2 get_size() const { return properties.stand.size; }
	void set_outline(const godot::NodePath &path);
	godot::NodePath get_outline() const { return properties.stand.outline; }
	void set_exclusions(const godot::TypedArray<godot::NodePath> &paths);
	godot::TypedArray<godot::NodePath> get_exclusions() const { return properties.stand.exclusions; }
	void set_ground_mode(GroundMode mode);
	GroundMode get_ground_mode() const { return GroundMode(properties.stand.ground_mode); }
	void set_ground_collision_mask(int64_t mask);
	int64_t get_ground_collision_mask() const { return properties.stand.ground_collision_mask; }
	void set_ground_mesh(const godot::NodePath &path);
	godot::NodePath get_ground_mesh() const { return properties.stand.ground_mesh; }
	void set_height_limits(const godot::Vector2 &metres);
	godot::Vector2 get_height_limits() const { return properties.stand.height_limits; }
	void set_slope_limits(const godot::Vector2 &radians);
	godot::Vector2 get_slope_limits() const;
	void set_slope_alignment(double share);
	double get_slope_alignment() const { return properties.stand.slope_alignment; }
	void set_wind(const godot::Ref<PlantWind> &wind);
	godot::Ref<PlantWind> get_wind() const { return properties.motion.wind; }
	void set_simulation_enabled(bool on);
	bool is_simulation_enabled() const { return properties.motion.simulation_enabled; }
	void set_max_threads(int count);
	int get_max_threads() const { return properties.motion.max_threads; }
	void set_update_interval(int step_count);
	int get_update_interval() const { return properties.motion.update_interval; }
	void set_far_distance(double metres);
	double get_far_distance() const { return properties.motion.far_distance; }
	void set_prototypes(int count);
	int get_prototypes() const { return properties.motion.prototypes; }
	void set_contact_enabled(bool on);
	bool is_contact_enabled() const { return properties.motion.contact_enabled; }
	void set_bodies_group(const godot::StringName &group);
	godot::StringName get_bodies_group() const { return properties.motion.bodies_group; }
	void set_touch_margin(double metres);
	double get_touch_margin() const { return properties.motion.touch_margin; }
	void set_levels(const godot::TypedArray<PlantFieldLevel> &entries);
	godot::TypedArray<PlantFieldLevel> get_levels() const { return properties.view.levels; }
	void set_fade_margin(double metres);
	double get_fade_margin() const { return properties.view.fade_margin; }
	void set_shadow_distance(double metres);
	double get_shadow_distance() const { return properties.view.shadow_distance; }
	void set_skeleton_distance(double metres);
	double get_skeleton_distance() const { return properties.view.skeleton_distance; }
	void set_max_skeletons(int count);
	int get_max_skeletons() const { return properties.view.max_skeletons; }
	void set_tile_size(double metres);
	double get_tile_size() const { return properties.view.tile_size; }
};

} // namespace undergrowth

VARIANT_ENUM_CAST(undergrowth::PlantField3D::GroundMode);
