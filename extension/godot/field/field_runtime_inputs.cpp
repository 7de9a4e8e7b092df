// Styles and motion of a field's species: collected before a build, and updated afterwards.

#include "field/field_runtime.hpp"

#include "base/frame_budget.hpp"
#include "base/messages.hpp"
#include "field/motion/wind_in_field.hpp"
#include "field/view/field_fitting.hpp"
#include "field/view/listed_styles.hpp"
#include "plants/plant_simulation.hpp"

#include <algorithm>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr double ASKING_USEC = 2000.0; // Per frame, for the scripts of species.

FieldSettings FieldRuntime::settings() const {
	FieldSettings made;
	made.step = float(PlantSimulation::get_singleton()->get_step_length());
	made.update_interval = properties.update_interval;
	made.prototypes = properties.prototypes;
	made.seed = uint64_t(properties.seed);
	return made;
}

// Builds tile by tile if only positions and heights of plants change.
bool FieldRuntime::start_tile_rebuild() {
	PlacementRequest request;
	FieldGround read;
	const bool is_possible = motion.is_ready() && (!is_at_work() || joins) && streams() == is_of_tiles &&
			(properties.prototypes > 0) == motion.follows_prototypes() &&
			float(properties.tile_size) == store.tile_size() && is_listed_so(setup, properties) && update_levels() &&
			read_request(node, properties, setup, nullptr, request).is_empty() &&
			read_ground(node, properties, read).is_empty() &&
			surveyor.is_current(node, properties, placed_box(request));
	const std::vector<TileKey> list = is_possible ? tiles.list_again(tile_scene(), request) : std::vector<TileKey>();
	if (list.empty()) {
		return false;
	}
	ground_queue.forget();
	GroundQueryQueue().take_findings(ground_queue);
	has_failed = false;
	built_before = 0.0f;
	drop_job();
	tiles.stop_list(tile_scene());
	tiles.interrupt(tile_scene());
	tiles.interrupt_parts();
	tiles.forget_parts();
	reports_parts = is_due_again = false; // The rebuild reports its own end.
	reported_progress = -1.0f;
	ground = std::move(read);
	ground.survey = surveyor.survey();
	placed_area.store_shapes(request);
	listener.fault(setup.left_out);
	tiles.begin_build(tile_scene(), list, request);
	return true;
}

// After tiles were exchanged one by one, rebuilds pages and multimeshes that tiles share, as in a build of the whole
// field.
void FieldRuntime::join_tiles() {
	BuildInput input;
	input.places = false;
	input.setup = setup;
	for (size_t i = 0; i < setup.styles.size(); i++) {
		input.setup.styles[i].materials.clear();
		input.species_numbers.push_back(int(i));
	}
	take_existing_plants(input);
	removed_meanwhile.clear();
	job = std::make_unique<FieldBuild>(std::move(input));
	joins = true;
	job->start();
}

void FieldRuntime::take_existing_plants(BuildInput &input) const {
	const Ref<PlantWind> &wind = properties.wind;
	input.settings = settings();
	input.makes_meshes = renders_on_threads();
	input.tile_size = float(properties.tile_size);
	input.wind = field_wind(wind, axes_of(node), wind.is_valid() ? wind->get_time() : 0.0);
	input.existing = share_generated(store);
	input.edits = own_edits.known();
}

String FieldRuntime::make_build_input(BuildInput &input) {
	const bool places = sampler->places;
	input.places = places;
	input.setup = std::move(sampler->setup);
	String fault = places ? read_request(node, properties, input.setup, nullptr, input.request) : String();
	if (fault.is_empty()) {
		fault = read_ground(node, properties, input.ground);
	}
	if (!fault.is_empty()) {
		return fault;
	}
	input.ground.survey = surveyor.survey();
	if (places) {
		ground = input.ground;
		tiles.forget_parts();
	}
	take_existing_plants(input);
	input.is_of_tiles = places && streams();
	input.draws_tiles = streams() || (drafted && drafted->has_rest());
	if (input.is_of_tiles) {
		input.tiles = tiles.choose_all(tile_scene(), input.request);
	}
	if (places) {
		split_first_build(input);
		input.is_draft = needs_drafts(input);
	}
	return String();
}

