#pragma once

#include "motion/fixed_step.hpp"
#include "motion/motion_page.hpp"
#include "plant_bone.hpp"
#include "plant_frame.hpp"
#include "plant_wind.hpp"

#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/core/object.hpp>

#include <memory>
#include <vector>

namespace undergrowth {

class Plant3D;

/// Plants of one species, one wind and one frame: a page that is stepped together, and the bones that show it.
struct PlantGroup {
	PlantGroup(const MotionSpecies &motion, const godot::Ref<PlantWind> &shared_wind, PlantFrame axes, float step);

	MotionSpecies species;
	godot::Ref<PlantWind> wind; ///< Null: still air.
	PlantFrame frame; ///< Axes of the page's directions; its roots are in the world's.
	MotionPage page;
	std::vector<Plant3D *> plants; ///< plants[i] is the page's plant i; touched only where plants come and go.
	std::vector<PlantBone> bones; ///< As many.
	std::vector<glm::vec3> directions; ///< As many, for drawing.

	/// One step that begins when the wind's clock shows `start` (s).
	void step(const FieldWind &air, double start);
	/// Turns all bones to where their plants point, `alpha` of the way of the last step.
	void pose(float alpha);
};

/// Steps all simulating plants of the running scene together, once a frame and in fixed steps, and poses their bones.
/// An engine singleton. Main thread only.
class PlantSimulation : public godot::Object {
	GDCLASS(PlantSimulation, godot::Object)

	std::vector<std::unique_ptr<PlantGroup>> groups;
	FixedStep clock;
	uint64_t step_number = 0; ///< Of the present step; the first is 1.
	uint64_t connected_tree = 0; ///< Instance id of the scene tree whose frames we follow.
	double step_time_usec = 0.0;
	double pose_time_usec = 0.0;

	PlantGroup *find_group(const MotionSpecies &species, const godot::Ref<PlantWind> &wind, PlantFrame frame);
	void drop_empty_groups();
	void step_groups();
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
	Place enter(Plant3D *plant, const MotionSpecies &species, const godot::Ref<PlantWind> &wind, PlantFrame frame,
			const MotionPlant &description, const PlantBone &bone);
	/// Lets a plant go.
	void leave(const Place &place);

	/// Simulates `delta` seconds; the scene tree's frames call it.
	void advance(double delta);
	void on_process_frame();
	void follow(godot::SceneTree *tree);

	int get_plant_count() const;
	double get_step_time_usec() const;
	double get_pose_time_usec() const;
	double get_step_length() const;
	void set_step_length(double seconds);
};

} // namespace undergrowth
