#include "bodies/root_ways.hpp"

#include "bodies/group_bodies.hpp"

#include <glm/geometric.hpp>

#include <algorithm>

namespace undergrowth {

void RootWays::add(const glm::vec3 &root) {
	ways.push_back({ root, root, root });
}

void RootWays::remove(int index) {
	ways[size_t(index)] = ways.back();
	ways.pop_back();
}

void RootWays::watch(const MotionPage &page, double delta) {
	time += delta;
	frame = delta;
	const float farthest = GroupBodies::farthest_way(delta);
	for (size_t i = 0; i < ways.size(); i++) {
		const glm::vec3 root = page.root(int(i));
		Way &way = ways[i];
		is_moving = is_moving || way.now != root;
		way.before = way.now;
		way.now = root;
		if (glm::distance(way.before, way.now) > farthest) {
			way = { root, root, root };
		}
	}
}

const glm::vec3 *RootWays::velocities(double ago) {
	const double seconds = time - ago - stepped_at;
	stepped_at = time - ago;
	if (!is_moving || seconds <= 0.0) {
		return nullptr;
	}
	const float part = frame > 0.0 ? float(std::clamp(1.0 - ago / frame, 0.0, 1.0)) : 1.0f;
	speeds.resize(ways.size());
	is_moving = false;
	for (size_t i = 0; i < ways.size(); i++) {
		Way &way = ways[i];
		const glm::vec3 place = way.before + part * (way.now - way.before); // To the bit where it stands.
		speeds[i] = (place - way.stepped) / float(seconds);
		way.stepped = place;
		is_moving = is_moving || place != way.now || speeds[i] != glm::vec3(0.0f);
	}
	return speeds.data();
}

} // namespace undergrowth
