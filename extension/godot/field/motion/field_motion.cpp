#include "field/motion/field_motion.hpp"

#include "base/convert.hpp"
#include "base/stopwatch.hpp"
#include "field/motion/wind_in_field.hpp"
#include "nodes/plant_wind_source_3d.hpp"
#include "plants/plant_simulation.hpp"

#include <godot_cpp/classes/os.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr double USUAL_STEP = 1.0 / 60.0; // s.
static constexpr int FRAMES_BETWEEN_FAR_UPDATES = 15;
static constexpr int MAX_FAR_MULTIPLE = 32;
static constexpr double NEAR = 10.0; // m: distance within which a stem's second mode is visible.
static constexpr double NEVER_FAR = 0.5; // Fraction of far_distance within which plants are stepped in full.
// Ratio of distances between rings; each ring is stepped half as often as the one before.
static constexpr double FARTHER = 1.4142135623730951;

FieldMotion::FieldMotion() : preview_clock(USUAL_STEP) {}

FieldMotion::~FieldMotion() {
	steps.wait();
}

void FieldMotion::wait() {
	steps.wait();
	transfer.wait();
	for (const Height &one : std::exchange(heights, {})) {
		const int page = rows_of(one.ref.chunk).page;
		if (!simulation->page(page).is_gone(row_of(one.ref))) {
			simulation->set_plant(page, row_of(one.ref), one.plant);
			textures->set_height(page, row_of(one.ref), one.share);
		}
	}
	if (pending_removals.empty()) {
		return;
	}
	for (const PlantRef &ref : std::exchange(pending_removals, {})) {
		drop(rows_of(ref.chunk).page, row_of(ref));
	}
	textures->write_history(*simulation, false);
	fit_contact(touches);
}

void FieldMotion::start(const FieldSettings &settings) {
	wait();
	is_transferred = false;
	simulation = std::make_unique<FieldSimulation>(settings);
	textures = std::make_unique<PoseTexture>(settings.prototypes > 0);
	rows.clear();
	begin_clock();
}

void FieldMotion::begin_clock() {
	preview_clock = FixedStep(PlantSimulation::get_singleton()->get_step_length());
	dirty_pages.clear();
}

void FieldMotion::begin_transfer(PreparedMotion &prepared, const std::vector<PlantMatch> &matches) {
	static constexpr size_t FEW = 2000; // Fewer cost less than waking a thread.
	wait();
	is_transferred = true;
	if (matches.size() < FEW) {
		prepared.transfer_motion(simulation.get(), rows, matches);
	} else {
		transfer.start([this, &prepared, &matches] { prepared.transfer_motion(simulation.get(), rows, matches); });
	}
}

void FieldMotion::cancel_transfer() {
	transfer.wait();
	is_transferred = false;
}

std::unique_ptr<FieldSimulation> FieldMotion::adopt(PreparedMotion &prepared, const std::vector<PlantMatch> &matches,
		const ChangeSet &changes, const PlantStore &store, const FieldRenderSetup &setup) {
	wait();
	if (!std::exchange(is_transferred, false)) {
		prepared.transfer_motion(simulation.get(), rows, matches);
	}
	std::unique_ptr<FieldSimulation> old = std::exchange(simulation, std::move(prepared.simulation));
	const std::vector<PageRows> old_rows = std::move(rows);
	textures = std::move(prepared.textures);
	rows.assign(size_t(store.chunk_count()), {});
	for (size_t i = 0; i < prepared.rows.size(); i++) {
		rows[size_t(changes.grown[i].chunk)] = prepared.rows[i];
	}
	for (int i = 0; i < int(setup.styles.size()); i++) {
		simulation->set_species(i, setup.styles[size_t(i)].motion);
	}
	textures->give_history(*simulation); // Stems may have more modes than when the build began.
	take_added(store, setup, old.get(), old_rows);
	begin_clock();
	write_all();
	fit_contact(touches);
	return old;
}

