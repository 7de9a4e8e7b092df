#include "bodies/group_bodies.hpp"

#include "base/convert.hpp"
#include "base/messages.hpp"
#include "base/world_of.hpp"
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

void GroupBodies::watch(const Place &here, const StringName &group, double delta) {
	time += delta;
	frame = delta;
	axes = here.axes;
	to_field = axes.affine_inverse();
	if (group != watched_group) {
		watched_group = group;
		empty_for = 0.0;
		is_group_known = false;
	}
	for (Body &body : bodies) {
		body.is_here = false;
	}
	if (!group.is_empty() && here.tree->has_group(group)) {
		note_members(here.tree->get_nodes_in_group(group), here.world, delta);
	} else if (!group.is_empty()) {
		warn_of_group(0, delta);
	}
	for (Body &body : bodies) {
		for (Shape &shape : body.shapes) {
			shape.is_here = shape.is_here && body.is_here;
		}
	}
}

void GroupBodies::note_members(const TypedArray<Node> &nodes, uint64_t world, double delta) {
	int64_t members = 0;
	for (int64_t i = 0; i < nodes.size(); i++) {
		const Node3D *node = Object::cast_to<Node3D>(nodes[i]);
		const bool is_here = !node || world_of(node) == world;
		members += is_here ? 1 : 0;
		if (node && is_here) {
			note(node, delta);
		} else if (node) {
			continue;
		} else if (const Node *other = Object::cast_to<Node>(nodes[i])) {
			warn_of({ other->get_instance_id(), {}, BODY_PATIENCE }, other);
		}
	}
	warn_of_group(members, delta);
}

void GroupBodies::note(const Node3D *node, double delta) {
	const uint64_t id = node->get_instance_id();
	auto found = std::find_if(bodies.begin(), bodies.end(), [id](const Body &body) { return body.id == id; });
	if (found == bodies.end()) {
		bodies.push_back({ id, {} });
		found = bodies.end() - 1;
	}
	Body &body = *found;
	body.is_here = true;
	body.age += delta;
	body.shapes_age += delta;
	if (body.shapes_age >= SHAPES_LIFETIME) {
		find_shapes(body, node);
		warn_of(body, node);
	}
	for (Shape &shape : body.shapes) {
		note_shape(shape);
	}
}

void GroupBodies::find_shapes(Body &body, const Node3D *node) {
	body.shapes_age = 0.0;
	std::vector<Shape> shapes;
	for (const uint64_t holder : find_shape_holders(node, watched_group)) {
		const auto known = std::find_if(body.shapes.begin(), body.shapes.end(),
				[holder](const Shape &shape) { return shape.holder == holder; });
		shapes.push_back(known != body.shapes.end() ? *known : Shape{ holder, {}, {}, {} });
	}
	body.shapes = std::move(shapes);
}

void GroupBodies::note_shape(Shape &shape) {
	const CollisionShape3D *holder = Object::cast_to<CollisionShape3D>(ObjectDB::get_instance(shape.holder));
	shape.was_here = shape.is_here;
	shape.before = shape.now;
	MovingBody world;
	shape.is_here = holder && shape_in_world(holder, world);
	if (!shape.is_here) {
		shape.stepped_at = -1.0;
		return;
	}
	shape.now = { transformed(to_field, world), middle(world) };
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
	const Vector3 in_field = axes.basis.xform(to_godot(middle(to.shape) - middle(from.shape)));
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
				gathered.back().velocity = velocity(shape.stepped, place, time - ago - shape.stepped_at);
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
	const bool is_world_less = glm::length(in_world) < float(axes.basis.xform(to_godot(in_field)).length());
	const glm::vec3 way = is_world_less ? to_glm(to_field.basis.xform(to_godot(in_world))) : in_field;
	return way / float(seconds);
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

void GroupBodies::warn_of(const Body &body, const Node *node) {
	const auto pushes = [](const Shape &shape) {
		const CollisionShape3D *holder = Object::cast_to<CollisionShape3D>(ObjectDB::get_instance(shape.holder));
		return holder && may_push(holder);
	};
	if (body.age < BODY_PATIENCE || std::any_of(body.shapes.begin(), body.shapes.end(), pushes) ||
			!warned_of.insert(body.id).second) {
		return;
	}
	warnings.push_back(describe(node) + " is in the group '" + String(watched_group) +
			"' but pushes no plants: it has no CollisionShape3D below it with a sphere, capsule, cylinder or box. "
			"Add one, or take it out of the group.");
}

void GroupBodies::warn_of_group(int64_t members, double delta) {
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
