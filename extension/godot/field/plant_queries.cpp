#include "field/plant_queries.hpp"

#include "base/convert.hpp"
#include "base/follow_changes.hpp"
#include "base/messages.hpp"
#include "field/view/plant_transforms.hpp"
#include "plants/plant_frame.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr int FLOATS_PER_STATE = 12; // Direction and rate, and the same of a stem's second mode.
static constexpr int FLOATS_OF_TIP = 6;

// Returns the result of `say` for the plant of an id. Without such a plant it reports an error and returns an empty
// value.
template <class Read> auto PlantQueries::query(int64_t id, const Read &read) const {
	const PlantRef place = runtime.store.find(id);
	if (place.chunk < 0) {
		report_error(node,
				"has no plant " + String::num_int64(id) +
						". Ids are those of get_plant_ids(), until a plant is removed.");
		return decltype(read(std::declval<FoundPlant>()))();
	}
	const PlacedPlant plant = runtime.store.chunk(place.chunk).plants.plant(place.slot);
	return read(FoundPlant{ place, plant, runtime.setup.styles[size_t(plant.species)] });
}

template <class Answers, class One> static Answers each_of(const PackedInt64Array &ids, const One &one) {
	Answers answers;
	for (const int64_t id : ids) {
		answers.push_back(one(id));
	}
	return answers;
}

static PackedInt64Array packed(const std::vector<PlantId> &ids) {
	PackedInt64Array made;
	made.resize(int64_t(ids.size()));
	std::copy(ids.begin(), ids.end(), made.ptrw());
	return made;
}

bool PlantQueries::has(int64_t id) const {
	return runtime.store.find(id).chunk >= 0;
}

PackedInt64Array PlantQueries::ids() const {
	return packed(runtime.store.ids());
}

Transform3D PlantQueries::transform(int64_t id) const {
	return query(id, [](const FoundPlant &one) { return drawn_transform(one.plant); });
}

TypedArray<Transform3D> PlantQueries::transforms(const PackedInt64Array &ids) const {
	return each_of<TypedArray<Transform3D>>(ids, [this](int64_t id) { return transform(id); });
}

Ref<PlantFunction> PlantQueries::species(int64_t id) const {
	return query(id, [](const FoundPlant &one) { return one.style.function; });
}

double PlantQueries::height(int64_t id) const {
	return query(id, [this](const FoundPlant &one) {
		const float share = runtime.own_edits.share_of(runtime.store, one.place);
		return double(one.style.length_of(one.plant) * share * axes_of(node).basis.get_column(1).length());
	});
}

PackedFloat32Array PlantQueries::heights(const PackedInt64Array &ids) const {
	return each_of<PackedFloat32Array>(ids, [this](int64_t id) { return float(height(id)); });
}

int64_t PlantQueries::seed(int64_t id) const {
	return query(id, [](const FoundPlant &one) { return one.style.variant_of(one.plant).seed; });
}

Skeleton3D *PlantQueries::skeleton(int64_t id) const {
	return query(id, [this](const FoundPlant &one) { return runtime.skeletons.find(one.place); });
}

Vector3 PlantQueries::tip_position(int64_t id) {
	return query(id, [this](const FoundPlant &one) { return to_godot(runtime.motion.blocking_read_tip(one.place)); });
}

PackedVector3Array PlantQueries::tip_positions(const PackedInt64Array &ids) {
	return each_of<PackedVector3Array>(ids, [this](int64_t id) { return tip_position(id); });
}

PackedFloat32Array PlantQueries::motion_state(const PackedInt64Array &ids) {
	PackedFloat32Array found;
	for (const int64_t id : ids) {
		const MotionState state =
				query(id, [this](const FoundPlant &one) { return runtime.motion.blocking_read_state(one.place); });
		for (const glm::vec3 &part : { state.tip.direction, state.tip.rate, state.second.bend, state.second.rate }) {
			found.push_back(part.x);
			found.push_back(part.y);
			found.push_back(part.z);
		}
	}
	return found;
}

void PlantQueries::set_motion_state(const PackedInt64Array &ids, const PackedFloat32Array &state) {
	const bool is_whole = state.size() == ids.size() * FLOATS_PER_STATE;
	if (!is_whole && state.size() != ids.size() * FLOATS_OF_TIP) {
		report_error(node,
				"set_motion_state() needs twelve numbers for each id, as returned by get_motion_state(), or the first "
				"six of them.");
		return;
	}
	const float *from = state.ptr();
	for (int64_t i = 0; i < ids.size(); i++, from += is_whole ? FLOATS_PER_STATE : FLOATS_OF_TIP) {
		MotionState given = { { { from[0], from[1], from[2] }, { from[3], from[4], from[5] } }, {} };
		if (is_whole) {
			given.second = { { from[6], from[7], from[8] }, { from[9], from[10], from[11] } };
		}
		query(ids[i], [&](const FoundPlant &one) { runtime.motion.write_state(one.place, given); });
	}
}

bool PlantQueries::is_point_in(const Vector3 &point, double margin) {
	if (!point.is_finite() || !node->is_inside_tree()) {
		return false;
	}
	return runtime.motion.blocking_is_point_in_plants(
			to_glm(axes_of(node).affine_inverse().xform(point)), float(margin));
}

PackedInt64Array PlantQueries::add(const Variant &transforms, const Ref<PlantFunction> &function) {
	std::vector<Transform3D> places;
	if (!read_transforms(transforms, places)) {
		report_error(
				node, "add_plants() needs an Array of Transform3D, or a PackedFloat32Array with 12 numbers for each.");
		return PackedInt64Array();
	}
	if (function.is_null()) {
		report_error(node, "add_plants() needs a species. Pass a PlantFunction.");
		return PackedInt64Array();
	}
	if (double(runtime.store.plant_count()) + double(places.size()) > PlacementRequest::MAX_PLANTS) {
		report_error(node, "cannot have more than 4,000,000 plants; none of these was added. Use another field.");
		return PackedInt64Array();
	}
	const int species_index = runtime.species_for(function);
	if (species_index < 0) {
		return PackedInt64Array();
	}
	// Also for a listed species: it may leave the list while these plants stay.
	follow_changes(function.ptr(), Callable(node, "_on_added_species_changed"));
	const int variants = int(runtime.setup.styles[size_t(species_index)].variants.size());
	std::vector<PlacedPlant> placed;
	for (const Transform3D &place : places) {
		PlacedPlant plant = place_transform(place);
		plant.species = species_index;
		plant.variant = (runtime.store.plant_count() + int(placed.size())) % variants;
		if (is_valid(plant)) {
			placed.push_back(plant);
		}
	}
	if (placed.size() < places.size()) {
		report_error(node,
				String::num_int64(int64_t(places.size() - placed.size())) +
						" transforms of add_plants() were skipped: they are not finite, or their scale is below 1e-6 "
						"or above 1e6. Correct them and add them again.");
	}
	return packed(runtime.add(std::move(placed)));
}

bool PlantQueries::remove(int64_t id) {
	return runtime.remove(runtime.store.find_all({ id })) > 0;
}

int PlantQueries::remove_all(const PackedInt64Array &ids) {
	return runtime.remove(runtime.store.find_all(std::vector<PlantId>(ids.ptr(), ids.ptr() + ids.size())));
}

} // namespace undergrowth
