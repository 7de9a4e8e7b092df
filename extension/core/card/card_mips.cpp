#include "card/card_mips.hpp"

#include "mesh/silhouette.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

namespace undergrowth {

namespace {

constexpr float THRESHOLD = 0.5f; // Of the alpha in materials.
constexpr int BINS = 256; // Of alphas.
constexpr int FINER = 3; // Points along a texel at which its coverage is measured.
constexpr int CELL = 8; // Texels. Thresholds are measured in squares of two cells.
constexpr float INEXACT = 0.04f; // Of the covered area.
constexpr float MIN_MEAN = 0.02f; // Linear light.
constexpr float DARKEST = 0.45f; // Occlusion.
constexpr float SHADE = 1.2f; // Occlusion per depth, in half-widths of the card.
constexpr int SHADE_REACH = 3; // Texels.

/// One mipmap: sums of texels, weighted by their coverage.
struct Mip {
	int width, height;
	std::vector<float> coverage;
	std::vector<glm::vec3> light; ///< Premultiplied, as are the following ones.
	std::vector<glm::vec4> surface;

	Mip(int p_width, int p_height) :
			width(p_width),
			height(p_height),
			coverage(size()),
			light(size(), glm::vec3(0.0f)),
			surface(size(), glm::vec4(0.0f)) {}
	size_t size() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }
	size_t at(int x, int y) const {
		return static_cast<size_t>(std::clamp(y, 0, height - 1)) * static_cast<size_t>(width) +
				static_cast<size_t>(std::clamp(x, 0, width - 1));
	}
};

/// Brightness of each texel: deep texels are in the shade of their neighbours.
std::vector<float> occlusion_of(const CardPicture &picture) {
	std::vector<float> open(picture.texels.size(), 1.0f);
	double sum = 0.0, weight = 0.0;
	for (int y = 0; y < picture.height; y++) {
		for (int x = 0; x < picture.width; x++) {
			const size_t at = static_cast<size_t>(y * picture.width + x);
			const CardTexel &own = picture.texels[at];
			float above = 0.0f, near = 1e-6f;
			for (int i = -SHADE_REACH; i <= SHADE_REACH && own.coverage > 0.0f; i++) {
				for (int k = -SHADE_REACH; k <= SHADE_REACH; k++) {
					const int row = std::clamp(y + i, 0, picture.height - 1);
					const int column = std::clamp(x + k, 0, picture.width - 1);
					const CardTexel &other = picture.texels[static_cast<size_t>(row * picture.width + column)];
					above += other.coverage * std::max(other.depth - own.depth, 0.0f);
					near += 1.0f;
				}
			}
			open[at] = std::max(1.0f - SHADE * above / (near * picture.box.half), DARKEST);
			sum += static_cast<double>(open[at] * own.coverage);
			weight += static_cast<double>(own.coverage);
		}
	}
	const float mean = weight > 0.0 ? static_cast<float>(sum / weight) : 1.0f;
	for (float &one : open) {
		one /= mean;
	}
	return open;
}

Mip first_mip(const CardPicture &picture) {
	Mip mip(picture.width, picture.height);
	const std::vector<float> open = occlusion_of(picture);
	for (size_t i = 0; i < picture.texels.size(); i++) {
		const CardTexel &texel = picture.texels[i];
		mip.coverage[i] = texel.coverage;
		mip.light[i] = texel.light * texel.coverage;
		mip.surface[i] = glm::vec4(texel.normal, open[i], texel.leafiness) * texel.coverage;
	}
	return mip;
}

Mip halved(const Mip &fine) {
	Mip mip(std::max(fine.width / 2, 1), std::max(fine.height / 2, 1));
	const int wide = fine.width / mip.width;
	const int high = fine.height / mip.height;
	const float share = 1.0f / static_cast<float>(wide * high);
	for (int y = 0; y < mip.height; y++) {
		for (int x = 0; x < mip.width; x++) {
			const size_t to = mip.at(x, y);
			for (int i = 0; i < wide * high; i++) {
				const size_t from = fine.at(x * wide + i % wide, y * high + i / wide);
				mip.coverage[to] += fine.coverage[from] * share;
				mip.light[to] += fine.light[from] * share;
				mip.surface[to] += fine.surface[from] * share;
			}
		}
	}
	return mip;
}

/// Coverage as the engine interpolates it, at FINER² points of each texel, row by row. As bins.
std::vector<uint16_t> interpolate(const Mip &mip) {
	std::vector<uint16_t> points;
	points.reserve(FINER * FINER * mip.size());
	for (int y = 0; y < FINER * mip.height; y++) {
		for (int x = 0; x < FINER * mip.width; x++) {
			const float place_x = (static_cast<float>(x) + 0.5f) / FINER - 0.5f;
			const float place_y = (static_cast<float>(y) + 0.5f) / FINER - 0.5f;
			const int left = static_cast<int>(std::floor(place_x));
			const int upper = static_cast<int>(std::floor(place_y));
			const float t = place_x - static_cast<float>(left);
			const float s = place_y - static_cast<float>(upper);
			const float one =
					mip.coverage[mip.at(left, upper)] * (1.0f - t) + mip.coverage[mip.at(left + 1, upper)] * t;
			const float other =
					mip.coverage[mip.at(left, upper + 1)] * (1.0f - t) + mip.coverage[mip.at(left + 1, upper + 1)] * t;
			points.push_back(static_cast<uint16_t>((one * (1.0f - s) + other * s) * BINS));
		}
	}
	return points;
}

/// Numbers of points by bin.
using Histogram = std::array<int, BINS + 1>;

/// Returns the threshold that cuts out this number of points: of all such thresholds the one nearest to `usual`.
float threshold_for(const Histogram &bins, float wanted, float usual) {
	const int most = static_cast<int>(wanted * (1.0f + INEXACT));
	const int least = static_cast<int>(wanted * (1.0f - INEXACT));
	int sum = 0, low = BINS, high = BINS;
	for (int bin = BINS; bin > 0 && sum + bins[static_cast<size_t>(bin)] <= most; bin--) {
		sum += bins[static_cast<size_t>(bin)];
		low = bin - 1;
		high = sum <= least ? low : high;
	}
	const float finest = 0.5f / BINS;
	return std::clamp(usual, static_cast<float>(low) / BINS + finest, static_cast<float>(high) / BINS + finest);
}

/// Thresholds that cut out as much of each part of a picture as it covers. With a single threshold, dense parts would
/// close and sparse ones vanish.
class Thresholds {
public:
	explicit Thresholds(const Mip &p_mip) :
			mip(p_mip), columns((mip.width + CELL - 1) / CELL), rows((mip.height + CELL - 1) / CELL) {
		std::vector<Histogram> cells(static_cast<size_t>(columns * rows), Histogram{});
		std::vector<float> wanted(cells.size(), 0.0f);
		const std::vector<uint16_t> points = interpolate(mip);
		for (int y = 0; y < FINER * mip.height; y++) {
			for (int x = 0; x < FINER * mip.width; x++) {
				const size_t cell = cell_at(x / (FINER * CELL), y / (FINER * CELL));
				cells[cell][points[static_cast<size_t>(y * FINER * mip.width + x)]]++;
				wanted[cell] += mip.coverage[mip.at(x / FINER, y / FINER)];
			}
		}
		for (int row = 0; row <= rows; row++) {
			for (int column = 0; column <= columns; column++) {
				Histogram sum = {};
				float all = 0.0f;
				for (int i = 0; i < 4; i++) {
					const int x = column - i % 2;
					const int y = row - i / 2;
					if (x >= 0 && x < columns && y >= 0 && y < rows) {
						const Histogram &own = cells[cell_at(x, y)];
						std::transform(own.begin(), own.end(), sum.begin(), sum.begin(), std::plus<int>());
						all += wanted[cell_at(x, y)];
					}
				}
				at_corners.push_back(threshold_for(sum, all, THRESHOLD));
			}
		}
	}

