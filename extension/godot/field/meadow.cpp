// Edits and frames of a field. meadow_fill.cpp builds it.

#include "field/meadow.hpp"

#include "convert.hpp"
#include "field/cpu_motion.hpp"
#include "field/eyes.hpp"
#include "stopwatch.hpp"
#include "world_of.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/world3d.hpp>

#include <algorithm>

using namespace godot;

namespace undergrowth {

Meadow::Meadow(GeometryInstance3D *field, const FieldProperties &set_by_users, Listener &&teller) :
		own_motion(std::make_unique<CpuMotion>()),
		motion(*own_motion),
		skeletons(SkeletonView::Tell(teller.skeleton)),
		node(field),
		properties(set_by_users),
		listener(std::move(teller)),
		dress(field) {
	view.set_owner(uint64_t(field->get_instance_id()));
}

Meadow::~Meadow() {
	motion.wait();
	drop_job(); // Prepared multimeshes are freed before their materials.
}

FieldMotion::Frame Meadow::frame(double delta, const Ref<PlantWind> &wind) const {
	FieldMotion::Frame now;
	now.delta = delta;
	now.axes = axes_of(node);
	now.wind = wind;
	now.tree = node->get_tree();
	now.world = world_of(node);
	return now;
}

FieldWear Meadow::near_wear() const {
	FieldWear near = wear;
	near.casts_shadows = wear.casts_shadows && (style.levels.empty() || style.levels[0].casts_shadows);
	return near;
}

double Meadow::advance(double delta, bool simulates) {
	if (!motion.is_ready()) {
		return 0.0;
	}
	const ViewOptions &seen = properties;
	FieldMotion::Frame now = frame(delta, properties.wind);
	motion.wait();
	feel(properties.wind);
	const bool wants_skeletons = seen.skeleton_distance > 0.0 && !Engine::get_singleton()->is_editor_hint();
	const bool eyes_matter = properties.far_distance > 0.0 || properties.wind.is_valid();
	if (wants_skeletons || (eyes_matter && motion.wants_eyes())) {
		now.eyes = find_eyes(node);
	}
	const bool is_seen = node->is_visible_in_tree();
	if (own_changes.grow_back(delta * properties.regrowth_rate, store, style, motion)) {
		is_unshown = true;
	}
	const bool has_chosen = !style.levels.empty() &&
			skeletons.choose({ node, store, style, motion, own_changes, now.axes, near_wear() },
					wants_skeletons && is_seen ? now.eyes : std::vector<Vector3>(), seen.skeleton_distance,
					seen.max_skeletons);
	if ((simulates || has_chosen || is_unshown || !unseen.empty()) && is_seen) {
		refresh();
	}
	skeletons.pose(store, motion);
	if (!simulates || store.plant_count() == 0) {
		return 0.0;
	}
	motion.bodies.watch({ now.tree, now.world, now.axes }, properties.bodies_group, delta);
	return motion.advance(now, properties);
}

void Meadow::preview(double delta, const Ref<PlantWind> &blowing) {
	feel(blowing);
	motion.preview(frame(delta, blowing), properties);
	refresh();
	skeletons.pose(store, motion);
}

// The margin covers plants that were added since the last box.
SeenDistances Meadow::seen_distances() {
	static constexpr int FRAMES_BETWEEN_BOXES = 16;
	static constexpr float MARGIN = 4.0f; // m.
	if (frames_since_box++ % FRAMES_BETWEEN_BOXES == 0) {
		seen_box = box();
	}
	const Transform3D axes = axes_of(node);
	const Vector3 scale = axes.basis.get_scale().abs();
	const float radius = MARGIN + 0.5f * seen_box.size.length() * std::max({ scale.x, scale.y, scale.z });
	const Vector3 reach(radius, radius, radius);
	return find_seen_distances(node, AABB(axes.xform(seen_box.get_center()) - reach, 2.0f * reach));
}

void Meadow::refresh() {
	if (!motion.is_ready() || !node->is_inside_tree()) {
		return;
	}
	const Stopwatch watch;
	is_unshown = false;
	if (motion.upload()) {
		dress.put_on(style, motion);
	}
	if (!unseen.empty()) {
		view.show_added(style, motion, store, unseen);
		unseen.clear();
	}
	dress.tell_of_followers(style, motion, axes_of(node));
	dress.tell_of_swings(style, motion, seen_distances());
	upload_usec = watch.usec();
}

void Meadow::thin() {
	view.note_drawing();
	if (view.thins() && node->is_visible_in_tree()) {
		const Stopwatch watch;
		view.thin(find_drawn_eyes(node));
		thin_usec = watch.usec();
	}
}

void Meadow::update_wear(const FieldWear &wanted) {
	if (!(wanted == wear)) {
		wear = wanted;
		view.wear(wear);
		skeletons.dress(near_wear());
	}
}

void Meadow::change_materials() {
	motion.wait();
	renewal.interrupt(tile_scene(), motion);
	has_other_materials = job != nullptr;
	dress.take_off(style, retired_materials); // Multimeshes that are not freed yet still use them.
	if (motion.pose_texture().is_valid()) {
		dress.put_on(style, motion);
		view.wear_materials(style);
		skeletons.release_all(motion);
		refresh(); // A field without simulation has no other call that sets the followers' parameters.
	}
	if (!view.free_some(0.0)) {
		retired_materials.clear();
	}
}

ChangeSet Meadow::apply(StandEdit &&edit, ArrivingBlocks *arriving) {
	if (edit.removed.empty() && edit.added.empty() && edit.grown.empty() && edit.stood.empty() &&
			edit.left_tiles.empty()) {
		return {}; // There may be no motion yet.
	}
	std::vector<TileKey> touched;
	for (const PlantPlace &place : edit.removed) {
		if (store.block(place.block).is_added) {
			touched.push_back(store.block(place.block).tile);
		}
	}
	for (size_t i = 0; i < edit.stood.size() && !repeated.empty(); i++) {
		arrived.push_back(edit.stood[i].tile);
	}
	ChangeSet changes = store.apply(std::move(edit));
	std::for_each(changes.dropped.begin(), changes.dropped.end(), [this](int block) { view.drop_newcomers(block); });
	motion.apply(changes, store, style, arriving);
	own_changes.follow(changes, store, style, motion);
	patches.follow(changes, store);
	for (const ChangeSet::Grown &grown : changes.grown) {
		if (store.block(grown.block).is_added) {
			unseen.insert(store.block(grown.block).tile);
		}
	}
	if (!changes.dropped.empty()) {
		unseen.insert(touched.begin(), touched.end());
	}
	return changes;
}

std::vector<PlantId> Meadow::add(std::vector<PlacedPlant> &&plants, std::vector<PlantId> &&ids) {
	StandEdit edit;
	edit.added = std::move(plants);
	edit.added_ids = std::move(ids);
	const ChangeSet changes = apply(std::move(edit));
	for (const ChangeSet::Grown &grown : changes.grown) {
		if (job && !job->knows(store.block(grown.block).species)) {
			const bool places = is_placing();
			drop_job(); // Its style would have no look for them.
			fill_again(places);
		}
	}
	return changes.added;
}

int Meadow::remove(std::vector<PlantPlace> &&places) {
	if (places.empty()) {
		return 0;
	}
	for (size_t i = 0; is_at_work() && i < places.size(); i++) {
		removed_meanwhile.push_back(store.id(places[i]));
	}
	own_changes.note_removed(store, places);
	for (size_t i = 0; renewal.is_at_work() && i < places.size(); i++) {
		renewal.note_removed(store.block(places[i].block).tile);
	}
	const int before = store.plant_count();
	StandEdit edit;
	edit.removed = std::move(places);
	apply(std::move(edit));
	skeletons.release_gone(store);
	show_soon();
	return before - store.plant_count();
}

void Meadow::mow(std::vector<PlantPlace> &&places, const std::vector<float> &shares) {
	if (places.empty()) {
		return;
	}
	own_changes.mow(places, shares, store, style, motion);
	std::sort(places.begin(), places.end());
	skeletons.release_those(motion, places);
	show_soon();
}

void Meadow::grow_again(const std::vector<AreaBox> &boxes) {
	if (is_at_work()) {
		fill(is_placing() || !boxes.empty()); // The present build does not contain the change.
		return;
	}
	tiles.interrupt(tile_scene());
	renewal.interrupt(tile_scene(), motion);
	for (size_t i = 0; i < boxes.size() && patches.touched_tiles() <= FieldPatches::MOST_TILES; i++) {
		patches.touch(boxes[i], store.tile_size());
		keep_standing_patches();
	}
	if (patches.touched_tiles() > FieldPatches::MOST_TILES) {
		fill(true);
	}
}

void Meadow::show_soon() {
	is_unshown = node->is_inside_tree() && node->can_process();
	if (!is_unshown) {
		refresh();
	}
}

void Meadow::settle() {
	if (motion.is_ready()) {
		motion.settle();
		refresh();
		skeletons.pose(store, motion);
	}
}

void Meadow::skeletons_changed() {
	skeletons.choose_soon();
	if (properties.skeleton_distance <= 0.0 || properties.max_skeletons <= 0) {
		motion.wait();
		skeletons.release_all(motion);
		skeletons.clear();
		refresh();
	}
}

void Meadow::enter_tree() {
	skeletons.remove_strays(node);
	view.set_scenario(node->get_world_3d().is_valid() ? node->get_world_3d()->get_scenario() : RID());
	moved();
	set_visible(node->is_visible_in_tree());
}

void Meadow::exit_tree() {
	motion.wait();
	wait_for_jobs();
	motion.bodies.forget();
	view.set_scenario(RID());
}

void Meadow::moved() {
	view.set_transform(node->get_global_transform());
	dress.tell_of_axes(style);
}

void Meadow::set_visible(bool visible) {
	view.set_visible(visible);
	if (visible) {
		refresh();
	}
}

AABB Meadow::box() const {
	AABB all;
	bool is_first = true;
	for (int number = 0; number < store.block_count(); number++) {
		const PlantBlock &block = store.block(number);
		if (block.standing() > 0 && size_t(block.species) < style.looks.size()) {
			const FieldLook &look = style.looks[size_t(block.species)];
			const float reach = look.motion.longest * 2.0f + look.width;
			const Vector3 low = to_godot(block.low - reach);
			const AABB own(low, to_godot(block.high + reach) - low);
			all = is_first ? own : all.merge(own);
			is_first = false;
		}
	}
	return all;
}

} // namespace undergrowth
