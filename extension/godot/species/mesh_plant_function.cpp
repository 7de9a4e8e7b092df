#include "species/mesh_plant_function.hpp"

#include "base/convert.hpp"
#include "base/follow_changes.hpp"
#include "base/new_object.hpp"
#include "base/random.hpp"
#include "base/shortest_decimal.hpp"
#include "species/species_sampling.hpp"

#include <godot_cpp/classes/packed_scene.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr Range HEIGHT_RANGE = { 0.0, 1000.0 };

MeshPlantFunction::MeshPlantFunction() {
	Motion usual;
	usual.law = Law::stem;
	usual.wind_weight = -1.0f;
	usual.natural_frequency = 1.2f;
	usual.damping_ratio = 0.12f;
	adopt_motion(usual);
}

Ref<MeshPlantFunction> MeshPlantFunction::of(const Variant &files) {
	Ref<MeshPlantFunction> made = new_counted<MeshPlantFunction>();
	Array list;
	if (files.get_type() == Variant::ARRAY) {
		list = files;
	} else {
		list.push_back(files);
	}
	made->set_models(list);
	return made;
}

void MeshPlantFunction::forget() {
	entries.clear();
	shape_changed();
}

void MeshPlantFunction::on_model_changed() {
	forget();
}

static ModelColors channels_of(MeshPlantFunction::VertexColors use) {
	switch (use) {
		case MeshPlantFunction::VERTEX_COLORS_BEND_FLUTTER_PHASE:
			return { 0, 1, 2 };
		case MeshPlantFunction::VERTEX_COLORS_FLUTTER_PHASE_BEND:
			return { 2, 0, 1 };
		case MeshPlantFunction::VERTEX_COLORS_ALPHA_BEND:
			return { 3, -1, -1 };
		default:
			return {};
	}
}

ModelOptions MeshPlantFunction::model_options() const {
	ModelOptions options;
	options.frame.up = UpAxis(int(up_axis));
	options.frame.height = height;
	options.frame.has_root = has_own_root;
	options.frame.root = to_glm(root);
	options.colors = channels_of(vertex_colors);
	options.foliage = leaf_surfaces;
	return options;
}

const MeshPlantFunction::Entry &MeshPlantFunction::entry(int64_t number) {
	entries.resize(size_t(models.size()));
	Entry &found = entries[size_t(number)];
	if (!found.is_read) {
		found.is_read = true;
		const Ref<Resource> file = models[number];
		const String name = "models[" + String::num_int64(number) + "]";
		if (file.is_null()) {
			found.problem = name + String(" is empty. Set a Mesh or a scene, or remove the entry.");
			return found;
		}
		const FileModel read = read_model_file(file);
		found.problem = read.problem;
		if (found.problem.is_empty()) {
			found.model = PlantModel::make(read, model_options(), found.problem);
		}
		if (!found.problem.is_empty()) {
			found.problem = name + String(" (") + describe(file.ptr()) + ") cannot become a plant. " + found.problem;
		}
	}
	return found;
}

double MeshPlantFunction::weight_of(int64_t number) const {
	return number < weights.size() ? double(weights[number]) : 1.0;
}

int64_t MeshPlantFunction::number_of(int64_t seed) const {
	double sum = 0.0;
	for (int64_t i = 0; i < models.size(); i++) {
		sum += weight_of(i);
	}
	double left = sum * unit16(mix_bits(uint64_t(seed)), 1);
	int64_t last = -1;
	for (int64_t i = 0; i < models.size(); i++) {
		left -= weight_of(i);
		last = weight_of(i) > 0.0 ? i : last;
		if (left < 0.0 && last == i) {
			break;
		}
	}
	return last;
}

String MeshPlantFunction::sample_shape(double wanted, int segments, int64_t seed, SampledPlant &result) {
	String problem = find_level_problem(segments);
	if (problem.is_empty()) {
		problem = find_height_problem(wanted);
	}
	if (!problem.is_empty()) {
		return problem;
	}
	const int64_t number = number_of(seed);
	if (number < 0) {
		return models.is_empty() ? "it has no model. Add a Mesh or the scene of a glTF file to its `models`."
								 : "all `weights` are 0. Give a model a weight above 0.";
	}
	const Entry &shown = entry(number);
	if (!shown.model) {
		return shown.problem;
	}
	result.model = shown.model;
	result.lod = segments;
	result.height = wanted == 0.0 ? shown.model->height() : float(wanted);
	return String();
}

double MeshPlantFunction::own_height(const Ref<RandomNumberGenerator> &) const {
	if (height > 0.0f || models.is_empty()) {
		return height > 0.0f ? height : 1.0;
	}
	const Entry &first = const_cast<MeshPlantFunction *>(this)->entry(0); // Analysed at the first call.
	return first.model ? first.model->height() : 1.0;
}

