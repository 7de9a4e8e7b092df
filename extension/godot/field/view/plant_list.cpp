#include "field/view/plant_list.hpp"

#include <godot_cpp/classes/rendering_server.hpp>

#include <utility>

using namespace godot;

namespace undergrowth {

PlantList::PlantList(const RID &own_mesh, int stride) : plants(stride), spare(stride), mesh(own_mesh) {}

PlantList::PlantList(PlantList &&other) noexcept :
		plants(std::move(other.plants)),
		spare(std::move(other.spare)),
		mesh(other.mesh),
		multimesh(std::exchange(other.multimesh, RID())),
		instance(std::exchange(other.instance, RID())) {}

PlantList::~PlantList() {
	RenderingServer *server = RenderingServer::get_singleton();
	if (server && multimesh.is_valid()) {
		server->free_rid(instance);
		server->free_rid(multimesh);
	}
}

void PlantList::exchange(PlantBuffer &&now) {
	spare = std::exchange(plants, std::move(now));
}

PlantBuffer PlantList::take_spare() {
	PlantBuffer empty = std::exchange(spare, PlantBuffer(plants.stride()));
	empty.clear();
	return empty;
}

void PlantList::upload(const AABB &box) {
	RenderingServer *server = RenderingServer::get_singleton();
	if (!multimesh.is_valid()) {
		multimesh = server->multimesh_create();
		server->multimesh_set_mesh(multimesh, mesh);
		instance = server->instance_create();
		server->instance_set_base(instance, multimesh);
	}
	server->multimesh_set_custom_aabb(multimesh, box);
	if (plants.size() > 0) {
		if (server->multimesh_get_instance_count(multimesh) != plants.capacity()) {
			server->multimesh_allocate_data(multimesh, plants.capacity(), RenderingServer::MULTIMESH_TRANSFORM_3D,
					plants.stride() == FieldRenderSetup::FLOATS_WITH_COLORS, true, false);
		}
		server->multimesh_set_buffer(multimesh, plants.floats());
		server->multimesh_set_visible_instances(multimesh, plants.size());
	}
}

void PlantList::set_box(const AABB &box) const {
	if (multimesh.is_valid()) {
		RenderingServer::get_singleton()->multimesh_set_custom_aabb(multimesh, box);
	}
}

void PlantList::set_look(const ListSurroundings &around, const RID &material, bool casts_shadows) const {
	if (!instance.is_valid()) {
		return;
	}
	RenderingServer *server = RenderingServer::get_singleton();
	server->instance_attach_object_instance_id(instance, around.owner);
	server->instance_geometry_set_material_override(instance, material);
	server->instance_geometry_set_cast_shadows_setting(instance,
			casts_shadows ? RenderingServer::SHADOW_CASTING_SETTING_SHADOWS_ONLY
						  : RenderingServer::SHADOW_CASTING_SETTING_OFF);
	server->instance_set_layer_mask(instance, around.flags.layers);
	server->instance_geometry_set_transparency(instance, around.flags.transparency);
	around.flags.set_gi(instance);
	server->instance_set_scenario(instance, around.world);
	server->instance_set_visible(
			instance, around.is_visible && plants.size() > 0 && (around.flags.casts_shadows || !casts_shadows));
}

void PlantList::place(const Transform3D &transform) const {
	if (instance.is_valid()) {
		RenderingServer::get_singleton()->instance_set_transform(instance, transform);
	}
}

} // namespace undergrowth
