// How a field grows: from properties, and from what code adds, to looks and to plants that stand.

#include "field/meadow.hpp"

#include "messages.hpp"
#include "stopwatch.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/world3d.hpp>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace godot;

namespace undergrowth {

void Meadow::fill(bool places) {
	const bool placed_before = is_filling();
	if (is_at_work() && !places && !placed_before) {
		is_due_again = true; // What changes in each frame is seen now and then, and not only when that ends.
		return;
	}
	places = places || (streams() && float(properties.tile_size) != store.tile_size());
	asker.forget();
	job.reset();
	tiles.interrupt(tile_scene());
	patches.interrupt();
	is_due_again = false;
	if (places) {
		removed_meanwhile.clear();
	}
	const String fault = begin_asking(places || placed_before);
	if (fault.is_empty()) {
		go_on_asking();
		return;
	}
	asking.reset();
	listener.fault(fault);
	removed_meanwhile.clear();
}

int Meadow::species_for(const Ref<PlantFunction> &function) {
	for (size_t i = 0; i < style.looks.size(); i++) {
		if (style.looks[i].function == function) {
			return int(i);
		}
	}
	if (style.levels.empty()) {
		style.levels = read_levels(properties, node->get_visibility_range_end());
		style.tile_size = store.tile_size();
		style.spacing = store.spacing();
		list_looks(StandOptions(), {}, style);
	}
	FieldLook look;
	const String fault = read_other_look(function, properties, style, look);
	if (!fault.is_empty()) {
		report_error(node, "cannot add plants of " + fault);
		return -1;
	}
	if (!motion.is_ready()) {
		motion.start(settings());
	}
	motion.add_species(look);
	style.looks.push_back(std::move(look));
	if (motion.pose_texture().is_valid()) {
		dress.put_on(style, motion);
	}
	return int(style.looks.size()) - 1;
}

void Meadow::touch(const AreaBox &box) {
	if (!is_filling() || job) { // What is asked for has not read the map yet.
		patches.touch(box, store.tile_size());
		tiles.interrupt(tile_scene(), box);
		keep_standing_patches();
	}
	if (!is_filling() && (style.levels.empty() || patches.touched_tiles() > FieldPatches::MOST_TILES)) {
		fill(true);
	}
}

void Meadow::grow_again(const std::vector<AreaBox> &boxes) {
	if (is_at_work()) {
		fill(is_filling() || !boxes.empty()); // It does not know of it.
		return;
	}
	tiles.interrupt(tile_scene());
	for (size_t i = 0; i < boxes.size() && patches.touched_tiles() <= FieldPatches::MOST_TILES; i++) {
		patches.touch(boxes[i], store.tile_size());
		keep_standing_patches();
	}
	if (patches.touched_tiles() > FieldPatches::MOST_TILES) {
		fill(true);
	}
}

void Meadow::keep_standing_patches() {
	if (streams()) {
		patches.keep_only([this](const TileKey &tile) { return tiles.stands(tile); });
	}
}

FieldTiles::Scene Meadow::tile_scene() {
	const auto change = [this](StandEdit &&edit, PreparedBlock *prepared) { return apply(std::move(edit), prepared); };
	return { node, properties, store, style, motion, ground, own_changes.known(), settings(), view, change,
		listener.fault };
}

// What is on its way while the field is placed in boxes would be placed twice.
void Meadow::poll_tiles(bool physics) {
	if (!streams() || is_at_work() || !motion.is_ready()) {
		return;
	}
	if (!physics) {
		motion.wait();
	}
	const Stopwatch watch;
	const int before = store.block_count() + tiles.standing_count();
	const bool edits = !patches.current() || patches.current()->is_drawing();
	tiles.go_on(tile_scene(), physics, edits);
	if (before != store.block_count() + tiles.standing_count()) {
		skeletons.release_gone(store);
	}
	tiles_usec = physics ? tiles_usec : watch.usec();
}

void Meadow::begin_patch() {
	PatchRecipe recipe;
	keep_standing_patches();
	recipe.boxes = patches.take_boxes(store, recipe.standing);
	if (recipe.boxes.empty()) {
		patches.draw(style, store, motion);
		return;
	}
	AreaBox around = recipe.boxes.front();
	for (const AreaBox &box : recipe.boxes) {
		around = { glm::min(around.low, box.low), glm::max(around.high, box.high) };
	}
	const bool are_known = style.listed_count == int(properties.species.size());
	const String fault = read_request(node, properties, &around, recipe.request);
	recipe.ground = ground;
	recipe.changes = own_changes.known().cut(around);
	recipe.spacing = store.spacing();
	const double spacing = 1.0 / std::sqrt(double(recipe.request.density));
	if (fault.is_empty() && are_known && spacing == recipe.spacing) { // Else it is filled anew soon.
		patches.start(std::move(recipe));
	}
}

void Meadow::poll_patches(double delta, bool physics) {
	if (is_at_work() || !motion.is_ready() || !patches.is_at_work()) {
		return;
	}
	if (!patches.current() && !physics) {
		begin_patch();
	}
	FieldPatch *patch = patches.current();
	if (patch && patch->wants_ground()) {
		if (asker.serve(*patch, node, properties, GroundAsker::usual_usec(delta), physics, false) ==
				GroundSurvey::State::failed) {
			listener.fault(asker.fault());
			patches.finish();
		}
	} else if (patch && patch->is_placed()) {
		stand_newcomers();
	} else if (patch && patch->is_drawn()) {
		for (const DrawnNewcomers &one : patch->drawn()) {
			if (patches.is_there(one.number)) {
				view.show_newcomers(style, one.block.tile, one.number, one.plans);
			}
		}
		patches.finish();
		refresh();
	}
}

void Meadow::stand_newcomers() {
	StandEdit edit = patches.current()->take_edit();
	patches.finish();
	if (double(store.plant_count()) + double(edit.grown.size()) > PlacementRequest::MOST_PLANTS) {
		listener.fault(undergrowth::describe(PlacementFault::too_many_plants));
		return;
	}
	apply(std::move(edit));
	skeletons.release_gone(store);
	if (!patches.draw(style, store, motion)) {
		refresh();
	}
}

void Meadow::poll(double delta, bool physics) {
	poll_tiles(physics);
	poll_patches(delta, physics);
	if (asking && !physics && asking->frame != Engine::get_singleton()->get_process_frames()) {
		go_on_asking();
	}
	if (job && job->wants_ground()) {
		if (asker.serve(*job, node, properties, GroundAsker::usual_usec(delta), physics, true) ==
				GroundSurvey::State::failed) {
			job.reset();
			listener.fault(asker.fault());
		}
	}
	if (!job) {
		return;
	}
	const bool is_done = job->is_done();
	const float progress = is_done ? 1.0f : job->progress();
	const bool tells = job->places();
	if (is_done) {
		const std::unique_ptr<FieldFill> finished = std::move(job);
		const bool stands = adopt(*finished);
		if (is_due_again || (stands && !update_levels())) {
			fill(false);
		}
		if (!stands) {
			return;
		}
	}
	if (tells && progress != told_progress) {
		told_progress = progress;
		listener.progressed(progress);
	}
	if (tells && is_done) {
		listener.filled();
	}
}

// What only shows when everything is placed.
static String fault_of(const FieldResult &result) {
	if (result.fault != PlacementFault::none) {
		return describe(result.fault);
	}
	if (result.motion->is_too_large()) {
		return "needs more texture layers than graphics cards have. Set a lower density, fewer species where there are "
			   "prototypes, or divide it among several fields.";
	}
	return String();
}

bool Meadow::adopt(FieldFill &finished) {
	FieldResult &result = finished.finish();
	const String fault = fault_of(result);
	if (!fault.is_empty()) {
		listener.fault(fault); // What stood before stays.
		return false;
	}
	motion.wait();
	skeletons.release_all(motion);
	view.clear(); // Before the materials go that it wears.
	tiles.forget_style();
	style = std::move(result.style);
	std::vector<int> other_leans;
	for (size_t i = 0; i < style.looks.size(); i++) {
		const float lean = style.looks[i].motion.lean;
		style.looks[i].in_air = PlantWind::is_air(properties.wind);
		style.looks[i].read_motion(); // It may have changed meanwhile.
		if (style.looks[i].motion.lean != lean) {
			other_leans.push_back(int(i));
		}
		style.looks[i].take_material();
	}
	StandEdit edit;
	edit.fills = true;
	edit.filled = std::move(result.blocks);
	edit.tile_size = finished.tile_size();
	edit.spacing = result.spacing;
	edit.species_numbers = finished.species_numbers();
	const ChangeSet changes = store.apply(std::move(edit));
	motion.adopt(*result.motion, result.kept, changes, store, style);
	motion.set_update_interval(properties.update_interval);
	own_changes.follow_all(store, style, motion);
	for (const int i : other_leans) {
		motion.set_species(i, style.looks[size_t(i)], store, true);
	}
	motion.upload();
	dress.put_on(style, motion);
	view.show(style, result.plans);
	view.show_all_added(style, motion, store);
	unseen.clear();
	patches.forget_unseen();
	if (finished.places()) {
		tiles.stand(finished.tiles(), finished.request());
	}
	remove(store.find_all(std::exchange(removed_meanwhile, {})));
	refresh();
	return true;
}

} // namespace undergrowth
