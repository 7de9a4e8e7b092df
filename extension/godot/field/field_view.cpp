#include "field/field_view.hpp"

#include "base/bounded_whole.hpp"

#include <godot_cpp/classes/rendering_server.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace godot;

namespace undergrowth {

static constexpr float EYE_STEP = 0.25f; // m that a camera moves before plants are counted again.
static constexpr float RANK_ERROR = 1e-3f; // Rounding error of ranks, which are half floats in the shader.

template <class Act> void FieldView::for_each(Act &&act) const {
	RenderingServer *server = RenderingServer::get_singleton();
	for (const bool is_shown : { true, false }) {
		const Levels &own = is_shown ? levels : prepared_levels;
		for (const auto &[place, group] : is_shown ? clumps : prepared) {
			for (const Clump &clump : group) {
				if (!clump.near) {
					act(server, own[size_t(clump.species)][size_t(place.level)], clump);
				}
			}
		}
	}
}

FieldView::~FieldView() {
	if (RenderingServer::get_singleton()) {
		move_all(clumps, gone);
		move_all(prepared, gone);
		std::for_each(leaving.begin(), leaving.end(), &FieldView::let_go);
		std::for_each(gone.begin(), gone.end(), &FieldView::let_go);
	}
}

// The engine measures in world units, from the middle of the box. The shader measures to the root of each plant.
void FieldView::set_range(const Clump &clump, const FieldLevel &level) const {
	const float radius = clump.radius * largest_scale;
	const float begin = std::max(level.begin - radius - level.margin, 0.0f);
	const float end = level.end > 0.0f ? level.end + radius : 0.0f;
	RenderingServer *server = RenderingServer::get_singleton();
	server->instance_geometry_set_visibility_range(
			clump.instance, begin, end, 0.0f, 0.0f, RenderingServer::VISIBILITY_RANGE_FADE_DISABLED);
	if (clump.shadow.is_valid()) { // Where the level itself casts no shadow, finer ones do.
		const float own_end = level.casts_shadows ? end : level.begin + radius;
		const float own_begin = std::max(level.shadow_begin - radius, 0.0f);
		server->instance_geometry_set_visibility_range(
				clump.shadow, own_begin, own_end, 0.0f, 0.0f, RenderingServer::VISIBILITY_RANGE_FADE_DISABLED);
	}
}

void FieldView::set_wear(const Clump &clump, const FieldLevel &level) const {
	RenderingServer *server = RenderingServer::get_singleton();
	server->instance_set_layer_mask(clump.instance, worn.layers);
	server->instance_geometry_set_transparency(clump.instance, worn.transparency);
	server->instance_geometry_set_cast_shadows_setting(clump.instance,
			worn.casts_shadows && level.casts_shadows && !level.casts_for_finer
					? RenderingServer::SHADOW_CASTING_SETTING_ON
					: RenderingServer::SHADOW_CASTING_SETTING_OFF);
	if (clump.shadow.is_valid()) {
		server->instance_set_layer_mask(clump.shadow, worn.layers);
		set_visible(clump, is_visible && clump.is_revealed);
	}
}

FieldView::Clump FieldView::make(const FieldStyle &style, const ClumpPlan &plan) const {
	RenderingServer *server = RenderingServer::get_singleton();
	const FieldLook &look = style.looks[size_t(plan.species)];
	const FieldLevel &level = look.levels[size_t(plan.place.level)];
	Clump clump;
	clump.species = plan.species;
	clump.count = plan.count;
	clump.has_parts = look.has_parts();
	clump.kept = plan.kept;
	clump.roots = plan.roots;
	clump.middle = plan.box.get_center();
	clump.radius = 0.5f * plan.roots.size.length() + clump.middle.distance_to(plan.roots.get_center());
	clump.near = plan.near;
	if (clump.near) {
		return clump;
	}
	clump.multimesh = server->multimesh_create();
	server->multimesh_allocate_data(
			clump.multimesh, plan.count, RenderingServer::MULTIMESH_TRANSFORM_3D, style.needs_colors, true, false);
	server->multimesh_set_mesh(clump.multimesh, look.meshes[size_t(plan.place.level)][size_t(plan.group)]->get_rid());
	server->multimesh_set_custom_aabb(clump.multimesh, plan.box);
	server->multimesh_set_buffer(clump.multimesh, plan.buffer);
	clump.instance = server->instance_create2(clump.multimesh, world);
	server->instance_attach_object_instance_id(clump.instance, owner);
	server->instance_set_transform(clump.instance, placed);
	server->instance_set_visible(clump.instance, false);
	server->instance_geometry_set_material_override(
			clump.instance, look.materials[size_t(plan.place.level)]->get_rid());
	if (level.casts_for_finer) {
		clump.shadow = server->instance_create2(clump.multimesh, world);
		server->instance_attach_object_instance_id(clump.shadow, owner);
		server->instance_set_transform(clump.shadow, placed);
		server->instance_set_visible(clump.shadow, false);
		server->instance_geometry_set_material_override(clump.shadow, look.materials[look.levels.size()]->get_rid());
		server->instance_geometry_set_cast_shadows_setting(
				clump.shadow, RenderingServer::SHADOW_CASTING_SETTING_SHADOWS_ONLY);
	}
	if (!level.casts_shadows || level.casts_for_finer || !(worn == FieldWear())) { // New instances have these defaults.
		set_wear(clump, level);
	}
	set_range(clump, level);
	return clump;
}

void FieldView::set_visible(const Clump &clump, bool visible) const {
	if (!clump.near) {
		RenderingServer::get_singleton()->instance_set_visible(clump.instance, visible);
	}
	if (clump.shadow.is_valid()) {
		RenderingServer::get_singleton()->instance_set_visible(clump.shadow, visible && worn.casts_shadows);
	}
}

FieldView::Levels FieldView::levels_of(const FieldStyle &style) {
	Levels all;
	for (const FieldLook &look : style.looks) {
		all.push_back(look.levels);
	}
	return all;
}

// Passes the present squares of single plants to `near`.
void FieldView::place_near() {
	std::vector<std::shared_ptr<NearSquare>> squares;
	for (const auto &[place, group] : clumps) {
		for (const Clump &clump : group) {
			if (clump.near) {
				squares.push_back(clump.near);
			}
		}
	}
	near.set_squares(std::move(squares));
	has_other_near = false;
}

void FieldView::show(const FieldStyle &style, const std::vector<ClumpPlan> &plans) {
	levels = levels_of(style);
	is_thinned = false;
	near.wear(style);
	for (const ClumpPlan &plan : plans) {
		std::vector<Clump> &there = clumps[plan.place];
		there.push_back(make(style, plan));
		reveal(there.back());
		has_other_near = has_other_near || plan.near;
	}
}

void FieldView::show_added(
		const FieldStyle &style, const FieldMotion &motion, const PlantStore &store, const std::set<TileKey> &tiles) {
	for (int level = 0; level < int(style.levels.size()); level++) {
		const int factor = style.levels[size_t(level)].tile_factor;
		std::set<TileKey> places;
		for (const TileKey &tile : tiles) {
			places.insert(wider_tile(tile, factor));
		}
		std::vector<DrawnBlock> members;
		for (const auto &[column, row] : places) {
			clear(ClumpPlace{ true, level, factor, { column, row } });
			for (int i = 0; i < factor * factor; i++) {
				for (const int number : store.blocks_of({ column * factor + i % factor, row * factor + i / factor })) {
					if (store.block(number).is_added) {
						members.push_back({ motion.texels(number), &store.block(number) });
					}
				}
			}
		}
		show(style, plan_level(style, members, level));
	}
}

void FieldView::show_all_added(const FieldStyle &style, const FieldMotion &motion, const PlantStore &store) {
	std::vector<DrawnBlock> added;
	for (int number = 0; number < store.block_count(); number++) {
		if (store.block(number).is_added) {
			added.push_back({ motion.texels(number), &store.block(number) });
		}
	}
	show(style, plan_clumps(style, added));
}

void FieldView::drop_newcomers(int number) {
	const auto known = newcomers.find(number);
	if (known != newcomers.end()) {
		for (int level = 0; level < level_count(); level++) {
			clear(ClumpPlace{ false, level, 1, known->second, number });
		}
		newcomers.erase(known);
	}
}

void FieldView::show_newcomers(
		const FieldStyle &style, const TileKey &tile, int number, const std::vector<ClumpPlan> &plans) {
	drop_newcomers(number);
	newcomers[number] = tile;
	show(style, plans);
}

void FieldView::update_levels(const FieldStyle &style) {
	levels = levels_of(style);
	is_thinned = false;
	near.wear(style);
	for (const auto &[place, group] : clumps) {
		for (const Clump &clump : group) {
			if (!clump.near) {
				set_range(clump, level_of(place, clump));
				set_wear(clump, level_of(place, clump));
			}
		}
	}
}

void FieldView::set_scenario(const RID &scenario) {
	world = scenario;
	free_some(0.0, true);
	for_each([&](RenderingServer *server, const FieldLevel &, const Clump &clump) {
		server->instance_set_scenario(clump.instance, world);
		if (clump.shadow.is_valid()) {
			server->instance_set_scenario(clump.shadow, world);
		}
	});
	near.set_scenario(world);
}

void FieldView::set_transform(const Transform3D &transform) {
	if (!transform.is_finite()) {
		return; // The engine would report an error for each multimesh.
	}
	placed = transform;
	is_thinned = false;
	const Vector3 scale = transform.basis.get_scale().abs();
	const float largest = std::max({ scale.x, scale.y, scale.z });
	const bool is_scaled_anew = largest != largest_scale;
	largest_scale = largest;
	for_each([&](RenderingServer *server, const FieldLevel &level, const Clump &clump) {
		server->instance_set_transform(clump.instance, placed);
		if (clump.shadow.is_valid()) {
			server->instance_set_transform(clump.shadow, placed);
		}
		if (is_scaled_anew) {
			set_range(clump, level);
		}
	});
	near.set_transform(placed);
}

void FieldView::set_visible(bool visible) {
	is_visible = visible;
	for_each([this, visible](RenderingServer *, const FieldLevel &, const Clump &clump) {
		if (clump.is_revealed) {
			set_visible(clump, visible);
		}
	});
	near.set_visible(visible);
}

void FieldView::wear(const FieldWear &wear) {
	worn = wear;
	for_each([&](RenderingServer *, const FieldLevel &level, const Clump &clump) { set_wear(clump, level); });
	near.set_wear(worn);
}

void FieldView::wear_materials(const FieldStyle &style) {
	RenderingServer *server = RenderingServer::get_singleton();
	near.wear(style);
	for (const auto &[place, group] : clumps) {
		for (const Clump &clump : group) {
			if (!clump.near) {
				wear_material(server, style, place, clump);
			}
		}
	}
}

void FieldView::wear_material(
		RenderingServer *server, const FieldStyle &style, const ClumpPlace &place, const Clump &clump) {
	const FieldLook &look = style.looks[size_t(clump.species)];
	server->instance_geometry_set_material_override(clump.instance, look.materials[size_t(place.level)]->get_rid());
	if (clump.shadow.is_valid()) {
		server->instance_geometry_set_material_override(clump.shadow, look.materials[look.levels.size()]->get_rid());
	}
}

static AABB box_around(const Transform3D &axes, const AABB &box) {
	const Vector3 half = 0.5f * box.size;
	Vector3 reach;
	for (int i = 0; i < 3; i++) {
		reach[i] = axes.basis.rows[i].abs().dot(half);
	}
	return AABB(axes.xform(box.get_center()) - reach, 2.0f * reach);
}

// The world-aligned box contains the turned one. The distance is never too large, so no plant disappears too early.
int FieldView::steps_for(const FieldLevel &level, const Clump &clump, const std::vector<Eye> &eyes) const {
	const Thinning thinning = level.thinning_of(clump.has_parts);
	if (eyes.empty() || !thinning.is_any()) {
		return RANK_STEPS;
	}
	const AABB box = box_around(placed, clump.roots);
	float nearest = std::numeric_limits<float>::max();
	for (const Eye &eye : eyes) {
		const Vector3 &place = eye.place;
		nearest = std::min(nearest, float(place.distance_to(place.clamp(box.position, box.get_end()))));
	}
	const float least = clump.shadow.is_valid() ? 0.0f : level.begin - level.margin;
	const float cut = thinning.cut_at(std::max(nearest - EYE_STEP, least));
	return bounded_whole(std::ceil((cut + RANK_ERROR) * RANK_STEPS), 0, RANK_STEPS);
}

bool FieldView::thins() const {
	const auto is_thinned_level = [](const FieldLevel &level) { return level.is_near || level.thinning.is_any(); };
	return std::any_of(levels.begin(), levels.end(), [&](const std::vector<FieldLevel> &of_look) {
		return std::any_of(of_look.begin(), of_look.end(), is_thinned_level);
	});
}

void FieldView::thin(const std::vector<Eye> &eyes) {
	if (has_other_near) {
		place_near();
	}
	near.update(eyes);
	const auto is_near = [](const Eye &one, const Eye &other) { return one.place.distance_to(other.place) < EYE_STEP; };
	if (is_thinned && std::equal(eyes.begin(), eyes.end(), thinned_for.begin(), thinned_for.end(), is_near)) {
		return;
	}
	is_thinned = true;
	thinned_for = eyes;
	RenderingServer *server = RenderingServer::get_singleton();
	for (auto &[place, group] : clumps) {
		for (Clump &clump : group) {
			if (clump.near) {
				continue;
			}
			const int steps = steps_for(level_of(place, clump), clump, eyes);
			if (steps != clump.shown) {
				clump.shown = steps;
				// Renderers need at least one instance; the shader does not draw it.
				server->multimesh_set_visible_instances(clump.multimesh, std::max(clump.kept[size_t(steps)], 1));
			}
		}
	}
}

std::vector<int> FieldView::count_drawn(const FieldStyle &style, const Vector3 &eye) const {
	std::vector<int> drawn(style.levels.size(), 0);
	Eye seen_from;
	seen_from.place = eye;
	for (const auto &[place, group] : clumps) {
		for (const Clump &clump : group) {
			if (clump.near) {
				const std::vector<FieldLevel> &of_look = levels[size_t(clump.species)];
				for (size_t i = 0; i < of_look.size(); i++) {
					drawn[i] += of_look[i].is_near ? clump.near->count_within(placed.affine_inverse().xform(eye), of_look[i]) : 0;
				}
				continue;
			}
			const FieldLevel &level = level_of(place, clump);
			const float away = placed.xform(clump.middle).distance_to(eye);
			const float radius = clump.radius * largest_scale;
			if (away >= level.begin - radius && (level.end <= 0.0f || away < level.end + radius)) {
				drawn[size_t(place.level)] += clump.kept[size_t(steps_for(level, clump, { seen_from }))];
			}
		}
	}
	return drawn;
}

} // namespace undergrowth
