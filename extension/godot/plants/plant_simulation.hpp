#pragma once

#include "base/queued_call.hpp"
#include "bodies/plant_bodies.hpp"
#include "field/canopy_grid.hpp"
#include "motion/fixed_step.hpp"
#include "motion/step_budget.hpp"
#include "motion/swing_clock.hpp"
#include "plants/frame_steps.hpp"
#include "plants/plant_contact.hpp"
#include "plants/plant_group.hpp"
#include "wind/world_air_sources.hpp"

#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/core/object.hpp>

#include <memory>
#include <vector>

namespace undergrowth {

class ClimberMotion;
class PlantField3D;
class PlantFunction;

/// Owns the fixed steps of the running scene and the clocks of its winds. Once a frame, before nodes process, it
/// advances each wind in use and all simulated `Plant3D`s, and poses their bones. Fields run the same steps when they
/// process. An engine singleton. Main thread.
class PlantSimulation : public godot::Object {
	GDCLASS(PlantSimulation, godot::Object)

	std::vector<std::unique_ptr<PlantGroup>> groups;
	std::vector<PlantField3D *> fields; ///< All in the tree.
	std::vector<ClimberMotion *> climbers; ///< That simulate.
	std::vector<godot::Ref<PlantWind>> winds; ///< In use in this frame. A wind may be listed twice.
	BodyReadings body_readings;
	PlantBodies bodies;
	PlantContact contact;
	WorldAirSources air_sources;
	bool are_groups_new = false; ///< Groups were added or removed since the last update of bodies and contact.
	bool is_contact_dirty = false; ///< Plants with contact were added or removed.
	bool has_reported_crowd = false;
	bool is_paused = false; ///< The tree, in this frame.
	size_t next_to_shelter = 0; ///< Plant whose surroundings are read next.
	FixedStep clock;
	StepBudget budget;
	FrameSteps frame; ///< The present one.
	SwingClock swings;
	uint64_t step_number = 0; ///< Of the present step; the first is 1.
	QueuedCall steps_start{ this, "_on_steps_collected" };
	uint64_t connected_tree = 0; ///< Instance id of the scene tree that sends frames.
	double step_time_usec = 0.0;
	double field_time_usec = 0.0; ///< Of the steps of all fields in this frame.
	double pose_time_usec = 0.0;

	PlantGroup *find_group(const PlantKind &kind);
	void drop_empty_groups();
	void follow_groups();
	void record_steps();
	void list_winds();
	void shelter_plants();
	void step_groups(double ago);
	void step(double ago, bool is_first);
	void report_warnings();
	void pose_plants();

protected:
	static void _bind_methods();

public:
	PlantSimulation();
	~PlantSimulation() override;
	static PlantSimulation *get_singleton();

	/// Row of a plant in the simulation.
	struct Place {
		PlantGroup *group = nullptr;
		int index = -1;
	};

	/// Adds a plant at rest, from the next frame on. It must leave before it is freed.
	Place enter(Plant3D *plant, const PlantKind &kind, const MotionPlant &description, const PlantBone &bone);
	/// Removes a plant.
	void leave(const Place &place);
	/// Ends the touches of a plant that leaves the tree, without a signal.
	void forget_touches(const Plant3D *plant) { bodies.forget(plant); }

	/// Adds a field of the tree. It takes part in the steps of a frame if its begin_frame() allows that.
	void enter(PlantField3D *field);
	void leave(PlantField3D *field);
	/// Adds a climber, which steps from the next frame on. It must leave before it is freed.
	void enter(ClimberMotion *climber);
	void leave(ClimberMotion *climber);
	/// Returns the bodies of a group in a world (instance id), in this frame. See BodyReadings::read().
	const BodyReading *read_bodies(const godot::StringName &group, uint64_t world) {
		return body_readings.read(group, world);
	}
	/// What grows around a `Plant3D`: the fields of its world at its place. An isolated plant if none is there.
	PlantCanopy canopy_around(const Plant3D *plant, const godot::Ref<PlantFunction> &species, float height) const;
	/// Sum of a Performance monitor over all fields.
	double read_monitor(int which) const;
	/// The steps of the present frame. They are done for plants and winds before nodes process.
	const FrameSteps &frame_steps() const { return frame; }

	/// Adds µs that the main thread spent on the steps of a field. They count for the number of steps in later frames.
	void add_field_time(double usec) { field_time_usec += usec; }

	/// Simulates `delta` seconds. Called in each frame of the scene tree.
	void advance(double delta);
	void on_process_frame();
	void on_parts_shader_wanted();
	/// Calls StepBatch::start_collected() when all nodes have processed this frame.
	void start_steps_soon() { steps_start.queue(); }
	void on_steps_collected();
	void follow(godot::SceneTree *tree);
	/// Follows the tree of the running game, if there is one.
	static void follow_main_loop();

	int get_plant_count() const;
	double get_step_time_usec() const;
	double get_pose_time_usec() const;
	double get_step_length() const;
	void set_step_length(double seconds);
};

} // namespace undergrowth
