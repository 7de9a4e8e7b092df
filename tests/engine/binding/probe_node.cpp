#include "probe_node.hpp"

#include <godot_cpp/variant/callable_method_pointer.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

using namespace godot;

namespace probe {

ProbeNode::ProbeNode() {
	child = memnew(Node3D);
	child->set_name("inner");
	add_child(child, false, INTERNAL_MODE_FRONT);
	log.clear();
}

void ProbeNode::_notification(int p_what) {
	switch (p_what) {
		case NOTIFICATION_POSTINITIALIZE:
			add_to_log("postinitialize");
			break;
		case NOTIFICATION_READY:
			add_to_log("ready");
			break;
		case NOTIFICATION_EXIT_TREE:
			add_to_log("exit");
			break;
		case NOTIFICATION_TRANSFORM_CHANGED:
			add_to_log("transform");
			break;
	}
}

void ProbeNode::_process(double p_delta) {
	processed += p_delta;
}

void ProbeNode::_enter_tree() {
	add_to_log("enter");
}

PackedStringArray ProbeNode::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (resource.is_null()) {
		warnings.push_back("needs a resource");
	}
	return warnings;
}

bool ProbeNode::_set(const StringName &p_name, const Variant &p_value) {
	const String name = p_name;
	if (!name.begins_with("extra/")) {
		return false;
	}
	extra[name.trim_prefix("extra/")] = p_value;
	return true;
}

bool ProbeNode::_get(const StringName &p_name, Variant &r_value) const {
	const String name = p_name;
	if (!name.begins_with("extra/")) {
		return false;
	}
	r_value = extra.get(name.trim_prefix("extra/"), 0);
	return true;
}

void ProbeNode::_get_property_list(List<PropertyInfo> *p_list) const {
	p_list->push_back(PropertyInfo(Variant::INT, "extra/first", PROPERTY_HINT_RANGE, "0,5"));
	p_list->push_back(PropertyInfo(Variant::STRING, "extra/second"));
}

String ProbeNode::_to_string() const {
	return vformat("<probe at %.1f>", speed);
}

void ProbeNode::set_speed(double p_speed) {
	speed = p_speed;
	update_configuration_warnings();
}

void ProbeNode::set_axis(int p_index, double p_value) {
	Vector3 position = get_position();
	position[p_index] = real_t(p_value);
	set_position(position);
}

double ProbeNode::get_axis(int p_index) const {
	return get_position()[p_index];
}

TypedArray<Node3D> ProbeNode::list(Node3D *p_node, const TypedArray<Node3D> &p_more) const {
	TypedArray<Node3D> result;
	result.push_back(p_node);
	for (int i = 0; i < p_more.size(); i++) {
		result.push_back(p_more[i]);
	}
	return result;
}

int ProbeNode::take_kind(ProbeResource::Kind p_kind, BitField<ProbeResource::Parts> p_parts) const {
	return int(p_kind) * 10 + (p_parts.has_flag(ProbeResource::PART_LEAF) ? 1 : 0);
}

// Moves the script's x axis to y: a wrong order of rows and columns would show.
Basis ProbeNode::turn(const Basis &p_basis) const {
	Basis result = p_basis;
	result.set_column(1, p_basis.get_column(0));
	return result;
}

void ProbeNode::measure(double p_value) {
	emit_signal("measured", p_value, get_position());
}

void ProbeNode::listen(bool p_on) {
	const Callable callable(this, "on_measured");
	if (p_on) {
		connect("measured", callable);
	} else if (is_connected("measured", callable)) {
		disconnect("measured", callable);
	}
}

void ProbeNode::listen_native(bool p_on) {
	const Callable callable = callable_mp(this, &ProbeNode::on_measured);
	if (p_on) {
		connect("measured", callable);
	} else if (is_connected("measured", callable)) {
		disconnect("measured", callable);
	}
}

void ProbeNode::on_measured(double p_value, const Vector3 &p_at) {
	add_to_log(vformat("measured %.1f at %.1f", p_value, p_at.y));
}

void ProbeNode::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_speed", "speed"), &ProbeNode::set_speed);
	ClassDB::bind_method(D_METHOD("get_speed"), &ProbeNode::get_speed);
	ClassDB::bind_method(D_METHOD("set_resource", "resource"), &ProbeNode::set_resource);
	ClassDB::bind_method(D_METHOD("get_resource"), &ProbeNode::get_resource);
	ClassDB::bind_method(D_METHOD("set_axis", "index", "value"), &ProbeNode::set_axis);
	ClassDB::bind_method(D_METHOD("get_axis", "index"), &ProbeNode::get_axis);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "speed", PROPERTY_HINT_RANGE, "0,10,0.1,suffix:m/s"), "set_speed",
			"get_speed");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "resource", PROPERTY_HINT_RESOURCE_TYPE, "ProbeResource"),
			"set_resource", "get_resource");
	ADD_PROPERTYI(PropertyInfo(Variant::FLOAT, "axis_y", PROPERTY_HINT_NONE, "", PROPERTY_USAGE_EDITOR), "set_axis",
			"get_axis", 1);

	ClassDB::bind_method(D_METHOD("get_log"), &ProbeNode::get_log);
	ClassDB::bind_method(D_METHOD("clear_log"), &ProbeNode::clear_log);
	ClassDB::bind_method(D_METHOD("get_processed"), &ProbeNode::get_processed);
	ClassDB::bind_method(D_METHOD("get_inner_child"), &ProbeNode::get_inner_child);
	ClassDB::bind_method(D_METHOD("add", "a", "b", "c"), &ProbeNode::add, DEFVAL(10), DEFVAL(100));
	ClassDB::bind_static_method("ProbeNode", D_METHOD("join", "a", "b"), &ProbeNode::join, DEFVAL("!"));
	ClassDB::bind_method(D_METHOD("list", "node", "more"), &ProbeNode::list, DEFVAL(TypedArray<Node3D>()));
	ClassDB::bind_method(D_METHOD("take_kind", "kind", "parts"), &ProbeNode::take_kind);
	ClassDB::bind_method(D_METHOD("turn", "basis"), &ProbeNode::turn);
	ClassDB::bind_method(D_METHOD("measure", "value"), &ProbeNode::measure);
	ClassDB::bind_method(D_METHOD("listen", "on"), &ProbeNode::listen);
	ClassDB::bind_method(D_METHOD("listen_native", "on"), &ProbeNode::listen_native);
	ClassDB::bind_method(D_METHOD("on_measured", "value", "at"), &ProbeNode::on_measured);
	ADD_SIGNAL(MethodInfo("measured", PropertyInfo(Variant::FLOAT, "value"), PropertyInfo(Variant::VECTOR3, "at")));
	BIND_CONSTANT(NOTIFICATION_READY);
}

void ProbeDerived::_notification(int p_what) {
	if (p_what == NOTIFICATION_READY || p_what == NOTIFICATION_EXIT_TREE) {
		add_to_log(p_what == NOTIFICATION_READY ? "derived ready" : "derived exit");
	}
}

} // namespace probe