	/// Interpolated between the corners of cells.
	float at(int x, int y) const {
		const float place_x = (static_cast<float>(x) + 0.5f) / CELL;
		const float place_y = (static_cast<float>(y) + 0.5f) / CELL;
		const int column = static_cast<int>(place_x);
		const int row = static_cast<int>(place_y);
		const float t = place_x - static_cast<float>(column);
		const float s = place_y - static_cast<float>(row);
		const float one = corner(column, row) * (1.0f - t) + corner(column + 1, row) * t;
		const float other = corner(column, row + 1) * (1.0f - t) + corner(column + 1, row + 1) * t;
		return one * (1.0f - s) + other * s;
	}

private:
	const Mip &mip;
	const int columns;
	const int rows;
	std::vector<float> at_corners;

	size_t cell_at(int x, int y) const { return static_cast<size_t>(y * columns + x); }
	float corner(int column, int row) const { return at_corners[static_cast<size_t>(row * (columns + 1) + column)]; }
};

/// Replaces coverages by alphas of which THRESHOLD cuts out as much.
void write_alphas(Mip &mip, float share) {
	const Thresholds thresholds(mip);
	for (int y = 0; y < mip.height; y++) {
		for (int x = 0; x < mip.width; x++) {
			float &own = mip.coverage[mip.at(x, y)];
			own = std::min(own * THRESHOLD / thresholds.at(x, y), 1.0f);
		}
	}
	Histogram bins = {};
	for (const uint16_t point : interpolate(mip)) {
		bins[point]++;
	}
	const float wanted = share * static_cast<float>(FINER * FINER) * static_cast<float>(mip.size());
	const float scale = THRESHOLD / threshold_for(bins, wanted, THRESHOLD);
	for (float &own : mip.coverage) {
		own *= scale;
	}
}

uint8_t byte_of(float value) {
	return static_cast<uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

/// Fills texels that are not covered from the coarser mipmaps.
void fill_holes(std::vector<Mip> &mips) {
	for (size_t level = mips.size(); level-- > 0;) {
		Mip &mip = mips[level];
		for (int y = 0; y < mip.height; y++) {
			for (int x = 0; x < mip.width; x++) {
				const size_t at = mip.at(x, y);
				if (mip.coverage[at] > 0.0f) {
					mip.light[at] *= 1.0f / mip.coverage[at];
					mip.surface[at] *= 1.0f / mip.coverage[at];
				} else if (level + 1 < mips.size()) {
					const Mip &coarse = mips[level + 1];
					const size_t from = coarse.at(x * coarse.width / mip.width, y * coarse.height / mip.height);
					mip.light[at] = coarse.light[from];
					mip.surface[at] = coarse.surface[from];
				}
			}
		}
	}
}

std::vector<Mip> mips_of(const CardPicture &picture) {
	std::vector<Mip> mips = { first_mip(picture) };
	while (mips.back().size() > 1) {
		mips.push_back(halved(mips.back()));
	}
	return mips;
}

/// `mean`: linear light that the colours are relative to.
void write_layer(std::vector<Mip> &mips, const glm::vec3 &mean, CardLayer &layer) {
	const std::vector<float> &finest = mips.front().coverage;
	const float share = std::accumulate(finest.begin(), finest.end(), 0.0f) / static_cast<float>(finest.size());
	fill_holes(mips);
	for (Mip &mip : mips) {
		write_alphas(mip, share);
		for (size_t i = 0; i < mip.size(); i++) {
			const glm::vec3 light = mip.light[i] / glm::max(mean, glm::vec3(MIN_MEAN));
			for (int k = 0; k < 3; k++) {
				layer.colors.push_back(byte_of(0.5f * std::sqrt(std::max(light[k], 0.0f))));
			}
			layer.colors.push_back(byte_of(mip.coverage[i]));
			const glm::vec4 &surface = mip.surface[i];
			layer.surfaces.push_back(byte_of(0.5f + 0.5f * surface.x));
			layer.surfaces.push_back(byte_of(0.5f + 0.5f * surface.y));
			layer.surfaces.push_back(byte_of(0.5f * surface.z));
			layer.surfaces.push_back(byte_of(surface.w));
		}
	}
}

} // namespace

void write_layers(const std::vector<CardPicture> &pictures, const std::vector<CardLayer *> &layers) {
	std::vector<std::vector<Mip>> all;
	glm::vec3 light(0.0f);
	float leafiness = 0.0f, covered = 0.0f;
	for (const CardPicture &picture : pictures) {
		all.push_back(mips_of(picture));
		const Mip &last = all.back().back();
		light += last.light[0];
		leafiness += last.surface[0].w;
		covered += last.coverage[0];
	}
	const float share = covered > 0.0f ? 1.0f / covered : 0.0f;
	for (size_t i = 0; i < layers.size(); i++) {
		layers[i]->color = { from_light(light.x * share), from_light(light.y * share), from_light(light.z * share),
			1.0f };
		layers[i]->leafiness = leafiness * share;
		write_layer(all[i], light * share, *layers[i]);
	}
}

} // namespace undergrowth
