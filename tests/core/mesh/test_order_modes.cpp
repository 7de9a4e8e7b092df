// Modes of branched beams beside chains of finite elements.

#include "conventions.hpp"
#include "mesh/order_modes.hpp"

#include "../figures.hpp"
#include "../form/form_species.hpp"
#include "mesh/branch_frequencies.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace undergrowth;

namespace {

/// A straight beam in a plane, fixed to its carrier.
struct FrameBeam {
	int carrier; ///< -1: the fixed base.
	double offset; ///< On the carrier; a whole number of its elements.
	double turn; ///< rad from upright.
	double length; ///< m.
	double mass; ///< kg.
	double stiffness; ///< N·m², EI.
	int elements;
};

using Frame = std::vector<FrameBeam>;
using Matrix = std::vector<std::vector<double>>;

constexpr int FREEDOMS = 3; // x, y and turn of a node.
constexpr double STRETCH = 1e5; // Stiffness along a beam of one metre over that across.

/// Node of a beam; node 0 is the fixed base.
size_t node_of(const std::vector<std::vector<size_t>> &nodes, size_t beam, double offset) {
	const double at = offset * static_cast<double>(nodes[beam].size() - 1);
	return nodes[beam][static_cast<size_t>(std::lround(at))];
}

/// Adds an element of Euler and Bernoulli with consistent mass (Cook et al., ch. 2 and 11).
void add_element(Matrix &stiffness, Matrix &mass, size_t from, size_t to, double turn, double length, double ei,
		double kilograms) {
	const double l = length;
	const double bend = ei / (l * l * l);
	const double pull = STRETCH * ei / l;
	const double m = kilograms / 420.0;
	// Along, across and turn of both ends.
	const double k[6][6] = { { pull, 0, 0, -pull, 0, 0 }, { 0, 12 * bend, 6 * bend * l, 0, -12 * bend, 6 * bend * l },
		{ 0, 6 * bend * l, 4 * bend * l * l, 0, -6 * bend * l, 2 * bend * l * l }, { -pull, 0, 0, pull, 0, 0 },
		{ 0, -12 * bend, -6 * bend * l, 0, 12 * bend, -6 * bend * l },
		{ 0, 6 * bend * l, 2 * bend * l * l, 0, -6 * bend * l, 4 * bend * l * l } };
	const double c[6][6] = { { 140 * m, 0, 0, 70 * m, 0, 0 }, { 0, 156 * m, 22 * l * m, 0, 54 * m, -13 * l * m },
		{ 0, 22 * l * m, 4 * l * l * m, 0, 13 * l * m, -3 * l * l * m }, { 70 * m, 0, 0, 140 * m, 0, 0 },
		{ 0, 54 * m, 13 * l * m, 0, 156 * m, -22 * l * m },
		{ 0, -13 * l * m, -3 * l * l * m, 0, -22 * l * m, 4 * l * l * m } };
	const double sine = std::sin(turn), cosine = std::cos(turn);
	double t[6][6] = {}; // Own axes of the plane's.
	for (size_t end = 0; end < 6; end += 3) {
		t[end][end] = sine;
		t[end][end + 1] = cosine;
		t[end + 1][end] = -cosine;
		t[end + 1][end + 1] = sine;
		t[end + 2][end + 2] = 1.0;
	}
	const auto freedom = [&](size_t i) { return FREEDOMS * (i < 3 ? from : to) + i % 3; };
	for (size_t i = 0; i < 6; i++) {
		for (size_t j = 0; j < 6; j++) {
			for (size_t a = 0; a < 6; a++) {
				for (size_t b = 0; b < 6; b++) {
					stiffness[freedom(i)][freedom(j)] += t[a][i] * k[a][b] * t[b][j];
					mass[freedom(i)][freedom(j)] += t[a][i] * c[a][b] * t[b][j];
				}
			}
		}
	}
}

/// Solves L·Lᵀ·x = b in place.
void solve(const Matrix &factor, std::vector<double> &x) {
	const size_t n = x.size();
	for (size_t i = 0; i < n; i++) {
		for (size_t j = 0; j < i; j++) {
			x[i] -= factor[i][j] * x[j];
		}
		x[i] /= factor[i][i];
	}
	for (size_t i = n; i-- > 0;) {
		for (size_t j = i + 1; j < n; j++) {
			x[i] -= factor[j][i] * x[j];
		}
		x[i] /= factor[i][i];
	}
}

Matrix cholesky(Matrix a) {
	for (size_t i = 0; i < a.size(); i++) {
		for (size_t j = 0; j <= i; j++) {
			double sum = a[i][j];
			for (size_t k = 0; k < j; k++) {
				sum -= a[i][k] * a[j][k];
			}
			a[i][j] = i == j ? std::sqrt(sum) : sum / a[j][j];
		}
	}
	return a;
}

double dot(const std::vector<double> &a, const std::vector<double> &b) {
	double sum = 0.0;
	for (size_t i = 0; i < a.size(); i++) {
		sum += a[i] * b[i];
	}
	return sum;
}

std::vector<double> times(const Matrix &a, const std::vector<double> &x) {
	std::vector<double> all;
	for (const std::vector<double> &row : a) {
		all.push_back(dot(row, x));
	}
	return all;
}

/// The `count` lowest frequencies (Hz), by inverse iteration.
std::vector<double> frequencies_of(const Frame &frame, size_t count) {
	std::vector<std::vector<size_t>> nodes;
	size_t last = 0;
	for (const FrameBeam &beam : frame) {
		nodes.push_back({ beam.carrier < 0 ? 0 : node_of(nodes, static_cast<size_t>(beam.carrier), beam.offset) });
		for (int i = 0; i < beam.elements; i++) {
			nodes.back().push_back(++last);
		}
	}
	const size_t whole = FREEDOMS * (last + 1);
	Matrix stiffness(whole, std::vector<double>(whole, 0.0));
	Matrix mass = stiffness;
	for (size_t beam = 0; beam < frame.size(); beam++) {
		const FrameBeam &own = frame[beam];
		for (int i = 0; i < own.elements; i++) {
			const size_t at = static_cast<size_t>(i);
			add_element(stiffness, mass, nodes[beam][at], nodes[beam][at + 1], own.turn, own.length / own.elements,
					own.stiffness, own.mass / own.elements);
		}
	}
	for (Matrix *one : { &stiffness, &mass }) { // Without the fixed base.
		one->erase(one->begin(), one->begin() + FREEDOMS);
		for (std::vector<double> &row : *one) {
			row.erase(row.begin(), row.begin() + FREEDOMS);
		}
	}
	const Matrix factor = cholesky(stiffness);
	std::vector<std::vector<double>> found;
	std::vector<double> all;
	for (size_t mode = 0; mode < count; mode++) {
		std::vector<double> x(mass.size());
		for (size_t i = 0; i < x.size(); i++) {
			x[i] = std::sin(1.0 + 2.3 * static_cast<double>((mode + 1) * i));
		}
		double square = 0.0;
		for (int i = 0; i < 400; i++) {
			for (const std::vector<double> &other : found) {
				const double share = dot(other, times(mass, x));
				for (size_t k = 0; k < x.size(); k++) {
					x[k] -= share * other[k];
				}
			}
			std::vector<double> next = times(mass, x);
			const double size = std::sqrt(dot(x, next));
			for (size_t k = 0; k < x.size(); k++) {
				x[k] /= size;
				next[k] /= size;
			}
			square = dot(x, times(stiffness, x));
			if (i == 399) {
				break;
			}
			x = next;
			solve(factor, x);
		}
		found.push_back(x);
		all.push_back(std::sqrt(square) / (2.0 * PI));
	}
	std::sort(all.begin(), all.end());
	return all;
}

/// Frequency of one beam on a fixed base, with what it carries rigid.
double own_frequency(const Frame &frame, size_t beam) {
	constexpr double RIGID = 1e4;
	Frame alone;
	std::vector<int> places(frame.size(), -1);
	for (size_t i = beam; i < frame.size(); i++) {
		const bool is_carried = frame[i].carrier >= 0 && places[static_cast<size_t>(frame[i].carrier)] >= 0;
		if (i != beam && !is_carried) {
			continue;
		}
		places[i] = static_cast<int>(alone.size());
		alone.push_back(frame[i]);
		alone.back().carrier = i == beam ? -1 : places[static_cast<size_t>(frame[i].carrier)];
		alone.back().stiffness *= i == beam ? 1.0 : RIGID;
	}
	return frequencies_of(alone, 1).front();
}

glm::vec2 way_of(const FrameBeam &beam) {
	return glm::vec2(static_cast<float>(std::sin(beam.turn)), static_cast<float>(std::cos(beam.turn)));
}

std::vector<BranchBeam> beams_of(const Frame &frame) {
	std::vector<BranchBeam> beams;
	for (size_t i = 0; i < frame.size(); i++) {
		const glm::vec2 way = way_of(frame[i]);
		BranchBeam beam;
		beam.carrier = frame[i].carrier;
		beam.offset = static_cast<float>(frame[i].offset);
		if (beam.carrier >= 0) {
			const BranchBeam &on = beams[static_cast<size_t>(beam.carrier)];
			beam.base = on.base + beam.offset * on.way;
		}
		beam.way = static_cast<float>(frame[i].length) * glm::vec3(way, 0.0f);
		beam.side = { way.y, -way.x, 0.0f };
		beam.mass = static_cast<float>(frame[i].mass);
		beam.frequency = static_cast<float>(own_frequency(frame, i));
		beams.push_back(beam);
	}
	return beams;
}

/// A stem with three branches of two twigs each. `heavy`: factor of the mass of twigs.
Frame branched(double heavy) {
	Frame frame = { { -1, 0.0, 0.0, 1.0, 0.1, 1.3, 10 } };
	const std::array<double, 3> offsets = { 0.5, 0.8, 1.0 };
	for (size_t i = 0; i < offsets.size(); i++) {
		const double turn = i == 1 ? -0.9 : 0.7;
		const int branch = static_cast<int>(frame.size());
		frame.push_back({ 0, offsets[i], turn, 0.4, 0.012, 0.025, 5 });
		frame.push_back({ branch, 0.6, turn + 0.7, 0.15, 0.0015 * heavy, 0.0002 * heavy, 3 });
		frame.push_back({ branch, 1.0, turn - 0.5, 0.15, 0.0015 * heavy, 0.0002 * heavy, 3 });
	}
	return frame;
}

} // namespace

