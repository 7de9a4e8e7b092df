// The division of the first build, the end of a build, and build_now().

#include "field/field_runtime.hpp"

#include "base/messages.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/os.hpp>
#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/classes/rendering_server.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr double FIRST_PLANTS = 10000.0; // Of the first part of a build.
static constexpr double MAX_WHOLE_PLANTS = 20000.0; // Up to this number a build has one part.
static constexpr float FIRST_SHARE = 0.1f; // Of the whole build's progress.
static constexpr float DRAFT_SHARE = 0.2f; // Of the progress of the first part: drafts.
static constexpr float TILES_SHARE = 0.8f; // Up to this progress tiles are built; then they are joined.
static constexpr int32_t WAITING_USEC = 100;

double FieldRuntime::budget_usec() const {
	return is_urgent() ? std::numeric_limits<double>::infinity() : 1000.0 * properties.build_budget_msec;
}

double FieldRuntime::ground_usec(double delta) const {
	return is_urgent() ? budget_usec() : std::max(GroundQueryQueue::usual_usec(delta), budget_usec());
}

FieldRuntime::Phase FieldRuntime::phase() const {
	if (sampler) {
		return Phase::sampling;
	}
	if (joins) {
		return Phase::joining;
	}
	if (job) {
		return job->places() ? Phase::placing : Phase::styling;
	}
	return tiles.is_building() ? Phase::tiles : Phase::idle;
}

float FieldRuntime::progress() const {
	const float end = streams() ? 1.0f : TILES_SHARE;
	if (phase() == Phase::joining) {
		return end + (1.0f - end) * job->progress();
	}
	if (job) {
		const float whole = (drafted ? drafted : job)->has_rest() ? FIRST_SHARE : 1.0f;
		const float begun = drafted ? DRAFT_SHARE : 0.0f;
		return whole * (begun + ((job->is_draft() ? DRAFT_SHARE : 1.0f) - begun) * job->progress());
	}
	return built_before + (end - built_before) * tiles.progress();
}

bool FieldRuntime::is_first_build() const {
	return store.generated_tiles().empty() || setup.is_draft;
}

bool FieldRuntime::may_need_drafts() const {
	return is_first_build() && !is_urgent();
}

// Measuring the errors of species takes far longer than everything else in a first build.
bool FieldRuntime::needs_drafts(const BuildInput &input) const {
	const std::vector<SpeciesStyle> &styles = input.setup.styles;
	return may_need_drafts() &&
			!std::all_of(styles.begin(), styles.end(), [](const SpeciesStyle &style) { return style.is_measured(); });
}

// The tiles nearest to the cameras are built together and shown. The remaining tiles follow, one by one.
void FieldRuntime::split_first_build(BuildInput &input) {
	if (!is_first_build()) {
		return;
	}
	const double each = double(input.request.density) * double(input.tile_size) * double(input.tile_size);
	std::vector<TileKey> all = streams() ? input.tiles : DirtyTiles::list_first(tile_scene(), input.request);
	const AreaBox box = placed_box(input.request); // Small fields meet tiles that they do not fill.
	const double of_box = double(box.high.x - box.low.x) * double(box.high.y - box.low.y);
	const double square_metres = std::min(double(std::abs(signed_area(input.request.area))), of_box);
	if (std::min(double(input.request.density) * square_metres, each * double(all.size())) <= MAX_WHOLE_PLANTS) {
		return;
	}
	const auto first = std::ptrdiff_t(std::ceil(std::min(FIRST_PLANTS / each, double(all.size()))));
	if (size_t(first) == all.size()) {
		return;
	}
	input.tiles.assign(all.begin(), all.begin() + first);
	input.rest.assign(all.begin() + first, all.end());
	input.rest_plants = each * double(input.rest.size());
	input.has_rest = input.is_of_tiles = input.draws_tiles = true;
}

