#include "wind_shader.hpp"

#include "new_object.hpp"
#include "wind/air_profile.hpp"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/rendering_server.hpp>

#include <cmath>
#include <unordered_set>

using namespace godot;

namespace undergrowth {

// A pointer, as in shared_resources.cpp.
static RID *turbulence = nullptr;

static Ref<Image> picture_of(const AirTiles &tiles) {
	PackedByteArray bytes;
	bytes.resize(int64_t(AirTiles::WIDTH) * AirTiles::HEIGHT * 2 * int64_t(sizeof(float)));
	float *texels = reinterpret_cast<float *>(bytes.ptrw());
	for (int row = 0; row < AirTiles::HEIGHT; row++) {
		for (int column = 0; column < AirTiles::WIDTH; column++) {
			const uint64_t *cells = &tiles.turbulence[size_t(2 * (row * AirTiles::WIDTH + column))];
			*texels++ = float(int16_t(cells[0] & 0xffffu) / AirTiles::UNIT);
			*texels++ = float(int16_t(cells[1] & 0xffffu) / AirTiles::UNIT);
		}
	}
	Ref<Image> image = Image::create_from_data(AirTiles::WIDTH, AirTiles::HEIGHT, false, Image::FORMAT_RGF, bytes);
	image->convert(Image::FORMAT_RGH);
	return image;
}

// Materials that know the texture, bounded; a pointer as above. A texture that is set, the same or not, makes the
// renderer throw a material's uniforms away: in each frame that costs, and keeps frames from being left out.
static std::unordered_set<int64_t> *knowing = nullptr;
static constexpr size_t MOST_KNOWING = 1024;

static void show_turbulence(const AirTiles &tiles, const RID &material) {
	RenderingServer *server = RenderingServer::get_singleton();
	if (!turbulence) {
		turbulence = new RID(server->texture_2d_create(picture_of(tiles)));
		knowing = new std::unordered_set<int64_t>;
	}
	if (knowing->size() >= MOST_KNOWING) {
		knowing->clear();
	}
	if (knowing->insert(material.get_id()).second) {
		server->material_set_param(material, "undergrowth_turbulence", *turbulence);
	}
}

void show_wind(const FieldWind &air, double time, const Ref<Material> &material) {
	RenderingServer *server = RenderingServer::get_singleton();
	const RID target = material->get_rid();
	const AirNow now = air_at_time(air.air, {}, air.tiles.get(), time);
	const PlantWinds along = winds_along(air);
	const AirMap &map = now.turbulence;
	const float gust = now.speed * now.gusts * float(open_ground_gusts(REFERENCE_HEIGHT, double(now.roughness)));
	const float along_gust = gust / std::sqrt(1.0f + 2.0f * now.skew * now.skew);
	show_turbulence(*air.tiles, target);
	const float texel = 1.0f / AirMap::PARTS;
	server->material_set_param(target, "undergrowth_wind_start", texel * Vector2(map.s, map.n));
	server->material_set_param(target, "undergrowth_wind_texels", texel * Vector4(map.s_x, map.n_x, map.s_z, map.n_z));
	server->material_set_param(target, "undergrowth_wind_ways", Vector4(along.x, along.z, along.side_x, along.side_z));
	server->material_set_param(
			target, "undergrowth_wind_air", Vector4(now.speed, along_gust, gust * float(SIDE_GUSTS), now.skew));
	server->material_set_param(target, "undergrowth_wind_roughness", now.roughness);
}

void free_wind_texture() {
	if (turbulence) {
		RenderingServer::get_singleton()->free_rid(*turbulence);
		delete turbulence;
		delete knowing;
		turbulence = nullptr;
		knowing = nullptr;
	}
}

} // namespace undergrowth
