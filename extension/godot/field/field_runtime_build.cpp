// Builds of a field: from its properties and the plants that code adds, through styles, to existing plants.

#include "field/field_runtime.hpp"

#include "base/frame_budget.hpp"
#include "base/free_memory.hpp"
#include "base/stopwatch.hpp"

#include <algorithm>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr double FREEING_SHARE = 0.5; // Of the budget of a frame.
// Plants from which on the memory that a build has freed is returned: 30 MB for its species, 250 bytes a plant.
static constexpr int LARGE_BUILD = 2000;

void FieldRuntime::rebuild(bool places, bool styles) {
	if (!node->is_inside_tree()) {
		node->call("rebuild"); // The field is built when it enters the tree: there are no axes and no cameras.
		return;
	}
	const FrameCost::Share share(build_cost);
	const bool placed_before = is_placing();
	if (places && !styles && start_tile_rebuild()) {
		return;
	}
	if (is_at_work() && !places && !placed_before) {
		is_due_again = true; // A property that changes in each frame must not restart the build forever.
		return;
	}
	places = places || needs_other_tiles();
	ground_queue.forget();
	GroundQueryQueue().take_findings(ground_queue);
	has_failed = false;
	built_before = 0.0f;
	drop_job();
	surveyor.stop();
	tiles.stop_list(tile_scene());
	tiles.interrupt(tile_scene());
	tiles.interrupt_parts();
	is_due_again = false;
	if (places || placed_before) {
		drafted.reset();
	}
	if (places) {
		removed_meanwhile.clear();
		reports_parts = false; // The build reports its own end.
	}
	const String fault = begin_sampling(places || placed_before);
	if (fault.is_empty()) {
		if (FrameBudget::of_fields().is_left()) {
			resume_sampling();
		}
		return;
	}
	fail(fault);
}

void FieldRuntime::restart_build(bool places) {
	const std::vector<PlantId> removed = removed_meanwhile;
	rebuild(places);
	removed_meanwhile = removed;
}

void FieldRuntime::touch(const AreaBox &box) {
	if (!sampler || !sampler->places) { // A build that still collects styles reads the map later.
		tiles.touch(tile_scene(), box, store.tile_size());
	}
	if ((!is_building() && setup.levels.empty()) || tiles.part_count() > DirtyTiles::MAX_PARTS) {
		rebuild(true, false);
	}
}

DirtyTiles::Scene FieldRuntime::tile_scene() {
	const auto change = [this](StoreEdit &&edit, ArrivingChunks *chunks) { return apply(std::move(edit), chunks); };
	const auto fault = [this](const String &why) { tile_fault = why; };
	FieldSettings built = settings();
	if (motion.is_ready()) { // The last build may have failed: tiles are for the existing simulation.
		built.prototypes = motion.follows_prototypes() ? std::max(built.prototypes, 1) : 0;
	}
	return { node, properties, store, setup, motion, ground, own_edits.known(), built, view, change, fault,
		left_usec() };
}

// During a build of the whole field, tiles would be placed twice.
void FieldRuntime::poll_tiles(bool physics) {
	const bool was_building = tiles.is_building();
	if (!(streams() || was_building) || is_at_work() || !motion.is_ready()) {
		return;
	}
	if (!physics) {
		motion.wait();
		poll_watch = Stopwatch(); // The step of many plants may take a frame, and the wait must not stop the build.
	}
	const Stopwatch watch;
	if (tiles.resume(tile_scene(), physics)) {
		show_soon(); // No step uploads the poses of a field that is not simulated.
	}
	repeat_edits();
	tiles_usec = physics ? tiles_usec : watch.usec();
	report_tile_fault(was_building);
	if (was_building && !tiles.is_building()) {
		finish_tiles();
	} else if (was_building) {
		report_progress(progress());
	}
}

void FieldRuntime::finish_tiles() {
	tiles.query_queue().take_findings(ground_queue);
	tiles.query_queue().report_all(node);
	listener.no_ground(tiles.query_queue().missing_ground());
	if (streams()) {
		report_progress(1.0f);
		finish_build();
	} else {
		join_tiles();
		report_progress(progress());
	}
}

