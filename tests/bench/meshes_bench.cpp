// Building the meshes of plants.

#include "mesh/plant_mesh.hpp"
#include "plant/base_shape.hpp"
#include "report.hpp"

using namespace undergrowth;

namespace {

constexpr int MESHES = 500;
constexpr int RING_POINTS = 16;
constexpr int LOD = 16;

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

} // namespace

void undergrowth::time_meshes(Report &report) {
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