// Added plants and their motion survive a build.
void FieldMotion::take_added(const PlantStore &store, const FieldRenderSetup &setup, const FieldSimulation *old,
		const std::vector<PageRows> &old_rows) {
	for (int chunk = 0; chunk < store.chunk_count(); chunk++) {
		if (!store.chunk(chunk).is_added) {
			continue;
		}
		grow({ chunk, 0 }, store, setup);
		const PageRows from = size_t(chunk) < old_rows.size() ? old_rows[size_t(chunk)] : PageRows();
		const PageRows &to = rows_of(chunk);
		const MotionPage &now = simulation->page(to.page);
		for (int slot = 0; old && from.page >= 0 && slot < std::min(from.count, to.count); slot++) {
			const MotionPage &before = old->page(from.page);
			if (!now.is_gone(to.first + slot) && before.root(from.first + slot) == now.root(to.first + slot)) {
				simulation->transfer_motion(to.page, to.first + slot, *old, from.page, from.first + slot);
			}
		}
	}
}

// Without new plants the running step continues: removed plants wait for the next wait().
void FieldMotion::apply(
		const ChangeSet &changes, const PlantStore &store, const FieldRenderSetup &setup, ArrivingChunks *arriving) {
	if (changes.dropped.empty() && changes.grown.empty()) {
		pending_removals.insert(pending_removals.end(), changes.gone.begin(), changes.gone.end());
		return;
	}
	wait();
	rows.resize(size_t(store.chunk_count()));
	if (arriving) {
		exchange_chunks(changes, *arriving);
		fit_contact(touches);
		return;
	}
	const auto grow_those = [&](bool late) {
		for (const ChangeSet::Grown &grown : changes.grown) {
			if (store.chunk(grown.chunk).is_new == late) {
				grow(grown, store, setup);
			}
		}
	};
	grow_those(true);
	for (const ChangeSet::Moved &plant : changes.moved) {
		const int to = rows_of(plant.to.chunk).page;
		const MotionPage &before = simulation->page(rows_of(plant.from.chunk).page);
		simulation->page(to).transfer_motion(row_of(plant.to), before, row_of(plant.from));
		dirty_pages.push_back(to);
	}
	for (const int chunk : changes.dropped) {
		drop_rows(std::exchange(rows[size_t(chunk)], {}), false);
	}
	grow_those(false);
	for (const PlantRef &ref : changes.gone) {
		drop(rows_of(ref.chunk).page, row_of(ref));
	}
	textures->write_history(*simulation, false);
	fit_contact(touches);
}

void FieldMotion::drop(int page, int row) {
	simulation->drop(page, row);
	textures->hide(page, row);
}

// Only chunks of added or new plants grow; each has a page of its own. New plants keep their texels. All plants of
// to_simulate() are valid, as the page requires.
void FieldMotion::grow(const ChangeSet::Grown &grown, const PlantStore &store, const FieldRenderSetup &setup) {
	const PlantChunk &chunk = store.chunk(grown.chunk);
	const SpeciesStyle &style = setup.styles[size_t(chunk.species)];
	std::vector<MotionPlant> plants;
	for (int slot = grown.first; slot < chunk.size(); slot++) {
		PlacedPlant plant = chunk.plants.plant(slot);
		plant.scale = chunk.is_gone(slot) ? 1.0f : plant.scale; // A removed plant needs a row, which is dropped below.
		plants.push_back(style.to_simulate(plant));
	}
	PageRows &own = rows[size_t(grown.chunk)];
	if (own.page < 0) {
		own.page = simulation->add_page(chunk.species, plants.data(), int(plants.size()));
	} else {
		simulation->add_to_page(own.page, plants.data(), int(plants.size()));
	}
	own.count = chunk.size();
	textures->give_rows(own.page, chunk.is_new ? chunk.room() : own.count);
	for (int slot = grown.first; slot < chunk.size(); slot++) {
		if (chunk.is_gone(slot)) {
			drop(own.page, slot);
		}
	}
	if (simulation->settings().prototypes > 0 && simulation->time() == 0.0) {
		simulation->step(); // Fills the history of the prototypes.
		textures->write_history(*simulation, true);
	}
	textures->write_page(*simulation, own.page);
	textures->write_beside(*simulation, own.page);
}

