#include "field/plant_queries.hpp"

#include "base/auto_name.hpp"
#include "base/convert.hpp"
#include "base/follow_changes.hpp"
#include "base/messages.hpp"
#include "field/view/plant_transforms.hpp"
#include "placement/edit_finder.hpp"
#include "plants/plant_frame.hpp"

#include <godot_cpp/classes/resource_loader.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr int FLOATS_PER_STATE = 12; // Direction and rate, and the same of a stem's second mode.
static constexpr int FLOATS_OF_TIP = 6;
static constexpr float SAME_SHARE = 1e-4f; // Of a plant's full height.

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

int PlantQueries::set_height_in_sphere(const Vector3 &center, double radius, double height) {
	if (!std::isfinite(height) || height < 0.0) {
		report_error(node, "set_height_in_sphere() needs a height of 0 m or more.");
		return 0;
	}
	const std::optional<Sphere> sphere = sphere_of("set_height_in_sphere", center, radius);
	if (!sphere) {
		return 0;
	}
	const float own_height = float(height) / axes_of(node).basis.get_column(1).length();
	const auto mow = [this, one = *sphere, own_height] { return mow_in(one, own_height); };
	const glm::vec2 middle = { sphere->center.x, sphere->center.z };
	runtime.repeat_in_first_build({ middle - sphere->radius, middle + sphere->radius }, [mow] { mow(); });
	return mow();
}

int PlantQueries::mow_in(const Sphere &sphere, float height) {
	std::vector<PlantRef> places;
	find_in(sphere, places);
	std::vector<PlantRef> mown;
	std::vector<float> shares;
	for (const PlantRef &place : places) {
		const PlacedPlant plant = runtime.store.chunk(place.chunk).plants.plant(place.slot);
		const float whole = runtime.setup.styles[size_t(plant.species)].length_of(plant);
		const float share = std::clamp(height / whole, EditLog::MIN_SHARE, 1.0f);
		if (std::abs(share - runtime.own_edits.share_of(runtime.store, place)) > SAME_SHARE) {
			mown.push_back(place);
			shares.push_back(share);
		}
	}
	runtime.mow(std::move(mown), shares);
	return int(shares.size());
}

// The name that identifies its species in saved edits: that of the map for listed species, else the file's path.
String PlantQueries::name_of_style(int style) const {
	const Ref<PlantFunction> function = runtime.setup.styles[size_t(style)].function;
	const Ref<PlantFieldSpecies> listed = runtime.listed_entry(function);
	if (listed.is_valid()) {
		return listed->get_layer_name();
	}
	const String path = function->get_path();
	return path.begins_with("res://") && !path.contains("::") ? path : name_of_species(function);
}

Ref<PlantFunction> PlantQueries::species_named(const String &name) const {
	const Ref<PlantFunction> listed = runtime.listed_species(name);
	if (listed.is_valid()) {
		return listed;
	}
	for (size_t style = 0; style < runtime.setup.styles.size(); style++) {
		if (name_of_style(int(style)) == name) {
			return runtime.setup.styles[style].function;
		}
	}
	ResourceLoader *loader = ResourceLoader::get_singleton();
	return name.begins_with("res://") && loader->exists(name) ? loader->load(name) : Ref<Resource>();
}

bool PlantQueries::find_species(const SavedEdits &saved, std::vector<Ref<PlantFunction>> &found) const {
	for (const std::string &name : saved.species) {
		found.push_back(species_named(String::utf8(name.c_str())));
		if (found.back().is_null()) {
			report_error(node,
					"apply_changes(): plants of '" + String::utf8(name.c_str()) +
							"' were added, but the field has no species of that name. Add it to the field's species, "
							"or restore its name. Nothing was changed.");
			return false;
		}
	}
	return true;
}

