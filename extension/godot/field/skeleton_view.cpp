#include "field/skeleton_view.hpp"

#include "convert.hpp"
#include "field/plant_transforms.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr int FRAMES_BETWEEN_CHOICES = 6;
static constexpr size_t MOST_NEW = 8; // Per frame; each needs a mesh of its own.
// A shown plant stays up to this multiple of the distance, so that nothing flickers.
static constexpr float KEPT_FARTHER = 1.1f;

// From the field's axes to the axes of a plant with this turn.
static glm::vec2 own_bend(const glm::vec2 &bend, float turn) {
	const float c = std::cos(turn);
	const float d = std::sin(turn);
	return { c * bend.x - d * bend.y, d * bend.x + c * bend.y };
}

const SkeletonView::Shown *SkeletonView::find_shown(const PlantPlace &place) const {
	const auto found =
			std::find_if(shown.begin(), shown.end(), [&](const Shown &entry) { return entry.place == place; });
	return found == shown.end() ? nullptr : &*found;
}

// Returns the nearest plants, nearest first. The distance is limited to where the first level of detail, which has the
// same mesh, is drawn in full.
std::vector<PlantPlace> SkeletonView::find_nearest(
		const Scene &scene, const std::vector<Vector3> &eyes, double wanted, int most) const {
	const FieldLevel &first = scene.style.levels[0];
	const float whole = first.end > 0.0f ? first.end - first.margin : float(wanted);
	const float distance = std::min(float(wanted), whole);
	const Transform3D to_field = scene.axes.affine_inverse();
	const Vector3 scale = to_field.basis.get_scale().abs();
	const float reach = KEPT_FARTHER * distance * std::max({ scale.x, scale.y, scale.z });
	std::map<PlantPlace, float> nearest; // m; reduced for shown plants.
	for (const Vector3 &eye : eyes) {
		std::vector<PlantPlace> around;
		scene.store.find_in_sphere(to_glm(to_field.xform(eye)), reach, around);
		for (const PlantPlace &place : around) {
			const PlantBlock &block = scene.store.block(place.block);
			const float away = scene.axes.xform(to_godot(block.root(place.slot))).distance_to(eye);
			const float counted = find_shown(place) ? away / KEPT_FARTHER : away;
			const Thinning thinning = first.thinning_of(scene.style.looks[size_t(block.species)].has_parts());
			const bool is_whole = !thinning.is_any() || // Thinned plants get no skeleton.
					thinning.width_of(plant_rank(scene.store.id(place)), away) == 1.0f;
			if (counted <= distance && is_whole && !scene.changes.is_mown(scene.store, place)) {
				const auto [entry, is_new] = nearest.insert({ place, counted });
				entry->second = std::min(entry->second, counted);
			}
		}
	}
	std::vector<std::pair<float, PlantPlace>> sorted;
	for (const auto &[place, away] : nearest) {
		sorted.push_back({ away, place });
	}
	const size_t count = std::min(sorted.size(), size_t(most));
	std::partial_sort(sorted.begin(), sorted.begin() + std::ptrdiff_t(count), sorted.end());
	std::vector<PlantPlace> chosen;
	for (size_t i = 0; i < count; i++) {
		chosen.push_back(sorted[i].second);
	}
	return chosen;
}

// Releases the entries for which `goes` is true. With `motion`, their plants are drawn in multimeshes again.
bool SkeletonView::release(FieldMotion *motion, const std::function<bool(const Shown &)> &goes) {
	std::vector<Shown> kept, gone;
	for (const Shown &entry : shown) {
		const bool stays = FieldSkeletons::node(entry.skeleton) && !goes(entry);
		(stays ? kept : gone).push_back(entry);
	}
	shown = std::move(kept);
	for (size_t i = 0; motion && i < gone.size(); i++) {
		motion->set_hidden(gone[i].place, false);
	}
	give_back(gone);
	return !gone.empty();
}

// Last, because a handler of the signal may change the field.
void SkeletonView::give_back(const std::vector<Shown> &gone) {
	for (const Shown &entry : gone) {
		if (Skeleton3D *skeleton = FieldSkeletons::node(entry.skeleton)) {
			nodes.give_back(skeleton);
			tell(skeleton, false);
		}
	}
}

// The signal waits for release_left(): a handler could change the field in the middle of a change.
void SkeletonView::follow(const ChangeSet &changes) {
	const auto is_gone = [&](const Shown &entry) {
		return std::find(changes.dropped.begin(), changes.dropped.end(), entry.place.block) != changes.dropped.end() ||
				std::find(changes.gone.begin(), changes.gone.end(), entry.place) != changes.gone.end();
	};
	const auto stay = std::stable_partition(shown.begin(), shown.end(), std::not_fn(is_gone));
	if (stay != shown.end()) {
		left.insert(left.end(), std::make_move_iterator(stay), std::make_move_iterator(shown.end()));
		shown.erase(stay, shown.end());
		frames_since_choice = 0;
	}
}

void SkeletonView::release_left() {
	give_back(std::exchange(left, {}));
}