String FieldRuntime::begin_sampling(bool places) {
	std::vector<int> numbers;
	std::vector<Ref<PlantFunction>> existing;
	for (const SpeciesStyle &style : setup.styles) {
		existing.push_back(style.function);
	}
	const bool of_drafts = places && !drafted && may_need_drafts();
	sampler = std::make_unique<SpeciesSampler>(places, of_drafts, std::move(existing));
	return sampler->begin(node, properties, sight_range_of(node), others_of(setup, store, properties, numbers));
}

bool FieldRuntime::has_survey(String &fault) {
	fault = surveyor.fault();
	if (surveyor.is_at_work() || !fault.is_empty()) {
		return false;
	}
	if (!HabitatSurveyor::is_needed(properties)) {
		return true; // Reading the request costs time, and the build reads it again.
	}
	PlacementRequest request;
	FieldGround below;
	fault = read_request(node, properties, sampler->setup, nullptr, request);
	fault = fault.is_empty() ? read_ground(node, properties, below) : fault;
	const AreaBox area = placed_box(request);
	const bool is_bare = area.low.x > area.high.x || area.low.y > area.high.y;
	if (!fault.is_empty() || is_bare || surveyor.is_current(node, properties, area)) {
		return fault.is_empty();
	}
	surveyor.begin(node, properties, below, area);
	fault = surveyor.fault();
	return false;
}

void FieldRuntime::resume_sampling() {
	const FrameBudget::Share share(FrameBudget::of_fields());
	bool is_done = false;
	String fault = sampler->resume(is_urgent() ? budget_usec() : ASKING_USEC, is_done);
	if (fault.is_empty() && !is_done) {
		return;
	}
	const bool places = sampler->places;
	if (fault.is_empty() && places && !has_survey(fault) && fault.is_empty()) {
		return;
	}
	BuildInput input;
	motion.wait();
	if (fault.is_empty() && !sampler->includes(others_of(setup, store, properties, input.species_numbers))) {
		restart_build(places); // Meanwhile code added plants of a species that had none before.
		return;
	}
	fault = fault.is_empty() ? make_build_input(input) : fault;
	if (!fault.is_empty()) {
		fail(fault);
		return;
	}
	sampler.reset();
	listener.fault(input.setup.left_out);
	job = std::make_unique<FieldBuild>(std::move(input));
	reported_progress = -1.0f;
	job->start();
}

void FieldRuntime::follow_area() {
	PlacementRequest now;
	const String fault = read_request(node, properties, setup, nullptr, now);
	if (!fault.is_empty() || !placed_area.can_follow(now) || is_at_work() || is_building() || streams() ||
			!surveyor.is_current(node, properties, placed_box(now))) {
		rebuild(true, false);
		return;
	}
	listener.fault(setup.left_out);
	reports_parts = true;
	if (const std::optional<AreaBox> changed = placed_area.follow(now)) {
		touch(*changed);
	}
}

