#pragma once

#include "base/messages.hpp"
#include "field/dependency_poller.hpp"
#include "field/field_dirty_flags.hpp"
#include "field/field_frames.hpp"
#include "field/field_monitors.hpp"
#include "field/field_problems.hpp"
#include "field/field_statistics.hpp"
#include "field/plant_queries.hpp"
#include "field/resources/species_list.hpp"

#include <godot_cpp/classes/geometry_instance3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

namespace undergrowth {

/// A node of thousands of plants, each with its own motion, drawn as multimeshes that bend in the vertex shader. It
/// contains the users' properties and passes changes to its FieldRuntime. A change affects only what it concerns: the
/// plants, the motion or the view.
class PlantField3D : public godot::GeometryInstance3D {
	GDCLASS(PlantField3D, godot::GeometryInstance3D)

public:
	enum GroundMode : int64_t {
		GROUND_NONE = int(FieldGround::Kind::none),
		GROUND_COLLIDERS = int(FieldGround::Kind::colliders),
		GROUND_MESH = int(FieldGround::Kind::mesh),
		GROUND_OBJECT = int(FieldGround::Kind::object),
	};

	enum GroundHeight : int64_t {
		GROUND_HIGHEST = int(GroundChoice::highest),
		GROUND_LOWEST = int(GroundChoice::lowest),
	};

private:
	/// The effect of a change of a property.
	enum class About {
		placement, ///< Rebuilds all plants.
		area, ///< Rebuilds plants only between the old and the new area.
		meshes, ///< Rebuilds only the styles.
		levels, ///< Updates distances, and meshes only if necessary.
		skeletons, ///< Chooses skeletons again.
		nothing, ///< No effect until it is read.
	};
	/// A property that is only a value in FieldProperties.
	struct Setting {
		const char *name;
		About about;
		Range range; ///< Of numbers, in degrees for angles. In a Vector2 it limits both, and x is at most y.
		bool is_angle = false; ///< The value is in radians, and the range in degrees.
	};
	template <class Part, class Value> static Value value_of(Value Part::*); // For decltype.

	FieldProperties properties;
	SpeciesList species{ this, properties };
	FollowedEntries followed_levels;
	DependencyPoller dependencies;
	FieldDirtyFlags dirty{ this };
	FieldFrames frames{ this };
	FieldStatistics statistics;
	FieldProblems problems{ this, properties };
	godot::PackedByteArray loaded_changes;
	uint64_t begun_frame = 0; ///< Number of the last frame whose steps it takes part in.
	bool is_unread = false; ///< They could not be applied, so the scene saves them unchanged.
	FieldRuntime runtime;
	PlantQueries plants{ this, runtime };

	/// The getter and the setter of a Setting, for scripts. The setter rejects values out of range with an error, and
	/// reports a real change to changed().
	template <auto slot> auto get() const { return properties.*slot; }
	template <auto slot, const Setting &setting> void set(decltype(value_of(slot)) value);
	/// Makes a method of `plants` a method of the node, for scripts.
	template <auto method, class Answer, class... Given> Answer call_const(Given... given) const {
		return (plants.*method)(given...);
	}
	template <auto method, class Answer, class... Given> Answer call_method(Given... given) {
		return (plants.*method)(given...);
	}
	template <auto method, class Answer, class... Given>
	static constexpr auto of_plants(Answer (PlantQueries::*)(Given...) const) {
		return &PlantField3D::call_const<method, Answer, Given...>;
	}
	template <auto method, class Answer, class... Given>
	static constexpr auto of_plants(Answer (PlantQueries::*)(Given...)) {
		return &PlantField3D::call_method<method, Answer, Given...>;
	}
	static void bind_properties();
	void changed(About about);
	bool may_simulate() const;
	void follow_simulation();
	void poll(double delta, bool physics);
	void process_frame();
	void poll_dependencies();
	void update_style(const godot::Ref<PlantFunction> &function);
	void change_materials();
	void report_bodies();
	void report_skeleton(godot::Skeleton3D *skeleton, bool is_shown);

protected:
	static void _bind_methods();
	void _notification(int what);
	bool _set(const godot::StringName &name, const godot::Variant &value);
	void _validate_property(godot::PropertyInfo &property) const;

public:
	PlantField3D();
	~PlantField3D() override;
	static PlantField3D *from_species(const godot::Array &functions, const godot::PackedFloat32Array &weights);
	godot::PackedStringArray _get_configuration_warnings() const override;
	godot::AABB _get_aabb() const override;

