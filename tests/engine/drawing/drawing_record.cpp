#include "drawing_record.hpp"

#include "record.hpp"

#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>

#include <algorithm>

using namespace godot;

namespace recorder {

Record &record() {
	static Record one;
	return one;
}

Array DrawingRecord::get_instances() {
	const std::lock_guard<std::mutex> lock(record().mutex);
	Array found;
	for (const auto &[rid, instance] : record().instances) {
		const Multimesh &multimesh = record().multimeshes[instance.multimesh];
		PackedFloat32Array buffer;
		buffer.resize(int64_t(multimesh.buffer.size()));
		std::copy(multimesh.buffer.begin(), multimesh.buffer.end(), buffer.ptrw());
		Dictionary one;
		one["visible"] = instance.is_visible;
		one["scenario"] = int64_t(instance.scenario);
		one["gi_flags"] = int64_t(instance.gi_flags);
		one["begin"] = instance.begin;
		one["end"] = instance.end;
		one["box"] = multimesh.box;
		one["mesh"] = int64_t(multimesh.mesh);
		one["shown"] = multimesh.shown;
		one["buffer"] = buffer;
		found.push_back(one);
	}
	return found;
}

Dictionary DrawingRecord::get_textures() {
	const std::lock_guard<std::mutex> lock(record().mutex);
	Dictionary found;
	for (const auto &[rid, layers] : record().textures) {
		Array all;
		for (const std::vector<uint8_t> &layer : layers) {
			PackedByteArray bytes;
			bytes.resize(int64_t(layer.size()));
			std::copy(layer.begin(), layer.end(), bytes.ptrw());
			all.push_back(bytes);
		}
		found[int64_t(rid)] = all;
	}
	return found;
}

int64_t DrawingRecord::count_parameter(const String &name) {
	const std::lock_guard<std::mutex> lock(record().mutex);
	return record().parameters[name.utf8().get_data()];
}

void DrawingRecord::_bind_methods() {
	ClassDB::bind_static_method("DrawingRecord", D_METHOD("count_parameter", "name"), &DrawingRecord::count_parameter);
	ClassDB::bind_static_method("DrawingRecord", D_METHOD("get_instances"), &DrawingRecord::get_instances);
	ClassDB::bind_static_method("DrawingRecord", D_METHOD("get_textures"), &DrawingRecord::get_textures);
}

} // namespace recorder
