#include "field/view/near_plants.hpp"

#include "field/view/plant_transforms.hpp"

#include <godot_cpp/classes/rendering_server.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr float STEP = 0.25f; // m that a camera moves before plants are selected again.
static constexpr float SLACK = 0.3f; // m by which plants are selected earlier than they are drawn.
static constexpr float STEP_COSINE = 0.9962f; // Of the angle (5°) by which a camera turns before that.
static constexpr int MIN_CAPACITY = 16;

// Calls visit(cell) for the cells that a square of side 2 * far around `place` (m, field axes) meets.
template <class Visit> void NearSquare::for_each_cell(const Vector3 &place, float far, const Visit &visit) const {
	const auto cell_at = [](float at, float first, int count) {
		return int(std::clamp(std::floor((at - first) / CELL_SIZE), -1.0f, float(count)));
	};
	const int left = std::max(cell_at(float(place.x) - far, low.x, columns), 0);
	const int right = std::min(cell_at(float(place.x) + far, low.x, columns), columns - 1);
	const int first = std::max(cell_at(float(place.z) - far, low.y, rows), 0);
	const int last = std::min(cell_at(float(place.z) + far, low.y, rows), rows - 1);
	for (int row = first; row <= last; row++) {
		for (int column = left; column <= right; column++) {
			visit(row * columns + column);
		}
	}
}

int NearSquare::count_within(const Vector3 &place, const FieldLevel &level) const {
	int count = 0;
	const float near = std::max(level.begin - level.margin, 0.0f);
	const float far = level.end > 0.0f ? level.end : std::numeric_limits<float>::max();
	for_each_cell(place, far, [&](int cell) {
		for (int i = begins[size_t(cell)]; i < begins[size_t(cell) + 1]; i++) {
			const float away = root(i).distance_to(place);
			count += away >= near && away < far ? 1 : 0;
		}
	});
	return count;
}

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
		if (!has_cone || band.casts_shadows) {
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
					[](const List &one, const List &two) { return one.mesh == two.mesh; });
}

NearPlants::~NearPlants() {
	if (RenderingServer::get_singleton()) {
		free_lists();
	}
}

void NearPlants::free_lists() {
	RenderingServer *server = RenderingServer::get_singleton();
	for (Band &band : bands) {
		for (List &list : band.lists) {
			if (list.multimesh.is_valid()) {
				server->free_rid(list.instance);
				server->free_rid(list.multimesh);
			}
		}
	}
	bands.clear();
}

void NearPlants::bind(const FieldRenderSetup &setup) {
	std::vector<Band> wanted;
	for (size_t species = 0; species < setup.styles.size(); species++) {
		const SpeciesStyle &style = setup.styles[species];
		const size_t count = style.levels.size();
		if (style.is_absent || style.materials.size() < count + 2) {
			continue;
		}
		const auto add = [&](size_t level, size_t material, float near, float far) {
			Band band;
			band.species = int(species);
			band.bit = uint8_t(1u << (material > count ? count : material));
			band.near = std::max(near - SLACK, 0.0f);
			band.far = far + SLACK;
			band.casts_shadows = material > count;
			band.material = style.materials[material]->get_rid();
			for (const FieldVariant &variant : style.variants) {
				band.heights.push_back(variant.height);
			}
			for (const Ref<ArrayMesh> &mesh : style.meshes[level]) {
				band.lists.emplace_back();
				band.lists.back().mesh = mesh->get_rid();
			}
			wanted.push_back(std::move(band));
		};
		for (size_t i = 0; i < count; i++) {
			if (style.levels[i].is_near) {
				add(i, i, style.levels[i].begin - style.levels[i].margin, style.levels[i].end);
			}
		}
		if (style.near_shadow_level >= 0) {
			add(size_t(style.near_shadow_level), count + 1, 0.0f, style.near_shadow_end);
		}
	}
	const bool are_same = std::equal(wanted.begin(), wanted.end(), bands.begin(), bands.end(),
			[](const Band &one, const Band &other) { return one.has_meshes_of(other); });
	is_due = true;
	needs_colors = setup.needs_colors;
	if (!are_same) {
		free_lists();
		bands = std::move(wanted);
		for (const std::shared_ptr<NearSquare> &square : squares) {
			std::fill(square->drawn.begin(), square->drawn.end(), uint8_t(0));
		}
		return;
	}
	for (size_t i = 0; i < bands.size(); i++) {
		bands[i].near = wanted[i].near;
		bands[i].far = wanted[i].far;
		bands[i].material = wanted[i].material;
		for (const List &list : bands[i].lists) {
			apply_flags(bands[i], list);
		}
	}
}

void NearPlants::apply_flags(const Band &band, const List &list) const {
	if (!list.instance.is_valid()) {
		return;
	}
	RenderingServer *server = RenderingServer::get_singleton();
	server->instance_geometry_set_material_override(list.instance, band.material);
	server->instance_geometry_set_cast_shadows_setting(list.instance,
			band.casts_shadows ? RenderingServer::SHADOW_CASTING_SETTING_SHADOWS_ONLY
							   : RenderingServer::SHADOW_CASTING_SETTING_OFF); // A coarser level does.
	server->instance_set_layer_mask(list.instance, render_flags.layers);
	server->instance_geometry_set_transparency(list.instance, render_flags.transparency);
	server->instance_set_scenario(list.instance, world);
	place(band, list);
	server->instance_set_visible(list.instance, is_shown(band, list));
}

