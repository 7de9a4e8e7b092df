#include "mesh/plant_mesh.hpp"

#include "mesh/mesh_parts.hpp"

namespace undergrowth {

MeshCounts count_mesh(int points, int lod, Shading shading) {
	const int triangles = 2 * points * lod + 2 * (points - 2);
	if (shading == Shading::flat) {
		return { 3 * triangles, 3 * triangles };
	}
	return { (lod + 1) * (points + 1) + 2 * points, 3 * triangles };
}

void build_mesh(const PlantSample &sample, const MeshOptions &options, const MeshBuffers &buffers) {
	const RingPlacer placer(sample, options);
	if (options.shading == Shading::flat) {
		build_flat_mesh(sample, placer, buffers);
	} else {
		build_smooth_mesh(sample, placer, buffers);
	}
	const int points = placer.points();
	write_bones(count_mesh(points, sample.lod, options.shading).vertices, buffers.bones);
}

} // namespace undergrowth
