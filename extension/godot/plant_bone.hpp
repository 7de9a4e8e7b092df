#pragma once

#include "part_skeleton.hpp"

#include <godot_cpp/classes/skeleton3d.hpp>
#include <godot_cpp/variant/basis.hpp>
#include <godot_cpp/variant/rid.hpp>

#include <glm/vec3.hpp>

#include <cstdint>

namespace undergrowth {

/// The bone that shows where one plant points, and the way to those of its parts: all that posing needs, so that the simulation's rows of these are read
/// one after the other and no plant is touched.
///
/// A skeleton that is told of a turn updates itself at the end of the frame: messages, signals, all bones, for three
/// times what the turn costs. Nobody sees that but who holds the skeleton, so the renderer is told instead until then,
/// and the node hears of its pose only when something happens to the plant.
struct PlantBone {
	enum class Way : uint8_t {
		NODE, ///< Somebody holds the skeleton, or the renderer does not have it yet.
		RENDERER,
		UNSEEN, ///< There is no renderer.
	};

	godot::Skeleton3D *skeleton = nullptr; ///< Null where there is nothing to show: no skeleton, or hidden.
	PartSkeleton *parts = nullptr; ///< Of a plant of parts: how its further bones stand.
	godot::RID drawn; ///< What the renderer has of it; invalid where nobody knows.
	godot::Basis to_local; ///< From the axes of the plant's directions to the plant's own.
	glm::vec3 posed = { 0.0f, 1.0f, 0.0f }; ///< What is shown now, in the plant's own axes.
	Way way = Way::NODE;
	bool is_held = false; ///< Somebody asked for the skeleton.
	bool node_is_behind = false; ///< The node does not know what is shown.

	/// Whether show() of this direction poses parts, which go by what the stem does.
	bool shows_parts(const glm::vec3 &direction) const;
	/// What the stem does besides: the directions (unit) before and after its last step of `step` seconds, and the clock
	/// of swings.
	void follow_stem(const glm::vec3 &before, const glm::vec3 &after, float step, float clock);
	/// Turns the bone to `direction` (unit), in every frame. Nothing where it points there already, within what can be
	/// seen.
	void show(const glm::vec3 &direction);
	/// The same by the node, whatever shows it otherwise.
	void turn_to(const glm::vec3 &direction);
	/// Tells the node what is shown.
	void catch_up();

private:
	void take(const glm::vec3 &local);
};

} // namespace undergrowth
