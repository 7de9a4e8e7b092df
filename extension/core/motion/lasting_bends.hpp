#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// Which part of a bend lasts, and how long; of a species.
struct Trampling {
	static constexpr float CONTACT = 0.5f; ///< s.
	float share = 0.0f; ///< 0 to 1: part of a bend that lasts after a body has held it for CONTACT.
	float recovery = 300.0f; ///< s, > 0: time in which a lasting bend falls to 37 %.
	float yield = 0.0f; ///< Bend of the tip from the lasting one beyond which everything lasts (lodging); 0: none.

	bool operator==(const Trampling &other) const {
		return share == other.share && recovery == other.recovery && yield == other.yield;
	}
	/// Part of the way to the present bend that a lasting bend goes in `seconds` of contact.
	float approach(float seconds) const;
	/// Part of a lasting bend that `seconds` leave.
	float kept(float seconds) const;
};

/// The lasting bends of a page's stems: bends that trodden plants return to in calm air, at the tip and in the frame of
/// their rest, as tip_bend(). Nothing is stored until make_room(). Only that and resize() allocate. One thread.
class LastingBends {
public:
	static constexpr int BLOCK = 64; ///< Rows.
	static constexpr float MIN = 2e-3f; ///< Shorter bends become 0: a quarter of a degree.
	static constexpr float MAX = 1.0f; ///< Longer bends are shortened: level with the ground.

	/// Reserves room for `rows` plants without lasting bends, if there is none.
	void make_room(int rows);
	/// Follows a page that has `rows` plants now. Does nothing without room.
	void resize(int rows);
	bool has_room() const { return !bends.empty(); }
	/// True if a bend within rows [begin, begin + count) may differ from 0. `begin`: a multiple of BLOCK.
	bool is_any(int begin, int count) const;
	bool is_any() const { return used > 0; }

	glm::vec2 at(int row) const { return bends.empty() ? glm::vec2(0.0f) : bends[static_cast<std::size_t>(row)]; }
	/// Sets a bend; an invalid one becomes 0. Does nothing without room.
	void set(int row, const glm::vec2 &bend);
	/// Multiplies all bends by `share`.
	void shrink(float share);

	std::size_t bytes() const { return bends.capacity() * sizeof(glm::vec2) + blocks.capacity(); }

private:
	std::vector<glm::vec2> bends; ///< By row.
	std::vector<uint8_t> blocks; ///< 1 for each block with a bend.
	int used = 0; ///< Number of these blocks.

	void use_block(int block, bool is_used);
};

} // namespace undergrowth
