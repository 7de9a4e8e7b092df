#include "form/plant_form.hpp"

namespace undergrowth {

glm::vec3 PlantForm::point_of(const PlacedPart &part, float offset) const {
	return part.base + turned(part.axes, midrib_of(part).point_at(offset) * part.length);
}

PartAxes PlantForm::axes_of(const PlacedPart &part, float offset) const {
	const Midrib::Place place = midrib_of(part).at(offset);
	return { turned(part.axes, place.across), turned(part.axes, place.along), turned(part.axes, place.up * -1.0f) };
}

} // namespace undergrowth
