// The part of PlantField3D about single plants: adding, removing, pushing and asking.

#include "field/plant_field_3d.hpp"

#include "convert.hpp"

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/performance.hpp>
#include <godot_cpp/classes/viewport.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

using namespace godot;

namespace undergrowth {

static constexpr float LEAST_TILT = 1e-3f;
static constexpr int MOST_ADDED_PATCHES = 8;
static constexpr int FLOATS_PER_TRANSFORM = 12;

// What a transform says about a plant: its place, scale and turn; a tilt becomes a lean to that side.
PlacedPlant PlantField3D::place_transform(const Transform3D &transform, int species_index) const {
	PlacedPlant plant;
	plant.root = to_glm(transform.origin);
	const Vector3 up = transform.basis.get_column(1);
	const Vector3 front = transform.basis.get_column(2);
	plant.scale = up.length();
	const float aside = std::sqrt(up.x * up.x + up.z * up.z);
	if (aside > LEAST_TILT * plant.scale) {
		plant.turn = std::atan2(-up.z, up.x);
		plant.lean = std::atan2(aside, up.y);
	} else {
		plant.turn = std::atan2(front.x, front.z);
	}
	plant.species = species_index;
	return plant;
}

// Index of the look for a function; a new one where none has it yet, -1 where it cannot be built.
int PlantField3D::species_for(const Ref<PlantFunction> &function) {
	for (size_t i = 0; i < style.looks.size(); i++) {
		if (style.looks[i].function == function) {
			return int(i);
		}
	}
	if (style.levels.empty()) {
		start_style(style);
	}
	FieldLook look;
	look.function = function;
	const String fault = look.sample(style.levels, options.variants, options.seed + int64_t(style.looks.size()));
	if (!fault.is_empty()) {
		report_error(this, "cannot add plants of " + undergrowth::describe(function.ptr()) + ": " + fault);
		return -1;
	}
	look.build();
	if (!simulation) {
		FieldSettings settings;
		settings.step = float(clock.step());
		settings.update_interval = options.update_interval;
		settings.prototypes = options.prototypes;
		settings.write_followers = false;
		settings.seed = uint64_t(options.seed);
		simulation = std::make_unique<FieldSimulation>(settings);
	}
	simulation->add_species(look.motion);
	style.looks.push_back(std::move(look));
	return int(style.looks.size()) - 1;
}

static bool read_transforms(const Variant &from, std::vector<Transform3D> &to) {
	if (from.get_type() == Variant::PACKED_FLOAT32_ARRAY) {
		const PackedFloat32Array rows = from;
		const float *f = rows.ptr();
		for (int64_t i = 0; i + FLOATS_PER_TRANSFORM <= rows.size();
				i += FLOATS_PER_TRANSFORM, f += FLOATS_PER_TRANSFORM) {
			to.push_back(
					Transform3D(Basis(Vector3(f[0], f[4], f[8]), Vector3(f[1], f[5], f[9]), Vector3(f[2], f[6], f[10])),
							Vector3(f[3], f[7], f[11])));
		}
		return rows.size() % FLOATS_PER_TRANSFORM == 0;
	}
	if (from.get_type() != Variant::ARRAY) {
		return false;
	}
	const Array list = from;
	for (int64_t i = 0; i < list.size(); i++) {
		if (list[i].get_type() != Variant::TRANSFORM3D) {
			return false;
		}
		to.push_back(list[i]);
	}
	return true;
}

void PlantField3D::add_plants(const Variant &transforms, const Ref<PlantFunction> &function) {
	std::vector<Transform3D> places;
	if (!read_transforms(transforms, places)) {
		report_error(
				this, "add_plants() needs an Array of Transform3D, or a PackedFloat32Array with 12 numbers for each.");
		return;
	}
	if (function.is_null()) {
		report_error(this, "add_plants() needs a PlantFunction: which species?");
		return;
	}
	finish_step();
	const int species_index = species_for(function);
	if (species_index < 0) {
		return;
	}
	if (double(get_plant_count()) + double(places.size()) > PlacementRequest::MOST_PLANTS) {
		report_error(this, "cannot hold more than 4,000,000 plants; none of these is added. Use another field.");
		return;
	}
	std::vector<PlacedPlant> placed;
	for (const Transform3D &place : places) {
		PlacedPlant plant = place_transform(place, species_index);
		plant.variant = (count_pending() + int(placed.size())) % options.variants;
		if (is_valid(plant)) {
			placed.push_back(plant);
		}
	}
	if (placed.size() < places.size()) {
		report_error(this,
				String::num_int64(int64_t(places.size() - placed.size())) +
						" transforms of add_plants() are not finite or of no size; the others are added.");
	}
	add_pending(function, std::move(placed));
	update_processing();
}

void PlantField3D::add_pending(const Ref<PlantFunction> &function, std::vector<PlacedPlant> &&plants) {
	if (plants.empty()) {
		return;
	}
	if (pending.empty() || pending.back().function != function) {
		pending.push_back({ function, std::move(plants) });
	} else {
		pending.back().plants.insert(pending.back().plants.end(), plants.begin(), plants.end());
	}
}

int PlantField3D::count_pending() const {
	int count = 0;
	for (const Pending &group : pending) {
		count += int(group.plants.size());
	}
	return count;
}

// A page of the species that has room, or -1.
static int find_open_page(const FieldSimulation &simulation, int species) {
	for (int page = simulation.page_count() - 1; page >= 0; page--) {
		const FieldPage &plants = simulation.page(page);
		if (plants.species() == species && plants.size() < FieldPage::PAGE_PLANTS) {
			return page;
		}
	}
	return -1;
}

// Puts some plants of a patch, all of one species, into the page of their species that has room, and into new ones.
void PlantField3D::take_into_pages(FieldPatch &patch, int species_index, const std::vector<int> &members) {
	size_t done = 0;
	while (done < members.size()) {
		int page = find_open_page(*simulation, species_index);
		const int before = page >= 0 ? simulation->page(page).size() : 0;
		const size_t count = std::min(members.size() - done, size_t(FieldPage::PAGE_PLANTS - before));
		std::vector<FieldPlant> simulated;
		for (size_t i = done; i < done + count; i++) {
			simulated.push_back(style.looks[size_t(species_index)].to_simulate(patch.plants.plant(members[i])));
		}
		if (page >= 0) {
			simulation->add_to_page(page, simulated.data(), int(count));
		} else {
			page = simulation->add_page(species_index, simulated.data(), int(count));
		}
		for (size_t i = 0; i < count; i++) {
			const uint32_t index = uint32_t(before) + uint32_t(i);
			patch.places[size_t(members[done + i])] = uint32_t(page) * FieldPage::PAGE_PLANTS + index;
		}
		done += count;
	}
}

// Many small patches become one, so that planting here and there does not end in thousands of multimeshes.
void PlantField3D::merge_added() {
	if (int(patches.size()) - filled_patches <= MOST_ADDED_PATCHES) {
		return;
	}
	FieldPlants all;
	std::vector<std::pair<float, uint32_t>> unsorted;
	for (size_t i = size_t(filled_patches); i < patches.size(); i++) {
		const FieldPatch &patch = *patches[i];
		for (int plant = 0; plant < patch.plants.size(); plant++) {
			if (patch.places[size_t(plant)] != FieldPatch::GONE) {
				all.add(patch.plants.plant(plant));
				unsorted.push_back({ all.x.back(), patch.places[size_t(plant)] });
			}
		}
	}
	patches.resize(size_t(filled_patches));
	drawings.resize(size_t(filled_patches));
	const std::vector<float> reach = reaches(style);
	auto merged = std::make_unique<FieldPatch>();
	merged->plants = std::move(all);
	// The order of sorting is not told: a plant is found again by where its page says that it stands.
	merged->chunks = sort_into_chunks(merged->plants, float(options.chunk_size), reach.data(), int(reach.size()));
	std::map<std::tuple<float, float, float, int>, std::vector<uint32_t>> by_root;
	for (const auto &[x, place] : unsorted) {
		const FieldPage &page = simulation->page(int(place / FieldPage::PAGE_PLANTS));
		const glm::vec3 root = page.root(int(place % FieldPage::PAGE_PLANTS));
		by_root[{ root.x, root.y, root.z, page.species() }].push_back(place);
	}
	for (int plant = 0; plant < merged->plants.size(); plant++) {
		const PlacedPlant placed = merged->plants.plant(plant);
		std::vector<uint32_t> &there = by_root[{ placed.root.x, placed.root.y, placed.root.z, placed.species }];
		merged->places.push_back(there.back());
		there.pop_back();
	}
	drawings.push_back(std::make_unique<FieldDrawing>());
	restart_drawing(*drawings.back());
	drawings.back()->show(style, FieldDrawing::plan(style, *merged, *simulation));
	patches.push_back(std::move(merged));
}

// Plants that were added since the last frame become a patch of their own.
void PlantField3D::flush_pending() {
	if (pending.empty() || !is_inside_tree()) {
		return;
	}
	finish_step();
	auto patch = std::make_unique<FieldPatch>();
	for (const Pending &group : pending) {
		const int species_index = species_for(group.function);
		for (PlacedPlant plant : group.plants) {
			plant.species = species_index;
			plant.variant %= options.variants;
			patch->plants.add(plant);
		}
	}
	pending.clear();
	const std::vector<float> reach = reaches(style);
	patch->chunks = sort_into_chunks(patch->plants, float(options.chunk_size), reach.data(), int(reach.size()));
	patch->places.assign(size_t(patch->plants.size()), FieldPatch::GONE);
	std::vector<std::vector<int>> members(style.looks.size());
	for (int plant = 0; plant < patch->plants.size(); plant++) {
		members[patch->plants.species[size_t(plant)]].push_back(plant);
	}
	for (int kind = 0; kind < int(members.size()); kind++) {
		take_into_pages(*patch, kind, members[size_t(kind)]);
	}
	show_bends();
	drawings.push_back(std::make_unique<FieldDrawing>());
	restart_drawing(*drawings.back());
	drawings.back()->show(style, FieldDrawing::plan(style, *patch, *simulation));
	patches.push_back(std::move(patch));
	merge_added();
	if (options.contact) {
		touching.fit(*simulation);
	}
	upload();
	update_processing();
}

// After pages came or grew: into the textures that there are, or larger ones.
void PlantField3D::show_bends() {
	if (simulation->settings().prototypes > 0 && simulation->time() == 0.0) {
		simulation->step(); // It fills the prototypes' history.
	}
	if (!bends || !bends->has_room(*simulation)) {
		bends = std::make_unique<FieldBends>();
		bends->make_images(*simulation);
		bends->make_textures();
	} else {
		for (int page = 0; page < simulation->page_count() && simulation->settings().prototypes == 0; page++) {
			bends->write_page(*simulation, page);
		}
	}
	dress();
}

void PlantField3D::redraw(int patch, const std::vector<ClumpPlace> &places) {
	for (const ClumpPlace &place : places) {
		drawings[size_t(patch)]->replace(
				style, place, FieldDrawing::plan_one(style, *patches[size_t(patch)], *simulation, place));
	}
}

int PlantField3D::remove_in_sphere(const Vector3 &center, double radius) {
	if (!center.is_finite() || !std::isfinite(radius) || radius < 0.0) {
		report_error(this, "remove_in_sphere() needs a finite centre and a radius of 0 or more.");
		return 0;
	}
	if (!is_inside_tree() || !simulation) {
		return 0;
	}
	finish_step();
	flush_pending();
	const Transform3D to_field = get_global_transform().affine_inverse();
	const glm::vec3 middle = to_glm(to_field.xform(center));
	const float reach = float(radius) * to_field.basis.get_column(1).length();
	// Where the last plant of each page is, which takes the place of one that goes.
	std::vector<std::vector<std::pair<int, int>>> members(size_t(simulation->page_count()));
	int removed = 0;
	std::vector<std::set<ClumpPlace>> dirty(patches.size());
	const auto mark = [&](int patch, int plant) {
		const FieldPlants &plants = patches[size_t(patch)]->plants;
		const float size = patches[size_t(patch)]->chunks.size;
		const int column = int(std::floor(plants.x[size_t(plant)] / size));
		const int row = int(std::floor(plants.z[size_t(plant)] / size));
		for (int level = 0; level < int(style.levels.size()); level++) {
			dirty[size_t(patch)].insert(FieldDrawing::place_of(style, level, column, row));
		}
	};
	std::vector<std::vector<int>> found;
	std::vector<bool> is_affected(size_t(simulation->page_count()), false);
	for (const std::unique_ptr<FieldPatch> &patch : patches) {
		found.push_back(find_in_sphere(patch->plants, patch->chunks, middle, reach));
		for (const int plant : found.back()) {
			if (patch->places[size_t(plant)] != FieldPatch::GONE) {
				is_affected[size_t(patch->page(plant))] = true;
			}
		}
	}
	for (int p = 0; p < int(patches.size()); p++) {
		const FieldPatch &patch = *patches[size_t(p)];
		for (int plant = 0; plant < patch.plants.size(); plant++) {
			if (patch.places[size_t(plant)] == FieldPatch::GONE || !is_affected[size_t(patch.page(plant))]) {
				continue;
			}
			auto &page = members[size_t(patch.page(plant))];
			page.resize(std::max(page.size(), size_t(patch.index(plant)) + 1));
			page[size_t(patch.index(plant))] = { p, plant };
		}
	}
	for (int p = 0; p < int(patches.size()); p++) {
		FieldPatch &patch = *patches[size_t(p)];
		for (const int plant : found[size_t(p)]) {
			if (patch.places[size_t(plant)] == FieldPatch::GONE) {
				continue;
			}
			const int page = patch.page(plant);
			const int index = patch.index(plant);
			auto &members_of_page = members[size_t(page)];
			const auto [last_patch, last_plant] = members_of_page.back();
			simulation->remove(page, index);
			patches[size_t(last_patch)]->places[size_t(last_plant)] = patch.places[size_t(plant)];
			members_of_page[size_t(index)] = members_of_page.back();
			members_of_page.pop_back();
			mark(last_patch, last_plant);
			patch.places[size_t(plant)] = FieldPatch::GONE;
			mark(p, plant);
			removed++;
		}
	}
	for (int page = 0; page < simulation->page_count() && simulation->settings().prototypes == 0; page++) {
		if (is_affected[size_t(page)]) {
			bends->write_page(*simulation, page);
		}
	}
	for (int p = 0; p < int(patches.size()); p++) {
		redraw(p, { dirty[size_t(p)].begin(), dirty[size_t(p)].end() });
	}
	if (removed > 0) {
		upload();
		if (options.contact) {
			touching.fit(*simulation);
		}
	}
	return removed;
}

bool PlantField3D::is_point_in_plants(const Vector3 &point) {
	if (!simulation || !point.is_finite() || !is_inside_tree()) {
		return false;
	}
	finish_step();
	flush_pending();
	return simulation->is_point_in_plants(to_glm(to_local(point)), float(options.touch_margin));
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
	const Transform3D to_field = get_global_transform().affine_inverse();
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
	const PlacedPlant plant = patches[size_t(found.patch)]->plants.plant(found.plant);
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

Dictionary PlantField3D::get_statistics() {
	Dictionary told;
	finish_step();
	PackedInt32Array drawn;
	const Camera3D *camera = is_inside_tree() ? get_viewport()->get_camera_3d() : nullptr;
	const Vector3 eye = camera ? to_local(camera->get_global_position()) : Vector3();
	drawn.resize(int64_t(style.levels.size()));
	drawn.fill(0);
	for (const std::unique_ptr<FieldDrawing> &drawing : drawings) {
		const std::vector<int> counts = drawing->count_drawn(style, eye);
		for (size_t i = 0; i < counts.size(); i++) {
			drawn[int64_t(i)] += counts[i];
		}
	}
	size_t bytes = 0;
	for (const std::unique_ptr<FieldPatch> &patch : patches) {
		bytes += patch->plants.bytes() + patch->places.capacity() * sizeof(uint32_t);
	}
	const int count = get_plant_count();
	told["plants"] = count;
	told["simulated"] = simulation ? simulation->simulated_count() : 0;
	told["drawn_by_level"] = drawn;
	told["step_usec"] = steps.busy_usec();
	told["upload_usec"] = upload_usec;
	told["main_usec"] = main_usec;
	told["wait_usec"] = wait_usec;
	told["bytes_per_plant"] = count > 0 ? double(bytes) / count + simulation->bytes_per_plant() : 0.0;
	return told;
}

} // namespace undergrowth
