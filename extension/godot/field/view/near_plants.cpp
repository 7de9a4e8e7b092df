#include "field/view/near_plants.hpp"

#include "field/view/plant_transforms.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr float STEP = 0.25f; // m that a camera moves before plants are selected again.
static constexpr float SLACK = 0.3f; // m by which plants are selected earlier than they are drawn.
static constexpr float STEP_COSINE = 0.9962f; // Of the angle (5°) by which a camera turns before that.

struct NearPlants::Sight {
	Vector3 place;
	Vector3 forward;
	float cosine = -1.0f, sine = 0.0f; // Of half the angle of view.
	bool has_cone = false;
	float longest = 1.0f; // Largest and smallest length of a unit of the world in the field's axes.
	float shortest = 1.0f;

	Sight(const DrawingCamera &camera, const Transform3D &placed) {
		const Transform3D to_field = placed.affine_inverse();
		const Vector3 scale = to_field.basis.get_scale().abs();
		place = to_field.xform(camera.place);
		forward = to_field.basis.xform(camera.forward).normalized();
		longest = std::max({ scale.x, scale.y, scale.z });
		shortest = std::min({ scale.x, scale.y, scale.z });
		has_cone = camera.has_cone && longest <= 1.01f * shortest; // Angles change under uneven scales.
		cosine = camera.cone_cosine;
		sine = std::sqrt(std::max(1.0f - cosine * cosine, 0.0f));
	}

	bool sees(const Band &band, const Vector3 &root, float reach) const {
		const Vector3 way = root - place;
		const float square = float(way.length_squared());
		const float far = band.far * longest;
		const float near = band.near * shortest;
		if (square > far * far || square < near * near) {
			return false;
		}
		if (!has_cone) {
			return true;
		}
		const float along = float(way.dot(forward));
		const float across = std::sqrt(std::max(square - along * along, 0.0f));
		return across * cosine - along * sine <= reach && along >= -reach;
	}
};

bool NearPlants::Band::has_meshes_of(const Band &other) const {
	return species == other.species && bit == other.bit &&
			std::equal(lists.begin(), lists.end(), other.lists.begin(), other.lists.end(),
					[](const List &one, const List &two) { return one.drawn.mesh_rid() == two.drawn.mesh_rid(); });
}

template <class Act> void NearPlants::for_each_list(const Act &act) const {
	for (const Band &band : bands) {
		for (const List &list : band.lists) {
			act(band, list);
		}
	}
}

static bool is_drawn(const SpeciesStyle &style) {
	return !style.is_absent && style.materials.size() >= style.levels.size();
}

void NearPlants::bind(const FieldRenderSetup &setup) {
	std::vector<Band> wanted;
	for (size_t species = 0; species < setup.styles.size(); species++) {
		const SpeciesStyle &style = setup.styles[species];
		for (size_t i = 0; is_drawn(style) && i < style.levels.size(); i++) {
			const FieldLevel &level = style.levels[i];
			if (level.is_near) {
				Band &band = wanted.emplace_back();
				band.species = int(species);
				band.bit = uint16_t(1u << i);
				band.near = std::max(level.begin - level.margin - SLACK, 0.0f);
				band.far = level.end + SLACK;
				band.material = style.materials[i]->get_rid();
				band.heights = style.variant_heights();
				for (const Ref<ArrayMesh> &mesh : style.meshes[i]) {
					band.lists.push_back({ PlantList(mesh->get_rid(), setup.instance_floats()), {}, false });
				}
			}
		}
	}
	const bool are_same = std::equal(wanted.begin(), wanted.end(), bands.begin(), bands.end(),
			[](const Band &one, const Band &other) { return one.has_meshes_of(other); });
	is_due = true;
	if (!are_same) {
		bands = std::move(wanted);
		for (const std::shared_ptr<NearSquare> &square : squares) {
			std::fill(square->drawn.begin(), square->drawn.end(), uint16_t(0));
		}
		return;
	}
	for (size_t i = 0; i < bands.size(); i++) {
		bands[i].near = wanted[i].near;
		bands[i].far = wanted[i].far;
		bands[i].material = wanted[i].material;
	}
	for_each_list([this](const Band &band, const List &list) { set_look(band, list); });
}

// Casts no shadows: ShadowPlants does.
void NearPlants::set_look(const Band &band, const List &list) const {
	list.drawn.set_look(around, band.material, false);
	place(list);
}

void NearPlants::set_squares(std::vector<std::shared_ptr<NearSquare>> &&now) {
	for (Band &band : bands) {
		for (List &list : band.lists) {
			list.is_changed = list.is_changed || !list.slots.empty();
			list.slots.clear();
			list.drawn.plants.clear();
		}
	}
	squares = std::move(now);
	for (const std::shared_ptr<NearSquare> &square : squares) {
		square->drawn.assign(square->plants.size(), 0);
	}
	is_due = true;
}

