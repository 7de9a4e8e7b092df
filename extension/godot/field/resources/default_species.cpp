#include "field/resources/default_species.hpp"

#include "base/messages.hpp"
#include "base/new_object.hpp"
#include "species/species_functions.hpp"

#include <godot_cpp/classes/resource_loader.hpp>

using namespace godot;

namespace undergrowth {

static const char *const GRASS_PATH = "res://addons/undergrowth/species/meadow_grass.tres";

Ref<PlantFunction> default_species(const Object *field) {
	ResourceLoader *loader = ResourceLoader::get_singleton();
	Ref<PlantFunction> grass;
	if (loader->exists(GRASS_PATH)) {
		grass = loader->load(GRASS_PATH);
	}
	if (grass.is_null()) {
		report_warning(field,
				String("its species are empty, and ") + GRASS_PATH +
						" is missing, so single blades grow (GrassFunction). Set species, or add that file of the "
						"add-on; an export takes it along where it exports all resources.");
		grass = Ref<PlantFunction>(new_counted<GrassFunction>());
	}
	return grass;
}

} // namespace undergrowth
