// Edits and frames of a field. field_runtime_build.cpp builds it.

#include "field/field_runtime.hpp"

#include "base/convert.hpp"
#include "base/runs_in_editor.hpp"
#include "base/stopwatch.hpp"
#include "base/world_of.hpp"
#include "field/view/cameras.hpp"
#include "plants/plant_simulation.hpp"

#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/world3d.hpp>

#include <algorithm>

using namespace godot;

namespace undergrowth {

FieldRuntime::FieldRuntime(GeometryInstance3D *field, const FieldProperties &set_by_users, Listener &&callbacks) :
		skeletons(SkeletonView::Callback(callbacks.skeleton)),
		node(field),
		properties(set_by_users),
		listener(std::move(callbacks)),
		materials(field) {
	view.set_owner(uint64_t(field->get_instance_id()));
}

FieldRuntime::~FieldRuntime() {
	motion.wait();
	drop_job(); // Prepared multimeshes are freed before their materials.
}

FieldMotion::Frame FieldRuntime::frame(double delta, const Ref<PlantWind> &wind) const {
	FieldMotion::Frame now;
	now.delta = delta;
	now.steps = PlantSimulation::get_singleton()->frame_steps();
	now.axes = axes_of(node);
	now.wind = wind;
	now.world = world;
	return now;
}

InstanceRenderFlags FieldRuntime::near_flags() const {
	InstanceRenderFlags near = flags;
	near.casts_shadows = flags.casts_shadows && (setup.levels.empty() || setup.levels[0].casts_shadows);
	return near;
}

double FieldRuntime::advance(double delta, bool simulates) {
	if (!motion.is_ready()) {
		return 0.0;
	}
	const ViewOptions &seen = properties;
	FieldMotion::Frame now = frame(delta, properties.wind);
	motion.wait();
	update_wind_kind(properties.wind);
	const bool needs_skeletons = seen.skeleton_distance > 0.0 && seen.max_skeletons > 0 && !runs_in_editor();
	const bool cameras_matter = properties.far_distance > 0.0 || properties.wind.is_valid();
	if (needs_skeletons || (cameras_matter && motion.needs_cameras())) {
		now.cameras = find_camera_positions(node);
	}
	const bool is_seen = node->is_visible_in_tree();
	trampling.advance(simulates ? delta : 0.0);
	if (own_edits.grow_back(delta * properties.regrowth_rate, store, setup, motion)) {
		is_unshown = true;
	}
	const bool has_chosen = !setup.levels.empty() &&
			skeletons.choose({ node, store, setup, motion, own_edits, now.axes, near_flags() },
					needs_skeletons && is_seen ? now.cameras : std::vector<Vector3>(), seen.skeleton_distance,
					seen.max_skeletons);
	if ((simulates || has_chosen || is_unshown || !unseen.empty()) && is_seen) {
		refresh(now.axes);
	}
	show_precipitation(properties.wind);
	skeletons.pose(store, motion);
	if (!simulates || store.plant_count() == 0) {
		return 0.0;
	}
	PlantSimulation *plants = PlantSimulation::get_singleton();
	motion.bodies.watch(plants->read_bodies(properties.bodies_group, world), now.axes, delta);
	const Stopwatch watch;
	const double stepping_usec = motion.advance(now, properties);
	plants->add_field_time(watch.usec());
	return stepping_usec;
}

void FieldRuntime::preview(double delta, const Ref<PlantWind> &blowing) {
	update_wind_kind(blowing);
	motion.preview(frame(delta, blowing), properties);
	refresh();
	show_precipitation(blowing);
	skeletons.pose(store, motion);
}

// Also without simulation. Costs a comparison if nothing has changed.
void FieldRuntime::show_precipitation(const Ref<PlantWind> &wind) {
	materials.send_precipitation(setup, wind.is_valid() ? wind->precipitation() : Precipitation());
}

// The margin covers plants that were added since the last box.
SeenDistances FieldRuntime::seen_distances(const Transform3D &axes) {
	static constexpr int FRAMES_BETWEEN_BOXES = 16;
	static constexpr float MARGIN = 4.0f; // m.
	if (frames_since_box++ % FRAMES_BETWEEN_BOXES == 0) {
		seen_box = box();
	}
	const Vector3 scale = axes.basis.get_scale().abs();
	const float radius = MARGIN + 0.5f * seen_box.size.length() * std::max({ scale.x, scale.y, scale.z });
	const Vector3 reach(radius, radius, radius);
	return find_seen_distances(node, world, AABB(axes.xform(seen_box.get_center()) - reach, 2.0f * reach));
}

void FieldRuntime::refresh() {
	if (motion.is_ready() && node->is_inside_tree()) {
		refresh(axes_of(node));
	}
}

void FieldRuntime::refresh(const Transform3D &axes) {
	const Stopwatch watch;
	is_unshown = false;
	if (motion.upload()) {
		materials.bind(setup, motion);
	}
	if (!unseen.empty()) {
		view.show_added(setup, motion, store, unseen);
		unseen.clear();
	}
	materials.send_followers(setup, motion, axes);
	if (materials.has_swinging(setup)) {
		materials.send_swing_clock(motion, seen_distances(axes));
	}
	materials.send_leans(setup, motion);
	upload_usec = watch.usec();
}

void FieldRuntime::cull() {
	view.note_drawing();
	if (node->is_visible_in_tree()) {
		const Stopwatch watch;
		const std::vector<DrawingCamera> cameras = find_drawing_cameras(node);
		if (view.culls()) {
			view.cull(cameras);
		}
		if (motion.is_ready()) {
			write_vectors(cameras);
		}
		thin_usec = watch.usec();
	}
}

void FieldRuntime::write_vectors(const std::vector<DrawingCamera> &cameras) {
	const bool are_wanted =
			std::any_of(cameras.begin(), cameras.end(), [](const DrawingCamera &camera) { return camera.has_vectors; });
	const MotionVectors::Sent before = vectors.next({ motion.shown_steps(), motion.swing_clock() }, are_wanted);
	view.set_tilt(before.tilt, cameras);
	materials.send_before(setup, before, motion.step_length());
}

void FieldRuntime::update_render_flags(const InstanceRenderFlags &wanted) {
	if (!(wanted == flags)) {
		flags = wanted;
		view.set_flags(flags);
		skeletons.apply_flags(near_flags());
	}
}

void FieldRuntime::change_materials() {
	motion.wait();
	tiles.interrupt(tile_scene());
	has_other_materials = job != nullptr;
	materials.release(setup, retired_materials); // Multimeshes that are not freed yet still use them.
	if (motion.pose_texture().is_valid()) {
		materials.bind(setup, motion);
		view.set_materials(setup);
		skeletons.release_all(motion);
		refresh(); // A field without simulation has no other call that sets the followers' parameters.
	}
	if (!view.free_some(0.0)) {
		retired_materials.clear();
	}
}

bool FieldRuntime::needs_other_meshes() const {
	return std::any_of(setup.styles.begin(), setup.styles.end(), [this](const SpeciesStyle &style) {
		return style.function.is_valid() &&
				style.needs_other_meshes(style.drawn_material(node->get_material_override()));
	});
}

ChangeSet FieldRuntime::apply(StoreEdit &&edit, ArrivingChunks *arriving) {
	if (edit.removed.empty() && edit.added.empty() && edit.grown.empty() && edit.arriving.empty() &&
			edit.left_tiles.empty()) {
		return {}; // There may be no motion yet.
	}
	std::vector<TileKey> touched;
	for (const PlantRef &place : edit.removed) {
		if (store.chunk(place.chunk).is_added) {
			touched.push_back(store.chunk(place.chunk).tile);
		}
	}
	for (size_t i = 0; i < edit.arriving.size() && !repeated.empty(); i++) {
		arrived.push_back(edit.arriving[i].tile);
	}
	ChangeSet changes = store.apply(std::move(edit));
	skeletons.follow(changes);
	std::for_each(changes.dropped.begin(), changes.dropped.end(), [this](int chunk) { view.drop_new_chunk(chunk); });
	trampling.leave(changes, setup, motion);
	motion.apply(changes, store, setup, arriving);
	trampling.arrive(changes, store, motion);
	own_edits.follow(changes, store, setup, motion);
	tiles.follow(changes, store);
	for (const ChangeSet::Grown &grown : changes.grown) {
		if (store.chunk(grown.chunk).is_added) {
			unseen.insert(store.chunk(grown.chunk).tile);
		}
	}
	if (!changes.dropped.empty()) {
		unseen.insert(touched.begin(), touched.end());
	}
	return changes;
}

std::vector<PlantId> FieldRuntime::add(std::vector<PlacedPlant> &&plants, std::vector<PlantId> &&ids) {
	StoreEdit edit;
	edit.added = std::move(plants);
	edit.added_ids = std::move(ids);
	const ChangeSet changes = apply(std::move(edit));
	for (const ChangeSet::Grown &grown : changes.grown) {
		if (job && !job->includes(store.chunk(grown.chunk).species)) {
			const bool places = is_placing();
			drop_job(); // Its setup would have no style for them.
			restart_build(places);
		}
	}
	return changes.added;
}

int FieldRuntime::remove(std::vector<PlantRef> &&places) {
	if (places.empty()) {
		return 0;
	}
	for (size_t i = 0; is_at_work() && i < places.size(); i++) {
		removed_meanwhile.push_back(store.id(places[i]));
	}
	own_edits.note_removed(store, places);
	for (size_t i = 0; tiles.waiting_count() > 0 && i < places.size(); i++) {
		tiles.note_removed(store.chunk(places[i].chunk).tile);
	}
	const int before = store.plant_count();
	StoreEdit edit;
	edit.removed = std::move(places);
	apply(std::move(edit));
	skeletons.release_left();
	show_soon();
	return before - store.plant_count();
}

void FieldRuntime::mow(std::vector<PlantRef> &&places, const std::vector<float> &shares) {
	if (places.empty()) {
		return;
	}
	own_edits.mow(places, shares, store, setup, motion);
	std::sort(places.begin(), places.end());
	skeletons.release_those(motion, places);
	show_soon();
}

void FieldRuntime::grow_again(const std::vector<AreaBox> &boxes) {
	if (is_at_work()) {
		rebuild(is_placing() || !boxes.empty()); // The present build does not contain the change.
		return;
	}
	tiles.interrupt(tile_scene());
	for (size_t i = 0; i < boxes.size() && tiles.part_count() <= DirtyTiles::MAX_PARTS; i++) {
		tiles.touch(tile_scene(), boxes[i], store.tile_size());
	}
	if (tiles.part_count() > DirtyTiles::MAX_PARTS) {
		rebuild(true);
	}
}

void FieldRuntime::show_soon() {
	is_unshown = node->is_inside_tree() && node->can_process();
	if (!is_unshown) {
		refresh();
	}
}

void FieldRuntime::settle() {
	if (motion.is_ready()) {
		motion.settle();
		trampling.forget_absent();
		refresh();
		skeletons.pose(store, motion);
	}
}

void FieldRuntime::skeletons_changed() {
	skeletons.choose_soon();
	if (properties.skeleton_distance <= 0.0 || properties.max_skeletons <= 0) {
		motion.wait();
		skeletons.release_all(motion);
		skeletons.clear();
		refresh();
	}
}

void FieldRuntime::note_world() {
	world = world_of(node);
}

void FieldRuntime::enter_tree() {
	note_world();
	skeletons.remove_strays(node);
	view.set_scenario(node->get_world_3d().is_valid() ? node->get_world_3d()->get_scenario() : RID());
	moved();
	set_visible(node->is_visible_in_tree());
}

void FieldRuntime::exit_tree() {
	motion.wait();
	wait_for_jobs();
	motion.bodies.forget();
	view.set_scenario(RID());
}

void FieldRuntime::moved() {
	view.set_transform(node->get_global_transform());
	materials.send_axes(setup);
}

void FieldRuntime::set_visible(bool visible) {
	view.set_visible(visible);
	if (visible) {
		refresh();
	}
}

AABB FieldRuntime::box() const {
	AABB all;
	bool is_first = true;
	for (int number = 0; number < store.chunk_count(); number++) {
		const PlantChunk &chunk = store.chunk(number);
		if (chunk.live_count() > 0 && size_t(chunk.species) < setup.styles.size()) {
			const SpeciesStyle &style = setup.styles[size_t(chunk.species)];
			const float reach = style.motion.longest * 2.0f + style.width;
			const Vector3 low = to_godot(chunk.low - reach);
			const AABB own(low, to_godot(chunk.high + reach) - low);
			all = is_first ? own : all.merge(own);
			is_first = false;
		}
	}
	return all;
}

} // namespace undergrowth
