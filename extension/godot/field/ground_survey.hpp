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

/// Finds the ground under plants, a part of them at a time: from a grid of heights where the ground is even between its
/// points, else by a query for each plant.
class GroundSurvey {
public:
	enum class State { going_on, done, failed };

	/// `spacing`: m between heights of the grid; 0: a query for each plant.
	GroundSurvey(std::unique_ptr<GroundQuery> &&of, float spacing) : query(std::move(of)), grid_spacing(spacing) {}

	/// Goes on for about `usec`. Once it has failed, it stays so.
	State go_on(const FieldPlants &plants, double usec);
	bool is_of_physics() const { return query->is_of_physics(); }
	/// Why it failed, and what to do.
	godot::String fault() const { return query->fault(); }
	/// What to check where none of the plants has ground.
	godot::String advice() const { return query->advice(); }
	bool has_found_any() const { return found_count > 0; }

	std::vector<float> heights; ///< m, field axes; NaN where there is no ground. As many as plants once it is done.
	std::vector<glm::vec3> normals; ///< Of any length.

private:
	enum class Phase { fresh, marking, sampling, finding, querying, done };

	std::unique_ptr<GroundQuery> query;
	float grid_spacing;
	GroundGrid grid;
	bool uses_grid = false;
	int point_count = 0;
	Phase phase = Phase::fresh;
	int next = 0; ///< Of the phase: a plant, a point, or an entry of `single`.
	std::vector<int> single; ///< Plants that need a query of their own.
	int found_count = 0;

	void enter(Phase into);
	/// One part of a phase. False: it has failed.
	bool go_on_a_little(const FieldPlants &plants);
	void begin(const FieldPlants &plants);
	void mark(const FieldPlants &plants);
	bool sample();
	void find(const FieldPlants &plants);
	bool query_some(const FieldPlants &plants);
};

/// The survey that goes on for those who wait for the ground, one after the other.
class GroundAsker {
public:
	/// So long (µs) it may take in a frame of `delta` s, in which nothing else need be smooth.
	static double usual_usec(double delta);
	/// Goes on for about `usec` with what `waiting`, a FieldFill, a FieldPatch or a TileJob, waits for, in a frame that
	/// may be one of physics. Once it is done, `waiting` goes on. Where no ground was found it tells where `tells`.
	template <class Job>
	GroundSurvey::State serve(
			Job &waiting, godot::Node3D *field, const FieldProperties &options, double usec, bool physics, bool tells);
	/// Adds what `other` found and has not reported.
	void take_findings(GroundAsker &other);
	/// Of what did not tell since the last time: tells where no ground was found under any of them.
	void tell_of_all(const godot::Node3D *field);
	/// What to check, where no ground was found under any of those of whom was told last; else empty.
	const godot::String &missing_ground() const { return missing; }
	/// Why it failed.
	const godot::String &fault() const { return why; }
	/// Nobody waits for it any more.
	void forget() { survey.reset(); }

private:
	std::unique_ptr<GroundSurvey> survey;
	godot::String why;
	godot::String missing;
	godot::String untold; ///< The advice for what did not tell, where it found no ground.
	bool has_found_some = false; ///< Under what did not tell.

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
