#pragma once

#include "card/card_form.hpp"
#include "form/plant_form.hpp"
#include "mesh/form_bones.hpp"
#include "mesh/form_measure.hpp"
#include "mesh/part_attachment.hpp"

#include <functional>
#include <map>
#include <mutex>
#include <utility>

namespace undergrowth {

/// A generated plant of parts. All levels of detail share it.
class GrownPlant {
public:
	const PlantForm form;
	const FormBones bones;

	explicit GrownPlant(PlantForm &&grown) : form(std::move(grown)), bones(form, attach_parts(form)) {}

	/// Measured by the first build of a mesh, on any thread.
	const FormMeasure &measure() const {
		std::call_once(is_measured, [this] { measured = measure_form(form); });
		return measured;
	}

	/// The same plant with cards, made at the first call. `sheet`: the one of its species. Any thread.
	const CardForm &card_form(const CardSheet &sheet) const {
		std::call_once(has_card_form, [this, &sheet] { with_cards = make_card_form(form, sheet); });
		return with_cards;
	}

	/// Returns the error of the outline at a level with `segments` (m). `measure` runs once for each number of
	/// segments, with and without cards. Any thread.
	float level_error(int segments, bool has_cards, const std::function<float()> &measure) const {
		const std::lock_guard<std::mutex> lock(measuring);
		const std::pair<int, bool> level(segments, has_cards);
		const auto known = level_errors.find(level);
		return known != level_errors.end() ? known->second : level_errors.emplace(level, measure()).first->second;
	}

private:
	mutable std::mutex measuring;
	mutable std::map<std::pair<int, bool>, float> level_errors; ///< m, by segments, with and without cards.
	mutable std::once_flag is_measured;
	mutable FormMeasure measured;
	mutable std::once_flag has_card_form;
	mutable CardForm with_cards;
};

} // namespace undergrowth
