#include "species/species_sampling.hpp"

#include "base/convert.hpp"
#include "base/new_object.hpp"
#include "plant/base_shape.hpp"
#include "species/plant_function.hpp"

#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr double MAX_HEIGHT = 1000.0; // m. Above it floats do not resolve millimetres.
static constexpr double MAX_WIDTH = 1e6;
static constexpr double MAX_RING_EXTENT = 1e6; // m.
static constexpr int STEM_SEGMENTS = PartColors::ROWS - 1; // The functions are sampled at one more offset.

String find_level_problem(int segments) {
	if (segments >= MIN_LOD && segments <= MAX_LOD) {
		return String();
	}
	return String::num_int64(segments) + " segments cannot be built. Use " + String::num_int64(MIN_LOD) + " to " +
			String::num_int64(MAX_LOD) + " along the height.";
}

static String ring_problem(const PackedVector3Array &shape) {
	const RingFault fault = find_ring_fault(reinterpret_cast<const glm::vec3 *>(shape.ptr()), int(shape.size()));
	if (fault != RingFault::none) {
		return String("its base shape is invalid. ") + describe(fault);
	}
	for (const Vector3 &point : shape) {
		if (std::fabs(point.x) > MAX_RING_EXTENT || std::fabs(point.z) > MAX_RING_EXTENT) {
			return "its base shape is too large. Use metres, up to 1000 km.";
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

String find_height_problem(double height) {
	if (std::isfinite(height) && height >= 0.0 && height <= MAX_HEIGHT) {
		return String();
	}
	return "a height of " + String::num(height) + " m cannot be built. Use more than 0 and at most " +
			String::num(MAX_HEIGHT) + " m, or 0 for the function's own.";
}

String sample_height(PlantFunction &species, double height, int64_t seed, SampledPlant &result) {
	if (height == 0.0) {
		Ref<RandomNumberGenerator> rng = new_counted<RandomNumberGenerator>();
		rng->set_seed(uint64_t(seed));
		String problem;
		height = species.call_height(rng, problem);
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

static String sample_ring(PlantFunction &species, int segments, SampledPlant &result) {
	String problem = find_level_problem(segments);
	if (!problem.is_empty()) {
		return problem;
	}
	const PackedVector3Array shape = species.call_base_shape(segments, problem);
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

static String sample_profile(PlantFunction &species, SampledPlant &result) {
	const size_t rings = size_t(result.lod) + 1;
	result.widths.resize(rings);
	result.colors.resize(rings);
	String problem;
	for (size_t ring = 0; ring < rings; ring++) {
		const double offset = double(ring) / result.lod;
		const double width = species.call_curve_point(offset, problem);
		const Color color = species.call_color(offset, problem);
		if (!problem.is_empty()) {
			return problem;
		}
		if (!(width >= 0.0) || width > MAX_WIDTH) {
			return "_calculate_curve_point(" + String::num(offset) + ") gave " + String::num(width) +
					". Return a factor of the base shape from 0 to " + String::num(MAX_WIDTH) + ".";
		}
		if (!Vector4(color.r, color.g, color.b, color.a).is_finite()) {
			return "_calculate_color_at_point(" + String::num(offset) +
					") returned a color that is not finite. Return components from 0 to 1.";
		}
		result.widths[ring] = float(width);
		result.colors[ring] = to_glm(color);
	}
	if (!(result.widest() > 0.0f)) { // A typed override that fails returns 0, too.
		return "_calculate_curve_point() returned 0 at every height. Return a factor above 0 at some height.";
	}
	return String();
}

String sample_lathe(PlantFunction &species, double height, int segments, int64_t seed, SampledPlant &result) {
	String problem = sample_height(species, height, seed, result);
	if (problem.is_empty()) {
		problem = sample_ring(species, segments, result);
	}
	return problem.is_empty() ? sample_profile(species, result) : problem;
}

String sample_stem(PlantFunction &species, Part &into) {
	SampledPlant sampled;
	String problem = sample_ring(species, STEM_SEGMENTS, sampled);
	if (problem.is_empty()) {
		problem = sample_profile(species, sampled);
	}
	if (!problem.is_empty()) {
		return problem;
	}
	into.kind = PartKind::axis;
	into.width = 2.0f * sampled.cross_section.radius;
	into.axis.tip_diameter = into.width;
	into.axis.ring = sampled.cross_section.points;
	into.widths.samples = sampled.widths;
	into.frequency = 0.0f;
	for (const glm::vec4 &color : sampled.colors) {
		into.colors.samples.insert(into.colors.samples.end(), PartColors::COLUMNS, color);
	}
	return String::utf8(find_part_fault(into).c_str());
}

} // namespace undergrowth