void FieldRuntime::poll_parts(DirtyTiles::Moment moment, double delta) {
	if (is_at_work() || !motion.is_ready() || !tiles.is_building_parts()) {
		return;
	}
	if (tiles.resume_parts(tile_scene(), moment, ground_usec(delta))) {
		show_soon();
	}
	report_tile_fault(false);
}

void FieldRuntime::follow_strokes(DirtyTiles::Moment moment, double delta) {
	const FrameCost::Share share(build_cost);
	poll_parts(moment, delta);
}

void FieldRuntime::drop_job() {
	motion.cancel_transfer();
	view.forget_prepared();
	joins = false;
	if (job && job->handover != FieldBuild::Handover::none) {
		job->cancel();
		retired.push_back(std::move(job->finish().setup));
	}
	job.reset();
}

// Prepares the build over some frames, undrawn, and transfers motion. Then the build replaces the old field.
bool FieldRuntime::make_ready() {
	if (is_transferring()) {
		return !motion.is_transferring();
	}
	if (job->fault() != PlacementFault::none) {
		return job->is_done();
	}
	FieldRenderSetup &next_setup = job->setup();
	for (SpeciesStyle &style : next_setup.styles) {
		if (!style.make_meshes(left_usec())) {
			return false;
		}
	}
	if (job->handover == FieldBuild::Handover::none) {
		has_other_materials = false;
		job->handover = FieldBuild::Handover::dressed;
	}
	if (job->handover == FieldBuild::Handover::dressed) {
		if (!materials.make(next_setup, left_usec())) {
			return false;
		}
		materials.hide(next_setup);
		job->handover = FieldBuild::Handover::shown;
	}
	for (bool is_first = true; const BatchPlan *plan = job->next_plan(); is_first = false) {
		if (!is_first && view.expected_usec(*plan) > left_usec()) {
			return false;
		}
		view.prepare(next_setup, *plan);
		job->leave_plan();
	}
	if (!job->is_done() || view.reveal_some(left_usec())) {
		return false;
	}
	FieldResult &result = job->finish();
	if (!result.describe_fault().is_empty()) {
		return true;
	}
	job->handover = FieldBuild::Handover::transferring;
	motion.begin_transfer(*result.motion, result.matches);
	return !motion.is_transferring();
}

void FieldRuntime::poll(double delta, bool physics) {
	const FrameCost::Share share(build_cost);
	const Caller before = std::exchange(caller, is_urgent() ? caller : Caller::frame);
	poll_all(delta, physics);
	caller = before;
}

void FieldRuntime::return_memory() {
	if (holds_free_memory && !is_at_work() && !is_building() && !clearing.is_running()) {
		holds_free_memory = false;
		clearing.start(&return_free_memory);
	}
}

void FieldRuntime::poll_all(double delta, bool physics) {
	if (!physics) {
		view.flush_if_undrawn();
	}
	poll_watch = Stopwatch();
	// A build that replaces the whole field needs most of a frame.
	if (!physics && !is_transferring() && !view.free_some(FREEING_SHARE * budget_usec())) {
		retired.clear();
		retired_materials.clear();
		return_memory();
	}
	poll_tiles(physics);
	poll_parts(physics ? DirtyTiles::Moment::physics : DirtyTiles::Moment::begun, delta);
	if (!physics) {
		skeletons.release_left();
	}
	if (sampler && surveyor.is_at_work()) {
		surveyor.resume(budget_usec(), physics);
	}
	if (sampler && !physics && (is_urgent() || (sampler->is_due() && FrameBudget::of_fields().is_left()))) {
		resume_sampling();
	}
	if (job && job->needs_ground()) {
		serve_ground(delta, physics);
	}
	if (job && (physics || is_urgent() || FrameBudget::of_fields().is_left())) {
		poll_job(physics);
	}
	if (reports_parts && !is_at_work() && !is_building() && !is_building_parts()) {
		reports_parts = false;
		finish_build();
	}
}

