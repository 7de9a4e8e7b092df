// Builds of a field: from its properties and the plants that code adds, through looks, to existing plants.

#include "field/meadow.hpp"

#include "frame_budget.hpp"
#include "stopwatch.hpp"

#include <algorithm>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr double FREEING_SHARE = 0.5; // Of the budget of a frame.

void Meadow::fill(bool places, bool looks) {
	if (!node->is_inside_tree()) {
		node->call("rebuild"); // The field is built when it enters the tree: there are no axes and no cameras.
		return;
	}
	const FrameCost::Share share(filling);
	const bool placed_before = is_placing();
	if (places && !looks && renew()) {
		return;
	}
	if (is_at_work() && !places && !placed_before) {
		is_due_again = true; // A property that changes in each frame must not restart the build forever.
		return;
	}
	places = places || needs_other_tiles();
	asker.forget();
	GroundAsker().take_findings(asker);
	has_failed = false;
	built_before = 0.0f;
	drop_job();
	renewal.stop(tile_scene(), motion);
	tiles.interrupt(tile_scene());
	patches.interrupt();
	is_due_again = false;
	if (places) {
		removed_meanwhile.clear();
		tells_of_patches = false; // The build reports its own end.
	}
	const String fault = begin_asking(places || placed_before);
	if (fault.is_empty()) {
		if (FrameBudget::of_fields().is_left()) {
			go_on_asking();
		}
		return;
	}
	fail(fault);
}

void Meadow::fill_again(bool places) {
	const std::vector<PlantId> removed = removed_meanwhile;
	fill(places);
	removed_meanwhile = removed;
}

void Meadow::touch(const AreaBox &box) {
	if (!asking || !asking->places) { // A build that still collects looks reads the map later.
		patches.touch(box, store.tile_size());
		tiles.interrupt(tile_scene(), box);
		renewal.interrupt(tile_scene(), motion, box);
		keep_standing_patches();
	}
	if ((!is_building() && style.levels.empty()) || patches.touched_tiles() > FieldPatches::MOST_TILES) {
		fill(true, false);
	}
}

void Meadow::keep_standing_patches() {
	if (streams()) {
		patches.keep_only([this](const TileKey &tile) { return tiles.stands(tile); });
	}
}

FieldTiles::Scene Meadow::tile_scene() {
	const auto change = [this](StandEdit &&edit, ArrivingBlocks *blocks) { return apply(std::move(edit), blocks); };
	const auto fault = [this](const String &why) { tile_fault = why; };
	FieldSettings built = settings();
	if (motion.is_ready()) { // The last build may have failed: tiles are for the existing simulation.
		built.prototypes = motion.follows_prototypes() ? std::max(built.prototypes, 1) : 0;
	}
	return { node, properties, store, style, motion, ground, own_changes.known(), built, view, change, fault,
		budget_usec() };
}

// During a build of the whole field, tiles would be placed twice.
void Meadow::poll_tiles(bool physics) {
	if (!streams() || is_at_work() || renewal.is_at_work() || !motion.is_ready()) {
		return;
	}
	if (!physics) {
		motion.wait();
	}
	const Stopwatch watch;
	const int before = store.block_count() + tiles.standing_count();
	const bool was_building = tiles.is_building();
	tiles.go_on(tile_scene(), physics, patches.lets_others_edit());
	repeat_edits();
	if (before != store.block_count() + tiles.standing_count()) {
		skeletons.release_gone(store);
	}
	tiles_usec = physics ? tiles_usec : watch.usec();
	if (report_tile_fault(was_building) || !was_building) {
		return;
	}
	if (tiles.is_building()) {
		tell_of(progress());
		return;
	}
	tiles.ground_asker().take_findings(asker);
	tiles.ground_asker().tell_of_all(node);
	listener.no_ground(tiles.ground_asker().missing_ground());
	tell_of(1.0f);
	finish_build();
}

void Meadow::poll_renewal(bool physics) {
	if (!renewal.is_at_work() || is_at_work()) {
		return;
	}
	if (!physics) {
		motion.wait();
	}
	renewal.go_on(tile_scene(), { motion, skeletons, !streams() }, physics);
	repeat_edits();
	report_tile_fault(true);
	if (renewal.is_at_work()) {
		tell_of(progress());
		return;
	}
	renewal.ground_asker().take_findings(asker);
	renewal.ground_asker().tell_of_all(node);
	listener.no_ground(renewal.ground_asker().missing_ground());
	if (!streams()) {
		join_tiles();
	}
	tell_of(progress());
	if (streams()) {
		finish_build();
	}
}

void Meadow::poll_patches(FieldPatches::Moment moment, double delta) {
	if (is_at_work() || is_placing() || !motion.is_ready() || !patches.is_at_work()) {
		return;
	}
	keep_standing_patches();
	if (patches.go_on(tile_scene(), moment, ground_usec(delta))) {
		skeletons.release_gone(store);
		show_soon();
	}
	report_tile_fault(false);
}

void Meadow::follow_strokes(FieldPatches::Moment moment, double delta) {
	const FrameCost::Share share(filling);
	poll_patches(moment, delta);
}

void Meadow::drop_job() {
	motion.forget_hand_over();
	view.forget_prepared();
	joins = false;
	if (job && job->is_dressed) {
		job->cancel();
		retired.push_back(std::move(job->finish().style));
	}
	job.reset();
}

