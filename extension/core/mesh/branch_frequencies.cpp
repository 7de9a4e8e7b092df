#include "mesh/branch_frequencies.hpp"

#include "conventions.hpp"
#include "mesh/order_modes.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr size_t MAX_BEAMS = 32; // More branches on a branch are rigid.
constexpr int PLACES = 4; // Of a part whose width is evaluated.
constexpr float BLADE_THICKNESS = 0.00025f; // m.
constexpr float MIN_MASS = 1e-9f; // m³.
constexpr float MIN_ACROSS = 0.1f;

bool is_branch(const PlantForm &form, const PlacedPart &part) {
	const Part &kind = form.parts[static_cast<size_t>(part.kind)];
	return part.carrier != ON_GROUND && kind.kind == PartKind::axis && kind.frequency > 0.0f;
}

/// Volume of a part (m³).
float volume_of(const PlantForm &form, const PlacedPart &part) {
	const Part &kind = form.parts[static_cast<size_t>(part.kind)];
	float section = 0.0f;
	for (int i = 0; i < PLACES; i++) {
		const float width = part.width * kind.width_at((static_cast<float>(i) + 0.5f) / PLACES);
		const float round = 0.25f * static_cast<float>(PI) * width * width;
		section += (kind.kind == PartKind::blade ? BLADE_THICKNESS * width : round) / PLACES;
	}
	return section * part.length;
}

/// The part of `side` across a beam, or any direction across it.
glm::vec3 side_across(const glm::vec3 &way, const glm::vec3 &side) {
	const glm::vec3 along = glm::normalize(way);
	glm::vec3 across = side - along * glm::dot(side, along);
	if (glm::length(across) < MIN_ACROSS) {
		across = glm::cross(along, std::fabs(along.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0));
	}
	return glm::normalize(across);
}

/// A branch and what it carries, as beams.
struct BranchTree {
	std::vector<BranchBeam> beams;
	std::vector<int> kinds; ///< Of the beams' parts.

	BranchTree(const PlantForm &form, size_t branch) : beam_of(form.placed.size() - branch, -1), first(branch) {
		add(form, branch, -1);
		for (size_t i = branch + 1; i < form.placed.size(); i++) {
			const int carrier = form.placed[i].carrier;
			if (carrier < static_cast<int>(first) || beam_of[static_cast<size_t>(carrier) - first] < 0) {
				continue;
			}
			const int on = beam_of[static_cast<size_t>(carrier) - first];
			if (is_branch(form, form.placed[i]) && beams.size() < MAX_BEAMS) {
				add(form, i, on);
			} else { // Rigid on its beam.
				beam_of[i - first] = on;
				beams[static_cast<size_t>(on)].mass += volume_of(form, form.placed[i]);
			}
		}
	}

private:
	std::vector<int> beam_of; ///< By part from `first` on: its beam, or -1.
	size_t first;

	void add(const PlantForm &form, size_t part, int on) {
		const PlacedPart &placed = form.placed[part];
		BranchBeam beam;
		beam.carrier = on;
		beam.offset = std::clamp(placed.offset, 0.0f, 1.0f);
		beam.base = placed.base;
		beam.way = form.point_of(placed, 1.0f) - placed.base;
		const glm::vec3 side = on < 0 ? glm::vec3(1, 0, 0) : beams[static_cast<size_t>(on)].side;
		beam.side = side_across(beam.way, side);
		beam.mass = std::max(volume_of(form, placed), MIN_MASS);
		beam.frequency = form.parts[static_cast<size_t>(placed.kind)].frequency;
		beam_of[part - first] = static_cast<int>(beams.size());
		beams.push_back(beam);
		kinds.push_back(placed.kind);
	}
};

/// True for the first branch of its group that no branch carries.
bool is_sampled(const PlantForm &form, size_t index) {
	const PlacedPart &part = form.placed[index];
	if (!is_branch(form, part) || static_cast<int>(index) != form.groups[static_cast<size_t>(part.group)].first) {
		return false;
	}
	for (int on = part.carrier; on != ON_GROUND; on = form.placed[static_cast<size_t>(on)].carrier) {
		if (is_branch(form, form.placed[static_cast<size_t>(on)])) {
			return false;
		}
	}
	return true;
}

} // namespace

std::vector<float> branch_frequency_factors(const PlantForm &form) {
	std::vector<float> sums(form.parts.size(), 0.0f);
	std::vector<float> counts(form.parts.size(), 0.0f);
	for (size_t i = 0; i < form.placed.size(); i++) {
		if (!is_sampled(form, i)) {
			continue;
		}
		const BranchTree tree(form, i);
		const BranchModes found = find_branch_modes(tree.beams);
		for (size_t beam = 0; beam < tree.beams.size(); beam++) {
			sums[static_cast<size_t>(tree.kinds[beam])] += found.of_beams[beam] / tree.beams[beam].frequency;
			counts[static_cast<size_t>(tree.kinds[beam])] += 1.0f;
		}
	}
	for (size_t kind = 0; kind < sums.size(); kind++) {
		sums[kind] = counts[kind] > 0.0f ? sums[kind] / counts[kind] : 1.0f;
	}
	return sums;
}

} // namespace undergrowth
