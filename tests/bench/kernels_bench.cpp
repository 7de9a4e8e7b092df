// Each law's step at each level that this processor has, beside what one core can do at most at that level.

#include "motion/joint_constants.hpp"
#include "motion/kernel_tables.hpp"
#include "motion/motion_page.hpp"
#include "report.hpp"
#include "stem/stem_beam.hpp"

using namespace undergrowth;

namespace {

// What one core can do. Vectors are those of each level; without vector types of the compiler, single floats.

#if defined(__GNUC__)
using Lanes16 = float __attribute__((vector_size(16)));
using Lanes32 = float __attribute__((vector_size(32)));
#else
using Lanes16 = float;
using Lanes32 = float;
#endif
#if defined(__GNUC__) && defined(__x86_64__)
#define FOR_AVX2 __attribute__((target("avx2")))
#else
#define FOR_AVX2
#endif

constexpr int CHAINS = 12; // As many as leave registers for the two constants, and enough to hide the latency.
constexpr int ROUNDS = 100000;

/// Twelve chains of a product and a sum. A macro of a body, because a function for other instructions is not inlined.
#define CHAIN_BODY(Lanes)                                                                                              \
	Lanes chains[CHAINS];                                                                                              \
	const Lanes factor = Lanes{} + 0.999f;                                                                             \
	const Lanes summand = Lanes{} + 0.001f;                                                                            \
	for (int i = 0; i < CHAINS; i++) {                                                                                 \
		chains[i] = Lanes{} + static_cast<float>(i);                                                                   \
	}                                                                                                                  \
	for (int round = 0; round < ROUNDS; round++) {                                                                     \
		chains[0] = chains[0] * factor + summand;                                                                      \
		chains[1] = chains[1] * factor + summand;                                                                      \
		chains[2] = chains[2] * factor + summand;                                                                      \
		chains[3] = chains[3] * factor + summand;                                                                      \
		chains[4] = chains[4] * factor + summand;                                                                      \
		chains[5] = chains[5] * factor + summand;                                                                      \
		chains[6] = chains[6] * factor + summand;                                                                      \
		chains[7] = chains[7] * factor + summand;                                                                      \
		chains[8] = chains[8] * factor + summand;                                                                      \
		chains[9] = chains[9] * factor + summand;                                                                      \
		chains[10] = chains[10] * factor + summand;                                                                    \
		chains[11] = chains[11] * factor + summand;                                                                    \
	}                                                                                                                  \
	for (int i = 1; i < CHAINS; i++) {                                                                                 \
		chains[0] += chains[i];                                                                                        \
	}                                                                                                                  \
	*reinterpret_cast<Lanes *>(out) = chains[0];

/// `out` is aligned and holds 8 floats.
void run_chains_16(float *out){ CHAIN_BODY(Lanes16) } FOR_AVX2 void run_chains_32(float *out) {
	CHAIN_BODY(Lanes32)
}

/// Reads twice as much as it writes, in place, as steps do: to[i] += from[i], in vectors.
void move_16(const float *from, float *to, int count) {
	constexpr int LANES = static_cast<int>(sizeof(Lanes16) / sizeof(float));
	for (int i = 0; i < count / LANES; i++) {
		reinterpret_cast<Lanes16 *>(to)[i] += reinterpret_cast<const Lanes16 *>(from)[i];
	}
}
FOR_AVX2 void move_32(const float *from, float *to, int count) {
	constexpr int LANES = static_cast<int>(sizeof(Lanes32) / sizeof(float));
	for (int i = 0; i < count / LANES; i++) {
		reinterpret_cast<Lanes32 *>(to)[i] += reinterpret_cast<const Lanes32 *>(from)[i];
	}
}

/// What a step of one law costs by its source: sums, products, comparisons, divisions and roots one each, and the bytes
/// of the columns that it reads and writes.
struct StepCost {
	const char *name;
	Law law;
	double operations;
	double bytes;
	bool is_whole; ///< With its wind and its bends, as a field's page does it; else the law's kernel alone.
	bool leans = true; ///< Its plants do, as most in a field.
	int modes = 1; ///< Of a stem.
	float newtons = 2.0f; ///< So strong a wind; in a gale, stems go the long way through their step.
	bool by_height = false; ///< Stems whose frequencies follow from their height.
};
constexpr float GALE = 200.0f; // N: twenty times what bends a tip to 45°.
constexpr StepCost STEPS[] = {
	{ "step_elasticity", Law::elasticity, 48.0, 52.0, false },
	{ "step_spring", Law::spring, 30.0, 44.0, false },
	{ "page_elasticity", Law::elasticity, 57.0, 76.0, true },
	{ "page_spring", Law::spring, 43.0, 68.0, true },
	{ "page_stem", Law::stem, 102.0, 68.0, true },
	{ "page_stem_upright", Law::stem, 88.0, 60.0, true, false },
	{ "page_stem_two_modes", Law::stem, 165.0, 124.0, true, true, 2 },
	{ "page_stem_gale", Law::stem, 140.0, 92.0, true, true, 1, GALE, true },
	{ "page_stem_two_modes_gale", Law::stem, 203.0, 164.0, true, true, 2, GALE, true },
};
constexpr int PAGE_FLOATS = 13; // Of a page's table, per plant.
constexpr int COLUMNS = 7; // Of a kernel.
constexpr int AT_ONCE = 512; // Plants whose winds are sampled together.

/// Operations per ns.
double time_compute(Report &report, SimdLevel level) {
	alignas(64) float sink[16] = {};
	const double run = median_ms([&] { level == SimdLevel::avx2 ? run_chains_32(sink) : run_chains_16(sink); });
	const double lanes = static_cast<double>(level == SimdLevel::avx2 ? sizeof(Lanes32) : sizeof(Lanes16)) / 4.0;
	const double rate = 2.0 * CHAINS * ROUNDS * lanes / (run * 1e6);
	report.row("ceiling_compute", ROUNDS, 1, run, level, member("gflops", rate));
	return rate;
}

/// Bytes per ns, for the memory size of the elasticity law's table of that many plants.
double time_memory(Report &report, int plants, SimdLevel level) {
	const int half = plants * PAGE_FLOATS / 2 / 16 * 16;
	struct alignas(64) Line {
		float values[16] = {};
	};
	std::vector<Line> from(static_cast<std::size_t>(half / 16));
	std::vector<Line> to(static_cast<std::size_t>(half / 16));
	const int repeats = std::max(PLANTS_PER_RUN / plants, 1);
	const double run = median_ms([&] {
		for (int i = 0; i < repeats; i++) {
			(level == SimdLevel::avx2 ? move_32 : move_16)(from.data()->values, to.data()->values, half);
		}
	});
	const double rate = 3.0 * sizeof(float) * half * repeats / (run * 1e6);
	report.row("ceiling_memory", plants, 1, run / repeats, level, member("gb_per_s", rate));
	return rate;
}

/// Pages of a field's size.
std::vector<MotionPage> meadow(const StepCost &cost, int plants) {
	constexpr float SLOPE_PER_NEWTON = 0.1f;
	MotionSpecies species;
	species.law = cost.law;
	if (cost.law == Law::stem) {
		StemBeam beam;
		beam.length = 1.0f;
		beam.modes = cost.modes;
		beam.natural_frequency = cost.by_height ? 0.0f : beam.natural_frequency;
		beam.diameter = 0.005f; // Upright by its own stiffness.
		species.stem = solve_stem(beam).constants;
		species.stem.dead_slope = SLOPE_PER_NEWTON;
	}
	std::vector<MotionPage> pages;
	for (int begin = 0; begin < plants; begin += MotionPage::PAGE_PLANTS) {
		std::vector<MotionPlant> some;
		for (int i = begin; i < std::min(begin + MotionPage::PAGE_PLANTS, plants); i++) {
			some.emplace_back();
			some.back().length = 0.3f + 1.5f * static_cast<float>(i) / static_cast<float>(plants);
			some.back().rest = { cost.leans ? 0.1f : 0.0f, 1.0f, 0.0f };
		}
		pages.emplace_back(0, species, some.data(), static_cast<int>(some.size()), 1.0f / 60.0f, true);
	}
	return pages;
}

/// The kernels' own columns, in upright plants.
class Rows {
public:
	Rows(int plants, Law species_law) :
			count(plants), law(species_law), values(static_cast<std::size_t>(COLUMNS) * stride()) {
		std::vector<float> lengths;
		for (int i = 0; i < plants; i++) {
			lengths.push_back(0.3f + 1.5f * static_cast<float>(i) / static_cast<float>(plants));
		}
		constexpr float STEP = 1.0f / 60.0f;
		const Joint joint = safe_joint({});
		if (law == Law::elasticity) {
			elastic = elasticity_constants(joint, STEP);
			elasticity_weights(joint, STEP, lengths.data(), plants, column(6));
			std::fill(column(1), column(1) + plants, 1.0f);
		} else {
			spring = spring_constants(joint, STEP);
			spring_gains(spring, lengths.data(), plants, column(6));
		}
	}

