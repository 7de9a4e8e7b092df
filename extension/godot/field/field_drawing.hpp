#pragma once

#include "field/chunks.hpp"
#include "field/field_looks.hpp"
#include "field/field_simulation.hpp"

#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <map>
#include <tuple>
#include <vector>

namespace undergrowth {

/// What all plants of a field share.
struct FieldStyle {
	std::vector<FieldLook> looks; ///< By species.
	std::vector<FieldLevel> levels;
	bool needs_colors = false; ///< Compatibility takes custom data for colours where instances have no colours.
};

/// Plants that came together, sorted by chunks, and where each is in the simulation's pages.
struct FieldPatch {
	static constexpr uint32_t GONE = 0xffffffffu;

	FieldPlants plants;
	FieldChunks chunks;
	std::vector<uint32_t> places; ///< page·PAGE_PLANTS + index, or GONE for a plant that was removed.

	int page(int plant) const { return int(places[size_t(plant)] / MotionPage::PAGE_PLANTS); }
	int index(int plant) const { return int(places[size_t(plant)] % MotionPage::PAGE_PLANTS); }
};

/// A square of the ground at one level of detail: FieldLevel::chunk_factor chunks wide.
struct ClumpPlace {
	int level;
	int column;
	int row;

	bool operator<(const ClumpPlace &other) const {
		return std::tie(level, column, row) < std::tie(other.level, other.column, other.row);
	}
};

/// One multimesh in the making: plants of one place that show one mesh.
struct ClumpPlan {
	ClumpPlace place;
	int species = 0;
	int group = 0;
	int count = 0;
	int stride = 0; ///< Floats per plant.
	godot::PackedFloat32Array buffer;
	godot::AABB box; ///< Covers the largest deflection.
};

/// The multimeshes of a patch, one for each level, chunk, species and mesh. Transforms never change: what moves is in
/// the textures of FieldBends, which each instance names its place in.
class FieldDrawing {
public:
	FieldDrawing() = default;
	~FieldDrawing();
	FieldDrawing(const FieldDrawing &) = delete;
	FieldDrawing &operator=(const FieldDrawing &) = delete;

	/// How all of a patch is drawn. On any thread.
	static std::vector<ClumpPlan> plan(const FieldStyle &style, const FieldPatch &patch);
	/// The same for one place only.
	static std::vector<ClumpPlan> plan_one(const FieldStyle &style, const FieldPatch &patch, const ClumpPlace &place);
	/// Where plants of a chunk are drawn.
	static ClumpPlace place_of(const FieldStyle &style, int level, int column, int row);

	// Main thread.
	void show(const FieldStyle &style, const std::vector<ClumpPlan> &plans);
	/// Takes what stands at `place` away and shows `plans` there.
	void replace(const FieldStyle &style, const ClumpPlace &place, const std::vector<ClumpPlan> &plans);
	/// Into which world, or none.
	void set_scenario(const godot::RID &scenario);
	void set_transform(const godot::Transform3D &transform);
	void set_visible(bool visible);
	void set_layers(uint32_t mask);

	struct Clump {
		godot::RID multimesh;
		godot::RID instance;
		int count = 0;
		godot::Vector3 middle;
		float radius = 0.0f;
	};
	/// Plants that are shown at each level to an eye at `eye` (field axes), and multimeshes that they take.
	std::vector<int> count_drawn(const FieldStyle &style, const godot::Vector3 &eye) const;

private:
	std::map<ClumpPlace, std::vector<Clump>> clumps;
	godot::RID world;
	godot::Transform3D placed;
	bool is_visible = true;
	uint32_t layers = 1;

	Clump make(const FieldStyle &style, const ClumpPlan &plan);
	template <class Act> void for_each(Act &&act) const;
};

} // namespace undergrowth
