#include "field/field_trampling.hpp"

#include <algorithm>

namespace undergrowth {

static float recovery_of(const FieldRenderSetup &setup, int species) {
	return size_t(species) < setup.styles.size() ? setup.styles[size_t(species)].motion.trampling.recovery
												 : Trampling().recovery;
}

void FieldTrampling::keep_chunk(
		int number, const PlantChunk &chunk, const FieldRenderSetup &setup, FieldMotion &motion, TroddenPlants &to) {
	const std::vector<glm::vec2> bends = motion.blocking_read_lasting_bends(number);
	for (int slot = 0; slot < std::min(int(bends.size()), chunk.size()); slot++) {
		if (bends[size_t(slot)] != glm::vec2(0.0f) && !chunk.is_gone(slot)) {
			to.put(chunk.id(slot), bends[size_t(slot)], recovery_of(setup, chunk.species));
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
	float slowest = Trampling().recovery;
	for (size_t i = 0; i < setup.styles.size(); i++) {
		const float recovery = recovery_of(setup, int(i));
		slowest = i == 0 ? recovery : std::max(slowest, recovery);
	}
	absent = TroddenPlants();
	for (const TroddenPlant &plant : trodden) {
		absent.put(plant.id, plant.bend, slowest);
	}
	for (int number = 0; motion.is_ready() && number < store.chunk_count(); number++) {
		for (int slot = 0; slot < int(motion.blocking_read_lasting_bends(number).size()); slot++) {
			motion.set_lasting_bend({ number, slot }, { 0.0f, 0.0f });
		}
		restore(number, 0, store, motion);
	}
}

} // namespace undergrowth
