#include "field/view/shadow_plants.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr float STEP = 1.0f; // m that a camera moves before plants are listed again.
static constexpr float SLACK = 1.5f; // m by which plants are listed earlier than they are needed.
static constexpr int MAX_PLANTS = 2500; // After so many in a frame, the remaining lists are shown in later ones.

ShadowPlants::Sight::Sight(const DrawingCamera &camera, const Transform3D &placed, const ShadowCaster &caster) {
	const Transform3D to_field = placed.affine_inverse();
	const Vector3 scale = to_field.basis.get_scale().abs();
	const float longest = float(std::max({ scale.x, scale.y, scale.z }));
	place = to_field.xform(camera.place);
	begin = std::max(caster.begin - SLACK, 0.0f) * float(std::min({ scale.x, scale.y, scale.z }));
	end = (caster.end + SLACK) * longest;
	metres = 1.0f / longest;
}

// Another scale changes the distances.
bool ShadowPlants::Sight::covers(const Sight &now) const {
	const float error = 1e-3f * end; // A field that turns has rounding errors.
	return place.distance_to(now.place) * metres < STEP && std::abs(begin - now.begin) <= error &&
			std::abs(end - now.end) <= error;
}

struct ShadowPlants::Listing {
	size_t band = 0;
	LodDensity lod_density;
	std::vector<float> heights;
	std::vector<Sight> sights;
	Squares squares;
	std::vector<PlantBuffer> plants; // By mesh.
	AABB box;

	void run();
	int size() const;

private:
	std::optional<float> needed_from(const AABB &cell_box, size_t sight) const;
	AABB list(const NearSquare &square);
	void write(const NearSquare &square, int first, int count);
};

// For the incomplete types.
ShadowPlants::ShadowPlants() = default;
ShadowPlants::~ShadowPlants() = default;

void ShadowPlants::bind(const FieldRenderSetup &setup) {
	std::vector<Band> wanted;
	for (size_t species = 0; species < setup.styles.size(); species++) {
		const SpeciesStyle &style = setup.styles[species];
		const size_t count = style.levels.size();
		for (size_t i = 0; !style.is_absent && i < style.casters.size(); i++) {
			const ShadowCaster &caster = style.casters[i];
			if (caster.level < 0 || style.materials.size() <= count + i) {
				continue;
			}
			Band &band = wanted.emplace_back();
			band.species = int(species);
			band.caster = caster;
			band.material = style.materials[count + i]->get_rid();
			band.heights = style.variant_heights();
			for (const Ref<ArrayMesh> &mesh : style.meshes[size_t(caster.level)]) {
				band.lists.emplace_back(mesh->get_rid(), setup.instance_floats());
			}
		}
	}
	if (!std::equal(wanted.begin(), wanted.end(), bands.begin(), bands.end(), has_meshes_of)) {
		task.wait();
		listings.clear();
		bands = std::move(wanted);
		return;
	}
	for (size_t i = 0; i < bands.size(); i++) {
		bands[i].is_due = bands[i].is_due || !(bands[i].caster == wanted[i].caster);
		bands[i].caster = wanted[i].caster;
		bands[i].material = wanted[i].material;
		set_look(bands[i]);
	}
}

bool ShadowPlants::has_meshes_of(const Band &one, const Band &other) {
	return one.species == other.species &&
			std::equal(one.lists.begin(), one.lists.end(), other.lists.begin(), other.lists.end(),
					[](const PlantList &own, const PlantList &their) { return own.mesh_rid() == their.mesh_rid(); });
}

void ShadowPlants::set_squares(const std::vector<std::shared_ptr<NearSquare>> &now) {
	squares.clear();
	for (const std::shared_ptr<NearSquare> &square : now) {
		squares.resize(std::max(squares.size(), size_t(square->species) + 1));
		squares[size_t(square->species)].push_back(square);
	}
	has_other_squares = true;
}

// Streaming adds and removes squares in most frames, but seldom near a camera.
void ShadowPlants::take_other_squares() {
	for (Band &band : bands) {
		band.is_due = band.is_due || squares_in(band, band.seen) != band.listed;
	}
}

std::vector<ShadowPlants::Sight> ShadowPlants::sights_of(
		const Band &band, const std::vector<DrawingCamera> &cameras) const {
	std::vector<Sight> sights;
	for (const DrawingCamera &camera : cameras) {
		sights.emplace_back(camera, around.placed, band.caster);
	}
	return sights;
}

ShadowPlants::Squares ShadowPlants::squares_in(const Band &band, const std::vector<Sight> &sights) const {
	Squares found;
	if (size_t(band.species) < squares.size()) {
		for (const std::shared_ptr<NearSquare> &square : squares[size_t(band.species)]) {
			const AABB box = square->box();
			if (std::any_of(sights.begin(), sights.end(), [&](const Sight &sight) {
					return sight.place.distance_to(sight.place.clamp(box.position, box.get_end())) < sight.end;
				})) {
				found.push_back(square);
			}
		}
	}
	return found;
}