// Sorted by id, so that the same plants give the same bytes.
static std::vector<AddedPlant> added_plants(const PlantStore &store) {
	std::vector<AddedPlant> added;
	for (int number = 0; number < store.chunk_count(); number++) {
		const PlantChunk &chunk = store.chunk(number);
		for (int slot = 0; chunk.is_added && slot < chunk.size(); slot++) {
			if (!chunk.is_gone(slot)) {
				added.push_back({ chunk.ids[size_t(slot)], chunk.plants.plant(slot) });
			}
		}
	}
	std::sort(added.begin(), added.end(), [](const AddedPlant &a, const AddedPlant &b) { return a.id < b.id; });
	return added;
}

PackedByteArray PlantQueries::changes() const {
	SavedEdits saved;
	saved.edits = runtime.own_edits.known();
	saved.seed = runtime.seed();
	saved.added = added_plants(runtime.store);
	saved.trodden = runtime.trampling.all(runtime.store, runtime.setup, runtime.motion);
	std::vector<int> numbers(runtime.setup.styles.size(), -1);
	for (AddedPlant &one : saved.added) {
		int &species = numbers[size_t(one.plant.species)];
		if (species < 0) {
			species = int(saved.species.size());
			saved.species.push_back(name_of_style(one.plant.species).utf8().get_data());
		}
		one.plant.species = species;
	}
	const std::vector<uint8_t> bytes = write_edits(saved);
	PackedByteArray made;
	made.resize(int64_t(bytes.size()));
	std::copy(bytes.begin(), bytes.end(), made.ptrw());
	return made;
}

bool PlantQueries::has_changes() const {
	return !runtime.own_edits.known().is_empty() || !added_plants(runtime.store).empty();
}

// Restores added plants.
void PlantQueries::bring_back(const SavedEdits &saved, const std::vector<Ref<PlantFunction>> &species) {
	std::vector<PlantRef> others;
	for (int number = 0; number < runtime.store.chunk_count(); number++) {
		for (int slot = 0; runtime.store.chunk(number).is_added && slot < runtime.store.chunk(number).size(); slot++) {
			others.push_back({ number, slot });
		}
	}
	runtime.remove(std::move(others));
	std::vector<int> styles;
	for (const Ref<PlantFunction> &function : species) {
		styles.push_back(runtime.species_for(function));
		follow_changes(function.ptr(), Callable(node, "_on_added_species_changed"));
	}
	std::vector<PlacedPlant> plants;
	std::vector<PlantId> ids;
	for (const AddedPlant &one : saved.added) {
		const int style = styles[size_t(one.plant.species)];
		if (style >= 0) { // Else species_for() has reported the error.
			plants.push_back(one.plant);
			plants.back().species = style;
			ids.push_back(one.id);
		}
	}
	runtime.add(std::move(plants), std::move(ids));
}

bool PlantQueries::apply_changes(const PackedByteArray &bytes) {
	SavedEdits saved;
	const BytesFault fault = read_edits(bytes.ptr(), size_t(bytes.size()), saved);
	if (fault != BytesFault::none) {
		report_error(node, String("apply_changes(): ") + describe_edits_fault(fault) + " Nothing was changed.");
		return false;
	}
	std::vector<Ref<PlantFunction>> species;
	if (!find_species(saved, species)) {
		return false;
	}
	if (saved.seed.value_or(runtime.seed()) != runtime.seed() && !saved.edits.of_generated().empty()) {
		report_warning(node,
				"apply_changes(): these edits were recorded with seed " + String::num_int64(*saved.seed) +
						", but the field has seed " + String::num_int64(runtime.seed()) +
						". They are applied by position to other plants. Set the recorded seed, or apply edits of this "
						"field.");
	}
	runtime.forget_repeated_edits();
	bring_back(saved, species);
	const EditLog before = runtime.own_edits.known();
	runtime.own_edits.replace(std::move(saved.edits), runtime.store, runtime.setup, runtime.motion);
	const EditLog &now = runtime.own_edits.known();
	std::vector<PlantRef> gone;
	EditFinder finder(now);
	for (int number = 0; number < runtime.store.chunk_count(); number++) {
		const PlantChunk &chunk = runtime.store.chunk(number);
		for (int slot = 0; !chunk.is_added && !now.of_generated().empty() && slot < chunk.size(); slot++) {
			if (!chunk.is_gone(slot) && finder.is_gone(chunk.plants.x[size_t(slot)], chunk.plants.z[size_t(slot)])) {
				gone.push_back({ number, slot });
			}
		}
	}
	runtime.remove(std::move(gone));
	runtime.trampling.replace(saved.trodden, runtime.store, runtime.setup, runtime.motion);
	runtime.grow_again(before.gone_beside(now));
	runtime.show_soon();
	return true;
}

