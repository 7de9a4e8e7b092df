#pragma once

#include "species/plant_function.hpp"

#include <godot_cpp/classes/curve.hpp>
#include <godot_cpp/classes/gradient.hpp>

namespace undergrowth {

/// A species without code: a selected cross-section, a curve for the width, a gradient for the color and a height
/// range.
class CurvePlantFunction : public PlantFunction {
	GDCLASS(CurvePlantFunction, PlantFunction)

public:
	enum CrossSection : int64_t {
		CROSS_SECTION_CIRCLE,
		CROSS_SECTION_PARALLELOGRAM,
		CROSS_SECTION_LOBED,
	};

private:
	CrossSection cross_section = CROSS_SECTION_CIRCLE;
	float radius = 0.05f; // m.
	int lobes = 5;
	float lobe_depth = 0.25f;
	godot::Ref<godot::Curve> width_curve;
	godot::Ref<godot::Gradient> color_gradient;
	float height_min = 0.5f; // m.
	float height_max = 1.0f; // m.

	void set_size(float &slot, const char *property, double value, const Range &range);
	/// Replaces `slot` with `part` and connects to its changes.
	template <typename Part> void follow(godot::Ref<Part> &slot, const godot::Ref<Part> &part);
	void on_part_changed();

protected:
	static void _bind_methods();
	void _validate_property(godot::PropertyInfo &property) const;
	godot::PackedVector3Array own_base_shape(int lod) const override;
	double own_height(const godot::Ref<godot::RandomNumberGenerator> &rng) const override;
	double own_curve_point(double offset) const override;
	godot::Color own_color(double offset) const override;

public:
	void set_cross_section(CrossSection shape);
	CrossSection get_cross_section() const;
	void set_radius(double metres);
	double get_radius() const;
	void set_lobes(int count);
	int get_lobes() const;
	void set_lobe_depth(double depth);
	double get_lobe_depth() const;
	void set_width_curve(const godot::Ref<godot::Curve> &curve);
	godot::Ref<godot::Curve> get_width_curve() const;
	void set_color_gradient(const godot::Ref<godot::Gradient> &gradient);
	godot::Ref<godot::Gradient> get_color_gradient() const;
	void set_height_min(double metres);
	double get_height_min() const;
	void set_height_max(double metres);
	double get_height_max() const;
};

} // namespace undergrowth

VARIANT_ENUM_CAST(undergrowth::CurvePlantFunction::CrossSection);
