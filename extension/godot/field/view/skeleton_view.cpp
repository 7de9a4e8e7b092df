#include "field/view/skeleton_view.hpp"

#include "base/convert.hpp"
#include "field/view/plant_transforms.hpp"

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
static constexpr size_t MAX_NEW_SKELETONS = 8; // Per frame; each needs a mesh of its own.
// A shown plant stays up to this multiple of the distance, so that nothing flickers.
static constexpr float HYSTERESIS = 1.1f;

// From the field's axes to the axes of a plant with this turn.
static glm::vec2 own_bend(const glm::vec2 &bend, float turn) {
	const float c = std::cos(turn);
	const float d = std::sin(turn);
	return { c * bend.x - d * bend.y, d * bend.x + c * bend.y };
}

const SkeletonView::Shown *SkeletonView::find_shown(const PlantRef &ref) const {
	const auto found = std::find_if(shown.begin(), shown.end(), [&](const Shown &entry) { return entry.ref == ref; });
	return found == shown.end() ? nullptr : &*found;
}

static const FieldLevel &first_used(const SpeciesStyle &style) {
	return *std::find_if(
			style.levels.begin(), style.levels.end() - 1, [](const FieldLevel &one) { return one.is_used; });
}

// Returns the distance up to which a species is drawn in full with the first level of detail, or with the first levels
// if they have all variants. Without an end: `otherwise`.
static float end_of_whole(const SpeciesStyle &style, float otherwise) {
	float end = 0.0f;
	for (const FieldLevel &level : style.levels) {
		const bool is_like_first = end == 0.0f || (style.is_by_error && level.halvings == 0);
		if (level.is_used && is_like_first) {
			end = level.end > 0.0f ? level.end - level.end_margin : otherwise;
		}
	}
	return end;
}

// Returns the nearest plants, nearest first. The distance is limited to where levels with all variants are drawn in
// full.
std::vector<PlantRef> SkeletonView::find_nearest(
		const Scene &scene, const std::vector<Vector3> &cameras, double wanted, int max) const {
	float distance = 0.0f;
	for (const SpeciesStyle &style : scene.setup.styles) {
		distance = std::max(distance, std::min(float(wanted), end_of_whole(style, float(wanted))));
	}
	const Transform3D to_field = scene.axes.affine_inverse();
	const Vector3 scale = to_field.basis.get_scale().abs();
	const float reach = HYSTERESIS * distance * std::max({ scale.x, scale.y, scale.z });
	std::map<PlantRef, float> nearest; // m; reduced for shown plants.
	for (const Vector3 &camera : cameras) {
		std::vector<PlantRef> around;
		scene.store.find_in_sphere(to_glm(to_field.xform(camera)), reach, around);
		for (const PlantRef &ref : around) {
			const PlantChunk &chunk = scene.store.chunk(ref.chunk);
			const float away = scene.axes.xform(to_godot(chunk.root(ref.slot))).distance_to(camera);
			const float counted = find_shown(ref) ? away / HYSTERESIS : away;
			const SpeciesStyle &style = scene.setup.styles[size_t(chunk.species)];
			const LodDensity lod_density = first_used(style).lod_density_of(style.has_parts());
			const bool is_whole = !lod_density.is_any() || // Thinned plants get no skeleton.
					lod_density.width_of(plant_rank(scene.store.id(ref)), away) == 1.0f;
			if (counted <= std::min(distance, end_of_whole(style, distance)) && is_whole &&
					!scene.edits.is_mown(scene.store, ref)) {
				const auto [entry, is_new] = nearest.insert({ ref, counted });
				entry->second = std::min(entry->second, counted);
			}
		}
	}
	std::vector<std::pair<float, PlantRef>> sorted;
	for (const auto &[ref, away] : nearest) {
		sorted.push_back({ away, ref });
	}
	const size_t count = std::min(sorted.size(), size_t(max));
	std::partial_sort(sorted.begin(), sorted.begin() + std::ptrdiff_t(count), sorted.end());
	std::vector<PlantRef> chosen;
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
		motion->set_hidden(gone[i].ref, false);
	}
	give_back(gone);
	return !gone.empty();
}

// Last, because a handler of the signal may change the field.
void SkeletonView::give_back(const std::vector<Shown> &gone) {
	for (const Shown &entry : gone) {
		if (Skeleton3D *skeleton = FieldSkeletons::node(entry.skeleton)) {
			nodes.give_back(skeleton);
			callback(skeleton, false);
		}
	}
}

