#include "climb/climber_view.hpp"

#include "base/new_object.hpp"
#include "field/view/field_material.hpp"
#include "species/shared_resources.hpp"

#include <godot_cpp/classes/rendering_server.hpp>

#include <algorithm>

using namespace godot;

namespace undergrowth {

static constexpr float STEM_DETAIL = 6.0f; // m to the camera, at which stems are round.
static constexpr float SHADOWS_TO = 40.0f; // m: leaves of farther levels cast no shadows.
static const char *const INCLUDE_NAME = "undergrowth_climb.gdshaderinc";

// Values for leaves in front of a wall, where the defaults are for a sward: no shaded base, few dead leaves, and no
// patches, which depend on the position seen from above.
static void set_defaults(const Ref<ShaderMaterial> &material) {
	material->set_shader_parameter("base_tone", 0.7f);
	material->set_shader_parameter("surface_detail", 0.8f);
	material->set_shader_parameter("patchiness", 0.0f);
	material->set_shader_parameter("clumpiness", 0.25f);
	material->set_shader_parameter("dead_leaves", 0.0f);
	material->set_shader_parameter("crown_shares", Vector2(0.0f, 0.35f));
	material->set_shader_parameter("crown_far", 40.0f);
	material->set_shader_parameter("roughness", 0.6f);
	material->set_shader_parameter("specular", 0.2f);
	material->set_shader_parameter("far_openness", 0.85f);
	material->set_shader_parameter("shadow_bias", 0.01f);
}

void ClimberView::make_material(const Ref<Material> &own, const MotionSpecies &species) {
	const Ref<ShaderMaterial> source = own;
	const Ref<Shader> shader = source.is_valid() ? source->get_shader() : Ref<Shader>();
	if (shader.is_valid() && shader->get_code().contains(INCLUDE_NAME)) {
		material = source->duplicate();
	} else {
		material = new_counted<ShaderMaterial>();
		material->set_shader(climber_shader());
		set_defaults(material);
	}
	set_stem_parameters(material, species);
}

void ClimberView::clear() {
	if (RenderingServer *server = RenderingServer::get_singleton()) {
		for (const Instance &one : instances) {
			server->free_rid(one.instance);
			if (one.multimesh.is_valid()) {
				server->free_rid(one.multimesh);
			}
		}
	}
	instances.clear();
	meshes.clear();
	whole = AABB();
}

void ClimberView::apply(const Instance &one) const {
	RenderingServer *server = RenderingServer::get_singleton();
	server->instance_set_layer_mask(one.instance, layers);
	server->instance_set_visible(one.instance, is_visible);
	const bool casts = casts_shadows && one.casts_shadows;
	server->instance_geometry_set_cast_shadows_setting(one.instance,
			casts ? RenderingServer::SHADOW_CASTING_SETTING_ON : RenderingServer::SHADOW_CASTING_SETTING_OFF);
}

// The engine measures the distance to the middle of the box; the nearest leaf may be nearer by its radius.
void ClimberView::add(
		const RID &base, const RID &multimesh, const ClimberChunk &chunk, float begin, float end, bool casts) {
	RenderingServer *server = RenderingServer::get_singleton();
	Instance made;
	made.instance = server->instance_create2(base, world);
	made.multimesh = multimesh;
	made.body = chunk.body;
	made.casts_shadows = casts;
	const float radius = 0.5f * float(chunk.box.size.length());
	server->instance_geometry_set_visibility_range(made.instance, begin > 0.0f ? begin + radius : 0.0f,
			end > 0.0f ? end + radius : 0.0f, 0.0f, 0.0f, RenderingServer::VISIBILITY_RANGE_FADE_DISABLED);
	server->instance_set_custom_aabb(made.instance, chunk.box);
	server->instance_attach_object_instance_id(made.instance, owner);
	apply(made);
	instances.push_back(made);
}

void ClimberView::add_leaves(const ClimberBuild &build, const ClimberChunk &chunk, int level) {
	const float begin = build.begins[size_t(level)];
	const float end = level + 1 < CLIMBER_LEVEL_COUNT ? build.begins[size_t(level) + 1] : 0.0f;
	const PackedFloat32Array &buffer = chunk.buffers[size_t(level)];
	if ((end > 0.0f && end <= begin) || buffer.is_empty()) {
		return;
	}
	RenderingServer *server = RenderingServer::get_singleton();
	const RID multimesh = server->multimesh_create();
	server->multimesh_allocate_data(multimesh, int(buffer.size()) / INSTANCE_FLOATS,
			RenderingServer::MULTIMESH_TRANSFORM_3D, true, true, false);
	server->multimesh_set_mesh(multimesh, build.leaf_meshes[size_t(level)]->get_rid());
	server->multimesh_set_custom_aabb(multimesh, chunk.box);
	server->multimesh_set_buffer(multimesh, buffer);
	add(multimesh, multimesh, chunk, begin, end, begin < SHADOWS_TO);
	server->instance_geometry_set_material_override(instances.back().instance, material->get_rid());
}

void ClimberView::add_stems(const ClimberChunk &chunk, int level) {
	const Ref<ArrayMesh> &mesh = chunk.stems[size_t(level)];
	if (mesh.is_valid()) {
		meshes.push_back(mesh);
		add(mesh->get_rid(), RID(), chunk, level > 0 ? STEM_DETAIL : 0.0f, level > 0 ? 0.0f : STEM_DETAIL, level == 0);
	}
}

void ClimberView::show(ClimberBuild &build, const Ref<Material> &own, const MotionSpecies &species) {
	clear();
	make_material(own, species);
	build.make_meshes();
	meshes.assign(build.leaf_meshes.begin(), build.leaf_meshes.end());
	for (const ClimberChunk &chunk : build.chunks) {
		whole = instances.empty() ? chunk.box : whole.merge(chunk.box);
		for (int level = 0; level < CLIMBER_LEVEL_COUNT; level++) {
			add_leaves(build, chunk, level);
		}
		for (int level = 0; level < STEM_LEVELS; level++) {
			add_stems(chunk, level);
		}
	}
	set_stem_material(stem_material);
	place(places);
}

void ClimberView::place(const std::vector<Transform3D> &of_bodies) {
	places = of_bodies;
	for (const Instance &one : instances) {
		if (size_t(one.body) < places.size()) {
			RenderingServer::get_singleton()->instance_set_transform(one.instance, places[size_t(one.body)]);
		}
	}
}

void ClimberView::set_world(const RID &scenario) {
	world = scenario;
	for (const Instance &one : instances) {
		RenderingServer::get_singleton()->instance_set_scenario(one.instance, world);
	}
}

void ClimberView::set_visible(bool on) {
	is_visible = on;
	std::for_each(instances.begin(), instances.end(), [this](const Instance &one) { apply(one); });
}

void ClimberView::set_layers(uint32_t mask) {
	layers = mask;
	std::for_each(instances.begin(), instances.end(), [this](const Instance &one) { apply(one); });
}

void ClimberView::set_casts_shadows(bool on) {
	casts_shadows = on;
	std::for_each(instances.begin(), instances.end(), [this](const Instance &one) { apply(one); });
}

void ClimberView::set_owner(uint64_t object) {
	owner = object;
	for (const Instance &one : instances) {
		RenderingServer::get_singleton()->instance_attach_object_instance_id(one.instance, owner);
	}
}

void ClimberView::set_stem_material(const Ref<Material> &changed) {
	stem_material = changed;
	for (const Instance &one : instances) {
		if (!one.multimesh.is_valid()) {
			RenderingServer::get_singleton()->instance_geometry_set_material_override(
					one.instance, stem_material.is_valid() ? stem_material->get_rid() : RID());
		}
	}
}

} // namespace undergrowth