static bool is_radius(double radius) {
	return std::isfinite(radius) && radius >= 0.0;
}

PackedInt64Array PlantQueries::ids_of(const std::vector<PlantRef> &places) const {
	PackedInt64Array ids;
	ids.resize(int64_t(places.size()));
	int64_t *to = ids.ptrw();
	for (const PlantRef &place : places) {
		*to++ = runtime.store.id(place);
	}
	return ids;
}

static Vector3 root_in_world(const PlantStore &store, const Transform3D &placed, const PlantRef &place) {
	return placed.xform(to_godot(store.chunk(place.chunk).root(place.slot)));
}

// Removes plants from the list if `is_beside` returns true for their root in the world.
template <class IsBeside>
static void remove_beside(
		const PlantStore &store, const Transform3D &placed, std::vector<PlantRef> &found, const IsBeside &is_beside) {
	const auto goes = [&](const PlantRef &place) { return is_beside(root_in_world(store, placed, place)); };
	found.erase(std::remove_if(found.begin(), found.end(), goes), found.end());
}

// Converts metres of the world to the field's axes.
static float reach_in(const Transform3D &to_field, double radius) {
	return float(radius) * to_field.basis.get_column(1).length();
}

std::optional<PlantQueries::Sphere> PlantQueries::sphere_of(
		const char *method, const Vector3 &center, double radius) const {
	if (!center.is_finite() || !is_radius(radius)) {
		report_error(node, String(method) + "() needs a finite centre and a radius of 0 or more.");
		return std::nullopt;
	}
	if (!node->is_inside_tree()) {
		return std::nullopt;
	}
	const Transform3D placed = axes_of(node);
	const Vector3 scale = placed.basis.get_scale().abs();
	const float smallest = std::min({ scale.x, scale.y, scale.z });
	const bool is_even = scale.is_equal_approx(Vector3(smallest, smallest, smallest));
	return Sphere{ to_glm(placed.affine_inverse().xform(center)), float(radius) / smallest, center, float(radius),
		placed, is_even };
}

void PlantQueries::find_in(const Sphere &sphere, std::vector<PlantRef> &found) const {
	runtime.store.find_in_sphere(sphere.center, sphere.radius, found);
	if (!sphere.is_even) { // In the field's axes the sphere is an ellipsoid.
		remove_beside(runtime.store, sphere.placed, found,
				[&](const Vector3 &root) { return root.distance_to(sphere.world_center) > sphere.world_radius; });
	}
}

std::vector<PlantRef> PlantQueries::in_sphere(const char *method, const Vector3 &center, double radius) const {
	std::vector<PlantRef> found;
	if (const std::optional<Sphere> sphere = sphere_of(method, center, radius)) {
		find_in(*sphere, found);
	}
	return found;
}

int PlantQueries::remove_found(const AreaBox &box, const Find &find) {
	const auto remove = [this, find] {
		std::vector<PlantRef> found;
		find(found);
		return runtime.remove(std::move(found));
	};
	runtime.repeat_in_first_build(box, [remove] { remove(); });
	return remove();
}

PackedInt64Array PlantQueries::find_in_sphere(const Vector3 &center, double radius) const {
	return ids_of(in_sphere("find_plants_in_sphere", center, radius));
}

// The bounding box, in the field's axes, of a box of the world.
static AABB box_in_field(const Transform3D &placed, const AABB &box) {
	const Transform3D to_field = placed.affine_inverse();
	AABB around(to_field.xform(box.position), Vector3());
	for (int i = 1; i < 8; i++) {
		around.expand_to(to_field.xform(box.position + box.size * Vector3(i & 1, i >> 1 & 1, i >> 2)));
	}
	return around;
}

