// What a species says of its stem, and what that comes to.

#include "plant_function.hpp"

#include "follow_changes.hpp"
#include "messages.hpp"

using namespace godot;

namespace undergrowth {

static constexpr int STEM_SEGMENTS = 12; // How finely a lathe says where it is thick.

void PlantFunction::set_stem(const Ref<PlantStem> &new_stem) {
	if (new_stem != stem) {
		const Callable listener(this, "_on_stem_changed");
		unfollow_changes(stem.ptr(), listener);
		stem = new_stem;
		follow_changes(stem.ptr(), listener);
		on_stem_changed();
	}
}

void PlantFunction::on_stem_changed() {
	told_of_stem = String();
	motion_changed();
}

// A plant of the species' own height says what its stem is like, so that it does not matter who asks first.
std::shared_ptr<const StemConstants> PlantFunction::find_stem(double height) {
	if (motion.law != Law::stem) {
		return nullptr;
	}
	if (!stems.knows_plants()) {
		follow_changes(this, Callable(this, "_on_own_change")); // A script may answer otherwise then.
		SampledPlant plant;
		if (!sample(0.0, STEM_SEGMENTS, 0, plant).is_empty()) {
			plant = SampledPlant(); // Whoever builds its mesh tells what is wrong.
			plant.height = height > 0.0 ? float(height) : 1.0f;
		}
		stems.learn(plant);
	}
	const std::shared_ptr<const StemConstants> found = stems.of(float(height), motion, stem);
	if (!stems.problem().is_empty() && stems.problem() != told_of_stem) {
		report_error(this, stems.problem() + " It stands as a bare stem until then.");
		told_of_stem = stems.problem();
	}
	return found;
}

} // namespace undergrowth
