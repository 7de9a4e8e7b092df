#pragma once

#include "base/stopwatch.hpp"
#include "base/workers.hpp"
#include "field/build/field_ground.hpp"
#include "field/build/ground_query.hpp"
#include "placement/habitat_survey.hpp"
#include "placement/height_grid.hpp"

#include <godot_cpp/classes/node3d.hpp>

#include <atomic>
#include <memory>
#include <vector>

namespace undergrowth {

/// Surveys the ground of a whole field for its habitats, before a build: samples heights and values on the main thread,
/// in parts, and finds moisture and light on a worker thread. The survey stays until the ground changes, so that
/// habitats can be changed at once.
class HabitatSurveyor {
public:
	HabitatSurveyor() = default;
	~HabitatSurveyor() { stop(); }
	HabitatSurveyor(const HabitatSurveyor &) = delete;
	HabitatSurveyor &operator=(const HabitatSurveyor &) = delete;

	/// True if some habitat of the field needs a survey.
	static bool is_needed(const FieldProperties &options);
	/// True if habitats of the field need no survey, or have one of this area (m, field axes).
	bool is_current(const godot::Node3D *field, const FieldProperties &options, const AreaBox &area) const;
	/// Begins a survey of an area.
	void begin(godot::Node3D *field, const FieldProperties &options, const FieldGround &ground, const AreaBox &of);
	bool is_at_work() const { return work != nullptr; }
	/// Continues for about `usec` in a frame that may be a physics frame.
	void resume(double usec, bool physics);
	/// Null: none is needed.
	const std::shared_ptr<const HabitatSurvey> &survey() const { return found; }
	/// Describes why the last survey failed, and what to do. Empty: it did not fail.
	const godot::String &fault() const { return why; }
	/// Call after a change of the ground.
	void forget() { found_key = godot::String(); }
	/// Discards a survey in progress, and its fault.
	void stop();

private:
	/// Samples of a method of an object.
	struct Sampled {
		size_t species = 0;
		uint64_t object = 0; ///< Instance id.
		godot::StringName method;
		int channel = 0;
		HabitatRaster raster;
	};

	struct Work {
		godot::String key;
		FieldGround ground;
		godot::Transform3D field;
		std::unique_ptr<GroundQuery> query; ///< Null: the ground needs none.
		HeightGrid grid;
		size_t next = 0; ///< Point of the grid, or of the first one of `sampled` that is not complete.
		std::vector<Sampled> sampled;
		size_t sampled_count = 0; ///< Complete ones.
		bool finds_moisture = false;
		bool finds_light = false;
		double latitude = 0.0; ///< rad.
		HabitatSurvey made;
		int64_t task = Workers::NONE;
		std::atomic<bool> is_done{ false };
	};

	std::unique_ptr<Work> work;
	std::shared_ptr<const HabitatSurvey> found;
	godot::String found_key; ///< Of all that `found` depends on, except the ground itself.
	godot::String why;

	static void compute(void *self);
	bool list_values(godot::Node3D *field, const FieldProperties &options);
	/// Measures all heights. Returns false if more time is needed, or if it failed.
	bool measure(const Stopwatch &watch, double usec, bool physics);
	/// Return false if they fail.
	bool measure_some();
	bool sample_some();
	void finish();
	void fail(godot::String fault);
};

} // namespace undergrowth
