// Starts the add-on with an interface that records its calls of the renderer.

#include "drawing_record.hpp"
#include "record.hpp"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/object.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/godot.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/string_name.hpp>

#include <dlfcn.h>

#include <atomic>
#include <cstring>
#include <string>

using namespace godot;

namespace recorder {

using Arguments = const GDExtensionConstTypePtr *;

GDExtensionInterfaceGetProcAddress get_proc_address = nullptr;
GDExtensionInterfaceClassdbGetMethodBind get_method_bind = nullptr;
GDExtensionInterfaceObjectMethodBindPtrcall ptrcall = nullptr;
GDExtensionInterfaceObjectGetInstanceId get_instance_id = nullptr;

// As the engine passes arguments by pointer.
template <class T> const T &argument(Arguments arguments, int number) {
	return *static_cast<const T *>(arguments[number]);
}

uint64_t rid_of(GDExtensionConstTypePtr pointer) {
	uint64_t id = 0;
	std::memcpy(&id, pointer, sizeof(id));
	return id;
}

std::vector<uint8_t> bytes_of(const Image *image) {
	const PackedByteArray bytes = image ? image->get_data() : PackedByteArray();
	return std::vector<uint8_t>(bytes.ptr(), bytes.ptr() + bytes.size());
}

const Image *image_of(GDExtensionConstTypePtr pointer) {
	const GDExtensionConstObjectPtr object = *static_cast<const GDExtensionConstObjectPtr *>(pointer);
	return Object::cast_to<Image>(ObjectDB::get_instance(get_instance_id(object)));
}

void note_buffer(Arguments arguments, GDExtensionTypePtr) {
	const PackedFloat32Array &buffer = argument<PackedFloat32Array>(arguments, 1);
	const std::lock_guard<std::mutex> lock(record().mutex);
	record().multimeshes[rid_of(arguments[0])].buffer.assign(buffer.ptr(), buffer.ptr() + buffer.size());
}

void note_box(Arguments arguments, GDExtensionTypePtr) {
	const std::lock_guard<std::mutex> lock(record().mutex);
	record().multimeshes[rid_of(arguments[0])].box = argument<AABB>(arguments, 1);
}

void note_mesh(Arguments arguments, GDExtensionTypePtr) {
	const std::lock_guard<std::mutex> lock(record().mutex);
	record().multimeshes[rid_of(arguments[0])].mesh = rid_of(arguments[1]);
}

void note_shown(Arguments arguments, GDExtensionTypePtr) {
	const std::lock_guard<std::mutex> lock(record().mutex);
	record().multimeshes[rid_of(arguments[0])].shown = argument<int64_t>(arguments, 1);
}

void note_instance(Arguments arguments, GDExtensionTypePtr result) {
	const std::lock_guard<std::mutex> lock(record().mutex);
	if (record().multimeshes.count(rid_of(arguments[0])) > 0) {
		Instance &made = record().instances[rid_of(result)];
		made.multimesh = rid_of(arguments[0]);
		made.scenario = rid_of(arguments[1]);
	}
}

template <class Act> void change_instance(Arguments arguments, const Act &act) {
	const std::lock_guard<std::mutex> lock(record().mutex);
	const auto found = record().instances.find(rid_of(arguments[0]));
	if (found != record().instances.end()) {
		act(found->second);
	}
}

void note_visible(Arguments arguments, GDExtensionTypePtr) {
	change_instance(arguments, [=](Instance &instance) { //
		instance.is_visible = argument<GDExtensionBool>(arguments, 1) != 0;
	});
}

void note_scenario(Arguments arguments, GDExtensionTypePtr) {
	change_instance(arguments, [=](Instance &instance) { instance.scenario = rid_of(arguments[1]); });
}

void note_range(Arguments arguments, GDExtensionTypePtr) {
	change_instance(arguments, [=](Instance &instance) {
		instance.begin = argument<double>(arguments, 1);
		instance.end = argument<double>(arguments, 2);
	});
}

void note_flag(Arguments arguments, GDExtensionTypePtr) {
	change_instance(arguments, [=](Instance &instance) {
		const uint32_t bit = 1u << argument<int64_t>(arguments, 1); // Baked light is flag 0, dynamic 1.
		instance.gi_flags =
				argument<GDExtensionBool>(arguments, 2) != 0 ? instance.gi_flags | bit : instance.gi_flags & ~bit;
	});
}

void note_texture(Arguments arguments, GDExtensionTypePtr result) {
	const std::lock_guard<std::mutex> lock(record().mutex);
	record().textures[rid_of(result)] = { bytes_of(image_of(arguments[0])) };
}

void note_layers(Arguments arguments, GDExtensionTypePtr result) {
	const Array &images = argument<Array>(arguments, 0);
	const std::lock_guard<std::mutex> lock(record().mutex);
	std::vector<std::vector<uint8_t>> &layers = record().textures[rid_of(result)];
	layers.clear();
	for (int64_t i = 0; i < images.size(); i++) {
		layers.push_back(bytes_of(Object::cast_to<Image>(images[i])));
	}
}

void note_update(Arguments arguments, GDExtensionTypePtr) {
	const std::lock_guard<std::mutex> lock(record().mutex);
	const auto found = record().textures.find(rid_of(arguments[0]));
	const auto layer = size_t(argument<int64_t>(arguments, 2));
	if (found != record().textures.end() && layer < found->second.size()) {
		found->second[layer] = bytes_of(image_of(arguments[1]));
	}
}

void note_parameter(Arguments arguments, GDExtensionTypePtr) {
	const std::lock_guard<std::mutex> lock(record().mutex);
	record().parameters[String(argument<StringName>(arguments, 1)).utf8().get_data()]++;
}

void note_free(Arguments arguments, GDExtensionTypePtr) {
	const std::lock_guard<std::mutex> lock(record().mutex);
	record().instances.erase(rid_of(arguments[0]));
	record().multimeshes.erase(rid_of(arguments[0]));
	record().textures.erase(rid_of(arguments[0]));
}

struct Recorded {
	const char *method;
	void (*note)(Arguments, GDExtensionTypePtr);
	std::atomic<GDExtensionMethodBindPtr> bind{ nullptr };
};

Recorded all_recorded[] = {
	{ "multimesh_set_buffer", note_buffer },
	{ "multimesh_set_custom_aabb", note_box },
	{ "multimesh_set_mesh", note_mesh },
	{ "multimesh_set_visible_instances", note_shown },
	{ "instance_create2", note_instance },
	{ "instance_set_visible", note_visible },
	{ "instance_set_scenario", note_scenario },
	{ "instance_geometry_set_visibility_range", note_range },
	{ "instance_geometry_set_flag", note_flag },
	{ "texture_2d_create", note_texture },
	{ "texture_2d_layered_create", note_layers },
	{ "texture_2d_update", note_update },
	{ "material_set_param", note_parameter },
	{ "free_rid", note_free },
};

GDExtensionMethodBindPtr find_method(
		GDExtensionConstStringNamePtr type, GDExtensionConstStringNamePtr name, GDExtensionInt hash) {
	const GDExtensionMethodBindPtr bind = get_method_bind(type, name, hash);
	if (*static_cast<const StringName *>(type) == StringName("RenderingServer")) {
		for (Recorded &one : all_recorded) {
			if (*static_cast<const StringName *>(name) == StringName(one.method)) {
				one.bind = bind;
			}
		}
	}
	return bind;
}

void call(GDExtensionMethodBindPtr bind, GDExtensionObjectPtr object, Arguments arguments, GDExtensionTypePtr result) {
	ptrcall(bind, object, arguments, result);
	for (const Recorded &one : all_recorded) {
		if (one.bind.load(std::memory_order_relaxed) == bind) {
			one.note(arguments, result);
			return;
		}
	}
}

GDExtensionInterfaceFunctionPtr find_function(const char *name) {
	const GDExtensionInterfaceFunctionPtr found = get_proc_address(name);
	const std::string wanted = name;
	if (wanted == "classdb_get_method_bind") {
		get_method_bind = reinterpret_cast<GDExtensionInterfaceClassdbGetMethodBind>(found);
		return reinterpret_cast<GDExtensionInterfaceFunctionPtr>(&find_method);
	}
	if (wanted == "object_method_bind_ptrcall") {
		ptrcall = reinterpret_cast<GDExtensionInterfaceObjectMethodBindPtrcall>(found);
		return reinterpret_cast<GDExtensionInterfaceFunctionPtr>(&call);
	}
	return found;
}

void initialize(ModuleInitializationLevel level) {
	if (level == MODULE_INITIALIZATION_LEVEL_SCENE) {
		GDREGISTER_CLASS(DrawingRecord);
	}
}

void terminate(ModuleInitializationLevel) {}

} // namespace recorder