	// Plants. `plants` has the methods for single ones.
	void rebuild();
	bool is_building() const;
	/// Returns when everything is built. Returns false if that is not possible.
	bool build_now();
	int get_plant_count() const { return runtime.store.plant_count(); }
	/// Names of its species in its map. Empty while a build is due, because it may change the species.
	godot::PackedStringArray read_layers() const {
		return dirty.is_clean() ? layers_of(properties) : godot::PackedStringArray();
	}
	/// The field's outline in its own axes.
	Polygon outline_polygon() const;
	godot::PackedVector3Array get_outline_points() const;
	godot::PackedVector3Array get_exclusion_points(int index) const;

	bool apply_changes(const godot::PackedByteArray &bytes);
	/// The edits that the scene saves.
	void set_saved_changes(const godot::PackedByteArray &bytes);
	godot::PackedByteArray get_saved_changes() const;

	// Motion.
	/// What grows around a plant of `height` metres of this species at a world position.
	PlantCanopy canopy_around(
			const godot::Vector3 &place, const godot::Ref<PlantFunction> &function, float height) const;
	bool is_point_in_plants(const godot::Vector3 &point) { return plants.is_point_in(point, properties.touch_margin); }
	godot::Vector3 sample_velocity(const godot::Vector3 &root, double height);
	void reset_motion();
	/// s of the wind's clock, of the states and tips of plants.
	double get_motion_time() const { return runtime.motion.motion_time(); }
	/// Moves the field by `delta` seconds under `blowing`, if it does not move by itself, as in the editor.
	void preview(double delta, const godot::Ref<PlantWind> &blowing);
	/// Sets a configuration warning of the editor's plugin, which finds the ground. Empty: none.
	void advise(const godot::String &text) { problems.advise_on_place(text); }

	// View.
	int64_t get_skeleton_plant(const godot::Skeleton3D *skeleton) const;
	godot::TypedArray<godot::Skeleton3D> get_skeletons() const;
	godot::Dictionary get_statistics();

	/// Called by PlantSimulation before nodes process in frame `number`. Returns true if the field takes part in the
	/// steps of this frame.
	bool begin_frame(uint64_t number);
	/// Value of a Performance monitor, by its index.
	double read_monitor(int which) const { return FieldMonitors::read(runtime, which); }
	/// Called by PlantSimulation when its steps have another length.
	void on_step_length_changed() { dirty.mark_style(); }

	// Called by the engine.
	void on_species_changed();
	void on_added_species_changed();
	void on_levels_changed();
	void on_area_changed();
	void on_ground_changed();
	void on_wind_changed();
	void on_map_painted(const godot::Rect2 &rect);
	void on_rebuild_queued();
	void on_tree_frame();
	void on_frame_ending();
	void on_physics_frame();
	void on_frame_drawn();

	// Users' properties that are not only a Setting.
	void set_species(const godot::TypedArray<PlantFieldSpecies> &entries);
	godot::TypedArray<PlantFieldSpecies> get_species() const { return species.get(); }
	void set_size(const godot::Vector2 &metres);
	void set_view_distance(double metres);
	void set_endless(bool on);
	void set_outline(const godot::NodePath &path);
	void set_exclusions(const godot::TypedArray<godot::NodePath> &paths);
	void set_exclusion_widths(const godot::PackedFloat32Array &metres);
	void set_map(const godot::Ref<PlantMap> &painted);
	void set_ground_mode(GroundMode mode);
	GroundMode get_ground_mode() const { return GroundMode(properties.ground_mode); }
	void set_ground_choice(GroundHeight choice);
	GroundHeight get_ground_choice() const { return GroundHeight(properties.ground_choice); }
	void set_wind(const godot::Ref<PlantWind> &wind);
	const godot::Ref<PlantWind> &get_wind() const { return properties.wind; }
	void set_simulation_enabled(bool on);
	void set_update_interval(int step_count);
	void set_contact_enabled(bool on);
	void set_levels(const godot::TypedArray<PlantFieldLevel> &entries);
};

} // namespace undergrowth

VARIANT_ENUM_CAST(undergrowth::PlantField3D::GroundMode);
VARIANT_ENUM_CAST(undergrowth::PlantField3D::GroundHeight);
