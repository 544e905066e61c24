//! The matching problem of the symmetric cycle of six reversals: five equations in five unknowns.

use crate::cycle::phase_function::PhaseFunction;
use crate::float::Float;

/// The quantities that depend on Ω alone: Ω and (sin β, cos β) of `β = π/2Ω`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frequency<F> {
    pub(super) omega: F,
    pub(super) sin_beta: F,
    pub(super) cos_beta: F,
}

impl<F: Float> Frequency<F> {
    pub(super) fn of(p: &PhaseFunction<F>) -> Self {
        let (sin_beta, cos_beta) = p.sin_cos();
        Self { omega: p.omega(), sin_beta, cos_beta }
    }

    /// `cot β`, which vanishes at the poles 1/(2n+1).
    pub(super) fn cotangent(&self) -> F {
        self.cos_beta / self.sin_beta
    }

    /// `κ(u) = (cos Ωu − cos u)/sin u` and its derivative.
    fn kappa(&self, u: F) -> (F, F) {
        let (one, two, omega) = (F::int(1), F::int(2), self.omega);
        let (sine, cosine) = u.sin_cos();
        let product = two * ((one + omega) * u / two).sin() * ((one - omega) * u / two).sin();
        let value = product / sine;
        (value, one - omega * (omega * u).sin() / sine - value * cosine / sine)
    }

    /// `μ(u) = sin Ωu/(Ω sin u)` and its derivative, for small u by the first term of its series.
    fn mu(&self, u: F) -> (F, F) {
        let (one, omega) = (F::int(1), self.omega);
        let (sine, cosine) = u.sin_cos();
        let (slow_sine, slow_cosine) = (omega * u).sin_cos();
        let value = slow_sine / (omega * sine);
        let slope = if u.square().square() < F::epsilon() {
            (one - omega) * (one + omega) * u / F::int(3)
        } else {
            (slow_cosine - value * cosine) / sine
        };
        (value, slope)
    }
}

/// The unknowns of the cycle; see the documentation of [`super`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Unknowns<F> {
    /// `a = ω_n(t₂ − t₁)`, the natural time from the first reversal to the second.
    pub(super) before: F,
    /// `b = ω_n(t₃ − t₂)`, from the second to the third.
    pub(super) after: F,
    /// `s = AΩ sin Ωφ₂`, φ₂ the natural time from the forced maximum to the second reversal.
    pub(super) sine: F,
    /// `c = AΩ² cos Ωφ₂`.
    pub(super) cosine: F,
    /// `p`, the part of the free vibration that is in phase with the second reversal.
    pub(super) swing: F,
}

/// The fifth equation: the quantity that is given in addition to Ω.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Closing<F> {
    /// The force, as `AΩ² = αΩ²/(1 − Ω²)`.
    Force(F),
    /// An edge: at the second reversal the force left over is exactly the friction bound.
    Second,
    /// An edge: at the third reversal it is.
    Third,
}

impl<F: Float> Unknowns<F> {
    /// `q`, the part of the free vibration a quarter of its period off: the velocity vanishes at the second
    /// reversal.
    pub(super) fn quarter_swing(&self) -> F {
        self.before.sin() + self.after.sin() - self.sine
    }

    /// `AΩ² = √(c² + Ω²s²)`.
    pub(super) fn forced_acceleration(&self, omega: F) -> F {
        self.cosine.hypot(omega * self.sine)
    }

    /// `α = (1 − Ω²) AΩ²/Ω²`.
    pub(super) fn force_ratio(&self, omega: F) -> F {
        let one = F::int(1);
        self.forced_acceleration(omega) * ((one - omega) * (one + omega)) / omega.square()
    }

    /// The force `α sin θ − x` at the three reversals, in units of r_y: the body slides on without a stop
    /// where the first and the third are below −1 and the second is above 1.
    pub(super) fn forces(&self, omega: F) -> [F; 3] {
        let Self { before: a, after: b, sine: s, cosine: c, swing: p } = *self;
        let q = self.quarter_swing();
        let ((sin_a, cos_a), (sin_b, cos_b)) = (a.sin_cos(), b.sin_cos());
        let (slow_a, slow_b) = ((omega * a).sin_cos(), (omega * b).sin_cos());
        let both = (a + b).cos();
        [
            -(c * slow_a.1 + omega * s * slow_a.0) - p * cos_a - q * sin_a + cos_a - both,
            -c - p + cos_a - cos_b,
            -(c * slow_b.1 - omega * s * slow_b.0) - p * cos_b + q * sin_b + both - cos_b,
        ]
    }

