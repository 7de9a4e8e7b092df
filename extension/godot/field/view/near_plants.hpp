#pragma once

#include "field/view/cameras.hpp"
#include "field/view/near_square.hpp"
#include "field/view/plant_list.hpp"

#include <memory>
#include <vector>

namespace undergrowth {

/// Draws the plants nearest to the cameras one by one: a multimesh for each species, level and variant that contains
/// only the plants in view at these distances. A plant keeps its place in the multimesh while it is drawn. The shader
/// selects the exact plants, so that a few more do no harm. Main thread.
class NearPlants {
public:
	/// Applies the levels, meshes and materials of `setup`. The plants stay if levels and meshes are the same.
	void bind(const FieldRenderSetup &setup);
	/// Sets all plants. Their squares must not be shared with another NearPlants.
	void set_squares(std::vector<std::shared_ptr<NearSquare>> &&now);
	/// Call before a frame is drawn. The cost depends on the plants near the cameras, and only after one has moved or
	/// turned.
	void update(const std::vector<DrawingCamera> &cameras);

	/// Applies all of `now`. If only the place has changed, set_transform() costs less.
	void follow(const ListSurroundings &now);
	void set_transform(const godot::Transform3D &placed);
	/// As FieldView::set_tilt().
	void set_tilt(float tilt);

private:
	struct Slot {
		NearSquare *square;
		int plant;
	};
	/// The plants of one mesh at one level.
	struct List {
		PlantList drawn;
		std::vector<Slot> slots; ///< By plant of `drawn`.
		bool is_changed = false;
	};
	/// One level of one species.
	struct Band {
		Band() = default;
		Band(Band &&) noexcept = default; // godot-cpp's RID has no noexcept move, so vectors would copy.
		Band &operator=(Band &&) noexcept = default;

		int species = 0;
		uint16_t bit = 0;
		float near = 0.0f; ///< m, world.
		float far = 0.0f;
		godot::RID material;
		std::vector<float> heights; ///< m, of the species' variants.
		std::vector<List> lists; ///< By variant, or by some of them at coarser levels.

		bool has_meshes_of(const Band &other) const; ///< And the same place among the bits of plants.
	};
	/// A camera in the field's axes, with distances that are never too strict.
	struct Sight;

	std::vector<Band> bands;
	std::vector<std::shared_ptr<NearSquare>> squares;
	std::vector<DrawingCamera> seen; ///< Cameras of the last update.
	bool is_due = false; ///< Everything may have changed since.
	ListSurroundings around;
	float tilt = 0.0f;

	void set_look(const Band &band, const List &list) const;
	void place(const List &list) const;
	template <class Act> void for_each_list(const Act &act) const;
	bool must_update(const std::vector<DrawingCamera> &cameras) const;
	void take_out(Band &band, const std::vector<Sight> &sights);
	void put_in(Band &band, const std::vector<Sight> &sights);
	void put_in(Band &band, NearSquare &square, int cell, const std::vector<Sight> &sights);
	void show(Band &band, const godot::AABB &box);
};

} // namespace undergrowth
