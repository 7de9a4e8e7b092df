#pragma once

#include "stand/area.hpp"
#include "stand/density_map.hpp"
#include "stand/painted_mix.hpp"
#include "stand/plants.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace undergrowth {

struct AreaRow;
struct AreaSpan;

/// How one species is spread.
struct PlacementSpecies {
	float share = 1.0f; ///< Weight among all species, >= 0.
	int variants = 1; ///< 1 to 256.
	float least_scale = 1.0f; ///< > 0; scales are uniform from least to most.
	float most_scale = 1.0f;
	float height_deviation = 0.0f; ///< 0 to 1: heights are uniform in 1 ± this.
	float most_lean = 0.0f; ///< rad, 0 to π/2: leans are uniform up to it, to all sides.
	int layer = -1; ///< Of the request's map; -1: it has none, and nothing grows by the map.
	bool is_absent = false; ///< Its places stay empty, and all others have the plants that they have beside it.
};

struct PlacementRequest {
	static constexpr double MOST_PLANTS = 4.0e6;
	static constexpr float MOST_DENSITY = 1.0e4f; ///< Plants/m²: one on each square centimetre.
	static constexpr int MOST_SPECIES = 256;

	Polygon area;
	/// Of the area's plants only those with their roots in this box: on its lower sides included, on the others not.
	std::optional<AreaBox> within;
	std::vector<Polygon> exclusions; ///< Those without area exclude nothing.
	float density = 1.0f; ///< Plants/m², 0 to MOST_DENSITY.
	std::vector<PlacementSpecies> species;
	uint64_t seed = 0;
	/// 0: each plant draws its species alone; 1: drifts of one species each, with frayed edges.
	float clumping = 0.0f;
	float drift_size = 3.0f; ///< m, from one drift's middle to the next, >= 0.01.
	/// With it each species grows as its layer says (PaintedMix), and as high. Their sum is at most `density`.
	std::shared_ptr<const DensityMap> map;
};

/// Around all that may stand; where nothing may, some side of it is below 0.
AreaBox placed_box(const PlacementRequest &request);

enum class PlacementFault {
	none,
	bad_area, ///< See find_area_fault().
	bad_exclusion, ///< Not finite or too far.
	bad_density,
	no_species,
	too_many_species,
	bad_share,
	no_share, ///< All are 0.
	bad_variants,
	bad_scale,
	bad_deviation, ///< Of height or lean.
	bad_clumping, ///< Or drift size.
	too_many_plants,
};

/// The first fault, in the order of the enumeration. Only Placement finds that an area which crosses itself has room
/// for too many plants.
PlacementFault find_placement_fault(const PlacementRequest &request);
/// One sentence for the author of the field: what is wrong and what to do.
const char *describe(PlacementFault fault);

/// Where the plants of a request stand: one at most in each cell of a grid of 1/density m² cells over the whole plane,
/// jittered. Everything about a plant follows from the seed and its cell: another area or other exclusions add or
/// remove plants but change none, and rows may be placed apart, on several threads, in any split. The expected count is
/// density times area; the grid leaves no more to chance than the cells on its border.
class Placement {
public:
	/// No two plants are closer than this times the spacing, 1/sqrt(density).
	static constexpr double LEAST_DISTANCE = 0.3;

	/// A copy of the request is kept. Where it has a fault there are no rows.
	explicit Placement(const PlacementRequest &request);

	PlacementFault fault() const { return found; }
	/// The side of a cell (m).
	double cell_size() const { return spacing; }
	/// Rows of cells, along x, by increasing z.
	int row_count() const { return rows; }
	/// Appends the plants of rows [begin, end), y = 0. Rows placed one after the other in any ranges give the same
	/// bytes as all at once. Changes nothing else: several threads may fill plants of their own.
	void place_rows(int begin, int end, FieldPlants &plants) const;
	/// At least as many plants as rows [begin, end) give, and few more.
	std::size_t candidate_count(int begin, int end) const;

private:
	PlacementRequest request;
	PlacementFault found;
	double spacing = 1.0; ///< m.
	int first_row = 0;
	int rows = 0;
	uint64_t cell_seed = 0;
	uint64_t drift_seed = 0;
	std::vector<double> shares; ///< Summed up to each species.
	PaintedMix mix; ///< With a map.
	std::map<int, std::vector<int>> painted; ///< With a map: columns of blocks that have something, by row.

	/// Its spans are cells: from the first to before the last.
	AreaRow read_row(int row) const;
	void list_painted();
	/// Where in a row of cells there may be something of the map.
	std::vector<AreaSpan> painted_spans(int row) const;
	void place_cell(int column, int row, const AreaRow &edges, FieldPlants &plants) const;
	int pick_species(uint64_t bits) const;
	uint64_t drift_bits(double x, double z) const;
};

/// Replaces `plants` by all that the request asks for; none where it has a fault, which it tells.
PlacementFault place_plants(const PlacementRequest &request, FieldPlants &plants);

} // namespace undergrowth
