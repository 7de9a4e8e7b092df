#include "form/part.hpp"

#include "form/limits.hpp"

#include <algorithm>

namespace undergrowth {

namespace {

bool is_sound(const glm::vec4 &color) {
	const auto within = [](float component) { return component >= 0.0f && component <= 16.0f; };
	return within(color.x) && within(color.y) && within(color.z) && within(color.w);
}

std::string find_size_fault(const Part &part) {
	return find_limit_fault({ { "length", part.length_min, 1e-4, 100.0 },
			{ "length", part.length_max, part.length_min, 100.0 }, { "width", part.width, 1e-5, 10.0 },
			{ "profile", part.widths.profile.rise, 0.0, 8.0 }, { "profile", part.widths.profile.fall, 0.0, 8.0 },
			{ "base_width", part.widths.base_width, 0.0, 1.0 }, { "bend", part.curve.bend, -12.6, 12.6 },
			{ "bend_power", part.curve.power, 0.5, 4.0 }, { "wander", part.curve.wander, 0.0, 1.5 },
			{ "translucency", part.translucency, 0.0, 1.0 }, { "frequency", part.frequency, 0.0, 100.0 },
			{ "damping_ratio", part.damping_ratio, 0.0, 100.0 } });
}

std::string find_shape_fault(const Part &part) {
	const AxisShape &axis = part.axis;
	const BladeShape &blade = part.blade;
	return find_limit_fault({ { "tip_diameter", axis.tip_diameter, 0.0, 10.0 },
			{ "lobes", static_cast<double>(axis.lobes), 0.0, 64.0 }, { "lobe_depth", axis.lobe_depth, 0.0, 0.9 },
			{ "fold", blade.fold, -1.5, 1.5 }, { "roll", blade.roll, -6.0, 6.0 }, { "twist", blade.twist, -20.0, 20.0 },
			{ "wave", blade.wave, 0.0, 1.0 }, { "wave_count", blade.wave_count, 0.0, 32.0 },
			{ "teeth", static_cast<double>(blade.teeth), 0.0, 32.0 }, { "tooth_depth", blade.tooth_depth, 0.0, 0.9 },
			{ "roundness", blade.roundness, 0.0, 1.0 } });
}

std::string find_sample_fault(const Part &part) {
	const std::vector<float> &widths = part.widths.samples;
	const std::vector<glm::vec4> &colors = part.colors.samples;
	if (widths.size() == 1 || (!colors.empty() && colors.size() != PartColors::ROWS * PartColors::COLUMNS)) {
		return "its functions have too few samples. Remove the samples, or provide all of them.";
	}
	for (const float width : widths) {
		const std::string fault = find_limit_fault({ { "the width at an offset", width, 0.0, 100.0 } });
		if (!fault.empty()) {
			return fault;
		}
	}
	if (!widths.empty() && !(*std::max_element(widths.begin(), widths.end()) > 0.0f)) {
		return "its width is 0 at every offset. Set a width above 0.";
	}
	const bool all_sound = is_sound(part.colors.base) && is_sound(part.colors.tip) &&
			std::all_of(colors.begin(), colors.end(), is_sound);
	return all_sound ? std::string()
					 : "a color has a component that is negative or not finite. Use components from 0 to 1.";
}

} // namespace

glm::vec4 PartColors::at(float s, float across) const {
	if (samples.empty()) {
		return base * (1.0f - s) + tip * s;
	}
	const float row = s * (ROWS - 1);
	const float column = across * (COLUMNS - 1);
	const int i = std::clamp(static_cast<int>(row), 0, ROWS - 2);
	const int k = std::clamp(static_cast<int>(column), 0, COLUMNS - 2);
	const float t = row - static_cast<float>(i);
	const float q = column - static_cast<float>(k);
	const glm::vec4 *from = samples.data() + i * COLUMNS + k;
	const glm::vec4 lower = from[0] * (1.0f - q) + from[1] * q;
	const glm::vec4 upper = from[COLUMNS] * (1.0f - q) + from[COLUMNS + 1] * q;
	return lower * (1.0f - t) + upper * t;
}

Venation venation_of(const Part &part) {
	static constexpr float NARROW = 0.12f; // Width over length of a leaf with parallel veins.
	if (part.venation != Venation::automatic) {
		return part.venation;
	}
	if (part.kind != PartKind::blade) {
		return part.kind == PartKind::axis && part.axis.open_tip ? Venation::radial : Venation::none;
	}
	const glm::vec4 color = part.colors.at(0.6f, 0.5f);
	if (color.y < std::max(color.x, color.z)) {
		return Venation::radial;
	}
	return part.width < NARROW * part.mean_length() ? Venation::parallel : Venation::pinnate;
}

std::string find_part_fault(const Part &part) {
	std::string fault = find_size_fault(part);
	if (fault.empty()) {
		fault = find_shape_fault(part);
	}
	return fault.empty() ? find_sample_fault(part) : fault;
}

} // namespace undergrowth