extern "C" GDExtensionBool GDE_EXPORT recorder_init(GDExtensionInterfaceGetProcAddress p_get_proc_address,
		GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) {
	const GDExtensionBinding::InitObject init(p_get_proc_address, p_library, r_initialization);
	init.register_initializer(recorder::initialize);
	init.register_terminator(recorder::terminate);
	init.set_minimum_library_initialization_level(MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}

/// The add-on's entry: loads its library, which lies beside this one, and gives it find_function().
extern "C" GDExtensionBool GDE_EXPORT recorded_init(GDExtensionInterfaceGetProcAddress p_get_proc_address,
		GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) {
	recorder::get_proc_address = p_get_proc_address;
	recorder::get_instance_id =
			reinterpret_cast<GDExtensionInterfaceObjectGetInstanceId>(p_get_proc_address("object_get_instance_id"));
	Dl_info own = {};
	dladdr(reinterpret_cast<const void *>(&recorder_init), &own);
	const std::string path = own.dli_fname;
	void *library = dlopen((path.substr(0, path.rfind('/') + 1) + "librecorded.so").c_str(), RTLD_NOW | RTLD_LOCAL);
	const auto start =
			library ? reinterpret_cast<GDExtensionInitializationFunction>(dlsym(library, "undergrowth_init")) : nullptr;
	return start ? start(&recorder::find_function, p_library, r_initialization) : GDExtensionBool(0);
}
