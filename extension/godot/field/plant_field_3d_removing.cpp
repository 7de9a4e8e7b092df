// The part of PlantField3D that takes plants away.

#include "field/plant_field_3d.hpp"

#include "convert.hpp"

#include <algorithm>
#include <cmath>
#include <set>

using namespace godot;

namespace undergrowth {

namespace {

using Patches = std::vector<std::unique_ptr<FieldPatch>>;

/// Takes the plants within a sphere out of patches and simulation. What has to be drawn again is noted.
class Removal {
public:
	Removal(const Patches &in, FieldSimulation &of, const FieldStyle &drawn_in);

	/// Tells how many plants are gone.
	int remove_in_sphere(const glm::vec3 &middle, float radius);

	std::vector<bool> is_affected; ///< By page.
	std::vector<std::set<ClumpPlace>> dirty; ///< By patch.

private:
	/// A plant by its patch and its index there.
	using Member = std::pair<int, int>;

	const Patches &patches;
	FieldSimulation &simulation;
	const FieldStyle &style;
	std::vector<std::vector<Member>> members; ///< Of each page that is affected.

	std::vector<Member> find(const glm::vec3 &middle, float radius) const;
	void list_members();
	void remove(const Member &member);
	void mark(const Member &member);
};

Removal::Removal(const Patches &in, FieldSimulation &of, const FieldStyle &drawn_in) :
		is_affected(size_t(of.page_count()), false),
		dirty(in.size()),
		patches(in),
		simulation(of),
		style(drawn_in),
		members(size_t(of.page_count())) {}

std::vector<Removal::Member> Removal::find(const glm::vec3 &middle, float radius) const {
	std::vector<Member> found;
	for (int p = 0; p < int(patches.size()); p++) {
		const FieldPatch &patch = *patches[size_t(p)];
		for (const int plant : find_in_sphere(patch.plants, patch.chunks, middle, radius)) {
			if (patch.places[size_t(plant)] != FieldPatch::GONE) {
				found.push_back({ p, plant });
			}
		}
	}
	return found;
}

void Removal::list_members() {
	for (int p = 0; p < int(patches.size()); p++) {
		const FieldPatch &patch = *patches[size_t(p)];
		for (int plant = 0; plant < patch.plants.size(); plant++) {
			if (patch.places[size_t(plant)] == FieldPatch::GONE || !is_affected[size_t(patch.page(plant))]) {
				continue;
			}
			std::vector<Member> &page = members[size_t(patch.page(plant))];
			page.resize(std::max(page.size(), size_t(patch.index(plant)) + 1));
			page[size_t(patch.index(plant))] = { p, plant };
		}
	}
}

void Removal::mark(const Member &member) {
	const auto [patch, plant] = member;
	const FieldPlants &plants = patches[size_t(patch)]->plants;
	const float size = patches[size_t(patch)]->chunks.size;
	const int column = int(std::floor(plants.x[size_t(plant)] / size));
	const int row = int(std::floor(plants.z[size_t(plant)] / size));
	for (int level = 0; level < int(style.levels.size()); level++) {
		dirty[size_t(patch)].insert(FieldDrawing::place_of(style, level, column, row));
	}
}

// The last plant of its page takes its place.
void Removal::remove(const Member &member) {
	FieldPatch &patch = *patches[size_t(member.first)];
	uint32_t &place = patch.places[size_t(member.second)];
	const int page = patch.page(member.second);
	const int index = patch.index(member.second);
	std::vector<Member> &others = members[size_t(page)];
	const Member last = others.back();
	simulation.remove(page, index);
	patches[size_t(last.first)]->places[size_t(last.second)] = place;
	others[size_t(index)] = last;
	others.pop_back();
	place = FieldPatch::GONE;
	mark(last);
	mark(member);
}

int Removal::remove_in_sphere(const glm::vec3 &middle, float radius) {
	const std::vector<Member> found = find(middle, radius);
	for (const auto &[patch, plant] : found) {
		is_affected[size_t(patches[size_t(patch)]->page(plant))] = true;
	}
	list_members();
	for (const Member &member : found) {
		remove(member);
	}
	return int(found.size());
}

} // namespace

int PlantField3D::remove_in_sphere(const Vector3 &center, double radius) {
	if (!center.is_finite() || !std::isfinite(radius) || radius < 0.0) {
		report_error(this, "remove_in_sphere() needs a finite centre and a radius of 0 or more.");
		return 0;
	}
	if (!is_inside_tree() || !simulation) {
		return 0;
	}
	finish_step();
	flush_pending();
	const Transform3D to_field = axes().affine_inverse();
	Removal removal(patches, *simulation, style);
	const int removed = removal.remove_in_sphere(
			to_glm(to_field.xform(center)), float(radius) * to_field.basis.get_column(1).length());
	if (removed > 0) {
		release_removed_skeletons();
		show_removed(removal.is_affected, removal.dirty);
	}
	return removed;
}

void PlantField3D::show_removed(const std::vector<bool> &is_affected, const std::vector<std::set<ClumpPlace>> &dirty) {
	for (int page = 0; page < simulation->page_count(); page++) {
		if (is_affected[size_t(page)]) {
			bends->write_page(*simulation, page);
		}
	}
	if (simulation->settings().prototypes > 0) {
		bends->write_history(*simulation); // Pushed plants have new places, too.
	}
	for (size_t p = 0; p < patches.size(); p++) {
		for (const ClumpPlace &place : dirty[p]) {
			drawings[p]->replace(style, place, FieldDrawing::plan_one(style, *patches[p], place));
		}
	}
	upload();
	if (options.contact) {
		touching.fit(*simulation);
	}
}

} // namespace undergrowth
