#include "probe_resource.hpp"

#include <godot_cpp/variant/utility_functions.hpp>

using namespace godot;

namespace probe {

void ProbeResource::set_kind(Kind p_kind) {
	kind = p_kind;
	notify_property_list_changed();
	emit_changed();
}

void ProbeResource::set_count(int p_count) {
	ERR_FAIL_COND_MSG(p_count < 0, "The count must not be negative.");
	count = p_count;
	emit_changed();
}

bool ProbeResource::_property_can_revert(const StringName &p_name) const {
	return p_name == StringName("label");
}

bool ProbeResource::_property_get_revert(const StringName &p_name, Variant &r_value) const {
	if (p_name == StringName("label")) {
		r_value = String("reverted");
		return true;
	}
	return false;
}

void ProbeResource::_validate_property(PropertyInfo &r_property) const {
	if (r_property.name == StringName("points") && kind == KIND_ROUND) {
		r_property.usage = PROPERTY_USAGE_NO_EDITOR;
	}
}

RID ProbeResource::_get_rid() const {
	return UtilityFunctions::rid_from_int64(77);
}

bool ProbeResource::ask_flag(bool p_flag) {
	bool result = false;
	return GDVIRTUAL_CALL(_get_flag, p_flag, result) ? result : p_flag;
}

int ProbeResource::ask_count(int p_count) {
	int result = -1;
	return GDVIRTUAL_CALL(_get_count, p_count, result) ? result : p_count;
}

double ProbeResource::ask_ratio(double p_ratio) const {
	double result = -1;
	return GDVIRTUAL_CALL(_get_ratio, p_ratio, result) ? result : p_ratio;
}

double ProbeResource::ask_width(float p_width) {
	float result = -1;
	return GDVIRTUAL_CALL(_get_width, p_width, result) ? result : p_width;
}

String ProbeResource::ask_label(const String &p_label) {
	String result;
	return GDVIRTUAL_CALL(_get_label, p_label, result) ? result : p_label;
}

Color ProbeResource::ask_tint(const Color &p_tint) {
	Color result;
	return GDVIRTUAL_CALL(_get_tint, p_tint, result) ? result : p_tint;
}

Vector3 ProbeResource::ask_direction(const Vector3 &p_from, double p_scale) {
	Vector3 result;
	return GDVIRTUAL_CALL(_get_direction, p_from, p_scale, result) ? result : p_from;
}

PackedVector3Array ProbeResource::ask_points(const PackedVector3Array &p_points) {
	PackedVector3Array result;
	return GDVIRTUAL_CALL(_get_points, p_points, result) ? result : p_points;
}

Ref<Resource> ProbeResource::ask_resource(const Ref<RandomNumberGenerator> &p_random) {
	Ref<Resource> result;
	return GDVIRTUAL_CALL(_get_resource, p_random, result) ? result : Ref<Resource>();
}

Node *ProbeResource::ask_node(Node *p_node) {
	Node *result = nullptr;
	return GDVIRTUAL_CALL(_get_node, p_node, result) ? result : p_node;
}

Variant ProbeResource::ask_anything() {
	Variant result;
	return GDVIRTUAL_CALL(_get_anything, result) ? result : Variant("nothing");
}

bool ProbeResource::note(const String &p_text) {
	return GDVIRTUAL_CALL(_note, p_text);
}

void ProbeResource::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_kind", "kind"), &ProbeResource::set_kind);
	ClassDB::bind_method(D_METHOD("get_kind"), &ProbeResource::get_kind);
	ClassDB::bind_method(D_METHOD("set_count", "count"), &ProbeResource::set_count);
	ClassDB::bind_method(D_METHOD("get_count"), &ProbeResource::get_count);
	ClassDB::bind_method(D_METHOD("set_ratio", "ratio"), &ProbeResource::set_ratio);
	ClassDB::bind_method(D_METHOD("get_ratio"), &ProbeResource::get_ratio);
	ClassDB::bind_method(D_METHOD("set_label", "label"), &ProbeResource::set_label);
	ClassDB::bind_method(D_METHOD("get_label"), &ProbeResource::get_label);
	ClassDB::bind_method(D_METHOD("set_tint", "tint"), &ProbeResource::set_tint);
	ClassDB::bind_method(D_METHOD("get_tint"), &ProbeResource::get_tint);
	ClassDB::bind_method(D_METHOD("set_curve", "curve"), &ProbeResource::set_curve);
	ClassDB::bind_method(D_METHOD("get_curve"), &ProbeResource::get_curve);
	ClassDB::bind_method(D_METHOD("set_points", "points"), &ProbeResource::set_points);
	ClassDB::bind_method(D_METHOD("get_points"), &ProbeResource::get_points);

