#include "field/view/field_view.hpp"

#include "base/bounded_whole.hpp"
#include "base/stopwatch.hpp"
#include "field/view/plant_transforms.hpp"

#include <godot_cpp/classes/rendering_server.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr float CAMERA_STEP = 0.25f; // m that a camera moves before plants are counted again.
static constexpr float RANK_ERROR = 1e-3f; // Rounding error of ranks, which are half floats in the shader.

template <class Act> void FieldView::for_each(Act &&act) const {
	RenderingServer *server = RenderingServer::get_singleton();
	for (const bool is_shown : { true, false }) {
		const Levels &own = is_shown ? levels : prepared_levels;
		for (const auto &[place, group] : is_shown ? batches : prepared) {
			for (const Batch &batch : group) {
				if (!batch.near) {
					act(server, own[size_t(batch.species)][size_t(place.level)], batch);
				}
			}
		}
	}
}

FieldView::~FieldView() {
	if (RenderingServer::get_singleton()) {
		leaving.push_back(std::move(batches));
		leaving.push_back(std::move(prepared));
		for (const Batches &groups : leaving) {
			for (const auto &[place, group] : groups) {
				std::for_each(group.begin(), group.end(), &FieldView::free_batch);
			}
		}
		std::for_each(gone.begin(), gone.end(), &FieldView::free_batch);
	}
}

// The engine measures in world units, from the middle of the box. The shader measures to the root of each plant.
void FieldView::set_range(const Batch &batch, const FieldLevel &level) const {
	const float radius = batch.radius * largest_scale;
	const float begin = std::max(level.begin - radius - level.margin, 0.0f);
	const float end = level.end > 0.0f ? level.end + radius : 0.0f;
	RenderingServer *server = RenderingServer::get_singleton();
	server->instance_geometry_set_visibility_range(
			batch.instance, begin, end, 0.0f, 0.0f, RenderingServer::VISIBILITY_RANGE_FADE_DISABLED);
}

void FieldView::apply_flags(const Batch &batch, const FieldLevel &level) const {
	RenderingServer *server = RenderingServer::get_singleton();
	server->instance_set_layer_mask(batch.instance, around.flags.layers);
	server->instance_geometry_set_transparency(batch.instance, around.flags.transparency);
	around.flags.set_gi(batch.instance);
	set_caster(batch, level);
}

void FieldView::set_caster(const Batch &batch, const FieldLevel &level) const {
	const bool casts = around.flags.casts_shadows && level.casts_shadows && batch.is_within_shadows;
	RenderingServer::get_singleton()->instance_geometry_set_cast_shadows_setting(batch.instance,
			casts ? RenderingServer::SHADOW_CASTING_SETTING_ON : RenderingServer::SHADOW_CASTING_SETTING_OFF);
}

FieldView::Batch FieldView::make(const FieldRenderSetup &setup, const BatchPlan &plan) const {
	RenderingServer *server = RenderingServer::get_singleton();
	const SpeciesStyle &style = setup.styles[size_t(plan.species)];
	Batch batch;
	batch.species = plan.species;
	batch.count = plan.count;
	batch.has_parts = style.has_parts();
	batch.rank_counts = plan.rank_counts;
	batch.roots = plan.roots;
	batch.middle = plan.box.get_center();
	batch.radius = 0.5f * plan.roots.size.length() + batch.middle.distance_to(plan.roots.get_center());
	batch.near = plan.near;
	if (batch.near) {
		return batch;
	}
	const FieldLevel &level = style.levels[size_t(plan.place.level)];
	batch.multimesh = server->multimesh_create();
	server->multimesh_allocate_data(
			batch.multimesh, plan.count, RenderingServer::MULTIMESH_TRANSFORM_3D, setup.needs_colors, true, false);
	server->multimesh_set_mesh(batch.multimesh, style.meshes[size_t(plan.place.level)][size_t(plan.group)]->get_rid());
	server->multimesh_set_custom_aabb(batch.multimesh, plan.box);
	server->multimesh_set_buffer(batch.multimesh, plan.buffer);
	batch.instance = server->instance_create2(batch.multimesh, around.world);
	server->instance_attach_object_instance_id(batch.instance, around.owner);
	server->instance_set_transform(batch.instance, place_of(batch));
	server->instance_set_visible(batch.instance, false);
	server->instance_geometry_set_material_override(batch.instance, style.override_for(size_t(plan.place.level)));
	if (!level.casts_shadows || !(around.flags == InstanceRenderFlags())) { // New instances have these defaults.
		apply_flags(batch, level);
	} else {
		around.flags.set_gi(batch.instance);
	}
	set_range(batch, level);
	return batch;
}

