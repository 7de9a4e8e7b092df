#pragma once

#include "field/field_recipe.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace undergrowth {

/// Collects the looks of a field's species from their scripts, on the main thread. Slow scripts run over several
/// frames.
class LookAsking {
public:
	/// `fills`: plants are placed afterwards. `with_plants`: functions of species that must not become absent by a
	/// fault.
	LookAsking(bool fills, std::vector<godot::Ref<PlantFunction>> &&with_plants) :
			places(fills), standing(std::move(with_plants)) {}

	const bool places;
	/// The looks collected up to now; complete when go_on() is done. Without meshes.
	FieldStyle style;

	/// Lists the species to process: those of the list, and `others`, the species of added plants. `range`: the
	/// visibility range and the LOD of the node. Returns an error with advice, or an empty string. So does go_on(),
	/// which takes about `usec`.
	godot::String begin(const godot::Node *field, const FieldProperties &properties, const SightRange &range,
			std::vector<FieldLook> &&others);
	/// True if no script ran in this frame.
	bool is_due() const;
	godot::String go_on(double usec, bool &is_done);
	/// True if these are the `others` of begin().
	bool knows(const std::vector<FieldLook> &others) const;

private:
	std::vector<godot::Ref<PlantFunction>> standing;
	uint64_t frame = 0; ///< The last one in which scripts ran.
};

} // namespace undergrowth
