#include "field/field_problems.hpp"

#include "base/messages.hpp"
#include "field/build/field_habitats.hpp"
#include "field/view/listed_styles.hpp"

#include <utility>

using namespace godot;

namespace undergrowth {

void FieldProblems::report(const String &what) {
	if (what != fault) { // Reports a fault once, even if every build finds it again.
		fault = what;
		if (has_fault()) {
			report_error(node, fault);
		}
		node->update_configuration_warnings();
	}
}

void FieldProblems::advise(const String &what) {
	if (std::exchange(no_ground, what) != what) {
		node->update_configuration_warnings();
	}
}

void FieldProblems::advise_on_place(const String &what) {
	if (std::exchange(off_ground, what) != what) {
		node->update_configuration_warnings();
	}
}

void FieldProblems::report_motion(FieldMotion &motion) {
	if (motion.is_crowded() && !std::exchange(has_reported_crowd, true)) {
		report_warning(node,
				"some contacts between plants are skipped, because too many tips are close together. Reduce "
				"collision_radius in its species, or the density.");
	}
	for (const String &warning : motion.bodies.take_warnings()) {
		report_warning(node, warning);
	}
}

PackedStringArray FieldProblems::warnings() const {
	PackedStringArray texts;
	for (const String &one : { fault, no_ground, off_ground }) {
		if (!one.is_empty()) {
			texts.push_back(one);
		}
	}
	if (properties.prototypes > 0 && properties.contact_enabled) {
		texts.push_back("Plants that follow Prototypes do not touch each other: set Prototypes to 0, or disable "
						"Contact Enabled.");
	}
	for (const String &name : forgotten_layers(properties)) {
		texts.push_back("'" + name +
				"' is painted on the map, but no species has that name: rename one, or set the Layer of its entry.");
	}
	texts.append_array(find_habitat_warnings(node, properties));
	if (properties.wind.is_valid() && properties.wind->get_strength() == 0.0) {
		texts.push_back(
				"The wind has a strength of 0 N, so these plants do not move: increase Strength of their Wind.");
	}
	return texts;
}

} // namespace undergrowth
