#pragma once

#include "field/field_options.hpp"
#include "field/ground_query.hpp"
#include "stand/ground_grid.hpp"
#include "stand/plants.hpp"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/string.hpp>

#include <glm/vec3.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace undergrowth {

/// Finds the ground under plants, in parts. It uses a grid of heights where the ground is even between grid points, and
/// a query for each remaining plant. Main thread.
class GroundSurvey {
public:
	enum class State { going_on, done, failed };

	/// `spacing`: m between grid points; 0: a query for each plant.
	GroundSurvey(std::unique_ptr<GroundQuery> &&of, float spacing) : query(std::move(of)), grid_spacing(spacing) {}

	/// Continues for about `usec`. A failure is final.
	State go_on(const FieldPlants &plants, double usec);
	bool is_of_physics() const { return query->is_of_physics(); }
	/// Describes why it failed, and what to do.
	godot::String fault() const { return query->fault(); }
	/// What to check if no plant has ground.
	godot::String advice() const { return query->advice(); }
	bool has_found_any() const { return found_count > 0; }

	std::vector<float> heights; ///< m, field axes; NaN: no ground. One per plant when it is done.
	std::vector<glm::vec3> normals; ///< Of any length.

private:
	enum class Phase { fresh, marking, sampling, finding, querying, done };

	std::unique_ptr<GroundQuery> query;
	float grid_spacing;
	GroundGrid grid;
	bool uses_grid = false;
	int point_count = 0;
	Phase phase = Phase::fresh;
	int next = 0; ///< Next plant, grid point or entry of `single` of the phase.
	std::vector<int> single; ///< Plants that need their own query.
	int found_count = 0;

	void enter(Phase into);
	/// Does one part of a phase. Returns false if it fails.
	bool go_on_a_little(const FieldPlants &plants);
	void begin(const FieldPlants &plants);
	void mark(const FieldPlants &plants);
	bool sample();
	void find(const FieldPlants &plants);
	bool query_some(const FieldPlants &plants);
};

/// Runs ground surveys for jobs, one after the other. Main thread.
class GroundAsker {
public:
	/// Time (µs) for surveys in a frame of `delta` seconds that need not be smooth.
	static double usual_usec(double delta);
	/// Continues for about `usec` with the survey for `waiting`, a FieldFill, a FieldPatch or a TileJob, in a frame
	/// that may be a physics frame. When it is done, `waiting` continues. `tells`: warns if no ground was found.
	template <class Job>
	GroundSurvey::State serve(
			Job &waiting, godot::Node3D *field, const FieldProperties &options, double usec, bool physics, bool tells);
	/// Adds the unreported findings of `other`.
	void take_findings(GroundAsker &other);
	/// Warns if no ground was found in any survey without a report since the last call.
	void tell_of_all(const godot::Node3D *field);
	/// What to check if the last report found no ground; else empty.
	const godot::String &missing_ground() const { return missing; }
	/// Describes why it failed.
	const godot::String &fault() const { return why; }
	/// Discards the survey in progress.
	void forget() { survey.reset(); }

private:
	std::unique_ptr<GroundSurvey> survey;
	godot::String why;
	godot::String missing;
	godot::String untold; ///< Advice of surveys without a report that found no ground.
	bool has_found_some = false; ///< In surveys without a report.

	GroundSurvey::State go_on(
			const FieldPlants &plants, godot::Node3D *field, const FieldProperties &options, double usec, bool physics);
	void tell_of_no_ground(const FieldPlants &plants, const godot::Node3D *field);
	void note_ground(const FieldPlants &plants);
};

template <class Job>
GroundSurvey::State GroundAsker::serve(
		Job &waiting, godot::Node3D *field, const FieldProperties &options, double usec, bool physics, bool tells) {
	const GroundSurvey::State state = go_on(waiting.plants(), field, options, usec, physics);
	if (state == GroundSurvey::State::done) {
		if (tells) {
			tell_of_no_ground(waiting.plants(), field);
		} else {
			note_ground(waiting.plants());
		}
		waiting.go_on(std::move(survey->heights), std::move(survey->normals));
	}
	if (state != GroundSurvey::State::going_on) {
		survey.reset();
	}
	return state;
}

} // namespace undergrowth