    /// Left less right sides of the five equations, and their derivatives by (a, b, s, c, p).
    pub(super) fn residuals(&self, frequency: &Frequency<F>, closing: Closing<F>) -> ([F; 5], [[F; 5]; 5]) {
        let Self { before: a, after: b, sine: s, cosine: c, swing: p } = *self;
        let Frequency { omega, sin_beta, cos_beta } = *frequency;
        let (zero, one) = (F::int(0), F::int(1));
        let ((sin_a, cos_a), (sin_b, cos_b)) = (a.sin_cos(), b.sin_cos());
        let ((kappa_a, dkappa_a), (kappa_b, dkappa_b)) = (frequency.kappa(a), frequency.kappa(b));
        let ((mu_a, dmu_a), (mu_b, dmu_b)) = (frequency.mu(a), frequency.mu(b));
        let free = sin_a + sin_b - s;
        let (last, last_row) = self.closing(omega, closing);
        (
            [
                c * mu_a + p - s * kappa_a - one - cos_a + cos_b,
                -c * mu_b - p - s * kappa_b - one - cos_b + cos_a,
                cos_beta * p + sin_beta * (sin_a - sin_b),
                cos_beta * free - sin_beta * (cos_a + cos_b - one),
                last,
            ],
            [
                [c * dmu_a - s * dkappa_a + sin_a, -sin_b, -kappa_a, mu_a, one],
                [-sin_a, -c * dmu_b - s * dkappa_b + sin_b, -kappa_b, -mu_b, -one],
                [sin_beta * cos_a, -sin_beta * cos_b, zero, zero, cos_beta],
                [
                    cos_beta * cos_a + sin_beta * sin_a,
                    cos_beta * cos_b + sin_beta * sin_b,
                    -cos_beta,
                    zero,
                    zero,
                ],
                last_row,
            ],
        )
    }

    /// Left less right side of the fifth equation, and its derivatives.
    fn closing(&self, omega: F, closing: Closing<F>) -> (F, [F; 5]) {
        let Self { before: a, after: b, sine: s, cosine: c, swing: p } = *self;
        let (zero, one) = (F::int(0), F::int(1));
        let ((sin_a, cos_a), (sin_b, cos_b)) = (a.sin_cos(), b.sin_cos());
        let [_, second, third] = self.forces(omega);
        match closing {
            Closing::Force(given) => {
                let found = self.forced_acceleration(omega);
                (found - given, [zero, zero, omega.square() * s / found, c / found, zero])
            }
            Closing::Second => (second - one, [-sin_a, sin_b, zero, -one, -one]),
            Closing::Third => {
                let (slow_sine, slow_cosine) = (omega * b).sin_cos();
                let (q, sin_both) = (self.quarter_swing(), (a + b).sin());
                let by_b =
                    omega * (c * slow_sine + omega * s * slow_cosine) + p * sin_b + cos_b * sin_b + q * cos_b
                        - sin_both
                        + sin_b;
                let row = [cos_a * sin_b - sin_both, by_b, omega * slow_sine - sin_b, -slow_cosine, -cos_b];
                (third + one, row)
            }
        }
    }

    pub(super) const fn to_array(self) -> [F; 5] {
        [self.before, self.after, self.sine, self.cosine, self.swing]
    }

    pub(super) const fn of_array([before, after, sine, cosine, swing]: [F; 5]) -> Self {
        Self { before, after, sine, cosine, swing }
    }

    pub(super) fn map<G: Float>(self, to: impl Fn(F) -> G) -> Unknowns<G> {
        Unknowns::of_array(self.to_array().map(to))
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::{Closing, Frequency, Unknowns};
    use crate::cycle::phase_function::PhaseFunction;

    #[test]
    fn the_derivatives_are_those_of_the_residuals() {
        let frequency = Frequency::of(&PhaseFunction::new(0.331).unwrap());
        the_derivatives_are_those_of(|y, closing| y.residuals(&frequency, closing));
    }

    /// Compares the rows of derivatives with differences of the residuals.
    pub(in crate::cycle::six_reversals) fn the_derivatives_are_those_of(
        residuals: impl Fn(&Unknowns<f64>, Closing<f64>) -> ([f64; 5], [[f64; 5]; 5]),
    ) {
        let at = [0.9, 1.3, -2.1, 7.5, -8.0];
        for closing in [Closing::Force(9.0), Closing::Second, Closing::Third] {
            let (_, rows) = residuals(&Unknowns::of_array(at), closing);
            for (column, h) in [1e-6f64; 5].into_iter().enumerate() {
                let moved = |by: f64| {
                    let mut y = at;
                    y[column] += by;
                    residuals(&Unknowns::of_array(y), closing).0
                };
                for (row, (up, down)) in rows.iter().zip(moved(h).into_iter().zip(moved(-h))) {
                    let slope = (up - down) / (2.0 * h);
                    assert!(
                        (row[column] - slope).abs() < 1e-7,
                        "{closing:?} {column}: {} {slope}",
                        row[column]
                    );
                }
            }
        }
    }

    /// The two branches of the derivative of μ agree where they meet.
    #[test]
    fn a_short_arc_has_its_series() {
        let frequency = Frequency::of(&PhaseFunction::new(0.331).unwrap());
        let (below, above): (f64, f64) = (frequency.mu(1.2e-4).1, frequency.mu(1.3e-4).1);
        assert!((below / 1.2e-4 - above / 1.3e-4).abs() < 1e-7, "{below:e} {above:e}");
    }
}