void FieldView::set_visible(const Batch &batch, bool visible) const {
	if (!batch.near) {
		RenderingServer::get_singleton()->instance_set_visible(batch.instance, visible);
	}
}

void FieldView::bind_lists(const FieldRenderSetup &setup) {
	near.bind(setup);
	shadows.bind(setup);
}

void FieldView::pass_surroundings() {
	near.follow(around);
	shadows.follow(around);
}

void FieldView::set_owner(uint64_t object) {
	around.owner = object;
	pass_surroundings();
}

FieldView::Levels FieldView::levels_of(const FieldRenderSetup &setup) {
	Levels all;
	for (const SpeciesStyle &style : setup.styles) {
		all.push_back(style.levels);
	}
	return all;
}

// Passes the present squares of single plants.
void FieldView::place_near() {
	std::vector<std::shared_ptr<NearSquare>> squares;
	for (const auto &[place, group] : batches) {
		for (const Batch &batch : group) {
			if (batch.near) {
				squares.push_back(batch.near);
			}
		}
	}
	shadows.set_squares(squares);
	near.set_squares(std::move(squares));
	has_other_near = false;
}

void FieldView::show(const FieldRenderSetup &setup, const std::vector<BatchPlan> &plans) {
	levels = levels_of(setup);
	note_change();
	bind_lists(setup);
	for (const BatchPlan &plan : plans) {
		std::vector<Batch> &there = batches[plan.place];
		there.push_back(make(setup, plan));
		reveal(there.back());
		has_other_near = has_other_near || plan.near;
	}
}

void FieldView::show_added(const FieldRenderSetup &setup, const FieldMotion &motion, const PlantStore &store,
		const std::set<TileKey> &tiles) {
	for (int level = SQUARES; level < int(setup.levels.size()); level++) {
		const int factor = level == SQUARES ? 1 : setup.levels[size_t(level)].tile_factor;
		std::set<TileKey> places;
		for (const TileKey &tile : tiles) {
			places.insert(wider_tile(tile, factor));
		}
		std::vector<DrawnChunk> members;
		for (const auto &[column, row] : places) {
			clear(BatchKey{ true, level, factor, { column, row } });
			for (int i = 0; i < factor * factor; i++) {
				for (const int number : store.chunks_of({ column * factor + i % factor, row * factor + i / factor })) {
					if (store.chunk(number).is_added) {
						members.push_back({ motion.texels(number), &store.chunk(number) });
					}
				}
			}
		}
		show(setup, plan_level(setup, members, level));
	}
}

void FieldView::show_all_added(const FieldRenderSetup &setup, const FieldMotion &motion, const PlantStore &store) {
	std::vector<DrawnChunk> added;
	for (int number = 0; number < store.chunk_count(); number++) {
		if (store.chunk(number).is_added) {
			added.push_back({ motion.texels(number), &store.chunk(number) });
		}
	}
	show(setup, plan_batches(setup, added));
}

void FieldView::drop_new_chunk(int number) {
	const auto known = new_chunks.find(number);
	if (known != new_chunks.end()) {
		for (int level = SQUARES; level < level_count(); level++) {
			clear(BatchKey{ false, level, 1, known->second, number });
		}
		new_chunks.erase(known);
	}
}

void FieldView::replace_new_chunk(const TileKey &tile, int number) {
	drop_new_chunk(number);
	new_chunks[number] = tile;
}

void FieldView::update_levels(const FieldRenderSetup &setup) {
	levels = levels_of(setup);
	note_change();
	bind_lists(setup);
	for (const auto &[place, group] : batches) {
		for (const Batch &batch : group) {
			if (!batch.near) {
				set_range(batch, level_of(place, batch));
				apply_flags(batch, level_of(place, batch));
			}
		}
	}
}

void FieldView::set_scenario(const RID &scenario) {
	around.world = scenario;
	free_some(0.0, true);
	for_each([&](RenderingServer *server, const FieldLevel &, const Batch &batch) {
		server->instance_set_scenario(batch.instance, around.world);
	});
	pass_surroundings();
}

