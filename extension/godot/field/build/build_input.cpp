#include "field/build/build_input.hpp"

#include "base/new_object.hpp"
#include "base/random.hpp"
#include "base/renderer.hpp"
#include "base/stopwatch.hpp"
#include "conventions.hpp"
#include "field/build/field_areas.hpp"
#include "field/build/field_habitats.hpp"
#include "field/build/ground_sampler.hpp"
#include "field/resources/empty_entry.hpp"
#include "field/view/field_fitting.hpp"
#include "nodes/plant_field_3d.hpp"
#include "species/species_functions.hpp"

#include <godot_cpp/classes/mesh_instance3d.hpp>
#include <godot_cpp/classes/rendering_server.hpp>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace godot;

namespace undergrowth {

Transform3D axes_of(const Node3D *node) {
	const Transform3D placed = node->is_inside_tree() ? node->get_global_transform() : node->get_transform();
	const float volume = placed.basis.determinant();
	return placed.is_finite() && std::isfinite(volume) && volume != 0.0f ? placed : Transform3D();
}

// Rounds to centimetres, so that the last bits of a position have no effect.
int64_t seed_at(const Node3D *node, int64_t seed) {
	static constexpr double STEPS_PER_METRE = 100.0;
	if (seed != PLACE_SEED) {
		return seed;
	}
	const Vector3 place = node->get_global_position();
	uint64_t bits = 0;
	for (const double metres : { double(place.x), double(place.y), double(place.z) }) {
		const double steps = std::clamp(std::round(metres * STEPS_PER_METRE), -1e15, 1e15);
		bits = mix_bits(bits ^ uint64_t(int64_t(std::isfinite(steps) ? steps : 0.0)));
	}
	return int64_t(bits >> 1);
}

// The density of a species is its weighted part of the field's density, times its own factor.
static void add_species(const PlantFieldSpecies &listed, PlacementRequest &into) {
	PlacementSpecies kind;
	kind.weight = float(listed.get_weight() * listed.get_density_factor());
	kind.variants = listed.get_variants();
	kind.min_scale = listed.get_scale_range().x;
	kind.max_scale = listed.get_scale_range().y;
	kind.height_deviation = float(listed.get_height_deviation());
	kind.max_lean = float(listed.get_lean_deviation());
	if (into.map) {
		kind.layer = into.map->find_layer(listed.get_layer_name().utf8().get_data());
	}
	into.species.push_back(kind);
}

// A box, extended by `margin` (m) on all sides.
static Polygon area_around(const AreaBox &box, float margin) {
	const glm::vec2 farthest(FARTHEST_COORDINATE);
	const glm::vec2 low = glm::clamp(box.low - margin, -farthest, farthest);
	const glm::vec2 high = glm::clamp(box.high + margin, -farthest, farthest);
	return rectangle(high - low, 0.5f * (low + high));
}

// A field with a map has no other area.
static String read_area(
		const Node3D *field, const PlacementOptions &options, const AreaBox *part, PlacementRequest &into) {
	if (options.map.is_valid() && !options.map->problem().is_empty()) {
		return "its map cannot be used. " + options.map->problem();
	}
	if (part) {
		into.within = *part;
	}
	if (options.map.is_valid() && part) {
		const DensityMap &map = options.map->density();
		into.map = std::make_shared<DensityMap>(map.cut(map.cells_around(*part)));
		return String();
	}
	if (options.map.is_valid()) {
		into.map = std::make_shared<DensityMap>(options.map->density().share());
	} else if (!options.outline.is_empty()) {
		const String fault = find_outline_fault(field, options);
		if (!fault.is_empty()) {
			return fault;
		}
	}
	if (options.endless && options.view_distance <= 0.0 && !options.map.is_valid()) {
		return "endless needs a view_distance above 0, because an endless field exists only around cameras. Set "
			   "view_distance, or disable endless.";
	}
	if (options.endless && !options.map.is_valid()) {
		into.area = rectangle({ 2.0f * FARTHEST_COORDINATE, 2.0f * FARTHEST_COORDINATE });
		return String();
	}
	const bool is_bare = into.map && into.map->block_count() == 0;
	into.area = is_bare ? rectangle({ 1.0f, 1.0f }) : read_outline(field, options);
	return String();
}

String read_request(const Node3D *field, const PlacementOptions &options, const FieldRenderSetup &setup,
		const AreaBox *part, PlacementRequest &into) {
	const String no_area = read_area(field, options, part, into);
	if (!no_area.is_empty()) {
		return no_area;
	}
	for (int64_t i = 0; i < options.exclusions.size(); i++) {
		into.exclusions.emplace_back();
		const String fault = read_exclusion(field, options, int(i), into.exclusions.back());
		if (!fault.is_empty()) {
			return fault;
		}
	}
	into.seed = uint64_t(options.place_seed);
	into.clumping = float(options.clumping);
	into.drift_size = float(options.clump_size);
	into.combed = float(options.combed);
	into.edge_falloff = float(options.edge_falloff);
	into.habitats = read_habitats(field, options);
	into.competition = read_competition(options);
	double shares = 0.0, weighted = 0.0;
	for (int64_t i = 0; i < options.species.size(); i++) {
		const Ref<PlantFieldSpecies> listed = options.species[i];
		if (listed.is_null()) {
			into.species.emplace_back();
			into.species.back().weight = 0.0f;
			continue;
		}
		add_species(**listed, into);
		into.species.back().is_absent = setup.is_absent(int(i));
		shares += listed->get_weight();
		weighted += listed->get_weight() * listed->get_density_factor();
	}
	into.density = float(shares > 0.0 ? options.density * weighted / shares : options.density);
	if (part && into.map) { // The painted cells are the area; cells at the border of the part are whole.
		into.area = area_around(*part, 2.0f / std::sqrt(std::max(into.density, 1.0e-6f)));
	}
	PlacementRequest tried = into;
	if (options.view_distance > 0.0) {
		tried.within = AreaBox(); // Tiles are placed one at a time.
	}
	const PlacementFault fault = tried.density > 0.0f ? find_placement_fault(tried) : PlacementFault::none;
	if (fault == PlacementFault::bad_area) {
		return describe(find_area_fault(into.area));
	}
	return fault == PlacementFault::none ? String() : String(undergrowth::describe(fault));
}

String read_ground(const Node3D *field, const PlacementOptions &options, FieldGround &into) {
	into.kind = FieldGround::Kind(options.ground_mode);
	into.choice = GroundChoice(options.ground_choice);
	into.limits.lowest = options.height_limits.x;
	into.limits.highest = options.height_limits.y;
	into.limits.flattest = options.slope_limits.x;
	into.limits.steepest = options.slope_limits.y;
	into.limits.alignment = float(options.slope_alignment);
	if (into.kind == FieldGround::Kind::object) {
		const Object *ground = find_ground_object(field, options.ground_object);
		return ground && ground->has_method("get_height") ? String()
														  : "ground_object '" + String(options.ground_object) +
						"' is no object with a method get_height(Vector3) -> float. Set the path of such a node, or of "
						"a node's property after a colon, or set another ground_mode.";
	}
	if (into.kind != FieldGround::Kind::mesh) {
		return String();
	}
	const MeshInstance3D *instance = Object::cast_to<MeshInstance3D>(field->get_node_or_null(options.ground_mesh));
	const Ref<Mesh> mesh = instance ? instance->get_mesh() : Ref<Mesh>();
	if (mesh.is_null()) {
		return "ground_mesh is no MeshInstance3D with a mesh. Set the path of one, or another ground_mode.";
	}
	const Transform3D to_field = axes_of(field).affine_inverse() * instance->get_global_transform();
	into.triangles = mesh->get_faces();
	Vector3 *corners = into.triangles.ptrw();
	for (int64_t i = 0; i < into.triangles.size(); i++) {
		corners[i] = to_field.xform(corners[i]);
	}
	return String();
}

// The dummy renderer of the headless engine does not support calls from two threads. It has no adapter name.
bool renders_on_threads() {
	return !RenderingServer::get_singleton()->get_video_adapter_name().is_empty();
}

// The seed depends on the index of the style: in the list of the properties, or after the list if only code adds it. A
// species that is appended to the list later has the same seed. The list counts as it is set, even if it is not built
// yet.
static SpeciesStyle style_of(
		const Ref<PlantFunction> &function, int variants, const PlacementOptions &options, size_t number) {
	SpeciesStyle style;
	style.function = function;
	style.variant_count = variants;
	style.seed = int64_t(mix_bits(uint64_t(options.seed) ^ mix_bits(uint64_t(number))));
	return style;
}

static SpeciesStyle listed_style(const PlantFieldSpecies &listed, const PlacementOptions &options, size_t number) {
	SpeciesStyle style = style_of(listed.get_species(), listed.get_variants(), options, number);
	style.detail = listed.get_lod_bias();
	style.mean_scale = 0.5f * (listed.get_scale_range().x + listed.get_scale_range().y);
	return style;
}

int64_t number_in_list(const PlacementOptions &options, const Ref<PlantFunction> &function) {
	for (int64_t i = 0; i < options.species.size(); i++) {
		const Ref<PlantFieldSpecies> listed = options.species[i];
		if (listed.is_valid() && listed->get_species() == function) {
			return i;
		}
	}
	return -1;
}

// No plant uses it, but everything that each species needs can be made from it.
static SpeciesStyle substitute_style(int64_t seed) {
	SpeciesStyle style;
	style.function = Ref<PlantFunction>(new_counted<GrassFunction>());
	style.variant_count = 1;
	style.seed = seed;
	style.is_absent = true;
	return style;
}

static void leave_out(const String &what, FieldRenderSetup &setup) {
	setup.left_out += (setup.left_out.is_empty() ? String() : String(" ")) + what;
}

// If false, the field has no plants to build.
static bool has_any_listed(const FieldRenderSetup &setup) {
	const auto end = setup.styles.begin() + setup.listed_count;
	return setup.listed_count == 0 ||
			std::any_of(setup.styles.begin(), end, [](const SpeciesStyle &style) { return !style.is_absent; });
}

void read_densities(const PlacementOptions &options, FieldRenderSetup &into) {
	double weights = 0.0;
	for (int64_t i = 0; i < options.species.size(); i++) {
		const Ref<PlantFieldSpecies> listed = options.species[i];
		weights += listed.is_valid() ? listed->get_weight() : 0.0;
	}
	for (int64_t i = 0; i < options.species.size() && size_t(i) < into.styles.size(); i++) {
		const Ref<PlantFieldSpecies> listed = options.species[i];
		const double own = listed.is_valid() ? listed->get_weight() * listed->get_density_factor() : 0.0;
		into.styles[size_t(i)].density = weights > 0.0 ? float(options.density * own / weights) : 0.0f;
	}
}

String list_styles(const Node *field, const PlacementOptions &options, const std::vector<SpeciesStyle> &others,
		FieldRenderSetup &into) {
	into.needs_colors = is_compatibility();
	for (int64_t i = 0; i < options.species.size(); i++) {
		const Ref<PlantFieldSpecies> listed = options.species[i];
		if (listed.is_null() || listed->get_species().is_null()) {
			into.styles.push_back(substitute_style(int64_t(i)));
			leave_out(describe_empty_entry(field, int(i), listed), into);
		} else {
			into.styles.push_back(listed_style(*listed.ptr(), options, size_t(i)));
		}
	}
	into.listed_count = int(into.styles.size());
	read_densities(options, into);
	if (!has_any_listed(into)) {
		return into.left_out;
	}
	for (size_t i = 0; i < others.size(); i++) {
		into.styles.push_back(style_of(others[i].function, others[i].variant_count, options, into.styles.size()));
	}
	return String();
}

// Returns the fault if the species is still needed.
static String leave_out_faulty(
		FieldRenderSetup &setup, size_t number, const String &fault, const std::vector<Ref<PlantFunction>> &existing) {
	SpeciesStyle &style = setup.styles[number];
	const bool is_listed = int(number) < setup.listed_count;
	const String what = describe(style.function.ptr()) + ": " + fault;
	if (!is_listed || std::find(existing.begin(), existing.end(), style.function) != existing.end()) {
		return what;
	}
	leave_out("species[" + String::num_uint64(number) + "] does not grow. " + what, setup);
	style = substitute_style(style.seed);
	return has_any_listed(setup) ? String() : setup.left_out;
}

String sample_styles(
		FieldRenderSetup &setup, const std::vector<Ref<PlantFunction>> &existing, bool are_drafts, double usec,
		bool &is_done) {
	const Stopwatch watch;
	is_done = false;
	for (size_t i = 0; i < setup.styles.size(); i++) {
		SpeciesStyle &style = setup.styles[i];
		while (!style.is_sampled()) {
			if (watch.usec() > usec) {
				return String();
			}
			String fault = style.sample_next(setup.levels, setup.rule.is_by_error, setup.material_override);
			if (!fault.is_empty()) {
				fault = leave_out_faulty(setup, i, fault, existing);
			}
			if (!fault.is_empty()) {
				return fault;
			}
		}
		while (style.load_next_shader(are_drafts)) {
			if (watch.usec() > usec) {
				return String();
			}
		}
	}
	is_done = true;
	return String();
}

String read_other_style(const Ref<PlantFunction> &function, const PlacementOptions &options,
		const FieldRenderSetup &setup, SpeciesStyle &into) {
	const int64_t listed = number_in_list(options, function);
	const auto is_other = [&](const SpeciesStyle &style) { return number_in_list(options, style.function) < 0; };
	const auto first_other = setup.styles.begin() + setup.listed_count;
	const auto others = std::count_if(first_other, setup.styles.end(), is_other);
	// Before the first build the list may be empty; the default grass will then be its only entry.
	const int64_t list_size = std::max(options.species.size(), int64_t(1));
	into = listed < 0 ? style_of(function, SpeciesStyle().variant_count, options, size_t(list_size + others))
					  : listed_style(*Ref<PlantFieldSpecies>(options.species[listed]).ptr(), options, size_t(listed));
	while (!into.is_sampled()) {
		const String fault = into.sample_next(setup.levels, setup.rule.is_by_error, setup.material_override);
		if (!fault.is_empty()) {
			return describe(function.ptr()) + ": " + fault;
		}
	}
	into.measure();
	fit_levels(setup, into);
	into.build();
	into.send_stem();
	into.make_meshes(std::numeric_limits<double>::infinity());
	return String();
}

} // namespace undergrowth