// The first part of a build may have no ground although the rest has some.
void FieldRuntime::serve_ground(double delta, bool physics) {
	const bool is_whole = !job->has_rest();
	const GroundSampler::State state =
			ground_queue.serve(*job, node, properties, ground_usec(delta), physics, is_whole);
	if (state == GroundSampler::State::failed) {
		drop_job();
		fail(ground_queue.fault());
	} else if (state == GroundSampler::State::done && is_whole) {
		listener.no_ground(ground_queue.missing_ground());
	}
}

void FieldRuntime::poll_job(bool physics) {
	const FrameBudget::Share share(FrameBudget::of_fields());
	const bool is_done = !physics && job->is_planned() && make_ready();
	const bool reports = job->places() || joins || drafted;
	if (!is_done) {
		if (reports) {
			report_progress(progress());
		}
		return;
	}
	joins = false;
	std::unique_ptr<FieldBuild> finished = std::move(job);
	const bool is_adopted = adopt(*finished);
	clearing.start(finished->take_garbage());
	holds_free_memory = store.plant_count() >= LARGE_BUILD;
	if (is_adopted && finished->is_draft()) {
		refine(std::move(finished));
		return;
	}
	if (is_due_again || (is_adopted && !update_levels())) {
		rebuild(false);
		if (is_adopted && drafted) {
			return; // The rest follows when that has ended.
		}
	}
	if (!is_adopted) {
		fail(finished->finish().describe_fault()); // The old field stays.
	} else if (reports) {
		const std::unique_ptr<FieldBuild> first = drafted ? std::move(drafted) : std::move(finished);
		follow(*first);
	}
}

bool FieldRuntime::adopt(FieldBuild &finished) {
	FieldResult &result = finished.finish();
	if (!result.describe_fault().is_empty()) {
		view.forget_prepared();
		retired.push_back(std::move(result.setup));
		return false;
	}
	motion.wait();
	tiles.interrupt(tile_scene());
	skeletons.release_all(motion);
	retired.push_back(std::exchange(setup, std::move(result.setup))); // Drawn multimeshes use it.
	has_felt = false;
	// Species with rest directions, or texels for those, that differ from the build's.
	std::vector<int> other_rests;
	for (size_t i = 0; i < setup.styles.size(); i++) {
		const float lean = setup.styles[i].motion.lean;
		const Law law = setup.styles[i].motion.law;
		setup.styles[i].in_air = PlantWind::is_air(properties.wind);
		setup.styles[i].send_stem();
		setup.styles[i].read_motion(); // It may have changed during the build.
		if (setup.styles[i].motion.lean != lean || setup.styles[i].motion.law != law) {
			other_rests.push_back(int(i));
		}
		setup.styles[i].take_material();
	}
	StoreEdit edit;
	edit.replaces_all = true;
	edit.generated = std::move(result.chunks);
	edit.tile_size = finished.tile_size();
	edit.spacing = result.spacing;
	edit.species_numbers = finished.species_numbers();
	ChangeSet changes = store.apply(std::move(edit));
	finished.add_garbage(motion.adopt(*result.motion, result.matches, changes, store, setup));
	finished.add_garbage(std::make_shared<decltype(changes.left)>(std::move(changes.left)));
	motion.set_update_interval(properties.update_interval);
	trampling.arrive(changes, store, motion);
	own_edits.follow_all(store, setup, motion);
	for (const int i : other_rests) {
		motion.set_species(i, setup.styles[size_t(i)], store, true);
	}
	motion.upload();
	materials.bind(setup, motion);
	materials.hide(retired.back());
	view.exchange(setup);
	view.show_all_added(setup, motion, store);
	unseen.clear();
	frames_since_box = 0;
	tiles.forget_undrawn();
	if (finished.places() && !ground.needs_queries()) {
		listener.no_ground(String());
	}
	if (finished.places()) {
		is_of_tiles = streams();
		placed_area.store_shapes(finished.request());
		tiles.set_existing(tile_scene(), streams() ? finished.tiles() : std::vector<TileKey>(), finished.request());
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