void FieldView::set_transform(const Transform3D &transform) {
	if (!transform.is_finite()) {
		return; // The engine would report an error for each multimesh.
	}
	around.placed = transform;
	note_change();
	const Vector3 scale = transform.basis.get_scale().abs();
	const float largest = std::max({ scale.x, scale.y, scale.z });
	const bool scale_changed = largest != largest_scale;
	largest_scale = largest;
	for_each([&](RenderingServer *server, const FieldLevel &level, const Batch &batch) {
		server->instance_set_transform(batch.instance, place_of(batch));
		if (scale_changed) {
			set_range(batch, level);
		}
	});
	near.set_transform(around.placed);
	shadows.set_transform(around.placed);
}

Transform3D FieldView::place_of(const Batch &batch) const {
	return batch.tilt == 0.0f ? around.placed : tilted(around.placed, batch.tilt, batch.roots.get_center().y);
}

// True if a camera may show the multimesh, as a sphere, at its level.
bool FieldView::is_seen(const Batch &batch, const FieldLevel &level, const DrawingCamera &camera) const {
	static constexpr float TALLEST = 4.0f; // m, beside the roots.
	const Vector3 way = around.placed.xform(batch.middle) - camera.place;
	const float away = way.length();
	const float radius = batch.radius * largest_scale;
	const bool is_in_range =
			away > level.begin - level.margin - radius && (level.end <= 0.0f || away < level.end + radius);
	const float along = way.dot(camera.forward);
	const float aside = std::sqrt(std::max(away * away - along * along, 0.0f));
	const float sine = std::sqrt(std::max(1.0f - camera.cone_cosine * camera.cone_cosine, 0.0f));
	const bool is_in_cone = !camera.has_cone || aside * camera.cone_cosine - along * sine < radius + TALLEST;
	return is_in_range && is_in_cone;
}

// Instances that only cast shadows have no vectors.
void FieldView::set_tilt(float now, const std::vector<DrawingCamera> &cameras) {
	if (now == tilt && tilt == 0.0f) {
		return;
	}
	tilt = now;
	for (auto &[key, group] : batches) {
		const BatchKey &place = key; // In C++17 a lambda captures no structured binding.
		for (Batch &batch : group) {
			const bool is_shown = !batch.near && tilt != 0.0f &&
					std::any_of(cameras.begin(), cameras.end(), [&](const DrawingCamera &camera) {
						return camera.has_vectors && is_seen(batch, level_of(place, batch), camera);
					});
			const float wanted = is_shown ? tilt : 0.0f;
			if (wanted != batch.tilt) {
				batch.tilt = wanted;
				RenderingServer::get_singleton()->instance_set_transform(batch.instance, place_of(batch));
			}
		}
	}
	near.set_tilt(tilt);
}

void FieldView::set_visible(bool visible) {
	around.is_visible = visible;
	for_each([this, visible](RenderingServer *, const FieldLevel &, const Batch &batch) {
		if (batch.is_revealed) {
			set_visible(batch, visible);
		}
	});
	pass_surroundings();
}

void FieldView::set_flags(const InstanceRenderFlags &flags) {
	around.flags = flags;
	for_each([&](RenderingServer *, const FieldLevel &level, const Batch &batch) { apply_flags(batch, level); });
	pass_surroundings();
}

void FieldView::set_materials(const FieldRenderSetup &setup) {
	RenderingServer *server = RenderingServer::get_singleton();
	bind_lists(setup);
	for (const auto &[place, group] : batches) {
		for (const Batch &batch : group) {
			if (!batch.near) {
				set_material(server, setup, place, batch);
			}
		}
	}
}