void FieldMotion::write_all() {
	textures->write_pages(*simulation);
	textures->write_history(*simulation, true);
}

bool FieldMotion::has_room_for_species() {
	wait();
	return textures->has_room_for_species();
}

void FieldMotion::add_species(const SpeciesStyle &style) {
	wait();
	simulation->add_species(style.motion);
	textures->give_history(*simulation);
	if (simulation->time() > 0.0) {
		textures->write_history_of(*simulation, simulation->species_count() - 1);
	}
}

int FieldMotion::modes_of_prototypes(int species) const {
	const Prototypes *models = simulation->prototypes(species);
	return models ? models->modes() : 0;
}

void FieldMotion::set_species(int index, const SpeciesStyle &style, const PlantStore &store, bool is_still) {
	wait();
	const int modes_before = modes_of_prototypes(index);
	simulation->set_species(index, style.motion);
	if (modes_of_prototypes(index) != modes_before) {
		textures->give_history(*simulation);
		textures->write_history(*simulation, true);
	}
	for (int number = 0; number < store.chunk_count(); number++) {
		const PlantChunk &chunk = store.chunk(number);
		if (chunk.size() == 0 || chunk.species != index) {
			continue;
		}
		std::vector<MotionPlant> plants;
		style.to_simulate(chunk.plants, plants);
		const PageRows &own = rows_of(number);
		simulation->page(own.page).set_owns(own.first, plants.data(), own.count);
		std::vector<glm::vec3> rests;
		for (const MotionPlant &plant : plants) {
			rests.push_back(plant.rest);
		}
		set_rests(own, rests, is_still);
	}
	fit_contact(touches);
	if (is_still) {
		write_all();
	}
}

void FieldMotion::set_rests(const PageRows &own, const std::vector<glm::vec3> &rests, bool is_still) {
	MotionPage &plants = simulation->page(own.page);
	std::vector<std::pair<int, glm::vec3>> at_rest;
	for (int i = own.first; is_still && plants.swings() && i < own.first + own.count; i++) {
		if (plants.is_at_rest(i)) {
			at_rest.emplace_back(i, plants.rest(i));
		}
	}
	simulation->set_rests(own.page, own.first, rests.data(), own.count);
	textures->write_beside(*simulation, own.page);
	for (const auto &[i, was] : at_rest) {
		if (plants.rest(i) != was) { // With the same rest, the plant may be passing through it.
			plants.settle(i);
		}
	}
}

void FieldMotion::set_update_interval(int step_count) {
	if (simulation) {
		wait();
		simulation->set_update_interval(step_count);
	}
}

void FieldMotion::fit_contact(bool on) {
	touches = on;
	if (on && simulation) {
		wait();
		touching.fit(*simulation);
	}
}

void FieldMotion::settle() {
	wait();
	is_transferred = false;
	simulation->settle();
	write_all();
}

MotionState FieldMotion::blocking_read_state(const PlantRef &ref) {
	wait();
	const int page = rows_of(ref.chunk).page;
	return simulation->motion(page, row_of(ref));
}

glm::vec3 FieldMotion::blocking_read_tip(const PlantRef &ref) {
	wait();
	const PageRows &own = rows_of(ref.chunk);
	const MotionPage &page = simulation->page(own.page);
	return page.swings() ? page.tip(row_of(ref)) : simulation->shown_point(own.page, row_of(ref), 1.0f, 1.0f);
}

void FieldMotion::write_state(const PlantRef &ref, const MotionState &state) {
	wait();
	is_transferred = false;
	simulation->set_state(rows_of(ref.chunk).page, row_of(ref), state.tip, state.second);
}

std::vector<glm::vec2> FieldMotion::blocking_read_lasting_bends(int chunk) {
	wait();
	const PageRows own = size_t(chunk) < rows.size() ? rows_of(chunk) : PageRows();
	std::vector<glm::vec2> bends;
	if (own.page >= 0 && simulation->page(own.page).has_lasting_bends()) {
		for (int row = own.first; row < own.first + own.count; row++) {
			bends.push_back(simulation->lasting_bend(own.page, row));
		}
	}
	return bends;
}

