#pragma once

#include "field/view/cameras.hpp"
#include "field/view/field_render_setup.hpp"

#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <glm/vec2.hpp>

#include <memory>
#include <vector>

namespace undergrowth {

/// The plants of one species in one square, sorted by cells, for levels that are drawn plant by plant.
struct NearSquare {
	static constexpr float CELL_SIZE = 1.0f; ///< m.

	int species = 0;
	int stride = 0; ///< Floats per plant, as in a multimesh.
	godot::PackedFloat32Array instances;
	std::vector<uint16_t> variants; ///< By plant.
	glm::vec2 low = { 0.0f, 0.0f }; ///< m, of the first cell.
	int columns = 0;
	int rows = 0;
	std::vector<int> begins; ///< First plant of each cell, and the end of the last one.
	float reach = 0.0f; ///< Largest distance of a plant's parts from its root (m).
	std::vector<uint8_t> drawn; ///< By plant: bits of the levels that draw it. Only NearPlants writes it.

	godot::Vector3 root(int plant) const {
		const float *own = instances.ptr() + int64_t(plant) * stride;
		return godot::Vector3(own[3], own[7], own[11]);
	}
	/// Returns the number of plants within the distances of a level from `place` (field axes).
	int count_within(const godot::Vector3 &place, const FieldLevel &level) const;
	template <class Visit> void for_each_cell(const godot::Vector3 &place, float far, const Visit &visit) const;
};

/// Draws the plants nearest to the cameras one by one: a multimesh for each species, level and variant that contains
/// only the plants in view at these distances. A plant keeps its place in the multimesh while it is drawn. The shader
/// selects the exact plants, so that a few more do no harm. Main thread.
class NearPlants {
public:
	NearPlants() = default;
	~NearPlants();
	NearPlants(const NearPlants &) = delete;
	NearPlants &operator=(const NearPlants &) = delete;

	/// Applies the levels, meshes and materials of `setup`. The plants stay if levels and meshes are the same.
	void bind(const FieldRenderSetup &setup);
	/// Sets all plants. Their squares must not be shared with another NearPlants.
	void set_squares(std::vector<std::shared_ptr<NearSquare>> &&now);
	/// Call before a frame is drawn. The cost depends on the plants near the cameras, and only after one has moved or
	/// turned.
	void update(const std::vector<DrawingCamera> &cameras);

	void set_scenario(const godot::RID &scenario);
	void set_transform(const godot::Transform3D &transform);
	/// As FieldView::set_tilt().
	void set_tilt(float tilt);
	void set_visible(bool visible);
	void apply_flags(const InstanceRenderFlags &flags);
	void set_owner(uint64_t object) { owner = object; }

private:
	struct Slot {
		NearSquare *square;
		int plant;
	};
	/// The plants of one mesh at one level.
	struct List {
		godot::RID mesh;
		godot::RID multimesh;
		godot::RID instance;
		int capacity = 0;
		godot::PackedFloat32Array buffer; ///< Of `capacity` plants.
		std::vector<Slot> slots;
		bool is_changed = false;
	};
	/// One level of one species.
	struct Band {
		int species = 0;
		uint8_t bit = 0;
		float near = 0.0f; ///< m, world.
		float far = 0.0f;
		bool casts_shadows = false; ///< True: it only casts shadows, of plants on all sides.
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
	bool needs_colors = false;
	godot::RID world;
	godot::Transform3D placed;
	float tilt = 0.0f;
	bool is_visible = true;
	InstanceRenderFlags render_flags;
	uint64_t owner = 0;

	void free_lists();
	void apply_flags(const Band &band, const List &list) const;
	void place(const Band &band, const List &list) const;
	void place_all() const;
	bool is_shown(const Band &band, const List &list) const;
	bool must_update(const std::vector<DrawingCamera> &cameras) const;
	void take_out(Band &band, const std::vector<Sight> &sights);
	void put_in(Band &band, const std::vector<Sight> &sights);
	void put_in(Band &band, NearSquare &square, int cell, const std::vector<Sight> &sights);
	void show(Band &band, const godot::AABB &box);
};

} // namespace undergrowth
