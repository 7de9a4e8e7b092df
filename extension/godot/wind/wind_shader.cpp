#include "wind/wind_shader.hpp"

#include "base/new_object.hpp"
#include "wind/air_profile.hpp"

#include <godot_cpp/classes/image.hpp>
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

// Materials that have the textures, up to a limit. A pointer as above. Setting a texture, even the same one, makes the
// renderer rebuild a material's uniforms. In each frame that costs time, and unchanged frames are not skipped.
static std::unordered_set<int64_t> *known_materials = nullptr;
static constexpr size_t MAX_KNOWN_MATERIALS = 1024;

static void show_textures(const AirTiles &tiles, const RID &material) {
	RenderingServer *server = RenderingServer::get_singleton();
	if (!textures) {
		textures = new WindTextures(make_textures(tiles));
		known_materials = new std::unordered_set<int64_t>;
	}
	if (known_materials->size() >= MAX_KNOWN_MATERIALS) {
		known_materials->clear();
	}
	if (known_materials->insert(material.get_id()).second) {
		server->material_set_param(material, "undergrowth_turbulence", textures->turbulence);
		server->material_set_param(material, "undergrowth_eddies", textures->eddies);
		server->material_set_param(material, "undergrowth_waves", textures->waves);
	}
}

static void show_map(const AirMap &map, const RID &material, const StringName &start, const StringName &texels) {
	constexpr float TEXEL = 1.0f / AirMap::PARTS;
	RenderingServer *server = RenderingServer::get_singleton();
	server->material_set_param(material, start, TEXEL * Vector2(map.s, map.n));
	server->material_set_param(material, texels, TEXEL * Vector4(map.s_x, map.n_x, map.s_z, map.n_z));
}

// The rows of a map by the turns of a sine: their number at the world's origin and per metre of x and z, and the
// texels.
static void show_sway(const AirMap &map, const RID &material, const StringName &name) {
	RenderingServer::get_singleton()->material_set_param(
			material, name, Vector4(map.turn, map.turn_x, map.turn_z, map.sway / AirMap::PARTS));
}

void show_wind(const FieldWind &air, double time, const Ref<Material> &material) {
	RenderingServer *server = RenderingServer::get_singleton();
	const RID target = material->get_rid();
	const AirSnapshot now = air_at_time(air.air, {}, air.tiles.get(), time);
	const PlantWinds along = winds_along(air);
	const AirMoments canopy = moments_over(now, std::max(air.air.canopy_height, TURF_HEIGHT), along);
	const float gust = now.speed * now.gusts * float(open_ground_gusts(REFERENCE_HEIGHT, double(now.roughness)));
	const float along_gust = gust / std::sqrt(1.0f + 2.0f * now.skew * now.skew);
	const float waves = now.waves.cells ? now.canopy_wave_amount : 0.0f;
	show_textures(*air.tiles, target);
	show_map(now.open.turbulence, target, "undergrowth_wind_start", "undergrowth_wind_texels");
	show_map(now.open.eddies, target, "undergrowth_eddies_start", "undergrowth_eddies_texels");
	show_map(now.canopy.turbulence, target, "undergrowth_canopy_start", "undergrowth_canopy_texels");
	show_map(now.canopy.eddies, target, "undergrowth_canopy_eddies_start", "undergrowth_canopy_eddies_texels");
	show_map(now.waves, target, "undergrowth_waves_start", "undergrowth_waves_texels");
	show_sway(now.open.turbulence, target, "undergrowth_wind_sway");
	show_sway(now.canopy.turbulence, target, "undergrowth_canopy_sway");
	server->material_set_param(target, "undergrowth_waves_bent", now.waves_bent / AirMap::PARTS);
	server->material_set_param(target, "undergrowth_wind_ways", Vector4(along.x, along.z, along.side_x, along.side_z));
	server->material_set_param(
			target, "undergrowth_wind_air", Vector4(now.speed, along_gust, gust * float(SIDE_GUSTS), now.skew));
	server->material_set_param(
			target, "undergrowth_canopy_air", Vector4(canopy.mean, canopy.gust, canopy.side_gust, waves));
	server->material_set_param(target, "undergrowth_wind_roughness", now.roughness);
	server->material_set_param(
			target, "undergrowth_precipitation", Vector2(air.precipitation.wetness, air.precipitation.snow));
}

void free_wind_textures() {
	if (textures) {
		for (const RID &texture : { textures->turbulence, textures->eddies, textures->waves }) {
			RenderingServer::get_singleton()->free_rid(texture);
		}
		delete textures;
		delete known_materials;
		textures = nullptr;
		known_materials = nullptr;
	}
}

} // namespace undergrowth
