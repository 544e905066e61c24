//! Two by two matrices: the propagation of a small disturbance (δx, δw) of the motion.

use crate::float::Float;

/// The matrix `[[a, b], [c, d]]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Matrix<F> {
    pub(crate) a: F,
    pub(crate) b: F,
    pub(crate) c: F,
    pub(crate) d: F,
}

/// The acceleration after a reversal divided by the acceleration before it, `|a|/(|a| + 2)` with a the
/// acceleration after: friction changes its sign, and nothing else changes. A quotient of the two
/// accelerations, each a difference of large terms, would contain the rounding of these terms.
#[inline]
pub(crate) fn reversal_ratio<F: Float>(after: F) -> F {
    after.abs() / (after.abs() + F::int(2))
}

/// A disturbance (δx, δw) after a slide, which is a free vibration. `rotation` contains the free vibrations from
/// (0, 1) and (1, 0) after the time of the slide, which are (sin φ, cos φ) without damping; `damping` is 2ζ.
#[inline]
pub(crate) fn freely<F: Float>((x, w): (F, F), (s, c): (F, F), damping: F) -> (F, F) {
    (c * x + s * w, (c - damping * s) * w - s * x)
}

impl<F: Float> Matrix<F> {
    pub(crate) fn identity() -> Self {
        let (zero, one) = (F::int(0), F::int(1));
        Self { a: one, b: zero, c: zero, d: one }
    }

    /// The disturbance after a slide ([`freely`]).
    #[inline]
    pub(crate) fn after_slide(self, rotation: (F, F), damping: F) -> Self {
        let (a, c) = freely((self.a, self.c), rotation, damping);
        let (b, d) = freely((self.b, self.d), rotation, damping);
        Self { a, b, c, d }
    }

    /// The disturbance after a velocity zero: δw is multiplied by the ratio of the accelerations after and
    /// before the zero, because the zero itself moves, and by 0 at a stop.
    #[inline]
    pub(crate) fn after_zero(self, ratio: F) -> Self {
        Self { c: ratio * self.c, d: ratio * self.d, ..self }
    }

    /// The disturbance after a release. If the body is released later by δθ = δx/(α cos θ), it has gained
    /// less velocity from its initial acceleration η − 1, so that `δw = −δx (η − 1)/(αΩ |cos θ|)`; `gain` is
    /// the factor of δx.
    #[inline]
    pub(crate) fn after_release(self, gain: F) -> Self {
        if gain == F::int(0) {
            return self;
        }
        Self { c: self.c - gain * self.a, d: self.d - gain * self.b, ..self }
    }

    /// This matrix with the opposite sign.
    pub(crate) fn negated(self) -> Self {
        Self { a: -self.a, b: -self.b, c: -self.c, d: -self.d }
    }

    pub(crate) fn determinant(self) -> F {
        self.a * self.d - self.b * self.c
    }

    pub(crate) fn trace(self) -> F {
        self.a + self.d
    }

    /// `det(1 − M)`.
    pub(crate) fn determinant_of_one_minus(self) -> F {
        F::int(1) - self.trace() + self.determinant()
    }

    /// `(1 + M)⁻¹`, or infinite or NaN entries where 1 + M is singular.
    #[inline]
    pub(crate) fn inverse_of_one_plus(self) -> Self {
        let one = F::int(1);
        let (a, d) = (one + self.a, one + self.d);
        let determinant = a * d - self.b * self.c;
        Self { a: d / determinant, b: -self.b / determinant, c: -self.c / determinant, d: a / determinant }
    }

    #[inline]
    pub(crate) fn times(self, (x, w): (F, F)) -> (F, F) {
        (self.a * x + self.b * w, self.c * x + self.d * w)
    }

    /// The absolute values of the entries.
    pub(crate) fn absolute(self) -> Self {
        Self { a: self.a.abs(), b: self.b.abs(), c: self.c.abs(), d: self.d.abs() }
    }

