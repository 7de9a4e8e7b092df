#pragma once

#include "field/view/field_render_setup.hpp"
#include "field/view/plant_buffer.hpp"

#include <godot_cpp/variant/aabb.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>

namespace undergrowth {

/// Where and how a field is drawn.
struct ListSurroundings {
	godot::RID world; ///< Scenario.
	godot::Transform3D placed;
	InstanceRenderFlags flags;
	bool is_visible = true;
	uint64_t owner = 0; ///< Object that the editor selects by rays.
};

/// A multimesh whose plants change while it is drawn, and its instance. Main thread.
class PlantList {
public:
	/// `stride`: floats per plant, as in a multimesh.
	PlantList(const godot::RID &mesh, int stride);
	PlantList(PlantList &&other) noexcept;
	PlantList &operator=(PlantList &&) = delete;
	~PlantList();

	const godot::RID &mesh_rid() const { return mesh; }
	PlantBuffer plants; ///< Drawn from the next upload() on.
	/// Replaces the plants. The old ones become spare.
	void exchange(PlantBuffer &&now);
	/// Returns an empty buffer with the room of the plants before the last exchange().
	PlantBuffer take_spare();
	/// Passes the plants to the renderer, which culls them all by `box` (field axes). Call set_look() and place() after
	/// it.
	void upload(const godot::AABB &box);
	/// The same without a change of the plants.
	void set_box(const godot::AABB &box) const;
	/// Without effect before the first upload().
	void set_look(const ListSurroundings &around, const godot::RID &material, bool casts_shadows) const;
	void place(const godot::Transform3D &transform) const;

private:
	PlantBuffer spare; ///< Room for the next plants.
	godot::RID mesh;
	godot::RID multimesh;
	godot::RID instance;
};

} // namespace undergrowth