bool NearPlants::must_update(const std::vector<DrawingCamera> &cameras) const {
	const auto is_like = [](const DrawingCamera &one, const DrawingCamera &other) {
		return one.place.distance_to(other.place) < STEP && one.has_cone == other.has_cone &&
				(!one.has_cone ||
						(one.forward.dot(other.forward) >= STEP_COSINE &&
								one.cone_cosine >= other.cone_cosine - 1e-4f));
	};
	return is_due || !std::equal(cameras.begin(), cameras.end(), seen.begin(), seen.end(), is_like);
}

void NearPlants::update(const std::vector<DrawingCamera> &cameras) {
	if (bands.empty() || cameras.empty() || !must_update(cameras)) {
		return;
	}
	is_due = false;
	seen = cameras;
	std::vector<Sight> sights;
	for (const DrawingCamera &camera : cameras) {
		sights.emplace_back(camera, around.placed);
	}
	for (Band &band : bands) {
		take_out(band, sights);
	}
	for (Band &band : bands) {
		put_in(band, sights);
		AABB box(sights[0].place, Vector3());
		for (const Sight &sight : sights) {
			const float far = band.far * sight.longest + 10.0f;
			box = box.merge(AABB(sight.place - Vector3(far, far, far), 2.0f * Vector3(far, far, far)));
		}
		show(band, box);
	}
}

void NearPlants::take_out(Band &band, const std::vector<Sight> &sights) {
	for (List &list : band.lists) {
		for (size_t i = list.slots.size(); i-- > 0;) {
			const Slot &slot = list.slots[i];
			const Vector3 root = slot.square->root(slot.plant);
			const auto sees = [&](const Sight &sight) { return sight.sees(band, root, slot.square->reach); };
			if (std::any_of(sights.begin(), sights.end(), sees)) {
				continue;
			}
			slot.square->drawn[size_t(slot.plant)] &= uint16_t(~band.bit);
			list.drawn.plants.remove(int(i));
			list.slots[i] = list.slots.back();
			list.slots.pop_back();
			list.is_changed = true;
		}
	}
}

void NearPlants::put_in(Band &band, const std::vector<Sight> &sights) {
	for (const std::shared_ptr<NearSquare> &square : squares) {
		if (square->species != band.species) {
			continue;
		}
		for (const Sight &sight : sights) {
			square->for_each_cell(
					sight.place, band.far * sight.longest, [&](int cell) { put_in(band, *square, cell, sights); });
		}
	}
}

void NearPlants::put_in(Band &band, NearSquare &square, int cell, const std::vector<Sight> &sights) {
	for (int plant = square.begins[size_t(cell)]; plant < square.begins[size_t(cell) + 1]; plant++) {
		uint16_t &drawn = square.drawn[size_t(plant)];
		const Vector3 root = square.root(plant);
		const auto sees = [&](const Sight &sight) { return sight.sees(band, root, square.reach); };
		if ((drawn & band.bit) != 0 || !std::any_of(sights.begin(), sights.end(), sees)) {
			continue;
		}
		drawn |= band.bit;
		square.write(plant, 1, band.heights, band.lists.size(), [&](size_t mesh) {
			List &list = band.lists[mesh];
			list.slots.push_back({ &square, plant });
			list.is_changed = true;
			return list.drawn.plants.add(1);
		});
	}
}

void NearPlants::show(Band &band, const AABB &box) {
	for (List &list : band.lists) {
		if (!std::exchange(list.is_changed, false)) {
			list.drawn.set_box(box);
			continue;
		}
		list.drawn.upload(box);
		set_look(band, list);
	}
}

void NearPlants::follow(const ListSurroundings &now) {
	around = now;
	for_each_list([this](const Band &band, const List &list) { set_look(band, list); });
}

void NearPlants::set_transform(const Transform3D &placed) {
	is_due = is_due || placed != around.placed;
	around.placed = placed;
	for_each_list([this](const Band &, const List &list) { place(list); });
}

void NearPlants::set_tilt(float now) {
	if (std::exchange(tilt, now) != now) {
		for_each_list([this](const Band &, const List &list) { place(list); });
	}
}

void NearPlants::place(const List &list) const {
	const bool is_tilted = tilt != 0.0f && !list.slots.empty();
	const float height = !is_tilted ? 0.0f : list.slots.front().square->root(list.slots.front().plant).y;
	list.drawn.place(is_tilted ? tilted(around.placed, tilt, height) : around.placed);
}

} // namespace undergrowth
