// A small rasterizer: silhouettes and mean colours of meshes from the side.

#include "form_mesh_fixture.hpp"
#include "mesh/shown_tone.hpp"

#include <algorithm>
#include <cmath>

using namespace undergrowth;

namespace {

struct Pixel {
	double depth = -1e9;
	glm::dvec3 light = glm::dvec3(0.0);
};

double to_linear(double s) {
	return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

struct Corner {
	glm::dvec3 at; ///< Pixels across and up, and depth.
	glm::dvec3 light;
};

double side_of(const glm::dvec3 &a, const glm::dvec3 &b, double x, double y) {
	return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

void draw(std::vector<Pixel> &picture, int pixels, const Corner (&t)[3]) {
	const double whole = side_of(t[0].at, t[1].at, t[2].at.x, t[2].at.y);
	if (whole == 0.0) {
		return;
	}
	const auto [left, right] = std::minmax({ t[0].at.x, t[1].at.x, t[2].at.x });
	const auto [low, high] = std::minmax({ t[0].at.y, t[1].at.y, t[2].at.y });
	for (int y = std::max(0, int(low)); y <= std::min(pixels - 1, int(high)); y++) {
		for (int x = std::max(0, int(left)); x <= std::min(pixels - 1, int(right)); x++) {
			double share[3];
			for (int i = 0; i < 3; i++) {
				share[i] = side_of(t[(i + 1) % 3].at, t[(i + 2) % 3].at, x + 0.5, y + 0.5) / whole;
			}
			if (share[0] < 0.0 || share[1] < 0.0 || share[2] < 0.0) {
				continue;
			}
			Pixel &pixel = picture[size_t(y * pixels + x)];
			const double depth = share[0] * t[0].at.z + share[1] * t[1].at.z + share[2] * t[2].at.z;
			if (depth > pixel.depth) {
				pixel = { depth, share[0] * t[0].light + share[1] * t[1].light + share[2] * t[2].light };
			}
		}
	}
}

double lab_part(double t) {
	return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
}

glm::dvec3 to_lab(const glm::dvec3 &c) {
	const double x = lab_part((0.4124 * c.x + 0.3576 * c.y + 0.1805 * c.z) / 0.9505);
	const double y = lab_part(0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z);
	const double z = lab_part((0.0193 * c.x + 0.1192 * c.y + 0.9505 * c.z) / 1.089);
	return { 116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z) };
}

} // namespace

Sight look_at(const BuiltForm &mesh, int side, double box, int pixels, double rise) {
	const double angle = side * 0.78539816339744831;
	const double c = std::cos(angle);
	const double s = std::sin(angle);
	const double scale = pixels / box;
	std::vector<Pixel> picture(size_t(pixels) * size_t(pixels));
	for (size_t i = 0; i < mesh.indices.size(); i += 3) {
		Corner corners[3];
		for (size_t k = 0; k < 3; k++) {
			const size_t vertex = size_t(mesh.indices[i + k]);
			const glm::dvec3 p = mesh.positions[vertex];
			const glm::dvec3 color = mesh.colors[vertex];
			const double near = s * p.x - c * p.z;
			const double up = p.y * std::cos(rise) - near * std::sin(rise);
			const int veins = int(mesh.custom0[vertex].z) + int(Venation::none);
			const double tone =
					double(tone_of(mesh.colors[vertex].w) * petal_tone(Venation(veins), mesh.uvs[vertex].y));
			corners[k] = { { (c * p.x + s * p.z + 0.5 * box) * scale, (up + 0.1 * box) * scale,
								   near * std::cos(rise) + p.y * std::sin(rise) },
				tone * glm::dvec3(to_linear(color.x), to_linear(color.y), to_linear(color.z)) };
		}
		draw(picture, pixels, corners);
	}
	Sight sight;
	for (const Pixel &pixel : picture) {
		if (pixel.depth > -1e9) {
			sight.area += 1.0;
			sight.light += pixel.light;
		}
	}
	sight.light /= std::max(sight.area, 1.0);
	sight.area /= scale * scale;
	return sight;
}

double color_distance(const glm::dvec3 &a, const glm::dvec3 &b) {
	const glm::dvec3 way = to_lab(a) - to_lab(b);
	return std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
}