void FieldRuntime::refine(std::unique_ptr<FieldBuild> &&shown) {
	drafted = std::move(shown);
	rebuild(false);
}

void FieldRuntime::follow(const FieldBuild &finished) {
	if (finished.has_rest()) {
		begin_rest(finished);
		return;
	}
	report_progress(1.0f);
	finish_build();
}

void FieldRuntime::begin_rest(const FieldBuild &finished) {
	built_before = FIRST_SHARE;
	const std::vector<TileKey> &rest = finished.rest();
	motion.make_room(finished.rest_plants(), int(rest.size() * setup.styles.size()));
	if (streams()) {
		tiles.begin_streamed_build(); // It chooses tiles again, because cameras may have moved.
	} else {
		tiles.begin_build(tile_scene(), rest, finished.request());
	}
}

void FieldRuntime::fail(const String &fault) {
	sampler.reset();
	drafted.reset();
	removed_meanwhile.clear();
	has_failed = true;
	listener.fault(fault);
	listener.failed(fault);
}

bool FieldRuntime::report_tile_fault(bool builds) {
	const String fault = std::exchange(tile_fault, String());
	if (fault.is_empty()) {
		return false;
	}
	listener.fault(fault);
	if (builds && !has_failed) { // Other tiles of the same build may fail, too.
		has_failed = true;
		listener.failed(fault);
	}
	return true;
}

void FieldRuntime::finish_build() {
	was_built = true;
	repeated.clear();
	arrived.clear();
	if (!has_failed) {
		listener.finished();
	}
}

void FieldRuntime::repeat_in_first_build(const AreaBox &box, std::function<void()> &&edit) {
	if (!was_built) {
		repeated.push_back({ box, std::move(edit) });
	}
}

void FieldRuntime::repeat_edits() {
	const std::vector<TileKey> those = std::exchange(arrived, {});
	for (const Repeated &one : repeated) {
		const auto meets = [&](const TileKey &tile) {
			const AreaBox both = common_box(one.box, tile_box(tile, store.tile_size()));
			return both.low.x <= both.high.x && both.low.y <= both.high.y;
		};
		if (std::any_of(those.begin(), those.end(), meets)) {
			one.edit();
		}
	}
}

// At exit the engine may wait forever for a thread of its pool that still works.
void FieldRuntime::wait_for_jobs() {
	if (job) {
		job->wait();
	}
	tiles.wait_for_tasks();
	clearing.wait();
}

// If physics runs on its own thread, its space may only be queried in physics frames.
bool FieldRuntime::can_query_ground() const {
	const bool casts_rays = properties.ground_mode == int(FieldGround::Kind::colliders);
	return !casts_rays || Engine::get_singleton()->is_in_physics_frame() ||
			!bool(ProjectSettings::get_singleton()->get_setting("physics/3d/run_on_separate_thread"));
}

bool FieldRuntime::build_now() {
	if (caller != Caller::none) {
		report_error(node, "build_now() is called by a handler of a signal of the same build. Call it deferred.");
		return false;
	}
	if (!can_query_ground()) {
		report_error(node,
				"build_now() cannot query colliders here, because physics runs on its own thread. Call it in "
				"_physics_process().");
		return false;
	}
	caller = Caller::build_now;
	while (node->is_inside_tree() && (is_building() || is_building_parts())) {
		poll(0.0, true);
		if (node->is_inside_tree()) {
			poll(0.0, false);
			follow_strokes(DirtyTiles::Moment::ending, 0.0);
			// Workers may wait for the renderer, and the renderer may wait for this thread.
			RenderingServer::get_singleton()->force_sync();
			OS::get_singleton()->delay_usec(WAITING_USEC);
		}
	}
	caller = Caller::none;
	const bool has_places = !streams() || !DirtyTiles::places_of(tile_scene()).empty();
	return node->is_inside_tree() && !has_failed && has_places;
}

} // namespace undergrowth