	ADD_PROPERTY(PropertyInfo(Variant::INT, "kind", PROPERTY_HINT_ENUM, "Plain,Round:5"), "set_kind", "get_kind");
	ADD_GROUP("Numbers", "");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "count", PROPERTY_HINT_RANGE, "0,10,1"), "set_count", "get_count");
	ADD_SUBGROUP("Parts", "");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "ratio"), "set_ratio", "get_ratio");
	ADD_GROUP("Looks", "");
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "label"), "set_label", "get_label");
	ADD_PROPERTY(PropertyInfo(Variant::COLOR, "tint"), "set_tint", "get_tint");
	ADD_PROPERTY(
			PropertyInfo(Variant::OBJECT, "curve", PROPERTY_HINT_RESOURCE_TYPE, "Curve"), "set_curve", "get_curve");
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_VECTOR3_ARRAY, "points"), "set_points", "get_points");

	ClassDB::bind_method(D_METHOD("ask_flag", "flag"), &ProbeResource::ask_flag);
	ClassDB::bind_method(D_METHOD("ask_count", "count"), &ProbeResource::ask_count);
	ClassDB::bind_method(D_METHOD("ask_ratio", "ratio"), &ProbeResource::ask_ratio);
	ClassDB::bind_method(D_METHOD("ask_width", "width"), &ProbeResource::ask_width);
	ClassDB::bind_method(D_METHOD("ask_label", "label"), &ProbeResource::ask_label);
	ClassDB::bind_method(D_METHOD("ask_tint", "tint"), &ProbeResource::ask_tint);
	ClassDB::bind_method(D_METHOD("ask_direction", "from", "scale"), &ProbeResource::ask_direction);
	ClassDB::bind_method(D_METHOD("ask_points", "points"), &ProbeResource::ask_points);
	ClassDB::bind_method(D_METHOD("ask_resource", "random"), &ProbeResource::ask_resource);
	ClassDB::bind_method(D_METHOD("ask_node", "node"), &ProbeResource::ask_node);
	ClassDB::bind_method(D_METHOD("ask_anything"), &ProbeResource::ask_anything);
	ClassDB::bind_method(D_METHOD("note", "text"), &ProbeResource::note);
	ClassDB::bind_method(D_METHOD("is_count_overridden"), &ProbeResource::is_count_overridden);
	GDVIRTUAL_BIND(_get_flag, "flag");
	GDVIRTUAL_BIND(_get_count, "count");
	GDVIRTUAL_BIND(_get_ratio, "ratio");
	GDVIRTUAL_BIND(_get_width, "width");
	GDVIRTUAL_BIND(_get_label, "label");
	GDVIRTUAL_BIND(_get_tint, "tint");
	GDVIRTUAL_BIND(_get_direction, "from", "scale");
	GDVIRTUAL_BIND(_get_points, "points");
	GDVIRTUAL_BIND(_get_resource, "random");
	GDVIRTUAL_BIND(_get_node, "node");
	GDVIRTUAL_BIND(_get_anything);
	GDVIRTUAL_BIND(_note, "text");

	BIND_ENUM_CONSTANT(KIND_PLAIN);
	BIND_ENUM_CONSTANT(KIND_ROUND);
	BIND_BITFIELD_FLAG(PART_STEM);
	BIND_BITFIELD_FLAG(PART_LEAF);
}

} // namespace probe
