#pragma once

#include "motion/motion_page.hpp"

#include <glm/vec3.hpp>

#include <vector>

namespace undergrowth {

/// How fast the roots of a page's plants move: where they are is noted in each frame, and between two frames they move
/// straight on. A root that moves farther than GroupBodies::farthest_way() was set down elsewhere.
class RootWays {
public:
	void add(const glm::vec3 &root);
	/// The last one takes its index.
	void remove(int index);
	/// Once in every frame, of `delta` seconds.
	void watch(const MotionPage &page, double delta);
	/// Once in every step, whose time is `ago` seconds before this frame.
	void step(double ago);
	/// m/s, of each root since the step before. Null where none moves.
	const glm::vec3 *velocities() const { return is_known ? speeds.data() : nullptr; }
	/// The same as means of the last STEPS steps: a node that moves in physics frames advances in some drawn frames by
	/// two of them and in others by none. Null where none moved in these steps.
	const glm::vec3 *mean_velocities() const { return is_known ? means.data() : nullptr; }

private:
	static constexpr int STEPS = 4;

	struct Way {
		glm::vec3 before; ///< m, in the frame before.
		glm::vec3 now;
		glm::vec3 stepped[STEPS]; ///< In the last steps: a ring.
	};

	std::vector<Way> ways;
	std::vector<glm::vec3> speeds; ///< m/s, as many.
	std::vector<glm::vec3> means; ///< As many.
	double time = 0.0; ///< s.
	double frame = 0.0; ///< s, the last one's length.
	double stepped_at[STEPS] = {}; ///< s of `time`.
	int newest = 0; ///< Of both rings.
	bool is_moving = false; ///< In the last step or since.
	bool is_known = false;

	static Way at_rest(const glm::vec3 &root);
};

} // namespace undergrowth
