#pragma once

#include "bodies/root_velocities.hpp"
#include "motion/bodies.hpp"
#include "motion/part_air.hpp"
#include "plants/plant_bone.hpp"
#include "plants/plant_frame.hpp"
#include "wind/air_sources.hpp"
#include "wind/plant_wind.hpp"

#include <godot_cpp/variant/string_name.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

class Plant3D;

/// Forces on a `Plant3D` other than the wind.
struct ForceSettings {
	godot::StringName bodies_group; ///< Group of the bodies that push it; empty: none.
	float touch_margin = 0.0f; ///< m; 0 without bodies.
	uint64_t world = 0; ///< Instance id of its World3D; 0: none.
	bool has_contact = false; ///< Its tip touches the tips of its world.
	float apparent_wind = 1.0f; ///< Share of its own motion that acts as wind.

	bool has_bodies() const { return !bodies_group.is_empty(); }
	bool operator==(const ForceSettings &other) const;
};

/// Properties that all plants of a page share.
struct PlantKind {
	MotionSpecies species;
	godot::Ref<PlantWind> wind; ///< Null: still air.
	PlantFrame frame = PlantFrame::WORLD; ///< Axes of the page's directions; roots are in world axes.
	ForceSettings forces;
	TallerPlants taller = {}; ///< Of a field around them.

	bool operator==(const PlantKind &other) const;
};

/// Plants of one kind: a page that steps together, and the bones that show it.
struct PlantGroup {
	PlantGroup(const PlantKind &of, float step);

	PlantKind kind;
	MotionPage page;
	std::vector<Plant3D *> plants; ///< plants[i] is row i of the page; read only when plants are added or removed.
	std::vector<PlantBone> bones; ///< One for each row.
	std::vector<glm::vec3> directions; ///< One for each row, for drawing.
	RootVelocities roots; ///< One for each row.
	glm::mat3 axes; ///< Of the kind's frame.
	PartAir air; ///< At the first plant.
	float drops = 0.0f; ///< As in StemMotion.

	void add(Plant3D *plant, const MotionPlant &description, const PlantBone &bone);
	/// Removes a row; the last plant gets its index.
	void remove(int index);
	/// Runs one step that begins at `start` (s) of the wind's clock. `stirring`: sources that stir the air of its
	/// world.
	void step(const FieldWind &blowing, double start, const std::vector<AirSource> &stirring);
	/// Null if directions are in world axes.
	const glm::mat3 *turned_axes() const { return kind.frame == PlantFrame::WORLD ? nullptr : &axes; }
	/// Turns all bones to the directions at `alpha` of the last step. `swing_clock`: as StemMotion::clock.
	void pose(float alpha, float swing_clock);
};

} // namespace undergrowth
