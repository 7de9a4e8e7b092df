#pragma once

#include "field/resources/field_options.hpp"
#include "field/build/ground_query.hpp"
#include "placement/ground_grid.hpp"
#include "placement/plants.hpp"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/string.hpp>

#include <glm/vec3.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace undergrowth {

/// Finds the ground under plants, in parts. It uses a grid of heights where the ground is even between grid points, and
/// a query for each remaining plant. Main thread.
class GroundSampler {
public:
	enum class State { in_progress, done, failed };

	/// `spacing`: m between grid points; 0: a query for each plant.
	GroundSampler(std::unique_ptr<GroundQuery> &&of, float spacing) : query(std::move(of)), grid_spacing(spacing) {}

	/// Continues for about `usec`. A failure is final.
	State resume(const FieldPlants &plants, double usec);
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
	bool resume_part(const FieldPlants &plants);
	void begin(const FieldPlants &plants);
	void mark(const FieldPlants &plants);
	bool sample();
	void find(const FieldPlants &plants);
	bool query_some(const FieldPlants &plants);
};

/// Runs ground queries for jobs, one after the other. Main thread.
class GroundQueryQueue {
public:
	/// Time (µs) for queries in a frame of `delta` seconds that need not be smooth.
	static double usual_usec(double delta);
	/// Continues for about `usec` with the query for `waiting`, a FieldBuild or a TileBuildTask, in a frame
	/// that may be a physics frame. When it is done, `waiting` continues. `reports`: warns if no ground was found.
	template <class Job>
	GroundSampler::State serve(Job &waiting, godot::Node3D *field, const FieldProperties &options, double usec,
			bool physics, bool reports);
	/// Adds the unreported findings of `other`.
	void take_findings(GroundQueryQueue &other);
	/// Warns if no ground was found in any query without a report since the last call.
	void report_all(const godot::Node3D *field);
	/// What to check if the last report found no ground; else empty.
	const godot::String &missing_ground() const { return missing; }
	/// Describes why it failed.
	const godot::String &fault() const { return why; }
	/// Discards the query in progress.
	void forget() { sampler.reset(); }

private:
	std::unique_ptr<GroundSampler> sampler;
	godot::String why;
	godot::String missing;
	godot::String unreported; ///< Advice of queries without a report that found no ground.
	bool has_found_some = false; ///< In queries without a report.

	GroundSampler::State resume(
			const FieldPlants &plants, godot::Node3D *field, const FieldProperties &options, double usec, bool physics);
	void report_no_ground(const FieldPlants &plants, const godot::Node3D *field);
	void note_ground(const FieldPlants &plants);
};

template <class Job>
GroundSampler::State GroundQueryQueue::serve(
		Job &waiting, godot::Node3D *field, const FieldProperties &options, double usec, bool physics, bool reports) {
	const GroundSampler::State state = resume(waiting.plants(), field, options, usec, physics);
	if (state == GroundSampler::State::done) {
		if (reports) {
			report_no_ground(waiting.plants(), field);
		} else {
			note_ground(waiting.plants());
		}
		waiting.resume(std::move(sampler->heights), std::move(sampler->normals));
	}
	if (state != GroundSampler::State::in_progress) {
		sampler.reset();
	}
	return state;
}

} // namespace undergrowth
