#pragma once

#include <godot_cpp/variant/packed_float32_array.hpp>

namespace undergrowth {

/// The floats of the plants in a multimesh, with spare room at the end.
class PlantBuffer {
public:
	/// `stride`: floats per plant, as in a multimesh.
	explicit PlantBuffer(int stride) : floats_of_plant(stride) {}

	int size() const { return count; }
	int capacity() const { return room; }
	int stride() const { return floats_of_plant; }
	/// Of `capacity()` plants.
	const godot::PackedFloat32Array &floats() const { return all; }
	/// Adds `added` plants and returns their floats, to be written before the next call.
	float *add(int added);
	/// Removes a plant. The last one takes its place.
	void remove(int plant);
	/// Removes all plants and keeps the room.
	void clear() { count = 0; }

private:
	int floats_of_plant;
	int room = 0; ///< Plants.
	int count = 0;
	godot::PackedFloat32Array all;
};

} // namespace undergrowth
