#pragma once

#include "field/contact.hpp"
#include "field/field_bodies.hpp"
#include "field/field_drawing.hpp"
#include "field/field_fill.hpp"
#include "field/field_options.hpp"
#include "field/field_skeletons.hpp"
#include "field/field_steps.hpp"
#include "pendulum/fixed_step.hpp"
#include "plant_wind.hpp"

#include <godot_cpp/classes/curve3d.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <memory>
#include <set>
#include <vector>

namespace undergrowth {

/// Thousands of plants, each with its own motion, drawn as multimeshes that bend in the vertex shader.
class PlantField3D : public godot::Node3D {
	GDCLASS(PlantField3D, godot::Node3D)

public:
	enum GroundKind : int64_t {
		GROUND_NONE = int(FieldGround::Kind::none),
		GROUND_COLLIDERS = int(FieldGround::Kind::colliders),
		GROUND_MESH = int(FieldGround::Kind::mesh),
	};

private:
	// What users set.
	FieldOptions options;
	godot::TypedArray<PlantFunction> species;
	godot::PackedFloat32Array shares;
	godot::Ref<godot::Curve3D> area;
	godot::TypedArray<godot::Curve3D> exclusions;
	godot::TypedArray<godot::NodePath> excluded_fields;
	godot::NodePath ground_mesh;
	godot::Ref<PlantWind> wind;
	godot::StringName bodies_group;
	godot::PackedInt32Array levels;
	godot::PackedFloat32Array level_distances;

	// What stands.
	FieldStyle style;
	std::vector<std::unique_ptr<FieldPatch>> patches; // The filled one first, then those that were added.
	std::vector<std::unique_ptr<FieldDrawing>> drawings; // One for each patch.
	std::unique_ptr<FieldSimulation> simulation;
	std::unique_ptr<FieldBends> bends;
	FieldSteps steps; // After what it works on: it is destroyed first.
	TipContact touching;
	bool has_told_of_crowd = false;
	/// Plants of one species that were added and are taken in at the next frame.
	struct Pending {
		godot::Ref<PlantFunction> function;
		std::vector<PlacedPlant> plants;
	};
	std::vector<Pending> pending;
	int filled_patches = 0; // 1 where the first patch was filled; the others were added.
	FieldSkeletons skeletons;
	int frames_since_choice = 0; // Of the plants that are shown as skeletons.
	godot::String problem;

	// Filling.
	std::unique_ptr<FieldFill> fill_job;
	std::unique_ptr<FieldRays> rays;
	bool has_missed_ground = false;
	bool is_stale = true;
	bool fill_is_queued = false;
	float told_progress = -1.0f;

	// Moving.
	FixedStep clock;
	double wind_offset = 0.0; // s, the wind's clock less the simulation's.
	double seen_wind_time = -1.0; // s.
	float shown_alpha = 0.0f; // Of the step that is shown next.
	double upload_usec = 0.0;
	double main_usec = 0.0; // Of the last frame, without wait_usec.
	double wait_usec = 0.0; // For the worker threads, where they took longer than the frame.
	FieldBodies bodies;
	int frames_since_far = 0;

	godot::Transform3D axes() const;

	// plant_field_3d_recipe.cpp
	godot::String make_recipe(FieldRecipe &recipe);
	void start_style(FieldStyle &into) const;
	godot::String make_style(FieldStyle &into);
	godot::String make_request(PlacementRequest &into);
	godot::String make_ground(FieldGround &into);
	std::vector<FieldLevel> make_levels() const;

	// plant_field_3d_fill.cpp
	void mark_stale();
	void report_problem(const godot::String &what);
	void poll_fill();
	void cast_rays();
	void tell_of_no_ground();
	void adopt(FieldResult &result);
	void dress();
	void restart_drawing(FieldDrawing &drawing);

