#pragma once

#include "placement/area.hpp"
#include "placement/competition.hpp"
#include "placement/density_map.hpp"
#include "placement/habitats.hpp"
#include "placement/painted_mix.hpp"
#include "placement/plants.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace undergrowth {

struct AreaRow;
struct AreaSpan;
class NearEdges;

/// Distribution of one species.
struct PlacementSpecies {
	float weight = 1.0f; ///< Relative frequency, >= 0.
	int variants = 1; ///< 1 to 256.
	float min_scale = 1.0f; ///< > 0; scales are uniform from least to most.
	float max_scale = 1.0f;
	float height_deviation = 0.0f; ///< 0 to 1: heights are uniform in 1 ± this.
	float max_lean = 0.0f; ///< rad, 0 to π/2: leans are uniform up to this, in all directions.
	int layer = -1; ///< In the request's map; -1: none, and the map grows nothing of the species.
	bool is_absent = false; ///< True: positions of its plants stay empty; all other plants are the same as with it.
};

struct PlacementRequest {
	static constexpr double MAX_PLANTS = 4.0e6;
	static constexpr float MAX_DENSITY = 1.0e4f; ///< Plants/m²: one per square centimetre.
	static constexpr int MAX_SPECIES = 256;
	static constexpr float MAX_FALLOFF = 100.0f; ///< m.

	Polygon area;
	/// Limits the area's plants to those with roots in this box, its lower sides included, its upper sides excluded.
	std::optional<AreaBox> within;
	std::vector<Polygon> exclusions; ///< Polygons without area exclude nothing.
	float density = 1.0f; ///< Plants/m², 0 to MAX_DENSITY.
	std::vector<PlacementSpecies> species;
	uint64_t seed = 0;
	/// 0: each plant draws its species separately; 1: drifts of one species each, with frayed edges.
	float clumping = 0.0f;
	float drift_size = 3.0f; ///< m, between the centres of neighbouring drifts, >= 0.01.
	/// 0: each plant has its own direction; 1: the plants of a clump share direction, lean and height (Clump).
	float combed = 0.0f;
	/// m, 0 to MAX_FALLOFF: plants within this distance of an edge of the area or of an exclusion are lower and fewer
	/// (EdgeFalloff). With a map the area has no edges.
	float edge_falloff = 0.0f;
	/// Optional. Each species grows with the density and height of its layer (PaintedMix). Their sum is at most
	/// `density`.
	std::shared_ptr<const DensityMap> map;
	/// Not applied by Placement: thin_by_habitats() needs the ground.
	Habitats habitats;
	/// As `habitats`, with compete().
	Competition competition;
};

/// Bounding box of all possible plants. If there are none, its low exceeds its high on some axis.
AreaBox placed_box(const PlacementRequest &request);

enum class PlacementFault {
	none,
	bad_area, ///< See find_area_fault().
	bad_exclusion, ///< Not finite or too far.
	bad_density,
	no_species,
	too_many_species,
	bad_weight,
	no_weight, ///< All are 0.
	bad_variants,
	bad_scale,
	bad_deviation, ///< Of height or lean.
	bad_clumping, ///< Or drift size.
	bad_combed,
	bad_falloff,
	too_many_plants,
};

/// The first fault, in the order of the enumeration. Only Placement detects that an area which crosses itself has room
/// for too many plants.
PlacementFault find_placement_fault(const PlacementRequest &request);
/// One sentence for the author of the field: what is wrong and what to do.
const char *describe(PlacementFault fault);

/// Places the plants of a request: at most one in each cell of a grid of 1/density m² cells over the whole plane,
/// jittered. The seed and the cell determine everything about a plant. Another area or other exclusions add or remove
/// plants but change none, except for heights within an edge falloff. Rows can be placed separately, on several
/// threads, in any split. The expected count is density times area without an edge falloff; only the cells on its
/// border add chance to it.
class Placement {
public:
	/// Min distance of two plants, as a fraction of the spacing, 1/sqrt(density).
	static constexpr double MIN_DISTANCE = 0.3;

	/// Copies the request. A request with a fault has no rows.
	explicit Placement(const PlacementRequest &request);

	PlacementFault fault() const { return found; }
	/// Side of a cell (m).
	double cell_size() const { return spacing; }
	/// Rows of cells, along x, by increasing z.
	int row_count() const { return rows; }
	/// Appends the plants of rows [begin, end), y = 0. Consecutive ranges of rows give the same bytes as all rows at
	/// once. Changes nothing else, so several threads can fill their own plants.
	void place_rows(int begin, int end, FieldPlants &plants) const;
	/// Upper bound, not much larger than the number of plants in rows [begin, end).
	std::size_t candidate_count(int begin, int end) const;

private:
	PlacementRequest request;
	PlacementFault found;
	double spacing = 1.0; ///< m.
	int first_row = 0;
	int rows = 0;
	uint64_t cell_seed = 0;
	uint64_t drift_seed = 0;
	std::vector<double> shares; ///< Running sums by species.
	PaintedMix mix; ///< Used with a map.
	std::map<int, std::vector<int>> painted; ///< Used with a map: columns of non-empty blocks, by row.

	/// Its spans are cells: [first, last).
	AreaRow read_row(int row) const;
	void list_painted();
	/// Spans of a row of cells where the map may have something.
	std::vector<AreaSpan> painted_spans(int row) const;
	void place_cell(int column, int row, const AreaRow &edges, FieldPlants &plants) const;
	/// Whether a plant at `root` remains near the edges, and its factor of height. `where` is the hash of its cell.
	std::optional<float> height_at_edge(const glm::vec2 &root, const NearEdges &edges, uint64_t where) const;
	int pick_species(uint64_t bits) const;
	/// Directs a plant with its clump. `bits` are its own.
	void comb(const PlacementSpecies &species, uint64_t bits, PlacedPlant &plant) const;
	uint64_t drift_bits(double x, double z) const;
};

/// Replaces `plants` with all plants of the request, or none if it has a fault. Returns the fault.
PlacementFault place_plants(const PlacementRequest &request, FieldPlants &plants);

} // namespace undergrowth
