#pragma once

#include "bodies/plant_bodies.hpp"
#include "motion/fixed_step.hpp"
#include "motion/swing_clock.hpp"
#include "plant_contact.hpp"
#include "plant_group.hpp"
#include "stirred_worlds.hpp"

#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/core/object.hpp>

#include <memory>
#include <vector>

namespace undergrowth {

/// Steps all simulating plants of the running scene together, once a frame and in fixed steps, and poses their bones.
/// An engine singleton. Main thread only.
class PlantSimulation : public godot::Object {
	GDCLASS(PlantSimulation, godot::Object)

	std::vector<std::unique_ptr<PlantGroup>> groups;
	PlantBodies bodies;
	PlantContact contact;
	StirredWorlds stirred;
	bool are_groups_new = false; ///< Groups came or went since bodies and contact were told.
	bool is_contact_stale = false; ///< Plants that touch did.
	bool has_told_of_crowd = false;
	FixedStep clock;
	SwingClock swings;
	uint64_t step_number = 0; ///< Of the present step; the first is 1.
	uint64_t connected_tree = 0; ///< Instance id of the scene tree whose frames we follow.
	double step_time_usec = 0.0;
	double pose_time_usec = 0.0;

	PlantGroup *find_group(const PlantKind &kind);
	void drop_empty_groups();
	void follow_groups();
	void step_groups(double ago);
	void step(double ago, bool is_first);
	void tell_of_pushes();
	void pose_plants();

protected:
	static void _bind_methods();

public:
	PlantSimulation();
	~PlantSimulation() override;
	static PlantSimulation *get_singleton();

	/// Where a plant stands in the simulation.
	struct Place {
		PlantGroup *group = nullptr;
		int index = -1;
	};

	/// Takes a plant in, from the next frame on, at rest. It must leave before it is freed.
	Place enter(Plant3D *plant, const PlantKind &kind, const MotionPlant &description, const PlantBone &bone);
	/// Lets a plant go.
	void leave(const Place &place);
	/// A plant that leaves the tree is touched by nobody, without a word.
	void forget_touches(const Plant3D *plant) { bodies.forget(plant); }

	/// Simulates `delta` seconds; the scene tree's frames call it.
	void advance(double delta);
	void on_process_frame();
	void on_parts_shader_wanted();
	void follow(godot::SceneTree *tree);

	int get_plant_count() const;
	double get_step_time_usec() const;
	double get_pose_time_usec() const;
	double get_step_length() const;
	void set_step_length(double seconds);
};

} // namespace undergrowth
