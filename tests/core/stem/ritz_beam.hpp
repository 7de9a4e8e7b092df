#pragma once

#include "stems.hpp"

#include <array>
#include <cmath>

/// The two slowest frequencies of a beam by a method other than the product's: Ritz's, with polynomials over the whole
/// stem. It is within 1e-5 for round stems that taper, with a head and leaves, weight included.
class RitzBeam {
public:
	RitzBeam(const undergrowth::StemBeam &stem, double youngs_modulus) : beam(stem), modulus(youngs_modulus) {
		for (int n = 0; n < STEPS; n++) {
			add((n + 0.5) / STEPS, 1.0 / STEPS);
		}
		add_head();
		solve();
	}

	double frequency = 0.0; ///< rad/s.
	double second = 0.0; ///< rad/s.

private:
	static constexpr int COUNT = 18;
	static constexpr int STEPS = 4000;
	using Matrix = std::array<std::array<double, COUNT>, COUNT>;

	undergrowth::StemBeam beam;
	double modulus;
	Matrix stiff = {};
	Matrix heavy = {};

	/// x²·P(2x - 1), P Legendre's, with two derivatives.
	struct Basis {
		double value[COUNT];
		double slope[COUNT];
		double curvature[COUNT];

		explicit Basis(double x) {
			double p[COUNT] = { 1.0, 2.0 * x - 1.0 };
			double d[COUNT] = { 0.0, 2.0 };
			double e[COUNT] = {};
			for (int k = 2; k < COUNT; k++) {
				const double a = (2.0 * k - 1.0) / k;
				const double b = (k - 1.0) / k;
				p[k] = a * (2.0 * x - 1.0) * p[k - 1] - b * p[k - 2];
				d[k] = a * (2.0 * p[k - 1] + (2.0 * x - 1.0) * d[k - 1]) - b * d[k - 2];
				e[k] = a * (4.0 * d[k - 1] + (2.0 * x - 1.0) * e[k - 1]) - b * e[k - 2];
			}
			for (int k = 0; k < COUNT; k++) {
				value[k] = x * x * p[k];
				slope[k] = 2.0 * x * p[k] + x * x * d[k];
				curvature[k] = 2.0 * p[k] + 4.0 * x * d[k] + x * x * e[k];
			}
		}
	};

	double mass_per_x(double x) const {
		const double share = 1.0 - beam.taper * x;
		return beam.density * undergrowth::PI / 4.0 * beam.diameter * beam.diameter * share * share * beam.length +
				beam.leaf_mass;
	}

	double mass_above(double x) const {
		const double middle = 0.5 * (x + 1.0); // Simpson's rule is exact for squares.
		return (1.0 - x) / 6.0 * (mass_per_x(x) + 4.0 * mass_per_x(middle) + mass_per_x(1.0)) + beam.head_mass;
	}

	void add(double x, double dx) {
		const Basis basis(x);
		const double l = beam.length;
		const double share = 1.0 - beam.taper * x;
		const double bending = modulus * root_bending(beam) * share * share * share * share / (l * l * l);
		const double pull = undergrowth::STANDARD_GRAVITY * mass_above(x) / l;
		for (int i = 0; i < COUNT; i++) {
			for (int j = 0; j < COUNT; j++) {
				stiff[i][j] += dx *
						(bending * basis.curvature[i] * basis.curvature[j] - pull * basis.slope[i] * basis.slope[j]);
				heavy[i][j] += dx * mass_per_x(x) * basis.value[i] * basis.value[j];
			}
		}
	}

	void add_head() {
		const Basis basis(1.0);
		const double arm = beam.head_centre / beam.length;
		const double turn = beam.head_inertia / (beam.length * beam.length);
		const double pull = undergrowth::STANDARD_GRAVITY * beam.head_mass * arm / beam.length;
		for (int i = 0; i < COUNT; i++) {
			for (int j = 0; j < COUNT; j++) {
				const double both = basis.slope[i] * basis.slope[j];
				heavy[i][j] += turn * both +
						beam.head_mass * (basis.value[i] + arm * basis.slope[i]) *
								(basis.value[j] + arm * basis.slope[j]);
				stiff[i][j] -= pull * both;
			}
		}
	}

	/// Cholesky decomposition of the masses, then Jacobi rotations.
	void solve() {
		Matrix lower = {};
		for (int i = 0; i < COUNT; i++) {
			for (int j = 0; j <= i; j++) {
				double sum = heavy[i][j];
				for (int k = 0; k < j; k++) {
					sum -= lower[i][k] * lower[j][k];
				}
				lower[i][j] = i == j ? std::sqrt(sum) : sum / lower[j][j];
			}
		}
		Matrix m = transposed(divided(lower, transposed(divided(lower, stiff))));
		for (int sweep = 0; sweep < 30; sweep++) {
			for (int p = 0; p < COUNT; p++) {
				for (int q = p + 1; q < COUNT; q++) {
					turn(m, p, q);
				}
			}
		}
		double first = 1e300;
		double next = 1e300;
		for (int i = 0; i < COUNT; i++) {
			next = std::min(next, std::max(first, m[i][i]));
			first = std::min(first, m[i][i]);
		}
		frequency = std::sqrt(first);
		second = std::sqrt(next);
	}

	static Matrix divided(const Matrix &lower, Matrix m) {
		for (int i = 0; i < COUNT; i++) {
			for (int c = 0; c < COUNT; c++) {
				for (int k = 0; k < i; k++) {
					m[i][c] -= lower[i][k] * m[k][c];
				}
				m[i][c] /= lower[i][i];
			}
		}
		return m;
	}

	static Matrix transposed(const Matrix &m) {
		Matrix t;
		for (int i = 0; i < COUNT; i++) {
			for (int j = 0; j < COUNT; j++) {
				t[i][j] = m[j][i];
			}
		}
		return t;
	}

	static void turn(Matrix &m, int p, int q) {
		if (std::abs(m[p][q]) < 1e-300) {
			return;
		}
		const double angle = 0.5 * std::atan2(2.0 * m[p][q], m[q][q] - m[p][p]);
		const double c = std::cos(angle);
		const double s = std::sin(angle);
		for (int k = 0; k < COUNT; k++) {
			const double a = m[k][p];
			const double b = m[k][q];
			m[k][p] = c * a - s * b;
			m[k][q] = s * a + c * b;
		}
		for (int k = 0; k < COUNT; k++) {
			const double a = m[p][k];
			const double b = m[q][k];
			m[p][k] = c * a - s * b;
			m[q][k] = s * a + c * b;
		}
	}
};