void FieldMotion::set_lasting_bend(const PlantRef &ref, const glm::vec2 &bend) {
	wait();
	simulation->set_lasting_bend(rows_of(ref.chunk).page, row_of(ref), bend);
}

void FieldMotion::forget_lasting_bends() {
	wait();
	for (int page = 0; page < simulation->page_count(); page++) {
		simulation->page(page).forget_lasting_bends();
	}
}

bool FieldMotion::trample(const PlantRef &ref, const glm::vec3 &direction) {
	wait();
	MotionPage &page = simulation->page(rows_of(ref.chunk).page);
	if (!page.swings() || page.law() != Law::stem) {
		return false;
	}
	const glm::vec2 bend = stereographic(encode_bend(direction));
	const bool is_upright = bend == glm::vec2(0.0f);
	page.set_lasting_bend(row_of(ref), is_upright ? bend : into_rest(bend, page.rest_bend(row_of(ref))));
	return true;
}

void FieldMotion::apply_impulse(const PlantRef &ref, const glm::vec3 &impulse) {
	wait();
	is_transferred = false;
	simulation->apply_impulse(rows_of(ref.chunk).page, row_of(ref), impulse);
}

Vector3 FieldMotion::blocking_air_around(const Vector3 &root, float height) {
	wait();
	const glm::vec2 air = simulation ? simulation->air_around(to_glm(root), height) : glm::vec2(0.0f);
	return Vector3(air.x, 0.0f, air.y);
}

bool FieldMotion::blocking_is_point_in_plants(const glm::vec3 &point, float margin) {
	wait();
	return simulation && simulation->is_point_in_plants(point, margin);
}

void FieldMotion::set_height(const PlantRef &ref, float share, const MotionPlant &plant) {
	heights.push_back({ ref, share, plant });
}

void FieldMotion::set_hidden(const PlantRef &ref, bool hidden) {
	wait();
	const int page = rows_of(ref.chunk).page;
	if (hidden) {
		textures->hide(page, row_of(ref));
	} else {
		textures->show(page, row_of(ref));
		dirty_pages.push_back(page);
	}
}

// A page is removed with the last of its chunks.
void FieldMotion::drop_rows(const PageRows &own, bool leaves_texels) {
	const auto is_there = [&](const PageRows &other) { return other.page == own.page; };
	if (own.page >= 0 && std::none_of(rows.begin(), rows.end(), is_there)) {
		simulation->remove_page(own.page);
		leaves_texels ? textures->leave_rows(own.page) : textures->take_rows(own.page);
		return;
	}
	for (int i = 0; own.page >= 0 && i < own.count; i++) {
		drop(own.page, own.first + i);
	}
}

// New chunks may have the numbers of dropped ones.
void FieldMotion::exchange_chunks(const ChangeSet &changes, ArrivingChunks &arriving) {
	std::map<int, PageRows> left;
	for (const int chunk : changes.dropped) {
		left[chunk] = std::exchange(rows[size_t(chunk)], {});
	}
	for (size_t i = 0; i < arriving.prepared.size(); i++) {
		take_in(changes.grown[i].chunk, *arriving.prepared[i]);
	}
	for (const PlantMatch &match : arriving.matches) {
		const auto was = left.find(match.from.chunk);
		const PageRows from = was == left.end() ? PageRows() : was->second;
		const PageRows &to = rows_of(changes.grown[size_t(match.to.chunk)].chunk);
		if (from.page < 0 || match.from.slot >= from.count) {
			continue;
		}
		const int row = to.first + match.to.slot;
		const int row_before = from.first + match.from.slot;
		const glm::vec3 before = simulation->page(from.page).root(row_before);
		const glm::vec3 now = simulation->page(to.page).root(row);
		if (before.x == now.x && before.z == now.z) {
			simulation->transfer_motion(to.page, row, *simulation, from.page, row_before);
		}
	}
	for (const ChangeSet::Grown &grown : changes.grown) {
		dirty_pages.push_back(rows_of(grown.chunk).page);
	}
	for (const auto &entry : left) {
		drop_rows(entry.second, arriving.leaves_texels);
	}
	if (simulation->settings().prototypes > 0) {
		textures->write_history(*simulation, false);
	}
}

