// The part of PlantField3D about single plants: pushing and asking.

#include "field/plant_field_3d.hpp"

#include "convert.hpp"

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

bool PlantField3D::is_point_in_plants(const Vector3 &point) {
	if (!simulation || !point.is_finite() || !is_inside_tree()) {
		return false;
	}
	finish_step();
	flush_pending();
	return simulation->is_point_in_plants(to_glm(axes().affine_inverse().xform(point)), float(options.touch_margin));
}

int PlantField3D::apply_impulse_in_sphere(const Vector3 &center, double radius, const Vector3 &impulse) {
	if (!center.is_finite() || !impulse.is_finite() || !std::isfinite(radius) || radius < 0.0) {
		report_error(this, "apply_impulse_in_sphere() needs a finite centre, radius and impulse.");
		return 0;
	}
	if (!simulation || !is_inside_tree()) {
		return 0;
	}
	finish_step();
	flush_pending();
	const Transform3D to_field = axes().affine_inverse();
	const glm::vec3 middle = to_glm(to_field.xform(center));
	const glm::vec3 blow = to_glm(to_field.basis.xform(impulse));
	const float reach = float(radius) * to_field.basis.get_column(1).length();
	int count = 0;
	for (const std::unique_ptr<FieldPatch> &patch : patches) {
		for (const int plant : find_in_sphere(patch->plants, patch->chunks, middle, reach)) {
			if (patch->places[size_t(plant)] != FieldPatch::GONE) {
				simulation->apply_impulse(patch->page(plant), patch->index(plant), blow);
				count++;
			}
		}
	}
	return count;
}

int PlantField3D::get_plant_count() const {
	return (simulation ? simulation->plant_count() : 0) + count_pending();
}

PlantField3D::Found PlantField3D::find(int64_t index) const {
	int64_t left = index;
	for (int p = 0; p < int(patches.size()) && left >= 0; p++) {
		const FieldPatch &patch = *patches[size_t(p)];
		const int64_t gone = std::count(patch.places.begin(), patch.places.end(), FieldPatch::GONE);
		const int64_t standing = patch.plants.size() - gone;
		if (left >= standing) {
			left -= standing;
			continue;
		}
		if (gone == 0) {
			return { p, int(left) };
		}
		for (int plant = 0; plant < patch.plants.size(); plant++) {
			if (patch.places[size_t(plant)] != FieldPatch::GONE && left-- == 0) {
				return { p, plant };
			}
		}
	}
	report_error(this,
			"has no plant " + String::num_int64(index) + "; there are " + String::num_int64(get_plant_count()) + ".");
	return {};
}

Transform3D PlantField3D::get_plant_transform(int64_t index) {
	flush_pending();
	const Found found = find(index);
	if (found.patch < 0) {
		return Transform3D();
	}
	return drawn_transform(patches[size_t(found.patch)]->plants.plant(found.plant));
}

// Where its mesh is drawn, before it bends. Field axes.
Transform3D PlantField3D::drawn_transform(const PlacedPlant &plant) {
	const Basis basis =
			Basis(Vector3(0.0f, 1.0f, 0.0f), plant.turn).scaled(Vector3(plant.scale, plant.scale, plant.scale));
	return Transform3D(basis, to_godot(plant.root));
}

Ref<PlantFunction> PlantField3D::get_plant_function(int64_t index) {
	flush_pending();
	const Found found = find(index);
	return found.patch < 0 ? Ref<PlantFunction>()
						   : style.looks[patches[size_t(found.patch)]->plants.species[size_t(found.plant)]].function;
}

double PlantField3D::get_plant_height(int64_t index) {
	flush_pending();
	const Found found = find(index);
	if (found.patch < 0) {
		return 0.0;
	}
	PlacedPlant plant = patches[size_t(found.patch)]->plants.plant(found.plant);
	plant.scale = 1.0f;
	return style.looks[size_t(plant.species)].length_of(plant);
}

int64_t PlantField3D::get_plant_seed(int64_t index) {
	flush_pending();
	const Found found = find(index);
	if (found.patch < 0) {
		return 0;
	}
	const PlacedPlant plant = patches[size_t(found.patch)]->plants.plant(found.plant);
	return style.looks[size_t(plant.species)].variants[size_t(plant.variant)].seed;
}

Vector3 PlantField3D::get_tip_position(int64_t index) {
	finish_step();
	flush_pending();
	const Found found = find(index);
	if (found.patch < 0) {
		return Vector3();
	}
	const FieldPatch &patch = *patches[size_t(found.patch)];
	const PlacedPlant plant = patch.plants.plant(found.plant);
	const TipState state = simulation->state(patch.page(found.plant), patch.index(found.plant));
	return to_godot(plant.root + style.looks[size_t(plant.species)].length_of(plant) * state.direction);
}

Skeleton3D *PlantField3D::get_skeleton(int64_t index) {
	flush_pending();
	const Found found = find(index);
	const FieldSkeletons::Shown *entry = found.patch < 0 ? nullptr : find_shown(found.patch, found.plant);
	return entry ? FieldSkeletons::node(*entry) : nullptr;
}

int64_t PlantField3D::get_skeleton_plant(const Skeleton3D *skeleton) const {
	const auto entry =
			std::find_if(skeletons.shown.begin(), skeletons.shown.end(), [&](const FieldSkeletons::Shown &shown) {
				return skeleton && shown.skeleton == uint64_t(skeleton->get_instance_id());
			});
	if (entry == skeletons.shown.end()) {
		return -1;
	}
	int64_t index = 0;
	for (int p = 0; p <= entry->patch; p++) {
		const std::vector<uint32_t> &places = patches[size_t(p)]->places;
		const auto end = p < entry->patch ? places.end() : places.begin() + entry->plant;
		index += (end - places.begin()) - std::count(places.begin(), end, FieldPatch::GONE);
	}
	return index;
}

TypedArray<Skeleton3D> PlantField3D::get_skeletons() const {
	TypedArray<Skeleton3D> nodes;
	for (const FieldSkeletons::Shown &entry : skeletons.shown) {
		Skeleton3D *skeleton = FieldSkeletons::node(entry);
		if (skeleton) {
			nodes.push_back(skeleton);
		}
	}
	return nodes;
}

} // namespace undergrowth