	// plant_field_3d_motion.cpp
	bool may_simulate() const;
	void update_processing();
	void process_frame();
	double step(double delta);
	int worker_count() const;
	void finish_step();
	void upload();
	FieldWind wind_here(const godot::Ref<PlantWind> &from, double offset) const;
	void update_wind(int step_count);
	void push_bodies(double ago);
	void tell_of_bodies();
	void update_far();
	void send_uniforms();

	// plant_field_3d_preview.cpp
	bool may_preview() const;

	// plant_field_3d_adding.cpp
	PlacedPlant place_transform(const godot::Transform3D &transform, int species_index) const;
	int species_for(const godot::Ref<PlantFunction> &function);
	void add_pending(const godot::Ref<PlantFunction> &function, std::vector<PlacedPlant> &&plants);
	int count_pending() const;
	void keep_added();

	// plant_field_3d_patches.cpp
	void flush_pending();
	void take_into_pages(FieldPatch &patch, int species_index, const std::vector<int> &members);
	void merge_added();
	void show_bends();

	// plant_field_3d_removing.cpp
	void show_removed(const std::vector<bool> &is_affected, const std::vector<std::set<ClumpPlace>> &dirty);

	// plant_field_3d_asking.cpp
	struct Found {
		int patch = -1;
		int plant = -1;
	};
	Found find(int64_t index) const;
	static godot::Transform3D drawn_transform(const PlacedPlant &plant);

	// plant_field_3d_statistics.cpp
	/// As one of the fields that the Performance monitors sum up.
	void count_in_monitors(bool on);

	// plant_field_3d_skeletons.cpp
	/// A plant near the camera.
	struct Near {
		float away; // m; less where it is shown already.
		int patch;
		int plant;
	};
	bool wants_skeletons() const;
	std::vector<Near> find_nearest() const;
	const FieldSkeletons::Shown *find_shown(int patch, int plant) const;
	template <class Test> bool release_skeletons(Test &&goes);
	void skeletons_changed();
	void release_all_skeletons();
	void release_added_skeletons();
	void release_removed_skeletons();
	void hide_shown();
	void show_skeleton(const Near &near);
	bool choose_skeletons();
	glm::vec2 drawn_bend(const FieldPatch &patch, int plant) const;
	void pose_skeletons();

	// plant_field_3d_plant_properties.cpp
	void set_number(double &slot, const char *name, double value, const Range &range, bool needs_fill);
	void set_whole(int &slot, const char *name, int value, const Range &range, bool needs_fill);
	void set_span(godot::Vector2 &slot, const char *name, const godot::Vector2 &value, const Range &range);

protected:
	static void _bind_methods();
	void _notification(int what);
	void _validate_property(godot::PropertyInfo &property) const;

public:
	PlantField3D();
	~PlantField3D() override;
	godot::PackedStringArray _get_configuration_warnings() const override;

	void fill();
	bool is_filling() const;
	void add_plants(const godot::Variant &transforms, const godot::Ref<PlantFunction> &function);
	int remove_in_sphere(const godot::Vector3 &center, double radius);
	bool is_point_in_plants(const godot::Vector3 &point);
	/// Moves the field by `delta` seconds under `blowing` where it does not move by itself, as in the editor.
	void preview(double delta, const godot::Ref<PlantWind> &blowing);
	/// Puts all plants into their rest.
	void reset();
	int apply_impulse_in_sphere(const godot::Vector3 &center, double radius, const godot::Vector3 &impulse);
	int get_plant_count() const;
	godot::Transform3D get_plant_transform(int64_t index);
	godot::Ref<PlantFunction> get_plant_function(int64_t index);
	double get_plant_height(int64_t index);
	int64_t get_plant_seed(int64_t index);
	godot::Vector3 get_tip_position(int64_t index);
	/// The node that shows a plant near the camera; null where it has none.
	godot::Skeleton3D *get_skeleton(int64_t index);
	/// The plant that a skeleton shows now, or -1.
	int64_t get_skeleton_plant(const godot::Skeleton3D *skeleton) const;
	godot::TypedArray<godot::Skeleton3D> get_skeletons() const;
	godot::Dictionary get_statistics();

