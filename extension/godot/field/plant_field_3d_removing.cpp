// The part of PlantField3D that takes plants away.

#include "field/plant_field_3d.hpp"

#include "convert.hpp"

#include <algorithm>
#include <cmath>
#include <set>

using namespace godot;

namespace undergrowth {

void PlantField3D::redraw(int patch, const std::vector<ClumpPlace> &places) {
	for (const ClumpPlace &place : places) {
		drawings[size_t(patch)]->replace(style, place, FieldDrawing::plan_one(style, *patches[size_t(patch)], place));
	}
}

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
	const glm::vec3 middle = to_glm(to_field.xform(center));
	const float reach = float(radius) * to_field.basis.get_column(1).length();
	// Where the last plant of each page is, which takes the place of one that goes.
	std::vector<std::vector<std::pair<int, int>>> members(size_t(simulation->page_count()));
	int removed = 0;
	std::vector<std::set<ClumpPlace>> dirty(patches.size());
	const auto mark = [&](int patch, int plant) {
		const FieldPlants &plants = patches[size_t(patch)]->plants;
		const float size = patches[size_t(patch)]->chunks.size;
		const int column = int(std::floor(plants.x[size_t(plant)] / size));
		const int row = int(std::floor(plants.z[size_t(plant)] / size));
		for (int level = 0; level < int(style.levels.size()); level++) {
			dirty[size_t(patch)].insert(FieldDrawing::place_of(style, level, column, row));
		}
	};
	std::vector<std::vector<int>> found;
	std::vector<bool> is_affected(size_t(simulation->page_count()), false);
	for (const std::unique_ptr<FieldPatch> &patch : patches) {
		found.push_back(find_in_sphere(patch->plants, patch->chunks, middle, reach));
		for (const int plant : found.back()) {
			if (patch->places[size_t(plant)] != FieldPatch::GONE) {
				is_affected[size_t(patch->page(plant))] = true;
			}
		}
	}
	for (int p = 0; p < int(patches.size()); p++) {
		const FieldPatch &patch = *patches[size_t(p)];
		for (int plant = 0; plant < patch.plants.size(); plant++) {
			if (patch.places[size_t(plant)] == FieldPatch::GONE || !is_affected[size_t(patch.page(plant))]) {
				continue;
			}
			auto &page = members[size_t(patch.page(plant))];
			page.resize(std::max(page.size(), size_t(patch.index(plant)) + 1));
			page[size_t(patch.index(plant))] = { p, plant };
		}
	}
	for (int p = 0; p < int(patches.size()); p++) {
		FieldPatch &patch = *patches[size_t(p)];
		for (const int plant : found[size_t(p)]) {
			if (patch.places[size_t(plant)] == FieldPatch::GONE) {
				continue;
			}
			const int page = patch.page(plant);
			const int index = patch.index(plant);
			auto &members_of_page = members[size_t(page)];
			const auto [last_patch, last_plant] = members_of_page.back();
			simulation->remove(page, index);
			patches[size_t(last_patch)]->places[size_t(last_plant)] = patch.places[size_t(plant)];
			members_of_page[size_t(index)] = members_of_page.back();
			members_of_page.pop_back();
			mark(last_patch, last_plant);
			patch.places[size_t(plant)] = FieldPatch::GONE;
			mark(p, plant);
			removed++;
		}
	}
	release_removed_skeletons();
	for (int page = 0; page < simulation->page_count(); page++) {
		if (is_affected[size_t(page)]) {
			bends->write_page(*simulation, page);
		}
	}
	if (simulation->settings().prototypes > 0) {
		bends->write_history(*simulation); // Pushed plants have new places, too.
	}
	for (int p = 0; p < int(patches.size()); p++) {
		redraw(p, { dirty[size_t(p)].begin(), dirty[size_t(p)].end() });
	}
	if (removed > 0) {
		upload();
		if (options.contact) {
			touching.fit(*simulation);
		}
	}
	return removed;
}

} // namespace undergrowth
