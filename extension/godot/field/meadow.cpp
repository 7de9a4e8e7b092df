// The way of edits and frames through a field. meadow_fill.cpp grows it.

#include "field/meadow.hpp"

#include "convert.hpp"
#include "field/field_material.hpp"
#include "messages.hpp"

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/classes/world3d.hpp>

#include <algorithm>
#include <chrono>

using namespace godot;

namespace undergrowth {

using Clock = std::chrono::steady_clock;

static constexpr float FARTHEST = 1e9f; // m.
static const char *const VIEWPORTS = "_viewports"; // The engine's own group.

Meadow::Meadow(GeometryInstance3D *field, const FieldProperties &set_by_users, Listener &&teller) :
		skeletons(SkeletonView::Tell(teller.skeleton)),
		node(field),
		properties(set_by_users),
		listener(std::move(teller)) {
	view.set_owner(uint64_t(field->get_instance_id()));
}

Meadow::~Meadow() {
	motion.wait();
}

FieldMotion::Frame Meadow::frame(double delta, const Ref<PlantWind> &wind) const {
	FieldMotion::Frame now;
	now.delta = delta;
	now.axes = axes_of(node);
	now.wind = wind;
	now.tree = node->get_tree();
	return now;
}

// All cameras that look into this world: that of the screen, and those of other viewports.
std::vector<Vector3> Meadow::find_eyes() const {
	std::vector<Vector3> eyes;
	const TypedArray<Node> viewports = node->get_tree()->get_nodes_in_group(VIEWPORTS);
	for (int64_t i = 0; i < viewports.size(); i++) {
		const Viewport *viewport = Object::cast_to<Viewport>(viewports[i]);
		const Camera3D *camera = viewport ? viewport->get_camera_3d() : nullptr;
		if (camera && camera->get_world_3d() == node->get_world_3d()) {
			eyes.push_back(camera->get_global_position());
		}
	}
	return eyes;
}

double Meadow::advance(double delta, bool simulates) {
	if (!motion.is_ready()) {
		return 0.0;
	}
	const ViewOptions &seen = properties.view;
	FieldMotion::Frame now = frame(delta, properties.motion.wind);
	motion.wait();
	const bool wants_skeletons = seen.skeleton_distance > 0.0 && !Engine::get_singleton()->is_editor_hint();
	if (wants_skeletons || properties.motion.far_distance > 0.0) {
		now.eyes = find_eyes();
	}
	const bool is_seen = node->is_visible_in_tree();
	const bool has_chosen = !style.levels.empty() &&
			skeletons.choose({ node, store, style, motion, now.axes, wear },
					wants_skeletons && is_seen ? now.eyes : std::vector<Vector3>(), seen.skeleton_distance,
					seen.max_skeletons);
	if ((simulates || has_chosen || !unseen.empty()) && is_seen) {
		refresh();
	}
	skeletons.pose(store, motion);
	if (!simulates || store.plant_count() == 0) {
		return 0.0;
	}
	motion.bodies.watch(now.tree, properties.motion.bodies_group, now.axes, delta);
	return motion.advance(now, properties.motion);
}

void Meadow::preview(double delta, const Ref<PlantWind> &blowing) {
	motion.preview(frame(delta, blowing), properties.motion);
	refresh();
	skeletons.pose(store, motion);
}

void Meadow::refresh() {
	if (!motion.is_ready() || !node->is_inside_tree()) {
		return;
	}
	const Clock::time_point start = Clock::now();
	if (motion.upload()) {
		dress();
	}
	if (!unseen.empty()) {
		view.show_added(style, *motion.poses(), store, unseen);
		unseen.clear();
	}
	send_uniforms();
	upload_usec = std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

// Materials belong to one field and level, since textures cannot differ by instance.
void Meadow::dress() {
	has_sent_delays = false;
	for (FieldLook &look : style.looks) {
		const bool is_new = look.materials.empty();
		for (size_t i = look.materials.size(); i < style.levels.size(); i++) {
			look.materials.push_back(make_field_material(worn_material(look)));
		}
		for (size_t i = 0; i < look.materials.size(); i++) {
			const FieldLevel &level = style.levels[i];
			const float begin = level.begin > 0.0f ? level.begin : -FARTHEST;
			const float end = level.end > 0.0f ? level.end : FARTHEST;
			look.materials[i]->set_shader_parameter("undergrowth_level", Vector3(begin, end, level.margin));
			look.materials[i]->set_shader_parameter("undergrowth_bends", motion.poses()->poses());
			look.materials[i]->set_shader_parameter("undergrowth_blends", motion.poses()->blends());
		}
		if (is_new && !look.materials.empty() && !bends_in_shader(look.materials[0])) {
			report_error(look.function.ptr(),
					"its material has a shader that does not bend in a PlantField3D. Include "
					"undergrowth_bend.gdshaderinc, which says how.");
		}
	}
}

Ref<Material> Meadow::worn_material(const FieldLook &look) const {
	const Ref<Material> instead = node->get_material_override();
	return instead.is_valid() ? instead : look.function->get_material();
}

void Meadow::change_materials() {
	motion.wait();
	std::vector<std::vector<Ref<ShaderMaterial>>> old; // They go once nobody wears them.
	for (FieldLook &look : style.looks) {
		old.push_back(std::move(look.materials));
		look.materials.clear();
		for (SampledPlant &sampled : look.nearest) {
			sampled.material = look.function->get_material();
		}
	}
	if (motion.is_ready() && motion.poses()->poses().is_valid()) {
		dress();
		view.wear_materials(style);
		skeletons.release_all(motion);
	}
}

void Meadow::follow_materials() {
	if (style.looks.empty()) {
		return;
	}
	followed_look = (followed_look + 1) % style.looks.size();
	const FieldLook &look = style.looks[followed_look];
	for (const Ref<ShaderMaterial> &material : look.materials) {
		follow_material(worn_material(look), material);
	}
}

void Meadow::send_uniforms() {
	if (!motion.poses() || !motion.poses()->follows()) {
		return;
	}
	const FieldMotion::Delays delays = motion.follower_delays(axes_of(node));
	const bool are_other = !has_sent_delays || delays.after != sent_delays.after ||
			delays.before != sent_delays.before || delays.share != sent_delays.share;
	sent_delays = delays;
	has_sent_delays = true;
	for (size_t i = 0; i < style.looks.size(); i++) {
		const Vector3 history = motion.history_of(int(i));
		for (const Ref<ShaderMaterial> &material : style.looks[i].materials) {
			material->set_shader_parameter("undergrowth_history", history);
			if (!are_other) {
				continue;
			}
			material->set_shader_parameter("undergrowth_delay", delays.after);
			material->set_shader_parameter("undergrowth_delay_before", delays.before);
			material->set_shader_parameter("undergrowth_delay_share", delays.share);
		}
	}
}

int Meadow::species_for(const Ref<PlantFunction> &function) {
	for (size_t i = 0; i < style.looks.size(); i++) {
		if (style.looks[i].function == function) {
			return int(i);
		}
	}
	if (style.levels.empty()) {
		style.levels = read_levels(properties.view, node->get_visibility_range_end());
		read_looks(StandOptions(), {}, style);
	}
	FieldLook look;
	const String fault = read_other_look(function, properties.stand, style, look);
	if (!fault.is_empty()) {
		report_error(node, "cannot add plants of " + fault);
		return -1;
	}
	if (!motion.is_ready()) {
		motion.start(settings());
	}
	motion.add_species(look);
	style.looks.push_back(std::move(look));
	if (motion.poses()->poses().is_valid()) {
		dress();
	}
	return int(style.looks.size()) - 1;
}

ChangeSet Meadow::apply(StandEdit &&edit) {
	motion.wait();
	std::vector<TileKey> touched;
	for (const PlantPlace &place : edit.removed) {
		if (store.block(place.block).is_added) {
			touched.push_back(store.block(place.block).tile);
		}
	}
	ChangeSet changes = store.apply(std::move(edit));
	motion.apply(changes, store, style);
	for (const ChangeSet::Grown &grown : changes.grown) {
		unseen.insert(store.block(grown.block).tile);
	}
	if (!changes.dropped.empty()) {
		unseen.insert(touched.begin(), touched.end());
	}
	return changes;
}

std::vector<PlantId> Meadow::add(std::vector<PlacedPlant> &&plants) {
	StandEdit edit;
	edit.added = std::move(plants);
	return apply(std::move(edit)).added;
}

void Meadow::remove(std::vector<PlantPlace> &&places) {
	if (job) {
		for (const PlantPlace &place : places) {
			removed_meanwhile.push_back(store.id(place));
		}
	}
	StandEdit edit;
	edit.removed = std::move(places);
	apply(std::move(edit));
	skeletons.release_gone(store);
	refresh();
}

void Meadow::settle() {
	if (motion.is_ready()) {
		motion.settle();
		refresh();
		skeletons.pose(store, motion);
	}
}

void Meadow::read_motion(const PlantFunction *function, bool is_still) {
	for (size_t i = 0; i < style.looks.size(); i++) {
		if (style.looks[i].function.ptr() == function && motion.is_ready()) {
			style.looks[i].read_motion();
			motion.set_species(int(i), style.looks[i], store, is_still);
		}
	}
	if (is_still && motion.is_ready()) {
		motion.write_all();
		refresh();
	}
}

bool Meadow::update_levels() {
	if (!find_level_fault(properties.view).is_empty()) {
		return false; // The next filling tells of it.
	}
	const std::vector<FieldLevel> wanted = read_levels(properties.view, node->get_visibility_range_end());
	const bool same = std::equal(wanted.begin(), wanted.end(), style.levels.begin(), style.levels.end(),
			[](const FieldLevel &a, const FieldLevel &b) { return a.lod == b.lod && a.tile_factor == b.tile_factor; });
	if (!same) {
		return style.levels.empty();
	}
	style.levels = wanted;
	view.update_levels(style);
	skeletons.dress(wear, style.levels[0].casts_shadows);
	if (motion.poses() && motion.poses()->poses().is_valid()) {
		dress();
	}
	return true;
}

void Meadow::update_wear(const FieldWear &wanted) {
	if (!(wanted == wear)) {
		wear = wanted;
		view.wear(wear);
		skeletons.dress(wear, style.levels.empty() || style.levels[0].casts_shadows);
	}
}

void Meadow::skeletons_changed() {
	skeletons.choose_soon();
	if (properties.view.skeleton_distance <= 0.0 || properties.view.max_skeletons <= 0) {
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
	motion.bodies.forget();
	view.set_scenario(RID());
}

void Meadow::moved() {
	view.set_transform(node->get_global_transform());
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
