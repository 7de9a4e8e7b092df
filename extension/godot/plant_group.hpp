#pragma once

#include "bodies/root_ways.hpp"
#include "motion/bodies.hpp"
#include "plant_bone.hpp"
#include "plant_frame.hpp"
#include "plant_wind.hpp"
#include "wind/air_sources.hpp"

#include <godot_cpp/variant/string_name.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

class Plant3D;

/// What else than the wind moves a plant that stands alone.
struct PlantPush {
	godot::StringName bodies_group; ///< Whose bodies push it; empty: nobody's.
	float touch_margin = 0.0f; ///< m; 0 without bodies.
	uint64_t world = 0; ///< Instance id of the World3D that it is in; 0: none.
	bool has_contact = false; ///< It touches the tips of its world.
	float apparent_wind = 1.0f; ///< How much of its own motion it feels as wind.

	bool has_bodies() const { return !bodies_group.is_empty(); }
	bool operator==(const PlantPush &other) const;
};

/// What plants have in common that share a page.
struct PlantKind {
	MotionSpecies species;
	godot::Ref<PlantWind> wind; ///< Null: still air.
	PlantFrame frame = PlantFrame::WORLD; ///< Axes of the page's directions; its roots are in the world's.
	PlantPush push;

	bool operator==(const PlantKind &other) const;
};

/// Plants of one kind: a page that is stepped together, and the bones that show it.
struct PlantGroup {
	PlantGroup(const PlantKind &of, float step);

	PlantKind kind;
	MotionPage page;
	std::vector<Plant3D *> plants; ///< plants[i] is the page's plant i; touched only where plants come and go.
	std::vector<PlantBone> bones; ///< As many.
	std::vector<glm::vec3> directions; ///< As many, for drawing.
	RootWays roots; ///< As many.
	glm::mat3 axes; ///< Of the kind's frame.

	void add(Plant3D *plant, const MotionPlant &description, const PlantBone &bone);
	/// The last plant takes its index.
	void remove(int index);
	/// One step that begins when the wind's clock shows `start` (s), with what stirs the air of its world.
	void step(const FieldWind &air, double start, const std::vector<AirSource> &stirring);
	/// Null where directions have the world's axes.
	const glm::mat3 *turned_axes() const { return kind.frame == PlantFrame::WORLD ? nullptr : &axes; }
	/// Turns all bones to where their plants point, `alpha` of the way of the last step.
	/// `swing_clock`: as StemMotion::clock.
	void pose(float alpha, float swing_clock);
};

} // namespace undergrowth
