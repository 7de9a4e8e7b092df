#include "mesh/form_mesh.hpp"

#include "mesh/drawn_attachments.hpp"
#include "mesh/form_match.hpp"
#include "mesh/form_writer.hpp"
#include "mesh/part_detail.hpp"

#include <algorithm>

namespace undergrowth {

namespace {

constexpr float MAX_STOUTNESS = 0.65f; // Silhouette of a spindle over its squared length: half of width over length.

/// Shapes that parts of a kind share, created for the first such part. Groups of one kind may have different details.
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

} // namespace

void build_form_mesh(const PlantForm &form, const FormMeasure &measure, const FormPlan &plan, const FormBones &bones,
		const MeshOptions &options, float height, const FormBuffers &buffers) {
	const DrawnAttachments attachments(form, plan, measure.attachments);
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
				PlacedPart part = form.placed[place];
				part.base += attachments.shift_of(place);
				writer.add_part(part, attachments.attachment_of(place), shapes.of(part));
			}
		}
		writer.widen(begin, plan.shown[g], near);
	}
	for (FormBody &body : make_bodies(form, measure, plan)) {
		attachments.place_rings(body);
		const FormWriter::Mark begin = writer.mark();
		const Layout layout = form.groups[static_cast<size_t>(body.group)].layout;
		begin_unit(0.5f, layout == Layout::whorl || layout == Layout::disc);
		writer.add_body(body);
		if (body.shown > 0.0f) {
			writer.widen(begin, body.shown, 0.5f);
			const float length = body.rings.back().along - body.rings.front().along;
			units.back().max = std::max(MAX_STOUTNESS * length * length / body.shown, 1.0f);
		}
	}
	if (plan.is_cut) {
		begin_unit(0.0f, false);
		match_form(measure, units, buffers);
	}
	writer.stretch(height / form.height);
}

} // namespace undergrowth
