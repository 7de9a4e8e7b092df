#pragma once

#include "card/card_sheet.hpp"
#include "form/grown_plant.hpp"

#include <godot_cpp/classes/texture2d_array.hpp>

#include <memory>
#include <mutex>

namespace undergrowth {

/// The cards of a species: pictures of its small parts, and the textures made from them. All seeds and fields share
/// them.
class SharedCards {
public:
	/// `plant`: the plant of the species that the pictures show.
	explicit SharedCards(const std::shared_ptr<const GrownPlant> &plant) : shown(plant) {}
	SharedCards(const SharedCards &) = delete;
	SharedCards &operator=(const SharedCards &) = delete;

	/// Draws the pictures at the first call. Any thread.
	const CardSheet &sheet() const;
	/// Creates the textures at the first call. Main thread.
	const godot::Ref<godot::Texture2DArray> &colors();
	const godot::Ref<godot::Texture2DArray> &surfaces();

private:
	const std::shared_ptr<const GrownPlant> shown;
	mutable std::once_flag is_drawn;
	mutable CardSheet drawn;
	godot::Ref<godot::Texture2DArray> color_texture, surface_texture;
};

} // namespace undergrowth
