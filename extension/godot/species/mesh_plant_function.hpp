#pragma once

#include "model/plant_model.hpp"
#include "species/plant_function.hpp"

#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>

namespace undergrowth {

/// A species whose plants are meshes of the user: a Mesh, a scene, or several with weights. It analyses each file once,
/// until a property changes.
class MeshPlantFunction : public PlantFunction {
	GDCLASS(MeshPlantFunction, PlantFunction)

public:
	enum Axis : int64_t {
		AXIS_AUTOMATIC = int(UpAxis::automatic),
		AXIS_PLUS_Y = int(UpAxis::plus_y),
		AXIS_MINUS_Y = int(UpAxis::minus_y),
		AXIS_PLUS_Z = int(UpAxis::plus_z),
		AXIS_MINUS_Z = int(UpAxis::minus_z),
		AXIS_PLUS_X = int(UpAxis::plus_x),
		AXIS_MINUS_X = int(UpAxis::minus_x),
	};

	enum VertexColors : int64_t {
		VERTEX_COLORS_UNUSED,
		VERTEX_COLORS_BEND_FLUTTER_PHASE,
		VERTEX_COLORS_FLUTTER_PHASE_BEND,
		VERTEX_COLORS_ALPHA_BEND,
	};

private:
	/// One file and what was found in it.
	struct Entry {
		bool is_read = false;
		std::shared_ptr<const PlantModel> model;
		godot::String problem;
	};

	godot::Array models; // Of Mesh and PackedScene.
	godot::PackedFloat32Array weights;
	Axis up_axis = AXIS_AUTOMATIC;
	float height = 0.0f; // m; 0: that of the file.
	bool has_own_root = false;
	godot::Vector3 root; // In the file's axes and unit.
	VertexColors vertex_colors = VERTEX_COLORS_UNUSED;
	godot::PackedInt32Array leaf_surfaces; // Empty: found.
	std::vector<Entry> entries;

	void forget();
	ModelOptions model_options() const;
	/// Analyses a file at the first call.
	const Entry &entry(int64_t number);
	double weight_of(int64_t number) const;
	/// Returns the number of the model of a seed; -1 if no model has a weight.
	int64_t number_of(int64_t seed) const;

protected:
	static void _bind_methods();
	void _validate_property(godot::PropertyInfo &property) const;
	godot::String sample_shape(double height, int segments, int64_t seed, SampledPlant &result) override;
	double own_height(const godot::Ref<godot::RandomNumberGenerator> &rng) const override;

public:
	MeshPlantFunction();

	bool has_parts() const override { return true; }
	/// `files`: a Mesh, a PackedScene, or an array of them.
	static godot::Ref<MeshPlantFunction> of(const godot::Variant &files);
	/// Returns what was found in a model, for people. Empty if the model has a fault, which is reported.
	godot::Dictionary find_model(int number);

	// Called by the engine.
	void on_model_changed();

	void set_models(const godot::Array &files);
	godot::Array get_models() const { return models; }
	void set_weights(const godot::PackedFloat32Array &list);
	godot::PackedFloat32Array get_weights() const { return weights; }
	void set_up_axis(Axis axis);
	Axis get_up_axis() const { return up_axis; }
	void set_height(double metres);
	double get_height() const;
	void set_has_own_root(bool has);
	bool get_has_own_root() const { return has_own_root; }
	void set_root(const godot::Vector3 &place);
	godot::Vector3 get_root() const { return root; }
	void set_vertex_colors(VertexColors use);
	VertexColors get_vertex_colors() const { return vertex_colors; }
	void set_leaf_surfaces(const godot::PackedInt32Array &numbers);
	godot::PackedInt32Array get_leaf_surfaces() const { return leaf_surfaces; }
};

} // namespace undergrowth

VARIANT_ENUM_CAST(undergrowth::MeshPlantFunction::Axis);
VARIANT_ENUM_CAST(undergrowth::MeshPlantFunction::VertexColors);
