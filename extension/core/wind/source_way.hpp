#pragma once

#include <glm/vec3.hpp>

namespace undergrowth {

/// Where a node was in the last moments, noted once a frame: its place and velocity at any time of the frame, the same
/// at every frame rate. Between two notes it moves straight on.
class SourceWay {
public:
	/// s: velocities are means over this time. A node that moves in physics frames advances in some drawn frames by two
	/// of them and in others by none; over four physics frames this averages out.
	static constexpr double SMOOTHING = 4.0 / 60.0;

	/// Forgets what came before.
	void begin(const glm::vec3 &place);
	/// The place in a frame that is `delta` seconds (finite, >= 0) after the one before.
	void add(double delta, const glm::vec3 &place);
	const glm::vec3 &last() const { return at(0).place; }
	/// m, `ago` seconds (>= 0) before the last note.
	glm::vec3 place(double ago) const;
	/// m/s, the mean of the SMOOTHING seconds before that time.
	glm::vec3 velocity(double ago) const;

private:
	static constexpr int ROOM = 32;
	static constexpr double SPACING = 1.0 / 240.0; ///< s: notes nearer than this replace each other.

	struct Note {
		double time = 0.0; ///< s.
		glm::vec3 place = { 0.0f, 0.0f, 0.0f }; ///< m.
	};

	Note notes[ROOM]; ///< A ring.
	int newest = 0;
	int count = 1;

	/// 0: the newest.
	const Note &at(int age) const { return notes[(newest - age + ROOM) % ROOM]; }
};

} // namespace undergrowth
