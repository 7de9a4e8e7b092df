#include "field/build/habitat_surveyor.hpp"

#include "base/messages.hpp"
#include "base/stopwatch.hpp"
#include "field/build/build_input.hpp"
#include "field/build/field_habitats.hpp"
#include "placement/ground_light.hpp"
#include "placement/ground_moisture.hpp"

#include <godot_cpp/core/object.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr int MAX_POINTS = 192; // Along a side of the area.
static constexpr float MIN_STEP = 1.0f; // m.
// m around the area, as a fraction of its larger side: hills there cast shadows, and water comes from there.
static constexpr float MARGIN = 0.25f, MIN_MARGIN = 8.0f, MAX_MARGIN = 64.0f;
static constexpr float SQUARE = 32.0f; // m.
static constexpr int PLACES_AT_ONCE = 64;

// An area in large squares, so that painting and small changes of the area rarely need another survey.
static AreaBox squares_around(const AreaBox &area) {
	const auto down = [](float place) { return SQUARE * std::floor(place / SQUARE); };
	const auto up = [](float place) { return SQUARE * std::ceil(place / SQUARE); };
	return { { down(area.low.x), down(area.low.y) }, { up(area.high.x), up(area.high.y) } };
}

static String text_of(const Vector2 &v) {
	return String::num(v.x) + "," + String::num(v.y) + ";";
}

// Everything that decides what is sampled and where, in one text.
static String key_of(const Node3D *field, const FieldProperties &options, const AreaBox &of) {
	const AreaBox area = squares_around(of);
	const Transform3D axes = axes_of(field);
	String key = text_of({ area.low.x, area.low.y }) + text_of({ area.high.x, area.high.y });
	for (int i = 0; i < 3; i++) {
		const Vector3 axis = axes.basis.get_column(i);
		key += text_of({ axis.x, axis.y }) + text_of({ axis.z, axes.origin[i] });
	}
	key += String::num_int64(options.ground_mode) + ";" + String::num_int64(options.ground_choice) + ";" +
			String::num_int64(options.ground_collision_mask) + ";" + String(options.ground_mesh) + ";" +
			String(options.ground_object) + ";" + String::num(options.sun_latitude);
	key += habitats_use(options, HabitatFactor::moisture) ? ";moisture" : "";
	key += habitats_use(options, HabitatFactor::light) ? ";light" : "";
	for (int64_t i = 0; i < options.species.size(); i++) {
		const Ref<PlantHabitat> habitat = habitat_of(options, i);
		const bool has_value = habitat.is_valid() && habitat->uses(HabitatFactor::value);
		key += ";";
		key += has_value ? String(habitat->get_value_group()) + ":" + String(habitat->get_value_method()) + ":" +
						String::num_int64(int64_t(habitat->get_value_channel()))
						 : String();
	}
	return key;
}

bool HabitatSurveyor::is_needed(const FieldProperties &options) {
	if (!has_area(options)) {
		return false;
	}
	for (int64_t i = 0; i < options.species.size(); i++) {
		const Ref<PlantHabitat> habitat = habitat_of(options, i);
		if (habitat.is_valid() && uses_survey(habitat.ptr())) {
			return true;
		}
	}
	return false;
}

bool HabitatSurveyor::is_current(const Node3D *field, const FieldProperties &options, const AreaBox &area) const {
	return !is_needed(options) || (!found_key.is_empty() && found_key == key_of(field, options, area));
}

void HabitatSurveyor::stop() {
	why = String();
	if (work) {
		Workers::wait(work->task);
		work.reset();
	}
}

void HabitatSurveyor::fail(String fault) {
	stop();
	why = fault;
}

void HabitatSurveyor::begin(
		Node3D *field, const FieldProperties &options, const FieldGround &ground, const AreaBox &of) {
	const AreaBox area = squares_around(of);
	stop();
	work = std::make_unique<Work>();
	work->key = key_of(field, options, area);
	work->ground = ground;
	work->field = axes_of(field);
	work->finds_moisture = habitats_use(options, HabitatFactor::moisture);
	work->finds_light = habitats_use(options, HabitatFactor::light);
	work->latitude = options.sun_latitude;
	const float side = std::max(area.high.x - area.low.x, area.high.y - area.low.y);
	const float margin = std::clamp(MARGIN * side, MIN_MARGIN, MAX_MARGIN);
	work->grid = HeightGrid::around(area, margin, MAX_POINTS, MIN_STEP);
	if (ground.needs_queries()) {
		work->query = query_ground(field, options);
	} else if (ground.kind == FieldGround::Kind::none) {
		std::fill(work->grid.heights.begin(), work->grid.heights.end(), 0.0f);
	}
	if (!list_values(field, options)) {
		fail(why);
	}
}

bool HabitatSurveyor::list_values(Node3D *field, const FieldProperties &options) {
	for (int64_t i = 0; i < options.species.size(); i++) {
		const Ref<PlantHabitat> habitat = habitat_of(options, i);
		if (habitat.is_null() || !habitat->uses(HabitatFactor::value)) {
			continue;
		}
		const Object *source = find_value_source(field, options, habitat.ptr());
		if (!source) {
			why = "the habitat of species[" + String::num_int64(i) + "] has the value_method '" +
					String(habitat->get_value_method()) + "', but " +
					(habitat->get_value_group().is_empty() ? String("ground_object has no such method")
														   : "no node of the group '" +
									String(habitat->get_value_group()) + "' has it") +
					". Add the method, which gets a Vector3 and returns a number, or clear value_curve.";
			return false;
		}
		Sampled one;
		one.species = size_t(i);
		one.object = uint64_t(source->get_instance_id());
		one.method = habitat->get_value_method();
		one.channel = int(habitat->get_value_channel());
		one.raster = work->grid.raster(0.0f);
		work->sampled.push_back(std::move(one));
	}
	return true;
}

