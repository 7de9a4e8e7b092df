// The part of PlantField3D that fills it: from properties to plants that stand.

#include "field/plant_field_3d.hpp"

#include "field/field_material.hpp"
#include "messages.hpp"
#include "plant_simulation.hpp"

#include <godot_cpp/classes/world3d.hpp>

#include <algorithm>

using namespace godot;

namespace undergrowth {

// Rays of one frame: at least so long, and a share of frames that take long anyway.
static constexpr double LEAST_RAY_USEC = 3000.0;
static constexpr double MOST_RAY_USEC = 50000.0;
static constexpr double RAY_SHARE = 0.2;
static constexpr float FARTHEST = 1e9f; // m.

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
		set_physics_process_internal(true);
		return;
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

// In a physics frame: only then may everybody ask physics.
void PlantField3D::cast_rays() {
	if (!fill_job || !fill_job->wants_ground()) {
		set_physics_process_internal(false);
		return;
	}
	if (!rays) {
		rays = std::make_unique<FieldRays>(axes(), uint32_t(options.ground_mask));
	}
	const double usec = std::clamp(1e6 * RAY_SHARE * get_physics_process_delta_time(), LEAST_RAY_USEC, MOST_RAY_USEC);
	const TypedArray<RID> excluded = collision_objects_of(get_tree(), bodies_group);
	const FieldRays::State state = rays->cast(get_world_3d(), excluded, fill_job->plants(), usec);
	if (state == FieldRays::State::going_on) {
		return;
	}
	set_physics_process_internal(false);
	if (state == FieldRays::State::failed) {
		report_problem(
				"there is no 3D physics to cast rays at, so nothing is planted. Choose a 3D physics engine in the "
				"project settings, or another ground.");
		fill_job.reset();
	} else {
		tell_of_no_ground();
		fill_job->go_on(std::move(rays->heights), std::move(rays->normals));
	}
	rays.reset();
}

void PlantField3D::tell_of_no_ground() {
	const bool is_missed = !rays->has_hit() && fill_job->plants().size() > 0;
	if (is_missed && !has_missed_ground) {
		report_warning(this,
				"no collider is below or above it, so nothing grows. Check that ground_mask has a layer of the ground, "
				"that the ground is within 1000 m, and call fill() once it is there where it comes later.");
	}
	has_missed_ground = is_missed;
}

void PlantField3D::adopt(FieldResult &result) {
	finish_step();
	release_all_skeletons();
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

} // namespace undergrowth
