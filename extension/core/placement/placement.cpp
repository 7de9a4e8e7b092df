#include "placement/placement.hpp"

#include "base/bounded_whole.hpp"
#include "base/random.hpp"
#include "conventions.hpp"
#include "placement/area_row.hpp"
#include "placement/clump.hpp"
#include "placement/edge_falloff.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

/// Max distance of a plant from the centre of its cell, in cells.
constexpr double JITTER = 0.5 * (1.0 - Placement::MIN_DISTANCE);
/// Centres of cells in even and odd rows, in cells. The offset between rows hides the grid.
constexpr double EVEN_MIDDLE = 0.25;
constexpr double ODD_MIDDLE = 0.75;
/// Max distance of a drift's centre from the centre of its cell, and the fraying of its edge, in drifts.
constexpr double DRIFT_JITTER = 0.35;
constexpr double DRIFT_FRAY = 0.2;
constexpr double FULL_TURN = 2.0 * PI;
/// Factor of height that the plants of a clump share, to both sides of 1.
constexpr double CLUMP_HEIGHT = 0.25;
/// Gives painted jitter its own random numbers.
constexpr uint64_t JITTER_SEED = 0x6A09E667F3BCC909u;
/// Only an area that crosses itself many times can have plants in more cells.
constexpr std::size_t MAX_CANDIDATES = 4 * static_cast<std::size_t>(PlacementRequest::MAX_PLANTS);

/// The upper or the lower 32 bits as a number in [-1, 1).
double signed32(uint64_t bits, int half) {
	return static_cast<double>((bits >> (32 * half)) & 0xffffffff) * (2.0 / 4294967296.0) - 1.0;
}

uint64_t hash_cell(uint64_t seed, int column, int row) {
	const uint64_t key = (static_cast<uint64_t>(static_cast<uint32_t>(row)) << 32) | static_cast<uint32_t>(column);
	return mix_bits(seed ^ key);
}

double row_middle(int row) {
	return (row & 1) == 0 ? EVEN_MIDDLE : ODD_MIDDLE;
}

/// The bounds exceed all coordinates of a field. Only cells that are wider than a field get there.
int floor_to_int(double value) {
	constexpr int BOUND = 1000000000;
	return bounded_whole(std::floor(value), -BOUND, BOUND);
}

/// Changes scale and color by the painted jitter of a cell.
void add_jitter(const DensityCell &cell, uint64_t bits, PlacedPlant &plant) {
	const auto noise = [bits](int part) { return static_cast<float>(2.0 * unit16(bits, part) - 1.0); };
	if (cell.scale_jitter > 0) {
		plant.scale *= 1.0f + cell.scale_range() * noise(0);
	}
	if (cell.color_jitter > 0) {
		plant.lightness = cell.color_range() * noise(1);
		plant.warmth = cell.color_range() * noise(2);
	}
}

/// Margin around positions (m), much larger than the rounding of coordinates.
constexpr double SLACK = 0.01;

/// Cells that meet a span of x (m): [first, last).
AreaSpan cells_of(const AreaSpan &span, double spacing) {
	return { std::floor((span.low - SLACK) / spacing) - 1.0, std::floor((span.high + SLACK) / spacing) + 1.0 };
}

/// Intersection of two lists of joined spans.
std::vector<AreaSpan> common(const std::vector<AreaSpan> &some, const std::vector<AreaSpan> &others) {
	std::vector<AreaSpan> both;
	for (std::size_t i = 0, j = 0; i < some.size() && j < others.size();) {
		const AreaSpan met = { std::max(some[i].low, others[j].low), std::min(some[i].high, others[j].high) };
		if (met.low < met.high) {
			both.push_back(met);
		}
		(some[i].high < others[j].high ? i : j)++;
	}
	return both;
}

} // namespace

Placement::Placement(const PlacementRequest &wanted) : request(wanted), found(find_placement_fault(wanted)) {
	if (found != PlacementFault::none || request.density == 0.0f) {
		return;
	}
	spacing = 1.0 / std::sqrt(static_cast<double>(request.density));
	cell_seed = mix_bits(request.seed);
	drift_seed = mix_bits(cell_seed);
	double sum = 0.0;
	for (const PlacementSpecies &species : request.species) {
		sum += static_cast<double>(species.weight);
		shares.push_back(sum);
	}
	mix = PaintedMix(request);
	list_painted();
	const AreaBox box = placed_box(request);
	if (box.low.y > box.high.y) {
		return;
	}
	const AreaBox reached = { box.low - request.edge_falloff, box.high + request.edge_falloff };
	const auto is_elsewhere = [&](const Polygon &exclusion) {
		const AreaBox both = common_box(bounding_box(exclusion), reached);
		return both.low.x > both.high.x || both.low.y > both.high.y;
	};
	const auto begin = request.exclusions.begin();
	request.exclusions.erase(std::remove_if(begin, request.exclusions.end(), is_elsewhere), request.exclusions.end());
	first_row = floor_to_int(static_cast<double>(box.low.y) / spacing);
	rows = floor_to_int(static_cast<double>(box.high.y) / spacing) + 1 - first_row;
	if (candidate_count(0, rows) > MAX_CANDIDATES) {
		found = PlacementFault::too_many_plants;
		rows = 0;
	}
}

