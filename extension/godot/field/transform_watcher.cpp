#include "field/transform_watcher.hpp"

#include "base/follow_changes.hpp"

#include <godot_cpp/core/object.hpp>

using namespace godot;

namespace undergrowth {

static const char *const CURVE_CHANGED = "curve_changed"; // Of a Path3D.

static const char *const SIZE = "size"; // Of a field.

static Transform3D place_in(const Node3D *field, const Node3D *node) {
	return field->get_global_transform().affine_inverse() * node->get_global_transform();
}

void TransformWatcher::watch(const Node3D *field, const std::vector<Node3D *> &wanted, const Callable &changed) {
	for (const Watched &old : nodes) {
		Object *node = ObjectDB::get_instance(old.node);
		if (node && node->has_signal(CURVE_CHANGED)) {
			follow_signal(node, CURVE_CHANGED, changed, false);
		}
	}
	nodes.clear();
	for (Node3D *node : wanted) {
		if (!node) {
			continue;
		}
		nodes.push_back({ uint64_t(node->get_instance_id()), place_in(field, node), node->get(SIZE) });
		if (node->has_signal(CURVE_CHANGED)) {
			follow_signal(node, CURVE_CHANGED, changed);
		}
	}
}

bool TransformWatcher::has_moved(const Node3D *field) {
	bool moved = false;
	for (Watched &one : nodes) {
		const Node3D *node = Object::cast_to<Node3D>(ObjectDB::get_instance(one.node));
		if (!node || !node->is_inside_tree()) {
			continue;
		}
		const Transform3D placed = place_in(field, node);
		const Variant size = node->get(SIZE);
		moved = moved || !placed.is_equal_approx(one.placed) || size != one.size;
		one.placed = placed;
		one.size = size;
	}
	return moved;
}

} // namespace undergrowth
