#include "field/resources/plant_habitat.hpp"

#include "base/bind_properties.hpp"
#include "base/follow_changes.hpp"
#include "base/messages.hpp"
#include "base/new_object.hpp"
#include "conventions.hpp"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

#include <algorithm>

using namespace godot;

namespace undergrowth {

static constexpr int CURVE_VALUES = 1025;
static constexpr int MAX_PIXELS = 2048; // Along a side of the texture.
static constexpr int CHANNELS = 4;
static constexpr Range SIZE_RANGE = { 0.01, 1e5 };
static constexpr Range OFFSET_RANGE = { -1e5, 1e5 };
static constexpr double MIN_DOMAIN = 0.01; // Of the engine's curves.

// The domain of a new curve of each factor, in the units that users see.
static constexpr Range DOMAINS[HABITAT_FACTORS] = { { 0.0, 90.0 }, { 0.0, 100.0 }, { 0.0, 1.0 }, { 0.0, 1.0 },
	{ 0.0, 1.0 }, { 0.0, 10.0 }, { 0.0, 1.0 } };

// The engine accepts only ends in the right order.
static void set_domain(Curve *curve, double low, double high) {
	if (low < double(curve->get_max_domain())) {
		curve->set_min_domain(float(low));
		curve->set_max_domain(float(high));
	} else {
		curve->set_max_domain(float(high));
		curve->set_min_domain(float(low));
	}
}

// As the engine's particle materials do with new curves: a curve without points gets the domain of its factor, and is 1
// everywhere.
static void set_up_new(Curve *curve, const Range &domain) {
	const bool is_new =
			curve->get_point_count() == 0 && curve->get_min_domain() == 0.0f && curve->get_max_domain() == 1.0f;
	if (is_new) {
		set_domain(curve, domain.min, domain.max);
		curve->add_point(Vector2(float(domain.min), 1.0f));
		curve->add_point(Vector2(float(domain.max), 1.0f));
	}
}

Ref<Curve> PlantHabitat::make_curve(const PackedVector2Array &points) {
	bool is_sound = points.size() >= 2;
	for (int64_t i = 0; i < points.size() && is_sound; i++) {
		is_sound = points[i].is_finite() && points[i].y >= 0.0f && points[i].y <= 1.0f &&
				(i == 0 || points[i].x > points[i - 1].x);
	}
	if (!is_sound || double(points[points.size() - 1].x) - double(points[0].x) <= MIN_DOMAIN) {
		UtilityFunctions::push_error("PlantHabitat.make_curve() needs two or more points (x, suitability) with rising "
									 "x, more than 0.01 from "
									 "the first to the last, and suitabilities from 0 to 1.");
		return Ref<Curve>();
	}
	Ref<Curve> curve = new_counted<Curve>();
	set_domain(curve.ptr(), double(points[0].x), double(points[points.size() - 1].x));
	for (const Vector2 &point : points) {
		curve->add_point(point, 0.0f, 0.0f, Curve::TANGENT_LINEAR, Curve::TANGENT_LINEAR);
	}
	return curve;
}

void PlantHabitat::on_part_changed() {
	core.reset();
	emit_changed();
}

void PlantHabitat::follow_curve(HabitatFactor factor, const Ref<Curve> &curve) {
	Ref<Curve> &slot = curves[size_t(factor)];
	if (curve == slot) {
		return;
	}
	const Callable changed(this, "_on_part_changed");
	const Ref<Curve> before = slot;
	slot = curve;
	if (std::find(curves.begin(), curves.end(), before) == curves.end()) {
		unfollow_changes(before.ptr(), changed);
	}
	if (curve.is_valid()) {
		set_up_new(curve.ptr(), DOMAINS[size_t(factor)]);
	}
	follow_changes(curve.ptr(), changed);
	on_part_changed();
}

void PlantHabitat::set_texture(const Ref<Texture2D> &image) {
	if (image == texture) {
		return;
	}
	const Callable changed(this, "_on_part_changed");
	unfollow_changes(texture.ptr(), changed);
	texture = image;
	follow_changes(texture.ptr(), changed);
	on_part_changed();
}

void PlantHabitat::set_texture_size(const Vector2 &metres) {
	if (accept_value(this, "texture_size", metres.x, SIZE_RANGE) &&
			accept_value(this, "texture_size", metres.y, SIZE_RANGE) && metres != texture_size) {
		texture_size = metres;
		on_part_changed();
	}
}

void PlantHabitat::set_texture_offset(const Vector2 &metres) {
	if (accept_value(this, "texture_offset", metres.x, OFFSET_RANGE) &&
			accept_value(this, "texture_offset", metres.y, OFFSET_RANGE) && metres != texture_offset) {
		texture_offset = metres;
		on_part_changed();
	}
}

void PlantHabitat::set_texture_channel(TextureChannel channel) {
	if (accept_value(this, "texture_channel", double(channel), { CHANNEL_RED, CHANNEL_ALPHA }) &&
			channel != texture_channel) {
		texture_channel = channel;
		on_part_changed();
	}
}

void PlantHabitat::set_texture_repeat(bool on) {
	if (on != texture_repeat) {
		texture_repeat = on;
		on_part_changed();
	}
}

void PlantHabitat::set_distance_group(const StringName &group) {
	if (group != distance_group) {
		distance_group = group;
		on_part_changed();
	}
}

void PlantHabitat::set_value_method(const StringName &method) {
	if (method != value_method) {
		value_method = method;
		on_part_changed();
	}
}

void PlantHabitat::set_value_group(const StringName &group) {
	if (group != value_group) {
		value_group = group;
		on_part_changed();
	}
}

void PlantHabitat::set_value_channel(TextureChannel channel) {
	if (accept_value(this, "value_channel", double(channel), { CHANNEL_RED, CHANNEL_ALPHA }) &&
			channel != value_channel) {
		value_channel = channel;
		on_part_changed();
	}
}

bool PlantHabitat::uses(HabitatFactor factor) const {
	if (factor == HabitatFactor::texture) {
		return texture.is_valid();
	}
	return curves[size_t(factor)].is_valid() && (factor != HabitatFactor::distance || !distance_group.is_empty()) &&
			(factor != HabitatFactor::value || !value_method.is_empty());
}

HabitatCurve PlantHabitat::read_curve(HabitatFactor factor) const {
	const Ref<Curve> &curve = curves[size_t(factor)];
	HabitatCurve read;
	if (curve.is_null() || curve->get_point_count() == 0) {
		return read;
	}
	const double low = double(curve->get_min_domain());
	const double high = double(curve->get_max_domain());
	const double unit = factor == HabitatFactor::slope ? PI / 180.0 : 1.0;
	read.low = float(low * unit);
	read.high = float(high * unit);
	for (int i = 0; i < CURVE_VALUES; i++) {
		const double x = low + (high - low) * i / (CURVE_VALUES - 1);
		read.values.push_back(std::clamp(curve->sample(float(x)), 0.0f, 1.0f));
	}
	return read;
}

// A noise texture has no image until it is generated, and reports that as a change.
void PlantHabitat::read_texture(Habitat &into) const {
	const Ref<Image> image = texture.is_valid() ? texture->get_image() : Ref<Image>();
	if (image.is_null() || image->is_empty()) {
		return;
	}
	Ref<Image> read = image->duplicate();
	if (read->is_compressed() && read->decompress() != OK) {
		report_error(this,
				"cannot read its texture, whose compression cannot be undone. Import it with another Compress Mode.");
		return;
	}
	if (read->has_mipmaps()) {
		read->clear_mipmaps();
	}
	if (read->get_width() > MAX_PIXELS || read->get_height() > MAX_PIXELS) {
		read->resize(std::min(read->get_width(), MAX_PIXELS), std::min(read->get_height(), MAX_PIXELS),
				Image::INTERPOLATE_BILINEAR);
	}
	read->convert(Image::FORMAT_RGBAF);
	const PackedByteArray bytes = read->get_data();
	const float *pixels = reinterpret_cast<const float *>(bytes.ptr());
	HabitatRaster &raster = into.texture;
	raster.columns = read->get_width();
	raster.rows = read->get_height();
	raster.cell = { texture_size.x / float(raster.columns), texture_size.y / float(raster.rows) };
	raster.low = { texture_offset.x - 0.5f * texture_size.x, texture_offset.y - 0.5f * texture_size.y };
	raster.repeats = texture_repeat;
	raster.values.resize(size_t(raster.columns) * size_t(raster.rows));
	for (size_t i = 0; i < raster.values.size(); i++) {
		raster.values[i] = pixels[i * CHANNELS + size_t(texture_channel)];
	}
	HabitatCurve &curve = into.curve(HabitatFactor::texture);
	curve = read_curve(HabitatFactor::texture);
	if (!curve.is_set()) {
		curve.values = { 0.0f, 1.0f };
	}
}

std::shared_ptr<const Habitat> PlantHabitat::share() const {
	if (!core) {
		auto read = std::make_shared<Habitat>();
		for (size_t i = 0; i < HABITAT_FACTORS; i++) {
			if (uses(HabitatFactor(i)) && HabitatFactor(i) != HabitatFactor::texture) {
				read->curves[i] = read_curve(HabitatFactor(i));
			}
		}
		read_texture(*read);
		core = read;
	}
	return core;
}

// A property with a curve over the factor `m_factor`.
#define CURVE(m_name, m_factor)                                                                                        \
	BIND_PROPERTY(OBJECT, m_name, "get_" #m_name, &self_type::set_curve<HabitatFactor::m_factor>,                      \
			&self_type::get_curve<HabitatFactor::m_factor>, PROPERTY_HINT_RESOURCE_TYPE, "Curve")

void PlantHabitat::_bind_methods() {
	ClassDB::bind_static_method("PlantHabitat", D_METHOD("make_curve", "points"), &PlantHabitat::make_curve);
	ClassDB::bind_method(D_METHOD("_on_part_changed"), &PlantHabitat::on_part_changed);
	CURVE(slope_curve, slope);
	CURVE(height_curve, height);
	CURVE(moisture_curve, moisture);
	CURVE(light_curve, light);
	ADD_GROUP("Texture", "texture_");
	PROPERTY(OBJECT, texture, PROPERTY_HINT_RESOURCE_TYPE, "Texture2D");
	CURVE(texture_curve, texture);
	PROPERTY(VECTOR2, texture_size, PROPERTY_HINT_NONE, "suffix:m");
	PROPERTY(VECTOR2, texture_offset, PROPERTY_HINT_NONE, "suffix:m");
	PROPERTY(INT, texture_channel, PROPERTY_HINT_ENUM, "Red,Green,Blue,Alpha");
	BIND_PROPERTY(
			BOOL, texture_repeat, "is_texture_repeat", &self_type::set_texture_repeat, &self_type::is_texture_repeat);
	ADD_GROUP("Distance", "distance_");
	CURVE(distance_curve, distance);
	PROPERTY(STRING_NAME, distance_group);
	ADD_GROUP("Value", "value_");
	CURVE(value_curve, value);
	PROPERTY(STRING_NAME, value_method);
	PROPERTY(STRING_NAME, value_group);
	PROPERTY(INT, value_channel, PROPERTY_HINT_ENUM, "X or Red,Y or Green,Z or Blue,Alpha");
	BIND_ENUM_CONSTANT(CHANNEL_RED);
	BIND_ENUM_CONSTANT(CHANNEL_GREEN);
	BIND_ENUM_CONSTANT(CHANNEL_BLUE);
	BIND_ENUM_CONSTANT(CHANNEL_ALPHA);
}

} // namespace undergrowth
