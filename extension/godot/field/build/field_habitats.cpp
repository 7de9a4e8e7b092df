#include "field/build/field_habitats.hpp"

#include "field/build/field_areas.hpp"
#include "field/build/field_ground.hpp"
#include "field/build/ground_query.hpp"
#include "nodes/plant_field_3d.hpp"

#include <godot_cpp/classes/path3d.hpp>
#include <godot_cpp/classes/scene_tree.hpp>

#include <algorithm>
#include <iterator>
#include <map>

using namespace godot;

namespace undergrowth {

// Factors of a survey.
static constexpr HabitatFactor SURVEYED[] = { HabitatFactor::moisture, HabitatFactor::light, HabitatFactor::value };

bool uses_survey(const PlantHabitat *habitat) {
	return std::any_of(std::begin(SURVEYED), std::end(SURVEYED),
			[habitat](HabitatFactor factor) { return habitat->uses(factor); });
}

bool has_area(const PlacementOptions &options) {
	return !options.endless || options.map.is_valid();
}

Ref<PlantHabitat> habitat_of(const PlacementOptions &options, int64_t number) {
	const Ref<PlantFieldSpecies> listed = options.species[number];
	return listed.is_valid() ? listed->get_habitat() : Ref<PlantHabitat>();
}

static std::vector<Node3D *> members_of(const Node *field, const StringName &group) {
	std::vector<Node3D *> nodes;
	const TypedArray<Node> members =
			field->is_inside_tree() && !group.is_empty() ? field->get_tree()->get_nodes_in_group(group) : TypedArray<Node>();
	for (int64_t i = 0; i < members.size(); i++) {
		Node3D *node = Object::cast_to<Node3D>(members[i]);
		if (node && node != field && (Object::cast_to<Path3D>(node) || Object::cast_to<PlantField3D>(node))) {
			nodes.push_back(node);
		}
	}
	return nodes;
}

static std::shared_ptr<const HabitatLines> read_lines(const Node3D *field, const StringName &group) {
	auto lines = std::make_shared<HabitatLines>();
	for (const Node3D *node : members_of(field, group)) {
		bool is_closed = true;
		const Polygon points = read_line(field, node, is_closed);
		if (is_closed && points.size() > 2) {
			lines->closed.push_back(points);
		} else if (points.size() > 1) {
			lines->open.push_back(points);
		}
	}
	return lines;
}

// Returns a habitat without the curves that need a survey, for fields that have none.
static std::shared_ptr<const Habitat> without_survey(const Habitat &of) {
	auto rest = std::make_shared<Habitat>(of);
	for (const HabitatFactor factor : SURVEYED) {
		rest->curve(factor) = HabitatCurve();
	}
	return rest;
}

Habitats read_habitats(const Node3D *field, const PlacementOptions &options) {
	Habitats read;
	std::map<StringName, std::shared_ptr<const HabitatLines>> by_group;
	for (int64_t i = 0; i < options.species.size(); i++) {
		const Ref<PlantHabitat> habitat = habitat_of(options, i);
		read.of_species.push_back(habitat.is_valid() ? habitat->share() : nullptr);
		if (habitat.is_valid() && !has_area(options)) {
			read.of_species.back() = without_survey(*read.of_species.back());
		}
		read.lines.emplace_back();
		if (habitat.is_valid() && habitat->uses(HabitatFactor::distance)) {
			const StringName group = habitat->get_distance_group();
			auto found = by_group.find(group);
			if (found == by_group.end()) {
				found = by_group.emplace(group, read_lines(field, group)).first;
			}
			read.lines.back() = found->second;
		}
	}
	read.seed = uint64_t(options.place_seed);
	return read;
}

Competition read_competition(const PlacementOptions &options) {
	Competition read;
	read.strength = float(options.competition);
	for (int64_t i = 0; i < options.species.size() && read.is_on(); i++) {
		const Ref<PlantFieldSpecies> listed = options.species[i];
		read.species.emplace_back();
		if (listed.is_valid()) {
			read.species.back() = { float(listed->get_vigor()), float(listed->get_shade_radius()),
				float(listed->get_shade_tolerance()) };
		}
	}
	read.seed = uint64_t(options.place_seed);
	return read;
}

Object *find_value_source(const Node3D *field, const PlacementOptions &options, const PlantHabitat *habitat) {
	const StringName method = habitat->get_value_method();
	const StringName group = habitat->get_value_group();
	if (group.is_empty()) {
		Object *ground = find_ground_object(field, options.ground_object);
		return ground && ground->has_method(method) ? ground : nullptr;
	}
	const TypedArray<Node> members = field->is_inside_tree() ? field->get_tree()->get_nodes_in_group(group) : TypedArray<Node>();
	for (int64_t i = 0; i < members.size(); i++) {
		Object *member = members[i];
		if (member && member->has_method(method)) {
			return member;
		}
	}
	return nullptr;
}

bool habitats_use(const PlacementOptions &options, HabitatFactor factor) {
	for (int64_t i = 0; i < options.species.size(); i++) {
		const Ref<PlantHabitat> habitat = habitat_of(options, i);
		if (habitat.is_valid() && habitat->uses(factor)) {
			return true;
		}
	}
	return false;
}

std::vector<Node3D *> find_habitat_nodes(const Node3D *field, const PlacementOptions &options) {
	std::vector<Node3D *> nodes;
	for (int64_t i = 0; i < options.species.size(); i++) {
		const Ref<PlantHabitat> habitat = habitat_of(options, i);
		if (habitat.is_valid() && habitat->uses(HabitatFactor::distance)) {
			const std::vector<Node3D *> members = members_of(field, habitat->get_distance_group());
			nodes.insert(nodes.end(), members.begin(), members.end());
		}
	}
	return nodes;
}

PackedStringArray find_habitat_warnings(const Node *field, const PlacementOptions &options) {
	PackedStringArray warnings;
	const bool is_flat = FieldGround::Kind(options.ground_mode) == FieldGround::Kind::none;
	for (int64_t i = 0; i < options.species.size(); i++) {
		const Ref<PlantHabitat> habitat = habitat_of(options, i);
		if (habitat.is_null()) {
			continue;
		}
		const String name = "The habitat of species[" + String::num_int64(i) + "] ";
		if (is_flat && (habitat->uses(HabitatFactor::slope) || habitat->uses(HabitatFactor::height))) {
			warnings.push_back(name +
					String("depends on slope or height, but this field is flat: set Ground Mode, or remove these curves."));
		}
		if (uses_survey(habitat.ptr()) && !has_area(options)) {
			warnings.push_back(name +
					String("depends on moisture, light or a value, which need an area: disable Endless, or remove these "
						   "curves."));
		}
		const StringName group = habitat->get_distance_group();
		if (habitat->uses(HabitatFactor::distance) && field->is_inside_tree() && members_of(field, group).empty()) {
			warnings.push_back(name + String("depends on the distance to the group '") + String(group) +
					"', which has no Path3D and no other PlantField3D: add one to the group.");
		}
	}
	return warnings;
}

} // namespace undergrowth
