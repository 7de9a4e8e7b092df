#pragma once

#include "card/card_form.hpp"
#include "form/plant_form.hpp"
#include "mesh/form_bones.hpp"
#include "mesh/form_measure.hpp"
#include "mesh/part_attachment.hpp"

#include <array>
#include <functional>
#include <map>
#include <mutex>
#include <utility>

namespace undergrowth {

/// What a level of a plant looks like.
struct LevelLooks {
	float error = 0.0f; ///< Of the outline (m).
	bool has_bodies = false; ///< Of SharedMesh.
	bool has_cards = false; ///< Of SharedMesh.
	int triangles = 0;
};

/// A generated plant of parts. All levels of detail share it.
class GrownPlant {
public:
	const PlantForm form;
	const FormBones bones;
	const bool has_orders; ///< has_branched_branches().

	explicit GrownPlant(PlantForm &&grown) :
			form(std::move(grown)), bones(form, attach_parts(form)), has_orders(has_branched_branches(form)) {}

	/// Measured by the first build of a mesh, on any thread.
	const FormMeasure &measure() const {
		std::call_once(is_measured, [this] { measured = measure_form(form); });
		return measured;
	}

	/// The same plant with cards, made at the first call. `sheet`: the one of its species. `drawn`: near or far. Any
	/// thread.
	const CardForm &card_form(const CardSheet &sheet, CardReach drawn) const {
		const size_t i = drawn == CardReach::far ? 1 : 0;
		std::call_once(has_card_form[i], [&] { with_cards[i] = make_card_form(form, measure(), sheet, drawn); });
		return with_cards[i];
	}

	/// Returns the looks of a level with `segments`. `measure` runs once for each number of segments, with and without
	/// cards. Any thread.
	LevelLooks level_looks(int segments, bool has_cards, const std::function<LevelLooks()> &measure) const {
		const std::lock_guard<std::mutex> lock(measuring);
		const std::pair<int, bool> level(segments, has_cards);
		const auto known = looks.find(level);
		return known != looks.end() ? known->second : looks.emplace(level, measure()).first->second;
	}

	/// True if level_looks() knows a level without cards. Never waits: false while a thread measures one.
	bool knows_looks(int segments) const {
		const std::unique_lock<std::mutex> lock(measuring, std::try_to_lock);
		return lock.owns_lock() && looks.count({ segments, false }) > 0;
	}

private:
	mutable std::mutex measuring;
	mutable std::map<std::pair<int, bool>, LevelLooks> looks; ///< By segments, with and without cards.
	mutable std::once_flag is_measured;
	mutable FormMeasure measured;
	mutable std::array<std::once_flag, 2> has_card_form; ///< Near, far.
	mutable std::array<CardForm, 2> with_cards;
};

} // namespace undergrowth