Dictionary MeshPlantFunction::find_model(int number) {
	Dictionary found;
	if (number < 0 || number >= models.size()) {
		report_error(this,
				"find_model(" + String::num_int64(number) + ") does not exist. Use 0 to " +
						String::num_int64(models.size() - 1) + ".");
		return found;
	}
	const Entry &one = entry(number);
	if (!one.model) {
		report_error(this, one.problem);
		return found;
	}
	const ModelMotion &parts = one.model->found();
	const ModelFrame &frame = one.model->found_frame();
	found[Variant("height")] = shortest_decimal(frame.height);
	found[Variant("scale")] = shortest_decimal(frame.scale);
	found[Variant("up_axis")] = int64_t(frame.up);
	found[Variant("root")] = to_godot(glm::transpose(frame.turn) * frame.root);
	found[Variant("roots")] = parts.roots;
	found[Variant("leaves")] = parts.leaves;
	found[Variant("heads")] = parts.heads;
	found[Variant("twigs")] = parts.twigs;
	PackedInt32Array triangles;
	for (const int segments : { 12, 8, 5, 3, 2 }) {
		if (int(triangles.size()) < one.model->level_count()) {
			triangles.push_back(one.model->triangles(segments));
		}
	}
	found[Variant("triangles")] = triangles;
	return found;
}

void MeshPlantFunction::set_models(const Array &files) {
	for (int64_t i = 0; i < files.size(); i++) {
		const Ref<Resource> file = files[i];
		const bool is_usable = file.is_null() || Ref<Mesh>(file).is_valid() || Ref<PackedScene>(file).is_valid();
		if (!is_usable) {
			report_error(this,
					"models[" + String::num_int64(i) + "] is " + describe(file.ptr()) +
							", which is no model. Use a Mesh or a PackedScene.");
			return;
		}
	}
	const Callable changed(this, "_on_model_changed");
	for (int64_t i = 0; i < models.size(); i++) {
		unfollow_changes(Ref<Resource>(models[i]).ptr(), changed);
	}
	models = files.duplicate();
	for (int64_t i = 0; i < models.size(); i++) {
		follow_changes(Ref<Resource>(models[i]).ptr(), changed);
	}
	forget();
}

void MeshPlantFunction::set_weights(const PackedFloat32Array &list) {
	for (int64_t i = 0; i < list.size(); i++) {
		if (!std::isfinite(list[i]) || list[i] < 0.0f) {
			report_error(this,
					"weights[" + String::num_int64(i) + "] cannot be " + String::num(list[i]) + ". Use 0 or more.");
			return;
		}
	}
	if (list != weights) {
		weights = list;
		shape_changed();
	}
}

void MeshPlantFunction::set_up_axis(Axis axis) {
	if (axis < AXIS_AUTOMATIC || axis > AXIS_MINUS_X) {
		report_error(this, "up_axis " + String::num_int64(axis) + " does not exist. Use one of the AXIS_ constants.");
		return;
	}
	if (axis != up_axis) {
		up_axis = axis;
		forget();
	}
}

void MeshPlantFunction::set_height(double metres) {
	if (accept_value(this, "height", metres, HEIGHT_RANGE) && float(metres) != height) {
		height = float(metres);
		forget();
	}
}

double MeshPlantFunction::get_height() const {
	return shortest_decimal(height);
}

void MeshPlantFunction::set_has_own_root(bool has) {
	if (has != has_own_root) {
		has_own_root = has;
		notify_property_list_changed();
		forget();
	}
}

void MeshPlantFunction::set_root(const Vector3 &place) {
	if (!place.is_finite()) {
		report_error(this, "root must be finite; the old value stays.");
	} else if (place != root) {
		root = place;
		forget();
	}
}

void MeshPlantFunction::set_vertex_colors(VertexColors use) {
	if (use < VERTEX_COLORS_UNUSED || use > VERTEX_COLORS_ALPHA_BEND) {
		report_error(this,
				"vertex_colors " + String::num_int64(use) +
						" does not exist. Use one of the VERTEX_COLORS_ constants.");
	} else if (use != vertex_colors) {
		vertex_colors = use;
		forget();
	}
}

void MeshPlantFunction::set_leaf_surfaces(const PackedInt32Array &numbers) {
	if (numbers != leaf_surfaces) {
		leaf_surfaces = numbers;
		forget();
	}
}

