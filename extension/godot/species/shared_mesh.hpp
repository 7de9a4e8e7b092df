#pragma once

#include "species/sampled_plant.hpp"

#include "mesh/level_error.hpp"

#include <godot_cpp/variant/vector2.hpp>

#include <memory>
#include <mutex>

namespace undergrowth {

/// The mesh of one sampled plant. All fields that draw an equal sample share it; the last one frees it. Samples are
/// compared by value, so a changed species gets other meshes. Any thread.
class SharedMesh {
public:
	/// Returns the mesh of an equal sample, or a new one that is not built.
	static std::shared_ptr<SharedMesh> of(const SampledPlant &plant);

	explicit SharedMesh(const SampledPlant &of_plant) : plant(of_plant) {}
	SharedMesh(const SharedMesh &) = delete;
	SharedMesh &operator=(const SharedMesh &) = delete;

	/// Builds the arrays, or waits until another thread has built them.
	void build();
	/// build() without waiting. Returns false while another thread builds them.
	bool try_build();
	/// Returns the engine's mesh of the arrays. Call after build(), on a thread that may create meshes
	/// (renders_on_threads()).
	godot::Ref<godot::ArrayMesh> make();

	/// Largest distance from the axis (m). Call after build().
	float width() const { return built_width; }
	/// Areas of the plant (x) and of this mesh (y) as seen from above, relative to the area as seen from the side. Call
	/// after build().
	godot::Vector2 from_above() const { return built_from_above; }
	/// True if it contains cards. Call after build().
	bool has_cards() const { return built_has_cards; }
	/// See MeshArrays. Call after build().
	bool has_bodies() const { return built_has_bodies; }
	/// Call after build().
	int triangles() const { return built_triangles; }
	/// Returns the error of the outline, and of the edges of blades (m), of a plant of parts. Builds the arrays if
	/// necessary. Any thread.
	float outline_error(const LevelError &whole);

private:
	const SampledPlant plant;
	std::mutex building; ///< Guards all members below.
	bool is_built = false;
	MeshArrays arrays; ///< Freed when the mesh exists.
	godot::Ref<godot::ArrayMesh> mesh;
	float built_width = 0.0f;
	bool built_has_cards = false;
	bool built_has_bodies = false;
	int built_triangles = 0;
	godot::Vector2 built_from_above;

	void build_locked();
};

} // namespace undergrowth
