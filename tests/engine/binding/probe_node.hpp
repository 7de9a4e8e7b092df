#pragma once

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include "probe_resource.hpp"

namespace probe {

// Signals, properties of every kind, defaults, engine virtuals, notifications.
class ProbeNode : public godot::Node3D {
	GDCLASS(ProbeNode, godot::Node3D)

	double speed = 1.0;
	godot::Ref<ProbeResource> resource;
	godot::Dictionary extra;
	godot::PackedStringArray log;
	godot::Node3D *child = nullptr;
	double processed = 0.0;

protected:
	static void _bind_methods();
	void _notification(int p_what);
	bool _set(const godot::StringName &p_name, const godot::Variant &p_value);
	bool _get(const godot::StringName &p_name, godot::Variant &r_value) const;
	void _get_property_list(godot::List<godot::PropertyInfo> *p_list) const;
	godot::String _to_string() const;
	void add_to_log(const godot::String &p_line) { log.push_back(p_line); }

public:
	ProbeNode();

	void _process(double p_delta) override;
	void _enter_tree() override;
	godot::PackedStringArray _get_configuration_warnings() const override;

	void set_speed(double p_speed);
	double get_speed() const { return speed; }
	void set_resource(const godot::Ref<ProbeResource> &p_resource) { resource = p_resource; }
	godot::Ref<ProbeResource> get_resource() const { return resource; }
	void set_axis(int p_index, double p_value);
	double get_axis(int p_index) const;
	godot::PackedStringArray get_log() const { return log; }
	void clear_log() { log.clear(); }
	double get_processed() const { return processed; }
	godot::Node3D *get_inner_child() const { return child; }

	int add(int p_a, int p_b, int p_c) const { return p_a + p_b + p_c; }
	static godot::String join(const godot::String &p_a, const godot::String &p_b) { return p_a + p_b; }
	godot::TypedArray<godot::Node3D> list(godot::Node3D *p_node, const godot::TypedArray<godot::Node3D> &p_more) const;
	int take_kind(ProbeResource::Kind p_kind, godot::BitField<ProbeResource::Parts> p_parts) const;
	godot::Basis turn(const godot::Basis &p_basis) const;
	void measure(double p_value);
	void listen(bool p_on);
	void on_measured(double p_value, const godot::Vector3 &p_at);
	void listen_native(bool p_on);
};

class ProbeDerived : public ProbeNode {
	GDCLASS(ProbeDerived, ProbeNode)

protected:
	static void _bind_methods() {}
	void _notification(int p_what);
};

} // namespace probe
