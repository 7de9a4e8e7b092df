#include "climb/climber_motion.hpp"

#include "base/convert.hpp"
#include "field/view/field_material.hpp"
#include "nodes/plant_wind_source_3d.hpp"

#include <godot_cpp/classes/rendering_server.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace godot;

namespace undergrowth {

static constexpr int COLUMNS = 32; // Parts in a row of texels, as in undergrowth_climb.gdshaderinc.
static constexpr int TEXEL_FLOATS = 4;
static constexpr float SWINGS_WHOLE = 20.0f; // m from the camera.
static constexpr float SWINGS_TO = 30.0f;
static constexpr float MIN_CHANGE = 1e-5f; // Of a bend.

static glm::vec2 bend_of_own(const glm::vec3 &own) {
	return glm::vec2(own.x, own.z) / std::max(1.0f + own.y, 1e-3f);
}

ClimberMotion::~ClimberMotion() {
	RenderingServer *server = RenderingServer::get_singleton();
	if (server && texture.is_valid()) {
		server->free_rid(texture);
	}
}

void ClimberMotion::set_cells(
		const std::vector<ClimbCell> &parts, const std::vector<Transform3D> &of_bodies, float root) {
	cells.clear();
	ground = root;
	for (const ClimbCell &part : parts) {
		Cell cell;
		cell.is = part;
		place_cell(cell, of_bodies[size_t(part.body)]);
		cells.push_back(cell);
	}
	begin();
}

void ClimberMotion::set_up(const Setup &changed) {
	setup = changed;
	begin();
}

void ClimberMotion::place_cell(Cell &cell, const Transform3D &body) const {
	cell.place = to_glm(body.xform(to_godot(cell.is.place)));
	const glm::vec3 out = to_glm(body.basis.xform(to_godot(cell.is.normal)).normalized());
	const glm::vec3 other = std::fabs(out.y) < 0.9f ? glm::vec3(0.0f, -1.0f, 0.0f) : glm::vec3(0.0f, 0.0f, 1.0f);
	const glm::vec3 down = glm::normalize(other - out * glm::dot(other, out));
	cell.axes = glm::mat3(glm::cross(out, down), out, down);
}

// The page of a law without rest directions has the axis of its frame.
PlantFrame ClimberMotion::frame_of(const Cell &cell) const {
	return frame_for(Law::spring, to_godot(cell.axes[1]));
}

glm::vec3 ClimberMotion::rest_of(const Cell &cell) const {
	const glm::vec2 bend = setup.rest;
	const float square = glm::dot(bend, bend);
	return cell.axes * (glm::vec3(2.0f * bend.x, 1.0f - square, 2.0f * bend.y) / (1.0f + square));
}

MotionPlant ClimberMotion::row_of(const Cell &cell, PlantFrame frame) const {
	MotionPlant row;
	row.root = cell.place;
	row.length = setup.length;
	if (PlantWind::is_air(setup.wind) && setup.species.law == Law::stem) {
		row.length = std::max(cell.place.y - ground, 0.0f) + setup.length; // The height at which the wind is sampled.
	}
	row.rest = to_glm(axes_of(frame).xform_inv(to_godot(rest_of(cell))));
	return row;
}

void ClimberMotion::begin() {
	pages.clear();
	is_shown = false;
	ForceSettings forces;
	forces.world = setup.world;
	forces.apparent_wind = 0.0f;
	for (size_t i = 0; i < cells.size(); i++) {
		const PlantFrame frame = frame_of(cells[i]);
		auto own = std::find_if(
				pages.begin(), pages.end(), [&](const Rows &rows) { return rows.group->kind.frame == frame; });
		if (own == pages.end()) {
			Rows made;
			made.group = std::make_unique<PlantGroup>(
					PlantKind{ setup.species, setup.wind, frame, forces, {} }, step_length);
			pages.push_back(std::move(made));
			own = pages.end() - 1;
		}
		const MotionPlant row = row_of(cells[i], frame);
		own->group->page.add(&row, 1);
		own->group->roots.add(row.root);
		own->cells.push_back(int(i));
		cells[i].bend = cells[i].rate = glm::vec3(0.0f);
	}
}

void ClimberMotion::place(const std::vector<Transform3D> &of_bodies) {
	bool is_turned = false;
	for (Cell &cell : cells) {
		const PlantFrame before = frame_of(cell);
		place_cell(cell, of_bodies[size_t(cell.is.body)]);
		is_turned = is_turned || frame_of(cell) != before;
	}
	if (is_turned) {
		begin();
		return;
	}
	for (Rows &rows : pages) {
		for (size_t i = 0; i < rows.cells.size(); i++) {
			rows.group->page.set_plant(int(i), row_of(cells[size_t(rows.cells[i])], rows.group->kind.frame));
		}
	}
	is_shown = false;
}

void ClimberMotion::show_in(const Ref<ShaderMaterial> &leaves) {
	material = leaves;
	is_shown = false;
	pose(1.0f, shown_clock);
}

void ClimberMotion::settle() {
	for (Rows &rows : pages) {
		rows.group->page.settle();
	}
	is_shown = false;
	pose(1.0f, shown_clock);
}

void ClimberMotion::set_step_length(float seconds) {
	step_length = seconds;
	preview_clock = FixedStep(double(seconds));
	for (Rows &rows : pages) {
		rows.group->page.set_step_length(seconds);
	}
}

void ClimberMotion::step(const FieldWind &blowing, double start, const std::vector<AirSource> &stirring) {
	for (Rows &rows : pages) {
		rows.group->step(blowing, start, stirring);
	}
}

void ClimberMotion::pose(float alpha, float swing_clock) {
	bool has_moved = !is_shown;
	for (Rows &rows : pages) {
		PlantGroup &group = *rows.group;
		group.directions.resize(rows.cells.size());
		group.page.interpolate(alpha, group.directions.data());
		for (size_t i = 0; i < rows.cells.size(); i++) {
			Cell &cell = cells[size_t(rows.cells[i])];
			const glm::mat3 to_own = glm::transpose(cell.axes) * group.axes;
			const auto bend = [&](const glm::vec3 &direction) { return bend_of_own(to_own * direction); };
			const glm::vec2 rest = bend(group.page.rest(int(i)));
			const glm::vec2 now = bend(group.directions[i]) - rest;
			const glm::vec2 rate =
					(bend(group.page.direction(int(i))) - bend(group.page.before(int(i)))) / group.page.step_length();
			const glm::vec3 shown = cell.axes * glm::vec3(now.x, 0.0f, now.y);
			cell.rate = cell.axes * glm::vec3(rate.x, 0.0f, rate.y);
			has_moved = has_moved || glm::distance(shown, cell.bend) > MIN_CHANGE;
			cell.bend = shown;
		}
	}
	if (has_moved) {
		upload();
	}
	send(swing_clock);
}

void ClimberMotion::upload() {
	if (cells.empty() || material.is_null()) {
		return;
	}
	RenderingServer *server = RenderingServer::get_singleton();
	const int height = int(cells.size() + COLUMNS - 1) / COLUMNS;
	const bool is_new = image.is_null() || image->get_height() != height;
	texels.resize(int64_t(2) * COLUMNS * height * TEXEL_FLOATS * int64_t(sizeof(float)));
	float *to = reinterpret_cast<float *>(texels.ptrw());
	for (size_t i = 0; i < cells.size(); i++) {
		std::memcpy(to + 2 * TEXEL_FLOATS * i, &cells[i].bend, sizeof(glm::vec3));
		std::memcpy(to + 2 * TEXEL_FLOATS * i + TEXEL_FLOATS, &cells[i].rate, sizeof(glm::vec3));
	}
	if (is_new) {
		image = Image::create_from_data(2 * COLUMNS, height, false, Image::FORMAT_RGBAF, texels);
		const RID old = texture;
		texture = server->texture_2d_create(image);
		server->material_set_param(material->get_rid(), "undergrowth_parts_of_climber", texture);
		if (old.is_valid()) {
			server->free_rid(old);
		}
	} else {
		image->set_data(2 * COLUMNS, height, false, Image::FORMAT_RGBAF, texels);
		server->texture_2d_update(texture, image, 0);
		if (!is_shown) {
			server->material_set_param(material->get_rid(), "undergrowth_parts_of_climber", texture);
		}
	}
	is_shown = true;
}

const PlantGroup *ClimberMotion::largest() const {
	const auto found = std::max_element(pages.begin(), pages.end(),
			[](const Rows &one, const Rows &other) { return one.cells.size() < other.cells.size(); });
	return found == pages.end() ? nullptr : found->group.get();
}

void ClimberMotion::send(float swing_clock) {
	shown_clock = swing_clock;
	const PlantGroup *air = largest();
	if (material.is_null() || !air) {
		return;
	}
	static const StringName &swing = *new StringName("undergrowth_swing");
	static const StringName &around = *new StringName("undergrowth_air");
	static const StringName &wet = *new StringName("undergrowth_precipitation");
	RenderingServer *server = RenderingServer::get_singleton();
	server->material_set_param(material->get_rid(), swing, Vector3(swing_clock, SWINGS_WHOLE, SWINGS_TO));
	server->material_set_param(
			material->get_rid(), around, Vector4(air->air.speed(), 0.0f, air->air.turns(), air->drops));
	const Precipitation falls = setup.wind.is_valid() ? setup.wind->precipitation() : Precipitation();
	server->material_set_param(material->get_rid(), wet, Vector2(falls.wetness, falls.snow));
}

void ClimberMotion::preview(double delta, const Ref<PlantWind> &blowing) {
	static const FieldWind CALM = { { WindKind::constant, 0.0f }, 0.0f };
	std::vector<AirSource> stirring;
	PlantWindSource3D::gather(setup.world, 0.0, stirring);
	double time = blowing.is_valid() ? blowing->get_time() - delta : 0.0;
	const FieldWind air = blowing.is_valid() ? blowing->travelling() : CALM;
	for (int steps = preview_clock.advance(delta); steps > 0; steps--) {
		step(air, time, stirring);
		preview_swings.step(preview_clock.step());
		time += preview_clock.step();
	}
	pose(preview_clock.alpha(), preview_swings.now(preview_clock.alpha()));
}

Vector3 ClimberMotion::bend_of(int cell) const {
	return to_godot(cells[size_t(cell)].bend);
}

StemMotion ClimberMotion::motion_in(int cell, const Basis &leaf) const {
	const Cell &one = cells[size_t(cell)];
	const auto own = [&](const glm::vec3 &v) {
		const Vector3 turned = leaf.xform_inv(to_godot(v));
		return glm::vec2(turned.x, turned.z);
	};
	StemMotion motion;
	motion.bend = own(one.bend);
	motion.rate = own(one.rate);
	motion.clock = shown_clock;
	if (const PlantGroup *air = largest()) {
		motion.air = air->air.speed();
		motion.turns = air->air.turns();
		motion.drops = air->drops;
	}
	return motion;
}

} // namespace undergrowth
