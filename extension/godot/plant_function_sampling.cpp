// The half of PlantFunction that asks the four functions and turns their answers into a mesh.

#include "plant_function.hpp"

#include "convert.hpp"
#include "new_object.hpp"
#include "plant/base_shape.hpp"
#include "script_call.hpp"

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr double MAX_HEIGHT = 1000.0; // m. Beyond that a float's millimetres are gone.
static constexpr double MAX_WIDTH = 1e6;
static constexpr double MAX_RING_EXTENT = 1e6; // m.

Variant PlantFunction::call_override(
		const StringName &method, const Variant &argument, Variant::Type wanted, String &problem) {
	Array arguments;
	arguments.push_back(argument);
	return call_script_override(this, method, arguments, wanted, problem);
}

PackedVector3Array PlantFunction::own_base_shape(int lod) const {
	PackedVector3Array points;
	for (const glm::vec2 &point : circle_ring(lod)) {
		points.push_back(Vector3(point.x, 0.0f, point.y));
	}
	return points;
}

double PlantFunction::own_height(const Ref<RandomNumberGenerator> &) const {
	return 1.0;
}

double PlantFunction::own_curve_point(double offset) const {
	return 0.1 * (1.0 - offset);
}

Color PlantFunction::own_color(double) const {
	return Color(0.2f, 0.85f, 0.2f);
}

PackedVector3Array PlantFunction::get_base_shape(int lod) {
	if (!GDVIRTUAL_IS_OVERRIDDEN(_get_base_shape)) {
		return own_base_shape(std::clamp(lod, MIN_LOD, MAX_LOD));
	}
	String problem;
	const Variant shape = call_override("_get_base_shape", lod, Variant::PACKED_VECTOR3_ARRAY, problem);
	if (!problem.is_empty()) {
		report_error(this, problem);
	}
	return shape;
}

double PlantFunction::generate_height(const Ref<RandomNumberGenerator> &rng) {
	if (rng.is_null()) {
		report_error(this, "generate_height() needs a RandomNumberGenerator. Pass RandomNumberGenerator.new().");
		return 0.0;
	}
	if (!GDVIRTUAL_IS_OVERRIDDEN(_generate_height)) {
		return own_height(rng);
	}
	String problem;
	const Variant height = call_override("_generate_height", rng, Variant::FLOAT, problem);
	if (!problem.is_empty()) {
		report_error(this, problem);
		return 0.0;
	}
	return height;
}

double PlantFunction::calculate_curve_point(double offset) {
	if (!GDVIRTUAL_IS_OVERRIDDEN(_calculate_curve_point)) {
		return own_curve_point(offset);
	}
	String problem;
	const Variant width = call_override("_calculate_curve_point", offset, Variant::FLOAT, problem);
	if (!problem.is_empty()) {
		report_error(this, problem);
		return 0.0;
	}
	return width;
}

Color PlantFunction::calculate_color_at_point(double offset) {
	if (!GDVIRTUAL_IS_OVERRIDDEN(_calculate_color_at_point)) {
		return own_color(offset);
	}
	String problem;
	const Variant color = call_override("_calculate_color_at_point", offset, Variant::COLOR, problem);
	if (!problem.is_empty()) {
		report_error(this, problem);
		return Color();
	}
	return color;
}

static bool is_level(int segments) {
	return segments >= MIN_LOD && segments <= MAX_LOD;
}

static String level_problem(int segments) {
	return String::num_int64(segments) + " segments cannot be built. Use " + String::num_int64(MIN_LOD) + " to " +
			String::num_int64(MAX_LOD) + " along the height.";
}

static String ring_problem(const PackedVector3Array &shape) {
	const RingFault fault = find_ring_fault(reinterpret_cast<const glm::vec3 *>(shape.ptr()), int(shape.size()));
	if (fault != RingFault::none) {
		return String("its base shape is unusable. ") + describe(fault);
	}
	for (const Vector3 &point : shape) {
		if (std::fabs(point.x) > MAX_RING_EXTENT || std::fabs(point.z) > MAX_RING_EXTENT) {
			return "its base shape is too large. Use metres; a plant is narrower than 1000 km.";
		}
	}
	return String();
}

static CrossSection cross_section_of(const PackedVector3Array &shape) {
	std::vector<glm::vec2> ring;
	ring.reserve(size_t(shape.size()));
	for (const Vector3 &point : shape) {
		ring.emplace_back(point.x, point.z);
	}
	return make_cross_section(ring);
}

