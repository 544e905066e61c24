//! From a time near the greatest velocity to the greatest velocity: Taylor's formula, without further circular functions.
//!
//! `v″ + Ω²v = F sin ψ` makes every derivative one fused product. v′ to the seventh order: the root h by the reversed series, then one
//! step of Halley's with the polynomial. What the series leaves is of the fourth power of h, and the step makes the cube of that.

use super::circular::held;

/// The largest distance from start to root, in the angle of the faster wave: x⁸/8! is 2.3e-17 there.
const FARTHEST: f64 = 1.0 / 32.0;
/// The largest of Halley's steps, whose cube is below rounding.
const GREATEST_CORRECTION: f64 = 1.0 / (1u64 << 20) as f64;

/// 1/n, n from 2 to 7.
#[derive(Clone, Copy)]
pub(crate) struct Reciprocals([f64; 6]);

impl Reciprocals {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(held([1.0 / 2.0, 1.0 / 3.0, 1.0 / 4.0, 1.0 / 5.0, 1.0 / 6.0, 1.0 / 7.0]))
    }
}

/// The motion at one centred time ψ.
#[derive(Clone, Copy)]
pub(crate) struct Moment {
    /// ψ.
    pub(crate) psi: f64,
    /// v/(Bω_n).
    pub(crate) velocity: f64,
    /// Its derivative by ψ.
    pub(crate) slope: f64,
    /// x/B.
    pub(crate) displacement: f64,
    /// `(F sin ψ, F cos ψ)`.
    pub(crate) forcing: (f64, f64),
    /// Ω².
    pub(crate) square: f64,
    /// 1/max(Ω, 1).
    pub(crate) slower: f64,
}

/// Where the velocity is greatest.
#[derive(Clone, Copy)]
pub(crate) struct Fastest {
    /// ψ.
    pub(crate) psi: f64,
    /// V₀/(Bω_n).
    pub(crate) velocity: f64,
    /// Δ₁/B.
    pub(crate) displacement: f64,
    /// Whether there is a maximum of the velocity, and near enough.
    pub(crate) is_found: bool,
}

impl Moment {
    /// The maximum of the velocity near this moment.
    #[inline(always)]
    pub(crate) fn fastest(&self, reciprocals: &Reciprocals) -> Fastest {
        let &Self { velocity: value, slope: f0, forcing: (fs, fc), square, .. } = self;
        let f1 = (-square).mul_add(value, fs);
        let f2 = (-square).mul_add(f0, fc);
        let f3 = (-square).mul_add(f1, -fs);
        let f4 = (-square).mul_add(f2, -fc);
        let f5 = (-square).mul_add(f3, fs);
        let f6 = (-square).mul_add(f4, fc);
        let f7 = (-square).mul_add(f5, -fs);

        let quotient = 1.0 / f1;
        let newton = -(f0 * quotient);
        let [half, .., sixth, _] = reciprocals.0;
        let (b2, b3) = (half * f2 * quotient, sixth * f3 * quotient);
        let cubic = (2.0 * b2).mul_add(b2, -b3).mul_add(newton, -b2);
        let h = (newton * newton).mul_add(cubic, newton);
        let [h2, h3, h4, h5, h6, h7] = reciprocals.0.map(|reciprocal| h * reciprocal);
        let rest = f7.mul_add(h7, f6).mul_add(h6, f5).mul_add(h5, f4).mul_add(h4, f3);
        let rest = rest.mul_add(h3, f2).mul_add(h2, f1).mul_add(h, f0);
        let slope = f6.mul_add(h5, f5).mul_add(h4, f4).mul_add(h3, f3).mul_add(h2, f2).mul_add(h, f1);
        let last = -(rest / slope);
        let last = (-b2 * last).mul_add(last, last);
        let rise = f6.mul_add(h7, f5).mul_add(h6, f4).mul_add(h5, f3).mul_add(h4, f2);
        let rise = rise.mul_add(h3, f1).mul_add(h2, f0).mul_add(h, value);
        let step = h + last;
        // dx/dψ = −v; the correction changes the displacement by v times itself.
        let fall = f5.mul_add(h7, f4).mul_add(h6, f3).mul_add(h5, f2).mul_add(h4, f1);
        let fall = fall.mul_add(h3, f0).mul_add(h2, value);
        let displacement = (-last).mul_add(rise, (-h).mul_add(fall, self.displacement));
        Fastest {
            psi: self.psi + step,
            velocity: (half * rest).mul_add(last, rise),
            displacement,
            is_found: (h.abs() <= FARTHEST * self.slower)
                & (last.abs() <= GREATEST_CORRECTION * self.slower)
                & (f1 < 0.0),
        }
    }
}
