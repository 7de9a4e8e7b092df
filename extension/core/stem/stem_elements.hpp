#pragma once

#include "stem/stem_line.hpp"

#include <array>

namespace undergrowth {

/// A deflection along a stem by its values (m) and slopes (m per x) at the ends of its elements, the root's left away:
/// two for each element, with a cubic curve between (Hermite).
class StemCurve {
public:
	static constexpr int ELEMENTS = 32;
	static constexpr int SIZE = 2 * ELEMENTS;

	std::array<double, SIZE> values = {};

	double &operator[](int i) { return values[i]; }
	double operator[](int i) const { return values[i]; }
	void add(const StemCurve &other, double factor);
	void scale(double factor);
	double dot(const StemCurve &other) const;

	/// m, at x from 0 to 1.
	double deflection(double x) const;
	/// m: d/dx; over the stem's length it is the slope.
	double slope(double x) const;
};

/// Symmetric band matrix: only neighbouring elements couple, so three diagonals on each side of the main one.
class StemMatrix {
public:
	static constexpr int BAND = 3;

	/// To the entry (row, column); entries of the root, which have a negative row or column, are left away.
	void add(int row, int column, double value);
	/// factor · this + other_factor · other.
	StemMatrix mixed(double factor, const StemMatrix &other, double other_factor) const;
	StemCurve times(const StemCurve &curve) const;
	double at(int row, int column) const { return rows[row][column - row + BAND]; }

private:
	double rows[StemCurve::SIZE][2 * BAND + 1] = {};
};

/// The factors of a positive definite matrix (Cholesky).
class StemFactors {
public:
	explicit StemFactors(const StemMatrix &matrix);

	/// Whether the matrix is positive definite; only then solve().
	bool is_sound() const { return sound; }
	StemCurve solve(const StemCurve &right) const;

private:
	double lower[StemCurve::SIZE][StemMatrix::BAND + 1] = {}; ///< The last of a row is on the diagonal.
	bool sound = true;
};

/// The linear beam as finite elements.
struct StemElements {
	explicit StemElements(const StemLine &line);

	StemMatrix stiffness; ///< m: for a Young's modulus of 1 Pa.
	StemMatrix mass; ///< kg.
	StemMatrix gravity; ///< N/m: what the weight takes from the stiffness.
};

/// Generalised load of one unit, for each value of a curve.
StemCurve load_of(const StemLine &line, const StemSpread &spread, double head);

/// value · right · curve = left · curve, with the smallest value that is not `before`'s.
struct StemEigen {
	double value;
	StemCurve curve; ///< curveᵀ · right · curve = 1.
};
StemEigen smallest_eigen(const StemFactors &left, const StemMatrix &right, const StemCurve *before = nullptr);

} // namespace undergrowth
