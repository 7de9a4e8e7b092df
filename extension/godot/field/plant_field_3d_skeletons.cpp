// The part of PlantField3D that shows the plants nearest to the camera as nodes with skeletons.

#include "convert.hpp"
#include "field/plant_field_3d.hpp"

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/viewport.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <set>

using namespace godot;

namespace undergrowth {

static constexpr int FRAMES_BETWEEN_CHOICES = 6;
static constexpr int MOST_NEW = 8; // A frame; each takes a mesh of its own.
static constexpr float KEPT_FARTHER = 1.1f; // What is shown stays until it is so much too far: nothing flickers.

bool PlantField3D::wants_skeletons() const {
	return options.skeleton_distance > 0.0 && options.most_skeletons > 0 && simulation &&
			!Engine::get_singleton()->is_editor_hint();
}

// The nearest plants, nearest first; no farther than the first level of detail, whose mesh they wear, is drawn whole.
std::vector<PlantField3D::Near> PlantField3D::find_nearest() const {
	std::vector<Near> nearest;
	const Camera3D *camera = wants_skeletons() && is_visible_in_tree() ? get_viewport()->get_camera_3d() : nullptr;
	if (!camera) {
		return nearest;
	}
	const FieldLevel &first = style.levels[0];
	const float whole = first.end > 0.0f ? first.end - first.margin : float(options.skeleton_distance);
	const float distance = std::min(float(options.skeleton_distance), whole);
	const Vector3 eye = camera->get_global_position();
	const Transform3D placed = axes();
	const Transform3D to_field = placed.affine_inverse();
	const float reach = KEPT_FARTHER * distance * to_field.basis.get_column(1).length();
	for (int p = 0; p < int(patches.size()); p++) {
		const FieldPatch &patch = *patches[size_t(p)];
		for (const int plant : find_in_sphere(patch.plants, patch.chunks, to_glm(to_field.xform(eye)), reach)) {
			if (patch.places[size_t(plant)] == FieldPatch::GONE) {
				continue;
			}
			const float away = placed.xform(to_godot(patch.plants.plant(plant).root)).distance_to(eye);
			const bool is_shown = find_shown(p, plant) != nullptr;
			if (is_shown || away <= distance) {
				nearest.push_back({ is_shown ? away / KEPT_FARTHER : away, p, plant });
			}
		}
	}
	const size_t count = std::min(nearest.size(), size_t(options.most_skeletons));
	const auto is_nearer = [](const Near &a, const Near &b) { return a.away < b.away; };
	std::partial_sort(nearest.begin(), nearest.begin() + std::ptrdiff_t(count), nearest.end(), is_nearer);
	nearest.resize(count);
	return nearest;
}

const FieldSkeletons::Shown *PlantField3D::find_shown(int patch, int plant) const {
	const auto found = std::find_if(skeletons.shown.begin(), skeletons.shown.end(),
			[&](const FieldSkeletons::Shown &entry) { return entry.patch == patch && entry.plant == plant; });
	return found == skeletons.shown.end() ? nullptr : &*found;
}

// Takes those away that `goes` names; the field draws these plants again after hide_shown().
template <class Test> bool PlantField3D::release_skeletons(Test &&goes) {
	std::vector<FieldSkeletons::Shown> kept;
	for (const FieldSkeletons::Shown &entry : skeletons.shown) {
		Skeleton3D *skeleton = FieldSkeletons::node(entry);
		if (skeleton && !goes(entry)) {
			kept.push_back(entry);
		} else if (skeleton) {
			skeletons.give_back(skeleton);
			call_deferred("emit_signal", "skeleton_hidden", skeleton);
		}
	}
	const bool changes = kept.size() < skeletons.shown.size();
	skeletons.shown = std::move(kept);
	return changes;
}

// After a property that decides about them changed.
void PlantField3D::skeletons_changed() {
	frames_since_choice = 0;
	if (!wants_skeletons()) {
		finish_step();
		release_all_skeletons();
		skeletons.clear();
		upload();
	}
	update_processing();
	update_configuration_warnings();
}

void PlantField3D::release_all_skeletons() {
	release_skeletons([](const FieldSkeletons::Shown &) { return true; });
	frames_since_choice = 0;
	hide_shown();
}

void PlantField3D::release_added_skeletons() {
	if (release_skeletons([this](const FieldSkeletons::Shown &entry) { return entry.patch >= filled_patches; })) {
		hide_shown();
	}
}

void PlantField3D::release_removed_skeletons() {
	release_skeletons([this](const FieldSkeletons::Shown &entry) {
		return patches[size_t(entry.patch)]->places[size_t(entry.plant)] == FieldPatch::GONE;
	});
	hide_shown(); // Others have moved within their pages.
}

// In the field's textures, the plants that skeletons show are not there.
void PlantField3D::hide_shown() {
	if (!bends || !simulation) {
		return;
	}
	std::vector<int> changed = bends->hidden_pages();
	bends->show_all();
	for (const FieldSkeletons::Shown &entry : skeletons.shown) {
		const FieldPatch &patch = *patches[size_t(entry.patch)];
		bends->hide(patch.page(entry.plant), patch.index(entry.plant));
	}
	const std::vector<int> hidden = bends->hidden_pages();
	changed.insert(changed.end(), hidden.begin(), hidden.end());
	for (const int page : std::set<int>(changed.begin(), changed.end())) {
		if (page < simulation->page_count()) {
			bends->write_page(*simulation, page);
		}
	}
}

void PlantField3D::show_skeleton(const Near &near) {
	const FieldPatch &patch = *patches[size_t(near.patch)];
	const PlacedPlant plant = patch.plants.plant(near.plant);
	const FieldLook &look = style.looks[size_t(plant.species)];
	Skeleton3D *skeleton = skeletons.take(this, drawn_transform(plant), look.build_alone(plant),
			{ uint32_t(options.layers), style.levels[0].casts_shadows });
	skeletons.shown.push_back({ near.patch, near.plant, uint64_t(skeleton->get_instance_id()) });
	call_deferred("emit_signal", "skeleton_shown", skeleton);
}

// Between two steps. Tells whether the textures changed.
bool PlantField3D::choose_skeletons() {
	if (!wants_skeletons() && skeletons.shown.empty()) {
		return false;
	}
	if (frames_since_choice++ % FRAMES_BETWEEN_CHOICES != 0) {
		return false;
	}
	const std::vector<Near> nearest = find_nearest();
	std::set<std::pair<int, int>> wanted;
	for (const Near &near : nearest) {
		wanted.insert({ near.patch, near.plant });
	}
	bool changes = release_skeletons(
			[&](const FieldSkeletons::Shown &entry) { return wanted.count({ entry.patch, entry.plant }) == 0; });
	int added = 0;
	for (size_t i = 0; i < nearest.size() && added < MOST_NEW; i++) {
		if (!find_shown(nearest[i].patch, nearest[i].plant)) {
			show_skeleton(nearest[i]);
			added++;
		}
	}
	if (added == MOST_NEW) {
		frames_since_choice = 0; // There may be more.
	}
	if (changes || added > 0) {
		hide_shown();
	}
	return changes || added > 0;
}

// The bend that the vertex shader reads for the same plant in this frame: undergrowth_bend.gdshaderinc.
glm::vec2 PlantField3D::drawn_bend(const FieldPatch &patch, int plant) const {
	return simulation->shown_bend(patch.page(plant), patch.index(plant), shown_alpha);
}

void PlantField3D::pose_skeletons() {
	for (const FieldSkeletons::Shown &entry : skeletons.shown) {
		Skeleton3D *skeleton = FieldSkeletons::node(entry);
		if (!skeleton) {
			continue; // A script has freed it; the next choice finds out.
		}
		const FieldPatch &patch = *patches[size_t(entry.patch)];
		const glm::vec2 bend = drawn_bend(patch, entry.plant);
		const float turn = patch.plants.plant(entry.plant).turn;
		const float c = std::cos(turn);
		const float d = std::sin(turn);
		const glm::vec2 own(c * bend.x - d * bend.y, d * bend.x + c * bend.y);
		const float scale = 1.0f / std::sqrt(1.0f + glm::dot(own, own));
		FieldSkeletons::pose(skeleton, Quaternion(own.y * scale, 0.0f, -own.x * scale, scale));
	}
}

} // namespace undergrowth
