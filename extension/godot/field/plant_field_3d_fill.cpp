// The part of PlantField3D that fills it: from properties to plants that stand.

#include "field/plant_field_3d.hpp"

#include "base/random.hpp"
#include "conventions.hpp"
#include "convert.hpp"
#include "field/field_material.hpp"
#include "plant_simulation.hpp"

#include <godot_cpp/classes/mesh_instance3d.hpp>
#include <godot_cpp/classes/world3d.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr double RAY_USEC = 3000.0; // A frame.
static constexpr float RADIANS_PER_DEGREE = float(PI / 180.0);
static constexpr int MOST_CHUNK_FACTOR = 4;
static constexpr float FARTHEST = 1e9f; // m.
static constexpr float OUTLINE_TOLERANCE_DEGREES = 4.0f;
static constexpr int OUTLINE_STAGES = 5;

void PlantField3D::report_problem(const String &what) {
	if (what != problem) { // The same fault is told once, however often the field is filled.
		problem = what;
		report_error(this, problem);
		update_configuration_warnings();
	}
}

// Many properties may change in one frame; the field is filled once, after it.
void PlantField3D::mark_stale() {
	is_stale = true;
	if (is_inside_tree() && !fill_is_queued) {
		fill_is_queued = true;
		call_deferred("_on_fill_queued");
	}
}

void PlantField3D::on_fill_queued() {
	fill_is_queued = false;
	if (is_stale && is_inside_tree() && !fill_job) {
		fill();
	}
}

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
		const Transform3D to_field = get_global_transform().affine_inverse() * other->get_global_transform();
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
		if (i + 1 == levels.size() || level.end <= level.begin) {
			level.end = float(options.visibility_range);
		}
		level.margin = std::max(float(options.fade_margin), 1e-3f);
		level.chunk_factor = std::min(1 << int(i), MOST_CHUNK_FACTOR);
		level.casts_shadows = level.begin < options.shadow_distance;
		made.push_back(level);
		if (level.end == float(options.visibility_range)) {
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
	if (into.kind != FieldGround::Kind::mesh) {
		return String();
	}
	const MeshInstance3D *instance = Object::cast_to<MeshInstance3D>(get_node_or_null(ground_mesh));
	const Ref<Mesh> mesh = instance ? instance->get_mesh() : Ref<Mesh>();
	if (mesh.is_null()) {
		return "ground_mesh leads to no MeshInstance3D with a mesh. Set its path, or another ground.";
	}
	const Transform3D to_field = get_global_transform().affine_inverse() * instance->get_global_transform();
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
	recipe.settings.write_followers = false;
	recipe.settings.seed = uint64_t(options.seed);
	recipe.chunk_size = float(options.chunk_size);
	recipe.wind = wind_here(wind.is_valid() ? wind->get_time() : 0.0);
	return fault;
}

void PlantField3D::fill() {
	if (!is_inside_tree()) {
		is_stale = true; // It is filled when it enters the tree.
		return;
	}
	is_stale = false;
	rays.reset();
	fill_job.reset();
	FieldRecipe recipe;
	const String fault = make_recipe(recipe);
	if (!fault.is_empty()) {
		report_problem(fault);
		update_processing();
		return;
	}
	if (!problem.is_empty()) {
		problem = String();
		update_configuration_warnings();
	}
	fill_job = std::make_unique<FieldFill>(std::move(recipe));
	told_progress = -1.0f;
	fill_job->start();
	update_processing();
}

bool PlantField3D::is_filling() const {
	return fill_job || (is_stale && fill_is_queued);
}

void PlantField3D::poll_fill() {
	if (fill_job->wants_ground()) {
		if (!rays) {
			rays = std::make_unique<FieldRays>(get_world_3d(), get_global_transform(), uint32_t(options.ground_mask));
		}
		if (rays->cast(fill_job->plants(), RAY_USEC)) {
			fill_job->go_on(std::move(rays->heights), std::move(rays->normals));
			rays.reset();
		}
	}
	const bool is_done = fill_job->is_done();
	const float progress = is_done ? 1.0f : fill_job->progress();
	if (is_done) {
		const std::unique_ptr<FieldFill> job = std::move(fill_job);
		adopt(job->finish());
	}
	if (progress != told_progress) {
		told_progress = progress;
		emit_signal("filling_progressed", progress);
	}
	if (is_done) {
		emit_signal("filled");
	}
}

void PlantField3D::adopt(FieldResult &result) {
	finish_step();
	keep_added();
	patches.clear();
	drawings.clear();
	simulation = std::move(result.simulation);
	bends = std::move(result.bends);
	style = std::move(result.style);
	patches.push_back(std::make_unique<FieldPatch>(std::move(result.patch)));
	drawings.push_back(std::make_unique<FieldDrawing>());
	filled_patches = 1;
	bends->make_textures();
	dress();
	restart_drawing(*drawings.back());
	drawings.back()->show(style, result.plans);
	clock = FixedStep(PlantSimulation::get_singleton()->get_step_length());
	seen_wind_time = -1.0;
	if (options.contact) {
		touching.fit(*simulation);
	}
	upload();
	if (is_stale) {
		mark_stale();
	}
	update_processing();
}

void PlantField3D::restart_drawing(FieldDrawing &drawing) {
	drawing.set_scenario(get_world_3d().is_valid() ? get_world_3d()->get_scenario() : RID());
	drawing.set_transform(get_global_transform());
	drawing.set_visible(is_visible_in_tree());
	drawing.set_layers(uint32_t(options.layers));
}

// Materials belong to one field and level, since textures cannot differ by instance.
void PlantField3D::dress() {
	for (FieldLook &look : style.looks) {
		const bool is_new = look.materials.empty();
		for (size_t i = look.materials.size(); i < style.levels.size(); i++) {
			const FieldLevel &level = style.levels[i];
			const float begin = level.begin > 0.0f ? level.begin : -FARTHEST;
			const float end = level.end > 0.0f ? level.end : FARTHEST;
			const Ref<ShaderMaterial> material = make_field_material(look.function->get_material());
			material->set_shader_parameter("undergrowth_level", Vector3(begin, end, level.margin));
			look.materials.push_back(material);
		}
		for (const Ref<ShaderMaterial> &material : look.materials) {
			material->set_shader_parameter("undergrowth_bends", bends->bends_texture());
			material->set_shader_parameter("undergrowth_blends", bends->blends_texture());
		}
		if (is_new && !bends_in_shader(look.materials[0])) {
			report_error(look.function.ptr(),
					"its material has a shader that does not bend in a PlantField3D. Include "
					"undergrowth_bend.gdshaderinc, which says how.");
		}
	}
}

// What was added by code outlives a new fill.
void PlantField3D::keep_added() {
	for (size_t i = size_t(filled_patches); i < patches.size(); i++) {
		const FieldPatch &patch = *patches[i];
		std::vector<std::vector<PlacedPlant>> by_species(style.looks.size());
		for (int plant = 0; plant < patch.plants.size(); plant++) {
			if (patch.places[size_t(plant)] != FieldPatch::GONE) {
				by_species[patch.plants.species[size_t(plant)]].push_back(patch.plants.plant(plant));
			}
		}
		for (size_t look = 0; look < by_species.size(); look++) {
			add_pending(style.looks[look].function, std::move(by_species[look]));
		}
	}
}

} // namespace undergrowth
