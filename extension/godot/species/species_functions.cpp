#include "species/species_functions.hpp"

#include <godot_cpp/core/class_db.hpp>

using namespace godot;

namespace undergrowth {

#define BIND_PART(m_class, m_part, m_argument)                                                                         \
	ClassDB::bind_method(D_METHOD("set_" #m_part, m_argument), &m_class::set_##m_part);                                \
	ClassDB::bind_method(D_METHOD("get_" #m_part), &m_class::get_##m_part)
#define BIND_PART_COLOR(m_class, m_part)                                                                               \
	BIND_PART(m_class, m_part, "color");                                                                               \
	ADD_PROPERTY(PropertyInfo(Variant::COLOR, #m_part), "set_" #m_part, "get_" #m_part)
#define BIND_PART_SIZE(m_class, m_part, m_range)                                                                       \
	BIND_PART(m_class, m_part, "metres");                                                                              \
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, #m_part, PROPERTY_HINT_RANGE, m_range), "set_" #m_part, "get_" #m_part)

void GrassFunction::_bind_methods() {
	ADD_GROUP("Grass", "");
	BIND_PART_COLOR(GrassFunction, root_color);
	BIND_PART_COLOR(GrassFunction, middle_color);
	BIND_PART_COLOR(GrassFunction, tip_color);
	BIND_PART_SIZE(GrassFunction, blade_width, "0.001,0.1,0.0001,or_greater,suffix:m");
}

void ReedFunction::_bind_methods() {
	ADD_GROUP("Reed", "");
	BIND_PART_COLOR(ReedFunction, stem_color);
	BIND_PART_COLOR(ReedFunction, joint_color);
	BIND_PART_COLOR(ReedFunction, plume_color);
	BIND_PART_COLOR(ReedFunction, plume_tip_color);
	BIND_PART_SIZE(ReedFunction, stem_radius, "0.001,0.1,0.0001,or_greater,suffix:m");
}

void CattailFunction::_bind_methods() {
	ADD_GROUP("Cattail", "");
	BIND_PART_COLOR(CattailFunction, stem_color);
	BIND_PART_COLOR(CattailFunction, head_color);
	BIND_PART_COLOR(CattailFunction, spike_color);
	BIND_PART_SIZE(CattailFunction, stem_radius, "0.001,0.1,0.0001,or_greater,suffix:m");
}

void TulipFunction::_bind_methods() {
	ADD_GROUP("Tulip", "");
	BIND_PART_COLOR(TulipFunction, stem_color);
	BIND_PART_COLOR(TulipFunction, flower_color);
}

void BellflowerFunction::_bind_methods() {
	ADD_GROUP("Bellflower", "");
	BIND_PART_COLOR(BellflowerFunction, stem_color);
	BIND_PART_COLOR(BellflowerFunction, bell_color);
	BIND_PART_COLOR(BellflowerFunction, rim_color);
	BIND_PART_SIZE(BellflowerFunction, bell_radius, "0.005,0.3,0.001,or_greater,suffix:m");
}

} // namespace undergrowth
