#pragma once

#include "placement/habitat.hpp"

#include <godot_cpp/classes/curve.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/classes/texture2d.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/vector2.hpp>

#include <memory>

namespace undergrowth {

/// Where a species of a field grows: curves over slope, height and other factors of the ground. Emits `changed` for
/// each change of a property, of a curve, and of the texture.
class PlantHabitat : public godot::Resource {
	GDCLASS(PlantHabitat, godot::Resource)

public:
	enum TextureChannel : int64_t {
		CHANNEL_RED,
		CHANNEL_GREEN,
		CHANNEL_BLUE,
		CHANNEL_ALPHA,
	};

private:
	std::array<godot::Ref<godot::Curve>, HABITAT_FACTORS> curves;
	godot::Ref<godot::Texture2D> texture;
	godot::Vector2 texture_size = { 20.0f, 20.0f }; // m.
	godot::Vector2 texture_offset; // m.
	TextureChannel texture_channel = CHANNEL_RED;
	bool texture_repeat = true;
	godot::StringName distance_group;
	godot::StringName value_method;
	godot::StringName value_group;
	TextureChannel value_channel = CHANNEL_RED;
	mutable std::shared_ptr<const Habitat> core; // Null: not read since the last change.

	template <HabitatFactor factor> void set_curve(const godot::Ref<godot::Curve> &curve) {
		follow_curve(factor, curve);
	}
	template <HabitatFactor factor> godot::Ref<godot::Curve> get_curve() const { return curves[size_t(factor)]; }
	void follow_curve(HabitatFactor factor, const godot::Ref<godot::Curve> &curve);
	HabitatCurve read_curve(HabitatFactor factor) const;
	void read_texture(Habitat &into) const;

protected:
	static void _bind_methods();

public:
	/// Returns a curve of straight lines through points (x, suitability), with their domain.
	static godot::Ref<godot::Curve> make_curve(const godot::PackedVector2Array &points);
	/// The habitat for builds. Main thread.
	std::shared_ptr<const Habitat> share() const;
	bool uses(HabitatFactor factor) const;
	// Called by the engine.
	void on_part_changed();

	void set_texture(const godot::Ref<godot::Texture2D> &image);
	godot::Ref<godot::Texture2D> get_texture() const { return texture; }
	void set_texture_size(const godot::Vector2 &metres);
	godot::Vector2 get_texture_size() const { return texture_size; }
	void set_texture_offset(const godot::Vector2 &metres);
	godot::Vector2 get_texture_offset() const { return texture_offset; }
	void set_texture_channel(TextureChannel channel);
	TextureChannel get_texture_channel() const { return texture_channel; }
	void set_texture_repeat(bool on);
	bool is_texture_repeat() const { return texture_repeat; }
	void set_value_method(const godot::StringName &method);
	godot::StringName get_value_method() const { return value_method; }
	void set_value_group(const godot::StringName &group);
	godot::StringName get_value_group() const { return value_group; }
	void set_value_channel(TextureChannel channel);
	TextureChannel get_value_channel() const { return value_channel; }
	void set_distance_group(const godot::StringName &group);
	godot::StringName get_distance_group() const { return distance_group; }
};

} // namespace undergrowth

VARIANT_ENUM_CAST(undergrowth::PlantHabitat::TextureChannel);
