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
				String("the field has no species, and the default file ") + GRASS_PATH +
						" is missing, so GrassFunction grows. Set species, or restore that file; to export it, export "
						"all resources of the project.");
		grass = Ref<PlantFunction>(new_counted<GrassFunction>());
	}
	return grass;
}

} // namespace undergrowth
