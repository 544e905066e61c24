//! From a time near the peak velocity to the peak velocity: Taylor's formula, without further
//! circular functions.
//!
//! `v″ + Ω²v = F sin ψ` makes every derivative one fused product. v′ to the seventh order: the root h by the
//! reversed series, then one step of Halley's with the polynomial. The error of the series is of order h⁴,
//! and the step reduces it to its cube.

use crate::float::Float;

/// The motion at one centred time ψ.
#[derive(Clone, Copy)]
pub(crate) struct ArrivalMoment<F> {
    /// ψ.
    pub(crate) psi: F,
    /// v/(Bω_n).
    pub(crate) velocity: F,
    /// Its derivative by ψ.
    pub(crate) slope: F,
    /// x/B.
    pub(crate) displacement: F,
    /// `(F sin ψ, F cos ψ)`.
    pub(crate) forcing: (F, F),
    /// Ω².
    pub(crate) square: F,
    /// 1/max(Ω, 1).
    pub(crate) slower: F,
}

/// The state at the peak velocity.
#[derive(Clone, Copy)]
pub(crate) struct Arrived<F> {
    /// ψ.
    pub(crate) psi: F,
    /// The maximum of v/(Bω_n) minus the velocity at this moment.
    pub(crate) gain: F,
    /// Δ₁/B.
    pub(crate) displacement: F,
    /// Whether there is a maximum of the velocity, and near enough.
    pub(crate) is_found: bool,
}

/// 1/n, n from 2 to 7.
#[derive(Clone, Copy)]
pub(crate) struct Reciprocals<F>([F; 6]);

impl<F: Float> Reciprocals<F> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self([2, 3, 4, 5, 6, 7].map(|n| F::ratio(1, n)))
    }
}

impl<F: Float> ArrivalMoment<F> {
    /// The maximum of the velocity near this moment.
    #[inline(always)]
    pub(crate) fn fastest(&self, reciprocals: &Reciprocals<F>) -> Arrived<F> {
        let &Self { psi, velocity, displacement, slower, .. } = self;
        Nearby { psi, velocity, slopes: self.slopes(), displacement, slower }.fastest(reciprocals)
    }

    /// v′ and its derivatives.
    #[inline(always)]
    fn slopes(&self) -> [F; 8] {
        let &Self { velocity: value, slope: f0, forcing: (fs, fc), square, .. } = self;
        // v″ = −Ω²v + F sin ψ, and so on
        let f1 = (-square).mul_add(value, fs);
        let f2 = (-square).mul_add(f0, fc);
        let f3 = (-square).mul_add(f1, -fs);
        let f4 = (-square).mul_add(f2, -fc);
        let f5 = (-square).mul_add(f3, fs);
        let f6 = (-square).mul_add(f4, fc);
        let f7 = (-square).mul_add(f5, -fs);
        [f0, f1, f2, f3, f4, f5, f6, f7]
    }
}

/// The motion at one time by its derivatives there, whatever equation they obey.
#[derive(Clone, Copy)]
pub(crate) struct Nearby<F> {
    /// ψ.
    pub(crate) psi: F,
    /// v/(Bω_n).
    pub(crate) velocity: F,
    /// Its first eight derivatives by ψ.
    pub(crate) slopes: [F; 8],
    /// x/B, where dx/dψ = −v.
    pub(crate) displacement: F,
    /// The time in which the fastest wave turns by 1.
    pub(crate) slower: F,
}

impl<F: Float> Nearby<F> {
    /// The maximum of the velocity near this time.
    #[inline(always)]
    pub(crate) fn fastest(&self, reciprocals: &Reciprocals<F>) -> Arrived<F> {
        let &Self { velocity: value, slopes: [f0, f1, f2, f3, f4, f5, f6, f7], .. } = self;
        let quotient = F::int(1) / f1;
        let newton = -(f0 * quotient);
        let [half, .., sixth, _] = reciprocals.0;
        let (b2, b3) = (half * f2 * quotient, sixth * f3 * quotient);
        let cubic = (b2 + b2).mul_add(b2, -b3).mul_add(newton, -b2);
        let h = (newton * newton).mul_add(cubic, newton);
        let [h2, h3, h4, h5, h6, h7] = reciprocals.0.map(|reciprocal| h * reciprocal);
        let rest = f7.mul_add(h7, f6).mul_add(h6, f5).mul_add(h5, f4).mul_add(h4, f3);
        let rest = rest.mul_add(h3, f2).mul_add(h2, f1).mul_add(h, f0);
        let slope = f6.mul_add(h5, f5).mul_add(h4, f4).mul_add(h3, f3).mul_add(h2, f2).mul_add(h, f1);
        let last = -(rest / slope);
        let last = (-b2 * last).mul_add(last, last);
        let rise = f6.mul_add(h7, f5).mul_add(h6, f4).mul_add(h5, f3).mul_add(h4, f2);
        let gain = rise.mul_add(h3, f1).mul_add(h2, f0) * h;
        let rise = value + gain;
        let gain = (half * rest).mul_add(last, gain);
        let step = h + last;
        // dx/dψ = −v; the correction changes the displacement by v times itself.
        let fall = f5.mul_add(h7, f4).mul_add(h6, f3).mul_add(h5, f2).mul_add(h4, f1);
        let fall = fall.mul_add(h3, f0).mul_add(h2, value);
        let displacement = (-last).mul_add(rise, (-h).mul_add(fall, self.displacement));
        // The largest distance from start to root, in the angle of the faster wave: x⁸/8! is 2.3e-17 there.
        // The largest of Halley's steps, whose cube is below rounding.
        let (farthest, greatest_correction) = (F::ratio(1, 1 << 5), F::ratio(1, 1 << 20));
        Arrived {
            psi: self.psi + step,
            gain,
            displacement,
            is_found: (h.abs() <= farthest * self.slower)
                & (last.abs() <= greatest_correction * self.slower)
                & (f1 < F::int(0)),
        }
    }
}