void Placement::list_painted() {
	for (const PlacementSpecies &species : request.species) {
		if (!request.map || species.layer < 0) {
			continue;
		}
		for (const auto &entry : request.map->blocks(species.layer)) {
			painted[entry.first.row].push_back(entry.first.column);
		}
	}
}

std::vector<AreaSpan> Placement::painted_spans(int row) const {
	const auto side = static_cast<double>(request.map->block_size());
	const auto begin = painted.lower_bound(floor_to_int((row * spacing - SLACK) / side));
	const auto end = painted.upper_bound(floor_to_int(((row + 1) * spacing + SLACK) / side));
	std::vector<AreaSpan> spans;
	for (auto blocks = begin; blocks != end; ++blocks) {
		for (const int column : blocks->second) {
			spans.push_back(cells_of({ column * side, (column + 1) * side }, spacing));
		}
	}
	join(spans);
	return spans;
}

AreaRow Placement::read_row(int row) const {
	const std::vector<AreaSpan> only = request.map ? painted_spans(row) : std::vector<AreaSpan>();
	if (request.map && only.empty()) {
		return AreaRow({}, {}, 0.0, 0.0);
	}
	AreaRow into(request.area, request.exclusions, row * spacing - SLACK, (row + 1) * spacing + SLACK);
	if (request.edge_falloff > 0.0f) {
		into.near = NearEdges(into.low, into.high, static_cast<double>(request.edge_falloff));
		if (!request.map) {
			into.near.add(request.area);
		}
		std::for_each(request.exclusions.begin(), request.exclusions.end(),
				[&](const Polygon &exclusion) { into.near.add(exclusion); });
	}
	for (AreaSpan &span : into.spans) {
		span = cells_of(span, spacing);
	}
	join(into.spans);
	if (request.within) {
		// The cell after the last one can have its plant before its side.
		const AreaSpan span = { request.within->low.x, request.within->high.x + spacing };
		into.spans = common(into.spans, { cells_of(span, spacing) });
	}
	if (request.map) {
		into.spans = common(into.spans, only);
	}
	return into;
}

std::size_t Placement::candidate_count(int begin, int end) const {
	double count = 0.0;
	for (int i = std::max(begin, 0); i < std::min(end, rows); i++) {
		const AreaRow row = read_row(first_row + i);
		for (const AreaSpan &span : row.spans) {
			count += span.high - span.low;
		}
	}
	return static_cast<std::size_t>(count);
}

void Placement::place_rows(int begin, int end, FieldPlants &plants) const {
	for (int i = std::max(begin, 0); i < std::min(end, rows); i++) {
		const AreaRow row = read_row(first_row + i);
		for (const AreaSpan &span : row.spans) {
			for (int column = static_cast<int>(span.low); column < static_cast<int>(span.high); column++) {
				place_cell(column, first_row + i, row, plants);
			}
		}
	}
}

