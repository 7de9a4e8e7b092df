// Queries of plants by position in the world, and edits of all plants found.

#include "field/plant_queries.hpp"

#include "base/convert.hpp"
#include "base/messages.hpp"

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static bool is_radius(double radius) {
	return std::isfinite(radius) && radius >= 0.0;
}

PackedInt64Array PlantQueries::ids_of(const std::vector<PlantRef> &places) const {
	PackedInt64Array ids;
	ids.resize(int64_t(places.size()));
	int64_t *to = ids.ptrw();
	for (const PlantRef &place : places) {
		*to++ = runtime.store.id(place);
	}
	return ids;
}

// Removes plants from the list if `is_beside` returns true for their root in the world.
template <class IsBeside>
static void remove_beside(
		const PlantStore &store, const Transform3D &placed, std::vector<PlantRef> &found, const IsBeside &is_beside) {
	const auto goes = [&](const PlantRef &place) {
		return is_beside(placed.xform(to_godot(store.chunk(place.chunk).root(place.slot))));
	};
	found.erase(std::remove_if(found.begin(), found.end(), goes), found.end());
}

// Converts metres of the world to the field's axes.
static float reach_in(const Transform3D &to_field, double radius) {
	return float(radius) * to_field.basis.get_column(1).length();
}

std::optional<PlantQueries::Sphere> PlantQueries::sphere_of(
		const char *method, const Vector3 &center, double radius) const {
	if (!center.is_finite() || !is_radius(radius)) {
		report_error(node, String(method) + "() needs a finite centre and a radius of 0 or more.");
		return std::nullopt;
	}
	if (!node->is_inside_tree()) {
		return std::nullopt;
	}
	const Transform3D placed = axes_of(node);
	const Vector3 scale = placed.basis.get_scale().abs();
	const float smallest = std::min({ scale.x, scale.y, scale.z });
	const bool is_even = scale.is_equal_approx(Vector3(smallest, smallest, smallest));
	return Sphere{ to_glm(placed.affine_inverse().xform(center)), float(radius) / smallest, center, float(radius),
		placed, is_even };
}

void PlantQueries::find_in(const Sphere &sphere, std::vector<PlantRef> &found) const {
	runtime.store.find_in_sphere(sphere.center, sphere.radius, found);
	if (!sphere.is_even) { // In the field's axes the sphere is an ellipsoid.
		remove_beside(runtime.store, sphere.placed, found,
				[&](const Vector3 &root) { return root.distance_to(sphere.world_center) > sphere.world_radius; });
	}
}

std::vector<PlantRef> PlantQueries::in_sphere(const char *method, const Vector3 &center, double radius) const {
	std::vector<PlantRef> found;
	if (const std::optional<Sphere> sphere = sphere_of(method, center, radius)) {
		find_in(*sphere, found);
	}
	return found;
}

int PlantQueries::remove_found(const AreaBox &box, const Find &find) {
	const auto remove = [this, find] {
		std::vector<PlantRef> found;
		find(found);
		return runtime.remove(std::move(found));
	};
	runtime.repeat_in_first_build(box, [remove] { remove(); });
	return remove();
}

PackedInt64Array PlantQueries::find_in_sphere(const Vector3 &center, double radius) const {
	return ids_of(in_sphere("find_plants_in_sphere", center, radius));
}

// The bounding box, in the field's axes, of a box of the world.
static AABB box_in_field(const Transform3D &placed, const AABB &box) {
	const Transform3D to_field = placed.affine_inverse();
	AABB around(to_field.xform(box.position), Vector3());
	for (int i = 1; i < 8; i++) {
		around.expand_to(to_field.xform(box.position + box.size * Vector3(i & 1, i >> 1 & 1, i >> 2)));
	}
	return around;
}

static void find_in_world_box(
		const PlantStore &store, const Transform3D &placed, const AABB &box, std::vector<PlantRef> &found) {
	const AABB around = box_in_field(placed, box);
	store.find_in_box(to_glm(around.position), to_glm(around.get_end()), found);
	// In a rotated field the bounding box is larger.
	remove_beside(store, placed, found, [&](const Vector3 &root) { return !box.has_point(root); });
}

// The same in a box.
std::vector<PlantRef> PlantQueries::in_box(const char *method, const AABB &box) const {
	std::vector<PlantRef> found;
	if (!box.is_finite()) {
		report_error(node, String(method) + "() needs a finite box.");
	}
	if (!box.is_finite() || !node->is_inside_tree()) {
		return found;
	}
	find_in_world_box(runtime.store, axes_of(node), box, found);
	return found;
}

PackedInt64Array PlantQueries::find_in_box(const AABB &box) const {
	return ids_of(in_box("find_plants_in_box", box));
}

int64_t PlantQueries::find_nearest(const Vector3 &point, double max_distance) const {
	if (!point.is_finite() || !(max_distance >= 0.0)) {
		report_error(node, "find_nearest_plant() needs a finite point and a distance of 0 or more.");
		return NO_PLANT;
	}
	if (!node->is_inside_tree()) {
		return NO_PLANT;
	}
	const Transform3D to_field = axes_of(node).affine_inverse();
	const PlantRef found = runtime.store.find_nearest(to_glm(to_field.xform(point)), reach_in(to_field, max_distance));
	return found.chunk < 0 ? NO_PLANT : runtime.store.id(found);
}

