#include "field/dependency_poller.hpp"

#include "field/build/field_areas.hpp"
#include "field/build/field_ground.hpp"
#include "field/build/field_habitats.hpp"

#include <godot_cpp/classes/material.hpp>

#include <utility>

using namespace godot;

namespace undergrowth {

static Node3D *find_ground_node(const Node3D *node, const PlacementOptions &options) {
	const auto kind = FieldGround::Kind(options.ground_mode);
	const NodePath path = kind == FieldGround::Kind::mesh ? options.ground_mesh
			: kind == FieldGround::Kind::object			  ? options.ground_object
														  : NodePath();
	return path.is_empty() ? nullptr : Object::cast_to<Node3D>(node->get_node_or_null(path));
}

DependencyPoller::Found DependencyPoller::poll(const GeometryInstance3D *node, const FieldProperties &properties) {
	const SightRange range = sight_range_of(node);
	const Ref<Material> source = node->get_material_override();
	const uint64_t material = source.is_valid() ? uint64_t(source->get_instance_id()) : 0;
	Found found;
	found.range = range != std::exchange(seen_range, range);
	found.material = std::exchange(seen_material, material) != material;
	found.exclusions = has_other_exclusions(properties);
	found.area = area.has_moved(node);
	found.ground = ground.has_moved(node);
	return found;
}

void DependencyPoller::watch(Node3D *node, const PlacementOptions &options) {
	area.watch(node, find_area_nodes(node, options), Callable(node, "_on_area_changed"));
	std::vector<Node3D *> below = find_habitat_nodes(node, options);
	below.push_back(find_ground_node(node, options));
	ground.watch(node, below, Callable(node, "_on_ground_changed"));
}

} // namespace undergrowth
