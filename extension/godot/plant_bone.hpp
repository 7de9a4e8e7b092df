#pragma once

#include "convert.hpp"
#include "part_skeleton.hpp"

#include <godot_cpp/classes/skeleton3d.hpp>
#include <godot_cpp/variant/basis.hpp>
#include <godot_cpp/variant/rid.hpp>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

namespace undergrowth {

/// The bone that shows where one plant points, and the way to those of its parts: all that posing needs, so that the
/// simulation's rows of these are read one after the other and no plant is touched.
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
	bool is_calm = true; ///< No part swings.
	bool node_is_behind = false; ///< The node does not know what is shown.
	uint64_t told_node_in = 0; ///< The frame in which it was told.

	/// What parts go by besides the bend: the stem's last step, from and to directions (unit), and the clock of swings.
	struct Step {
		glm::vec3 before;
		glm::vec3 after;
		float seconds;
		float clock;
		glm::vec3 second; ///< MotionPage::second_bend().
	};
	void follow(const Step &step);
	/// Of a plant with parts that is on no page: MotionPage::second_bend() of a stem that moves so.
	glm::vec3 second_bend(const TipState &tip, const StemSecond &second) const;
	/// Turns the bone to `direction` (unit), in every frame. Nothing where it points there already, within what can be
	/// seen, and no part swings. `step()` tells the last step and is asked where parts need it.
	template <typename AskStep> void show(const glm::vec3 &direction, const AskStep &step) {
		if (!skeleton) {
			return;
		}
		const glm::vec3 local = to_glm(to_local.xform(to_godot(direction)));
		if (way != Way::NODE && is_calm && !can_be_told_apart(local, posed)) {
			return;
		}
		if (parts && way != Way::UNSEEN) {
			follow(step());
		}
		show_local(local);
	}
	/// The same by the node, whatever shows it otherwise.
	void turn_to(const glm::vec3 &direction);
	/// Tells the node what is shown.
	void catch_up();

private:
	static bool can_be_told_apart(const glm::vec3 &a, const glm::vec3 &b) {
		const glm::vec3 change = glm::abs(a - b);
		return !(change.x < SMALLEST_TURN && change.y < SMALLEST_TURN && change.z < SMALLEST_TURN);
	}
	/// Below this (radians, about) a change of the pose cannot be seen and is not worth an update of the skeleton.
	static constexpr float SMALLEST_TURN = 1e-6f;
	bool may_leave_node() const;
	void show_local(const glm::vec3 &local);
	void turn_to_local(const glm::vec3 &local);
	void take(const glm::vec3 &local);
};

} // namespace undergrowth
