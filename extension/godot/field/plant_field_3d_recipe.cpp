// The part of PlantField3D that reads from properties what a fill needs to know.

#include "field/plant_field_3d.hpp"

#include "base/random.hpp"
#include "conventions.hpp"
#include "convert.hpp"
#include "plant_simulation.hpp"

#include <godot_cpp/classes/mesh_instance3d.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr float RADIANS_PER_DEGREE = float(PI / 180.0);
static constexpr int MOST_CHUNK_FACTOR = 4;
static constexpr float OUTLINE_TOLERANCE_DEGREES = 4.0f;
static constexpr int OUTLINE_STAGES = 5;

static Polygon flatten(const Ref<Curve3D> &curve, const Transform3D &to_field) {
	Polygon polygon;
	const PackedVector3Array points = curve->tessellate(OUTLINE_STAGES, OUTLINE_TOLERANCE_DEGREES);
	for (const Vector3 &point : points) {
		const Vector3 placed = to_field.xform(point);
		polygon.push_back({ placed.x, placed.z });
	}
	if (polygon.size() > 1 && polygon.front() == polygon.back()) {
		polygon.pop_back(); // Closed curves repeat their first point.
	}
	return polygon;
}

Polygon PlantField3D::outline() const {
	return area.is_valid() ? flatten(area, Transform3D()) : rectangle({ options.size.x, options.size.y });
}

String PlantField3D::make_request(PlacementRequest &into) {
	into.area = outline();
	for (int64_t i = 0; i < exclusions.size(); i++) {
		const Ref<Curve3D> curve = exclusions[i];
		if (curve.is_valid()) {
			into.exclusions.push_back(flatten(curve, Transform3D()));
		}
	}
	for (int64_t i = 0; i < excluded_fields.size(); i++) {
		const PlantField3D *other = Object::cast_to<PlantField3D>(get_node_or_null(excluded_fields[i]));
		if (!other || other == this) {
			return "excluded_fields[" + String::num_int64(i) + "] leads to no other PlantField3D. Set a path to one.";
		}
		const Transform3D to_field = axes().affine_inverse() * other->axes();
		Polygon polygon = other->outline();
		for (glm::vec2 &point : polygon) {
			const Vector3 placed = to_field.xform(Vector3(point.x, 0.0f, point.y));
			point = { placed.x, placed.z };
		}
		into.exclusions.push_back(std::move(polygon));
	}
	into.density = float(options.density);
	into.seed = uint64_t(options.seed);
	into.clumping = float(options.clumping);
	into.drift_size = float(options.drift_size);
	for (int64_t i = 0; i < species.size(); i++) {
		PlacementSpecies kind;
		kind.share = i < shares.size() ? shares[i] : 1.0f;
		kind.variants = options.variants;
		kind.least_scale = options.scale_range.x;
		kind.most_scale = options.scale_range.y;
		kind.height_deviation = float(options.height_deviation);
		kind.most_lean = float(options.lean_deviation_degrees) * RADIANS_PER_DEGREE;
		into.species.push_back(kind);
	}
	const PlacementFault fault = find_placement_fault(into);
	if (fault == PlacementFault::bad_area) {
		return describe(find_area_fault(into.area));
	}
	return fault == PlacementFault::none ? String() : String(undergrowth::describe(fault));
}

std::vector<FieldLevel> PlantField3D::make_levels() const {
	std::vector<FieldLevel> made;
	for (int64_t i = 0; i < levels.size(); i++) {
		FieldLevel level;
		level.lod = levels[i];
		level.begin = i > 0 ? made.back().end : 0.0f;
		level.end = i < level_distances.size() ? level_distances[i] : 0.0f;
		const float range = float(options.visibility_range);
		const bool is_last = i + 1 == levels.size() || level.end <= level.begin || (range > 0.0f && level.end >= range);
		level.end = is_last ? range : level.end;
		level.margin = std::max(float(options.fade_margin), 1e-3f);
		level.chunk_factor = std::min(1 << int(i), MOST_CHUNK_FACTOR);
		level.casts_shadows = level.begin < options.shadow_distance;
		made.push_back(level);
		if (is_last) {
			break; // Nothing is seen behind it.
		}
	}
	return made;
}

void PlantField3D::start_style(FieldStyle &into) const {
	into.levels = make_levels();
	into.needs_colors = RenderingServer::get_singleton()->get_current_rendering_method() == String("gl_compatibility");
}

// The headless engine's stand-in for a renderer may not be used by two threads at once. It has no adapter.
static bool renders_on_threads() {
	return !RenderingServer::get_singleton()->get_video_adapter_name().is_empty();
}

String PlantField3D::make_style(FieldStyle &into) {
	start_style(into);
	for (int64_t i = 0; i < species.size(); i++) {
		FieldLook look;
		look.function = species[i];
		if (look.function.is_null()) {
			return "species[" + String::num_int64(i) + "] is empty. Set a PlantFunction there, or remove the entry.";
		}
		const int64_t look_seed = int64_t(mix_bits(uint64_t(options.seed) ^ mix_bits(uint64_t(i))));
		const String fault = look.sample(into.levels, options.variants, look_seed);
		if (!fault.is_empty()) {
			return describe(look.function.ptr()) + ": " + fault;
		}
		if (!renders_on_threads()) {
			look.build();
		}
		into.looks.push_back(std::move(look));
	}
	return String();
}

String PlantField3D::make_ground(FieldGround &into) {
	into.kind = FieldGround::Kind(options.ground);
	into.limits.lowest = options.height_limits.x;
	into.limits.highest = options.height_limits.y;
	into.limits.flattest = options.slope_limits_degrees.x * RADIANS_PER_DEGREE;
	into.limits.steepest = options.slope_limits_degrees.y * RADIANS_PER_DEGREE;
	into.limits.alignment = float(options.slope_alignment);
	if (into.kind != FieldGround::Kind::mesh) {
		return String();
	}
	const MeshInstance3D *instance = Object::cast_to<MeshInstance3D>(get_node_or_null(ground_mesh));
	const Ref<Mesh> mesh = instance ? instance->get_mesh() : Ref<Mesh>();
	if (mesh.is_null()) {
		return "ground_mesh leads to no MeshInstance3D with a mesh. Set its path, or another ground.";
	}
	const Transform3D to_field = axes().affine_inverse() * instance->get_global_transform();
	into.triangles = mesh->get_faces();
	Vector3 *corners = into.triangles.ptrw();
	for (int64_t i = 0; i < into.triangles.size(); i++) {
		corners[i] = to_field.xform(corners[i]);
	}
	return String();
}

String PlantField3D::make_recipe(FieldRecipe &recipe) {
	const bool has_filled = filled_patches > 0 && patches[0]->plants.size() > 0;
	if (species.is_empty() && has_filled) {
		return "has no species any more; its plants stay. Add a PlantFunction to species.";
	}
	String fault = species.is_empty() ? String() : make_request(recipe.request); // Else only what code adds.
	if (fault.is_empty()) {
		fault = make_ground(recipe.ground);
	}
	if (fault.is_empty()) {
		fault = make_style(recipe.style);
	}
	recipe.settings.step = float(PlantSimulation::get_singleton()->get_step_length());
	recipe.settings.update_interval = options.update_interval;
	recipe.settings.prototypes = options.prototypes;
	recipe.settings.seed = uint64_t(options.seed);
	recipe.chunk_size = float(options.chunk_size);
	recipe.wind = wind_here(wind, wind.is_valid() ? wind->get_time() : 0.0);
	return fault;
}

} // namespace undergrowth
