#include "bodies/root_velocities.hpp"

#include "bodies/group_bodies.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <iterator>

namespace undergrowth {

RootVelocities::Way RootVelocities::at_rest(const glm::vec3 &root) {
	Way way = { root, root, {} };
	std::fill(std::begin(way.stepped), std::end(way.stepped), root);
	return way;
}

void RootVelocities::add(const glm::vec3 &root) {
	ways.push_back(at_rest(root));
	is_known = false;
}

void RootVelocities::remove(int index) {
	ways[size_t(index)] = ways.back();
	ways.pop_back();
	is_known = false;
}

void RootVelocities::watch(const MotionPage &page, double delta) {
	time += delta;
	frame = delta;
	const float farthest = GroupBodies::farthest_way(delta);
	for (size_t i = 0; i < ways.size(); i++) {
		const glm::vec3 root = page.root(int(i));
		Way &way = ways[i];
		is_moving = is_moving || way.now != root;
		way.before = way.now;
		way.now = root;
		if (!(glm::distance(way.before, way.now) <= farthest)) {
			way = at_rest(root);
		}
	}
}

void RootVelocities::step(double ago) {
	const int oldest = (newest + 1) % STEPS;
	const double since_last = time - ago - stepped_at[newest];
	const double since_oldest = time - ago - stepped_at[oldest];
	newest = oldest;
	stepped_at[newest] = time - ago;
	is_known = is_moving && since_last > 0.0;
	if (!is_known) {
		return;
	}
	const float part = frame > 0.0 ? float(std::clamp(1.0 - ago / frame, 0.0, 1.0)) : 1.0f;
	speeds.resize(ways.size());
	means.resize(ways.size());
	is_moving = false;
	for (size_t i = 0; i < ways.size(); i++) {
		Way &way = ways[i];
		const glm::vec3 place = way.before + part * (way.now - way.before); // Equal to the bit for a root at rest.
		speeds[i] = (place - way.stepped[(newest + STEPS - 1) % STEPS]) / float(since_last);
		means[i] = (place - way.stepped[newest]) / float(since_oldest);
		way.stepped[newest] = place;
		const auto is_elsewhere = [&](const glm::vec3 &step) { return step != way.now; };
		is_moving = is_moving || std::any_of(std::begin(way.stepped), std::end(way.stepped), is_elsewhere);
	}
}

} // namespace undergrowth
