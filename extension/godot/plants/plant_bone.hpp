#pragma once

#include "base/convert.hpp"
#include "plants/part_skeleton.hpp"

#include <godot_cpp/classes/skeleton3d.hpp>
#include <godot_cpp/variant/basis.hpp>
#include <godot_cpp/variant/rid.hpp>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

namespace undergrowth {

/// The bone that shows the direction of one plant, and access to the bones of its parts. It contains all data for
/// posing. So the simulation reads a contiguous array of these and no plant.
///
/// An update of a Skeleton3D node costs three times as much as the rotation: notifications, signals and all bones, at
/// the end of the frame. Only code that holds the skeleton can observe it. Until then the pose is written to the
/// renderer only, and the node gets it when something happens to the plant.
struct PlantBone {
	enum class Way : uint8_t {
		NODE, ///< A script holds the skeleton, or the renderer does not have it yet.
		RENDERER,
		UNSEEN, ///< There is no renderer.
	};

	godot::Skeleton3D *skeleton = nullptr; ///< Null if nothing is shown: no skeleton, or hidden.
	PartSkeleton *parts = nullptr; ///< Further bones, for a plant of parts.
	godot::RID drawn; ///< The renderer's skeleton; invalid if not available.
	godot::Basis to_local; ///< From the axes of the plant's directions to the plant's own.
	glm::vec3 posed = { 0.0f, 1.0f, 0.0f }; ///< Shown direction, in the plant's own axes.
	Way way = Way::NODE;
	bool is_held = false; ///< A script requested the skeleton.
	bool is_calm = true; ///< No part swings.
	bool node_is_behind = false; ///< The pose of the node is older than the shown one.
	uint64_t node_updated_in = 0; ///< Frame of the node's last update.

	/// Input of the parts besides the bend: the stem's last step, from and to directions (unit), and the clock of
	/// swings.
	struct Step {
		glm::vec3 before;
		glm::vec3 after;
		float seconds;
		float clock;
		glm::vec3 second; ///< MotionPage::second_bend().
		float air = 0.0f; ///< As in StemMotion.
		float turns = 0.0f;
		float drops = 0.0f;
	};
	void follow(const Step &step);
	/// Returns MotionPage::second_bend() of a stem in this state, for a plant of parts that is on no page.
	glm::vec3 second_bend(const TipState &tip, const StemSecond &second) const;
	/// Turns the bone to `direction` (unit), in every frame. Returns early if the direction is visibly the same and no
	/// part swings. `step()` returns the last step; it is called only if parts need it.
	template <typename GetStep> void show(const glm::vec3 &direction, const GetStep &step) {
		if (!skeleton) {
			return;
		}
		const glm::vec3 local = to_glm(to_local.xform(to_godot(direction)));
		if (way != Way::NODE && is_calm && !can_be_distinguished(local, posed)) {
			return;
		}
		if (parts && way != Way::UNSEEN) {
			follow(step());
		}
		show_local(local);
	}
	/// Turns the bone of the node, even if the pose is written to the renderer only.
	void turn_to(const glm::vec3 &direction);
	/// Writes the shown pose to the node.
	void catch_up();

private:
	static bool can_be_distinguished(const glm::vec3 &a, const glm::vec3 &b) {
		const glm::vec3 change = glm::abs(a - b);
		return !(change.x < SMALLEST_TURN && change.y < SMALLEST_TURN && change.z < SMALLEST_TURN);
	}
	/// A smaller change of the pose (about radians) is not visible and not worth an update of the skeleton.
	static constexpr float SMALLEST_TURN = 1e-6f;
	bool may_leave_node() const;
	void show_local(const glm::vec3 &local);
	void turn_to_local(const glm::vec3 &local);
	void take(const glm::vec3 &local);
};

} // namespace undergrowth
