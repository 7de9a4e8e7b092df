#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

struct PlacementRequest;

/// Chooses the species at each position of a painted field. Each layer with plants/m² is chosen with the probability
/// that gives these. The rest is the mix, where each species grows with the probability of its density. Painted plants
/// first use the positions that the mix leaves empty, then those of its plants. Without plants/m² at a position the mix
/// alone decides, with the same bits. If the sum of plants/m² exceeds the field's density, all are reduced in
/// proportion.
class PaintedMix {
public:
	/// Draw of the mix at a position.
	struct Drawn {
		int species = 0;
		/// True: the species is that of the drift. False: it was drawn for this position alone.
		bool is_in_drift = false;
	};

	/// Without a map.
	PaintedMix() = default;
	/// The request must have a map and no fault. The functions below need the same request.
	explicit PaintedMix(const PlacementRequest &request);

	/// Returns the species that grows at `root` (m), or -1. `bits` are random, and different for each position.
	int choose(const PlacementRequest &request, const Drawn &drawn, const glm::vec2 &root, uint64_t bits) const;

private:
	/// A species with plants/m² somewhere.
	struct Counted {
		int species = 0;
		double part = 1.0; ///< Its part of the layer, which several species can share.
	};

	std::vector<double> fractions; ///< Of the mix, by species; their sum is 1.
	std::vector<Counted> counted;

	double plants_at(const PlacementRequest &request, const Counted &one, const glm::vec2 &root) const;
	int pick_counted(const PlacementRequest &request, const glm::vec2 &root, double plants) const;
	int pick_other(const PlacementRequest &request, const glm::vec2 &root, double drawn, double keep) const;
	double filled_chance(const PlacementRequest &request, const glm::vec2 &root, bool without_counted) const;
};

} // namespace undergrowth
