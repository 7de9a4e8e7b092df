#pragma once

#include "bodies/group_bodies.hpp"
#include "plants/plant_group.hpp"

#include <memory>
#include <vector>

namespace undergrowth {

/// Bodies that push `Plant3D`s. Each group of bodies is tracked once, for any number of plants. Main thread.
class PlantBodies {
public:
	/// Updates the groups of plants. Call when one was added or removed.
	void follow(const std::vector<std::unique_ptr<PlantGroup>> &groups);
	/// True if plants have a group of bodies, or plants were touched.
	bool are_needed() const { return are_named || !touches.empty(); }
	/// Follows the bodies of `engine`. Call once in every frame, of `delta` seconds.
	void watch(BodyReadings &engine, double delta);
	/// Gathers the shapes for a step at `ago` seconds before this frame. Call before the step.
	void gather(double ago);
	/// Pushes the plants. Call after the step.
	void push();
	/// Reports bodies that came among plants or left them, by the shapes of the last gather().
	void report_touches();
	/// Ends the touches of a plant that leaves the tree, without a signal.
	void forget(const Plant3D *plant);
	/// Returns new warnings, with what to do; each once.
	std::vector<godot::String> take_warnings();

private:
	/// The bodies of a group in one world, and the plants that they push.
	struct Reading {
		godot::StringName name;
		uint64_t world = 0; ///< Instance id.
		GroupBodies bodies;
		std::vector<PlantGroup *> groups;
		const std::vector<MovingBody> *shapes = nullptr; ///< Of the present step.
	};
	/// A body that touches a plant, by instance ids: both may be freed.
	struct Touch {
		uint64_t plant;
		uint64_t body;
		bool operator<(const Touch &other) const;
	};

	std::vector<Reading> readings;
	std::vector<Touch> touches; ///< Sorted.
	std::vector<Touch> found; ///< In this frame; a member to reuse its memory.
	bool are_named = false;

	Reading &reading_of(const ForceSettings &forces);
	void find(const Reading &reading, const PlantGroup &group);
	void report_end(const Touch &touch);
};

} // namespace undergrowth
