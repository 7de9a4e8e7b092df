#pragma once

#include "base/worker_task.hpp"
#include "field/view/cameras.hpp"
#include "field/view/near_square.hpp"
#include "field/view/plant_list.hpp"

#include <memory>
#include <vector>

namespace undergrowth {

/// Casts the shadows of the plants around the cameras: a multimesh for each ShadowCaster and mesh, with fewer and wider
/// plants away from the camera. So shadows do not depend on the squares and levels that draw the plants. A worker
/// thread lists the plants, and the shadows follow a few frames later. Main thread.
class ShadowPlants {
public:
	ShadowPlants();
	~ShadowPlants();

	/// Applies the casters, meshes and materials of `setup`. The lists stay if the meshes are the same.
	void bind(const FieldRenderSetup &setup);
	/// Sets all plants.
	void set_squares(const std::vector<std::shared_ptr<NearSquare>> &now);
	/// Call before a frame is drawn. Passes lists of a bounded number of plants to the renderer.
	void update(const std::vector<DrawingCamera> &cameras);
	/// True while plants are being listed, or lists wait for the renderer.
	bool is_listing() const;
	/// As those of NearPlants. A field that moves with its camera keeps its lists.
	void follow(const ListSurroundings &now);
	void set_transform(const godot::Transform3D &placed);

private:
	using Squares = std::vector<std::shared_ptr<NearSquare>>;

	/// A camera in the field's axes, and what a caster needs of it.
	struct Sight {
		godot::Vector3 place;
		float begin, end; ///< Distances of the caster, in the field's unit.
		float metres; ///< Length of that unit, or less.

		Sight(const DrawingCamera &camera, const godot::Transform3D &placed, const ShadowCaster &caster);
		/// True if a list for this camera is good enough for `now`.
		bool covers(const Sight &now) const;
	};
	/// Plants of one caster, as a worker thread lists them.
	struct Listing;
	/// One caster of one species.
	struct Band {
		Band() = default;
		Band(Band &&) noexcept = default; // godot-cpp's RID has no noexcept move, so vectors would copy.
		Band &operator=(Band &&) noexcept = default;

		int species = 0;
		ShadowCaster caster;
		godot::RID material;
		std::vector<float> heights; ///< m, of the species' variants.
		std::vector<PlantList> lists; ///< By mesh.
		std::vector<Sight> seen; ///< Cameras of its last list.
		Squares listed; ///< Squares of that list.
		bool is_due = true; ///< Something else has changed since.
	};

	std::vector<Band> bands;
	std::vector<Squares> squares; ///< By species.
	bool has_other_squares = false;
	ListSurroundings around;
	std::vector<std::unique_ptr<Listing>> listings; ///< Of the task, and then to be passed to the renderer.
	WorkerTask task; ///< After `listings`, which it writes.

	bool is_shown() const { return around.flags.casts_shadows && around.is_visible; }
	static bool has_meshes_of(const Band &one, const Band &other);
	std::vector<Sight> sights_of(const Band &band, const std::vector<DrawingCamera> &cameras) const;
	Squares squares_in(const Band &band, const std::vector<Sight> &sights) const;
	void take_other_squares();
	void start(const std::vector<DrawingCamera> &cameras);
	void show_listed();
	void set_look(const Band &band) const;
};

} // namespace undergrowth