static void find_in_world_box(
		const PlantStore &store, const Transform3D &placed, const AABB &box, std::vector<PlantRef> &found) {
	const AABB around = box_in_field(placed, box);
	store.find_in_box(to_glm(around.position), to_glm(around.get_end()), found);
	// In a rotated field the bounding box is larger.
	remove_beside(store, placed, found, [&](const Vector3 &root) { return !box.has_point(root); });
}

// The same in a box.
std::vector<PlantRef> PlantQueries::in_box(const char *method, const AABB &box) const {
	std::vector<PlantRef> found;
	if (!box.is_finite()) {
		report_error(node, String(method) + "() needs a finite box.");
	}
	if (!box.is_finite() || !node->is_inside_tree()) {
		return found;
	}
	find_in_world_box(runtime.store, axes_of(node), box, found);
	return found;
}

PackedInt64Array PlantQueries::find_in_box(const AABB &box) const {
	return ids_of(in_box("find_plants_in_box", box));
}

int64_t PlantQueries::find_nearest(const Vector3 &point, double max_distance) const {
	if (!point.is_finite() || !(max_distance >= 0.0)) {
		report_error(node, "find_nearest_plant() needs a finite point and a distance of 0 or more.");
		return NO_PLANT;
	}
	if (!node->is_inside_tree()) {
		return NO_PLANT;
	}
	const Transform3D to_field = axes_of(node).affine_inverse();
	const PlantRef found = runtime.store.find_nearest(to_glm(to_field.xform(point)), reach_in(to_field, max_distance));
	return found.chunk < 0 ? NO_PLANT : runtime.store.id(found);
}

Ref<PlantFunction> PlantQueries::species_at(const Vector3 &point, double max_distance) const {
	const int64_t nearest = find_nearest(point, max_distance);
	return nearest == NO_PLANT ? Ref<PlantFunction>() : species(nearest);
}

int PlantQueries::remove_in_sphere(const Vector3 &center, double radius) {
	const std::optional<Sphere> sphere = sphere_of("remove_in_sphere", center, radius);
	if (!sphere) {
		return 0;
	}
	const glm::vec2 middle = { sphere->center.x, sphere->center.z };
	return remove_found({ middle - sphere->radius, middle + sphere->radius },
			[this, one = *sphere](std::vector<PlantRef> &found) { find_in(one, found); });
}

int PlantQueries::remove_in_box(const AABB &box) {
	if (!box.is_finite() || !node->is_inside_tree()) {
		return int(in_box("remove_in_box", box).size());
	}
	const Transform3D placed = axes_of(node);
	const AABB around = box_in_field(placed, box);
	const Vector3 end = around.get_end();
	return remove_found({ { around.position.x, around.position.z }, { end.x, end.z } },
			[this, placed, box](
					std::vector<PlantRef> &found) { find_in_world_box(runtime.store, placed, box, found); });
}

int PlantQueries::remove_in_polygon(const PackedVector3Array &points) {
	if (!node->is_inside_tree()) {
		return 0;
	}
	const Transform3D to_field = axes_of(node).affine_inverse();
	Polygon polygon;
	for (const Vector3 &point : points) {
		const Vector3 place = to_field.xform(point);
		polygon.push_back({ place.x, place.z });
	}
	const AreaFault fault = find_area_fault(polygon);
	if (fault != AreaFault::none) {
		report_error(node, String("remove_in_polygon(): ") + undergrowth::describe(fault));
		return 0;
	}
	return remove_found(bounding_box(polygon),
			[this, polygon](std::vector<PlantRef> &found) { runtime.store.find_in_polygon(polygon, found); });
}

