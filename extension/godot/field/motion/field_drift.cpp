#include "field/motion/field_drift.hpp"

#include "base/convert.hpp"
#include "bodies/group_bodies.hpp"

#include <algorithm>
#include <iterator>

using namespace godot;

namespace undergrowth {

static constexpr real_t LARGEST_TURN = 0.5f; // rad per frame, approximate.

void FieldDrift::begin() {
	before = now;
	std::fill(std::begin(stepped), std::end(stepped), now);
	is_moving = false;
	is_placed = true;
}

bool FieldDrift::is_jump() const {
	bool is_turned = false;
	for (int i = 0; i < 3; i++) {
		const Vector3 was = before.basis.get_column(i);
		is_turned = is_turned || !((now.basis.get_column(i) - was).length() <= LARGEST_TURN * was.length());
	}
	return is_turned || !((now.origin - before.origin).length() <= GroupBodies::farthest_way(frame));
}

void FieldDrift::watch(const Transform3D &axes, double delta) {
	time += delta;
	frame = delta;
	before = now;
	now = axes;
	is_moving = is_moving || now != before;
	if (!is_placed || (is_moving && is_jump())) {
		begin();
	}
}

AirDrift FieldDrift::step(double ago) {
	AirDrift drift;
	const int oldest = (newest + 1) % STEPS;
	const double seconds = time - ago - stepped_at[oldest];
	newest = oldest;
	stepped_at[newest] = time - ago;
	if (!is_moving || seconds <= 0.0) {
		return drift;
	}
	const real_t part = frame > 0.0 ? real_t(std::clamp(1.0 - ago / frame, 0.0, 1.0)) : real_t(1.0);
	const Transform3D was = stepped[newest];
	Transform3D &is = stepped[newest];
	is.origin = before.origin + part * (now.origin - before.origin); // Exact if the node does not move.
	for (int i = 0; i < 3; i++) {
		const Vector3 from = before.basis.get_column(i);
		is.basis.set_column(i, from + part * (now.basis.get_column(i) - from));
	}
	const Basis turn = is.basis.orthonormalized().transposed();
	const auto speed = [&](const Vector3 &from, const Vector3 &to) {
		return to_glm(turn.xform((to - from) / real_t(seconds)));
	};
	drift.base = speed(was.origin, is.origin);
	drift.by_x = speed(was.basis.get_column(0), is.basis.get_column(0));
	drift.by_y = speed(was.basis.get_column(1), is.basis.get_column(1));
	drift.by_z = speed(was.basis.get_column(2), is.basis.get_column(2));
	is_moving =
			std::any_of(std::begin(stepped), std::end(stepped), [&](const Transform3D &step) { return step != now; });
	return drift;
}

} // namespace undergrowth
