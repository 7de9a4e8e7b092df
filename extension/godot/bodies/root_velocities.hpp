#pragma once

#include "motion/motion_page.hpp"

#include <glm/vec3.hpp>

#include <vector>

namespace undergrowth {

/// Velocities of the roots of a page's plants. Positions are read in each frame and interpolated linearly. A motion
/// longer than GroupBodies::farthest_way() is a move to another position and has no velocity.
class RootVelocities {
public:
	void add(const glm::vec3 &root);
	/// Removes a root; the last one gets its index.
	void remove(int index);
	/// Reads the positions. Call once in every frame, of `delta` seconds.
	void watch(const MotionPage &page, double delta);
	/// Updates the velocities for a step at `ago` seconds before this frame. Call once in every step.
	void step(double ago);
	/// Velocities of all roots since the step before (m/s). Null if none moves.
	const glm::vec3 *velocities() const { return is_known ? speeds.data() : nullptr; }
	/// Means of velocities() over the last STEPS steps; null if none moved in them. A node that moves in physics frames
	/// advances by two of these in some drawn frames and by none in the next.
	const glm::vec3 *mean_velocities() const { return is_known ? means.data() : nullptr; }

private:
	static constexpr int STEPS = 4;

	struct Way {
		glm::vec3 before; ///< m, in the frame before.
		glm::vec3 now;
		glm::vec3 stepped[STEPS]; ///< In the last steps: a ring buffer.
	};

	std::vector<Way> ways;
	std::vector<glm::vec3> speeds; ///< m/s, one for each root.
	std::vector<glm::vec3> means; ///< m/s, one for each root.
	double time = 0.0; ///< s.
	double frame = 0.0; ///< Length of the last frame, s.
	double stepped_at[STEPS] = {}; ///< s of `time`.
	int newest = 0; ///< Index in both ring buffers.
	bool is_moving = false; ///< In the last step or since.
	bool is_known = false;

	static Way at_rest(const glm::vec3 &root);
};

} // namespace undergrowth
