#include "field/build/species_sampler.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/geometry_instance3d.hpp>

using namespace godot;

namespace undergrowth {

static uint64_t this_frame() {
	return Engine::get_singleton()->get_process_frames();
}

String SpeciesSampler::begin(const Node *field, const FieldProperties &properties, const SightRange &range,
		std::vector<SpeciesStyle> &&others) {
	setup.levels = read_levels(properties, range);
	setup.rule = read_level_rule(properties, range);
	const GeometryInstance3D *drawn = Object::cast_to<GeometryInstance3D>(field);
	setup.material_override = drawn ? drawn->get_material_override() : Ref<Material>();
	setup.tile_size = float(properties.tile_size);
	const String fault = find_level_fault(properties);
	return fault.is_empty() ? list_styles(field, properties, others, setup) : fault;
}

bool SpeciesSampler::is_due() const {
	return frame != this_frame();
}

String SpeciesSampler::resume(double usec, bool &is_done) {
	frame = this_frame();
	return sample_styles(setup, existing, are_drafts, usec, is_done);
}

bool SpeciesSampler::includes(const std::vector<SpeciesStyle> &others) const {
	const size_t listed = size_t(setup.listed_count);
	bool all = setup.styles.size() == listed + others.size();
	for (size_t i = 0; all && i < others.size(); i++) {
		all = setup.styles[listed + i].function == others[i].function;
	}
	return all;
}

} // namespace undergrowth
