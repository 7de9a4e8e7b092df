#include "form/shared_cards.hpp"

#include "base/new_object.hpp"

#include <godot_cpp/classes/image.hpp>

#include <cstring>

using namespace godot;

namespace undergrowth {

static Ref<Texture2DArray> texture_of(const CardSheet &sheet, std::vector<uint8_t> CardLayer::*bytes) {
	TypedArray<Image> images;
	for (const CardLayer &layer : sheet.pictures) {
		const std::vector<uint8_t> &from = layer.*bytes;
		PackedByteArray data;
		data.resize(int64_t(from.size()));
		std::memcpy(data.ptrw(), from.data(), from.size());
		images.push_back(Image::create_from_data(sheet.width, sheet.height, true, Image::FORMAT_RGBA8, data));
	}
	Ref<Texture2DArray> made = new_counted<Texture2DArray>();
	made->create_from_images(images);
	return made;
}

const CardSheet &SharedCards::sheet() const {
	std::call_once(is_drawn, [this] { drawn = make_card_sheet(shown->form); });
	return drawn;
}

const Ref<Texture2DArray> &SharedCards::colors() {
	if (color_texture.is_null()) {
		color_texture = texture_of(sheet(), &CardLayer::colors);
	}
	return color_texture;
}

const Ref<Texture2DArray> &SharedCards::surfaces() {
	if (surface_texture.is_null()) {
		surface_texture = texture_of(sheet(), &CardLayer::surfaces);
	}
	return surface_texture;
}

} // namespace undergrowth