PoseTexels FieldMotion::reserve(PreparedChunk &prepared) {
	wait();
	prepared.texels = textures->reserve(int(prepared.plants.size()));
	return prepared.texels.texels();
}

void FieldMotion::release_texels(PreparedChunk &prepared) {
	wait();
	textures->release(std::exchange(prepared.texels, {}));
}

void FieldMotion::make_room(double plants, int chunks) {
	static constexpr double USED_OF_LAST_ROW = 0.5;
	wait();
	textures->make_room(plants / PoseTexture::SIDE + USED_OF_LAST_ROW * double(chunks));
}

// A new chunk has its own page.
void FieldMotion::take_in(int chunk, PreparedChunk &prepared) {
	PageRows &own = rows[size_t(chunk)];
	own.count = prepared.page.size();
	own.page = simulation->add_page(std::move(prepared.page), prepared.plants.data());
	if (prepared.texels.layer >= 0) {
		textures->give_reserved(own.page, std::exchange(prepared.texels, {}));
	} else {
		textures->give_rows(own.page, own.count);
	}
	// Pages that are uploaded together step together.
	simulation->set_page_phase(own.page, textures->layer_of(own.page));
	textures->write_page(*simulation, own.page);
	textures->write_beside(*simulation, own.page);
}

static int worker_count(const MotionOptions &options) {
	static const int processors = OS::get_singleton()->get_processor_count();
	return options.max_threads > 0 ? options.max_threads : processors;
}

bool FieldMotion::needs_cameras() const {
	return frames_since_far % FRAMES_BETWEEN_FAR_UPDATES == 0;
}

// Pages farther than far_distance are stepped every second step, pages FARTHER times as far every fourth, and so on.
// All far rings cost about the same, because their areas grow at the same rate.
//
// The distance is that of a page's middle, but at most that of its nearest point plus half of far_distance. So all
// plants around a camera are stepped in full, also seen from above. Pushing bodies count as cameras. Near a camera or a
// body, stems with two modes step both. If far_distance is 0, cameras have no effect.
void FieldMotion::update_far(const Frame &frame, const MotionOptions &options) {
	const bool is_due = needs_cameras();
	frames_since_far++;
	if (!is_due) {
		return;
	}
	const Transform3D to_field = frame.axes.affine_inverse();
	std::vector<glm::vec3> cameras;
	for (const Vector3 &camera : frame.cameras) {
		cameras.push_back(to_glm(to_field.xform(camera)));
	}
	const bool applies = options.far_distance > 0.0 && !cameras.empty();
	cameras.insert(cameras.end(), pushed_at.begin(), pushed_at.end());
	const auto metres = [&](const glm::vec3 &way) { return double(frame.axes.basis.xform(to_godot(way)).length()); };
	for (int page = 0; page < simulation->page_count(); page++) {
		const MotionPage &plants = simulation->page(page);
		double away = applies ? 1e30 : 0.0;
		bool is_near = false;
		for (const glm::vec3 &camera : cameras) {
			const double nearest = metres(camera - glm::clamp(camera, plants.low(), plants.high()));
			const double middle = metres(camera - 0.5f * (plants.low() + plants.high()));
			away = std::min(away, std::min(middle, nearest + NEVER_FAR * options.far_distance));
			is_near = is_near || nearest < NEAR;
		}
		simulation->set_page_near(page, applies && is_near);
		int multiple = 1;
		for (double limit = options.far_distance; multiple < MAX_FAR_MULTIPLE && applies && away > limit;
				limit *= FARTHER) {
			multiple *= 2;
		}
		simulation->set_page_multiple(page, multiple);
	}
}

