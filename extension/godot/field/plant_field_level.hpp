#pragma once

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>

namespace undergrowth {

/// One level of detail of a PlantField3D: how finely plants are drawn, and up to which distance.
/// Emits `changed` for each real change.
class PlantFieldLevel : public godot::Resource {
	GDCLASS(PlantFieldLevel, godot::Resource)

	int segments = 12;
	double end = 0.0; // m.
	double density = 1.0;
	godot::String given_name;

	void level_changed();

protected:
	static void _bind_methods();
	bool _set(const godot::StringName &name, const godot::Variant &value);
	void _validate_property(godot::PropertyInfo &property) const;

public:
	/// Plants of `segments` up to `end` metres; 0: without end. At its end a `density` of them is left.
	static godot::Ref<PlantFieldLevel> of(int segments, double end = 0.0, double density = 1.0);

	void set_segments(int count);
	int get_segments() const { return segments; }
	void set_end(double metres);
	double get_end() const { return end; }
	void set_density(double value);
	double get_density() const { return density; }
};

} // namespace undergrowth
