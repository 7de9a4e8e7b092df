// Puts plants into multimeshes: field_clumps.cpp plans them, this shows them.

#include "field/field_drawing.hpp"

#include <godot_cpp/classes/rendering_server.hpp>

#include <algorithm>

using namespace godot;

namespace undergrowth {

template <class Act> void FieldDrawing::for_each(Act &&act) const {
	RenderingServer *server = RenderingServer::get_singleton();
	for (const auto &[place, group] : clumps) {
		for (const Clump &clump : group) {
			act(server, clump);
		}
	}
}

static void free_clump(RenderingServer *server, const FieldDrawing::Clump &clump) {
	server->free_rid(clump.instance);
	server->free_rid(clump.multimesh);
}

FieldDrawing::~FieldDrawing() {
	if (RenderingServer::get_singleton()) {
		for_each(free_clump);
	}
}

// The engine measures to the middle of the box; the shader measures to each plant.
static void set_range(RenderingServer *server, const FieldDrawing::Clump &clump, const FieldLevel &level) {
	const float begin = std::max(level.begin - clump.radius - level.margin, 0.0f);
	const float end = level.end > 0.0f ? level.end + clump.radius : 0.0f;
	server->instance_geometry_set_visibility_range(
			clump.instance, begin, end, 0.0f, 0.0f, RenderingServer::VISIBILITY_RANGE_FADE_DISABLED);
}

FieldDrawing::Clump FieldDrawing::make(const FieldStyle &style, const ClumpPlan &plan) {
	RenderingServer *server = RenderingServer::get_singleton();
	const FieldLevel &level = style.levels[size_t(plan.place.level)];
	const FieldLook &look = style.looks[size_t(plan.species)];
	Clump clump;
	clump.count = plan.count;
	clump.middle = plan.box.get_center();
	clump.radius = 0.5f * plan.box.size.length();
	clump.multimesh = server->multimesh_create();
	server->multimesh_allocate_data(
			clump.multimesh, plan.count, RenderingServer::MULTIMESH_TRANSFORM_3D, style.needs_colors, true, false);
	server->multimesh_set_mesh(clump.multimesh, look.meshes[size_t(plan.place.level)][size_t(plan.group)]->get_rid());
	server->multimesh_set_custom_aabb(clump.multimesh, plan.box);
	server->multimesh_set_buffer(clump.multimesh, plan.buffer);
	clump.instance = server->instance_create2(clump.multimesh, world);
	server->instance_set_transform(clump.instance, placed);
	server->instance_set_visible(clump.instance, is_visible);
	server->instance_set_layer_mask(clump.instance, layers);
	server->instance_geometry_set_material_override(
			clump.instance, look.materials[size_t(plan.place.level)]->get_rid());
	server->instance_geometry_set_cast_shadows_setting(clump.instance,
			level.casts_shadows ? RenderingServer::SHADOW_CASTING_SETTING_ON
								: RenderingServer::SHADOW_CASTING_SETTING_OFF);
	set_range(server, clump, level);
	return clump;
}

void FieldDrawing::show(const FieldStyle &style, const std::vector<ClumpPlan> &plans) {
	for (const ClumpPlan &plan : plans) {
		clumps[plan.place].push_back(make(style, plan));
	}
}

void FieldDrawing::replace(const FieldStyle &style, const ClumpPlace &place, const std::vector<ClumpPlan> &plans) {
	const auto found = clumps.find(place);
	if (found != clumps.end()) {
		for (const Clump &clump : found->second) {
			free_clump(RenderingServer::get_singleton(), clump);
		}
		clumps.erase(found);
	}
	show(style, plans);
}

void FieldDrawing::set_scenario(const RID &scenario) {
	world = scenario;
	for_each(
			[&](RenderingServer *server, const Clump &clump) { server->instance_set_scenario(clump.instance, world); });
}

void FieldDrawing::set_transform(const Transform3D &transform) {
	if (!transform.is_finite()) {
		return; // The engine would complain once for each multimesh.
	}
	placed = transform;
	for_each([&](RenderingServer *server, const Clump &clump) {
		server->instance_set_transform(clump.instance, placed);
	});
}

void FieldDrawing::set_visible(bool visible) {
	is_visible = visible;
	for_each([&](RenderingServer *server, const Clump &clump) {
		server->instance_set_visible(clump.instance, visible);
	});
}

void FieldDrawing::set_layers(uint32_t mask) {
	layers = mask;
	for_each([&](RenderingServer *server, const Clump &clump) {
		server->instance_set_layer_mask(clump.instance, mask);
	});
}

std::vector<int> FieldDrawing::count_drawn(const FieldStyle &style, const Vector3 &eye) const {
	std::vector<int> drawn(style.levels.size(), 0);
	for (const auto &[place, group] : clumps) {
		const FieldLevel &level = style.levels[size_t(place.level)];
		for (const Clump &clump : group) {
			const float away = clump.middle.distance_to(eye);
			if (away >= level.begin - clump.radius && (level.end <= 0.0f || away < level.end + clump.radius)) {
				drawn[size_t(place.level)] += clump.count;
			}
		}
	}
	return drawn;
}

} // namespace undergrowth