void SkeletonView::release_those(FieldMotion &motion, const std::vector<PlantPlace> &ascending) {
	release(&motion,
			[&](const Shown &entry) { return std::binary_search(ascending.begin(), ascending.end(), entry.place); });
}

void SkeletonView::release_all(FieldMotion &motion) {
	release_left();
	release(motion.is_ready() ? &motion : nullptr, [](const Shown &) { return true; });
	frames_since_choice = 0;
}

Skeleton3D *SkeletonView::show(const Scene &scene, const PlantPlace &place) {
	const PlacedPlant plant = scene.store.block(place.block).plants.plant(place.slot);
	const FieldLook &look = scene.style.looks[size_t(plant.species)];
	SampledPlant sampled = look.sample_alone(plant);
	sampled.rest = own_bend(scene.motion.read_drawn_stem_now(place).rest, plant.turn);
	std::shared_ptr<PartSkeleton> parts = PartSkeleton::of(sampled);
	Skeleton3D *skeleton = nodes.take(scene.field, drawn_transform(plant), sampled.build(), parts.get(), scene.wear);
	shown.push_back({ place, uint64_t(skeleton->get_instance_id()), std::move(parts) });
	scene.motion.set_hidden(place, true);
	return skeleton;
}

bool SkeletonView::choose(const Scene &scene, const std::vector<Vector3> &eyes, double distance, int most) {
	if (((distance <= 0.0 || most <= 0) && shown.empty()) || frames_since_choice++ % FRAMES_BETWEEN_CHOICES != 0) {
		return false;
	}
	const std::vector<PlantPlace> nearest = find_nearest(scene, eyes, distance, most);
	const std::set<PlantPlace> wanted(nearest.begin(), nearest.end());
	const bool changes = release(&scene.motion, [&](const Shown &entry) { return wanted.count(entry.place) == 0; });
	std::vector<uint64_t> added;
	for (size_t i = 0; i < nearest.size() && added.size() < MOST_NEW; i++) {
		if (!find_shown(nearest[i])) {
			added.push_back(uint64_t(show(scene, nearest[i])->get_instance_id()));
		}
	}
	if (added.size() == MOST_NEW) {
		frames_since_choice = 0; // There may be more.
	}
	for (const uint64_t skeleton : added) { // Last, because a handler of the signal may change the field.
		if (Skeleton3D *node = FieldSkeletons::node(skeleton)) {
			tell(node, true);
		}
	}
	return changes || !added.empty();
}

void SkeletonView::pose(const PlantStore &store, const FieldMotion &motion) const {
	for (const Shown &entry : shown) {
		Skeleton3D *skeleton = FieldSkeletons::node(entry.skeleton);
		if (!skeleton) {
			continue; // A script has freed it; the next selection removes the entry.
		}
		const StemMotion stem = motion.read_drawn_stem_now(entry.place);
		const float turn = store.block(entry.place.block).plants.plant(entry.place.slot).turn;
		const auto to_own = [turn](const glm::vec2 &s) { return own_bend(s, turn); };
		const glm::vec2 own = to_own(stem.bend);
		if (!entry.parts || !entry.parts->has_joints()) {
			FieldSkeletons::pose(skeleton, quaternion_of(own));
		}
		if (entry.parts) {
			entry.parts->stem = { own, to_own(stem.rate), to_own(stem.rest), to_own(stem.second), stem.clock };
			entry.parts->pose(skeleton);
		}
	}
}

void SkeletonView::dress(const FieldWear &wear) const {
	for (const Shown &entry : shown) {
		if (Skeleton3D *skeleton = FieldSkeletons::node(entry.skeleton)) {
			FieldSkeletons::dress(skeleton, wear);
		}
	}
}

void SkeletonView::follow_stems(const PlantStore &store, const FieldStyle &style, FieldMotion &motion) {
	const auto stem_of = [&](const Shown &entry) {
		return style.looks[size_t(store.block(entry.place.block).species)].stem;
	};
	release(&motion, [&](const Shown &entry) {
		const std::shared_ptr<const StemConstants> stem = stem_of(entry);
		return (entry.parts ? entry.parts->joint_count() : 0) != (stem ? stem->joints : 0);
	});
	for (const Shown &entry : shown) {
		if (const std::shared_ptr<const StemConstants> stem = stem_of(entry)) {
			entry.parts->set_stem(stem);
		}
	}
}

TypedArray<Skeleton3D> SkeletonView::skeletons() const {
	TypedArray<Skeleton3D> found;
	for (const Shown &entry : shown) {
		if (Skeleton3D *skeleton = FieldSkeletons::node(entry.skeleton)) {
			found.push_back(skeleton);
		}
	}
	return found;
}

Skeleton3D *SkeletonView::find(const PlantPlace &place) const {
	const Shown *entry = find_shown(place);
	return entry ? FieldSkeletons::node(entry->skeleton) : nullptr;
}

PlantPlace SkeletonView::find(const Skeleton3D *skeleton) const {
	for (const Shown &entry : shown) {
		if (skeleton && entry.skeleton == uint64_t(skeleton->get_instance_id())) {
			return entry.place;
		}
	}
	return {};
}

} // namespace undergrowth