void FieldView::set_material(
		RenderingServer *server, const FieldRenderSetup &setup, const BatchKey &place, const Batch &batch) {
	const SpeciesStyle &style = setup.styles[size_t(batch.species)];
	server->instance_geometry_set_material_override(batch.instance, style.override_for(size_t(place.level)));
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
float FieldView::distance_to(const Batch &batch, const std::vector<DrawingCamera> &cameras) const {
	if (cameras.empty()) {
		return 0.0f;
	}
	const AABB box = box_around(around.placed, batch.roots);
	float nearest = std::numeric_limits<float>::max();
	for (const DrawingCamera &camera : cameras) {
		const Vector3 &place = camera.place;
		nearest = std::min(nearest, float(place.distance_to(place.clamp(box.position, box.get_end()))));
	}
	return std::max(nearest - CAMERA_STEP, 0.0f);
}

int FieldView::steps_for(const FieldLevel &level, const Batch &batch, float distance) const {
	const LodDensity lod_density = level.lod_density_of(batch.has_parts);
	if (!lod_density.is_any()) {
		return RANK_STEPS;
	}
	const float cut = lod_density.cut_at(std::max(distance, level.begin - level.margin));
	return bounded_whole(std::ceil((cut + RANK_ERROR) * RANK_STEPS), 0, RANK_STEPS);
}

bool FieldView::culls() const {
	const auto is_culled_level = [](const FieldLevel &level) {
		return level.is_near || level.lod_density.is_any() || level.casts_shadows;
	};
	return std::any_of(levels.begin(), levels.end(), [&](const std::vector<FieldLevel> &species_levels) {
		return std::any_of(species_levels.begin(), species_levels.end(), is_culled_level);
	});
}

void FieldView::cull(const std::vector<DrawingCamera> &cameras) {
	if (has_other_near) {
		place_near();
	}
	near.update(cameras);
	shadows.update(cameras);
	const auto is_near = [](const DrawingCamera &one, const DrawingCamera &other) {
		return one.place.distance_to(other.place) < CAMERA_STEP;
	};
	if (is_culled && std::equal(cameras.begin(), cameras.end(), culled_for.begin(), culled_for.end(), is_near)) {
		return;
	}
	is_culled = true;
	culled_for = cameras;
	RenderingServer *server = RenderingServer::get_singleton();
	for (auto &[place, group] : batches) {
		for (Batch &batch : group) {
			if (batch.near) {
				continue;
			}
			const FieldLevel &level = level_of(place, batch);
			const float distance = distance_to(batch, cameras);
			const bool is_within = distance < level.shadow_end;
			if (is_within != batch.is_within_shadows) {
				batch.is_within_shadows = is_within;
				set_caster(batch, level);
			}
			const int steps = steps_for(level, batch, distance);
			if (steps != batch.shown) {
				batch.shown = steps;
				// Renderers need at least one instance; the shader does not draw it.
				server->multimesh_set_visible_instances(batch.multimesh, std::max(batch.rank_counts[size_t(steps)], 1));
			}
		}
	}
}

const std::vector<int> &FieldView::count_drawn(const FieldRenderSetup &setup, const Vector3 &camera) {
	if (has_counted && camera.distance_to(counted_for) < CAMERA_STEP) {
		return counted;
	}
	has_counted = true;
	counted_for = camera;
	counted.assign(setup.levels.size(), 0);
	DrawingCamera seen_from;
	seen_from.place = camera;
	for (const auto &[place, group] : batches) {
		for (const Batch &batch : group) {
			if (batch.near) {
				const std::vector<FieldLevel> &species_levels = levels[size_t(batch.species)];
				for (size_t i = 0; i < species_levels.size(); i++) {
					counted[i] += species_levels[i].is_near
							? batch.near->count_within(around.placed.affine_inverse().xform(camera), species_levels[i])
							: 0;
				}
				continue;
			}
			const FieldLevel &level = level_of(place, batch);
			const float away = around.placed.xform(batch.middle).distance_to(camera);
			const float radius = batch.radius * largest_scale;
			if (away >= level.begin - radius && (level.end <= 0.0f || away < level.end + radius)) {
				const int steps = steps_for(level, batch, distance_to(batch, { seen_from }));
				counted[size_t(place.level)] += batch.rank_counts[size_t(steps)];
			}
		}
	}
	return counted;
}

void FieldView::free_batch(const Batch &batch) {
	RenderingServer *server = RenderingServer::get_singleton();
	if (batch.near) {
		return;
	}
	server->free_rid(batch.instance);
	server->free_rid(batch.multimesh);
}

void FieldView::prepare(const FieldRenderSetup &setup, const BatchPlan &plan) {
	const Stopwatch watch;
	if (prepared.empty()) {
		prepared_levels = levels_of(setup);
	}
	prepared[plan.place].push_back(make(setup, plan));
	next_revealed.reset();
	preparing.note(plan.count, watch.usec());
}

void FieldView::forget_prepared() {
	leaving.push_back(std::exchange(prepared, {}));
	next_revealed.reset();
}

void FieldView::reveal(Batch &batch) {
	batch.is_revealed = has_unflushed = true;
	set_visible(batch, around.is_visible);
}

// The renderer processes everything new before it frees an instance.
void FieldView::flush_if_undrawn() {
	if (std::exchange(has_unflushed, false)) {
		RenderingServer *server = RenderingServer::get_singleton();
		server->free_rid(server->instance_create());
	}
}

bool FieldView::reveal_some(double usec) {
	const Stopwatch watch;
	auto entry = next_revealed ? prepared.lower_bound(*next_revealed) : prepared.begin();
	for (; entry != prepared.end(); ++entry) {
		next_revealed = entry->first;
		for (Batch &batch : entry->second) {
			if (batch.is_revealed) {
				continue;
			}
			reveal(batch);
			if (watch.usec() > usec) {
				return true;
			}
		}
	}
	return false;
}

// Calls act(place, group) for all groups of a square, whole or in parts, and removes them.
template <class Act> void FieldView::take_parts(Batches &from, const BatchKey &place, const Act &act) {
	auto group = from.lower_bound(place);
	while (group != from.end() && group->first.is_beside(place)) {
		act(group->first, group->second);
		group = from.erase(group);
	}
}

bool FieldView::has_near(const std::vector<Batch> &group) {
	return std::any_of(group.begin(), group.end(), [](const Batch &batch) { return batch.near != nullptr; });
}

void FieldView::clear(const BatchKey &place) {
	has_counted = false;
	take_parts(batches, place, [this](const BatchKey &, std::vector<Batch> &group) {
		has_other_near = has_other_near || has_near(group);
		std::for_each(group.begin(), group.end(), &FieldView::free_batch);
	});
}

void FieldView::drop_tile(const TileKey &tile) {
	has_counted = false;
	for (int level = SQUARES; level < level_count(); level++) {
		take_parts(batches, { false, level, 1, tile }, [this](const BatchKey &, std::vector<Batch> &group) {
			has_other_near = has_other_near || has_near(group);
			for (const Batch &batch : group) {
				set_visible(batch, false);
				gone.push_back(batch);
			}
		});
	}
}

void FieldView::show_tile(const FieldRenderSetup &setup, const TileKey &tile) {
	for (int level = SQUARES; level < int(setup.levels.size()); level++) {
		take_parts(prepared, { false, level, 1, tile }, [&](const BatchKey &place, std::vector<Batch> &group) {
			for (Batch &batch : group) {
				show_prepared(setup, place, std::move(batch));
			}
		});
	}
}

void FieldView::show_prepared(const FieldRenderSetup &setup, const BatchKey &place, Batch &&batch) {
	note_change();
	if (batch.near) {
		has_other_near = true;
	} else {
		const FieldLevel &seen = setup.styles[size_t(batch.species)].levels[size_t(place.level)];
		set_material(RenderingServer::get_singleton(), setup, place, batch);
		set_range(batch, seen);
		apply_flags(batch, seen);
	}
	reveal(batch);
	batches[place].push_back(std::move(batch));
}

void FieldView::forget_tile(const TileKey &tile) {
	for (int level = SQUARES; level < (prepared_levels.empty() ? 0 : int(prepared_levels.front().size())); level++) {
		take_parts(prepared, { false, level, 1, tile }, [this](const BatchKey &, std::vector<Batch> &group) {
			std::move(group.begin(), group.end(), std::back_inserter(gone));
		});
	}
}

void FieldView::exchange(const FieldRenderSetup &setup) {
	leaving.push_back(std::exchange(batches, std::exchange(prepared, {})));
	new_chunks.clear();
	next_revealed.reset();
	levels = levels_of(setup);
	bind_lists(setup);
	has_other_near = true;
	note_change();
}

bool FieldView::free_some(double usec, bool hides_all) {
	const Stopwatch watch;
	while (!leaving.empty() && (hides_all || watch.usec() < usec)) {
		const auto group = leaving.back().begin();
		if (group == leaving.back().end()) {
			leaving.pop_back();
			continue;
		}
		for (Batch &batch : group->second) {
			set_visible(batch, false);
			gone.push_back(std::move(batch));
		}
		leaving.back().erase(group);
	}
	while (!gone.empty() && watch.usec() < usec) {
		free_batch(gone.back());
		gone.pop_back();
	}
	return !gone.empty() || !leaving.empty();
}

} // namespace undergrowth
