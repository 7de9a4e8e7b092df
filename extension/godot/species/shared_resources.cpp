#include "species/shared_resources.hpp"

#include "base/new_object.hpp"
#include "plants/plant_simulation.hpp"

#include <godot_cpp/classes/os.hpp>
#include <godot_cpp/classes/resource_loader.hpp>

#include <mutex>
#include <utility>

using namespace godot;

namespace undergrowth {

// Pointers, because references cannot exist before the engine's interface is loaded or after it is unloaded.
static Ref<StandardMaterial3D> *material = nullptr;
static Ref<ShaderMaterial> *of_sheets = nullptr;
static Ref<Skin> *skin = nullptr;
// For lathes, parts, in fields: parts without cards, parts with cards, and shadows; for climbers; and in fields: parts
// with orders of branches, without cards and with them.
static constexpr int SHADERS = 8;
static Ref<Shader> *shaders[SHADERS] = {};
static bool parts_have_shader = false;
static std::mutex making; // Meshes may be generated on several threads.

static const char *const SHADER_PATHS[SHADERS] = { "res://addons/undergrowth/shaders/plant_field.gdshader",
	"res://addons/undergrowth/shaders/plant_parts.gdshader", "res://addons/undergrowth/shaders/plant_solids.gdshader",
	"res://addons/undergrowth/shaders/plant_cards.gdshader", "res://addons/undergrowth/shaders/plant_shadows.gdshader",
	"res://addons/undergrowth/shaders/plant_climber.gdshader", "res://addons/undergrowth/shaders/plant_orders.gdshader",
	"res://addons/undergrowth/shaders/plant_order_cards.gdshader" };

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

// A pool thread that loads a resource runs other tasks meanwhile. These may request the same resource, so nothing is
// loaded under the lock.
static Ref<Shader> load_shader(int kind) {
	Ref<Shader> *&shader = shaders[kind];
	{
		const std::lock_guard<std::mutex> lock(making);
		if (shader && shader->is_valid()) {
			return *shader;
		}
	}
	const Ref<Shader> loaded = ResourceLoader::get_singleton()->load(SHADER_PATHS[kind], "Shader");
	const std::lock_guard<std::mutex> lock(making);
	delete shader;
	shader = new Ref<Shader>(loaded);
	return loaded;
}

static bool is_loaded(int kind) {
	const std::lock_guard<std::mutex> lock(making);
	return shaders[kind] && shaders[kind]->is_valid();
}

bool load_next_field_shader(bool of_parts, bool with_cards, bool with_orders) {
	const bool needed[SHADERS] = { !of_parts, of_parts, of_parts, with_cards, of_parts, false, with_orders,
		with_cards && with_orders };
	for (int kind = 0; kind < SHADERS; kind++) {
		if (needed[kind] && !is_loaded(kind)) {
			return load_shader(kind).is_valid();
		}
	}
	return false;
}

Ref<Shader> plant_shader(bool of_parts) {
	return load_shader(int(of_parts));
}

Ref<Shader> solids_shader() {
	return load_shader(2);
}

Ref<Shader> cards_shader() {
	return load_shader(3);
}

Ref<Shader> shadows_shader() {
	return load_shader(4);
}

Ref<Shader> climber_shader() {
	return load_shader(5);
}

Ref<Shader> orders_shader() {
	return load_shader(6);
}

Ref<Shader> orders_with_cards_shader() {
	return load_shader(7);
}

static bool is_main_thread() {
	const OS *system = OS::get_singleton();
	return system->get_thread_caller_id() == system->get_main_thread_id();
}

// A thread that loads a shader waits for the main thread, which may wait for that thread. So the main thread loads it,
// at the end of the frame.
Ref<ShaderMaterial> parts_material() {
	const bool loads = is_main_thread();
	const Ref<Shader> shader = loads ? plant_shader(true) : Ref<Shader>();
	const std::lock_guard<std::mutex> lock(making);
	if (!of_sheets) {
		Ref<ShaderMaterial> made = new_counted<ShaderMaterial>();
		made->set_name("Undergrowth plant of parts");
		of_sheets = new Ref<ShaderMaterial>(made);
	}
	if (!parts_have_shader && loads) {
		(*of_sheets)->set_shader(shader);
		parts_have_shader = true;
	} else if (!parts_have_shader) {
		PlantSimulation::get_singleton()->call_deferred("_load_parts_shader");
	}
	return *of_sheets;
}

void load_parts_shader() {
	if (is_main_thread()) { // Threads that load resources have deferred calls of their own.
		parts_material();
	}
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
	for (Ref<Shader> *&shader : shaders) {
		delete std::exchange(shader, nullptr);
	}
	material = nullptr;
	of_sheets = nullptr;
	parts_have_shader = false;
	skin = nullptr;
}

} // namespace undergrowth
