#include "mesh/order_modes.hpp"

#include "conventions.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr int PIECES = 12; // Of a beam, with the mass of each in its middle.
constexpr int MAX_SWEEPS = 30;
constexpr double SMALL = 1e-24; // Of the squared diagonal.

/// A symmetric matrix.
class Square {
public:
	explicit Square(size_t p_size) : size(p_size), values(p_size * p_size, 0.0) {}
	double &at(size_t i, size_t j) { return values[i * size + j]; }
	const size_t size;

private:
	std::vector<double> values;
};

/// Shape of a cantilever under an even load, 1 at the tip, and its slope: the first mode within 1 % of its frequency.
double shape_at(double s) {
	return s * s * (6.0 - 4.0 * s + s * s) / 3.0;
}

double slope_at(double s) {
	return 4.0 * s * (3.0 - 3.0 * s + s * s) / 3.0;
}

/// Displacement of a place by one coordinate.
struct Influence {
	size_t of;
	glm::dvec3 way;
};

/// Displacements of a place on a beam, by its own coordinate and those of the beams that carry it.
std::vector<Influence> influences_at(const std::vector<BranchBeam> &beams, size_t beam, double s) {
	std::vector<Influence> all;
	const glm::dvec3 place = glm::dvec3(beams[beam].base) + s * glm::dvec3(beams[beam].way);
	all.push_back({ beam, shape_at(s) * glm::dvec3(beams[beam].side) });
	for (size_t on = beam; beams[on].carrier >= 0; on = static_cast<size_t>(beams[on].carrier)) {
		const size_t carrier = static_cast<size_t>(beams[on].carrier);
		const glm::dvec3 way(beams[carrier].way);
		const glm::dvec3 side(beams[carrier].side);
		const double length = glm::length(way);
		const double offset = static_cast<double>(beams[on].offset);
		const glm::dvec3 turn = glm::cross(way / length, side) * (slope_at(offset) / length);
		all.push_back({ carrier, shape_at(offset) * side + glm::cross(turn, place - glm::dvec3(beams[on].base)) });
	}
	return all;
}

Square mass_of(const std::vector<BranchBeam> &beams) {
	Square mass(beams.size());
	for (size_t beam = 0; beam < beams.size(); beam++) {
		for (int piece = 0; piece < PIECES; piece++) {
			const std::vector<Influence> all = influences_at(beams, beam, (piece + 0.5) / PIECES);
			for (const Influence &one : all) {
				for (const Influence &other : all) {
					mass.at(one.of, other.of) +=
							static_cast<double>(beams[beam].mass) / PIECES * glm::dot(one.way, other.way);
				}
			}
		}
	}
	return mass;
}

/// Diagonalises a symmetric matrix by rotations (Jacobi); the columns of `ways` are its directions.
void diagonalise(Square &a, Square &ways) {
	const size_t n = a.size;
	for (size_t i = 0; i < n; i++) {
		ways.at(i, i) = 1.0;
	}
	for (int sweep = 0; sweep < MAX_SWEEPS; sweep++) {
		double off = 0.0;
		for (size_t i = 0; i < n; i++) {
			for (size_t j = i + 1; j < n; j++) {
				if (a.at(i, j) * a.at(i, j) <= SMALL * std::fabs(a.at(i, i) * a.at(j, j))) {
					continue;
				}
				off = 1.0;
				const double half = 0.5 * (a.at(j, j) - a.at(i, i)) / a.at(i, j);
				const double t = (half >= 0.0 ? 1.0 : -1.0) / (std::fabs(half) + std::sqrt(half * half + 1.0));
				const double c = 1.0 / std::sqrt(t * t + 1.0);
				const double s = t * c;
				for (size_t k = 0; k < n; k++) {
					const double x = a.at(k, i), y = a.at(k, j);
					a.at(k, i) = c * x - s * y;
					a.at(k, j) = s * x + c * y;
				}
				for (size_t k = 0; k < n; k++) {
					const double x = a.at(i, k), y = a.at(j, k);
					a.at(i, k) = c * x - s * y;
					a.at(j, k) = s * x + c * y;
					const double u = ways.at(k, i), v = ways.at(k, j);
					ways.at(k, i) = c * u - s * v;
					ways.at(k, j) = s * u + c * v;
				}
			}
		}
		if (off == 0.0) {
			return;
		}
	}
}

} // namespace

// The stiffness has no terms between beams, so with each coordinate in units of the root of its energy, the inverse
// squared frequencies are the eigenvalues of the mass.
BranchModes find_branch_modes(const std::vector<BranchBeam> &beams) {
	const size_t n = beams.size();
	Square mass = mass_of(beams);
	std::vector<double> stiffness(n);
	for (size_t i = 0; i < n; i++) {
		const double own = 2.0 * PI * static_cast<double>(beams[i].frequency);
		stiffness[i] = own * own * mass.at(i, i);
	}
	for (size_t i = 0; i < n; i++) {
		for (size_t j = 0; j < n; j++) {
			mass.at(i, j) /= std::sqrt(stiffness[i] * stiffness[j]);
		}
	}
	Square ways(n);
	diagonalise(mass, ways);
	BranchModes found;
	found.of_beams.assign(n, 0.0f);
	std::vector<double> shares(n, 0.0);
	for (size_t k = 0; k < n; k++) {
		const float frequency = static_cast<float>(1.0 / (2.0 * PI * std::sqrt(mass.at(k, k))));
		found.modes.push_back(frequency);
		for (size_t i = 0; i < n; i++) {
			if (const double share = ways.at(i, k) * ways.at(i, k); share > shares[i]) {
				shares[i] = share;
				found.of_beams[i] = frequency;
			}
		}
	}
	std::sort(found.modes.begin(), found.modes.end());
	return found;
}

} // namespace undergrowth
