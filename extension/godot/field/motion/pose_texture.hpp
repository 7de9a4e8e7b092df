#pragma once

#include "field/field_simulation.hpp"
#include "field/motion/pose_texels.hpp"
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

/// The textures with the plants' poses for the graphics card. Each plant has a texel with its bends before and after
/// its last step, in layers of 64 by 64 texels. A page of plants has whole rows of one layer. A second texture has a
/// blend for each row.
///
/// A third texture has the factor for rates of bends for each row, and three layer numbers: of rest directions, of
/// second modes' bends, and of lost heights. Plants of parts and stems have a layer of rests once one of them does not
/// rest upright. Stems of two modes have a layer of second modes.
///
/// If plants follow prototypes, a texel has the number of its prototype and its delay instead. Each species then has 16
/// layers for the history of its prototypes and one for pushed plants. It has as many more for second modes if its
/// stems have two.
class PoseTexture {
public:
	static constexpr int SIDE = 64;
	static constexpr int MAX_LAYERS = 2048; ///< Maximum of graphics cards.
	static constexpr int PAIRS_PER_LAYER = SIDE * SIDE;

	/// For a simulation with or without prototypes.
	explicit PoseTexture(bool follows_prototypes);
	~PoseTexture();
	PoseTexture(const PoseTexture &) = delete;
	PoseTexture &operator=(const PoseTexture &) = delete;

	/// Gives a page rows for `plants` plants, and does nothing if its rows are enough. On any thread, not concurrently.
	void give_rows(int page, int plants);
	void take_rows(int page);
	/// Removes the page, but does not release its rows. Multimeshes that use them draw nothing.
	void leave_rows(int page);
	/// Reserves rows for `plants` plants of a future page, until release(). release() of no rows does nothing.
	TexelRows reserve(int plants) { return find_rows((plants + SIDE - 1) / SIDE); }
	void release(const TexelRows &rows);
	/// Adds layers for about `row_count` more rows, up to the maximum of graphics cards.
	void make_room(double row_count);
	/// Gives reserved rows to their page.
	void give_reserved(int page, const TexelRows &rows);
	/// Adds layers for the history of all species of a simulation, for their present number of modes.
	void give_history(const FieldSimulation &simulation);
	/// True if layers remain for the history of another species.
	bool has_room_for_species() const;
	/// True if it needs more layers than graphics cards have.
	bool is_too_large() const;
	/// Location of a page's plants for the shader.
	PoseTexels texels(const PageRows &plants) const;
	int layer_of(int page) const { return pages[size_t(page)].rows.layer; }

	/// Copies the bends of a page of the simulation, if it has rows. On any thread, concurrently for different pages.
	void write_page(const FieldSimulation &simulation, int page);
	void write_pages(const FieldSimulation &simulation);
	/// The same in two parts: will_write() of all pages on one thread, then write_bends() on any, of plants that swing.
	void will_write(int page);
	void write_bends(const FieldSimulation &simulation, int page);
	/// Copies the newest slot of each species' history, or all slots, and the bends of its pushed plants.
	void write_history(const FieldSimulation &simulation, bool all);
	/// Copies all slots of one species.
	void write_history_of(const FieldSimulation &simulation, int species);

	/// Copies the rest directions of a page's plants, and adds a layer for second modes. Call it on one thread before
	/// the plants are first drawn, and after a species changes.
	void write_beside(const FieldSimulation &simulation, int page);
	/// Adds only a layer for second modes, if the page steps them now. Call it before they are written.
	void give_seconds(const FieldSimulation &simulation, int page);

	/// Sets the drawn height of a plant, as a fraction of its full height.
	void set_height(int page, int row, float share);
	/// True if set_height() ever reduced a height.
	bool has_heights() const { return draws_heights; }

	/// Hides this plant.
	void hide(int page, int row);
	/// Shows it again after the next write_page().
	void show(int page, int row);

	/// Main thread from here on. Creates the textures if they are missing or have too few layers. Returns true if it
	/// did.
	bool make_textures();
	/// Uploads what was written since the last call, and the blends for `fraction` of a step.
	void upload(const FieldSimulation &simulation, float fraction);
	godot::RID poses() const { return texture; }
	godot::RID blends() const { return blend_texture; }
	godot::RID beats() const { return beat_texture; }
	/// First layer of a species' history of a mode, or -1.
	int history_layer(int species, int mode) const;
	bool follows() const { return follows_prototypes; }

private:
	static constexpr int SPARE_LAYERS = 2; ///< Reserve for added plants, so that they seldom need another texture.
	static constexpr size_t BEAT_FLOATS = 4; ///< Per row: 1 / rate_time(), layers of rests, second modes and heights.
	static constexpr size_t TEXEL_BYTES = 2 * sizeof(Bend);
	static constexpr uint64_t ALL_ROWS = ~uint64_t(0); ///< Of a layer.
	using Rows = TexelRows;
	struct Page {
		Rows rows;
		float rate_time = -1.0f; ///< s, the uploaded FieldSimulation::rate_time().
		bool has_seconds = false; ///< As uploaded.
		std::vector<uint16_t> hidden; ///< Rows of removed plants and of plants that skeletons show.
	};

	const bool follows_prototypes;
	std::vector<godot::Ref<godot::Image>> layers;
	std::vector<uint64_t> free_rows; ///< By layer: a bit for each row.
	std::vector<uint8_t> is_dirty; ///< By layer: written and not uploaded.
	std::vector<Page> pages; ///< By page number of the simulation.
	struct BlendRows {
		int first = 0; ///< In `shares`.
		int count = 0; ///< 0: the page has no rows.
		float share = -1.0f; ///< The uploaded blend.
	};
	std::vector<BlendRows> blends_sent; ///< As many. Separate, because each frame reads all of them.
	bool has_new_rows = false; ///< Some pages' beats are not uploaded.
	int64_t sent_rates = -1; ///< FieldSimulation::rates_version() of the uploaded beats.
	using History = std::array<int, MAX_STEM_MODES>; ///< By mode: its first layer, or -1.
	std::vector<History> histories; ///< By species.
	godot::Ref<godot::Image> blend_image;
	std::vector<float> shares; ///< Contents of `blend_image`.
	godot::Ref<godot::Image> beat_image;
	std::vector<float> beats_sent; ///< Contents of `beat_image`.
	struct Beside { ///< Additional layers of a layer's plants, or -1.
		int rests = -1;
		int seconds = -1;
		int heights = -1;
	};
	bool draws_heights = false;
	std::vector<Beside> besides; ///< By layer; may be shorter.
	godot::RID texture;
	godot::RID blend_texture;
	godot::RID beat_texture;
	size_t textured_layers = 0;

	int add_layer(bool is_shared);
	int find_layer();
	/// Number of layers at the end without plants.
	int count_spare_layers() const;
	/// Returns the first of `count` consecutive layers for a history.
	int take_layers(int count);
	Rows find_rows(int count);
	void add_pages(int page);
	void take_as_new(int page, const Rows &rows);
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
	/// Creates one of them, of zeros, if it is missing and graphics cards have room. Returns its number or -1.
	int add_beside(int layer, int Beside::*which);
	void write_rests(const FieldSimulation &simulation, int page);
	void free_textures();
};

} // namespace undergrowth