TEST_CASE("finite elements have the frequencies of an even cantilever") {
	const double square = 3.516015 * 3.516015 * 1.3 / 0.1;
	const Frame alone = { { -1, 0.0, 0.4, 1.0, 0.1, 1.3, 10 } };
	CHECK(frequencies_of(alone, 1).front() == doctest::Approx(std::sqrt(square) / (2.0 * PI)).epsilon(0.001));
}

TEST_CASE("modes of a stem with branches and twigs are those of a chain of finite elements") {
	for (const double heavy : { 0.25, 0.5, 1.0 }) {
		const Frame frame = branched(heavy);
		const std::vector<float> modes = find_branch_modes(beams_of(frame)).modes;
		const std::vector<double> exact = frequencies_of(frame, frame.size());
		REQUIRE(modes.size() == exact.size());
		for (size_t k = 0; k < modes.size(); k++) {
			CAPTURE(heavy);
			CAPTURE(exact[k]);
			const double error = std::abs(static_cast<double>(modes[k]) / exact[k] - 1.0);
			CHECK(error < 0.03);
			figures::record_error(figures::SWINGS, "modes of a stem with branches and twigs", 0.03, error);
		}
	}
}

TEST_CASE("what a branch carries makes it slower, and is faster on it than on a fixed base") {
	const std::vector<BranchBeam> beams = beams_of(branched(1.0));
	const BranchModes found = find_branch_modes(beams);
	CHECK(found.modes.front() < beams.front().frequency);
	CHECK(found.modes.back() > beams.back().frequency);
	for (const float frequency : found.of_beams) {
		CHECK(frequency >= found.modes.front());
		CHECK(frequency <= found.modes.back());
	}
}

TEST_CASE("branches without mass leave their stem its own frequency") {
	std::vector<BranchBeam> beams = beams_of(branched(1.0));
	for (size_t i = 1; i < beams.size(); i++) {
		beams[i].mass *= 1e-6f;
	}
	CHECK(find_branch_modes(beams).of_beams[0] == doctest::Approx(beams[0].frequency).epsilon(0.001));
}

TEST_CASE("branches of a shrub are slower than declared because their twigs swing") {
	const PlantForm form = grow_shrub(3);
	const std::vector<float> factors = branch_frequency_factors(form);
	for (size_t kind = 0; kind < form.parts.size(); kind++) {
		CAPTURE(form.parts[kind].frequency);
		const bool is_branch = form.parts[kind].frequency == 1.4f;
		CHECK((factors[kind] < 0.97f) == is_branch);
		CHECK((factors[kind] >= 1.0f) != is_branch);
	}
	for (const float factor : branch_frequency_factors(grow_tulip(3))) {
		CHECK(factor == 1.0f);
	}
}
