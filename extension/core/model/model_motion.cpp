#include "model/model_motion.hpp"

#include "model/model_bones.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
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

// The value of a channel, or 1 without one.
float channel_of(const ModelSurface &surface, int vertex, int channel) {
	return channel < 0 || surface.colors == nullptr ? 1.0f : std::clamp(surface.colors[vertex][channel], 0.0f, 1.0f);
}

void set_phases(const std::vector<ModelSurface> &surfaces, const ModelIslands &islands, int channel,
		std::vector<ModelPart> &parts) {
	std::vector<float> sums(parts.size(), 0.0f);
	size_t vertex = 0;
	for (const ModelSurface &surface : surfaces) {
		for (int i = 0; i < surface.vertices; i++, vertex++) {
			const int island = islands.of_vertex[vertex];
			if (island >= 0) {
				sums[static_cast<size_t>(island)] += channel_of(surface, i, channel);
			}
		}
	}
	for (size_t i = 0; i < parts.size(); i++) {
		if (parts[i].swings) {
			parts[i].swing.phase = sums[i] / static_cast<float>(islands.islands[i].count);
			parts[i].code = encode_part_motion(parts[i].swing);
			parts[i].swing = decode_part_motion(parts[i].code);
		}
	}
}

std::vector<int> number_leaves(const std::vector<ModelPart> &parts) {
	std::vector<int> numbers;
	int count = 0;
	for (const ModelPart &part : parts) {
		numbers.push_back(part.swings ? count++ : -1);
	}
	return numbers;
}

/// What write_vertices() reads besides the surfaces.
struct Written {
	const ModelIslands &islands;
	const std::vector<ModelPart> &parts;
	const std::vector<ModelSwinger> &swingers;
	const std::vector<int> &leaves; // Number of the leaf of each island; -1: none.
	const ModelColors &colors;
	float height;
};

void write_vertex(const Written &from, const ModelSurface &surface, int i, size_t vertex, ModelVertices &vertices) {
	const int island = from.islands.of_vertex[vertex];
	if (island < 0) {
		return;
	}
	const ModelPart &part = from.parts[static_cast<size_t>(island)];
	const ModelSwinger &swinger = from.swingers[static_cast<size_t>(island)];
	const glm::vec3 &place = vertices.places[vertex];
	const float bend = part.is_root ? channel_of(surface, i, from.colors.bend) : 1.0f; // Leaves move with their stem.
	const float offset = bend * part.stem_offset_of(place, from.height);
	const float weight = part.weight_of(place, from.height) * channel_of(surface, i, from.colors.flutter);
	vertices.custom0[vertex] = { offset, weight, 0.0f, surface.is_foliage ? 1.0f : 0.0f };
	vertices.custom1[vertex] = glm::vec4(part.pivot, part.code.pace);
	vertices.custom2[vertex] = glm::vec4(place - part.midrib_at(place), part.code.place);
	vertices.stem_places[vertex] = offset;
	vertices.swingers[vertex] = swinger.number;
	vertices.bone_weights[vertex] = swinger.share * weight;
	vertices.leaves[vertex] = from.leaves[static_cast<size_t>(island)];
}

void write_vertices(const Written &from, const std::vector<ModelSurface> &surfaces, ModelVertices &vertices) {
	const size_t count = vertices.places.size();
	vertices.custom0.assign(count, glm::vec4(0.0f));
	vertices.custom1.assign(count, glm::vec4(0.0f));
	vertices.custom2.assign(count, glm::vec4(0.0f));
	vertices.stem_places.assign(count, 0.0f);
	vertices.swingers.assign(count, -1);
	vertices.bone_weights.assign(count, 0.0f);
	vertices.leaves.assign(count, -1);
	size_t vertex = 0;
	for (const ModelSurface &surface : surfaces) {
		for (int i = 0; i < surface.vertices; i++, vertex++) {
			write_vertex(from, surface, i, vertex, vertices);
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

bool is_leaf_kept(int leaf, float share) {
	constexpr double GOLDEN = 0.61803398874989485;
	const double turns = static_cast<double>(leaf) * GOLDEN;
	return turns - std::floor(turns) < static_cast<double>(share);
}

ModelMotion find_model_motion(
		const std::vector<ModelSurface> &surfaces, const ModelFrame &frame, const ModelColors &colors) {
	ModelMotion motion;
	place_vertices(surfaces, frame, motion.vertices);
	const ModelIslands islands = find_islands(surfaces, motion.vertices.places);
	std::vector<ModelPart> parts = attach_islands(surfaces, motion.vertices.places, islands, frame.height);
	if (colors.phase >= 0) {
		set_phases(surfaces, islands, colors.phase, parts);
	}
	std::vector<ModelSwinger> swingers;
	motion.bones = make_model_bones(parts, islands, frame.height, swingers);
	write_vertices({ islands, parts, swingers, number_leaves(parts), colors, frame.height }, surfaces, motion.vertices);
	const int stem = find_stem(islands, parts, frame.height);
	measure_stem(parts, stem, frame.height, motion.beam);
	measure_loads(islands, parts, stem, frame.height, motion.beam);
	count_parts(parts, motion);
	return motion;
}

} // namespace undergrowth
