#include "field/skeleton_view.hpp"

#include "convert.hpp"
#include "field/plant_transforms.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace godot;

namespace undergrowth {

static constexpr int FRAMES_BETWEEN_CHOICES = 6;
static constexpr int MOST_NEW = 8; // Per frame; each needs a mesh of its own.
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

static const FieldLevel &first_used(const FieldLook &look) {
	return *std::find_if(look.levels.begin(), look.levels.end() - 1, [](const FieldLevel &one) { return one.is_used; });
}

// Returns the distance up to which a species is drawn in full with the first level of detail, or with the first levels
// if they have all variants. Without an end: `otherwise`.
static float end_of_whole(const FieldLook &look, float otherwise) {
	float end = 0.0f;
	for (const FieldLevel &level : look.levels) {
		const bool is_like_first = end == 0.0f || (look.is_by_error && level.halvings == 0);
		if (level.is_used && is_like_first) {
			end = level.end > 0.0f ? level.end - level.end_margin : otherwise;
		}
	}
	return end;
}

// Returns the nearest plants, nearest first. The distance is limited to where levels with all variants are drawn in
// full.
std::vector<PlantPlace> SkeletonView::find_nearest(
		const Scene &scene, const std::vector<Vector3> &eyes, double wanted, int most) const {
	float distance = 0.0f;
	for (const FieldLook &look : scene.style.looks) {
		distance = std::max(distance, std::min(float(wanted), end_of_whole(look, float(wanted))));
	}
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
			const FieldLook &look = scene.style.looks[size_t(block.species)];
			const Thinning thinning = first_used(look).thinning_of(look.has_parts());
			const bool is_whole = !thinning.is_any() || // Thinned plants get no skeleton.
					thinning.width_of(plant_rank(scene.store.id(place)), away) == 1.0f;
			if (counted <= std::min(distance, end_of_whole(look, distance)) && is_whole && !scene.changes.is_mown(scene.store, place)) {
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
	for (const Shown &entry : gone) {
		if (motion) {
			motion->set_hidden(entry.place, false);
		}
		if (Skeleton3D *skeleton = FieldSkeletons::node(entry.skeleton)) {
			nodes.give_back(skeleton);
			tell(skeleton, false);
		}
	}
	return !gone.empty();
}

void SkeletonView::release_gone(const PlantStore &store) {
	release(nullptr, [&](const Shown &entry) {
		const PlantBlock &block = store.block(entry.place.block);
		return entry.place.slot >= block.size() || block.is_gone(entry.place.slot);
	});
}

void SkeletonView::release_those(FieldMotion &motion, const std::vector<PlantPlace> &ascending) {
	release(&motion,
			[&](const Shown &entry) { return std::binary_search(ascending.begin(), ascending.end(), entry.place); });
}

void SkeletonView::release_in(const std::vector<int> &blocks) {
	const auto goes = [&](const Shown &entry) {
		return std::find(blocks.begin(), blocks.end(), entry.place.block) != blocks.end();
	};
	if (!shown.empty() && release(nullptr, goes)) {
		frames_since_choice = 0;
	}
}

void SkeletonView::release_all(FieldMotion &motion) {
	release(motion.is_ready() ? &motion : nullptr, [](const Shown &) { return true; });
	frames_since_choice = 0;
}

void SkeletonView::show(const Scene &scene, const PlantPlace &place) {
	const PlacedPlant plant = scene.store.block(place.block).plants.plant(place.slot);
	const FieldLook &look = scene.style.looks[size_t(plant.species)];
	SampledPlant sampled = look.sample_alone(plant);
	sampled.rest = own_bend(scene.motion.read_drawn_stem_now(place).rest, plant.turn);
	std::shared_ptr<PartSkeleton> parts = PartSkeleton::of(sampled);
	Skeleton3D *skeleton = nodes.take(scene.field, drawn_transform(plant), sampled.build(), parts.get(), scene.wear);
	shown.push_back({ place, uint64_t(skeleton->get_instance_id()), std::move(parts) });
	scene.motion.set_hidden(place, true);
	tell(skeleton, true);
}

bool SkeletonView::choose(const Scene &scene, const std::vector<Vector3> &eyes, double distance, int most) {
	if (((distance <= 0.0 || most <= 0) && shown.empty()) || frames_since_choice++ % FRAMES_BETWEEN_CHOICES != 0) {
		return false;
	}
	const std::vector<PlantPlace> nearest = find_nearest(scene, eyes, distance, most);
	const std::set<PlantPlace> wanted(nearest.begin(), nearest.end());
	const bool changes = release(&scene.motion, [&](const Shown &entry) { return wanted.count(entry.place) == 0; });
	int added = 0;
	for (size_t i = 0; i < nearest.size() && added < MOST_NEW; i++) {
		if (!find_shown(nearest[i])) {
			show(scene, nearest[i]);
			added++;
		}
	}
	if (added == MOST_NEW) {
		frames_since_choice = 0; // There may be more.
	}
	return changes || added > 0;
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
