#include "form/plant_growth.hpp"

#include "base/new_object.hpp"
#include "form/growth_options.hpp"
#include "species/plant_function.hpp"
#include "species/species_sampling.hpp"

#include <godot_cpp/core/class_db.hpp>

using namespace godot;

namespace undergrowth {

void PlantGrowth::begin(PlantFunction *function, double metres, uint64_t seed) {
	species = function;
	height = metres;
	growth = std::make_unique<Growth>(float(metres), seed);
	rng = new_counted<RandomNumberGenerator>();
	rng->set_seed(seed);
}

PlantForm PlantGrowth::finish(String &what) {
	species = nullptr;
	what = problem;
	if (what.is_empty() && growth->form().placed.empty()) {
		what = "it has no stem and no parts. Add some in `_grow`, or set `arrangements`.";
	}
	return what.is_empty() ? growth->finish() : PlantForm();
}

bool PlantGrowth::may_grow() {
	if (!species) {
		report_error(this, "the plant is complete. Add parts only during `_grow`.");
	}
	return species && problem.is_empty();
}

bool PlantGrowth::find_kind(const Ref<PlantPart> &part, int &kind) {
	if (part.is_null()) {
		problem = "`_grow` passed no part. Pass a PlantAxis, PlantBlade or PlantBead.";
		return false;
	}
	for (const auto &[id, known] : kinds) {
		if (id == uint64_t(part->get_instance_id())) {
			kind = known;
			return true;
		}
	}
	Part described;
	problem = part->read(described);
	if (problem.is_empty()) {
		growth->add_kind(described, kind);
		kinds.emplace_back(uint64_t(part->get_instance_id()), kind);
	}
	return problem.is_empty();
}

PackedInt32Array PlantGrowth::place(
		const Ref<PlantPart> &part, Arrangement arrangement, const PackedInt32Array &on, const Dictionary &options) {
	PackedInt32Array placed;
	int kind = 0;
	if (!may_grow() || !find_kind(part, kind)) {
		return placed;
	}
	problem = read_options(options, arrangement);
	std::vector<int> carriers(on.ptr(), on.ptr() + on.size());
	std::vector<int> handles;
	if (problem.is_empty()) {
		problem = String::utf8(growth->arrange(kind, arrangement, carriers, handles).c_str());
		problem = problem.is_empty() ? problem : "`_grow` with " + describe(part.ptr()) + ": " + problem;
	}
	for (const int handle : handles) {
		placed.push_back(handle);
	}
	return placed;
}

PackedInt32Array PlantGrowth::get_ground() const {
	PackedInt32Array ground;
	ground.push_back(ON_GROUND);
	return ground;
}

PackedInt32Array PlantGrowth::add_stem() {
	PackedInt32Array handles;
	Part part;
	if (may_grow()) {
		problem = sample_stem(*species, part);
	}
	if (species && problem.is_empty()) {
		problem = String::utf8(growth->add_stem(part, stem).c_str());
	}
	if (species && problem.is_empty()) {
		handles.push_back(stem);
	}
	return handles;
}

static Arrangement arranged(Layout layout, int count) {
	Arrangement arrangement;
	arrangement.layout = layout;
	arrangement.count_min = arrangement.count_max = count;
	return arrangement;
}

PackedInt32Array PlantGrowth::add(const Ref<PlantPart> &part, const PackedInt32Array &on, const Dictionary &options) {
	const bool on_ground = on.is_empty() || (on.size() == 1 && on[0] == ON_GROUND);
	Arrangement one = arranged(on_ground ? Layout::ground : Layout::along, 1);
	one.from = 1.0f; // At the tip, unless the options contain a position.
	return place(part, one, on_ground ? get_ground() : on, options);
}

PackedInt32Array PlantGrowth::along(
		const Ref<PlantPart> &part, const PackedInt32Array &on, int count, const Dictionary &options) {
	return place(part, arranged(Layout::along, count), on, options);
}

PackedInt32Array PlantGrowth::whorl(
		const Ref<PlantPart> &part, const PackedInt32Array &on, int count, const Dictionary &options) {
	return place(part, arranged(Layout::whorl, count), on, options);
}

PackedInt32Array PlantGrowth::disc(
		const Ref<PlantPart> &part, const PackedInt32Array &on, int count, const Dictionary &options) {
	return place(part, arranged(Layout::disc, count), on, options);
}

PackedInt32Array PlantGrowth::scatter(const Ref<PlantPart> &part, int count, const Dictionary &options) {
	return place(part, arranged(Layout::ground, count), get_ground(), options);
}

void PlantGrowth::arrange(const TypedArray<PlantArrangement> &arrangements) {
	if (!may_grow()) {
		return;
	}
	Recipe recipe;
	std::vector<uint64_t> known;
	for (int64_t i = 0; i < arrangements.size() && problem.is_empty(); i++) {
		const Ref<PlantArrangement> arrangement = arrangements[i];
		problem = arrangement.is_valid() ? arrangement->read(recipe, ON_GROUND, 1, known) : String();
	}
	if (problem.is_empty()) {
		problem = String::utf8(grow(recipe, stem, *growth).c_str());
		problem = problem.is_empty() ? problem : "its `arrangements`: " + problem;
	}
}

void PlantGrowth::_bind_methods() {
	const Dictionary none;
	ClassDB::bind_method(D_METHOD("get_height"), &PlantGrowth::get_height);
	ClassDB::bind_method(D_METHOD("get_rng"), &PlantGrowth::get_rng);
	ClassDB::bind_method(D_METHOD("get_ground"), &PlantGrowth::get_ground);
	ClassDB::bind_method(D_METHOD("add_stem"), &PlantGrowth::add_stem);
	ClassDB::bind_method(
			D_METHOD("add", "part", "on", "options"), &PlantGrowth::add, DEFVAL(PackedInt32Array()), DEFVAL(none));
	ClassDB::bind_method(D_METHOD("along", "part", "on", "count", "options"), &PlantGrowth::along, DEFVAL(none));
	ClassDB::bind_method(D_METHOD("whorl", "part", "on", "count", "options"), &PlantGrowth::whorl, DEFVAL(none));
	ClassDB::bind_method(D_METHOD("disc", "part", "on", "count", "options"), &PlantGrowth::disc, DEFVAL(none));
	ClassDB::bind_method(D_METHOD("scatter", "part", "count", "options"), &PlantGrowth::scatter, DEFVAL(none));
	ClassDB::bind_method(D_METHOD("arrange", "arrangements"), &PlantGrowth::arrange);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "height", PROPERTY_HINT_NONE, "", PROPERTY_USAGE_NONE), "", "get_height");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "rng", PROPERTY_HINT_RESOURCE_TYPE, "RandomNumberGenerator",
						 PROPERTY_USAGE_NONE),
			"", "get_rng");
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_INT32_ARRAY, "ground", PROPERTY_HINT_NONE, "", PROPERTY_USAGE_NONE), "",
			"get_ground");
}

} // namespace undergrowth
