#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

struct PlacementRequest;

/// Which species grows at each place of a painted field. At every place each layer with plants/m² is chosen with the
/// chance that gives these. The rest goes to the mix, where each species grows with the chance that its density says.
/// Painted plants take the places that the mix leaves bare first, then those of its plants. Without plants/m² at a
/// place the mix alone decides, with the same bits. If all plants/m² are more than the field's density, all are reduced
/// alike.
class PaintedMix {
public:
	/// What the mix has at a place.
	struct Drawn {
		int species = 0;
		bool is_in_drift = false; ///< The species is that of the drift, and not drawn for this place alone.
	};

	/// Without a map.
	PaintedMix() = default;
	/// The request has a map and no fault. The functions below need the same request.
	explicit PaintedMix(const PlacementRequest &request);

	/// The species that grows at `root` (m), or -1. `bits` are random, and different for each place.
	int choose(const PlacementRequest &request, const Drawn &drawn, const glm::vec2 &root, uint64_t bits) const;

private:
	/// A species with plants/m² somewhere.
	struct Counted {
		int species = 0;
		double part = 1.0; ///< Its part of the layer, which several species may share.
	};

	std::vector<double> fractions; ///< Of the mix, by species; the sum is 1.
	std::vector<Counted> counted;

	double plants_at(const PlacementRequest &request, const Counted &one, const glm::vec2 &root) const;
	int pick_counted(const PlacementRequest &request, const glm::vec2 &root, double plants) const;
	int pick_other(const PlacementRequest &request, const glm::vec2 &root, double drawn, double keep) const;
	double filled_chance(const PlacementRequest &request, const glm::vec2 &root, bool without_counted) const;
};

} // namespace undergrowth
