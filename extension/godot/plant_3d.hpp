#pragma once

#include "plant_function.hpp"
#include "plant_simulation.hpp"
#include "plant_wind.hpp"

#include <godot_cpp/classes/mesh_instance3d.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/skeleton3d.hpp>

#include <memory>

namespace undergrowth {

/// One plant: a generated mesh on a skeleton of two bones (thesis, section 4.1), moved by the simulation or by step().
/// Its skeleton and mesh instance are internal children: they are never saved with the scene.
class Plant3D : public godot::Node3D {
	GDCLASS(Plant3D, godot::Node3D)

	// What users set.
	godot::Ref<PlantFunction> function;
	godot::Ref<PlantWind> wind;
	int lod = 12;
	double height = 0.0; // m; 0: the function's own.
	int64_t seed = 0;
	bool simulating = true;

	// What is drawn.
	godot::Skeleton3D *skeleton = nullptr;
	uint64_t mesh_instance = 0; // Instance id: a grandchild may be freed without a word to the plant.
	godot::Ref<godot::ArrayMesh> mesh;
	float built_height = 0.0f; // m; 0 until a mesh was built.
	bool mesh_is_stale = true;
	bool rebuild_is_queued = false;
	godot::String problem; // Why the last build failed; shown as configuration warning.
	godot::String refusal; // Why the last step() did nothing; told once, not in each frame that calls it.

	// How it moves. Either in the simulation (place) or driven by hand (own).
	TipState state; // Valid while in neither.
	bool has_state = false;
	PlantSimulation::Place place;
	std::unique_ptr<PlantGroup> own;
	std::unique_ptr<FixedStep> own_clock;
	double own_time = 0.0; // s, the wind's clock while driven by hand.
	godot::Basis frame; // Axes of the direction: the world's, but for plants on walls and ceilings.
	godot::Basis to_local; // From that frame to the plant's own axes.
	godot::Basis plant_axes; // The node's global axes, without scale.
	float scale_along = 1.0f; // The node's scale along the plant.
	glm::vec3 posed = { 0.0f, 1.0f, 0.0f }; // The direction the bone has now, in the plant's own axes.
	bool is_shown = true;

	// plant_3d_mesh.cpp
	void mark_stale();
	bool build_mesh();
	void make_children();
	void make_mesh_instance();
	void find_children();
	void lose_skeleton();
	void show_mesh();
	godot::MeshInstance3D *get_mesh_instance() const;
	godot::AABB reach() const;
	void report_problem(const godot::String &what);

	// plant_3d_motion.cpp
	bool may_simulate() const;
	Joint joint() const;
	glm::vec3 rest() const;
	TipState current_state() const;
	void park();
	void update_axes();
	void update_joint();
	bool can_be_driven();
	void refuse(const godot::String &what);
	PlantGroup *prepare_own_group();
	void pose_now();

	void on_function_changed();
	void on_wind_changed();
	void on_rebuild_queued();

protected:
	static void _bind_methods();
	void _notification(int what);

public:
	Plant3D() = default;
	~Plant3D() override;
	godot::PackedStringArray _get_configuration_warnings() const override;

	void set_function(const godot::Ref<PlantFunction> &new_function);
	godot::Ref<PlantFunction> get_function() const;
	void set_wind(const godot::Ref<PlantWind> &new_wind);
	godot::Ref<PlantWind> get_wind() const;
	void set_lod(int new_lod);
	int get_lod() const;
	void set_height(double metres);
	double get_height() const;
	void set_seed(int64_t new_seed);
	int64_t get_seed() const;
	void set_simulating(bool on);
	bool is_simulating() const;

	bool rebuild();
	godot::Ref<godot::ArrayMesh> get_mesh();
	godot::Skeleton3D *get_skeleton();
	godot::AABB get_reach();
	double get_plant_height();

	godot::Vector3 get_tip_position() const;
	double get_deflection() const;
	void apply_impulse(const godot::Vector3 &impulse);
	void reset();
	void step(double delta);
	/// Moves the plant as if `blowing` were its wind, at that wind's own clock. Properties stay as they are.
	void preview(double delta, const godot::Ref<PlantWind> &blowing);

	// For PlantSimulation.
	void moved_to(int index) { place.index = index; }
	void leave_simulation();
	void update_simulation();
	/// Turns the tip's bone to `direction` (unit, in the plant's frame).
	void pose(const glm::vec3 &direction);
};

} // namespace undergrowth
