#pragma once

#include "field/field_frames.hpp"
#include "field/field_monitors.hpp"
#include "field/field_problems.hpp"
#include "field/field_staleness.hpp"
#include "field/field_statistics.hpp"
#include "field/named_plants.hpp"
#include "field/species_list.hpp"
#include "field/untold_changes.hpp"
#include "messages.hpp"

#include <godot_cpp/classes/geometry_instance3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

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
		Range range; ///< Of numbers; of both in a Vector2, which is a span from x up to y. Of angles in degrees.
		bool is_angle = false; ///< In radians.
	};
	template <class Part, class Value> static Value value_of(Value Part::*); // For decltype.

	FieldProperties properties;
	SpeciesList species{ this, properties };
	FollowedEntries followed_levels;
	UntoldChanges untold;
	FieldStaleness staleness{ this };
	FieldFrames frames{ this };
	FieldStatistics statistics;
	FieldProblems problems{ this, properties };
	godot::PackedByteArray loaded_changes;
	bool is_unread = false; ///< They could not be applied: the scene keeps them as they are.
	Meadow meadow;
	NamedPlants plants{ this, meadow };

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
	bool may_simulate() const;
	void poll(double delta, bool physics);
	void process_frame();
	void look_around();
	void follow_look(const godot::Ref<PlantFunction> &function);
	void tell_of_bodies();
	void tell_of_skeleton(godot::Skeleton3D *skeleton, bool is_shown);

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

	// What stands; of single plants `plants` tells.
	void rebuild();
	bool is_building() const;
	/// Returns when all of it is built. False where it cannot be.
	bool build_now();
	int get_plant_count() const { return meadow.store.plant_count(); }
	/// What its species are called in its map; none where others may be by the time that it has grown anew.
	godot::PackedStringArray read_layers() const {
		return staleness.is_fresh() ? layers_of(properties) : godot::PackedStringArray();
	}
	/// The field's outline in its own axes.
	Polygon outline_polygon() const;
	godot::PackedVector3Array get_outline_points() const;
	godot::PackedVector3Array get_exclusion_points(int index) const;

	bool apply_changes(const godot::PackedByteArray &bytes);
	/// What the scene keeps of them.
	void set_saved_changes(const godot::PackedByteArray &bytes);
	godot::PackedByteArray get_saved_changes() const;

	// How it moves.
	bool is_point_in_plants(const godot::Vector3 &point) { return plants.is_point_in(point, properties.touch_margin); }
	void reset_motion();
	/// s of the wind's clock: the moment that the states and tips of plants belong to.
	double get_motion_time() const { return meadow.motion.motion_time(); }
	/// Moves the field by `delta` seconds under `blowing` where it does not move by itself, as in the editor.
	void preview(double delta, const godot::Ref<PlantWind> &blowing);

	// How it is seen.
	int64_t get_skeleton_plant(const godot::Skeleton3D *skeleton) const;
	godot::TypedArray<godot::Skeleton3D> get_skeletons() const;
	godot::Dictionary get_statistics();

	// Called by the engine.
	void on_species_changed();
	void on_added_species_changed();
	void on_levels_changed();
	void on_area_changed();
	void on_ground_changed() { staleness.mark_stand(); }
	void on_wind_changed();
	void on_map_painted(const godot::Rect2 &rect);
	void on_fill_queued();
	void on_tree_frame();
	void on_frame_ending();
	void on_physics_frame();
	void on_frame_drawn();
	double monitor(int which) const { return FieldMonitors::sum(which); }

	// What users set, where that is more than a Setting.
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
	void set_simulation_enabled(bool on);
	void set_update_interval(int step_count);
	void set_contact_enabled(bool on);
	void set_levels(const godot::TypedArray<PlantFieldLevel> &entries);
};

} // namespace undergrowth

VARIANT_ENUM_CAST(undergrowth::PlantField3D::GroundMode);
VARIANT_ENUM_CAST(undergrowth::PlantField3D::GroundHeight);
