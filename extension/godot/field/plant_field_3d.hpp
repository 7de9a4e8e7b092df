#pragma once

#include "field/field_monitors.hpp"
#include "field/named_plants.hpp"
#include "field/node_watch.hpp"
#include "messages.hpp"

#include <godot_cpp/classes/geometry_instance3d.hpp>
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
		GROUND_OBJECT = int(FieldGround::Kind::object),
	};

	enum GroundHeight : int64_t {
		GROUND_HIGHEST = int(GroundChoice::highest),
		GROUND_LOWEST = int(GroundChoice::lowest),
	};

private:
	/// What a change of a property is about.
	enum class About {
		stand, ///< Plants grow anew.
		area, ///< They do where they may stand now and might not before, or the other way.
		meshes, ///< What stands is dressed anew.
		levels, ///< Distances, and other meshes only where those need them.
		skeletons, ///< They are chosen anew.
		nothing, ///< It is read when it is needed.
	};
	/// A property that is no more than a value in FieldProperties.
	struct Setting {
		const char *name;
		About about;
		Range range; ///< Of numbers; of both in a Vector2, which is a span from x up to y.
	};
	template <class Part, class Value> static Value value_of(Value Part::*); // For decltype.

	FieldProperties properties;
	godot::TypedArray<PlantFieldSpecies> listed; ///< By users. Where it is empty, grass grows.
	Meadow meadow;
	NamedPlants plants{ this, meadow };
	NodeWatch watched; ///< What the area hangs on.
	NodeWatch watched_ground;
	std::vector<uint64_t> seen_species; ///< Of the list, as it was read: scripts may append to it.
	godot::TypedArray<godot::NodePath> seen_exclusions;
	godot::TypedArray<PlantFieldLevel> seen_levels;
	float seen_range = 0.0f;
	uint64_t seen_material = 0;
	godot::String problem;
	godot::String no_ground; ///< What to check.
	bool stand_is_stale = true;
	bool look_is_stale = true;
	bool area_is_stale = false; ///< Paths that keep places free, or give room, are others.
	bool fill_is_queued = false;
	bool end_is_queued = false; ///< Of the frame.
	bool has_told_of_crowd = false;
	double main_usec = 0.0; ///< Of the last frame, without wait_usec.
	double wait_usec = 0.0; ///< For the worker threads, where they took longer than the frame.
	int frames_since_look = 0;

	/// The getter and the setter of a Setting that scripts call. The setter refuses, with an error, what is out of
	/// range, and tells `about` of a real change.
	template <auto slot> auto get() const { return properties.*slot; }
	template <auto slot, const Setting &setting> void set(decltype(value_of(slot)) value);
	/// A method of `plants` as one of the node, for scripts.
	template <auto asked, class Answer, class... Given> Answer ask(Given... given) const {
		return (plants.*asked)(given...);
	}
	template <auto asked, class Answer, class... Given> Answer tell(Given... given) {
		return (plants.*asked)(given...);
	}
	template <auto asked, class Answer, class... Given>
	static constexpr auto of_plants(Answer (NamedPlants::*)(Given...) const) {
		return &PlantField3D::ask<asked, Answer, Given...>;
	}
	template <auto asked, class Answer, class... Given>
	static constexpr auto of_plants(Answer (NamedPlants::*)(Given...)) {
		return &PlantField3D::tell<asked, Answer, Given...>;
	}
	static void bind_properties();
	void changed(About about);
	void mark_stale(bool stand);
	void queue_fill();
	void report_problem(const godot::String &what);
	bool may_simulate() const;
	void follow_frames(bool on);
	/// Whether it stands by its properties. Else it grows anew soon.
	bool is_fresh() const { return is_inside_tree() && !stand_is_stale && !area_is_stale; }
	void poll(double delta, bool physics);
	void queue_end();
	void process_frame();
	void look_around();
	void follow_species();
	void choose_grass();
	void follow_look(const godot::Ref<PlantFunction> &function);
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

	// What stands; of single plants `plants` tells.
	void fill();
	bool is_filling() const;
	int get_plant_count() const { return meadow.store.plant_count(); }
	/// What its species are called in its map; none where others may be by the time that it has grown anew.
	godot::PackedStringArray read_layers() const {
		return is_fresh() ? layers_of(properties) : godot::PackedStringArray();
	}
	/// The field's outline in its own axes.
	Polygon outline_polygon() const;
	godot::PackedVector3Array get_outline_points() const;
	godot::PackedVector3Array get_exclusion_points(int index) const;

	bool apply_changes(const godot::PackedByteArray &bytes);

	// How it moves.
	bool is_point_in_plants(const godot::Vector3 &point) { return plants.is_point_in(point, properties.touch_margin); }
	void reset_motion();
	/// Moves the field by `delta` seconds under `blowing` where it does not move by itself, as in the editor.
	void preview(double delta, const godot::Ref<PlantWind> &blowing);

	// How it is seen.
	int64_t get_skeleton_plant(const godot::Skeleton3D *skeleton) const;
	godot::TypedArray<godot::Skeleton3D> get_skeletons() const;
	godot::Dictionary get_statistics();

	// Called by the engine.
	void on_species_changed();
	bool lists(const godot::Ref<PlantFunction> &function) const;
	void on_added_species_changed();
	void on_levels_changed();
	void on_area_changed();
	void on_ground_changed() { mark_stale(true); }
	void on_wind_changed();
	void on_map_painted(const godot::Rect2 &rect);
	void on_fill_queued();
	void on_tree_frame();
	void on_frame_ending();
	void on_physics_frame();
	void on_frame_drawn();
	void follow_drawing(bool on);
	double monitor(int which) const { return FieldMonitors::sum(which); }

	// What users set, where that is more than a Setting.
	void set_species(const godot::TypedArray<PlantFieldSpecies> &entries);
	godot::TypedArray<PlantFieldSpecies> get_species() const { return listed; }
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
	void set_simulation_enabled(bool on);
	void set_update_interval(int step_count);
	void set_contact_enabled(bool on);
	void set_levels(const godot::TypedArray<PlantFieldLevel> &entries);
};

} // namespace undergrowth

VARIANT_ENUM_CAST(undergrowth::PlantField3D::GroundMode);
VARIANT_ENUM_CAST(undergrowth::PlantField3D::GroundHeight);
