// Times the core and prints a JSON list of rows: each law's step at each level that this processor has, whole steps of
// fields of plants, contact, building meshes, and what one core can do at most: arithmetic without fused operations,
// and moving the bytes that a step of so many plants moves. "us_per_plant" is the median run's time per plant and step
// (or per mesh). Rows of steps tell what share of both ceilings at their level they reach.

#include "base/random.hpp"
#include "field/contact.hpp"
#include "field/field_simulation.hpp"
#include "mesh/plant_mesh.hpp"
#include "pendulum/batch.hpp"
#include "plant/base_shape.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

using namespace undergrowth;

namespace {

constexpr int RUNS = 101;
constexpr int FEW_RUNS = 31;
constexpr int PLANTS_PER_RUN = 200000; // At least, so that the clock's own time does not count.
constexpr int MESHES = 500;
constexpr int RING_POINTS = 16;
constexpr int LOD = 16;

/// The median time of `runs` runs (ms), after some that warm up.
template <class Work> double median_ms(const Work &work, int runs = RUNS) {
	constexpr int WARM_UP = 3;
	std::vector<double> times;
	for (int i = -WARM_UP; i < runs; i++) {
		const auto start = std::chrono::steady_clock::now();
		work();
		const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
		if (i >= 0) {
			times.push_back(spent.count());
		}
	}
	std::nth_element(times.begin(), times.begin() + runs / 2, times.end());
	return times[static_cast<std::size_t>(runs / 2)];
}

/// All rows, with commas between them.
class Report {
public:
	/// `more`: further members, each with a comma before it.
	void row(const char *name, int plants, int threads, double milliseconds, SimdLevel level,
			const std::string &more = "") {
		std::printf("%s  {\"name\": \"%s\", \"plants\": %d, \"threads\": %d, \"median_ms\": %.6f, "
					"\"us_per_plant\": %.6f, \"level\": \"%s\"%s}",
				started ? ",\n" : "[\n", name, plants, threads, milliseconds, 1000.0 * milliseconds / plants,
				level == SimdLevel::avx2 ? "avx2" : "baseline", more.c_str());
		started = true;
	}
	void end() const { std::printf("\n]\n"); }

private:
	bool started = false;
};

std::string member(const char *name, double value) {
	char text[80];
	std::snprintf(text, sizeof text, ", \"%s\": %.4f", name, value);
	return text;
}

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
	int floats; ///< Of the table, per plant.
};
constexpr StepCost STEPS[] = {
	{ "step_elasticity", Law::elasticity, 48.0, 80.0, 14 },
	{ "step_spring", Law::spring, 30.0, 68.0, 13 },
};

/// Operations per ns.
double time_compute(Report &report, SimdLevel level) {
	alignas(64) float sink[16] = {};
	const double run = median_ms([&] { level == SimdLevel::avx2 ? run_chains_32(sink) : run_chains_16(sink); });
	const double lanes = static_cast<double>(level == SimdLevel::avx2 ? sizeof(Lanes32) : sizeof(Lanes16)) / 4.0;
	const double rate = 2.0 * CHAINS * ROUNDS * lanes / (run * 1e6);
	report.row("ceiling_compute", ROUNDS, 1, run, level, member("gflops", rate));
	return rate;
}