// Sets the wind of step `index` of a frame. The clock of the wind and that of the simulation differ.
void FieldMotion::follow_wind(const Frame &frame, int index) {
	const double length = frame.steps.length;
	const double time = simulation->time();
	if (frame.wind.is_null()) {
		simulation->set_wind(field_wind({}, frame.axes, 0.0));
		time_after_step += length;
		return;
	}
	const int ago = frame.steps.count - index;
	simulation->set_wind(field_wind(frame.wind, frame.axes, frame.wind->time_before(ago, length) - time, ago));
	time_after_step = frame.wind->time_before(ago - 1, length);
}

void FieldMotion::start_step(const Frame &frame, const MotionOptions &options, bool with_contact) {
	is_transferred = false;
	TipContact *contact = with_contact && simulation->settings().prototypes == 0 ? &touching : nullptr;
	simulated_before = simulation->settings().prototypes > 0 ? simulation->simulated_count() : 0;
	follow_air(frame.steps.length);
	steps.start(*simulation, *textures, leans, contact, worker_count(options));
	swings.step(frame.steps.length);
}

// Reads one species in a few steps: a reading costs a microsecond, and parts follow the mean of a second.
void FieldMotion::follow_air(double step) {
	constexpr int STEPS_BETWEEN = 4;
	const size_t count = size_t(simulation->species_count());
	for (size_t i = air_speeds.size(); i < count; i++) {
		air_speeds.push_back(simulation->air_speed(int(i)));
	}
	air_speeds.resize(count);
	airs.resize(count);
	if (count > 0 && ++air_step % STEPS_BETWEEN == 0) {
		const size_t next = size_t(air_step / STEPS_BETWEEN) % count;
		air_speeds[next] = simulation->air_speed(int(next));
	}
	for (size_t i = 0; i < count; i++) {
		airs[i].step(air_speeds[i], step);
	}
	stirred = simulation->stirred_speed();
}

// Sets the bodies at `ago` seconds before this frame.
void FieldMotion::push(double ago) {
	const std::vector<MovingBody> &pushing = bodies.gather(ago);
	simulation->set_bodies(pushing.data(), int(pushing.size()));
	pushed_at.clear();
	for (const MovingBody &body : pushing) {
		pushed_at.push_back(body.from);
	}
}

// Sets the air sources, and the field's own motion through the air, `ago` seconds before this frame.
void FieldMotion::stir(const Frame &frame, const MotionOptions &options, double ago) {
	PlantWindSource3D::gather_in(frame.world, frame.axes, ago, stirring);
	simulation->set_air_sources(stirring);
	AirDrift own = drift.step(ago);
	own.share = float(options.apparent_wind);
	simulation->set_drift(own);
}

void FieldMotion::find_events(double margin) {
	const auto is_among_plants = [&](const MovingBody &body) {
		for (int page = 0; page < simulation->page_count(); page++) {
			if (touches_plants(simulation->page(page), body, float(margin))) {
				return true;
			}
		}
		return false;
	};
	const std::vector<GroupBodies::Event> found = bodies.find_events(is_among_plants);
	events.insert(events.end(), found.begin(), found.end());
}

// The last step of a frame runs beside it and is shown in the next frame. If frames are longer than a step, the earlier
// steps finish at once.
double FieldMotion::advance(const Frame &frame, const MotionOptions &options) {
	drift.watch(frame.axes, frame.delta);
	shown_alpha = frame.steps.alpha;
	if (frame.steps.count == 0) {
		return 0.0;
	}
	update_far(frame, options);
	double stepping_usec = 0.0;
	for (int i = 0; i < frame.steps.count; i++) {
		wait();
		stepping_usec += i > 0 ? steps.inline_usec() : 0.0;
		const double ago = frame.steps.ago(i);
		follow_wind(frame, i);
		stir(frame, options, ago);
		push(ago);
		if (i == 0) {
			find_events(options.touch_margin);
		}
		start_step(frame, options, touches);
	}
	return stepping_usec;
}

