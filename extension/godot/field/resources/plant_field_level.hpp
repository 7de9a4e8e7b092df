#pragma once

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>

namespace undergrowth {

/// One level of detail of a PlantField3D: the segments of its plants and the distance at which it ends. Emits `changed`
/// for each real change.
class PlantFieldLevel : public godot::Resource {
	GDCLASS(PlantFieldLevel, godot::Resource)

	int segments = 12;
	double end = 0.0; // m.
	double density = 1.0;
	godot::String auto_name;

	void level_changed();

protected:
	static void _bind_methods();
	bool _set(const godot::StringName &name, const godot::Variant &value);
	void _validate_property(godot::PropertyInfo &property) const;

public:
	/// Returns a level with `segments` up to `end` metres (0: no end). At its end, a `density` of the plants remains.
	static godot::Ref<PlantFieldLevel> of(int segments, double end = 0.0, double density = 1.0);

	void set_segments(int count);
	int get_segments() const { return segments; }
	void set_end(double metres);
	double get_end() const { return end; }
	void set_density(double value);
	double get_density() const { return density; }
};

} // namespace undergrowth