bool HabitatSurveyor::measure_some() {
	std::array<glm::vec2, PLACES_AT_ONCE> places;
	const int left = int(work->grid.size() - work->next);
	const int count = std::min({ PLACES_AT_ONCE, work->query->max_places(), left });
	for (int i = 0; i < count; i++) {
		places[size_t(i)] = work->grid.point(work->next + size_t(i));
	}
	if (!work->query->measure(places.data(), count, work->grid.heights.data() + work->next, nullptr)) {
		fail(work->query->fault());
		return false;
	}
	work->next += size_t(count);
	if (work->next == work->grid.size()) {
		work->query.reset();
		work->next = 0;
	}
	return true;
}

static bool has_number(const Variant &value) {
	const Variant::Type type = value.get_type();
	return type == Variant::BOOL || type == Variant::INT || type == Variant::FLOAT || type == Variant::VECTOR2 ||
			type == Variant::VECTOR3 || type == Variant::COLOR;
}

// Returns a component of a value that has_number().
static float number_in(const Variant &value, int channel) {
	std::array<float, 4> numbers = { 0.0f, 0.0f, 0.0f, 0.0f };
	if (value.get_type() == Variant::COLOR) {
		const Color color = value;
		numbers = { color.r, color.g, color.b, color.a };
	} else if (value.get_type() == Variant::VECTOR3) {
		const Vector3 vector = value;
		numbers = { vector.x, vector.y, vector.z, 0.0f };
	} else if (value.get_type() == Variant::VECTOR2) {
		const Vector2 vector = value;
		numbers = { vector.x, vector.y, 0.0f, 0.0f };
	} else {
		return float(double(value));
	}
	return numbers[size_t(channel)];
}

bool HabitatSurveyor::sample_some() {
	Sampled &one = work->sampled[work->sampled_count];
	for (int i = 0; i < PLACES_AT_ONCE && work->next < work->grid.size(); i++) {
		Object *source = ObjectDB::get_instance(one.object); // A call may free it.
		if (!source) {
			fail("the object of a habitat's value_method was freed during a build. Add one again.");
			return false;
		}
		const glm::vec2 place = work->grid.point(work->next);
		const float height = work->grid.heights[work->next];
		const Vector3 at = work->field.xform(Vector3(place.x, std::isfinite(height) ? height : 0.0f, place.y));
		const Variant value = source->call(one.method, at);
		if (!has_number(value)) {
			fail(String(one.method) + "() of " + describe(source) +
					" did not return a number, a Vector2, a Vector3 or a Color. Return the value of the ground at the "
					"position.");
			return false;
		}
		const float number = number_in(value, one.channel);
		one.raster.values[work->next++] = std::isfinite(number) ? number : 0.0f; // Terrains return NAN in holes.
	}
	if (work->next == work->grid.size()) {
		work->next = 0;
		work->sampled_count++;
	}
	return true;
}

void HabitatSurveyor::compute(void *self) {
	Work &all = *static_cast<Work *>(self);
	if (all.ground.kind == FieldGround::Kind::mesh) {
		FieldPlants points;
		points.resize(all.grid.size());
		for (size_t i = 0; i < all.grid.size(); i++) {
			const glm::vec2 place = all.grid.point(i);
			points.x[i] = place.x;
			points.z[i] = place.y;
		}
		std::vector<glm::vec3> normals;
		all.ground.look_up(points, all.grid.heights, normals);
	}
	if (all.finds_moisture) {
		all.made.moisture = find_moisture(all.grid);
	}
	if (all.finds_light) {
		all.made.light = find_light(all.grid, all.latitude);
	}
	for (Sampled &one : all.sampled) {
		all.made.values.resize(std::max(all.made.values.size(), one.species + 1));
		all.made.values[one.species] = std::move(one.raster);
	}
	all.is_done = true;
}

void HabitatSurveyor::finish() {
	Workers::wait(work->task);
	found = std::make_shared<HabitatSurvey>(std::move(work->made));
	found_key = work->key;
	work.reset();
}

// Rays need begin() in each frame, before the first measurement.
bool HabitatSurveyor::measure(const Stopwatch &watch, double usec, bool physics) {
	if (work->query->is_of_physics() != physics) {
		return false;
	}
	const GroundQuery::State state = work->query->begin();
	if (state == GroundQuery::State::failed) {
		fail(work->query->fault());
	}
	if (state != GroundQuery::State::ready) {
		return false;
	}
	while (work->query) {
		if (!measure_some() || (work->query && watch.usec() > usec)) {
			return false;
		}
	}
	return true;
}

void HabitatSurveyor::resume(double usec, bool physics) {
	const Stopwatch watch;
	if (!work || (work->task == Workers::NONE && work->query && !measure(watch, usec, physics))) {
		return;
	}
	if (work->task == Workers::NONE) {
		while (work->sampled_count < work->sampled.size()) {
			if (!sample_some() || watch.usec() > usec) {
				return;
			}
		}
		work->task = Workers::start(&HabitatSurveyor::compute, work.get());
	}
	if (work->is_done) {
		finish();
	}
}

} // namespace undergrowth
