#include "motion/lasting_bends.hpp"

#include "base/portable_math.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

float Trampling::approach(float seconds) const {
	if (share >= 1.0f) {
		return 1.0f;
	}
	const double left = 1.0 - static_cast<double>(std::max(share, 0.0f));
	return static_cast<float>(1.0 - portable_pow(left, static_cast<double>(seconds / CONTACT)));
}

float Trampling::kept(float seconds) const {
	return static_cast<float>(portable_exp(-static_cast<double>(seconds / recovery)));
}

void LastingBends::make_room(int rows) {
	if (bends.empty() && rows > 0) {
		bends.resize(static_cast<std::size_t>(rows));
		blocks.assign(static_cast<std::size_t>((rows + BLOCK - 1) / BLOCK), 0);
		used = 0;
	}
}

void LastingBends::resize(int rows) {
	if (bends.empty()) {
		return;
	}
	bends.resize(static_cast<std::size_t>(rows));
	blocks.resize(static_cast<std::size_t>((rows + BLOCK - 1) / BLOCK));
	used = static_cast<int>(std::count(blocks.begin(), blocks.end(), uint8_t(1)));
}

bool LastingBends::is_any(int begin, int count) const {
	if (used == 0) {
		return false;
	}
	const auto end = blocks.begin() + (begin + count + BLOCK - 1) / BLOCK;
	return std::find(blocks.begin() + begin / BLOCK, end, uint8_t(1)) != end;
}

void LastingBends::use_block(int block, bool is_used) {
	uint8_t &now = blocks[static_cast<std::size_t>(block)];
	used += static_cast<int>(is_used) - static_cast<int>(now);
	now = is_used ? 1 : 0;
}

void LastingBends::set(int row, const glm::vec2 &bend) {
	if (bends.empty()) {
		return;
	}
	const float size = glm::length(bend);
	const bool is_none = !std::isfinite(size) || size < MIN;
	bends[static_cast<std::size_t>(row)] = is_none ? glm::vec2(0.0f) : bend * std::min(1.0f, MAX / size);
	if (!is_none) {
		use_block(row / BLOCK, true);
	}
}

void LastingBends::shrink(float share) {
	const int rows = static_cast<int>(bends.size());
	for (int block = 0; used > 0 && block < static_cast<int>(blocks.size()); block++) {
		if (blocks[static_cast<std::size_t>(block)] == 0) {
			continue;
		}
		bool is_used = false;
		for (int row = block * BLOCK; row < std::min((block + 1) * BLOCK, rows); row++) {
			glm::vec2 &bend = bends[static_cast<std::size_t>(row)];
			bend *= share;
			bend = glm::dot(bend, bend) < MIN * MIN ? glm::vec2(0.0f) : bend;
			is_used = is_used || bend != glm::vec2(0.0f);
		}
		use_block(block, is_used);
	}
}

} // namespace undergrowth
