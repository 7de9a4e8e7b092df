#include "field/field_trampling.hpp"

#include <algorithm>

namespace undergrowth {

void FieldTrampling::keep_chunk(
		int number, const PlantChunk &chunk, const FieldRenderSetup &setup, FieldMotion &motion, TroddenPlants &to) {
	const std::vector<glm::vec2> bends = motion.blocking_read_lasting_bends(number);
	for (int slot = 0; slot < std::min(int(bends.size()), chunk.size()); slot++) {
		if (bends[size_t(slot)] != glm::vec2(0.0f) && !chunk.is_gone(slot)) {
			const Trampling &trampling = setup.styles[size_t(chunk.species)].motion.trampling;
			to.put(chunk.id(slot), bends[size_t(slot)], trampling.recovery);
		}
	}
}

void FieldTrampling::leave(const ChangeSet &changes, const FieldRenderSetup &setup, FieldMotion &motion) {
	for (size_t i = 0; i < changes.dropped.size(); i++) {
		keep_chunk(changes.dropped[i], *changes.left[i], setup, motion, absent);
	}
}

void FieldTrampling::restore(int number, int first, const PlantStore &store, FieldMotion &motion) {
	const PlantChunk &chunk = store.chunk(number);
	for (int slot = first; slot < chunk.size() && !absent.is_empty(); slot++) {
		const glm::vec2 bend = absent.take(chunk.id(slot));
		if (bend != glm::vec2(0.0f) && !chunk.is_gone(slot)) {
			motion.set_lasting_bend({ number, slot }, bend);
		}
	}
}

void FieldTrampling::arrive(const ChangeSet &changes, const PlantStore &store, FieldMotion &motion) {
	for (const ChangeSet::Grown &grown : changes.grown) {
		restore(grown.chunk, grown.first, store, motion);
	}
}

std::vector<TroddenPlant> FieldTrampling::all(
		const PlantStore &store, const FieldRenderSetup &setup, FieldMotion &motion) const {
	TroddenPlants both = absent;
	for (int number = 0; motion.is_ready() && number < store.chunk_count(); number++) {
		keep_chunk(number, store.chunk(number), setup, motion, both);
	}
	return both.all();
}

void FieldTrampling::replace(const std::vector<TroddenPlant> &trodden, const PlantStore &store,
		const FieldRenderSetup &setup, FieldMotion &motion) {
	float slowest = setup.styles.empty() ? Trampling().recovery : 0.0f;
	for (const SpeciesStyle &style : setup.styles) {
		slowest = std::max(slowest, style.motion.trampling.recovery);
	}
	absent = TroddenPlants();
	for (const TroddenPlant &plant : trodden) {
		absent.put(plant.id, plant.bend, slowest);
	}
	if (motion.is_ready()) {
		motion.forget_lasting_bends();
	}
	for (int number = 0; motion.is_ready() && number < store.chunk_count(); number++) {
		restore(number, 0, store, motion);
	}
}

} // namespace undergrowth
