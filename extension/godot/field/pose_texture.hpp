#pragma once

#include "field/field_motion.hpp"
#include "field/field_simulation.hpp"
#include "field/page_rows.hpp"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/variant/rid.hpp>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace undergrowth {

/// Rows of texels of one layer.
struct TexelRows {
	int layer = -1; ///< -1: none.
	int first = 0;
	int count = 0;
	PoseTexels texels() const;
};

/// The textures that carry the plants' poses to the graphics card. A texel belongs to a plant: its bends before and
/// after its last step, in layers of 64 by 64 texels; a page of plants has whole rows of one layer. A second texture
/// has a blend for each row, a third one what makes rates of changes of bends, which layer says where its plants rest,
/// which one the bends of their stems' second modes, and which one how much of its height each has lost: plants of
/// parts and stems have the one as soon as one of them does not rest upright, stems of two modes the other. Where
/// plants follow prototypes, a texel says whom and how late instead, and each species has 16 layers for the history of
/// its prototypes and one for plants that were pushed, and as many of second modes where its stems have two.
class PoseTexture {
public:
	static constexpr int SIDE = 64;
	static constexpr int MOST_LAYERS = 2048; ///< What graphics cards have.
	static constexpr int PAIRS_PER_LAYER = SIDE * SIDE;

	/// For a simulation with prototypes or without.
	explicit PoseTexture(bool follows_prototypes);
	~PoseTexture();
	PoseTexture(const PoseTexture &) = delete;
	PoseTexture &operator=(const PoseTexture &) = delete;

	/// Gives a page rows for `plants` plants, those that it has or other ones. On any thread, but for no two at once.
	void give_rows(int page, int plants);
	void take_rows(int page);
	/// The page goes, and its rows stay nobody's: whatever is drawn there is not seen.
	void leave_rows(int page);
	/// Rows for `plants` plants of a page that is yet to come, until release(). None: nothing happens.
	TexelRows reserve(int plants) { return find_rows((plants + SIDE - 1) / SIDE); }
	void release(const TexelRows &rows);
	/// Adds layers for about as many rows more, as far as graphics cards have them.
	void make_room(double row_count);
	/// The page has come.
	void give_reserved(int page, const TexelRows &rows);
	/// Makes room for the history of all species of a simulation, in as many modes as they have now.
	void give_history(const FieldSimulation &simulation);
	/// Whether layers are left for the history of another species.
	bool has_room_for_species() const;
	/// Whether the layers are more than a graphics card has.
	bool is_too_large() const;
	/// Where the shader finds plants of a page.
	PoseTexels texels(const PageRows &plants) const;
	int layer_of(int page) const { return pages[size_t(page)].rows.layer; }

	/// Takes over the bends of a page of the simulation, nothing where it has no rows. On any thread, different pages
	/// at the same time.
	void write_page(const FieldSimulation &simulation, int page);
	void write_pages(const FieldSimulation &simulation);
	/// The same in two: will_write() of all pages on one thread, then write_bends() on any, of plants that swing.
	void will_write(int page);
	void write_bends(const FieldSimulation &simulation, int page);
	/// Takes over the newest slot of each species' history, or all of them, and what its pushed plants do.
	void write_history(const FieldSimulation &simulation, bool all);
	/// All slots of one species.
	void write_history_of(const FieldSimulation &simulation, int species);

	/// Takes over where the plants of a page rest, and gives it room for second modes. Before they are drawn first, and
	/// whenever a species changes; on one thread.
	void write_beside(const FieldSimulation &simulation, int page);
	/// Room for second modes alone, where the page steps them now, before they are written.
	void give_seconds(const FieldSimulation &simulation, int page);

	/// A plant is drawn so high, as a share of its own height.
	void set_height(int page, int row, float share);
	/// Whether any ever was.
	bool has_heights() const { return draws_heights; }

	/// Draws nothing where this plant is.
	void hide(int page, int row);
	/// Ends that, from the next write_page() on.
	void show(int page, int row);

	/// Main thread from here on. Makes textures of the layers where they are new or more; tells whether they are
	/// others.
	bool make_textures();
	/// Sends what was written since the last time, and the blends for `fraction` of a step.
	void upload(const FieldSimulation &simulation, float fraction);
	godot::RID poses() const { return texture; }
	godot::RID blends() const { return blend_texture; }
	godot::RID beats() const { return beat_texture; }
	/// First layer of a species' history in a mode, or -1.
	int history_layer(int species, int mode) const;
	bool follows() const { return follows_prototypes; }

private:
	static constexpr int SPARE_LAYERS = 2; ///< So that plants which are added seldom need another texture.
	static constexpr size_t BEAT_FLOATS = 4; ///< Of a row: 1 over rate_time(), layers of rests, second modes, heights.
	static constexpr size_t TEXEL_BYTES = 2 * sizeof(Bend);
	using Rows = TexelRows;
	struct Page {
		Rows rows;
		float share = -1.0f; ///< The blend that was sent.
		float rate_time = -1.0f; ///< s, FieldSimulation::rate_time() that was sent.
		bool has_seconds = false; ///< As was sent.
		std::vector<uint16_t> hidden; ///< Plants that are gone, or that others show.
	};

	const bool follows_prototypes;
	std::vector<godot::Ref<godot::Image>> layers;
	std::vector<uint64_t> free_rows; ///< By layer: a bit for each row.
	std::vector<uint8_t> is_fresh; ///< By layer: written and not yet sent.
	std::vector<Page> pages; ///< By the simulation's numbers.
	bool has_new_rows = false; ///< Pages whose beat was not sent.
	using History = std::array<int, MOST_STEM_MODES>; ///< By mode: its first layer, or -1.
	std::vector<History> histories; ///< By species.
	godot::Ref<godot::Image> blend_image;
	std::vector<float> shares; ///< What `blend_image` holds.
	godot::Ref<godot::Image> beat_image;
	std::vector<float> beats_sent; ///< What `beat_image` holds.
	struct Beside { ///< Layers that say more of a layer's plants, or -1.
		int rests = -1;
		int seconds = -1;
		int heights = -1;
	};
	bool draws_heights = false;
	std::vector<Beside> besides; ///< By layer, as far as any has one.
	godot::RID texture;
	godot::RID blend_texture;
	godot::RID beat_texture;
	size_t textured_layers = 0;

	int add_layer(bool is_shared);
	int find_layer();
	Rows find_rows(int count);
	void take_as_new(Page &page, const Rows &rows);
	bool has_rows(int page) const { return size_t(page) < pages.size() && pages[size_t(page)].rows.layer >= 0; }
	uint8_t *bytes_of(const Rows &rows);
	void write_hidden(const Page &page);
	void forget_heights(const Rows &rows);
	void write_followers(const FieldSimulation &simulation, int page);
	void write_species(const FieldSimulation &simulation, int species, bool all);
	void write_models(const Prototypes &models, int mode, int first, bool all);
	void write_layer(int layer, const Bend *from, int pairs, int first);
	void upload_layers();
	void upload_blends(const FieldSimulation &simulation, float fraction);
	void upload_beats(const FieldSimulation &simulation);
	Beside beside(int layer) const;
	/// Makes one of them, of zeros, unless it is there or the graphics card has no more; tells it or -1.
	int add_beside(int layer, int Beside::*which);
	void write_rests(const FieldSimulation &simulation, int page);
	void free_textures();
};

} // namespace undergrowth