bool NearPlants::is_shown(const Band &band, const List &list) const {
	return is_visible && !list.slots.empty() && (render_flags.casts_shadows || !band.casts_shadows);
}

void NearPlants::set_squares(std::vector<std::shared_ptr<NearSquare>> &&now) {
	for (Band &band : bands) {
		for (List &list : band.lists) {
			list.is_changed = list.is_changed || !list.slots.empty();
			list.slots.clear();
		}
	}
	squares = std::move(now);
	for (const std::shared_ptr<NearSquare> &square : squares) {
		square->drawn.assign(square->variants.size(), 0);
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
		sights.emplace_back(camera, placed);
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
			slot.square->drawn[size_t(slot.plant)] &= uint8_t(~band.bit);
			const int stride = slot.square->stride;
			float *floats = list.buffer.ptrw();
			const size_t last = list.slots.size() - 1;
			std::copy_n(floats + int64_t(last) * stride, stride, floats + int64_t(i) * stride);
			list.slots[i] = list.slots[last];
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
		uint8_t &drawn = square.drawn[size_t(plant)];
		const Vector3 root = square.root(plant);
		const auto sees = [&](const Sight &sight) { return sight.sees(band, root, square.reach); };
		if ((drawn & band.bit) != 0 || !std::any_of(sights.begin(), sights.end(), sees)) {
			continue;
		}
		drawn |= band.bit;
		List &list = band.lists[square.variants[size_t(plant)] % band.lists.size()];
		const int64_t at = int64_t(list.slots.size()) * square.stride;
		if (int(list.slots.size()) == list.capacity) {
			list.capacity = std::max(2 * list.capacity, MIN_CAPACITY);
			list.buffer.resize(int64_t(list.capacity) * square.stride);
			std::fill(list.buffer.ptrw() + at, list.buffer.ptrw() + list.buffer.size(), 0.0f);
		}
		float *to = list.buffer.ptrw() + at;
		std::copy_n(square.instances.ptr() + int64_t(plant) * square.stride, square.stride, to);
		const size_t variant = square.variants[size_t(plant)] % band.heights.size();
		to[square.stride - 1] *= band.heights[variant] / band.heights[variant % band.lists.size()];
		list.slots.push_back({ &square, plant });
		list.is_changed = true;
	}
}

void NearPlants::show(Band &band, const AABB &box) {
	RenderingServer *server = RenderingServer::get_singleton();
	for (List &list : band.lists) {
		if (list.multimesh.is_valid()) {
			server->multimesh_set_custom_aabb(list.multimesh, box);
		}
		if (!list.is_changed) {
			continue;
		}
		list.is_changed = false;
		if (!list.multimesh.is_valid()) {
			list.multimesh = server->multimesh_create();
			server->multimesh_set_mesh(list.multimesh, list.mesh);
			server->multimesh_set_custom_aabb(list.multimesh, box);
			list.instance = server->instance_create();
			server->instance_set_base(list.instance, list.multimesh);
			server->instance_attach_object_instance_id(list.instance, owner);
			apply_flags(band, list);
		}
		if (!list.slots.empty()) {
			if (server->multimesh_get_instance_count(list.multimesh) != list.capacity) {
				server->multimesh_allocate_data(list.multimesh, list.capacity, RenderingServer::MULTIMESH_TRANSFORM_3D,
						needs_colors, true, false);
			}
			server->multimesh_set_buffer(list.multimesh, list.buffer);
			server->multimesh_set_visible_instances(list.multimesh, int(list.slots.size()));
		}
		server->instance_set_visible(list.instance, is_shown(band, list));
	}
}

void NearPlants::set_scenario(const RID &scenario) {
	world = scenario;
	for (const Band &band : bands) {
		for (const List &list : band.lists) {
			apply_flags(band, list);
		}
	}
}

void NearPlants::set_transform(const Transform3D &transform) {
	is_due = is_due || transform != placed;
	placed = transform;
	place_all();
}

void NearPlants::set_tilt(float now) {
	if (std::exchange(tilt, now) != now) {
		place_all();
	}
}

void NearPlants::place_all() const {
	for (const Band &band : bands) {
		for (const List &list : band.lists) {
			place(band, list);
		}
	}
}

// Instances that only cast shadows have no vectors.
void NearPlants::place(const Band &band, const List &list) const {
	if (list.instance.is_valid()) {
		const bool is_tilted = tilt != 0.0f && !band.casts_shadows && !list.slots.empty();
		const float height = !is_tilted ? 0.0f : list.slots.front().square->root(list.slots.front().plant).y;
		RenderingServer::get_singleton()->instance_set_transform(
				list.instance, is_tilted ? tilted(placed, tilt, height) : placed);
	}
}

void NearPlants::set_visible(bool visible) {
	is_visible = visible;
	for (const Band &band : bands) {
		for (const List &list : band.lists) {
			apply_flags(band, list);
		}
	}
}

void NearPlants::apply_flags(const InstanceRenderFlags &flags) {
	render_flags = flags;
	for (const Band &band : bands) {
		for (const List &list : band.lists) {
			apply_flags(band, list);
		}
	}
}

} // namespace undergrowth
