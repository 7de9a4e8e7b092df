#pragma once

#include "plants/driven_plant.hpp"
#include "plants/plant_simulation.hpp"

#include <memory>
#include <optional>

namespace undergrowth {

/// The input of a page for one plant, in world axes.
struct MovedPlant {
	MotionSpecies species;
	godot::Ref<PlantWind> wind; ///< Null: still air.
	ForceSettings forces;
	glm::vec3 root; ///< m.
	glm::vec3 rest; ///< Rest direction, unit.
	float length; ///< m.
	float scale, own; ///< As in MotionPlant.
	TallerPlants taller = {}; ///< Of a field around it.
};

/// The motion of a plant, in world axes: its state, and its drawn direction one step before.
struct PlantMotionState {
	/// All modes of a stem, as stored by a page with these axes.
	struct Stem {
		PlantFrame frame;
		int modes;
		StemState now, before;
		glm::vec2 lasting = { 0.0f, 0.0f };
	};

	TipState now;
	glm::vec3 before;
	StemSecond second = {};
	std::optional<Stem> stem = std::nullopt; ///< A page of the same kind continues from it, equal to the bit.

	static PlantMotionState at_rest(const glm::vec3 &rest) { return { { rest, {} }, rest }; }
};

/// The motion of a `Plant3D`: on a page of the simulation, on a page of its own that code advances, or parked (without
/// a page). Every change of these transfers the motion. Main thread.
class PlantMotion {
public:
	explicit PlantMotion(Plant3D *of) : plant(of) {}
	~PlantMotion() { leave_simulation(); }
	PlantMotion(const PlantMotion &) = delete;
	PlantMotion &operator=(const PlantMotion &) = delete;

	bool is_simulated() const { return place.group != nullptr; }
	/// Enters the simulation, which moves the plant from the next frame on.
	void simulate(PlantSimulation *simulation, const MovedPlant &moved);
	/// Sets another row of the simulation.
	void moved_to(int index) { place.index = index; }
	/// Takes the motion out of its page. A stem at rest that nods keeps no state, so that it follows its species.
	void park();
	/// True for a plant without a page that nothing has moved.
	bool is_unmoved() const { return !group() && !parked; }
	void leave_simulation();

	/// True if it has a page of its own, with steps as long as those of the simulation.
	bool is_driven() const;
	/// Creates a page of its own. Wind and pushes of `moved` have no effect: the caller of advance() passes the wind.
	void drive(const MovedPlant &moved);
	/// Advances a driven plant by `delta` seconds of its own clock.
	void advance(double delta, const godot::Ref<PlantWind> &wind);
	/// Advances a driven plant by `delta` seconds of the clock of `blowing`.
	void preview(double delta, const godot::Ref<PlantWind> &blowing);
	/// Resets the gusts. Call when the plant gets another wind.
	void forget_wind() { gust_listener = PlantWind::Listener(); }

	/// Applies changed constants, axes, length or position and preserves the motion. Returns false if this needs
	/// another page of the simulation; call simulate() then.
	bool follow(const MovedPlant &moved);
	/// True if it is on a page of the simulation with other pushes.
	bool has_other_forces(const ForceSettings &forces) const {
		return place.group && !(place.group->kind.forces == forces);
	}

	/// Returns the motion. `rest` (unit, world axes) is its direction until something moves it.
	PlantMotionState motion_state(const glm::vec3 &rest) const;
	void set_motion_state(const PlantMotionState &motion_state);
	/// Sets `arm` to the vector from the root to a point on the plant: from the root (share 0) to the tip (1). The unit
	/// is the length of the plant, in world axes. Returns false for a parked plant.
	bool find_arm(float share, glm::vec3 &arm) const;
	/// Puts the plant at rest. A driven plant starts again.
	void reset();
	/// Applies `impulse` (N·s, world axes) to the tip of a simulated or driven plant.
	void apply_impulse(const glm::vec3 &impulse);
	/// Applies `impulse` to a joint of the stem, 1 to its number of joints.
	void apply_impulse_at(int joint, const glm::vec3 &impulse);

	/// Returns the bone: a row of its page, or its own.
	PlantBone &bone();
	/// Sets the plant's axes for its bone (global, without scale).
	void follow_axes(const godot::Basis &axes);
	/// Poses the bone now, between frames.
	void pose_now(const glm::vec3 &rest);

private:
	Plant3D *plant;
	PlantSimulation::Place place;
	std::unique_ptr<DrivenPlant> driven;
	std::optional<PlantMotionState> parked;
	PlantBone own_bone; // While on no page.
	double own_time = 0.0; // s, clock of the wind for a driven plant.
	PlantWind::Listener gust_listener; // For gusts, by that clock.

	PlantGroup *group() const;
	int index() const { return place.group ? place.index : 0; }
	PlantFrame frame() const;
};

} // namespace undergrowth