void FieldMotion::preview(Frame frame, const MotionOptions &options) {
	wait();
	frame.steps.count = preview_clock.advance(frame.delta);
	frame.steps.length = preview_clock.step();
	shown_alpha = preview_clock.alpha();
	if (frame.steps.count > 0) {
		simulation->set_bodies(nullptr, 0);
		PlantWindSource3D::gather_in(frame.world, frame.axes, 0.0, stirring);
		simulation->set_air_sources(stirring);
		simulation->set_drift({});
	}
	for (int i = 0; i < frame.steps.count; i++) {
		wait();
		follow_wind(frame, i);
		start_step(frame, options, false);
	}
	wait();
}

int FieldMotion::simulated_count(const PlantStore &store) const {
	if (!simulation || simulation->settings().prototypes == 0) {
		return simulation ? store.plant_count() : 0;
	}
	return steps.is_running() ? simulated_before : simulation->simulated_count();
}

double FieldMotion::bytes_per_plant(const PlantStore &store) {
	if (!simulation || store.plant_count() == 0) {
		return 0.0;
	}
	const std::array<int64_t, 4> now = { store.plant_count(), store.chunk_count(), simulation->row_count(),
		int64_t(simulation->wind().wind.kind) };
	if (std::exchange(counted, now) != now) {
		wait();
		counted_bytes = double(store.bytes()) / store.plant_count() + simulation->bytes_per_plant();
	}
	return counted_bytes;
}

bool FieldMotion::upload() {
	wait();
	const std::vector<int> &changed = simulation->changed_pages();
	dirty_pages.insert(dirty_pages.end(), changed.begin(), changed.end());
	simulation->forget_changed_pages();
	std::sort(dirty_pages.begin(), dirty_pages.end());
	dirty_pages.erase(std::unique(dirty_pages.begin(), dirty_pages.end()), dirty_pages.end());
	for (const int page : dirty_pages) {
		textures->give_seconds(*simulation, page);
		textures->write_page(*simulation, page);
	}
	dirty_pages.clear();
	const bool are_new = textures->make_textures();
	textures->upload(*simulation, shown_alpha);
	shown_at = double(simulation->step_count()) + double(shown_alpha);
	const bool are_first = textures->has_heights() && !showed_heights;
	showed_heights = textures->has_heights();
	return are_new || are_first;
}

Vector4 FieldMotion::history_of(int species) const {
	const Prototypes *models = simulation->prototypes(species);
	if (!models) {
		return Vector4(-1.0f, 0.0f, 0.0f, -1.0f);
	}
	const int second = models->modes() == 2 ? textures->history_layer(species, 1) : -1;
	return Vector4(
			float(textures->history_layer(species, 0)), float(models->newest_slot()), shown_alpha, float(second));
}

// Converts a plane of delays in the field's axes to metres of the world, for the shader.
static Vector4 world_delay(const DelayPlane &plane, const Transform3D &axes) {
	const Vector3 per_metre = axes.basis.inverse().transposed().xform(Vector3(plane.x, 0.0f, plane.z));
	return Vector4(per_metre.x, per_metre.y, per_metre.z, plane.base - per_metre.dot(axes.origin));
}

FieldMotion::Delays FieldMotion::follower_delays(const Transform3D &axes) const {
	const FollowDelays &delays = simulation->follow_delays();
	return { world_delay(delays.after(), axes), world_delay(delays.before(), axes), delays.share(shown_alpha) };
}

glm::vec4 FieldMotion::part_air(int species) const {
	const auto index = size_t(species);
	if (index >= airs.size()) {
		return glm::vec4(0.0f);
	}
	return { airs[index].speed(), stirred, airs[index].turns(), drop_chance(precipitation()) };
}

StemMotion FieldMotion::blocking_read_drawn_stem(const PlantRef &ref) const {
	const int page = rows_of(ref.chunk).page;
	StemMotion stem = simulation->shown_stem(page, row_of(ref), shown_alpha);
	const glm::vec4 air = part_air(simulation->page(page).species());
	stem.clock = swing_clock();
	stem.air = air.x;
	stem.stirred = air.y;
	stem.turns = air.z;
	stem.drops = air.w;
	return stem;
}

} // namespace undergrowth
