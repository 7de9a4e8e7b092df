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
	double share = 1.0;
	godot::String given_name;

	void level_changed();

protected:
	static void _bind_methods();
	void _validate_property(godot::PropertyInfo &property) const;

public:
	/// Returns a level with `segments` up to `end` metres (0: no end). At its end, a `share` of the plants remains.
	static godot::Ref<PlantFieldLevel> of(int segments, double end = 0.0, double share = 1.0);

	void set_segments(int count);
	int get_segments() const { return segments; }
	void set_end(double metres);
	double get_end() const { return end; }
	void set_share(double kept);
	double get_share() const { return share; }
};

} // namespace undergrowth
