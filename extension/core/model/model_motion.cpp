#include "model/model_motion.hpp"

#include "model/model_bones.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>

namespace undergrowth {

namespace {

constexpr int BINS = 8; // Along the stem: loads within one bin are combined.
constexpr float SHEET_MASS = 0.2f; // kg/m², as in mesh/form_stem.cpp.
constexpr float SHEET_DRAG = 0.7f;
constexpr float MIN_DIAMETER = 2e-4f; // m.
constexpr float MAX_DIAMETER = 0.1f; // Of the height.
constexpr float SLENDER = 0.08f; // Mean radius of a stem over the height; wider bodies are tufts and bushes.
constexpr float UNSEEN = 0.02f; // Of the height: diameter of a stem inside of them.
constexpr float MAX_TAPER = 0.9f;
constexpr float MAX_MASS = 1000.0f; // kg: describe(StemFault).
constexpr float MAX_AREA = 100.0f; // m².

void place_vertices(const std::vector<ModelSurface> &surfaces, const ModelFrame &frame, ModelVertices &vertices) {
	for (const ModelSurface &surface : surfaces) {
		for (int i = 0; i < surface.vertices; i++) {
			vertices.places.push_back(frame.place_of(surface.positions[i]));
		}
	}
}

void write_vertices(const ModelIslands &islands, const std::vector<ModelPart> &parts,
		const std::vector<ModelSwinger> &swingers, const std::vector<ModelSurface> &surfaces, float height,
		ModelVertices &vertices) {
	const size_t count = vertices.places.size();
	vertices.custom0.resize(count);
	vertices.custom1.resize(count);
	vertices.custom2.resize(count);
	vertices.stem_places.resize(count);
	vertices.swingers.assign(count, -1);
	vertices.bone_weights.assign(count, 0.0f);
	const ModelPart unused = {};
	size_t vertex = 0;
	for (const ModelSurface &surface : surfaces) {
		const float leafiness = surface.is_foliage ? 1.0f : 0.0f;
		for (int i = 0; i < surface.vertices; i++, vertex++) {
			const int island = islands.of_vertex[vertex];
			const ModelPart &part = island < 0 ? unused : parts[static_cast<size_t>(island)];
			const glm::vec3 &place = vertices.places[vertex];
			const float offset = part.stem_offset_of(place, height);
			const glm::vec3 aside = island < 0 ? glm::vec3(0.0f) : place - part.midrib_at(place);
			vertices.custom0[vertex] = { offset, part.weight_of(place, height), 0.0f, leafiness };
			vertices.custom1[vertex] = glm::vec4(part.pivot, part.code.pace);
			vertices.custom2[vertex] = glm::vec4(aside, part.code.place);
			vertices.stem_places[vertex] = offset;
			if (island >= 0) {
				const ModelSwinger &swinger = swingers[static_cast<size_t>(island)];
				vertices.swingers[vertex] = swinger.number;
				vertices.bone_weights[vertex] = swinger.share * vertices.custom0[vertex].y;
			}
		}
	}
}

float mean_radius(const ModelMidrib &midrib) {
	float sum = 0.0f;
	for (const float radius : midrib.radii) {
		sum += radius / (ModelMidrib::SLICES + 1);
	}
	return sum;
}

/// Returns the root that is a stem: the one with the largest area, if it is slender. -1: there is none.
int find_stem(const ModelIslands &islands, const std::vector<ModelPart> &parts, float height) {
	int stem = -1;
	for (size_t i = 0; i < parts.size(); i++) {
		const bool is_larger = stem < 0 || islands.islands[i].area > islands.islands[static_cast<size_t>(stem)].area;
		stem = parts[i].is_root && is_larger ? static_cast<int>(i) : stem;
	}
	const bool is_slender = stem >= 0 && mean_radius(parts[static_cast<size_t>(stem)].midrib) <= SLENDER * height;
	return is_slender ? stem : -1;
}

void measure_stem(const std::vector<ModelPart> &parts, int stem, float height, StemBeam &beam) {
	beam.length = height;
	beam.diameter = std::max(UNSEEN * height, MIN_DIAMETER);
	if (stem < 0) {
		return;
	}
	const ModelMidrib &midrib = parts[static_cast<size_t>(stem)].midrib;
	const float base = 2.0f * std::max(midrib.radii[0], midrib.radii[1]);
	const float tip = 2.0f * midrib.radii[ModelMidrib::SLICES - 1];
	beam.diameter = std::clamp(base, MIN_DIAMETER, std::max(MAX_DIAMETER * height, MIN_DIAMETER));
	beam.taper = std::clamp(1.0f - tip / beam.diameter, 0.0f, MAX_TAPER);
}

void measure_loads(
		const ModelIslands &islands, const std::vector<ModelPart> &parts, int stem, float height, StemBeam &beam) {
	std::array<StemBeam::Load, BINS> bins = {};
	for (size_t i = 0; i < parts.size(); i++) {
		if (static_cast<int>(i) == stem) {
			continue;
		}
		const ModelIsland &island = islands.islands[i];
		const float offset = parts[i].is_root ? island.centre().y / height : parts[i].stem_offset;
		StemBeam::Load &bin = bins[static_cast<size_t>(std::clamp(offset, 0.0f, 0.999f) * BINS)];
		bin.mass += SHEET_MASS * island.area;
		bin.drag_area += SHEET_DRAG * 0.5f * island.area; // Sheets of closed bodies have two sides.
	}
	for (size_t i = 0; i < BINS; i++) {
		if (bins[i].mass > 0.0f) {
			bins[i].place = (static_cast<float>(i) + 0.5f) / BINS;
			bins[i].mass = std::min(bins[i].mass, MAX_MASS);
			bins[i].drag_area = std::min(bins[i].drag_area, MAX_AREA);
			beam.loads.push_back(bins[i]);
		}
	}
}

void count_parts(const std::vector<ModelPart> &parts, ModelMotion &motion) {
	std::set<int> heads;
	for (const ModelPart &part : parts) {
		motion.roots += part.is_root ? 1 : 0;
		motion.leaves += part.swings ? 1 : 0;
		motion.twigs += !part.is_root && part.swinger < 0 ? 1 : 0;
		if (!part.swings && part.swinger >= 0) {
			heads.insert(part.swinger);
		}
	}
	motion.heads = static_cast<int>(heads.size());
}

} // namespace

ModelMotion find_model_motion(const std::vector<ModelSurface> &surfaces, const ModelFrame &frame) {
	ModelMotion motion;
	place_vertices(surfaces, frame, motion.vertices);
	const ModelIslands islands = find_islands(surfaces, motion.vertices.places);
	const std::vector<ModelPart> parts = attach_islands(surfaces, motion.vertices.places, islands, frame.height);
	std::vector<ModelSwinger> swingers;
	motion.bones = make_model_bones(parts, islands, frame.height, swingers);
	write_vertices(islands, parts, swingers, surfaces, frame.height, motion.vertices);
	const int stem = find_stem(islands, parts, frame.height);
	measure_stem(parts, stem, frame.height, motion.beam);
	measure_loads(islands, parts, stem, frame.height, motion.beam);
	count_parts(parts, motion);
	return motion;
}

} // namespace undergrowth
