// Times the core on one thread and prints a JSON list: a row for each law's step at each level that this processor has,
// and one for building meshes. "us_per_plant" is the median run's time per plant and step (or per mesh).

#include "mesh/plant_mesh.hpp"
#include "pendulum/batch.hpp"
#include "plant/base_shape.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <vector>

using namespace undergrowth;

namespace {

constexpr int RUNS = 101;
constexpr int PLANTS = 10000;
constexpr int STEPS_PER_RUN = 20;
constexpr int MESHES = 500;
constexpr int RING_POINTS = 16;
constexpr int LOD = 16;

/// The median time of `RUNS` runs (ms), after one that warms up.
template <class Work> double median_ms(const Work &work) {
	std::vector<double> times;
	for (int i = 0; i <= RUNS; i++) {
		const auto start = std::chrono::steady_clock::now();
		work();
		const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
		if (i > 0) {
			times.push_back(spent.count());
		}
	}
	std::nth_element(times.begin(), times.begin() + RUNS / 2, times.end());
	return times[RUNS / 2];
}

void print_row(const char *name, int plants, double milliseconds, const char *level, bool last) {
	std::printf("  {\"name\": \"%s\", \"plants\": %d, \"threads\": 1, \"median_ms\": %.6f, \"us_per_plant\": %.6f, "
				"\"level\": \"%s\"}%s\n",
			name, plants, milliseconds, 1000.0 * milliseconds / plants, level, last ? "" : ",");
}

PendulumBatch meadow(Law law) {
	PendulumBatch batch(law, 1.0f / 60.0f);
	for (int i = 0; i < PLANTS; i++) {
		const float part = static_cast<float>(i) / PLANTS;
		Joint joint;
		joint.length = 0.3f + 1.5f * part;
		joint.natural_frequency = 0.5f + 2.0f * part;
		batch.add(joint, { { 0.3f * part, 1.0f, 0.1f }, { 0.0f, 0.0f, part } });
	}
	return batch;
}

void time_steps(const char *name, Law law, SimdLevel level) {
	PendulumBatch batch = meadow(law);
	const double run = median_ms([&] {
		for (int i = 0; i < STEPS_PER_RUN; i++) {
			batch.step(0, PLANTS, { 2.0f, 0.0f, 1.0f }, level);
		}
	});
	print_row(name, PLANTS, run / STEPS_PER_RUN, level == SimdLevel::avx2 ? "avx2" : "baseline", false);
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

void time_meshes() {
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
	print_row("mesh", MESHES, run, "baseline", true);
}

} // namespace

int main() {
	std::printf("[\n");
	for (const SimdLevel level : { SimdLevel::baseline, SimdLevel::avx2 }) {
		if (level <= best_simd_level()) {
			time_steps("step_elasticity", Law::elasticity, level);
			time_steps("step_spring", Law::spring, level);
		}
	}
	time_meshes();
	std::printf("]\n");
	return 0;
}
