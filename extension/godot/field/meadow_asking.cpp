// Looks and motion of a field's species: collected before a build, and updated afterwards.

#include "field/meadow.hpp"

#include "field/field_fitting.hpp"
#include "field/field_patch.hpp"
#include "field/field_wind_clock.hpp"
#include "field/listed_looks.hpp"
#include "frame_budget.hpp"
#include "messages.hpp"
#include "plant_simulation.hpp"

#include <algorithm>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr double ASKING_USEC = 2000.0; // Per frame, for the scripts of species.

FieldSettings Meadow::settings() const {
	FieldSettings made;
	made.step = float(PlantSimulation::get_singleton()->get_step_length());
	made.update_interval = properties.update_interval;
	made.prototypes = properties.prototypes;
	made.seed = uint64_t(properties.seed);
	return made;
}

// Builds tile by tile if only positions and heights of plants change.
bool Meadow::renew() {
	PlacementRequest request;
	FieldGround read;
	const bool is_possible = motion.is_ready() && (!is_at_work() || joins) && streams() == is_of_tiles &&
			(properties.prototypes > 0) == motion.follows_prototypes() &&
			float(properties.tile_size) == store.tile_size() && is_listed_so(style, properties) && update_levels() &&
			read_request(node, properties, style, nullptr, request).is_empty() &&
			read_ground(node, properties, read).is_empty();
	std::vector<TileKey> list = is_possible ? FieldRenewal::list(tile_scene(), request, tiles) : std::vector<TileKey>();
	if (list.empty()) {
		return false;
	}
	asker.forget();
	GroundAsker().take_findings(asker);
	has_failed = false;
	built_before = 0.0f;
	drop_job();
	renewal.stop(tile_scene(), motion);
	tiles.interrupt(tile_scene());
	patches.interrupt();
	patches.forget_touched();
	tells_of_patches = is_due_again = false; // The renewal reports its own end.
	told_progress = -1.0f;
	ground = std::move(read);
	standing_area.stand_by(request);
	listener.fault(style.left_out);
	if (streams()) {
		tiles.stand(list, request);
	}
	renewal.begin(std::move(list), request);
	return true;
}

// After tiles were exchanged one by one, rebuilds pages and multimeshes that tiles share, as in a build of the whole
// field.
void Meadow::join_tiles() {
	FieldRecipe recipe;
	recipe.places = false;
	recipe.style = style;
	for (size_t i = 0; i < style.looks.size(); i++) {
		recipe.style.looks[i].materials.clear();
		recipe.species_numbers.push_back(int(i));
	}
	tell_what_stands(recipe);
	removed_meanwhile.clear();
	job = std::make_unique<FieldFill>(std::move(recipe));
	joins = true;
	job->start();
}

void Meadow::tell_what_stands(FieldRecipe &recipe) const {
	const Ref<PlantWind> &wind = properties.wind;
	recipe.prepare = motion.prepare();
	recipe.settings = settings();
	recipe.makes_meshes = renders_on_threads();
	recipe.tile_size = float(properties.tile_size);
	recipe.wind = field_wind(wind, axes_of(node), wind.is_valid() ? wind->get_time() : 0.0);
	recipe.standing = copy_filled(store);
	recipe.changes = own_changes.known();
}

String Meadow::make_recipe(FieldRecipe &recipe) {
	recipe.places = asking->places;
	recipe.style = std::move(asking->style);
	String fault = recipe.places ? read_request(node, properties, recipe.style, nullptr, recipe.request) : String();
	if (fault.is_empty()) {
		fault = read_ground(node, properties, recipe.ground);
	}
	if (!fault.is_empty()) {
		return fault;
	}
	if (recipe.places) {
		ground = recipe.ground;
		patches.forget_touched();
	}
	tell_what_stands(recipe);
	recipe.is_of_tiles = recipe.places && streams();
	recipe.draws_tiles = streams();
	if (recipe.is_of_tiles) {
		recipe.tiles = tiles.choose_all(tile_scene(), recipe.request);
	}
	if (recipe.places) {
		split_first_build(recipe);
	}
	return String();
}

String Meadow::begin_asking(bool places) {
	std::vector<int> numbers;
	std::vector<Ref<PlantFunction>> standing;
	for (const FieldLook &look : style.looks) {
		standing.push_back(look.function);
	}
	asking = std::make_unique<LookAsking>(places, std::move(standing));
	return asking->begin(node, properties, sight_range_of(node), others_of(style, store, properties, numbers));
}

void Meadow::go_on_asking() {
	const FrameBudget::Share share(FrameBudget::of_fields());
	bool is_done = false;
	String fault = asking->go_on(is_urgent ? budget_usec() : ASKING_USEC, is_done);
	if (fault.is_empty() && !is_done) {
		return;
	}
	const bool places = asking->places;
	FieldRecipe recipe;
	motion.wait();
	if (fault.is_empty() && !asking->knows(others_of(style, store, properties, recipe.species_numbers))) {
		fill_again(places); // Meanwhile code added plants of a species that had none before.
		return;
	}
	fault = fault.is_empty() ? make_recipe(recipe) : fault;
	if (!fault.is_empty()) {
		fail(fault);
		return;
	}
	asking.reset();
	listener.fault(recipe.style.left_out);
	job = std::make_unique<FieldFill>(std::move(recipe));
	told_progress = -1.0f;
	job->start();
}

