#include "field/view/plant_buffer.hpp"

#include <algorithm>

namespace undergrowth {

static constexpr int MIN_ROOM = 16;

float *PlantBuffer::add(int added) {
	const int64_t at = int64_t(count) * floats_of_plant;
	count += added;
	if (count > room) {
		room = std::max({ room + room / 2, count, MIN_ROOM });
		all.resize(int64_t(room) * floats_of_plant);
		std::fill(all.ptrw() + at, all.ptrw() + all.size(), 0.0f);
	}
	return all.ptrw() + at;
}

void PlantBuffer::remove(int plant) {
	count--;
	float *floats = all.ptrw();
	std::copy_n(floats + int64_t(count) * floats_of_plant, floats_of_plant, floats + int64_t(plant) * floats_of_plant);
}

} // namespace undergrowth
