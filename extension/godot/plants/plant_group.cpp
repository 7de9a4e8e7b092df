#include "plants/plant_group.hpp"

#include "base/convert.hpp"
#include "nodes/plant_3d.hpp"
#include "wind/air_drift.hpp"

using namespace godot;

namespace undergrowth {

static glm::mat3 matrix_of(const Basis &basis) {
	return { to_glm(basis.get_column(0)), to_glm(basis.get_column(1)), to_glm(basis.get_column(2)) };
}

bool ForceSettings::operator==(const ForceSettings &other) const {
	return bodies_group == other.bodies_group && touch_margin == other.touch_margin && world == other.world &&
			has_contact == other.has_contact && apparent_wind == other.apparent_wind;
}

bool PlantKind::operator==(const PlantKind &other) const {
	return wind == other.wind && frame == other.frame && is_same_motion(species, other.species) &&
			forces == other.forces && taller == other.taller;
}

PlantGroup::PlantGroup(const PlantKind &of, float step) :
		kind(of),
		page(0, of.species, nullptr, 0, step, true, MotionPage::Keeps::directions),
		axes(matrix_of(axes_of(of.frame))) {
	page.set_taller_plants(of.taller);
}

void PlantGroup::add(Plant3D *plant, const MotionPlant &description, const PlantBone &bone) {
	plants.push_back(plant);
	bones.push_back(bone);
	page.add(&description, 1);
	roots.add(description.root);
}

void PlantGroup::remove(int index) {
	const int last = page.size() - 1;
	page.remove(index);
	if (index != last) {
		plants[size_t(index)] = plants[size_t(last)];
		plants[size_t(index)]->moved_to(index);
		bones[size_t(index)] = bones[size_t(last)];
	}
	plants.pop_back();
	bones.pop_back();
	roots.remove(index);
}

void PlantGroup::step(const FieldWind &blowing, double start, const std::vector<AirSource> &stirring) {
	const double moment = start + page.wind_moment() * double(page.step_length());
	const PlantWinds along = winds_along(blowing);
	const Vector3 way = axes_of(kind.frame).xform_inv(Vector3(along.x, 0.0f, along.z));
	const Vector3 side = axes_of(kind.frame).xform_inv(Vector3(along.side_x, 0.0f, along.side_z));
	WindSnapshot now = wind_at_time(blowing, moment);
	const Vector3 x = axes_of(kind.frame).xform_inv(Vector3(1.0f, 0.0f, 0.0f));
	const Vector3 z = axes_of(kind.frame).xform_inv(Vector3(0.0f, 0.0f, 1.0f));
	now.sources = { stirring.data(), int(stirring.size()), x.x, x.z, z.x, z.z };
	AirDrift drift;
	drift.of_roots = roots.mean_velocities();
	drift.share = kind.forces.apparent_wind;
	now.drift = &drift;
	if (page.size() > 0) {
		WindSnapshot in_world = wind_at_time(blowing, moment);
		in_world.sources = { stirring.data(), int(stirring.size()) };
		const float speed = air_speed_at(in_world, along, kind.species, kind.taller, page.length(0), page.root(0));
		air.step(speed, double(page.step_length()));
	}
	drops = drop_chance(blowing.precipitation);
	if (!kind.forces.has_bodies()) { // With bodies, PlantBodies makes room.
		page.make_room_for_lasting_bends(false);
	}
	page.step(now, { nullptr, way.x, way.z, side.x, side.z });
}

void PlantGroup::pose(float alpha, float swing_clock) {
	directions.resize(bones.size());
	page.interpolate(alpha, directions.data());
	for (size_t i = 0; i < bones.size(); i++) {
		bones[i].is_calm = bones[i].is_calm && drops <= 0.0f;
		bones[i].show(directions[i], [&]() -> PlantBone::Step {
			return { page.before(int(i)), page.direction(int(i)), page.step_length(), swing_clock,
				page.second_bend(int(i), alpha), air.speed(), air.turns(), drops };
		});
	}
}

} // namespace undergrowth