// Prepares the build over some frames, undrawn, and transfers motion. Then the build replaces the old field.
bool Meadow::make_ready() {
	if (job->is_handed_over) {
		return !motion.is_handing_over();
	}
	if (job->fault() != PlacementFault::none) {
		return job->is_done();
	}
	const Stopwatch watch;
	FieldStyle &coming = job->style();
	for (FieldLook &look : coming.looks) {
		if (!look.make_meshes(budget_usec() - watch.usec())) {
			return false;
		}
	}
	if (!std::exchange(job->is_dressed, true)) {
		has_other_materials = false;
		dress.make(coming);
		dress.take_away(coming);
	}
	while (const std::unique_ptr<ClumpPlan> plan = job->take_plan()) {
		view.prepare(coming, *plan);
		if (watch.usec() > budget_usec()) {
			return false;
		}
	}
	if (!job->is_done() || view.reveal_some(budget_usec())) {
		return false;
	}
	FieldResult &result = job->finish();
	if (!result.describe_fault().is_empty()) {
		return true;
	}
	job->is_handed_over = true;
	motion.hand_over(*result.motion, result.kept);
	return !motion.is_handing_over();
}

void Meadow::poll(double delta, bool physics) {
	const FrameCost::Share share(filling);
	is_polling = true;
	poll_parts(delta, physics);
	is_polling = false;
}

void Meadow::poll_parts(double delta, bool physics) {
	if (!physics) {
		view.tell_if_undrawn();
	}
	if (!physics && !view.free_some(FREEING_SHARE * budget_usec())) {
		retired.clear();
		retired_materials.clear();
	}
	poll_tiles(physics);
	poll_renewal(physics);
	poll_patches(physics ? FieldPatches::Moment::physics : FieldPatches::Moment::begun, delta);
	if (asking && !physics && (is_urgent || (asking->is_due() && FrameBudget::of_fields().is_left()))) {
		go_on_asking();
	}
	if (job && job->wants_ground()) {
		serve_ground(delta, physics);
	}
	if (job && (physics || is_urgent || FrameBudget::of_fields().is_left())) {
		poll_job(physics);
	}
	if (tells_of_patches && !is_at_work() && !is_building() && !is_patching()) {
		tells_of_patches = false;
		finish_build();
	}
}

// The first part of a build may have no ground although the rest has some.
void Meadow::serve_ground(double delta, bool physics) {
	const bool is_whole = !job->has_rest();
	const GroundSurvey::State state = asker.serve(*job, node, properties, ground_usec(delta), physics, is_whole);
	if (state == GroundSurvey::State::failed) {
		drop_job();
		fail(asker.fault());
	} else if (state == GroundSurvey::State::done && is_whole) {
		listener.no_ground(asker.missing_ground());
	}
}

void Meadow::poll_job(bool physics) {
	const FrameBudget::Share share(FrameBudget::of_fields());
	const bool is_done = !physics && job->is_planned() && make_ready();
	const bool tells = job->places() || joins;
	if (!is_done) {
		if (tells) {
			tell_of(progress());
		}
		return;
	}
	joins = false;
	const std::unique_ptr<FieldFill> finished = std::move(job);
	const bool stands = adopt(*finished);
	clearing.start(finished->take_rubbish());
	if (stands && finished->has_rest()) {
		begin_rest(*finished);
	}
	if (is_due_again || (stands && !update_levels())) {
		fill(false);
	}
	if (!stands) {
		fail(finished->finish().describe_fault()); // The old field stays.
	} else if (tells && !finished->has_rest()) {
		tell_of(1.0f);
		finish_build();
	}
}

bool Meadow::adopt(FieldFill &finished) {
	FieldResult &result = finished.finish();
	if (!result.describe_fault().is_empty()) {
		view.forget_prepared();
		retired.push_back(std::move(result.style));
		return false;
	}
	motion.wait();
	skeletons.release_all(motion);
	tiles.forget_style();
	retired.push_back(std::exchange(style, std::move(result.style))); // Drawn multimeshes use it.
	has_felt = false;
	// Species with rest directions, or texels for those, that differ from the build's.
	std::vector<int> other_rests;
	for (size_t i = 0; i < style.looks.size(); i++) {
		const float lean = style.looks[i].motion.lean;
		const Law law = style.looks[i].motion.law;
		style.looks[i].in_air = PlantWind::is_air(properties.wind);
		style.looks[i].tell_of_stem();
		style.looks[i].read_motion(); // It may have changed during the build.
		if (style.looks[i].motion.lean != lean || style.looks[i].motion.law != law) {
			other_rests.push_back(int(i));
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
	for (const int i : other_rests) {
		motion.set_species(i, style.looks[size_t(i)], store, true);
	}
	motion.upload();
	dress.put_on(style, motion);
	dress.take_away(retired.back());
	view.exchange(style);
	view.show_all_added(style, motion, store);
	unseen.clear();
	frames_since_box = 0;
	patches.forget_unseen();
	if (finished.places() && !ground.needs_survey()) {
		listener.no_ground(String());
	}
	if (finished.places()) {
		is_of_tiles = streams();
		standing_area.stand_by(finished.request());
		tiles.stand(streams() ? finished.tiles() : std::vector<TileKey>(), finished.request());
	}
	remove(store.find_all(std::exchange(removed_meanwhile, {})));
	for (const Repeated &one : repeated) {
		one.edit();
	}
	if (has_other_materials) {
		change_materials();
	}
	refresh();
	return true;
}

} // namespace undergrowth
