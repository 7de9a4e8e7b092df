#pragma once

#include "bodies/group_bodies.hpp"
#include "plant_group.hpp"

#include <memory>
#include <vector>

namespace undergrowth {

/// Bodies that push plants which stand alone. Each group of bodies is read once in a frame, however many plants name
/// it. Main thread.
class PlantBodies {
public:
	/// Whenever groups of plants came or went: which there are.
	void follow(const std::vector<std::unique_ptr<PlantGroup>> &groups);
	/// Whether there is anything to do: plants that name a group, or plants that were touched.
	bool are_needed() const { return are_named || !touches.empty(); }
	/// Once in every frame, of `delta` seconds: notes where bodies are.
	void watch(godot::SceneTree *tree, double delta);
	/// Before a step whose time is `ago` seconds before this frame: what pushes in it.
	void gather(double ago);
	/// After the plants moved in it.
	void push();
	/// Tells plants of bodies that came among them, or left them, by what gather() found last.
	void tell_of_touches();
	/// A plant that leaves the tree is touched by nobody, without a word.
	void forget(const Plant3D *plant);
	/// What is amiss, with what to do; each once.
	std::vector<godot::String> take_warnings();

private:
	/// The bodies of a group in one world, and the plants there that name it.
	struct Reading {
		godot::StringName name;
		uint64_t world = 0; ///< Instance id.
		GroupBodies bodies;
		std::vector<PlantGroup *> groups;
		const std::vector<MovingBody> *shapes = nullptr; ///< Of the present step.
	};
	/// A body that touches a plant, by their instance ids: either may be freed by now.
	struct Touch {
		uint64_t plant;
		uint64_t body;
		bool operator<(const Touch &other) const;
	};

	std::vector<Reading> readings;
	std::vector<Touch> touches; ///< In rising order.
	std::vector<Touch> found; ///< In this frame; kept for its memory.
	bool are_named = false;

	Reading &reading_of(const PlantPush &push);
	void find(const Reading &reading, const PlantGroup &group);
	void tell_of_end(const Touch &touch);
};

} // namespace undergrowth
