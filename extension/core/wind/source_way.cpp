#include "wind/source_way.hpp"

#include <glm/common.hpp>

#include <algorithm>

namespace undergrowth {

void SourceWay::begin(const glm::vec3 &place) {
	newest = 0;
	count = 1;
	notes[0] = { 0.0, place };
}

void SourceWay::add(double delta, const glm::vec3 &place) {
	const double time = at(0).time + delta;
	if (count < 2 || time - at(1).time >= SPACING) {
		newest = (newest + 1) % ROOM;
		count = std::min(count + 1, ROOM);
	}
	notes[newest] = { time, place };
}

glm::vec3 SourceWay::place(double ago) const {
	const double time = at(0).time - ago;
	for (int age = 1; age < count; age++) {
		const Note &before = at(age);
		const Note &after = at(age - 1);
		if (before.time <= time) {
			const double span = after.time - before.time;
			const double part = span > 0.0 ? std::min((time - before.time) / span, 1.0) : 1.0;
			return glm::mix(before.place, after.place, static_cast<float>(part));
		}
	}
	return at(count - 1).place;
}

glm::vec3 SourceWay::velocity(double ago) const {
	return (place(ago) - place(ago + SMOOTHING)) / static_cast<float>(SMOOTHING);
}

} // namespace undergrowth