String PlantFunction::find_height_problem(double height) {
	if (std::isfinite(height) && height >= 0.0 && height <= MAX_HEIGHT) {
		return String();
	}
	return "a height of " + String::num(height) + " m cannot be built. Use more than 0 and at most " +
			String::num(MAX_HEIGHT) + " m, or 0 for the function's own.";
}

String PlantFunction::sample_height(double height, int64_t seed, SampledPlant &result) {
	if (height == 0.0) {
		Ref<RandomNumberGenerator> rng = new_counted<RandomNumberGenerator>();
		rng->set_seed(uint64_t(seed));
		String problem;
		height = GDVIRTUAL_IS_OVERRIDDEN(_generate_height)
				? double(call_override("_generate_height", rng, Variant::FLOAT, problem))
				: own_height(rng);
		if (!problem.is_empty()) {
			return problem;
		}
		if (!(height > 0.0)) {
			return "_generate_height() gave " + String::num(height) + ". Return metres above 0.";
		}
	}
	result.height = float(height);
	return find_height_problem(height);
}

String PlantFunction::sample_ring(int segments, SampledPlant &result) {
	if (!is_level(segments)) {
		return level_problem(segments);
	}
	String problem;
	const PackedVector3Array shape = GDVIRTUAL_IS_OVERRIDDEN(_get_base_shape)
			? PackedVector3Array(call_override("_get_base_shape", segments, Variant::PACKED_VECTOR3_ARRAY, problem))
			: own_base_shape(segments);
	if (problem.is_empty()) {
		problem = ring_problem(shape);
	}
	if (!problem.is_empty()) {
		return problem;
	}
	result.lod = segments;
	result.cross_section = cross_section_of(shape);
	return String();
}

String PlantFunction::sample_profile(SampledPlant &result) {
	const bool script_width = GDVIRTUAL_IS_OVERRIDDEN(_calculate_curve_point);
	const bool script_color = GDVIRTUAL_IS_OVERRIDDEN(_calculate_color_at_point);
	const size_t rings = size_t(result.lod) + 1;
	result.widths.resize(rings);
	result.colors.resize(rings);
	String problem;
	for (size_t ring = 0; ring < rings; ring++) {
		const double offset = double(ring) / result.lod;
		const double width = script_width
				? double(call_override("_calculate_curve_point", offset, Variant::FLOAT, problem))
				: own_curve_point(offset);
		const Color color = script_color
				? Color(call_override("_calculate_color_at_point", offset, Variant::COLOR, problem))
				: own_color(offset);
		if (!problem.is_empty()) {
			return problem;
		}
		if (!(width >= 0.0) || width > MAX_WIDTH) {
			return "_calculate_curve_point(" + String::num(offset) + ") gave " + String::num(width) +
					". Return a factor of the base shape from 0 to " + String::num(MAX_WIDTH) + ".";
		}
		if (!Vector4(color.r, color.g, color.b, color.a).is_finite()) {
			return "_calculate_color_at_point(" + String::num(offset) +
					") gave a color that is not finite. Return components from 0 to 1.";
		}
		result.widths[ring] = float(width);
		result.colors[ring] = to_glm(color);
	}
	if (!(result.widest() > 0.0f)) { // Which a typed override returns that fails, too.
		return "_calculate_curve_point() gave 0 at every height. Return a factor of the base shape above 0 somewhere.";
	}
	return String();
}

String PlantFunction::sample(double height, int segments, int64_t seed, SampledPlant &result) {
	result.options = look;
	result.options.seed = uint64_t(seed);
	result.material = material;
	result.grown.reset();
	if (has_parts()) {
		result.lod = segments;
		return is_level(segments) ? sample_parts(height, seed, result) : level_problem(segments);
	}
	String problem = sample_height(height, seed, result);
	if (problem.is_empty()) {
		problem = sample_ring(segments, result);
	}
	return problem.is_empty() ? sample_profile(result) : problem;
}

String PlantFunction::find_problem(double height, int segments, int64_t seed) {
	SampledPlant sampled;
	return sample(height, segments, seed, sampled);
}

Ref<ArrayMesh> PlantFunction::generate_mesh(double height, int segments, int64_t seed) {
	SampledPlant sampled;
	const String problem = sample(height, segments, seed, sampled);
	if (!problem.is_empty()) {
		report_error(this, problem);
		return Ref<ArrayMesh>();
	}
	return sampled.build();
}

} // namespace undergrowth
