#include "shared_resources.hpp"

#include "new_object.hpp"

#include <godot_cpp/classes/resource_loader.hpp>

#include <mutex>
#include <utility>

using namespace godot;

namespace undergrowth {

// Pointers: no reference may be made before the engine's interface is loaded or die after it is gone.
static Ref<StandardMaterial3D> *material = nullptr;
static Ref<ShaderMaterial> *of_sheets = nullptr;
static Ref<Skin> *skin = nullptr;
static Ref<Shader> *shaders[2] = { nullptr, nullptr }; // Of lathes and of parts.
static std::mutex making; // Meshes may be generated on several threads.

static const char *const SHADER_PATHS[2] = { "res://addons/undergrowth/shaders/plant_field.gdshader",
	"res://addons/undergrowth/shaders/plant_parts.gdshader" };

static Ref<StandardMaterial3D> make_material() {
	Ref<StandardMaterial3D> made = new_counted<StandardMaterial3D>();
	made->set_name("Undergrowth plant");
	made->set_flag(BaseMaterial3D::FLAG_ALBEDO_FROM_VERTEX_COLOR, true);
	made->set_flag(BaseMaterial3D::FLAG_SRGB_VERTEX_COLOR, true);
	made->set_diffuse_mode(BaseMaterial3D::DIFFUSE_LAMBERT);
	made->set_roughness(0.75f);
	made->set_specular(0.25f);
	made->set_feature(BaseMaterial3D::FEATURE_BACKLIGHT, true);
	made->set_backlight(Color(0.18f, 0.2f, 0.1f));
	return made;
}

static Ref<Skin> make_skin() {
	Ref<Skin> made = new_counted<Skin>();
	made->add_bind(0, Transform3D());
	made->add_bind(1, Transform3D());
	return made;
}

Ref<StandardMaterial3D> default_material() {
	const std::lock_guard<std::mutex> lock(making);
	if (!material) {
		material = new Ref<StandardMaterial3D>(make_material());
	}
	return *material;
}

// A thread of the pool that loads something works on other tasks until that is there, and those may ask for the same:
// so nothing is loaded under the lock.
Ref<Shader> plant_shader(bool of_parts) {
	Ref<Shader> *&kept = shaders[int(of_parts)];
	{
		const std::lock_guard<std::mutex> lock(making);
		if (kept && kept->is_valid()) {
			return *kept;
		}
	}
	const Ref<Shader> loaded = ResourceLoader::get_singleton()->load(SHADER_PATHS[int(of_parts)], "Shader");
	const std::lock_guard<std::mutex> lock(making);
	delete kept;
	kept = new Ref<Shader>(loaded);
	return loaded;
}

Ref<ShaderMaterial> parts_material() {
	const Ref<Shader> shader = plant_shader(true);
	const std::lock_guard<std::mutex> lock(making);
	if (!of_sheets) {
		Ref<ShaderMaterial> made = new_counted<ShaderMaterial>();
		made->set_name("Undergrowth plant of parts");
		made->set_shader(shader);
		of_sheets = new Ref<ShaderMaterial>(made);
	}
	return *of_sheets;
}

Ref<Skin> plant_skin() {
	const std::lock_guard<std::mutex> lock(making);
	if (!skin) {
		skin = new Ref<Skin>(make_skin());
	}
	return *skin;
}

void free_shared_resources() {
	const std::lock_guard<std::mutex> lock(making);
	delete material;
	delete of_sheets;
	delete skin;
	for (Ref<Shader> *&kept : shaders) {
		delete std::exchange(kept, nullptr);
	}
	material = nullptr;
	of_sheets = nullptr;
	skin = nullptr;
}

} // namespace undergrowth
