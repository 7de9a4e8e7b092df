// FormWriter: writing of bodies.

#include "base/portable_math.hpp"
#include "conventions.hpp"
#include "mesh/form_writer.hpp"
#include "mesh/template_parts.hpp"

#include <glm/geometric.hpp>

#include <algorithm>

namespace undergrowth {

namespace {

/// Normal from the growth of the radius along the axis, measured between the neighbours of a ring.
glm::vec3 slope_normal(const FormBody &body, size_t ring, const glm::vec3 &outward) {
	const glm::vec3 &along = body.rings[ring].axes.along;
	const FormBody::Ring &before = body.rings[ring > 0 ? ring - 1 : 0];
	const FormBody::Ring &after = body.rings[std::min(ring + 1, body.rings.size() - 1)];
	const float rise = after.along - before.along;
	const float growth = after.radius - before.radius;
	const glm::vec3 normal = outward * rise - along * growth;
	const float length = glm::length(normal);
	return length > 0.0f ? normal / length : outward;
}

} // namespace

void FormWriter::add_body(const FormBody &body) {
	const auto common_of = [&body](const FormBody::Ring &ring) {
		return Common{ ring.attachment, ring.attachment.code, body.translucency, 0.0f, 1.0f };
	};
	const int first = vertices;
	const size_t poles_before = body.has_base ? 1 : 0;
	const size_t rings = body.rings.size() - (body.has_tip ? 1 : 0);
	PartTemplate woven;
	Weaver weaver(woven, body.detail.sides, true);
	for (size_t i = poles_before; i < rings; i++) {
		const FormBody::Ring &ring = body.rings[i];
		const Common common = common_of(ring);
		const float v = 1.0f - static_cast<float>(i) / static_cast<float>(body.rings.size() - 1);
		for (int side = 0; side < body.detail.sides; side++) {
			const float turn = static_cast<float>(side) / static_cast<float>(body.detail.sides);
			const glm::vec3 outward = turn_into(ring.axes, static_cast<float>(-2.0 * PI * turn), 0.0f).outward;
			put(common, ring.middle, outward * ring.radius, slope_normal(body, i, outward), ring.axes.along, ring.color,
					{ turn, v }, 1.0f - v);
		}
		const int begin = vertices - first - body.detail.sides;
		if (begin > 0) {
			weaver.band(begin - body.detail.sides, begin);
		}
	}
	const auto pole = [&](const FormBody::Ring &ring, float facing) {
		put(common_of(ring), ring.middle, glm::vec3(0.0f), ring.axes.along * facing, ring.axes.x, ring.color,
				{ 0.5f, 0.5f - 0.5f * facing }, 0.5f + 0.5f * facing);
		return vertices - first - 1;
	};
	const int last_ring = vertices - first - body.detail.sides;
	if (body.has_tip) {
		weaver.fan_to_tip(last_ring, pole(body.rings.back(), 1.0f));
	}
	if (body.has_base) {
		weaver.fan_to_base(0, pole(body.rings.front(), -1.0f));
	}
	for (const int32_t index : woven.indices) {
		put_index(first + index);
	}
}

} // namespace undergrowth
