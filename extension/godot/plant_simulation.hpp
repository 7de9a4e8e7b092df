#pragma once

#include "motion/batch.hpp"
#include "motion/fixed_step.hpp"
#include "plant_wind.hpp"

#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/basis.hpp>

#include <memory>
#include <vector>

namespace undergrowth {

class Plant3D;

/// Plants with one law, one wind and one frame, stepped together.
struct PlantGroup {
	PlantGroup(Law law, float step, const godot::Ref<PlantWind> &shared_wind, const godot::Basis &axes);

	PendulumBatch batch;
	godot::Ref<PlantWind> wind; ///< Null: still air.
	godot::Basis frame; ///< Axes of the batch's directions: the world's, but for plants on walls and ceilings.
	std::vector<Plant3D *> plants; ///< plants[i] is the batch's plant i.
	std::vector<glm::vec3> directions; ///< For drawing, one per plant.
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

	PlantGroup *find_group(Law law, const godot::Ref<PlantWind> &wind, const godot::Basis &frame);
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

	/// Takes a plant in, from the next frame on. It must leave before it is freed.
	Place enter(Plant3D *plant, Law law, const godot::Ref<PlantWind> &wind, const godot::Basis &frame,
			const Joint &joint, const TipState &state);
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