bool FieldRuntime::update_levels() {
	if (!find_level_fault(properties).is_empty()) {
		return false; // The next build reports it.
	}
	std::vector<FieldLevel> wanted = read_levels(properties, sight_range_of(node));
	const bool same = std::equal(wanted.begin(), wanted.end(), setup.levels.begin(), setup.levels.end(),
			[](const FieldLevel &a, const FieldLevel &b) { return a.lod == b.lod; });
	if (!same) {
		return setup.levels.empty();
	}
	for (size_t i = 0; i < wanted.size(); i++) { // The squares of the plans stay the same.
		wanted[i].tile_factor = setup.levels[i].tile_factor;
		wanted[i].tile_cuts = setup.levels[i].tile_cuts;
	}
	FieldRenderSetup fitted = outline_of(setup);
	fitted.levels = wanted;
	fitted.rule = read_level_rule(properties, sight_range_of(node));
	if (is_listed_so(setup, properties)) {
		read_densities(properties, fitted);
	}
	fit_levels(fitted);
	bool are_same = wanted == setup.levels;
	for (size_t i = 0; i < setup.styles.size(); i++) {
		std::vector<FieldLevel> &own = fitted.styles[i].levels;
		for (size_t k = 0; k < own.size(); k++) {
			const FieldLevel &old = setup.styles[i].levels[k];
			own[k].tile_factor = old.tile_factor;
			own[k].tile_cuts = old.tile_cuts;
			if (!own[k].has_form_of(old)) {
				return false;
			}
		}
		are_same = are_same && own == setup.styles[i].levels && fitted.styles[i].casters == setup.styles[i].casters;
	}
	if (are_same) {
		return true;
	}
	setup.levels = wanted;
	setup.rule = fitted.rule;
	for (size_t i = 0; i < setup.styles.size(); i++) {
		setup.styles[i].levels = std::move(fitted.styles[i].levels);
		setup.styles[i].density = fitted.styles[i].density;
		setup.styles[i].casters = fitted.styles[i].casters;
	}
	view.update_levels(setup);
	skeletons.apply_flags(near_flags());
	if (motion.pose_texture().is_valid()) {
		materials.bind(setup, motion);
	}
	return true;
}

int FieldRuntime::species_for(const Ref<PlantFunction> &function) {
	for (size_t i = 0; i < setup.styles.size(); i++) {
		if (setup.styles[i].function == function) {
			return int(i);
		}
	}
	if (setup.styles.size() >= size_t(PlacementRequest::MAX_SPECIES)) {
		report_error(node,
				"has the maximum of 256 species: no plants of " + describe(function.ptr()) +
						" are added. Add them to another field.");
		return -1;
	}
	if (motion.is_ready() && !motion.has_room_for_species()) {
		report_error(node,
				"has no texture layers left for another species with prototypes: no plants of " +
						describe(function.ptr()) + " are added. Add them to another field, or set prototypes to 0.");
		return -1;
	}
	if (setup.levels.empty()) {
		setup.levels = read_levels(properties, sight_range_of(node));
		setup.rule = read_level_rule(properties, sight_range_of(node));
		setup.tile_size = store.tile_size();
		list_styles(nullptr, PlacementOptions(), {}, setup);
	}
	SpeciesStyle style;
	const String fault = read_other_style(function, properties, setup, style);
	if (!fault.is_empty()) {
		report_error(node, "cannot add plants of " + fault);
		return -1;
	}
	if (!motion.is_ready()) {
		motion.start(settings());
	}
	motion.add_species(style);
	setup.styles.push_back(std::move(style));
	has_felt = false;
	if (motion.pose_texture().is_valid()) {
		materials.bind_last(setup, motion);
	}
	return int(setup.styles.size()) - 1;
}

void FieldRuntime::update_wind_kind(const Ref<PlantWind> &blowing) {
	const bool in_air = PlantWind::is_air(blowing);
	if (has_felt && in_air == felt_air) {
		return;
	}
	has_felt = true;
	felt_air = in_air;
	bool is_news = false;
	for (size_t i = 0; i < setup.styles.size(); i++) {
		SpeciesStyle &style = setup.styles[i];
		if (style.in_air == in_air) {
			continue;
		}
		style.in_air = in_air;
		if (style.motion.law == Law::stem) {
			style.read_motion();
			motion.set_species(int(i), style, store, false);
			is_news = true;
		}
	}
	if (is_news) {
		tiles.interrupt(tile_scene());
		send_stems();
	}
}

void FieldRuntime::send_stems() {
	materials.send_stems(setup);
	skeletons.follow_stems(store, setup, motion);
}

void FieldRuntime::read_motion(const PlantFunction *function, bool is_still) {
	for (size_t i = 0; i < setup.styles.size(); i++) {
		if (setup.styles[i].function.ptr() == function && motion.is_ready()) {
			setup.styles[i].read_motion();
			motion.set_species(int(i), setup.styles[i], store, is_still);
			tiles.interrupt(tile_scene());
		}
	}
	send_stems();
	if (is_still && motion.is_ready()) {
		refresh();
	}
}

} // namespace undergrowth
