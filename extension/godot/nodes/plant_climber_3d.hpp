#pragma once

#include "base/messages.hpp"
#include "base/queued_call.hpp"
#include "base/worker_task.hpp"
#include "climb/climber_build.hpp"
#include "climb/climber_motion.hpp"
#include "climb/climber_supports.hpp"
#include "climb/climber_view.hpp"
#include "species/plant_function.hpp"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <memory>

namespace undergrowth {

/// A climbing plant: stems that grow from the node over the surfaces of its supports, and their leaves. A worker grows
/// it by its seed and settings; scenes store only these. It owns its surfaces (ClimberSupports), its motion
/// (ClimberMotion) and its drawing (ClimberView).
class PlantClimber3D : public godot::Node3D {
	GDCLASS(PlantClimber3D, godot::Node3D)

	// Properties that users set.
	ClimbSettings settings; ///< Without root, path and directions, which are read when it grows.
	godot::Ref<PlantFunction> species;
	godot::Ref<PlantWind> wind;
	godot::TypedArray<godot::NodePath> supports;
	godot::PackedVector3Array path; // m, the node's axes.
	godot::Vector3 light_direction = { 0.0f, 1.0f, 0.0f }; // World axes.
	double leaf_size = 1.0;
	int64_t seed = 0;
	bool simulation_enabled = true;
	godot::Ref<godot::Material> stem_material;
	int64_t layers = 1;
	bool cast_shadows = true;

	// Components and state.
	ClimberSupports bodies;
	ClimberView view;
	ClimberMotion motion;
	std::unique_ptr<ClimberBuild> build; ///< In the worker, or null.
	godot::Transform3D growth; ///< From the axes of growth to the world's, when it grew.
	ClimberSupports growing_bodies; ///< Of `build`.
	godot::Transform3D growing; ///< `growth` of `build`.
	godot::Transform3D followed; ///< Own transform in the last frame.
	std::vector<ClimbLeaf> leaves;
	std::vector<int> cells_of_leaves;
	std::vector<godot::Transform3D> places; ///< From the axes of growth to the world's, by body.
	float stem_length = 0.0f; ///< m.
	double grow_usec = 0.0;
	double main_thread_usec = 0.0;
	godot::Array levels; ///< Dictionaries of get_statistics().
	int stem_vertices = 0;
	godot::Ref<PlantFunction> shown_species;
	float shown_height = 0.1f; ///< m, of a leaf's plant.
	bool is_dirty = true;
	bool wind_is_air = false;
	godot::String problem;
	ClimbSupport picked; ///< World axes: surfaces for pick().
	QueuedCall rebuild_call{ this, "_on_rebuild_queued" };
	WorkerTask task; // Declared after the data that it uses, so it is destroyed first.

	void mark_dirty();
	void report_problem(const godot::String &what);
	godot::Ref<PlantFunction> used_species() const;
	bool start();
	godot::String prepare(ClimberBuild &into);
	void adopt();
	void list_levels(const ClimberBuild &grown);
	void process_frame();
	void follow_supports();
	void place_all();
	void update_motion();
	void update_simulation();
	bool may_simulate() const;
	MotionSpecies kind_of_motion(const godot::Ref<PlantFunction> &of, float height) const;
	template <class Number> void set_number(Number &slot, const char *property, double value, const Range &range);
	static void bind_growth();
	static void bind_queries();

protected:
	static void _bind_methods();
	void _notification(int what);

public:
	PlantClimber3D() = default;
	~PlantClimber3D() override;
	godot::PackedStringArray _get_configuration_warnings() const override;

	void set_species(const godot::Ref<PlantFunction> &leaf);
	godot::Ref<PlantFunction> get_species() const { return species; }
	void set_wind(const godot::Ref<PlantWind> &new_wind);
	godot::Ref<PlantWind> get_wind() const { return wind; }
	void set_supports(const godot::TypedArray<godot::NodePath> &paths);
	godot::TypedArray<godot::NodePath> get_supports() const { return supports; }
	void set_path(const godot::PackedVector3Array &points);
	godot::PackedVector3Array get_path_points() const { return path; }
	void set_seed(int64_t new_seed);
	int64_t get_seed() const { return seed; }
	void set_shoots(int count);
	int get_shoots() const { return settings.shoots; }
	void set_length(double metres);
	double get_length() const;
	void set_branching(double per_metre);
	double get_branching() const;
	void set_branch_length(double share);
	double get_branch_length() const;
	void set_stem_spacing(double metres);
	double get_stem_spacing() const;
	void set_stem_diameter(double metres);
	double get_stem_diameter() const;
	void set_leaf_spacing(double metres);
	double get_leaf_spacing() const;
	void set_leaf_size(double scale);
	double get_leaf_size() const { return leaf_size; }
	void set_light_direction(const godot::Vector3 &direction);
	godot::Vector3 get_light_direction() const { return light_direction; }
	void set_light_weight(double weight);
	double get_light_weight() const;
	void set_gravity_weight(double weight);
	double get_gravity_weight() const;
	void set_random_weight(double weight);
	double get_random_weight() const;
	void set_adhesion_distance(double metres);
	double get_adhesion_distance() const;
	void set_max_hanging(double metres);
	double get_max_hanging() const;
	void set_simulation_enabled(bool enabled);
	bool is_simulation_enabled() const { return simulation_enabled; }
	void set_stem_material(const godot::Ref<godot::Material> &material);
	godot::Ref<godot::Material> get_stem_material() const { return stem_material; }
	void set_layers(int64_t mask);
	int64_t get_layers() const { return layers; }
	void set_cast_shadows(bool on);
	bool is_cast_shadows() const { return cast_shadows; }

	bool rebuild();
	bool is_growing() const { return build != nullptr; }
	int get_leaf_count() const { return int(leaves.size()); }
	double get_stem_length() const { return double(stem_length); }
	godot::Transform3D get_leaf_transform(int leaf) const;
	double get_leaf_deflection(int leaf) const;
	godot::AABB get_reach() const;
	godot::Dictionary get_statistics() const;
	void reset_motion();
	/// Returns the first point of a support on a ray (world axes), or nil. `is_first`: reads the surfaces again. For
	/// the editor.
	godot::Variant pick(const godot::Vector3 &from, const godot::Vector3 &direction, bool is_first);
	void preview(double delta, const godot::Ref<PlantWind> &blowing);

	// Called by the engine.
	void on_rebuild_queued();
	void on_species_changed();
	void on_wind_changed();
};

} // namespace undergrowth
