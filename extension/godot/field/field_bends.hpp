#pragma once

#include "field/field_simulation.hpp"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/variant/rid.hpp>

#include <vector>

namespace undergrowth {

/// The textures that carry bends to the graphics card: a layer of 64 by 64 texels for each page (before and after its
/// last step) and a row with a blend for each layer. Where plants follow prototypes, a page's layer says whom and how
/// late instead, and each species has 16 layers for the history of its prototypes and one for plants that were pushed.
class FieldBends {
public:
	FieldBends() = default;
	~FieldBends();
	FieldBends(const FieldBends &) = delete;
	FieldBends &operator=(const FieldBends &) = delete;

	/// Makes images for `simulation` as it is now and some pages more. On any thread, but for make_textures().
	void make_images(const FieldSimulation &simulation);
	void make_textures();
	/// Whether the images have room for all pages of `simulation`.
	bool has_room(const FieldSimulation &simulation) const;
	/// First layer of a species' history; its pushed plants are in the one after the history.
	int history_layer(int species) const;

	/// Takes over a page's bends. On any thread; different pages at the same time.
	void write_page(const FieldSimulation &simulation, int page);
	/// Draws nothing where this plant is, until show_all(). From the page's next write_page() on.
	void hide(int page, int index);
	/// Pages with plants that are hidden.
	std::vector<int> hidden_pages() const;
	/// Forgets what was hidden. Each page shows it from its next write_page() on.
	void show_all();
	/// Takes over the newest slot of each species' history, and what its pushed plants do.
	void write_history(const FieldSimulation &simulation);

	/// Sends what was written since the last time, and the blends for `fraction` of a step. Main thread.
	void upload(const FieldSimulation &simulation, float fraction);

	godot::RID bends_texture() const { return texture; }
	godot::RID blends_texture() const { return blend_texture; }
	size_t bytes() const;

private:
	std::vector<godot::Ref<godot::Image>> layers;
	std::vector<uint8_t> is_fresh; ///< By layer: written and not yet sent.
	std::vector<std::vector<int>> hidden; ///< By page: plants that others show.
	godot::Ref<godot::Image> blends;
	std::vector<float> shares; ///< What `blends` holds.
	godot::RID texture;
	godot::RID blend_texture;
	int page_layers = 0;
	bool follows = false; ///< Prototypes.
	std::vector<int> loose_versions; ///< By page: as written.

	void write_hidden(int page);
	void write_followers(const FieldSimulation &simulation, int page);
	void write_layer(int layer, const Bend *from, int pairs, int first);
};

} // namespace undergrowth
