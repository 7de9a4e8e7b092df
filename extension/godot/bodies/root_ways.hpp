#pragma once

#include "motion/motion_page.hpp"

#include <glm/vec3.hpp>

#include <vector>

namespace undergrowth {

/// How fast the roots of a page's plants go, as GroupBodies knows it of bodies: where they are is noted in each frame,
/// and between two frames they are taken to go straight on. A root that goes farther than GroupBodies::FASTEST was set
/// down elsewhere.
class RootWays {
public:
	void add(const glm::vec3 &root);
	/// The last one takes its index.
	void remove(int index);
	/// Once in every frame, of `delta` seconds.
	void watch(const MotionPage &page, double delta);
	/// Once in every step, whose time is `ago` seconds before this frame: m/s of each root since the step before. Null
	/// where all of them stand.
	const glm::vec3 *velocities(double ago);

private:
	struct Way {
		glm::vec3 before; ///< m, in the frame before.
		glm::vec3 now;
		glm::vec3 stepped; ///< In the last step.
	};

	std::vector<Way> ways;
	std::vector<glm::vec3> speeds; ///< m/s, as many.
	double time = 0.0; ///< s.
	double frame = 0.0; ///< s, the last one's length.
	double stepped_at = 0.0; ///< s of `time`.
	bool is_moving = false;
};

} // namespace undergrowth
