#include "field/view/drawn_plant.hpp"

#include "field/view/field_render_setup.hpp"
#include "placement/plants.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace undergrowth {

// Slope of a plant's x axis for a warmth of 1, and of its z axis for a lightness of 1: too small to be seen, but the
// shader reads them (undergrowth_color_of). Instances without jitter have upright axes.
static constexpr float COLOR_SLOPE = 0.0009765625f; // 2^-10.

float *DrawnPlant::write(int stride, float mesh_height, float *to) const {
	const float angle = FieldPlants::angle_of(turn);
	const float cosine = scale * std::cos(angle), sine = scale * std::sin(angle);
	const float slope = COLOR_SLOPE * scale;
	const float transform[] = { cosine, 0.0f, sine, root.x, //
		slope * FieldPlants::color_of(warmth), scale, slope * FieldPlants::color_of(lightness), root.y, //
		-sine, 0.0f, cosine, root.z };
	to = std::copy(std::begin(transform), std::end(transform), to);
	to = std::fill_n(to, stride - FieldRenderSetup::FLOATS, 1.0f); // White.
	for (const float number : { float(texel), float(layer), rank(), height / mesh_height }) {
		*to++ = number;
	}
	return to;
}

} // namespace undergrowth
