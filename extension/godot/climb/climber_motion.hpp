#pragma once

#include "climb/climb_chunks.hpp"
#include "motion/fixed_step.hpp"
#include "motion/swing_clock.hpp"
#include "plants/plant_group.hpp"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/shader_material.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <memory>
#include <vector>

namespace undergrowth {

/// The motion of a climber: each of its parts (ClimbCell) is a row of a page that moves as a Plant3D of the leaf's
/// species at its place, with the surface as its ground. PlantSimulation steps it. A texture passes the bends to the
/// shader. Main thread.
class ClimberMotion {
public:
	/// What all parts share.
	struct Setup {
		MotionSpecies species;
		glm::vec2 rest = { 0.0f, 0.0f }; ///< Bend in calm air, in a leaf's own axes.
		float length = 0.1f; ///< m, of a leaf's plant.
		godot::Ref<PlantWind> wind;
		uint64_t world = 0;
	};

	ClimberMotion() = default;
	~ClimberMotion();
	ClimberMotion(const ClimberMotion &) = delete;
	ClimberMotion &operator=(const ClimberMotion &) = delete;

	/// Takes other parts, at rest. `of_bodies`: from the axes of growth to the world's, by body. `root`: y is the
	/// ground from which the wind's height is measured (m, world axes).
	void set_cells(const std::vector<ClimbCell> &parts, const std::vector<godot::Transform3D> &of_bodies, float root);
	/// Applies a changed species or wind. Begins at rest.
	void set_up(const Setup &changed);
	/// Follows moved bodies.
	void place(const std::vector<godot::Transform3D> &of_bodies);
	/// The material to pass the motion to.
	void show_in(const godot::Ref<godot::ShaderMaterial> &leaves);
	bool is_empty() const { return cells.empty(); }
	const godot::Ref<PlantWind> &wind() const { return setup.wind; }
	uint64_t world() const { return setup.world; }
	/// Sets all parts to rest.
	void settle();

	// For PlantSimulation.
	void step(const FieldWind &blowing, double start, const std::vector<AirSource> &stirring);
	void pose(float alpha, float swing_clock);
	void set_step_length(float seconds);

	/// Moves it by `delta` seconds of the clock of `blowing`, for tools.
	void preview(double delta, const godot::Ref<PlantWind> &blowing);
	/// Returns the displacement of a part's bend from calm air: a vector of the world, across the part's axis.
	godot::Vector3 bend_of(int cell) const;
	/// Returns the motion of a leaf in a part, with the axes `leaf` (world, orthonormal).
	StemMotion motion_in(int cell, const godot::Basis &leaf) const;

private:
	struct Rows {
		std::unique_ptr<PlantGroup> group;
		std::vector<int> cells;
	};
	struct Cell {
		ClimbCell is;
		glm::vec3 place = { 0.0f, 0.0f, 0.0f }; ///< m, world axes.
		glm::mat3 axes = glm::mat3(1.0f); ///< World: across, out of the surface, and down.
		glm::vec3 bend = { 0.0f, 0.0f, 0.0f };
		glm::vec3 rate = { 0.0f, 0.0f, 0.0f };
	};

	Setup setup;
	std::vector<Cell> cells;
	std::vector<Rows> pages; ///< One for each frame in which rows are.
	float ground = 0.0f; ///< m, world y.
	float step_length = 1.0f / 60.0f;
	godot::Ref<godot::ShaderMaterial> material;
	godot::Ref<godot::Image> image;
	godot::PackedByteArray texels;
	godot::RID texture;
	bool is_shown = false; ///< The texture has the present bends.
	float shown_clock = 0.0f;
	FixedStep preview_clock{ 1.0 / 60.0 };
	SwingClock preview_swings;

	void begin();
	void place_cell(Cell &cell, const godot::Transform3D &body) const;
	MotionPlant row_of(const Cell &cell, PlantFrame frame) const;
	PlantFrame frame_of(const Cell &cell) const;
	glm::vec3 rest_of(const Cell &cell) const;
	const PlantGroup *largest() const;
	void upload();
	void send(float swing_clock);
};

} // namespace undergrowth
