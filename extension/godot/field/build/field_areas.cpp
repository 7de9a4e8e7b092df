#include "field/build/field_areas.hpp"

#include "field/build/build_input.hpp"
#include "nodes/plant_field_3d.hpp"

#include <godot_cpp/classes/curve3d.hpp>
#include <godot_cpp/classes/geometry2d.hpp>
#include <godot_cpp/classes/path3d.hpp>

#include <algorithm>

using namespace godot;

namespace undergrowth {

static constexpr float OUTLINE_TOLERANCE_DEGREES = 4.0f;
static constexpr int OUTLINE_STAGES = 5;

namespace {

/// A path in a field's ground plane.
struct FlatPath {
	Polygon points;
	bool is_closed = false; ///< True if the curve is closed; the first point is not repeated.
};

} // namespace

static FlatPath flatten(const Path3D *path, const Node3D *field) {
	const Transform3D to_field = axes_of(field).affine_inverse() * axes_of(path);
	FlatPath flat;
	for (const Vector3 &point : path->get_curve()->tessellate(OUTLINE_STAGES, OUTLINE_TOLERANCE_DEGREES)) {
		const Vector3 placed = to_field.xform(point);
		flat.points.push_back({ placed.x, placed.z });
	}
	flat.is_closed = flat.points.size() > 2 && flat.points.front() == flat.points.back();
	if (flat.points.size() > 1 && flat.points.front() == flat.points.back()) {
		flat.points.pop_back();
	}
	return flat;
}

// Returns the outline of another field in the axes of `field`.
static Polygon outline_of(const PlantField3D *other, const Node3D *field) {
	const Transform3D to_field = axes_of(field).affine_inverse() * axes_of(other);
	Polygon outline = other->outline_polygon();
	for (glm::vec2 &point : outline) {
		const Vector3 placed = to_field.xform(Vector3(point.x, 0.0f, point.y));
		point = { placed.x, placed.z };
	}
	return outline;
}

static const Path3D *find_path(const Node3D *field, const NodePath &path) {
	const Path3D *found = path.is_empty() ? nullptr : Object::cast_to<Path3D>(field->get_node_or_null(path));
	return found && found->get_curve().is_valid() ? found : nullptr;
}

// Joins rings that do not cross each other into one polygon. The line to each ring from the first is there twice, so
// that it has no effect.
static Polygon joined(const TypedArray<PackedVector2Array> &rings) {
	Polygon all;
	for (int64_t i = 0; i < rings.size(); i++) {
		const PackedVector2Array ring = rings[i];
		for (int64_t corner = 0; corner <= ring.size() && !ring.is_empty(); corner++) {
			const Vector2 &place = ring[corner % ring.size()];
			all.push_back({ place.x, place.y });
		}
		if (i > 0 && !all.empty()) {
			all.push_back(all.front());
		}
	}
	return all;
}

// Returns the area within half of `width` (m) of a path.
static Polygon band_along(const FlatPath &path, float width) {
	PackedVector2Array line;
	for (const glm::vec2 &point : path.points) {
		line.push_back(Vector2(point.x, point.y));
	}
	if (line.size() < 2) {
		return {};
	}
	return joined(Geometry2D::get_singleton()->offset_polyline(line, 0.5f * width, Geometry2D::JOIN_MITER,
			path.is_closed ? Geometry2D::END_JOINED : Geometry2D::END_BUTT));
}

static Polygon area_of(const FlatPath &path, double width) {
	return width > 0.0 ? band_along(path, float(width)) : path.points;
}

// Returns the painted area; empty if nothing is painted.
static Polygon painted_area(const PlacementOptions &options) {
	if (options.map.is_null() || options.map->density().painted().is_empty()) {
		return {};
	}
	const DensityMap &map = options.map->density();
	const AreaBox box = map.box_of(map.painted());
	const auto near = [](float place) { return std::clamp(place, -FARTHEST_COORDINATE, FARTHEST_COORDINATE); };
	return { { near(box.low.x), near(box.low.y) }, { near(box.high.x), near(box.low.y) },
		{ near(box.high.x), near(box.high.y) }, { near(box.low.x), near(box.high.y) } };
}

Polygon read_outline(const Node3D *field, const PlacementOptions &options) {
	const Polygon painted = painted_area(options);
	if (!painted.empty() || options.endless) {
		return painted;
	}
	const Path3D *path = field->is_inside_tree() ? find_path(field, options.outline) : nullptr;
	return path ? area_of(flatten(path, field), options.outline_width) : rectangle({ options.size.x, options.size.y });
}

// Describes a curve that is too short, and its remedy.
static String find_short_fault(const FlatPath &path, double width, const String &its_width) {
	if (width > 0.0) {
		return path.points.size() > 1 ? String() : "has a curve of fewer than two points. Add points.";
	}
	return path.points.size() > 2
			? String()
			: "has a curve of fewer than three points, which encloses no area. Add points, or set " + its_width +
					" for a band along the curve.";
}

String find_outline_fault(const Node3D *field, const PlacementOptions &options) {
	const Path3D *path = find_path(field, options.outline);
	if (!path) {
		return "outline '" + String(options.outline) +
				"' is no Path3D with a curve. Set the path of one, or an empty path for a rectangle of Size.";
	}
	const String fault = find_short_fault(flatten(path, field), options.outline_width, "outline_width");
	return fault.is_empty() ? fault : "outline '" + String(options.outline) + "' " + fault;
}

String read_exclusion(const Node3D *field, const PlacementOptions &options, int entry, Polygon &into) {
	const NodePath path = options.exclusions[entry];
	const String name = "exclusions[" + String::num_int64(entry) + "] ";
	if (const Path3D *line = find_path(field, path)) {
		const double width = entry < options.exclusion_widths.size() ? double(options.exclusion_widths[entry]) : 0.0;
		const FlatPath flat = flatten(line, field);
		into = area_of(flat, width);
		const String fault = find_short_fault(flat, width, "exclusion_widths[" + String::num_int64(entry) + "]");
		return fault.is_empty() ? fault : name + fault;
	}
	const PlantField3D *other = Object::cast_to<PlantField3D>(field->get_node_or_null(path));
	if (!other || other == field) {
		return name + String("'") + String(path) +
				"' is neither a Path3D with a curve nor another PlantField3D. Set the path of one.";
	}
	into = outline_of(other, field);
	return String();
}

Polygon read_line(const Node3D *field, const Node3D *node, bool &is_closed) {
	is_closed = true;
	if (const PlantField3D *other = Object::cast_to<PlantField3D>(node)) {
		return outline_of(other, field);
	}
	const Path3D *path = Object::cast_to<Path3D>(node);
	if (!path || path->get_curve().is_null()) {
		return {};
	}
	const FlatPath flat = flatten(path, field);
	is_closed = flat.is_closed;
	return flat.points;
}

std::vector<Node3D *> find_area_nodes(const Node3D *field, const PlacementOptions &options) {
	TypedArray<NodePath> paths = options.exclusions.duplicate();
	paths.push_back(options.outline);
	std::vector<Node3D *> nodes;
	for (int64_t i = 0; i < paths.size(); i++) {
		const NodePath path = paths[i];
		nodes.push_back(path.is_empty() ? nullptr : Object::cast_to<Node3D>(field->get_node_or_null(path)));
		const PlantField3D *other = Object::cast_to<PlantField3D>(nodes.back());
		const NodePath outline = other ? NodePath(static_cast<const Object *>(other)->get("outline")) : NodePath();
		if (!outline.is_empty()) {
			nodes.push_back(Object::cast_to<Node3D>(other->get_node_or_null(outline)));
		}
	}
	return nodes;
}

} // namespace undergrowth
