#pragma once

#include <godot_cpp/classes/curve.hpp>
#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/random_number_generator.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/gdvirtual.gen.inc>
#include <godot_cpp/variant/packed_vector3_array.hpp>

namespace probe {

// Every kind of property that is saved, and one method to override per type of argument and result.
class ProbeResource : public godot::Resource {
	GDCLASS(ProbeResource, godot::Resource)

public:
	enum Kind {
		KIND_PLAIN,
		KIND_ROUND = 5,
	};
	enum Parts {
		PART_STEM = 1,
		PART_LEAF = 2,
	};

private:
	Kind kind = KIND_PLAIN;
	int count = 3;
	double ratio = 0.5;
	godot::String label = "none";
	godot::Color tint;
	godot::Ref<godot::Curve> curve;
	godot::PackedVector3Array points;

protected:
	static void _bind_methods();
	bool _property_can_revert(const godot::StringName &p_name) const;
	bool _property_get_revert(const godot::StringName &p_name, godot::Variant &r_value) const;
	void _validate_property(godot::PropertyInfo &r_property) const;

	GDVIRTUAL1R(bool, _get_flag, bool)
	GDVIRTUAL1R(int, _get_count, int)
	GDVIRTUAL1RC(double, _get_ratio, double)
	GDVIRTUAL1R(float, _get_width, float)
	GDVIRTUAL1R(godot::String, _get_label, godot::String)
	GDVIRTUAL1R(godot::Color, _get_tint, godot::Color)
	GDVIRTUAL2R(godot::Vector3, _get_direction, godot::Vector3, double)
	GDVIRTUAL1R(godot::PackedVector3Array, _get_points, godot::PackedVector3Array)
	GDVIRTUAL1R(godot::Ref<godot::Resource>, _get_resource, godot::Ref<godot::RandomNumberGenerator>)
	GDVIRTUAL1R(godot::Node *, _get_node, godot::Node *)
	GDVIRTUAL0R(godot::Variant, _get_anything)
	GDVIRTUAL1(_note, godot::String)

public:
	void set_kind(Kind p_kind);
	Kind get_kind() const { return kind; }
	void set_count(int p_count);
	int get_count() const { return count; }
	void set_ratio(double p_ratio) { ratio = p_ratio; }
	double get_ratio() const { return ratio; }
	void set_label(const godot::String &p_label) { label = p_label; }
	godot::String get_label() const { return label; }
	void set_tint(const godot::Color &p_tint) { tint = p_tint; }
	godot::Color get_tint() const { return tint; }
	void set_curve(const godot::Ref<godot::Curve> &p_curve) { curve = p_curve; }
	godot::Ref<godot::Curve> get_curve() const { return curve; }
	void set_points(const godot::PackedVector3Array &p_points) { points = p_points; }
	godot::PackedVector3Array get_points() const { return points; }

	godot::RID _get_rid() const override;

	// What scripts override, with the answer without one.
	bool ask_flag(bool p_flag);
	int ask_count(int p_count);
	double ask_ratio(double p_ratio) const;
	double ask_width(float p_width);
	godot::String ask_label(const godot::String &p_label);
	godot::Color ask_tint(const godot::Color &p_tint);
	godot::Vector3 ask_direction(const godot::Vector3 &p_from, double p_scale);
	godot::PackedVector3Array ask_points(const godot::PackedVector3Array &p_points);
	godot::Ref<godot::Resource> ask_resource(const godot::Ref<godot::RandomNumberGenerator> &p_random);
	godot::Node *ask_node(godot::Node *p_node);
	godot::Variant ask_anything();
	bool note(const godot::String &p_text);
	bool is_count_overridden() const { return GDVIRTUAL_IS_OVERRIDDEN(_get_count); }
};

} // namespace probe

VARIANT_ENUM_CAST(probe::ProbeResource::Kind);
VARIANT_BITFIELD_CAST(probe::ProbeResource::Parts);
