#include "bodies/body_readings.hpp"

#include "base/world_of.hpp"
#include "bodies/body_shapes.hpp"

#include <godot_cpp/core/object.hpp>

#include <algorithm>
#include <limits>

using namespace godot;

namespace undergrowth {

static const CollisionShape3D *holder_of(const BodyReading::Shape &shape) {
	return Object::cast_to<CollisionShape3D>(ObjectDB::get_instance(shape.holder));
}

static void find_shapes(BodyReading::Body &body, const Node3D *node, const StringName &group) {
	body.shapes_age = 0.0;
	body.shapes.clear();
	for (const uint64_t holder : find_shape_holders(node, group)) {
		body.shapes.push_back({ holder, false, {} });
	}
	body.can_push = std::any_of(body.shapes.begin(), body.shapes.end(), [](const BodyReading::Shape &shape) {
		const CollisionShape3D *holder = holder_of(shape);
		return holder && may_push(holder);
	});
}

void BodyReadings::begin_frame(SceneTree *of, double seconds) {
	tree = of;
	delta = seconds;
	const auto is_unused = [](const std::unique_ptr<BodyReading> &reading) { return !reading->is_read; };
	readings.erase(std::remove_if(readings.begin(), readings.end(), is_unused), readings.end());
	for (const std::unique_ptr<BodyReading> &reading : readings) {
		reading->is_read = false;
	}
}

const BodyReading *BodyReadings::read(const StringName &group, uint64_t world) {
	if (group.is_empty() || !tree) {
		return nullptr;
	}
	auto found = std::find_if(readings.begin(), readings.end(), [&](const std::unique_ptr<BodyReading> &reading) {
		return reading->world == world && reading->group == group;
	});
	if (found == readings.end()) {
		readings.push_back(std::make_unique<BodyReading>());
		found = readings.end() - 1;
		(*found)->group = group;
		(*found)->world = world;
	}
	if (!(*found)->is_read) {
		update(**found);
	}
	return found->get();
}

void BodyReadings::update(BodyReading &reading) const {
	reading.is_read = true;
	reading.members = 0;
	for (BodyReading::Body &body : reading.bodies) {
		body.is_member = false;
	}
	const TypedArray<Node> nodes =
			tree->has_group(reading.group) ? tree->get_nodes_in_group(reading.group) : TypedArray<Node>();
	for (int64_t i = 0; i < nodes.size(); i++) {
		const Node3D *node = Object::cast_to<Node3D>(nodes[i]);
		if (node && world_of(node) != reading.world) {
			continue;
		}
		reading.members++;
		if (node) {
			note(reading, node);
		} else if (const Node *other = Object::cast_to<Node>(nodes[i])) {
			reading.bodies.push_back({ other->get_instance_id(), {} });
			reading.bodies.back().age = std::numeric_limits<double>::infinity(); // It never has a shape.
		}
	}
	const auto is_gone = [](const BodyReading::Body &body) { return !body.is_member; };
	reading.bodies.erase(std::remove_if(reading.bodies.begin(), reading.bodies.end(), is_gone), reading.bodies.end());
}

void BodyReadings::note(BodyReading &reading, const Node3D *node) const {
	const uint64_t id = node->get_instance_id();
	auto found = std::find_if(reading.bodies.begin(), reading.bodies.end(),
			[id](const BodyReading::Body &body) { return body.id == id; });
	if (found == reading.bodies.end()) {
		reading.bodies.push_back({ id, {} });
		found = reading.bodies.end() - 1;
		found->shapes_age = SHAPES_LIFETIME;
	}
	found->is_member = true;
	found->age += delta;
	found->shapes_age += delta;
	if (found->shapes_age >= SHAPES_LIFETIME) {
		find_shapes(*found, node, reading.group);
	}
	for (BodyReading::Shape &shape : found->shapes) {
		const CollisionShape3D *holder = holder_of(shape);
		shape.is_here = holder && shape_in_world(holder, shape.body);
	}
}

} // namespace undergrowth
