#include "probe_checks.hpp"

#include <godot_cpp/core/math.hpp>
#include <godot_cpp/variant/typed_array.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

#ifdef GODOT_BUNDLED_BINDING
#include <godot_cpp/core/engine_calls.hpp>
#endif

using namespace godot;

namespace probe {

void ProbeChecks::check(bool p_passed, const char *p_text) {
	if (!p_passed) {
		failures.push_back(p_text);
	}
}

PackedStringArray ProbeChecks::check_strings() {
	failures.clear();
	const String text = "leaf";
	CHECK(text + String("s") == "leafs");
	CHECK(String("a") + String("b") + "c" == String("abc"));
	String grown = text;
	grown += "let";
	CHECK(grown == "leaflet" && text == "leaf" && grown.length() == 7);
	CHECK(text.utf8().get_data()[0] == 'l' && text.utf8().length() == 4);
	CHECK(String::utf8("gr\xc3\xbcn").length() == 4);
	CHECK(vformat("%s %d %.2f", "x", 3, 1.5) == "x 3 1.50");
	CHECK(String::num(2.5) == "2.5" && String::num_int64(-4) == "-4");
	CHECK(String("a,b,c").split(",").size() == 3 && text.to_upper() == "LEAF");
	CHECK(text[1] == 'e' && String("a") < String("b") && text != "stem" && !text.is_empty() && String().is_empty());
	const StringName name = "leaf";
	CHECK(name == StringName("leaf") && String(name) == text && name != StringName("x"));
	const NodePath path = "a/b:c";
	CHECK(path.get_name_count() == 2 && String(path) == "a/b:c");
	return failures;
}

PackedStringArray ProbeChecks::check_arrays() {
	failures.clear();
	PackedVector3Array points;
	points.resize(3);
	points.ptrw()[1] = Vector3(1, 2, 3);
	points.push_back(Vector3(4, 5, 6));
	points[0] = Vector3(7, 8, 9);
	const PackedVector3Array &view = points;
	CHECK(points.size() == 4 && view[1].z == 3 && view.ptr()[3].x == 4);
	PackedVector3Array copy = points;
	copy.set(0, Vector3());
	CHECK(points[0].x == 7);
	float sum = 0;
	for (const Vector3 &point : view) {
		sum += point.x;
	}
	CHECK(sum == 12);
	PackedFloat32Array floats;
	floats.push_back(0.5f);
	PackedInt32Array ints = { 1, 2, 3 };
	PackedByteArray bytes;
	bytes.append(7);
	PackedColorArray colors;
	colors.push_back(Color(1, 0, 0));
	PackedStringArray strings;
	strings.push_back("s");
	strings[0] = "t";
	CHECK(floats[0] == 0.5f && ints[2] == 3 && bytes[0] == 7 && colors[0].r == 1 && strings[0] == "t");
	Array array;
	array.push_back(1);
	array.push_back("two");
	array.append(Vector3(0, 3, 0));
	array[0] = 5;
	CHECK(array.size() == 3 && int(array[0]) == 5 && String(array[1]) == "two" && Vector3(array[2]).y == 3);
	Array shared = array;
	shared.clear();
	CHECK(array.is_empty());
	TypedArray<Vector3> typed;
	typed.push_back(Vector3(1, 1, 1));
	CHECK(typed.is_typed() && typed.size() == 1 && typed.get_typed_builtin() == Variant::VECTOR3);
	Dictionary dictionary;
	dictionary["key"] = 3;
	CHECK(dictionary.has("key") && int(dictionary["key"]) == 3 && dictionary.size() == 1 &&
			dictionary.keys().size() == 1);
	return failures;
}

PackedStringArray ProbeChecks::check_math() {
	failures.clear();
	const Vector3 x(1, 0, 0), y(0, 1, 0);
	CHECK(x.cross(y) == Vector3(0, 0, 1) && x.dot(y) == 0 && (x + y * 2).length_squared() == 5);
	CHECK(2 * x == x * 2 && -x == Vector3(-1, 0, 0) && x / 2 == Vector3(0.5, 0, 0) && x[0] == 1);
	CHECK(Math::is_equal_approx((x * 3).normalized().length(), real_t(1)));
	const Quaternion quarter(y, real_t(Math::PI / 2));
	CHECK(quarter.xform(x).is_equal_approx(Vector3(0, 0, -1)) &&
			(quarter * quarter.inverse()).is_equal_approx(Quaternion()));
	const Basis basis(quarter);
	CHECK(basis.xform(x).is_equal_approx(Vector3(0, 0, -1)) && basis.get_column(0).is_equal_approx(Vector3(0, 0, -1)));
	CHECK(basis.rows[0].is_equal_approx(Vector3(0, 0, 1)) && basis.transposed().is_equal_approx(basis.inverse()));
	CHECK((basis * basis).is_equal_approx(Basis(y, real_t(Math::PI))) &&
			basis.get_rotation_quaternion().is_equal_approx(quarter));
	const Transform3D transform(basis, Vector3(1, 2, 3));
	CHECK(transform.xform(x).is_equal_approx(Vector3(1, 2, 2)) &&
			transform.affine_inverse().xform(transform.xform(y)).is_equal_approx(y));
	CHECK(Color(0.5, 0.25, 0).lerp(Color(1, 1, 1), 0).is_equal_approx(Color(0.5, 0.25, 0)) &&
			Color(1, 0, 0).to_html(false) == "ff0000");
	AABB box(Vector3(), Vector3(1, 1, 1));
	box.expand_to(Vector3(2, 0, 0));
	CHECK(box.get_end() == Vector3(2, 1, 1) && box.has_point(Vector3(1.5, 0.5, 0.5)));
	CHECK(Rect2(0, 0, 2, 2).has_point(Vector2(1, 1)) && Vector2i(3, 4).x == 3 && Plane(y, 1).distance_to(y * 3) == 2);
	CHECK(Math::deg_to_rad(180.0) == Math::PI && CLAMP(5, 0, 3) == 3 && MAX(1, 2) == 2 && MIN(1, 2) == 1);
	CHECK(UtilityFunctions::lerpf(0, 2, 0.5) == 1 && UtilityFunctions::is_nan(NAN));
	return failures;
}

PackedStringArray ProbeChecks::check_variants() {
	failures.clear();
	CHECK(Variant().get_type() == Variant::NIL && Variant(1).get_type() == Variant::INT &&
			Variant(1.5f).get_type() == Variant::FLOAT);
	CHECK(Variant(true).get_type() == Variant::BOOL && Variant("text").get_type() == Variant::STRING);
	CHECK(Variant(uint8_t(200)) == Variant(200) && Variant(Variant::INT) == Variant(2) && Variant(3) < Variant(4));
	const Variant vector = Vector3(1, 2, 3);
	CHECK(Vector3(vector) == Vector3(1, 2, 3) && vector.stringify() == "(1.0, 2.0, 3.0)");
	CHECK(double(Variant(2)) == 2.0 && int(Variant(2.9)) == 2 && bool(Variant(1)) && String(Variant(5)) == "5");
	Variant moved = vector;
	Variant target = std::move(moved);
	CHECK(target == vector);
	CHECK(Transform3D(Variant(Transform3D(Basis(), Vector3(1, 2, 3)))).origin.y == 2);
	CHECK(PackedVector3Array(Variant(PackedVector3Array())).is_empty());
	return failures;
}

#ifdef GODOT_BUNDLED_BINDING

bool ProbeChecks::is_bundled_binding() {
	return true;
}

String ProbeChecks::call_missing_method() {
	static internal::EngineMethod method{ "Node3D", "photosynthesize", 12345 };
	return internal::call_engine<String>(method, nullptr, Vector3());
}

#else

bool ProbeChecks::is_bundled_binding() {
	return false;
}

String ProbeChecks::call_missing_method() {
	ERR_FAIL_V_MSG(String(), "godot-cpp tells of photosynthesize in its own words");
}

#endif

void ProbeChecks::_bind_methods() {
	ClassDB::bind_static_method("ProbeChecks", D_METHOD("is_bundled_binding"), &ProbeChecks::is_bundled_binding);
	ClassDB::bind_static_method("ProbeChecks", D_METHOD("call_missing_method"), &ProbeChecks::call_missing_method);
	ClassDB::bind_method(D_METHOD("check_strings"), &ProbeChecks::check_strings);
	ClassDB::bind_method(D_METHOD("check_arrays"), &ProbeChecks::check_arrays);
	ClassDB::bind_method(D_METHOD("check_math"), &ProbeChecks::check_math);
	ClassDB::bind_method(D_METHOD("check_variants"), &ProbeChecks::check_variants);
	ClassDB::bind_method(D_METHOD("check_objects"), &ProbeChecks::check_objects);
	ClassDB::bind_method(D_METHOD("check_engine"), &ProbeChecks::check_engine);
}

} // namespace probe