void ShadowPlants::follow(const ListSurroundings &now) {
	around = now;
	for (const Band &band : bands) {
		set_look(band);
	}
}

void ShadowPlants::set_transform(const Transform3D &placed) {
	around.placed = placed;
	for (const Band &band : bands) {
		for (const PlantList &list : band.lists) {
			list.place(placed);
		}
	}
}

void ShadowPlants::set_look(const Band &band) const {
	for (const PlantList &list : band.lists) {
		list.set_look(around, band.material, true);
		list.place(around.placed);
	}
}

bool ShadowPlants::is_listing() const {
	return task.is_running() || (!listings.empty() && is_shown());
}

void ShadowPlants::update(const std::vector<DrawingCamera> &cameras) {
	if (cameras.empty() || !is_shown() || task.is_running()) {
		return;
	}
	if (listings.empty()) {
		start(cameras);
	} else {
		show_listed();
	}
}

void ShadowPlants::start(const std::vector<DrawingCamera> &cameras) {
	if (std::exchange(has_other_squares, false)) {
		take_other_squares();
	}
	for (size_t i = 0; i < bands.size(); i++) {
		Band &band = bands[i];
		std::vector<Sight> sights = sights_of(band, cameras);
		const bool is_covered = std::equal(band.seen.begin(), band.seen.end(), sights.begin(), sights.end(),
				[](const Sight &one, const Sight &now) { return one.covers(now); });
		if (is_covered && !band.is_due) {
			continue;
		}
		band.is_due = false;
		band.seen = sights;
		auto listing = std::make_unique<Listing>();
		listing->band = i;
		listing->lod_density = band.caster.lod_density;
		listing->heights = band.heights;
		listing->squares = band.listed = squares_in(band, sights);
		listing->sights = std::move(sights);
		for (PlantList &list : band.lists) {
			listing->plants.push_back(list.take_spare());
		}
		listings.push_back(std::move(listing));
	}
	if (!listings.empty()) {
		task.start([this]() {
			for (const std::unique_ptr<Listing> &listing : listings) {
				listing->run();
			}
		});
	}
}

void ShadowPlants::show_listed() {
	int shown = 0;
	while (!listings.empty() && shown < MAX_PLANTS) {
		Listing &listing = *listings.back();
		Band &band = bands[listing.band];
		shown += listing.size();
		for (size_t i = 0; i < band.lists.size(); i++) {
			band.lists[i].exchange(std::move(listing.plants[i]));
			band.lists[i].upload(listing.box);
		}
		set_look(band);
		listings.pop_back();
	}
}

void ShadowPlants::Listing::run() {
	for (const std::shared_ptr<NearSquare> &square : squares) {
		const AABB own = list(*square);
		if (own.has_surface()) {
			box = box.has_surface() ? box.merge(own) : own;
		}
	}
}

int ShadowPlants::Listing::size() const {
	return std::accumulate(
			plants.begin(), plants.end(), 0, [](int sum, const PlantBuffer &own) { return sum + own.size(); });
}

// Returns the smallest distance (m) at which a camera needs the plants of a box; nothing if none does, or if one before
// `sight` does, for which they are listed already.
std::optional<float> ShadowPlants::Listing::needed_from(const AABB &cell_box, size_t sight) const {
	std::optional<float> least;
	for (size_t i = 0; i < sights.size(); i++) {
		const Sight &one = sights[i];
		const float nearest = float(one.place.distance_to(one.place.clamp(cell_box.position, cell_box.get_end())));
		const float farthest = float(((one.place - cell_box.get_center()).abs() + 0.5f * cell_box.size).length());
		if (nearest >= one.end || farthest < one.begin) {
			continue;
		}
		if (i < sight) {
			return {};
		}
		least = std::min(least.value_or(nearest * one.metres), nearest * one.metres);
	}
	return least;
}

// Returns a box around the plants that it lists.
AABB ShadowPlants::Listing::list(const NearSquare &square) {
	AABB all;
	for (size_t i = 0; i < sights.size(); i++) {
		square.for_each_cell(sights[i].place, sights[i].end, [&](int cell) {
			const int first = square.begins[size_t(cell)];
			const AABB cell_box = square.box_of(cell);
			const bool is_empty = first == square.begins[size_t(cell) + 1];
			const std::optional<float> away = is_empty ? std::nullopt : needed_from(cell_box, i);
			if (!away) {
				return;
			}
			const float cut = lod_density.cut_at(std::max(*away - SLACK, 0.0f));
			write(square, first, square.count_ranked(cell, cut));
			all = all.has_surface() ? all.merge(cell_box) : cell_box;
		});
	}
	return all.has_surface() ? all.grow(square.reach) : AABB();
}

// Adds plants that are adjacent in a square.
void ShadowPlants::Listing::write(const NearSquare &square, int first, int count) {
	float *next = plants.size() == 1 ? plants[0].add(count) : nullptr; // All at once.
	square.write(first, count, heights, plants.size(),
			[&](size_t mesh) { return next ? std::exchange(next, next + square.stride) : plants[mesh].add(1); });
}

} // namespace undergrowth
