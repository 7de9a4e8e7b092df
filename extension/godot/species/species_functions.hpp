#pragma once

#include "base/convert.hpp"
#include "base/shortest_decimal.hpp"
#include "plant/species/bellflower.hpp"
#include "plant/species/cattail.hpp"
#include "plant/species/grass.hpp"
#include "plant/species/reed.hpp"
#include "plant/species/tulip.hpp"
#include "species/plant_function.hpp"

namespace undergrowth {

/// A plant function with the four functions of a species of the core. It is not a class of the engine.
template <typename Species> class SpeciesFunction : public PlantFunction {
protected:
	Species species;

	SpeciesFunction() { adopt_motion(Species::motion()); }

	void set_part_color(glm::vec4 &part, const godot::Color &color) {
		if (to_glm(color) != part) {
			part = to_glm(color);
			shape_changed();
		}
	}

	void set_part_size(float &part, const char *property, double metres) {
		if (accept_value(this, property, metres, { 0.0001, 10.0 }) && float(metres) != part) {
			part = float(metres);
			shape_changed();
		}
	}

	godot::PackedVector3Array own_base_shape(int lod) const override {
		godot::PackedVector3Array points;
		for (const glm::vec2 &point : species.base_shape(lod)) {
			points.push_back(godot::Vector3(point.x, 0.0f, point.y));
		}
		return points;
	}

	double own_height(const godot::Ref<godot::RandomNumberGenerator> &rng) const override {
		// Half open, as Math.random() is in the thesis.
		const double share = double(rng->randi()) / 4294967296.0;
		return Species::heights.min + share * (double(Species::heights.max) - Species::heights.min);
	}

	double own_curve_point(double offset) const override { return species.width(float(offset)); }
	godot::Color own_color(double offset) const override { return to_godot(species.color(float(offset))); }
};

// Setter and getter of one property of a species.
#define UNDERGROWTH_PART_COLOR(m_part)                                                                                 \
	void set_##m_part(const godot::Color &color) {                                                                     \
		set_part_color(species.m_part, color);                                                                         \
	}                                                                                                                  \
	godot::Color get_##m_part() const {                                                                                \
		return to_godot(species.m_part);                                                                               \
	}
#define UNDERGROWTH_PART_SIZE(m_part)                                                                                  \
	void set_##m_part(double metres) {                                                                                 \
		set_part_size(species.m_part, #m_part, metres);                                                                \
	}                                                                                                                  \
	double get_##m_part() const {                                                                                      \
		return shortest_decimal(species.m_part);                                                                       \
	}

class GrassFunction : public SpeciesFunction<Grass> {
	GDCLASS(GrassFunction, PlantFunction)

protected:
	static void _bind_methods();

public:
	UNDERGROWTH_PART_COLOR(root_color)
	UNDERGROWTH_PART_COLOR(middle_color)
	UNDERGROWTH_PART_COLOR(tip_color)
	UNDERGROWTH_PART_SIZE(blade_width)
};

class ReedFunction : public SpeciesFunction<Reed> {
	GDCLASS(ReedFunction, PlantFunction)

protected:
	static void _bind_methods();

public:
	UNDERGROWTH_PART_COLOR(stem_color)
	UNDERGROWTH_PART_COLOR(joint_color)
	UNDERGROWTH_PART_COLOR(plume_color)
	UNDERGROWTH_PART_COLOR(plume_tip_color)
	UNDERGROWTH_PART_SIZE(stem_radius)
};

class CattailFunction : public SpeciesFunction<Cattail> {
	GDCLASS(CattailFunction, PlantFunction)

protected:
	static void _bind_methods();

public:
	UNDERGROWTH_PART_COLOR(stem_color)
	UNDERGROWTH_PART_COLOR(head_color)
	UNDERGROWTH_PART_COLOR(spike_color)
	UNDERGROWTH_PART_SIZE(stem_radius)
};

class TulipFunction : public SpeciesFunction<Tulip> {
	GDCLASS(TulipFunction, PlantFunction)

protected:
	static void _bind_methods();

public:
	UNDERGROWTH_PART_COLOR(stem_color)
	UNDERGROWTH_PART_COLOR(flower_color)
};

class BellflowerFunction : public SpeciesFunction<Bellflower> {
	GDCLASS(BellflowerFunction, PlantFunction)

protected:
	static void _bind_methods();

public:
	UNDERGROWTH_PART_COLOR(stem_color)
	UNDERGROWTH_PART_COLOR(bell_color)
	UNDERGROWTH_PART_COLOR(rim_color)
	UNDERGROWTH_PART_SIZE(bell_radius)
};

#undef UNDERGROWTH_PART_COLOR
#undef UNDERGROWTH_PART_SIZE

} // namespace undergrowth
