#include "wind/wind_shader.hpp"

#include "base/new_object.hpp"
#include "wind/air_profile.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/classes/rendering_server.hpp>

#include <algorithm>
#include <cmath>
#include <unordered_set>

using namespace godot;

namespace undergrowth {

// The maps of turbulence and waves as textures. A pointer, as in shared_resources.cpp.
struct WindTextures {
	RID turbulence;
	RID eddies;
	RID waves;
};
static WindTextures *textures = nullptr;

static float first_of(uint64_t cell) {
	return float(int16_t(cell & 0xffffu) / AirTiles::UNIT);
}

static Ref<Image> picture_of(int width, int height, Image::Format format, Image::Format half, const uint64_t *cells) {
	PackedByteArray bytes;
	const int64_t count = int64_t(width) * height * (format == Image::FORMAT_RGF ? 2 : 1);
	bytes.resize(count * int64_t(sizeof(float)));
	std::transform(cells, cells + count, reinterpret_cast<float *>(bytes.ptrw()), first_of);
	Ref<Image> image = Image::create_from_data(width, height, false, format, bytes);
	image->convert(half);
	return image;
}

static WindTextures make_textures(const AirTiles &tiles) {
	RenderingServer *server = RenderingServer::get_singleton();
	const auto pairs = [&](const std::vector<uint64_t> &cells) {
		return server->texture_2d_create(
				picture_of(AirTiles::WIDTH, AirTiles::HEIGHT, Image::FORMAT_RGF, Image::FORMAT_RGH, cells.data()));
	};
	return { pairs(tiles.turbulence), pairs(tiles.eddies),
		server->texture_2d_create(picture_of(AirTiles::WAVES_WIDTH, AirTiles::WAVES_HEIGHT, Image::FORMAT_RF,
				Image::FORMAT_RH, tiles.waves.data())) };
}

static const WindTextures &shared_textures(const AirTiles &tiles) {
	if (!textures) {
		textures = new WindTextures(make_textures(tiles));
	}
	return *textures;
}

template <class Set> static void set_textures(const WindTextures &to, const Set &set) {
	set("undergrowth_turbulence", to.turbulence);
	set("undergrowth_eddies", to.eddies);
	set("undergrowth_waves", to.waves);
}

template <class Set>
static void set_map(const AirMap &map, const StringName &start, const StringName &texels, const Set &set) {
	constexpr float TEXEL = 1.0f / AirMap::PARTS;
	set(start, TEXEL * Vector2(map.s, map.n));
	set(texels, TEXEL * Vector4(map.s_x, map.n_x, map.s_z, map.n_z));
}

// The rows of a map by the turns of a sine: their number at the world's origin and per metre of x and z, and the
// texels.
static Vector4 sway_of(const AirMap &map) {
	return Vector4(map.turn, map.turn_x, map.turn_z, map.sway / AirMap::PARTS);
}

// Calls `set` with the name and the value of each uniform of undergrowth_wind.gdshaderinc, except the textures.
template <class Set> static void set_wind(const FieldWind &air, double time, const Set &set) {
	const AirSnapshot now = air_at_time(air.air, {}, air.tiles.get(), time);
	const PlantWinds along = winds_along(air);
	const AirMoments canopy = moments_over(now, std::max(air.air.canopy_height, TURF_HEIGHT), along);
	const float gust = now.speed * now.gusts * float(open_ground_gusts(REFERENCE_HEIGHT, double(now.roughness)));
	const float along_gust = gust / std::sqrt(1.0f + 2.0f * now.skew * now.skew);
	const float waves = now.waves.cells ? now.canopy_wave_amount : 0.0f;
	set_map(now.open.turbulence, "undergrowth_wind_start", "undergrowth_wind_texels", set);
	set_map(now.open.eddies, "undergrowth_eddies_start", "undergrowth_eddies_texels", set);
	set_map(now.canopy.turbulence, "undergrowth_canopy_start", "undergrowth_canopy_texels", set);
	set_map(now.canopy.eddies, "undergrowth_canopy_eddies_start", "undergrowth_canopy_eddies_texels", set);
	set_map(now.waves, "undergrowth_waves_start", "undergrowth_waves_texels", set);
	set("undergrowth_wind_sway", sway_of(now.open.turbulence));
	set("undergrowth_canopy_sway", sway_of(now.canopy.turbulence));
	set("undergrowth_waves_bent", now.waves_bent / AirMap::PARTS);
	set("undergrowth_wind_ways", Vector4(along.x, along.z, along.side_x, along.side_z));
	set("undergrowth_wind_air", Vector4(now.speed, along_gust, gust * float(SIDE_GUSTS), now.skew));
	set("undergrowth_canopy_air", Vector4(canopy.mean, canopy.gust, canopy.side_gust, waves));
	set("undergrowth_wind_roughness", now.roughness);
	set("undergrowth_precipitation", Vector2(air.precipitation.wetness, air.precipitation.snow));
}

// Materials that have the textures, up to a limit. A pointer as above. Setting a texture, even the same one, makes the
// renderer rebuild a material's uniforms. In each frame that costs time, and unchanged frames are not skipped.
static std::unordered_set<int64_t> *known_materials = nullptr;
static constexpr size_t MAX_KNOWN_MATERIALS = 1024;

void show_wind(const FieldWind &air, double time, const Ref<Material> &material) {
	const RID target = material->get_rid();
	const auto set = [server = RenderingServer::get_singleton(), target](const StringName &name, const Variant &value) {
		server->material_set_param(target, name, value);
	};
	if (!known_materials) {
		known_materials = new std::unordered_set<int64_t>;
	}
	if (known_materials->size() >= MAX_KNOWN_MATERIALS) {
		known_materials->clear();
	}
	if (known_materials->insert(target.get_id()).second) {
		set_textures(shared_textures(*air.tiles), set);
	}
	set_wind(air, time, set);
}

static bool globals_have_textures = false;

static void set_global(const StringName &name, const Variant &value) {
	RenderingServer::get_singleton()->global_shader_parameter_set(name, value);
}

void show_scene_wind(const FieldWind &air, double time) {
	if (!globals_have_textures) {
		globals_have_textures = true;
		set_textures(shared_textures(*air.tiles), set_global);
	}
	set_wind(air, time, set_global);
}

void calm_scene_wind() {
	set_global("undergrowth_wind_air", Vector4());
	set_global("undergrowth_canopy_air", Vector4());
	set_global("undergrowth_precipitation", Vector2());
}

struct GlobalType {
	RenderingServer::GlobalShaderParameterType type;
	const char *name; // In the settings of a project.
};

static GlobalType type_of(const Variant &value) {
	switch (value.get_type()) {
		case Variant::RID:
			return { RenderingServer::GLOBAL_VAR_TYPE_SAMPLER2D, "sampler2D" };
		case Variant::VECTOR2:
			return { RenderingServer::GLOBAL_VAR_TYPE_VEC2, "vec2" };
		case Variant::VECTOR4:
			return { RenderingServer::GLOBAL_VAR_TYPE_VEC4, "vec4" };
		default:
			return { RenderingServer::GLOBAL_VAR_TYPE_FLOAT, "float" };
	}
}

void add_scene_wind_parameters() {
	ProjectSettings *settings = ProjectSettings::get_singleton();
	bool is_new = false;
	const auto add = [&](const StringName &name, const Variant &value) {
		const String setting = String("shader_globals/") + name;
		if (settings->has_setting(setting)) {
			return; // The engine has added it.
		}
		const GlobalType type = type_of(value);
		RenderingServer::get_singleton()->global_shader_parameter_add(name, type.type, value);
		Dictionary stored;
		stored["type"] = type.name;
		stored["value"] = value.get_type() == Variant::RID ? Variant("") : value;
		settings->set_setting(setting, stored);
		is_new = true;
	};
	FieldWind calm;
	calm.wind.kind = WindKind::air;
	set_textures({}, add);
	set_wind(calm, 0.0, add);
	if (is_new && Engine::get_singleton()->is_editor_hint()) {
		settings->save();
	}
}

void free_wind_textures() {
	if (textures) {
		for (const RID &texture : { textures->turbulence, textures->eddies, textures->waves }) {
			RenderingServer::get_singleton()->free_rid(texture);
		}
		delete textures;
		textures = nullptr;
	}
	delete known_materials;
	known_materials = nullptr;
	if (globals_have_textures && Engine::get_singleton()->get_main_loop()) { // A reload of the library.
		set_textures({}, set_global);
	}
	globals_have_textures = false;
}

} // namespace undergrowth
