// Entry of the library: registers and unregisters its classes.

#include "base/deferred_error.hpp"
#include "base/doc_data.hpp"
#include "base/renamed_properties.hpp"
#include "field/motion/step_batch.hpp"
#include "field/resources/plant_field_level.hpp"
#include "field/resources/plant_field_species.hpp"
#include "field/resources/plant_habitat.hpp"
#include "field/resources/plant_map.hpp"
#include "form/plant_growth.hpp"
#include "form/plant_part_kinds.hpp"
#include "model/model_material.hpp"
#include "nodes/plant_3d.hpp"
#include "nodes/plant_climber_3d.hpp"
#include "nodes/plant_field_3d.hpp"
#include "nodes/plant_wind_source_3d.hpp"
#include "plants/plant_simulation.hpp"
#include "species/curve_plant_function.hpp"
#include "species/mesh_plant_function.hpp"
#include "species/shared_resources.hpp"
#include "species/species_functions.hpp"
#include "wind/plant_wind.hpp"
#include "wind/wind_shader.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/defs.hpp>
#include <godot_cpp/godot.hpp>

using namespace godot;

namespace undergrowth {

static const char *const SIMULATION_NAME = "PlantSimulation";
static GDExtensionInterfaceGetProcAddress engine_function = nullptr;

// Uses the engine's interface directly, which is the same with any binding.
static void load_class_help() {
	using LoadHelp = void (*)(const char *, GDExtensionInt); // Its name differs between versions of the header.
	const auto load = reinterpret_cast<LoadHelp>(engine_function("editor_help_load_xml_from_utf8_chars_and_len"));
	if (load) {
		load(undergrowth_doc_xml, GDExtensionInt(undergrowth_doc_xml_size));
	}
}

static void register_classes() {
	GDREGISTER_INTERNAL_CLASS(DeferredError);
	GDREGISTER_INTERNAL_CLASS(OldNameWarning);
	GDREGISTER_ABSTRACT_CLASS(PlantPart);
	GDREGISTER_CLASS(PlantAxis);
	GDREGISTER_CLASS(PlantBlade);
	GDREGISTER_CLASS(PlantBead);
	GDREGISTER_CLASS(PlantArrangement);
	GDREGISTER_CLASS(PlantGrowth);
	GDREGISTER_CLASS(PlantStem);
	GDREGISTER_CLASS(PlantFunction);
	GDREGISTER_CLASS(GrassFunction);
	GDREGISTER_CLASS(ReedFunction);
	GDREGISTER_CLASS(CattailFunction);
	GDREGISTER_CLASS(TulipFunction);
	GDREGISTER_CLASS(BellflowerFunction);
	GDREGISTER_CLASS(CurvePlantFunction);
	GDREGISTER_CLASS(MeshPlantFunction);
	GDREGISTER_CLASS(PlantWind);
	GDREGISTER_CLASS(PlantWindSource3D);
	GDREGISTER_CLASS(Plant3D);
	GDREGISTER_CLASS(PlantClimber3D);
	GDREGISTER_CLASS(PlantHabitat);
	GDREGISTER_CLASS(PlantFieldSpecies);
	GDREGISTER_CLASS(PlantFieldLevel);
	GDREGISTER_CLASS(PlantMap);
	GDREGISTER_CLASS(PlantField3D);
	GDREGISTER_ABSTRACT_CLASS(PlantSimulation);
}

static void initialize(ModuleInitializationLevel level) {
	if (level == MODULE_INITIALIZATION_LEVEL_SCENE) {
		register_classes();
		Engine::get_singleton()->register_singleton(SIMULATION_NAME, memnew(PlantSimulation));
	} else if (level == MODULE_INITIALIZATION_LEVEL_EDITOR) {
		load_class_help();
	}
}

static void uninitialize(ModuleInitializationLevel level) {
	if (level == MODULE_INITIALIZATION_LEVEL_SCENE) {
		StepBatch::end_all();
		Engine::get_singleton()->unregister_singleton(SIMULATION_NAME);
		memdelete(PlantSimulation::get_singleton());
		free_shared_resources();
		free_model_shaders();
		free_wind_textures();
	}
}

} // namespace undergrowth

extern "C" GDExtensionBool GDE_EXPORT undergrowth_init(GDExtensionInterfaceGetProcAddress get_proc_address,
		GDExtensionClassLibraryPtr library, GDExtensionInitialization *initialization) {
	undergrowth::engine_function = get_proc_address;
	GDExtensionBinding::InitObject init(get_proc_address, library, initialization);
	init.register_initializer(undergrowth::initialize);
	init.register_terminator(undergrowth::uninitialize);
	init.set_minimum_library_initialization_level(MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