	void step(SimdLevel level) {
		const PlantWinds winds = { strengths.data(), 0.8f, 0.6f };
		for (int begin = 0; begin < count; begin += AT_ONCE) {
			const int some = std::min(AT_ONCE, count - begin);
			const auto at = [&](int which) { return column(which) + begin; };
			if (law == Law::elasticity) {
				kernels(level).step_elasticity({ at(0), at(1), at(2), at(3), at(4), at(5), at(6), elastic.lift_share,
													   elastic.wind_share, elastic.keep, elastic.lowest_y },
						some, winds);
			} else {
				kernels(level).step_spring(
						{ at(0), at(1), at(2), at(3), at(4), at(5), at(6), spring.place_from_place,
								spring.place_from_rate, spring.rate_from_place, spring.rate_from_rate, MAX_GNOMONIC },
						some, winds);
			}
		}
	}

private:
	int count;
	Law law;
	std::vector<float> values;
	std::vector<float> strengths = std::vector<float>(AT_ONCE, 2.0f);
	ElasticityConstants elastic = {};
	SpringConstants spring = {};

	/// Not a whole number of memory pages, as in Columns.
	std::size_t stride() const { return static_cast<std::size_t>(count) + 80; }
	float *column(int which) { return values.data() + static_cast<std::size_t>(which) * stride(); }
};

void time_steps(Report &report, const StepCost &cost, int plants, SimdLevel level, double compute, double memory) {
	std::vector<MotionPage> pages = meadow(cost, plants);
	Rows rows(plants, cost.is_whole ? Law::spring : cost.law);
	WindSnapshot wind = {};
	wind.steady = cost.newtons;
	const int repeats = std::max(PLANTS_PER_RUN / plants, 1);
	const auto step = [&] {
		if (!cost.is_whole) {
			rows.step(level);
			return;
		}
		for (MotionPage &page : pages) {
			page.step(wind, { nullptr, 0.8f, 0.6f }, level);
		}
	};
	const double run = median_ms([&] {
		for (int i = 0; i < repeats; i++) {
			step();
		}
	}) / repeats;
	const double per_ns = plants / (run * 1e6);
	report.row(cost.name, plants, 1, run, level,
			member("g_plant_steps", per_ns) + member("compute_share", per_ns * cost.operations / compute) +
					member("memory_share", per_ns * cost.bytes / memory));
}

void time_level(Report &report, SimdLevel level) {
	const double compute = time_compute(report, level);
	for (const int plants : { 10000, 100000 }) {
		const double memory = time_memory(report, plants, level);
		for (const StepCost &cost : STEPS) {
			time_steps(report, cost, plants, level, compute, memory);
		}
	}
}

} // namespace

void undergrowth::time_kernels(Report &report) {
	for (const SimdLevel level : { SimdLevel::baseline, SimdLevel::avx2 }) {
		if (level <= best_simd_level()) {
			time_level(report, level);
		}
	}
}
