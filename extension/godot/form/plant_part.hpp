#pragma once

#include "base/messages.hpp"
#include "form/part.hpp"

#include <godot_cpp/classes/curve.hpp>
#include <godot_cpp/classes/gradient.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/gdvirtual.gen.inc>
#include <godot_cpp/variant/dictionary.hpp>

namespace undergrowth {

/// A kind of part of a plant, with a width along it and colors along and across it, in the spirit of the thesis's
/// functions. PlantAxis, PlantBlade and PlantBead are the kinds (form/part.hpp). Setters emit `changed` once for each
/// real change, never for the present value.
class PlantPart : public godot::Resource {
	GDCLASS(PlantPart, godot::Resource)

	godot::Ref<godot::Curve> width_curve;
	godot::Ref<godot::Gradient> gradient;

	void follow(godot::Resource *before, godot::Resource *now);
	godot::String call_widths(Part &into);
	godot::String call_colors(Part &into);

protected:
	Part part;

	static void _bind_methods();
	void change_number(float &slot, const char *property, double value, const Range &range);
	void change_angle(float &slot, const char *property, double radians, const Range &degrees);
	void change_count(int &slot, const char *property, int value, const Range &range);

	GDVIRTUAL1R(double, _calculate_width, double)
	GDVIRTUAL2R(godot::Color, _calculate_color, double, double)

public:
	enum Venation : int64_t {
		VENATION_AUTOMATIC,
		VENATION_NONE,
		VENATION_PARALLEL,
		VENATION_PINNATE,
		VENATION_PALMATE,
		VENATION_RADIAL,
	};

	/// Samples the part and its functions for the core. Main thread. Returns what is wrong and what to do, or an empty
	/// string.
	godot::String read(Part &into);
	/// Sets properties by their names. A name that does not exist is an error.
	void set_all(const godot::Dictionary &values);
	// Called by the engine.
	void on_function_changed();

	void set_length(const godot::Vector2 &metres);
	godot::Vector2 get_length() const;
	void set_width_curve(const godot::Ref<godot::Curve> &curve);
	godot::Ref<godot::Curve> get_width_curve() const;
	void set_base_color(const godot::Color &color);
	godot::Color get_base_color() const;
	void set_tip_color(const godot::Color &color);
	godot::Color get_tip_color() const;
	void set_gradient(const godot::Ref<godot::Gradient> &colors);
	godot::Ref<godot::Gradient> get_gradient() const;
	void set_translucency(double share);
	double get_translucency() const;
	void set_venation(Venation kind);
	Venation get_venation() const { return Venation(part.venation); }
	void set_frequency(double hertz);
	double get_frequency() const;
	void set_damping_ratio(double ratio);
	double get_damping_ratio() const;
};

/// Returns an angle (rad) of the core, in single precision, as the user wrote it in degrees.
double written_angle(float radians);

// Setter and getter of one property of the core's part: a number, a count or an angle.
#define UNDERGROWTH_NUMBER(m_name, m_slot, m_min, m_max)                                                               \
	void set_##m_name(double value) {                                                                                  \
		change_number(m_slot, #m_name, value, { m_min, m_max });                                                       \
	}                                                                                                                  \
	double get_##m_name() const {                                                                                      \
		return shortest_decimal(m_slot);                                                                               \
	}
#define UNDERGROWTH_COUNT(m_name, m_slot, m_min, m_max)                                                                \
	void set_##m_name(int value) {                                                                                     \
		change_count(m_slot, #m_name, value, { m_min, m_max });                                                        \
	}                                                                                                                  \
	int get_##m_name() const {                                                                                         \
		return m_slot;                                                                                                 \
	}
#define UNDERGROWTH_ANGLE(m_name, m_slot, m_min, m_max)                                                                \
	void set_##m_name(double radians) {                                                                                \
		change_angle(m_slot, #m_name, radians, { m_min, m_max });                                                      \
	}                                                                                                                  \
	double get_##m_name() const {                                                                                      \
		return written_angle(m_slot);                                                                                  \
	}

} // namespace undergrowth

VARIANT_ENUM_CAST(undergrowth::PlantPart::Venation);
