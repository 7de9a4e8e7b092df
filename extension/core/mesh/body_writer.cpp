// The half of FormWriter that writes bodies.

#include "base/portable_math.hpp"
#include "conventions.hpp"
#include "mesh/form_writer.hpp"
#include "mesh/template_parts.hpp"

#include <glm/geometric.hpp>

#include <algorithm>

namespace undergrowth {

namespace {

/// How fast the radius grows along the axis at a ring: between its neighbours.
glm::vec3 slope_normal(const FormBody &body, size_t ring, const glm::vec3 &outward) {
	const FormBody::Ring &before = body.rings[ring > 0 ? ring - 1 : 0];
	const FormBody::Ring &after = body.rings[std::min(ring + 1, body.rings.size() - 1)];
	const float rise = after.along - before.along;
	const float growth = after.radius - before.radius;
	const glm::vec3 normal = outward * rise - body.axes.along * growth;
	const float length = glm::length(normal);
	return length > 0.0f ? normal / length : outward;
}

} // namespace

void FormWriter::add_body(const FormBody &body, const PartHang &hang) {
	const PartHang held = hang.of_body();
	const Common common = { held, held.code, body.translucency, 1.0f };
	const int first = vertices;
	const size_t poles_before = body.has_base ? 1 : 0;
	const size_t rings = body.rings.size() - (body.has_tip ? 1 : 0);
	PartTemplate woven;
	Weaver weaver(woven, body.detail.sides, true);
	for (size_t i = poles_before; i < rings; i++) {
		const FormBody::Ring &ring = body.rings[i];
		const glm::vec3 middle = body.origin + body.axes.along * ring.along;
		const float v = 1.0f - static_cast<float>(i) / static_cast<float>(body.rings.size() - 1);
		for (int side = 0; side < body.detail.sides; side++) {
			const float turn = static_cast<float>(side) / static_cast<float>(body.detail.sides);
			const glm::vec3 outward = turn_into(body.axes, static_cast<float>(-2.0 * PI * turn), 0.0f).outward;
			put(common, middle, outward * ring.radius, slope_normal(body, i, outward), body.axes.along, body.color,
					{ turn, v }, 1.0f - v);
		}
		const int begin = vertices - first - body.detail.sides;
		if (begin > 0) {
			weaver.band(begin - body.detail.sides, begin);
		}
	}
	const auto pole = [&](float along, float facing) {
		put(common, body.origin + body.axes.along * along, glm::vec3(0.0f), body.axes.along * facing, body.axes.x,
				body.color, { 0.5f, 0.5f - 0.5f * facing }, 0.5f + 0.5f * facing);
		return vertices - first - 1;
	};
	const int last_ring = vertices - first - body.detail.sides;
	if (body.has_tip) {
		weaver.fan_to_tip(last_ring, pole(body.rings.back().along, 1.0f));
	}
	if (body.has_base) {
		weaver.fan_to_base(0, pole(body.rings.front().along, -1.0f));
	}
	for (const int32_t index : woven.indices) {
		put_index(first + index);
	}
}

} // namespace undergrowth