	// Called by the engine.
	void on_species_changed();
	void on_area_changed();
	void on_wind_changed();
	void on_fill_queued();
	double monitor(int which) const;

	/// The field's outline in its own axes.
	Polygon outline() const;

	void set_species(const godot::TypedArray<PlantFunction> &functions);
	godot::TypedArray<PlantFunction> get_species() const;
	void set_shares(const godot::PackedFloat32Array &weights);
	godot::PackedFloat32Array get_shares() const;
	void set_density(double plants);
	double get_density() const;
	void set_size(const godot::Vector2 &metres);
	godot::Vector2 get_size() const;
	void set_area(const godot::Ref<godot::Curve3D> &curve);
	godot::Ref<godot::Curve3D> get_area() const;
	void set_exclusions(const godot::TypedArray<godot::Curve3D> &curves);
	godot::TypedArray<godot::Curve3D> get_exclusions() const;
	void set_excluded_fields(const godot::TypedArray<godot::NodePath> &paths);
	godot::TypedArray<godot::NodePath> get_excluded_fields() const;
	void set_seed(int64_t seed);
	int64_t get_seed() const;
	void set_clumping(double share);
	double get_clumping() const;
	void set_drift_size(double metres);
	double get_drift_size() const;
	void set_variants(int count);
	int get_variants() const;
	void set_scale_range(const godot::Vector2 &range);
	godot::Vector2 get_scale_range() const;
	void set_height_deviation(double share);
	double get_height_deviation() const;
	void set_lean_deviation_degrees(double degrees);
	double get_lean_deviation_degrees() const;
	void set_ground(GroundKind kind);
	GroundKind get_ground() const;
	void set_ground_mask(int64_t mask);
	int64_t get_ground_mask() const;
	void set_ground_mesh(const godot::NodePath &path);
	godot::NodePath get_ground_mesh() const;
	void set_height_limits(const godot::Vector2 &metres);
	godot::Vector2 get_height_limits() const;
	void set_slope_limits_degrees(const godot::Vector2 &degrees);
	godot::Vector2 get_slope_limits_degrees() const;
	void set_slope_alignment(double share);
	double get_slope_alignment() const;
	void set_wind(const godot::Ref<PlantWind> &new_wind);
	godot::Ref<PlantWind> get_wind() const;
	void set_wind_speed(double speed);
	double get_wind_speed() const;
	void set_simulating(bool on);
	bool is_simulating() const;
	void set_threads(int count);
	int get_threads() const;
	void set_update_interval(int step_count);
	int get_update_interval() const;
	void set_far_distance(double metres);
	double get_far_distance() const;
	void set_prototypes(int count);
	int get_prototypes() const;
	void set_contact(bool on);
	bool has_contact() const;
	void set_bodies_group(const godot::StringName &group);
	godot::StringName get_bodies_group() const;
	void set_touch_margin(double metres);
	double get_touch_margin() const;
	void set_levels(const godot::PackedInt32Array &lods);
	godot::PackedInt32Array get_levels() const;
	void set_level_distances(const godot::PackedFloat32Array &metres);
	godot::PackedFloat32Array get_level_distances() const;
	void set_fade_margin(double metres);
	double get_fade_margin() const;
	void set_shadow_distance(double metres);
	double get_shadow_distance() const;
	void set_visibility_range(double metres);
	double get_visibility_range() const;
	void set_skeleton_distance(double metres);
	double get_skeleton_distance() const;
	void set_most_skeletons(int count);
	int get_most_skeletons() const;
	void set_chunk_size(double metres);
	double get_chunk_size() const;
	void set_layers(int64_t mask);
	int64_t get_layers() const;
};

} // namespace undergrowth

VARIANT_ENUM_CAST(undergrowth::PlantField3D::GroundKind);
