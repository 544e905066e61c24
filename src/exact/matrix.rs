//! Two by two matrices: what a small disturbance (δx, δw) of the motion becomes.

use crate::float::Float;

/// The matrix `[[a, b], [c, d]]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Matrix<F> {
    pub(crate) a: F,
    pub(crate) b: F,
    pub(crate) c: F,
    pub(crate) d: F,
}

impl<F: Float> Matrix<F> {
    pub(crate) fn identity() -> Self {
        let (zero, one) = (F::int(0), F::int(1));
        Self { a: one, b: zero, c: zero, d: one }
    }

    /// What a disturbance becomes in a slide of natural length φ, `rotation` = (sin φ, cos φ): a free vibration.
    #[inline]
    pub(crate) fn after_slide(self, rotation: (F, F)) -> Self {
        let (s, c) = rotation;
        Self {
            a: c * self.a + s * self.c,
            b: c * self.b + s * self.d,
            c: c * self.c - s * self.a,
            d: c * self.d - s * self.b,
        }
    }

    /// What it becomes at a velocity zero: δw is multiplied by the ratio of the accelerations after and before, because
    /// the zero itself moves; by 0 at a stop.
    #[inline]
    pub(crate) fn after_zero(self, ratio: F) -> Self {
        Self { c: ratio * self.c, d: ratio * self.d, ..self }
    }

    pub(crate) fn determinant(self) -> F {
        self.a * self.d - self.b * self.c
    }

    pub(crate) fn trace(self) -> F {
        self.a + self.d
    }

    /// `(1 + M)⁻¹`, where there is one.
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

    /// The squares of the eigenvalues, each as (re, im), the larger first.
    ///
    /// `μ² − (t² − 2δ) μ + δ² = 0` with t the trace and δ the determinant; the smaller real root from the product.
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
        // the product is the squared determinant, the sum the trace of the square
        assert!((re * re2 - im * im2 - 0.63f64.powi(2)).abs() < 1e-15);
        assert!((re + re2 - (0.09 + 0.01 - 1.2f64)).abs() < 1e-15 && im == -im2);
        let real = Matrix { a: 0.5, b: 0.2, c: 0.1, d: -0.25 };
        let [(p, _), (q, _)] = real.squared_eigenvalues();
        assert!(
            (p * q - (0.125f64 + 0.02).powi(2)).abs() < 1e-16
                && (p + q - (0.25 + 0.0625 + 0.04f64)).abs() < 1e-15
        );
    }
}
