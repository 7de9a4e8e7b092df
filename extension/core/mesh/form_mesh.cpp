#include "mesh/form_mesh.hpp"

#include "mesh/form_match.hpp"
#include "mesh/form_writer.hpp"
#include "mesh/part_detail.hpp"

#include <glm/geometric.hpp>

#include <algorithm>

namespace undergrowth {

namespace {

constexpr float MOST_STOUT = 0.65f; // Of a spindle, twice it: width by length.

/// Shapes that parts of a kind share, made when the first is drawn. Groups of one kind may be drawn differently.
class Shapes {
public:
	Shapes(const PlantForm &p_form, const FormMeasure &p_measure, const FormPlan &p_plan) :
			form(p_form), measure(p_measure), plan(p_plan), shared(p_form.groups.size()) {}

	const PartTemplate &of(const PlacedPart &placed) {
		const Part &part = form.parts[static_cast<size_t>(placed.kind)];
		const PartDetail &detail = plan.groups[static_cast<size_t>(placed.group)].detail;
		if (placed.own_midrib >= 0) {
			own = make(placed, part, detail);
			return own;
		}
		PartTemplate &shape = shared[static_cast<size_t>(placed.group)];
		if (shape.vertices.empty()) {
			shape = make(placed, part, detail);
		}
		return shape;
	}

private:
	const PlantForm &form;
	const FormMeasure &measure;
	const FormPlan &plan;
	std::vector<PartTemplate> shared;
	PartTemplate own;

	PartTemplate make(const PlacedPart &placed, const Part &part, const PartDetail &detail) const {
		return make_part_template(
				part, form.midrib_of(placed), detail, measure.colors[static_cast<size_t>(placed.kind)]);
	}
};

/// Between two rows a stem is drawn straight, beside the curve on which it bends: what it carries there hangs so far
/// along the bend that it stays on the stem that is drawn.
class DrawnStem {
public:
	DrawnStem(const PlantForm &p_form, const FormPlan &plan, int carrier) :
			form(p_form),
			stem(p_form.placed[static_cast<size_t>(carrier)]),
			rows(row_offsets(p_form.parts[static_cast<size_t>(stem.kind)],
					plan.groups[static_cast<size_t>(stem.group)].detail)) {}

	float stem_offset(float offset) const {
		const auto above = std::upper_bound(rows.begin() + 1, rows.end() - 1, offset);
		const glm::vec3 low = form.point_of(stem, *(above - 1));
		const glm::vec3 high = form.point_of(stem, *above);
		const float t = (offset - *(above - 1)) / (*above - *(above - 1));
		const glm::vec3 moved =
				low * (stem_offset_of(form, low) * (1.0f - t)) + high * (stem_offset_of(form, high) * t);
		const glm::vec3 place = form.point_of(stem, offset);
		const float square = glm::dot(place, place);
		return square > 0.0f ? std::clamp(glm::dot(moved, place) / square, 0.0f, 1.0f) : 0.0f;
	}

private:
	const PlantForm &form;
	const PlacedPart &stem;
	const std::vector<float> rows;
};

void hold_to_stems(const PlantForm &form, const FormPlan &plan, std::vector<PartHang> &hangs) {
	const PlacedPart *before = nullptr; // Parts of a whorl or a disc stand at one place and follow each other.
	float held = 0.0f;
	for (size_t i = 0; i < form.placed.size(); i++) {
		const PlacedPart &part = form.placed[i];
		const size_t carrier = static_cast<size_t>(std::max(part.carrier, 0));
		if (part.carrier == ON_GROUND || plan.fates[carrier] != FormPlan::drawn) {
			continue;
		}
		if (!hangs[carrier].is_root) {
			hangs[i].stem_offset = hangs[carrier].stem_offset;
			continue;
		}
		if (before == nullptr || before->carrier != part.carrier || before->offset != part.offset) {
			held = DrawnStem(form, plan, part.carrier).stem_offset(part.offset);
			before = &part;
		}
		hangs[i].stem_offset = held;
	}
}

} // namespace

void build_form_mesh(const PlantForm &form, const FormMeasure &measure, const FormPlan &plan, const FormBones &bones,
		const MeshOptions &options, float height, const FormBuffers &buffers) {
	std::vector<PartHang> hangs = measure.hangs;
	hold_to_stems(form, plan, hangs);
	FormWriter writer(form, bones, options, buffers);
	Shapes shapes(form, measure, plan);
	std::vector<WrittenUnit> units;
	const auto begin_unit = [&](float near, bool is_flower) {
		units.push_back({ writer.mark().vertex, writer.mark().index, near, is_flower, 1e9f });
	};
	for (size_t g = 0; g < form.groups.size(); g++) {
		const PartGroup &group = form.groups[g];
		const FormWriter::Mark begin = writer.mark();
		const bool is_sheet = plan.groups[g].detail.columns == 2;
		const float near = is_sheet ? 1.0f : near_share(form.parts[static_cast<size_t>(group.kind)].kind);
		for (int i = group.first; i < group.first + group.count; i++) {
			const size_t place = static_cast<size_t>(i);
			if (plan.fates[place] == FormPlan::drawn) {
				begin_unit(near, group.layout == Layout::whorl);
				writer.add_part(form.placed[place], hangs[place], shapes.of(form.placed[place]));
			}
		}
		writer.widen(begin, plan.shown[g], near);
	}
	for (const FormBody &body : make_bodies(form, measure, plan)) {
		const FormWriter::Mark begin = writer.mark();
		const Layout layout = form.groups[static_cast<size_t>(body.group)].layout;
		begin_unit(0.5f, layout == Layout::whorl || layout == Layout::disc);
		writer.add_body(body, hangs[static_cast<size_t>(body.first)]);
		if (body.shown > 0.0f) {
			writer.widen(begin, body.shown, 0.5f);
			const float length = body.rings.back().along - body.rings.front().along;
			units.back().most = std::max(MOST_STOUT * length * length / body.shown, 1.0f);
		}
	}
	if (plan.is_cut) {
		begin_unit(0.0f, false);
		match_form(measure, units, buffers);
	}
	writer.stretch(height / form.height);
}

} // namespace undergrowth