void Meadow::follow_area() {
	PlacementRequest now;
	const String fault = read_request(node, properties, style, nullptr, now);
	if (!fault.is_empty() || !standing_area.can_follow(now) || is_at_work() || is_building() || streams()) {
		fill(true, false);
		return;
	}
	listener.fault(style.left_out);
	tells_of_patches = true;
	if (const std::optional<AreaBox> changed = standing_area.follow(now)) {
		touch(*changed);
	}
}

bool Meadow::update_levels() {
	if (!find_level_fault(properties).is_empty()) {
		return false; // The next build reports it.
	}
	std::vector<FieldLevel> wanted = read_levels(properties, sight_range_of(node));
	const bool same = std::equal(wanted.begin(), wanted.end(), style.levels.begin(), style.levels.end(),
			[](const FieldLevel &a, const FieldLevel &b) { return a.lod == b.lod; });
	if (!same) {
		return style.levels.empty();
	}
	for (size_t i = 0; i < wanted.size(); i++) { // The squares of the plans stay the same.
		wanted[i].tile_factor = style.levels[i].tile_factor;
		wanted[i].tile_cuts = style.levels[i].tile_cuts;
	}
	FieldStyle fitted = outline_of(style);
	fitted.levels = wanted;
	fitted.rule = read_level_rule(properties, sight_range_of(node));
	for (size_t i = 0; i < style.looks.size(); i++) {
		fitted.looks[i].errors = style.looks[i].errors;
		fitted.looks[i].density = style.looks[i].density;
		fitted.looks[i].mean_scale = style.looks[i].mean_scale;
	}
	if (is_listed_so(style, properties)) {
		read_densities(properties, fitted);
	}
	fit_levels(fitted);
	bool are_same = wanted == style.levels;
	for (size_t i = 0; i < style.looks.size(); i++) {
		std::vector<FieldLevel> &own = fitted.looks[i].levels;
		for (size_t k = 0; k < own.size(); k++) {
			const FieldLevel &old = style.looks[i].levels[k];
			own[k].tile_factor = old.tile_factor;
			own[k].tile_cuts = old.tile_cuts;
			if (!own[k].has_form_of(old)) {
				return false;
			}
		}
		are_same = are_same && own == style.looks[i].levels;
	}
	if (are_same) {
		return true;
	}
	style.levels = wanted;
	style.rule = fitted.rule;
	for (size_t i = 0; i < style.looks.size(); i++) {
		style.looks[i].levels = std::move(fitted.looks[i].levels);
		style.looks[i].density = fitted.looks[i].density;
		style.looks[i].near_shadow_level = fitted.looks[i].near_shadow_level;
		style.looks[i].near_shadow_end = fitted.looks[i].near_shadow_end;
	}
	view.update_levels(style);
	skeletons.dress(near_wear());
	if (motion.pose_texture().is_valid()) {
		dress.put_on(style, motion);
	}
	return true;
}

int Meadow::species_for(const Ref<PlantFunction> &function) {
	for (size_t i = 0; i < style.looks.size(); i++) {
		if (style.looks[i].function == function) {
			return int(i);
		}
	}
	if (style.looks.size() >= size_t(PlacementRequest::MOST_SPECIES)) {
		report_error(node,
				"cannot hold more than 256 species, and it has them: no plants of " + describe(function.ptr()) +
						" are added. Add them to another field.");
		return -1;
	}
	if (motion.is_ready() && !motion.has_room_for_species()) {
		report_error(node,
				"cannot hold more species with prototypes than its textures have layers for: no plants of " +
						describe(function.ptr()) + " are added. Add them to another field, or set prototypes to 0.");
		return -1;
	}
	if (style.levels.empty()) {
		style.levels = read_levels(properties, sight_range_of(node));
		style.rule = read_level_rule(properties, sight_range_of(node));
		style.tile_size = store.tile_size();
		list_looks(nullptr, StandOptions(), {}, style);
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
		dress.put_on_last(style, motion);
	}
	return int(style.looks.size()) - 1;
}

void Meadow::feel(const Ref<PlantWind> &blowing) {
	const bool in_air = PlantWind::is_air(blowing);
	bool is_news = false;
	for (size_t i = 0; i < style.looks.size(); i++) {
		FieldLook &look = style.looks[i];
		if (look.in_air == in_air) {
			continue;
		}
		look.in_air = in_air;
		if (look.motion.law == Law::stem) {
			look.read_motion();
			motion.set_species(int(i), look, store, false);
			is_news = true;
		}
	}
	if (is_news) {
		tiles.interrupt(tile_scene());
		renewal.interrupt(tile_scene(), motion);
		tell_of_stems();
	}
}

void Meadow::tell_of_stems() {
	dress.tell_of_stems(style);
	skeletons.follow_stems(store, style, motion);
}

void Meadow::read_motion(const PlantFunction *function, bool is_still) {
	for (size_t i = 0; i < style.looks.size(); i++) {
		if (style.looks[i].function.ptr() == function && motion.is_ready()) {
			style.looks[i].read_motion();
			motion.set_species(int(i), style.looks[i], store, is_still);
			tiles.interrupt(tile_scene());
			renewal.interrupt(tile_scene(), motion);
		}
	}
	tell_of_stems();
	if (is_still && motion.is_ready()) {
		refresh();
	}
}

} // namespace undergrowth
