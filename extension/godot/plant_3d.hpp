#pragma once

#include "plant_function.hpp"
#include "plant_simulation.hpp"
#include "plant_wind.hpp"

#include <godot_cpp/classes/mesh_instance3d.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/skeleton3d.hpp>
#include <godot_cpp/classes/skin_reference.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>

#include <memory>

namespace undergrowth {

/// One plant: a generated mesh on a skeleton of two bones (thesis, section 4.1) and those of its parts, moved by the
/// simulation or by advance(). Its skeleton and mesh instance are internal children: they are never saved with the
/// scene.
class Plant3D : public godot::Node3D {
	GDCLASS(Plant3D, godot::Node3D)

	/// What moves of a plant, in world axes: its state, and where it pointed a step before, as it is drawn.
	struct Swing {
		TipState now;
		glm::vec3 before = { 0.0f, 1.0f, 0.0f };
	};
	/// A plant that is driven by hand: a page of its own, and its own clock.
	struct Driven {
		Driven(const PlantKind &kind, double step) : group(kind, float(step)), clock(step, MOST_STEPS_OF_CALL) {}
		static constexpr int MOST_STEPS_OF_CALL = 128;
		PlantGroup group;
		FixedStep clock;
		SwingClock swings;
	};

	// What users set.
	godot::Ref<PlantFunction> species;
	godot::Ref<PlantWind> wind;
	int segments = 12;
	double height = 0.0; // m; 0: the species' own.
	int64_t seed = 0;
	bool simulation_enabled = true;
	bool contact_enabled = false;
	godot::StringName bodies_group;
	double touch_margin = 0.1; // m.

	// What is drawn.
	godot::Skeleton3D *skeleton = nullptr;
	uint64_t mesh_instance = 0; // Instance id: a grandchild may be freed without a word to the plant.
	godot::Ref<godot::SkinReference> drawn; // The renderer's skeleton, which must not go before its id here.
	bool skeleton_is_held = false; // Somebody asked for it.
	godot::Ref<godot::ArrayMesh> mesh;
	std::unique_ptr<PartSkeleton> parts; // Of a plant of parts that swing.
	float built_height = 0.0f; // m; 0 until a mesh was built.
	bool mesh_is_stale = true;
	bool rebuild_is_queued = false;
	godot::String problem; // Why the last build failed; shown as configuration warning.
	godot::String refusal; // Why the last advance() did nothing; told once, not in each frame that calls it.

	// How it moves: on a page of the simulation (place), on its own (driven), or not at all (parked).
	Swing parked;
	bool has_swing = false;
	PlantSimulation::Place place;
	std::unique_ptr<Driven> driven;
	double own_time = 0.0; // s, the wind's clock while driven by hand.
	PlantWind::Listener ear; // For gusts, by that clock.
	PlantFrame frame = PlantFrame::WORLD;
	PlantBone own_bone; // While in no page.
	godot::Basis plant_axes; // The node's global axes, without scale.
	glm::vec3 root = { 0.0f, 0.0f, 0.0f }; // m, world axes.
	float scale_along = 1.0f; // The node's scale along the plant.

	// plant_3d_mesh.cpp
	void mark_stale();
	bool build_mesh();
	void make_children();
	void make_mesh_instance();
	void find_children();
	void lose_skeleton();
	void find_drawn();
	void show_mesh();
	void set_up_bones();
	godot::MeshInstance3D *get_mesh_instance() const;
	godot::AABB reach() const;
	void report_problem(const godot::String &what);

	// plant_3d_motion.cpp
	bool may_simulate() const;
	MotionSpecies motion() const;
	PlantPush what_pushes() const;
	MotionPlant description() const;
	godot::Vector3 rest() const;
	Swing swing() const;
	void set_swing(const Swing &swing);
	PlantGroup *page_group() const;
	int page_index() const { return place.group ? place.index : 0; }
	PlantBone &bone();
	void park();
	void update_axes();
	void update_motion();
	void update_bone();
	void pose_now();

	// plant_3d_pushes.cpp
	void change_pushes();
	void forget_touches();

	// plant_3d_driving.cpp
	bool can_be_driven();
	void refuse(const godot::String &what);
	Driven &prepare_driven();

	void on_species_changed();
	void on_wind_changed();
	void on_rebuild_queued();

protected:
	static void _bind_methods();
	void _notification(int what);

public:
	Plant3D() = default;
	~Plant3D() override;
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

	bool rebuild();
	godot::Ref<godot::ArrayMesh> get_mesh();
	godot::Skeleton3D *get_skeleton();
	godot::AABB get_reach();
	double get_plant_height();

	godot::Vector3 get_tip_position() const;
	double get_deflection() const;
	bool is_point_in_plants(const godot::Vector3 &point) const;
	void apply_impulse(const godot::Vector3 &impulse);
	void reset_motion();
	/// Direction and rate of the tip, six floats in the plant's own axes.
	godot::PackedFloat32Array get_motion_state() const;
	void set_motion_state(const godot::PackedFloat32Array &state);
	void advance(double delta);
	/// Moves the plant as if `blowing` were its wind, at that wind's own clock. Properties stay as they are.
	void preview(double delta, const godot::Ref<PlantWind> &blowing);

	// For PlantSimulation.
	void moved_to(int index) { place.index = index; }
	bool is_in_simulation() const { return place.group != nullptr; }
	void leave_simulation();
	void update_simulation();
	/// A body, by its instance id, came among the plant or left it.
	void tell_of_body(uint64_t body, bool has_entered);
};

} // namespace undergrowth
