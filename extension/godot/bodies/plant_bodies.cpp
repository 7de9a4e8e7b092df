#include "bodies/plant_bodies.hpp"

#include "nodes/plant_3d.hpp"

#include <algorithm>
#include <iterator>

using namespace godot;

namespace undergrowth {

bool PlantBodies::Touch::operator<(const Touch &other) const {
	return plant != other.plant ? plant < other.plant : body < other.body;
}

void PlantBodies::follow(const std::vector<std::unique_ptr<PlantGroup>> &groups) {
	for (Reading &reading : readings) {
		reading.groups.clear();
	}
	are_named = false;
	for (const std::unique_ptr<PlantGroup> &group : groups) {
		if (group->kind.forces.has_bodies()) {
			reading_of(group->kind.forces).groups.push_back(group.get());
			are_named = true;
		}
	}
	for (Reading &reading : readings) { // An unused reading remains, so that its warnings are not repeated.
		if (reading.groups.empty()) {
			reading.bodies.forget();
		}
	}
}

PlantBodies::Reading &PlantBodies::reading_of(const ForceSettings &forces) {
	const auto is_its = [&forces](const Reading &reading) {
		return reading.name == forces.bodies_group && reading.world == forces.world;
	};
	const auto known = std::find_if(readings.begin(), readings.end(), is_its);
	if (known != readings.end()) {
		return *known;
	}
	readings.emplace_back();
	readings.back().name = forces.bodies_group;
	readings.back().world = forces.world;
	return readings.back();
}

void PlantBodies::watch(BodyReadings &engine, double delta) {
	for (Reading &reading : readings) {
		if (!reading.groups.empty()) {
			reading.bodies.watch(engine.read(reading.name, reading.world), Transform3D(), delta);
		}
	}
}

void PlantBodies::gather(double ago) {
	for (Reading &reading : readings) {
		reading.shapes = &reading.bodies.gather(ago);
	}
}

void PlantBodies::push() {
	for (Reading &reading : readings) {
		for (PlantGroup *group : reading.groups) {
			const PageFrame frame = { group->turned_axes(), group->roots.velocities() };
			make_room_for_lasting_bends(group->page, *reading.shapes);
			for (const MovingBody &shape : *reading.shapes) {
				push_plants(group->page, shape, frame);
			}
		}
	}
}

void PlantBodies::find(const Reading &reading, const PlantGroup &group) {
	const PageFrame frame = { group.turned_axes(), nullptr };
	const float margin = group.kind.forces.touch_margin;
	reading.bodies.for_each_shape([&](uint64_t body, const MovingBody &shape) {
		if (!is_valid(shape)) {
			return;
		}
		MovingBody reach = shape;
		reach.radius += margin;
		for_each_in_reach(group.page, reach, [&](int i) {
			if (touches_plant(group.page, i, shape, margin, frame)) {
				found.push_back({ uint64_t(group.plants[size_t(i)]->get_instance_id()), body });
			}
		});
	});
}

void PlantBodies::report_touches() {
	found.clear();
	for (Reading &reading : readings) {
		for (const PlantGroup *group : reading.groups) {
			find(reading, *group);
		}
		reading.bodies.drop_gone();
	}
	const auto is_same = [](const Touch &a, const Touch &b) { return a.plant == b.plant && a.body == b.body; };
	std::sort(found.begin(), found.end());
	found.erase(std::unique(found.begin(), found.end(), is_same), found.end());
	const std::vector<Touch> before = std::move(touches);
	touches = found;
	for (const Touch &touch : touches) {
		Plant3D *plant = Object::cast_to<Plant3D>(ObjectDB::get_instance(touch.plant));
		if (plant && !std::binary_search(before.begin(), before.end(), touch)) {
			plant->report_body(touch.body, true);
		}
	}
	for (const Touch &touch : before) {
		if (!std::binary_search(found.begin(), found.end(), touch)) {
			report_end(touch);
		}
	}
	std::sort(touches.begin(), touches.end());
}

// A plant that is not simulated now, such as a paused one, retains its touches until it is simulated again.
void PlantBodies::report_end(const Touch &touch) {
	Plant3D *plant = Object::cast_to<Plant3D>(ObjectDB::get_instance(touch.plant));
	if (plant && plant->is_in_simulation()) {
		plant->report_body(touch.body, false);
	} else if (plant) {
		touches.push_back(touch);
	}
}

void PlantBodies::forget(const Plant3D *plant) {
	const uint64_t id = plant->get_instance_id();
	const auto is_its = [id](const Touch &touch) { return touch.plant == id; };
	touches.erase(std::remove_if(touches.begin(), touches.end(), is_its), touches.end());
}

std::vector<String> PlantBodies::take_warnings() {
	std::vector<String> all;
	for (Reading &reading : readings) {
		const std::vector<String> own = reading.bodies.take_warnings();
		all.insert(all.end(), own.begin(), own.end());
	}
	return all;
}

} // namespace undergrowth