// The signal waits for release_left(): a handler could change the field in the middle of a change.
void SkeletonView::follow(const ChangeSet &changes) {
	const auto is_gone = [&](const Shown &entry) {
		return std::find(changes.dropped.begin(), changes.dropped.end(), entry.ref.chunk) != changes.dropped.end() ||
				std::find(changes.gone.begin(), changes.gone.end(), entry.ref) != changes.gone.end();
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

void SkeletonView::release_those(FieldMotion &motion, const std::vector<PlantRef> &ascending) {
	release(&motion,
			[&](const Shown &entry) { return std::binary_search(ascending.begin(), ascending.end(), entry.ref); });
}

void SkeletonView::release_all(FieldMotion &motion) {
	release_left();
	release(motion.is_ready() ? &motion : nullptr, [](const Shown &) { return true; });
	frames_since_choice = 0;
}

Skeleton3D *SkeletonView::show(const Scene &scene, const PlantRef &ref) {
	const PlacedPlant plant = scene.store.chunk(ref.chunk).plants.plant(ref.slot);
	const SpeciesStyle &style = scene.setup.styles[size_t(plant.species)];
	SampledPlant sampled = style.sample_alone(plant);
	sampled.rest = own_bend(scene.motion.blocking_read_drawn_stem(ref).rest, plant.turn);
	std::shared_ptr<PartSkeleton> parts = PartSkeleton::of(sampled);
	Skeleton3D *skeleton = nodes.take(scene.field, drawn_transform(plant), sampled.build(), parts.get(), scene.flags);
	shown.push_back({ ref, uint64_t(skeleton->get_instance_id()), std::move(parts) });
	scene.motion.set_hidden(ref, true);
	return skeleton;
}

bool SkeletonView::choose(const Scene &scene, const std::vector<Vector3> &cameras, double distance, int max) {
	if (((distance <= 0.0 || max <= 0) && shown.empty()) || frames_since_choice++ % FRAMES_BETWEEN_CHOICES != 0) {
		return false;
	}
	const std::vector<PlantRef> nearest = find_nearest(scene, cameras, distance, max);
	const std::set<PlantRef> wanted(nearest.begin(), nearest.end());
	const bool changes = release(&scene.motion, [&](const Shown &entry) { return wanted.count(entry.ref) == 0; });
	std::vector<uint64_t> added;
	for (size_t i = 0; i < nearest.size() && added.size() < MAX_NEW_SKELETONS; i++) {
		if (!find_shown(nearest[i])) {
			added.push_back(uint64_t(show(scene, nearest[i])->get_instance_id()));
		}
	}
	if (added.size() == MAX_NEW_SKELETONS) {
		frames_since_choice = 0; // There may be more.
	}
	for (const uint64_t skeleton : added) { // Last, because a handler of the signal may change the field.
		if (Skeleton3D *node = FieldSkeletons::node(skeleton)) {
			callback(node, true);
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
		const StemMotion stem = motion.blocking_read_drawn_stem(entry.ref);
		const float turn = store.chunk(entry.ref.chunk).plants.plant(entry.ref.slot).turn;
		const auto to_own = [turn](const glm::vec2 &s) { return own_bend(s, turn); };
		const glm::vec2 own = to_own(stem.bend);
		if (!entry.parts || !entry.parts->has_joints()) {
			FieldSkeletons::pose(skeleton, quaternion_of(own));
		}
		if (entry.parts) {
			entry.parts->stem = { own, to_own(stem.rate), to_own(stem.rest), to_own(stem.second), stem.clock, stem.air,
				stem.stirred, stem.turns, stem.drops };
			entry.parts->pose(skeleton);
		}
	}
}

void SkeletonView::apply_flags(const InstanceRenderFlags &flags) const {
	for (const Shown &entry : shown) {
		if (Skeleton3D *skeleton = FieldSkeletons::node(entry.skeleton)) {
			FieldSkeletons::apply_flags(skeleton, flags);
		}
	}
}

void SkeletonView::follow_stems(const PlantStore &store, const FieldRenderSetup &setup, FieldMotion &motion) {
	const auto stem_of = [&](const Shown &entry) {
		return setup.styles[size_t(store.chunk(entry.ref.chunk).species)].stem;
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

Skeleton3D *SkeletonView::find(const PlantRef &ref) const {
	const Shown *entry = find_shown(ref);
	return entry ? FieldSkeletons::node(entry->skeleton) : nullptr;
}

PlantRef SkeletonView::find(const Skeleton3D *skeleton) const {
	for (const Shown &entry : shown) {
		if (skeleton && entry.skeleton == uint64_t(skeleton->get_instance_id())) {
			return entry.ref;
		}
	}
	return {};
}

} // namespace undergrowth
