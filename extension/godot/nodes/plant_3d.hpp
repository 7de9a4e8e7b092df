#pragma once

#include "base/queued_call.hpp"
#include "plants/plant_motion.hpp"
#include "plants/plant_transform.hpp"
#include "plants/plant_view.hpp"
#include "species/plant_function.hpp"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>

namespace undergrowth {

/// One plant: a generated mesh on a skeleton of two bones (thesis, section 4.1) and the bones of its parts. The
/// simulation or advance() moves it. It owns its position (PlantTransform), its motion (PlantMotion) and its drawing
/// (PlantView).
class Plant3D : public godot::Node3D {
	GDCLASS(Plant3D, godot::Node3D)

	// Properties that users set.
	godot::Ref<PlantFunction> species;
	godot::Ref<PlantWind> wind;
	int segments = 12;
	double height = 0.0; // m; 0: the height that the species generates.
	int64_t seed = 0;
	bool simulation_enabled = true;
	bool contact_enabled = false;
	godot::StringName bodies_group;
	double touch_margin = 0.1; // m.
	double apparent_wind = 1.0;

	// Components and state.
	PlantTransform plant_transform;
	PlantCanopy canopy; ///< Of fields around it.
	PlantMotion motion{ this };
	PlantView view{ this, motion };
	bool mesh_is_dirty = true;
	QueuedCall rebuild_call{ this, "_on_rebuild_queued" };
	godot::String problem; // Why the last build failed. Shown as a configuration warning.
	bool wind_is_air = false; // The last wind was in m/s.
	godot::String refusal; // Why the last advance() had no effect. Reported once, not in each frame.

	// plant_3d_properties.cpp
	/// Returns the stem of a plant of `metres` here; null under other laws than the stem law.
	std::shared_ptr<const StemConstants> find_stem(float metres) const;
	MotionSpecies kind_of_motion() const;
	ForceSettings force_settings() const;
	MovedPlant moved() const;
	glm::vec3 rest() const;
	void mark_dirty();
	void on_rebuild_queued();
	void on_species_changed();
	void on_wind_changed();
	void update_wind_kind(const godot::Ref<PlantWind> &blowing);
	void update_forces();

	// plant_3d.cpp
	void read_canopy();
	bool build_mesh();
	void report_problem(const godot::String &what);
	void update_axes();
	void update_motion();
	void bend_at_rest();
	void update_bone();
	bool may_simulate() const;
	bool can_be_driven();
	void drive();
	void refuse(const godot::String &what);
	void forget_touches();

	// plant_3d_binding.cpp
	/// Returns the position at `share` of the plant's length, in its own axes. The unit is its height.
	godot::Vector3 arm(float share) const;

protected:
	static void _bind_methods();
	void _notification(int what);

public:
	Plant3D() = default;
	godot::PackedStringArray _get_configuration_warnings() const override;

	void set_species(const godot::Ref<PlantFunction> &new_species);
	godot::Ref<PlantFunction> get_species() const;
	void set_wind(const godot::Ref<PlantWind> &new_wind);
	godot::Ref<PlantWind> get_wind() const;
	void set_segments(int count);
	int get_segments() const;
	void set_height(double metres);
	double get_height() const;
	void set_seed(int64_t new_seed);
	int64_t get_seed() const;
	void set_simulation_enabled(bool enabled);
	bool is_simulation_enabled() const;
	void set_contact_enabled(bool on);
	bool is_contact_enabled() const;
	void set_bodies_group(const godot::StringName &group);
	godot::StringName get_bodies_group() const;
	void set_touch_margin(double metres);
	double get_touch_margin() const;
	void set_apparent_wind(double share);
	double get_apparent_wind() const;

	bool rebuild();
	godot::Ref<godot::ArrayMesh> get_mesh();
	godot::Skeleton3D *get_skeleton();
	godot::AABB get_reach();
	double get_plant_height();

	int get_joint_count();
	godot::Vector3 get_joint_position(int joint) const;
	godot::Vector3 get_tip_position() const;
	double get_deflection() const;
	bool is_point_in_plants(const godot::Vector3 &point) const;
	void apply_impulse(const godot::Vector3 &impulse, int joint = -1);
	void reset_motion();
	/// Direction and rate of the tip, six floats in the plant's own axes.
	godot::PackedFloat32Array get_motion_state() const;
	void set_motion_state(const godot::PackedFloat32Array &state);
	void advance(double delta);
	/// Moves the plant as if `blowing` were its wind, at that wind's clock. Properties do not change.
	void preview(double delta, const godot::Ref<PlantWind> &blowing);

	// For PlantSimulation.
	void moved_to(int index) { motion.moved_to(index); }
	bool is_in_simulation() const { return motion.is_simulated(); }
	void leave_simulation() { motion.leave_simulation(); }
	void update_simulation();
	/// Reads what grows around the plant, which shelters it from air.
	void update_canopy();
	/// Reports that a body, given by its instance id, came among the plant or left it.
	void report_body(uint64_t body, bool has_entered);
};

} // namespace undergrowth