int PlantQueries::remove_along(const PackedVector3Array &points, double width) {
	const Vector3 *all = points.ptr();
	const bool are_finite =
			std::all_of(all, all + points.size(), [](const Vector3 &point) { return point.is_finite(); });
	if (points.is_empty() || !are_finite || !is_radius(width)) {
		report_error(node, "remove_along() needs at least one point, finite points, and a width of 0 or more.");
		return 0;
	}
	if (!node->is_inside_tree()) {
		return 0;
	}
	const Transform3D to_field = axes_of(node).affine_inverse();
	const float reach = reach_in(to_field, 0.5 * width);
	Polygon line;
	for (int64_t i = 0; i < points.size(); i++) {
		const Vector3 point = to_field.xform(points[i]);
		line.push_back({ point.x, point.z });
	}
	const AreaBox box = bounding_box(line);
	return remove_found({ box.low - reach, box.high + reach }, [this, line, reach](std::vector<PlantRef> &found) {
		for (size_t i = 0; i < std::max(line.size() - 1, size_t(1)); i++) {
			runtime.store.find_along(line[i], line[std::min(i + 1, line.size() - 1)], reach, found);
		}
		std::sort(found.begin(), found.end()); // A plant near two of the lines is found twice.
		found.erase(std::unique(found.begin(), found.end()), found.end());
	});
}

int PlantQueries::apply_impulse_in_sphere(const Vector3 &center, double radius, const Vector3 &impulse) {
	if (!impulse.is_finite()) {
		report_error(node, "apply_impulse_in_sphere() needs a finite impulse.");
		return 0;
	}
	const std::vector<PlantRef> places = in_sphere("apply_impulse_in_sphere", center, radius);
	const glm::vec3 local_impulse = places.empty() ? glm::vec3() : to_glm(axes_of(node).basis.inverse().xform(impulse));
	for (const PlantRef &place : places) {
		runtime.motion.apply_impulse(place, local_impulse);
	}
	return int(places.size());
}

// Along the ground, away from the centre. A plant at the centre does not move.
int PlantQueries::apply_blast(const Vector3 &center, double radius, double impulse) {
	if (!std::isfinite(impulse) || radius <= 0.0) {
		report_error(node, "apply_blast() needs a radius above 0 and a finite impulse.");
		return 0;
	}
	const std::vector<PlantRef> places = in_sphere("apply_blast", center, radius);
	const Transform3D placed = places.empty() ? Transform3D() : axes_of(node);
	const Basis to_field = placed.basis.inverse();
	for (const PlantRef &place : places) {
		const Vector3 way = root_in_world(runtime.store, placed, place) - center;
		const Vector3 aside = Vector3(way.x, 0.0f, way.z).normalized();
		const double share = 1.0 - double(way.length()) / radius;
		runtime.motion.apply_impulse(place, to_glm(to_field.xform(aside * float(impulse * share))));
	}
	return int(places.size());
}

// A plant at the centre falls along the x axis.
int PlantQueries::trample_in_sphere(const Vector3 &center, double radius, double angle) {
	static constexpr double MAX_ANGLE = 0.5 * PI;
	if (!(angle >= 0.0 && angle <= MAX_ANGLE)) {
		report_error(node, "trample_in_sphere() needs an angle from 0 to PI / 2, in radians.");
		return 0;
	}
	const std::vector<PlantRef> places = in_sphere("trample_in_sphere", center, radius);
	const Transform3D placed = places.empty() ? Transform3D() : axes_of(node);
	const Basis to_field = placed.basis.inverse();
	int trodden = 0;
	for (const PlantRef &place : places) {
		const Vector3 way = root_in_world(runtime.store, placed, place) - center;
		const Vector3 level = Vector3(way.x, 0.0f, way.z);
		const Vector3 aside = level.is_zero_approx() ? Vector3(1.0f, 0.0f, 0.0f) : level.normalized();
		const Vector3 tip = aside * float(std::sin(angle)) + Vector3(0.0f, float(std::cos(angle)), 0.0f);
		trodden += runtime.motion.trample(place, to_glm(to_field.xform(tip).normalized())) ? 1 : 0;
	}
	return trodden;
}

} // namespace undergrowth