Ref<PlantFunction> PlantQueries::species_at(const Vector3 &point, double max_distance) const {
	const int64_t nearest = find_nearest(point, max_distance);
	return nearest == NO_PLANT ? Ref<PlantFunction>() : species(nearest);
}

int PlantQueries::remove_in_sphere(const Vector3 &center, double radius) {
	const std::optional<Sphere> sphere = sphere_of("remove_in_sphere", center, radius);
	if (!sphere) {
		return 0;
	}
	const glm::vec2 middle = { sphere->center.x, sphere->center.z };
	return remove_found({ middle - sphere->radius, middle + sphere->radius },
			[this, one = *sphere](std::vector<PlantRef> &found) { find_in(one, found); });
}

int PlantQueries::remove_in_box(const AABB &box) {
	if (!box.is_finite() || !node->is_inside_tree()) {
		return int(in_box("remove_in_box", box).size());
	}
	const Transform3D placed = axes_of(node);
	const AABB around = box_in_field(placed, box);
	const Vector3 end = around.get_end();
	return remove_found({ { around.position.x, around.position.z }, { end.x, end.z } },
			[this, placed, box](
					std::vector<PlantRef> &found) { find_in_world_box(runtime.store, placed, box, found); });
}

int PlantQueries::remove_in_polygon(const PackedVector3Array &points) {
	if (!node->is_inside_tree()) {
		return 0;
	}
	const Transform3D to_field = axes_of(node).affine_inverse();
	Polygon polygon;
	for (const Vector3 &point : points) {
		const Vector3 place = to_field.xform(point);
		polygon.push_back({ place.x, place.z });
	}
	const AreaFault fault = find_area_fault(polygon);
	if (fault != AreaFault::none) {
		report_error(node, String("remove_in_polygon(): ") + undergrowth::describe(fault));
		return 0;
	}
	return remove_found(bounding_box(polygon),
			[this, polygon](std::vector<PlantRef> &found) { runtime.store.find_in_polygon(polygon, found); });
}

int PlantQueries::remove_along(const PackedVector3Array &points, double width) {
	const Vector3 *all = points.ptr();
	const bool are_finite =
			std::all_of(all, all + points.size(), [](const Vector3 &point) { return point.is_finite(); });
	if (points.is_empty() || !are_finite || !is_radius(width)) {
		report_error(node, "remove_along() needs at least one point, finite points, and a width of 0 or more.");
		return 0;
	}
	if (!node->is_inside_tree()) {
		return 0;
	}
	const Transform3D to_field = axes_of(node).affine_inverse();
	const float reach = reach_in(to_field, 0.5 * width);
	Polygon line;
	for (int64_t i = 0; i < points.size(); i++) {
		const Vector3 point = to_field.xform(points[i]);
		line.push_back({ point.x, point.z });
	}
	const AreaBox box = bounding_box(line);
	return remove_found({ box.low - reach, box.high + reach }, [this, line, reach](std::vector<PlantRef> &found) {
		for (size_t i = 0; i < std::max(line.size() - 1, size_t(1)); i++) {
			runtime.store.find_along(line[i], line[std::min(i + 1, line.size() - 1)], reach, found);
		}
		std::sort(found.begin(), found.end()); // A plant near two of the lines is found twice.
		found.erase(std::unique(found.begin(), found.end()), found.end());
	});
}

int PlantQueries::apply_impulse_in_sphere(const Vector3 &center, double radius, const Vector3 &impulse) {
	if (!impulse.is_finite()) {
		report_error(node, "apply_impulse_in_sphere() needs a finite impulse.");
		return 0;
	}
	const std::vector<PlantRef> places = in_sphere("apply_impulse_in_sphere", center, radius);
	const glm::vec3 local_impulse = places.empty() ? glm::vec3() : to_glm(axes_of(node).basis.inverse().xform(impulse));
	for (const PlantRef &place : places) {
		runtime.motion.apply_impulse(place, local_impulse);
	}
	return int(places.size());
}

// Along the ground, away from the centre. A plant at the centre does not move.
int PlantQueries::apply_blast(const Vector3 &center, double radius, double impulse) {
	if (!std::isfinite(impulse) || radius <= 0.0) {
		report_error(node, "apply_blast() needs a radius above 0 and a finite impulse.");
		return 0;
	}
	const std::vector<PlantRef> places = in_sphere("apply_blast", center, radius);
	const Transform3D placed = places.empty() ? Transform3D() : axes_of(node);
	const Basis to_field = placed.basis.inverse();
	for (const PlantRef &place : places) {
		const Vector3 way = placed.xform(to_godot(runtime.store.chunk(place.chunk).root(place.slot))) - center;
		const Vector3 aside = Vector3(way.x, 0.0f, way.z).normalized();
		const double share = 1.0 - double(way.length()) / radius;
		runtime.motion.apply_impulse(place, to_glm(to_field.xform(aside * float(impulse * share))));
	}
	return int(places.size());
}

} // namespace undergrowth
