#pragma once

#include "field/build/build_input.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace undergrowth {

/// Collects the styles of a field's species from their scripts, on the main thread. Slow scripts run over several
/// frames.
class SpeciesSampler {
public:
	/// `places_plants`: plants are placed afterwards. `of_drafts`: drafts may be drawn first, which have no cards.
	/// `with_plants`: functions of species that must not become absent by a fault.
	SpeciesSampler(bool places_plants, bool of_drafts, std::vector<godot::Ref<PlantFunction>> &&with_plants) :
			places(places_plants), are_drafts(of_drafts), existing(std::move(with_plants)) {}

	const bool places;
	/// The styles collected up to now; complete when resume() is done. Without meshes.
	FieldRenderSetup setup;

	/// Lists the species to process: those of the list, and `others`, the species of added plants. `range`: the
	/// visibility range and the LOD of the node. Returns an error with advice, or an empty string. So does resume(),
	/// which takes about `usec`.
	godot::String begin(const godot::Node *field, const FieldProperties &properties, const SightRange &range,
			std::vector<SpeciesStyle> &&others);
	/// True if no script ran in this frame.
	bool is_due() const;
	godot::String resume(double usec, bool &is_done);
	/// True if these are the `others` of begin().
	bool includes(const std::vector<SpeciesStyle> &others) const;

private:
	const bool are_drafts;
	std::vector<godot::Ref<PlantFunction>> existing;
	uint64_t frame = 0; ///< The last one in which scripts ran.
};

} // namespace undergrowth
