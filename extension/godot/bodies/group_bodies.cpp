#include "bodies/group_bodies.hpp"

#include "base/convert.hpp"
#include "base/messages.hpp"
#include "bodies/body_shapes.hpp"

#include <godot_cpp/classes/engine.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

using namespace godot;

namespace undergrowth {

static MovingBody mix(const MovingBody &from, const MovingBody &to, float part) {
	MovingBody mixed = to;
	mixed.from = glm::mix(from.from, to.from, part);
	mixed.to = glm::mix(from.to, to.to, part);
	mixed.half_width = glm::mix(from.half_width, to.half_width, part);
	mixed.half_depth = glm::mix(from.half_depth, to.half_depth, part);
	mixed.radius = glm::mix(from.radius, to.radius, part);
	return mixed;
}

static glm::vec3 middle(const MovingBody &body) {
	return 0.5f * (body.from + body.to);
}

void GroupBodies::watch(const BodyReading *reading, const Transform3D &axes, double delta) {
	time += delta;
	frame = delta;
	to_world = axes;
	to_field = axes.affine_inverse();
	const StringName group = reading ? reading->group : StringName();
	if (group != watched_group) {
		watched_group = group;
		empty_for = 0.0;
		is_group_known = false;
	}
	for (Body &body : bodies) {
		body.is_here = false;
	}
	if (reading) {
		std::for_each(
				reading->bodies.begin(), reading->bodies.end(), [this](const BodyReading::Body &body) { note(body); });
		warn_of_group(reading->members, delta);
	}
	for (Body &body : bodies) {
		for (Shape &shape : body.shapes) {
			shape.is_here = shape.is_here && body.is_here;
		}
	}
}

GroupBodies::Body &GroupBodies::body_of(uint64_t id) {
	const auto found = std::find_if(bodies.begin(), bodies.end(), [id](const Body &body) { return body.id == id; });
	return found != bodies.end() ? *found : bodies.emplace_back(Body{ id, {} });
}

void GroupBodies::note(const BodyReading::Body &read) {
	warn_of(read);
	Body &body = body_of(read.id);
	body.is_here = true;
	follow_shapes(body, read);
	for (size_t i = 0; i < read.shapes.size(); i++) {
		note_shape(body.shapes[i], read.shapes[i]);
	}
}

// Makes the shapes of `body` those of `read`. Known ones continue.
void GroupBodies::follow_shapes(Body &body, const BodyReading::Body &read) {
	const auto is_same = [](const Shape &shape, const BodyReading::Shape &one) { return shape.holder == one.holder; };
	if (std::equal(body.shapes.begin(), body.shapes.end(), read.shapes.begin(), read.shapes.end(), is_same)) {
		return;
	}
	std::vector<Shape> shapes;
	for (const BodyReading::Shape &one : read.shapes) {
		const auto known = std::find_if(
				body.shapes.begin(), body.shapes.end(), [&](const Shape &shape) { return is_same(shape, one); });
		shapes.push_back(known != body.shapes.end() ? *known : Shape{ one.holder, {}, {}, {} });
	}
	body.shapes = std::move(shapes);
}

void GroupBodies::note_shape(Shape &shape, const BodyReading::Shape &read) const {
	shape.was_here = shape.is_here;
	shape.before = shape.now;
	shape.is_here = read.is_here;
	if (!shape.is_here) {
		shape.stepped_at = -1.0;
		return;
	}
	shape.now = { transformed(to_field, read.body), middle(read.body) };
	if (!shape.was_here || is_jump(shape.before, shape.now)) {
		shape.before = shape.now;
		shape.stepped_at = -1.0;
	}
}

// Physics bodies move in physics frames only. So in a short drawn frame a body may move as far as in a longer one.
float GroupBodies::farthest_way(double delta) {
	const double tick = 1.0 / std::max(Engine::get_singleton()->get_physics_ticks_per_second(), 1);
	return float(FASTEST * std::max(delta, tick));
}

bool GroupBodies::is_jump(const Spot &from, const Spot &to) const {
	const float farthest = farthest_way(frame);
	const Vector3 in_field = to_world.basis.xform(to_godot(middle(to.shape) - middle(from.shape)));
	return glm::distance(from.in_world, to.in_world) > farthest || in_field.length() > farthest;
}

const std::vector<MovingBody> &GroupBodies::gather(double ago) {
	gathered.clear();
	const float part = frame > 0.0 ? float(std::clamp(1.0 - ago / frame, 0.0, 1.0)) : 1.0f;
	for (Body &body : bodies) {
		body.first = gathered.size();
		for (Shape &shape : body.shapes) {
			if (!body.is_here || !shape.is_here) {
				continue;
			}
			const Spot place = { mix(shape.before.shape, shape.now.shape, part),
				glm::mix(shape.before.in_world, shape.now.in_world, part) };
			gathered.push_back(place.shape);
			if (shape.stepped_at >= 0.0) {
				const double seconds = time - ago - shape.stepped_at;
				gathered.back().velocity = velocity(shape.stepped, place, seconds);
				gathered.back().growth = growth(shape.stepped, place, seconds);
			}
			shape.stepped = place;
			shape.stepped_at = time - ago;
		}
		body.count = gathered.size() - body.first;
	}
	return gathered;
}

// Returns the velocity in field axes.
glm::vec3 GroupBodies::velocity(const Spot &from, const Spot &to, double seconds) const {
	if (seconds <= 0.0) {
		return { 0.0f, 0.0f, 0.0f };
	}
	const glm::vec3 in_world = to.in_world - from.in_world;
	const glm::vec3 in_field = middle(to.shape) - middle(from.shape);
	const bool is_world_less = glm::length(in_world) < float(to_world.basis.xform(to_godot(in_field)).length());
	const glm::vec3 way = is_world_less ? to_glm(to_field.basis.xform(to_godot(in_world))) : in_field;
	return way / float(seconds);
}

float GroupBodies::growth(const Spot &from, const Spot &to, double seconds) {
	return seconds > 0.0 ? (to.shape.radius - from.shape.radius) / float(seconds) : 0.0f;
}

std::vector<GroupBodies::Event> GroupBodies::find_events(const std::function<bool(const MovingBody &)> &touches) {
	std::vector<Event> events;
	for (Body &body : bodies) {
		const bool was_touching = body.is_touching;
		const auto first = gathered.begin() + std::ptrdiff_t(body.first);
		body.is_touching = body.is_here && std::any_of(first, first + std::ptrdiff_t(body.count), touches);
		if (body.is_touching != was_touching) {
			events.push_back({ body.id, body.is_touching });
		}
	}
	drop_gone();
	return events;
}

void GroupBodies::for_each_shape(const std::function<void(uint64_t, const MovingBody &)> &visit) const {
	for (const Body &body : bodies) {
		for (size_t i = body.first; i < body.first + body.count; i++) {
			visit(body.id, gathered[i]);
		}
	}
}

void GroupBodies::drop_gone() {
	const auto is_gone = [](const Body &body) { return !body.is_here; };
	bodies.erase(std::remove_if(bodies.begin(), bodies.end(), is_gone), bodies.end());
}

void GroupBodies::warn_of(const BodyReading::Body &read) {
	if (read.age < BODY_PATIENCE || read.can_push || !warned_of.insert(read.id).second) {
		return;
	}
	warnings.push_back(describe(Object::cast_to<Node>(ObjectDB::get_instance(read.id))) + " is in the group '" +
			String(watched_group) +
			"' but pushes no plants: it has no CollisionShape3D with a sphere, capsule, cylinder or box. Add one, or "
			"remove the node from the group.");
}

void GroupBodies::warn_of_group(int members, double delta) {
	empty_for += delta;
	is_group_known = is_group_known || members > 0;
	if (empty_for < GROUP_PATIENCE || is_group_known) {
		return;
	}
	is_group_known = true;
	warnings.push_back(String("no body of its world is in the group '") + String(watched_group) +
			"', so nothing pushes its plants. Add bodies to that group, or correct its name in bodies_group.");
}

std::vector<String> GroupBodies::take_warnings() {
	std::vector<String> taken;
	taken.swap(warnings);
	return taken;
}

void GroupBodies::forget() {
	bodies.clear();
	gathered.clear();
	empty_for = 0.0;
}

} // namespace undergrowth
