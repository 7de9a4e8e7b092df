#pragma once

#include "driven_plant.hpp"
#include "plant_simulation.hpp"

#include <memory>
#include <optional>

namespace undergrowth {

/// What is moved: all that a page needs of a plant, in world axes.
struct MovedPlant {
	MotionSpecies species;
	godot::Ref<PlantWind> wind; ///< Null: still air.
	PlantPush push;
	glm::vec3 root; ///< m.
	glm::vec3 rest; ///< Where it points at rest, unit.
	float length; ///< m.
};

/// What moves of a plant, in world axes: its state, and where it pointed a step before, as it is drawn.
struct PlantSwing {
	/// All modes of a stem, as a page of these axes has them.
	struct Stem {
		PlantFrame frame;
		int modes;
		StemState now, before;
	};

	TipState now;
	glm::vec3 before;
	StemSecond second = {};
	std::optional<Stem> stem = std::nullopt; ///< Where a page like that goes on with it, it is to the bit.

	static PlantSwing at_rest(const glm::vec3 &rest) { return { { rest, {} }, rest }; }
};

/// How a plant that stands alone moves: on a page of the simulation, on a page of its own that is driven by hand, or
/// not at all (parked). It goes on from one to the other as it moved. Main thread.
class PlantMotion {
public:
	explicit PlantMotion(Plant3D *of) : plant(of) {}
	~PlantMotion() { leave_simulation(); }
	PlantMotion(const PlantMotion &) = delete;
	PlantMotion &operator=(const PlantMotion &) = delete;

	bool is_simulated() const { return place.group != nullptr; }
	/// The simulation moves it from the next frame on.
	void simulate(PlantSimulation *simulation, const MovedPlant &moved);
	/// The simulation gave it another row.
	void moved_to(int index) { place.index = index; }
	/// Takes its motion out of the page that has it.
	void park();
	void leave_simulation();

	/// Whether it has a page of its own, for steps as long as the simulation's.
	bool is_driven() const;
	/// Gives it one. Wind and pushes do not count: who drives it says what blows.
	void drive(const MovedPlant &moved);
	/// A driven plant goes on by `delta` seconds of its own clock.
	void advance(double delta, const godot::Ref<PlantWind> &wind);
	/// The same by `blowing`'s clock.
	void preview(double delta, const godot::Ref<PlantWind> &blowing);
	/// It has another wind.
	void forget_wind() { ear = PlantWind::Listener(); }

	/// Constants, axes, length or place changed; the motion goes on. False where it needs another page of the
	/// simulation, which only simulate() gives.
	bool follow(const MovedPlant &moved);
	/// Whether it is on a page of the simulation for other pushes.
	bool has_other_push(const PlantPush &push) const { return place.group && !(place.group->kind.push == push); }

	/// What moves. `rest` (unit, world axes) is where it points as long as nothing moved it.
	PlantSwing swing(const glm::vec3 &rest) const;
	void set_swing(const PlantSwing &swing);
	/// From the root to a place on a plant that has a page, 0 the root to 1 the tip, in lengths of the plant and world
	/// axes. False of one that is parked.
	bool find_arm(float share, glm::vec3 &arm) const;
	/// Calms it down at `rest`; one that is driven begins anew.
	void reset(const glm::vec3 &rest);
	/// Once: `impulse` in newton seconds, world axes, on one that is simulated or driven.
	void apply_impulse(const glm::vec3 &impulse);
	/// The same on one of its stem's joints, 1 to as many as there are.
	void apply_impulse_at(int joint, const glm::vec3 &impulse);

	/// What shows it: a row of its page, or its own.
	PlantBone &bone();
	/// Its bone turns in these axes of the plant (global, without scale).
	void follow_axes(const godot::Basis &axes);
	/// Poses its bone now, between frames.
	void pose_now(const glm::vec3 &rest);

private:
	Plant3D *plant;
	PlantSimulation::Place place;
	std::unique_ptr<DrivenPlant> driven;
	std::optional<PlantSwing> parked;
	PlantBone own_bone; // While in no page.
	double own_time = 0.0; // s, the wind's clock while driven by hand.
	PlantWind::Listener ear; // For gusts, by that clock.

	PlantGroup *group() const;
	int index() const { return place.group ? place.index : 0; }
	PlantFrame frame() const;
};

} // namespace undergrowth