/// Bytes per ns, in as much memory as the elasticity law's table of so many plants.
double time_memory(Report &report, int plants, SimdLevel level) {
	const int half = plants * STEPS[0].floats / 2 / 16 * 16;
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

PendulumBatch meadow(Law law, int plants) {
	PendulumBatch batch(law, 1.0f / 60.0f);
	for (int i = 0; i < plants; i++) {
		const float part = static_cast<float>(i) / static_cast<float>(plants);
		Joint joint;
		joint.length = 0.3f + 1.5f * part;
		joint.natural_frequency = 0.5f + 2.0f * part;
		batch.add(joint, { { 0.3f * part, 1.0f, 0.1f }, { 0.0f, 0.0f, part } });
	}
	return batch;
}

void time_steps(Report &report, const StepCost &cost, int plants, SimdLevel level, double compute, double memory) {
	PendulumBatch batch = meadow(cost.law, plants);
	const int repeats = std::max(PLANTS_PER_RUN / plants, 1);
	const double run = median_ms([&] {
		for (int i = 0; i < repeats; i++) {
			batch.step(0, plants, { 2.0f, 0.0f, 1.0f }, level);
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

/// Threads that wait, spinning, for pages to step.
class PageWorkers {
public:
	explicit PageWorkers(int count) {
		for (int i = 1; i < count; i++) {
			threads.emplace_back([this] { work(); });
		}
	}
	PageWorkers(const PageWorkers &) = delete;
	PageWorkers &operator=(const PageWorkers &) = delete;
	~PageWorkers() {
		stopping = true;
		round++;
		for (std::thread &thread : threads) {
			thread.join();
		}
	}

	void step(FieldSimulation &which) {
		which.begin_step();
		field = &which;
		next_page = 0;
		busy = static_cast<int>(threads.size());
		round++;
		take_pages();
		while (busy.load() > 0) {
			std::this_thread::yield();
		}
	}

private:
	static constexpr int PAGES_AT_ONCE = 2;

	std::vector<std::thread> threads;
	std::atomic<FieldSimulation *> field = nullptr;
	std::atomic<int> next_page = 0;
	std::atomic<int> busy = 0;
	std::atomic<int> round = 0;
	std::atomic<bool> stopping = false;

	void take_pages() {
		FieldSimulation &which = *field.load();
		for (int page = next_page.fetch_add(PAGES_AT_ONCE); page < which.page_count();
				page = next_page.fetch_add(PAGES_AT_ONCE)) {
			which.step_pages(page, page + PAGES_AT_ONCE);
		}
	}

	void work() {
		for (int seen = 0;;) {
			while (round.load() == seen) {
				std::this_thread::yield();
			}
			seen = round.load();
			if (stopping) {
				return;
			}
			take_pages();
			busy--;
		}
	}
};

/// Half of each law, under waves.
FieldSimulation waving_field(const FieldSettings &settings, int plants) {
	FieldSimulation field(settings);
	const int page_size = std::clamp(plants / 16, 256, FieldPage::PAGE_PLANTS);
	for (const Law law : { Law::elasticity, Law::spring }) {
		FieldSpecies species;
		species.law = law;
		const int kind = field.add_species(species);
		std::vector<FieldPlant> page;
		for (int i = 0; i < plants / 2; i++) {
			const auto noise = [i, kind](uint64_t which) {
				return signed_noise(which + 100 * static_cast<uint64_t>(kind), static_cast<uint64_t>(i));
			};
			FieldPlant plant;
			plant.root = { 80.0f * noise(1), 0.0f, 80.0f * noise(2) };
			plant.length = 0.75f + 0.25f * noise(3);
			page.push_back(plant);
			if (static_cast<int>(page.size()) == page_size || i == plants / 2 - 1) {
				field.add_page(kind, page.data(), static_cast<int>(page.size()));
				page.clear();
			}
		}
	}
	FieldWind wind;
	wind.wind.kind = WindKind::waves;
	wind.wind.strength = 2.0f;
	field.set_wind(wind);
	return field;
}

void time_field(Report &report, const char *name, const FieldSettings &settings, int plants, int threads) {
	FieldSimulation field = waving_field(settings, plants);
	PageWorkers workers(threads);
	// Whole turns of the interval, so that every run does the same.
	const int repeats = std::max(PLANTS_PER_RUN / plants, 1) * settings.update_interval;
	const double run = median_ms(
							   [&] {
								   for (int i = 0; i < repeats; i++) {
									   workers.step(field);
								   }
							   },
							   FEW_RUNS) /
			repeats;
	report.row(name, plants, threads, run, best_simd_level(), member("bytes_per_plant", field.bytes_per_plant()));
}

void time_fields(Report &report) {
	FieldSettings interval_4;
	interval_4.update_interval = 4;
	FieldSettings prototypes_64;
	prototypes_64.prototypes = 64;
	FieldSettings drawn_prototypes = prototypes_64;
	drawn_prototypes.write_followers = false;
	const bool has_four = std::thread::hardware_concurrency() >= 4;
	for (const int plants : { 1000, 10000, 100000, 1000000 }) {
		for (const int threads : { 1, 4 }) {
			if (threads == 1 || has_four) {
				time_field(report, "field_step", {}, plants, threads);
				time_field(report, "field_step_interval_4", interval_4, plants, threads);
				time_field(report, "field_step_prototypes_64", prototypes_64, plants, threads);
			}
		}
		time_field(report, "field_step_prototypes_64_drawn", drawn_prototypes, plants, 1);
	}
}

void time_contact(Report &report) {
	constexpr int PLANTS = 100000;
	FieldSimulation field = waving_field({}, PLANTS);
	TipContact contact;
	contact.fit(field);
	for (int i = 0; i < 60; i++) {
		field.step();
	}
	const double run = median_ms([&] { contact.resolve(field); }, FEW_RUNS);
	report.row("field_contact", PLANTS, 1, run, best_simd_level());
}

/// A mesh with all attributes, in memory that is taken once.
class MeshRoom {
public:
	explicit MeshRoom(const MeshCounts &counts) :
			positions(size(counts.vertices)),
			normals(size(counts.vertices)),
			colors(size(counts.vertices)),
			uvs(size(counts.vertices)),
			bones(4 * size(counts.vertices)),
			weights(4 * size(counts.vertices)),
			indices(size(counts.indices)) {}

	MeshBuffers buffers() {
		return { positions.data(), normals.data(), colors.data(), uvs.data(), bones.data(), weights.data(),
			indices.data() };
	}

private:
	std::vector<glm::vec3> positions;
	std::vector<glm::vec3> normals;
	std::vector<glm::vec4> colors;
	std::vector<glm::vec2> uvs;
	std::vector<int32_t> bones;
	std::vector<float> weights;
	std::vector<int32_t> indices;

	static std::size_t size(int count) { return static_cast<std::size_t>(count); }
};

void time_meshes(Report &report) {
	const CrossSection section = make_cross_section(circle_ring(RING_POINTS));
	const std::vector<float> widths(LOD + 1, 0.5f);
	const std::vector<glm::vec4> colors(LOD + 1, glm::vec4(0.2f, 0.8f, 0.2f, 1.0f));
	PlantSample sample;
	sample.cross_section = &section;
	sample.widths = widths.data();
	sample.colors = colors.data();
	sample.lod = LOD;
	MeshRoom room(count_mesh(RING_POINTS, LOD, Shading::smooth));
	const MeshBuffers buffers = room.buffers();
	const double run = median_ms([&] {
		for (int i = 0; i < MESHES; i++) {
			build_mesh(sample, MeshOptions{}, buffers);
		}
	});
	report.row("mesh", MESHES, 1, run, SimdLevel::baseline);
}

} // namespace

int main() {
	Report report;
	for (const SimdLevel level : { SimdLevel::baseline, SimdLevel::avx2 }) {
		if (level <= best_simd_level()) {
			time_level(report, level);
		}
	}
	time_fields(report);
	time_contact(report);
	time_meshes(report);
	report.end();
	return 0;
}
