#pragma once

#include "sampled_plant.hpp"

#include <godot_cpp/variant/vector2.hpp>

#include <memory>
#include <mutex>

namespace undergrowth {

/// The mesh of one sampled plant. All fields that draw an equal sample share it; it is freed with the last of them.
/// Its samples are compared by value, so a changed species gets other meshes. Any thread.
class SharedMesh {
public:
	/// The mesh of an equal sample, or a new one that is not built.
	static std::shared_ptr<SharedMesh> of(const SampledPlant &plant);

	explicit SharedMesh(const SampledPlant &of_plant) : plant(of_plant) {}
	SharedMesh(const SharedMesh &) = delete;
	SharedMesh &operator=(const SharedMesh &) = delete;

	/// Builds the arrays, or waits until another thread has built them.
	void build();
	/// The same without waiting. Returns false while another thread builds them.
	bool try_build();
	/// The engine's mesh of the arrays. Needs a thread that may make meshes (renders_on_threads()), after build().
	godot::Ref<godot::ArrayMesh> make();

	/// How far it reaches from the axis (m). After build().
	float width() const { return built_width; }
	/// What the plant (x) and this mesh (y) show from above, as shares of what they show from the side. After build().
	godot::Vector2 from_above() const { return built_from_above; }

private:
	const SampledPlant plant;
	std::mutex building; ///< Guards all below.
	bool is_built = false;
	MeshArrays arrays; ///< Freed when the mesh exists.
	godot::Ref<godot::ArrayMesh> mesh;
	float built_width = 0.0f;
	godot::Vector2 built_from_above;

	void build_locked();
};

} // namespace undergrowth
