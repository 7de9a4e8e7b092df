#pragma once

#include "base/shortest_decimal.hpp"
#include "form/arrangement.hpp"
#include "form/growth.hpp"
#include "form/plant_part.hpp"

#include <godot_cpp/classes/curve.hpp>
#include <godot_cpp/variant/typed_array.hpp>
#include <godot_cpp/variant/vector2i.hpp>

namespace undergrowth {

/// Positions and number of the parts of one kind on their carrier, and the arrangements that these parts carry
/// (form/arrangement.hpp).
class PlantArrangement : public godot::Resource {
	GDCLASS(PlantArrangement, godot::Resource)

public:
	enum ArrangementLayout : int64_t {
		LAYOUT_ALONG = int(Layout::along),
		LAYOUT_WHORL = int(Layout::whorl),
		LAYOUT_DISC = int(Layout::disc),
		LAYOUT_GROUND = int(Layout::ground),
	};

private:
	Arrangement arrangement;
	godot::Ref<PlantPart> part;
	godot::Ref<godot::Curve> angle_curve;
	godot::Ref<godot::Curve> scale_curve;
	godot::Array carries; // Of PlantArrangement.
	bool visible = true;
	bool is_reporting = false; // A change is being reported; stops arrangements that carry themselves.

	void report_change();
	void follow(godot::Resource *before, godot::Resource *now);
	void change_number(float &slot, const char *property, double value, const Range &range);
	void change_angle(float &slot, const char *property, double radians, const Range &degrees);
	void set_span(Span &slot, const char *property, const godot::Vector2 &value, const Range &range);
	void set_angles(Span &slot, const char *property, const godot::Vector2 &radians);
	godot::String own_problem(const godot::String &what) const;

protected:
	static void _bind_methods();
	void _validate_property(godot::PropertyInfo &property) const;

public:
	static godot::Ref<PlantArrangement> of(const godot::Dictionary &values);
	/// Appends this arrangement and all that it carries to a recipe, as lines on line `on`. The ids of the recipe's
	/// parts are in `known`. Main thread. Returns what is wrong and what to do, or an empty string.
	godot::String read(Recipe &recipe, int on, int depth, std::vector<uint64_t> &known);
	/// Returns the arrangement for the core.
	Arrangement described() const;
	// Called by the engine.
	void on_changed();

	void set_layout(ArrangementLayout layout);
	ArrangementLayout get_layout() const { return ArrangementLayout(int64_t(arrangement.layout)); }
	void set_visible(bool shown);
	bool get_visible() const { return visible; }
	void set_part(const godot::Ref<PlantPart> &kind);
	godot::Ref<PlantPart> get_part() const { return part; }
	void set_count(const godot::Vector2i &range);
	godot::Vector2i get_count() const { return godot::Vector2i(arrangement.count_min, arrangement.count_max); }
	void set_per_node(int count);
	int get_per_node() const { return arrangement.per_node; }
	void set_level_tops(bool level);
	bool get_level_tops() const { return arrangement.level_tops; }
	void set_flat(bool flat);
	bool get_flat() const { return arrangement.flat; }
	void set_angle_curve(const godot::Ref<godot::Curve> &curve);
	godot::Ref<godot::Curve> get_angle_curve() const { return angle_curve; }
	void set_scale_curve(const godot::Ref<godot::Curve> &curve);
	godot::Ref<godot::Curve> get_scale_curve() const { return scale_curve; }
	void set_carries(const godot::TypedArray<PlantArrangement> &others);
	godot::TypedArray<PlantArrangement> get_carries() const { return godot::TypedArray<PlantArrangement>(carries); }
	void set_angle(const godot::Vector2 &radians) { set_angles(arrangement.angle, "angle", radians); }
	godot::Vector2 get_angle() const;
	void set_tilt(const godot::Vector2 &radians) { set_angles(arrangement.tilt, "tilt", radians); }
	godot::Vector2 get_tilt() const;
	void set_scale(const godot::Vector2 &factors) { set_span(arrangement.scale, "scale", factors, { 1e-3, 1e3 }); }
	godot::Vector2 get_scale() const { return godot::Vector2(arrangement.scale.first, arrangement.scale.last); }
	UNDERGROWTH_NUMBER(from, arrangement.from, 0.0, 1.0)
	UNDERGROWTH_NUMBER(to, arrangement.to, 0.0, 1.0)
	UNDERGROWTH_NUMBER(swept, arrangement.swept, 0.0, 1.0)
	UNDERGROWTH_NUMBER(radius, arrangement.radius, 0.0, 10.0)
	UNDERGROWTH_ANGLE(turn, arrangement.turn, -36000.0, 36000.0)
	UNDERGROWTH_ANGLE(phase, arrangement.phase, -36000.0, 36000.0)
	UNDERGROWTH_ANGLE(dome, arrangement.dome, 0.0, 180.0)
	UNDERGROWTH_ANGLE(deviation, arrangement.deviation, 0.0, 85.0)
};

} // namespace undergrowth

VARIANT_ENUM_CAST(undergrowth::PlantArrangement::ArrangementLayout);