void MeshPlantFunction::_validate_property(PropertyInfo &property) const {
	static const char *const unused[] = { "has_stem", "arrangements", "shading", "shape_deviation", "color_deviation" };
	const String name = property.name;
	if (std::any_of(std::begin(unused), std::end(unused), [&](const char *one) { return name == String(one); })) {
		property.usage = PROPERTY_USAGE_NO_EDITOR;
	}
	if (name == String("root") && !has_own_root) {
		property.usage = PROPERTY_USAGE_NO_EDITOR;
	}
}

void MeshPlantFunction::_bind_methods() {
	ClassDB::bind_static_method("MeshPlantFunction", D_METHOD("of", "files"), &MeshPlantFunction::of);
	ClassDB::bind_method(D_METHOD("find_model", "index"), &MeshPlantFunction::find_model);
	ClassDB::bind_method(D_METHOD("_on_model_changed"), &MeshPlantFunction::on_model_changed);
	ClassDB::bind_method(D_METHOD("set_models", "files"), &MeshPlantFunction::set_models);
	ClassDB::bind_method(D_METHOD("get_models"), &MeshPlantFunction::get_models);
	ClassDB::bind_method(D_METHOD("set_weights", "weights"), &MeshPlantFunction::set_weights);
	ClassDB::bind_method(D_METHOD("get_weights"), &MeshPlantFunction::get_weights);
	ClassDB::bind_method(D_METHOD("set_up_axis", "axis"), &MeshPlantFunction::set_up_axis);
	ClassDB::bind_method(D_METHOD("get_up_axis"), &MeshPlantFunction::get_up_axis);
	ClassDB::bind_method(D_METHOD("set_height", "metres"), &MeshPlantFunction::set_height);
	ClassDB::bind_method(D_METHOD("get_height"), &MeshPlantFunction::get_height);

	ClassDB::bind_method(D_METHOD("set_has_own_root", "has"), &MeshPlantFunction::set_has_own_root);
	ClassDB::bind_method(D_METHOD("get_has_own_root"), &MeshPlantFunction::get_has_own_root);
	ClassDB::bind_method(D_METHOD("set_root", "place"), &MeshPlantFunction::set_root);
	ClassDB::bind_method(D_METHOD("get_root"), &MeshPlantFunction::get_root);
	ClassDB::bind_method(D_METHOD("set_vertex_colors", "use"), &MeshPlantFunction::set_vertex_colors);
	ClassDB::bind_method(D_METHOD("get_vertex_colors"), &MeshPlantFunction::get_vertex_colors);
	ClassDB::bind_method(D_METHOD("set_leaf_surfaces", "numbers"), &MeshPlantFunction::set_leaf_surfaces);
	ClassDB::bind_method(D_METHOD("get_leaf_surfaces"), &MeshPlantFunction::get_leaf_surfaces);

	ADD_GROUP("Models", "");
	ADD_PROPERTY(PropertyInfo(Variant::ARRAY, "models", PROPERTY_HINT_ARRAY_TYPE, "24/17:Mesh,PackedScene"),
			"set_models", "get_models");
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_FLOAT32_ARRAY, "weights"), "set_weights", "get_weights");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "height", PROPERTY_HINT_RANGE, "0,10,0.01,or_greater,suffix:m"),
			"set_height", "get_height");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "up_axis", PROPERTY_HINT_ENUM, "Automatic,+Y,-Y,+Z,-Z,+X,-X"),
			"set_up_axis", "get_up_axis");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "has_own_root"), "set_has_own_root", "get_has_own_root");
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR3, "root"), "set_root", "get_root");
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_INT32_ARRAY, "leaf_surfaces"), "set_leaf_surfaces", "get_leaf_surfaces");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "vertex_colors", PROPERTY_HINT_ENUM,
						 "Unused,Bend Flutter Phase,Flutter Phase Bend,Alpha Bend"),
			"set_vertex_colors", "get_vertex_colors");

	BIND_ENUM_CONSTANT(AXIS_AUTOMATIC);
	BIND_ENUM_CONSTANT(AXIS_PLUS_Y);
	BIND_ENUM_CONSTANT(AXIS_MINUS_Y);
	BIND_ENUM_CONSTANT(AXIS_PLUS_Z);
	BIND_ENUM_CONSTANT(AXIS_MINUS_Z);
	BIND_ENUM_CONSTANT(AXIS_PLUS_X);
	BIND_ENUM_CONSTANT(AXIS_MINUS_X);
	BIND_ENUM_CONSTANT(VERTEX_COLORS_UNUSED);
	BIND_ENUM_CONSTANT(VERTEX_COLORS_BEND_FLUTTER_PHASE);
	BIND_ENUM_CONSTANT(VERTEX_COLORS_FLUTTER_PHASE_BEND);
	BIND_ENUM_CONSTANT(VERTEX_COLORS_ALPHA_BEND);
}

} // namespace undergrowth
