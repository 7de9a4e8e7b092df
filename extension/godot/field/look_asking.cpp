#include "field/look_asking.hpp"

#include <godot_cpp/classes/engine.hpp>

using namespace godot;

namespace undergrowth {

static uint64_t this_frame() {
	return Engine::get_singleton()->get_process_frames();
}

String LookAsking::begin(const Node *field, const FieldProperties &properties, const SightRange &range,
		std::vector<FieldLook> &&others) {
	style.levels = read_levels(properties, range);
	style.rule = read_level_rule(properties, range);
	style.tile_size = float(properties.tile_size);
	const String fault = find_level_fault(properties);
	return fault.is_empty() ? list_looks(field, properties, others, style) : fault;
}

bool LookAsking::is_due() const {
	return frame != this_frame();
}

String LookAsking::go_on(double usec, bool &is_done) {
	frame = this_frame();
	return sample_looks(style, standing, usec, is_done);
}

bool LookAsking::knows(const std::vector<FieldLook> &others) const {
	const size_t listed = size_t(style.listed_count);
	bool all = style.looks.size() == listed + others.size();
	for (size_t i = 0; all && i < others.size(); i++) {
		all = style.looks[listed + i].function == others[i].function;
	}
	return all;
}

} // namespace undergrowth