void Placement::place_cell(int column, int row, const AreaRow &edges, FieldPlants &plants) const {
	const uint64_t where = hash_cell(cell_seed, column, row);
	const double x = (column + row_middle(row) + JITTER * signed32(where, 0)) * spacing;
	const double z = (row + 0.5 + JITTER * signed32(where, 1)) * spacing;
	const glm::vec2 root = { static_cast<float>(x), static_cast<float>(z) };
	if ((request.within && !is_in_box(*request.within, root)) || !edges.holds(root)) {
		return;
	}
	const std::optional<float> at_edge = height_at_edge(root, edges.near, where);
	if (!at_edge) {
		return;
	}
	const uint64_t kind = mix_bits(where);
	uint64_t species_bits = kind >> 32;
	const bool is_in_drift = unit16(kind, 0) < static_cast<double>(request.clumping);
	if (is_in_drift) {
		const uint64_t fray = mix_bits(kind ^ drift_seed);
		species_bits = drift_bits(x / static_cast<double>(request.drift_size) + DRIFT_FRAY * signed32(fray, 0),
				z / static_cast<double>(request.drift_size) + DRIFT_FRAY * signed32(fray, 1));
	}
	int number = pick_species(species_bits & 0xffffffff);
	const uint64_t shape = mix_bits(kind);
	number = request.map ? mix.choose(request, { number, is_in_drift }, root, mix_bits(shape)) : number;
	if (number < 0) {
		return;
	}
	const PlacementSpecies &species = request.species[static_cast<std::size_t>(number)];
	if (species.is_absent) {
		return;
	}
	const double scale_way = static_cast<double>(species.max_scale) - static_cast<double>(species.min_scale);
	const double height = 1.0 + static_cast<double>(species.height_deviation) * (2.0 * unit16(shape, 1) - 1.0);
	PlacedPlant plant;
	plant.root = { root.x, 0.0f, root.y };
	plant.scale = static_cast<float>(static_cast<double>(species.min_scale) + scale_way * unit16(shape, 0));
	plant.height = static_cast<float>(height);
	plant.lean = static_cast<float>(static_cast<double>(species.max_lean) * unit16(shape, 2));
	plant.turn = static_cast<float>(unit16(shape, 3) * FULL_TURN);
	plant.species = number;
	plant.variant = static_cast<int>(unit16(kind, 1) * species.variants);
	if (request.combed > 0.0f) {
		comb(species, mix_bits(shape ^ drift_seed), plant);
	}
	if (request.map) {
		const DensityCell cell = request.map->cell_at(species.layer, root);
		plant.height *= cell.height_factor();
		add_jitter(cell, mix_bits(shape ^ JITTER_SEED), plant);
	}
	plant.height *= *at_edge;
	plants.add(plant);
}

std::optional<float> Placement::height_at_edge(const glm::vec2 &root, const NearEdges &edges, uint64_t where) const {
	if (request.edge_falloff <= 0.0f) {
		return 1.0f;
	}
	const EdgeFalloff falloff =
			edge_falloff_at(root, edges.distance_to(root), static_cast<double>(request.edge_falloff));
	const bool remains = unit16(mix_bits(where ^ drift_seed), 0) < static_cast<double>(falloff.density);
	return remains ? std::optional(falloff.height) : std::nullopt;
}

void Placement::comb(const PlacementSpecies &species, uint64_t bits, PlacedPlant &plant) const {
	const double combed = static_cast<double>(request.combed);
	const double free = (1.0 - combed) * (1.0 - combed) * (1.0 - combed);
	const Clump clump = clump_at(static_cast<double>(plant.root.x), static_cast<double>(plant.root.z));
	plant.height *= static_cast<float>(1.0 + CLUMP_HEIGHT * combed * clump.height);
	plant.turn = static_cast<float>(clump.turn + free * (static_cast<double>(plant.turn) - PI));
	if (species.max_lean > 0.0f) { // To the plant's front (+z), or near it.
		const double shared = static_cast<double>(species.max_lean) * clump.lean;
		plant.lean = static_cast<float>(static_cast<double>(plant.lean) * (1.0 - combed) + shared * combed);
		plant.side = static_cast<float>(free * (unit16(bits, 0) - 0.5) * FULL_TURN - 0.5 * PI);
	}
}

int Placement::pick_species(uint64_t bits) const {
	const double drawn = static_cast<double>(bits) * (1.0 / 4294967296.0) * shares.back();
	return static_cast<int>(std::upper_bound(shares.begin(), shares.end(), drawn) - shares.begin());
}

uint64_t Placement::drift_bits(double x, double z) const {
	const int column = floor_to_int(x);
	const int row = floor_to_int(z);
	double nearest = 1.0e30;
	uint64_t winner = 0;
	for (int j = row - 1; j <= row + 1; j++) {
		for (int i = column - 1; i <= column + 1; i++) {
			const uint64_t bits = hash_cell(drift_seed, i, j);
			const double dx = i + 0.5 + DRIFT_JITTER * signed32(bits, 0) - x;
			const double dz = j + 0.5 + DRIFT_JITTER * signed32(bits, 1) - z;
			const double distance = dx * dx + dz * dz;
			if (distance < nearest) {
				nearest = distance;
				winner = bits;
			}
		}
	}
	return mix_bits(winner);
}

PlacementFault place_plants(const PlacementRequest &request, FieldPlants &plants) {
	plants.clear();
	const Placement placement(request);
	plants.reserve(placement.candidate_count(0, placement.row_count()));
	placement.place_rows(0, placement.row_count(), plants);
	return placement.fault();
}

} // namespace undergrowth