    /// The eigenvalues, each as (re, im), the larger first.
    pub(crate) fn eigenvalues(self) -> [(F, F); 2] {
        let (zero, two) = (F::int(0), F::int(2));
        let (half, det) = (self.trace() / two, self.determinant());
        let discriminant = half.square() - det;
        if discriminant < zero {
            let imaginary = (-discriminant).sqrt();
            return [(half, imaginary), (half, -imaginary)];
        }
        let larger = half + discriminant.sqrt().with_sign_of(half);
        let smaller = if larger == zero { zero } else { det / larger };
        [(larger, zero), (smaller, zero)]
    }

    /// The squares of the eigenvalues, each as (re, im), the larger first.
    ///
    /// The squares solve `μ² − (t² − 2δ) μ + δ² = 0` with t the trace and δ the determinant; the smaller real
    /// root comes from the product. Where t²/4 − δ does not exceed its rounding the root counts as double,
    /// |μ| = δ. The larger root therefore never exceeds that of a neighbouring matrix by more than a root of
    /// 8ε, relative, and is exactly δ where the two are complex.
    pub(crate) fn squared_eigenvalues(self) -> [(F, F); 2] {
        let (zero, two) = (F::int(0), F::int(2));
        let (t, det) = (self.trace(), self.determinant());
        let half = t / two;
        let discriminant = half.square() - det;
        if discriminant < zero {
            // λ = t/2 ± i √(δ − t²/4)
            let imaginary = (-discriminant).sqrt();
            let (re, im) = (half.square() - imaginary.square(), two * half.abs() * imaginary);
            return [(re, im), (re, -im)];
        }
        let rounding =
            F::int(8) * F::epsilon() * (half.square() + (self.a * self.d).abs() + (self.b * self.c).abs());
        if discriminant <= rounding {
            return [(det.abs(), zero), (det.abs(), zero)];
        }
        let larger = half.abs() + discriminant.sqrt();
        let smaller = if larger == zero { zero } else { det / larger };
        [(larger.square(), zero), (smaller.square(), zero)]
    }
}

#[cfg(test)]
mod tests {
    use super::Matrix;

    #[test]
    fn inverse_and_eigenvalues() {
        let m = Matrix { a: 0.3, b: -1.2, c: 0.5, d: 0.1 };
        let (x, w) = m.inverse_of_one_plus().times((0.7, -0.4));
        assert!((1.3 * x - 1.2 * w - 0.7f64).abs() < 1e-15 && (0.5 * x + 1.1 * w + 0.4f64).abs() < 1e-15);
        let [(re, im), (re2, im2)] = m.squared_eigenvalues();
        // The product of the multipliers is the squared determinant, and their sum the trace of the square.
        assert!((re * re2 - im * im2 - 0.63f64.powi(2)).abs() < 1e-15);
        assert!((re + re2 - (0.09 + 0.01 - 1.2f64)).abs() < 1e-15 && im == -im2);
        let real = Matrix { a: 0.5, b: 0.2, c: 0.1, d: -0.25 };
        let [(p, _), (q, _)] = real.squared_eigenvalues();
        assert!(
            (p * q - (0.125f64 + 0.02).powi(2)).abs() < 1e-16
                && (p + q - (0.25 + 0.0625 + 0.04f64)).abs() < 1e-15
        );
    }

    /// A double root is of the size of the determinant, whatever the rounding of the discriminant.
    #[test]
    fn a_double_root_keeps_its_digits() {
        let mut worst = 0.0f64;
        for i in 1..2000 {
            // A rotation, a velocity zero and a rotation: (1 + s)² cos² = 4s where the roots meet.
            let s = 0.2 + 0.8 * f64::from(i) / 2000.0;
            let sum = (2.0 * s.sqrt() / (1.0 + s)).acos();
            let before = 0.3 * sum;
            let rotated = |m: Matrix<f64>, angle: f64| m.after_slide(angle.sin_cos(), 0.0);
            let m = rotated(rotated(Matrix::identity(), before).after_zero(s), sum - before);
            let [(re, im), _] = m.squared_eigenvalues();
            worst = worst.max((re.hypot(im) / s - 1.0).abs());
        }
        assert!(worst < 1e-15, "{worst:e}");
    }
}
