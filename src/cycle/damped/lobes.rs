//! The supremum of the border's condition below Ω = d/2 without a search: one lobe, and a bound of all others.
//!
//! In the notation of [`super::border()`], g rises from 0 at an end of the half cycle while p < 0 there, so that the lobe after
//! the first zero of p has a maximum unless g > 0 to its other end. Where p > 0 at an end, the lobe after the first zero
//! has none. At one end at most p < 0, because `p(0) + p(T) = 4ζ`. In the rest, from t₁ to t₂,
//!
//! ```text
//! ρ ≤ (max b cos Ωτ + C e^{−ζt₁})/(Ω min sin Ωτ),   |h′| ≤ C e^{−ζτ},   C = hypot(h′(0), (h″(0) + ζh′(0))/d),
//! ```
//!
//! with the maximum and the minimum at the ends.
//!
//! Seen from the last end, the half cycle backwards is one with −ζ, −G and −H.

use super::border::has_lobes;
use super::half_period::HalfPeriod;
use crate::float::Float;
use crate::float::circular::{Exponential, SinCos, TO_HALF_PI};
use crate::float::pair::Pair;

/// The constants of the functions.
#[derive(Clone, Copy)]
pub(crate) struct Constants<F> {
    pub(super) circular: SinCos<F, 8, 8>,
    pub(super) exponential: Exponential<F>,
}

impl<F: Float> Constants<F> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self { circular: TO_HALF_PI.of(), exponential: Exponential::new() }
    }
}

/// An amplitude below that at the turning point by more than its rounding.
#[inline(always)]
pub(crate) fn least<F: Float>(at_turning_point: Pair<F>) -> F {
    at_turning_point.hi * (F::int(1) - F::int(64) * F::epsilon())
}

/// The greatest argument of [`Exponential`].
#[inline(always)]
pub(super) fn reach<F: Float>() -> F {
    F::int(F::RATIO_EXPONENT / 2)
}

/// The only maximum of ρ that may be above an amplitude.
#[derive(Clone, Copy)]
pub(crate) struct Lobe<F> {
    /// 1 where the time is counted from the first end of the half cycle, −1 where it is from the last.
    pub(crate) side: F,
    /// The time since that end.
    pub(crate) time: F,
    /// Whether there is such a maximum.
    pub(crate) is_above: bool,
    /// Whether no other can be: otherwise the rest is meaningless.
    pub(crate) is_decided: bool,
}

/// The end of a half cycle where p < 0, if there is one: the first of the parts of [`Lobe`], which are loops of their own in a
/// batch.
#[derive(Clone, Copy)]
pub(crate) struct Edge<F> {
    pub(crate) side: F,
    pub(crate) over_d: F,
    /// cos and sin of the first zero of p, in (0, π].
    pub(crate) zero: (F, F),
    /// Whether p < 0 at this end, and not at the other.
    pub(crate) has_lobe: bool,
    pub(crate) is_alone: bool,
}

/// A half cycle seen from that end.
#[derive(Clone, Copy)]
pub(crate) struct FromEnd<F> {
    pub(crate) side: F,
    pub(crate) over_d: F,
    /// cos and sin of the first zero of p, in (0, π], and that angle.
    pub(crate) zero: (F, F),
    pub(crate) angle: F,
    /// The time from this end to the end of the lobe, and from the other end to that of its own.
    pub(crate) own: F,
    pub(crate) far: F,
    /// Whether the lobe has a maximum.
    pub(crate) has_maximum: bool,
    /// Whether all this is certain.
    pub(crate) is_clear: bool,
}

/// The waves at a phase y after the first zero of p.
#[derive(Clone, Copy)]
pub(crate) struct EndWaves<F> {
    /// (sin y, cos y).
    pub(crate) swing: (F, F),
    /// (sin Ωτ, cos Ωτ) of the time since the end.
    pub(crate) drive: (F, F),
    /// `e^{−ζτ}`, backwards in time from the last end.
    pub(crate) decay: F,
}

/// A step towards the maximum in a lobe.
#[derive(Clone, Copy)]
pub(crate) struct Step<F> {
    /// The phase after the first zero of p.
    pub(crate) y: F,
    /// A value of ρ that the maximum exceeds by no more than a part of 10⁻⁵.
    pub(crate) amplitude: F,
    pub(crate) is_near: bool,
}

impl<F: Float> Lobe<F> {
    /// The lobe of a half period whose maximum may be above `least`.
    #[inline(always)]
    pub(crate) fn of(half: &HalfPeriod<F>, least: F, given: &Constants<F>) -> Self {
        let from = FromEnd::of(half, &Edge::of(half, F::int(1) / half.free.frequency));
        let step = if from.has_maximum {
            let start = from.start(half);
            let first = from.step(half, start, &from.waves(half, start, given));
            if first.is_near {
                first
            } else {
                first.or(from.step(half, first.y, &from.waves(half, first.y, given)))
            }
        } else {
            Step { y: F::pi(), amplitude: F::int(0), is_near: true }
        };
        from.lobe::<false>(half, least, step, given)
    }
}

impl<F: Float> Step<F> {
    /// This step, or the next if it is not near.
    #[inline(always)]
    pub(crate) fn or(self, next: Self) -> Self {
        if self.is_near { self } else { next }
    }
}

impl<F: Float> Edge<F> {
    #[inline(always)]
    pub(crate) fn of(half: &HalfPeriod<F>, over_d: F) -> Self {
        let (zero, one, zeta) = (F::int(0), F::int(1), half.free.zeta);
        let b = half.omega * half.h;
        let (first, last) = (half.weighted(b, one + half.shift), half.weighted(-b, one - half.shift));
        let (side, weight, other) = if last < zero { (-one, last, first) } else { (one, first, last) };
        let (x, v) = state(half, side);
        let a = -(x + F::int(2) * zeta * v);
        // p = e^{−ζτ} (p cos dτ + [(p′ + ζp)/d] sin dτ)
        let part = side * (half.weighted(a, v) + zeta * weight) * over_d;
        let scale = one / weight.mul_add(weight, part * part).sqrt();
        let (sine, cosine) = (weight * scale, -(part * scale));
        let has_lobe = sine < zero;
        let zero_of_p = if has_lobe { (-cosine, -sine) } else { (cosine, sine) };
        Self { side, over_d, zero: zero_of_p, has_lobe, is_alone: other >= zero }
    }
}

/// h and h′ at the end on this side.
#[inline(always)]
fn state<F: Float>(half: &HalfPeriod<F>, side: F) -> (F, F) {
    (side.mul_add(half.shift, F::int(1)), side * (half.omega * half.h))
}

impl<F: Float> FromEnd<F> {
    #[inline(always)]
    pub(crate) fn of(half: &HalfPeriod<F>, edge: &Edge<F>) -> Self {
        let (one, pi, zeta, d) = (F::int(1), F::pi(), half.free.zeta, half.free.frequency);
        let Edge { side, over_d, zero: (cosine, sine), has_lobe, is_alone } = *edge;
        let angle = F::angle_of(sine, cosine);
        // The zero of p next to the other end is a number of half turns before it.
        let whole = d * half.period - angle;
        let beyond = whole - pi * (whole * (one / pi)).floor();
        let has_maximum = has_lobe & ((angle + pi) * over_d < half.period) & has_lobes(half);
        // Beside the end g is a small difference, with less than half of the digits.
        let is_clear = !has_maximum | (angle * angle > F::int(16) * F::epsilon().sqrt());
        // A zero at the other end would be followed by a lobe.
        let is_clear = is_clear & (beyond < pi - F::ratio(1, 1 << 20));
        let is_clear = is_clear & (zeta * (angle + pi) * over_d <= reach()) & is_alone;
        let own = (if has_lobe { angle + pi + pi } else { angle + pi }) * over_d;
        let far = (beyond + pi) * over_d;
        Self { side, over_d, zero: (cosine, sine), angle, own, far, has_maximum, is_clear }
    }

    /// The lobe after the steps, if its maximum may be above `least`. `ALL` is without branches.
    #[inline(always)]
    pub(crate) fn lobe<const ALL: bool>(
        &self,
        half: &HalfPeriod<F>,
        least: F,
        step: Step<F>,
        given: &Constants<F>,
    ) -> Lobe<F> {
        let Self { side, over_d, angle, own, far, has_maximum, is_clear, .. } = *self;
        let Step { y, amplitude, is_near } = step;
        let is_above = has_maximum & (amplitude > least * (F::int(1) - F::ratio(1, 1 << 14)));
        let best = if is_above { least.or_larger(amplitude) } else { least };
        let is_all = (own + far >= half.period) | !has_lobes(half);
        let is_bounded = if ALL {
            is_all | self.is_bounded(half, best, given)
        } else {
            is_all || self.is_bounded(half, best, given)
        };
        let is_decided = is_clear & (is_near | !has_maximum) & is_bounded;
        Lobe { side, time: (angle + y) * over_d, is_above, is_decided }
    }

    /// Whether no ρ exceeds an amplitude between the lobes at both ends.
    #[inline(always)]
    fn is_bounded(&self, half: &HalfPeriod<F>, best: F, given: &Constants<F>) -> bool {
        let (&Self { side, over_d, own, far, .. }, Constants { circular, exponential }) = (self, given);
        let (omega, zeta) = (half.omega, half.free.zeta);
        let ((sin_own, cos_own), (sin_far, cos_far)) =
            (circular.upper(omega * own), circular.upper(omega * far));
        let v = state(half, side).1;
        let driven = (v * cos_own).or_larger(-(v * cos_far));
        let b = omega * half.h;
        let a = -(F::int(1) + half.shift + F::int(2) * zeta * b);
        let across = (a + zeta * b) * over_d;
        let start = if side < F::int(0) { far } else { own };
        let size =
            b.mul_add(b, across * across).sqrt() * exponential.at((-(zeta * start)).or_larger(-reach::<F>()));
        let sine = if sin_own < sin_far { sin_own } else { sin_far };
        driven + size < best * omega * sine
    }

    /// A phase after the first zero of p near the maximum: a least-squares fit for ζ ≤ 1/2, within 2 %; without damping 10⁻³.
    #[inline(always)]
    pub(crate) fn start(&self, half: &HalfPeriod<F>) -> F {
        let Self { side, over_d, angle, .. } = *self;
        let [c0, c1, c2, c3, c4, c5, c6, c7, c8] = FIT.map(F::from_f64);
        let turn = angle * (F::int(1) / F::pi());
        let (x, w) = (turn * turn, F::int(4) * (half.omega * over_d) * (half.omega * over_d));
        let q = side * half.free.zeta * over_d * turn;
        let by_x = c2.mul_add(x, c3.mul_add(w, c1));
        let by_q = c8.mul_add(q, c5).mul_add(q, c6.mul_add(x, c7.mul_add(w, c4)));
        angle * by_q.mul_add(q, by_x.mul_add(x, c0))
    }

    /// The waves at the phase y after the first zero of p.
    #[inline(always)]
    pub(crate) fn waves(&self, half: &HalfPeriod<F>, y: F, given: &Constants<F>) -> EndWaves<F> {
        let (&Self { side, over_d, angle, .. }, Constants { circular, exponential }) = (self, given);
        let (time, swing) = ((angle + y) * over_d, circular.upper(y));
        let drive = circular.upper(half.omega * time);
        EndWaves { swing, drive, decay: exponential.at(-(side * half.free.zeta * time)) }
    }

    /// A step of Halley's from the phase y after the first zero of p, by the waves there.
    #[inline(always)]
    pub(crate) fn step(&self, half: &HalfPeriod<F>, y: F, waves: &EndWaves<F>) -> Step<F> {
        let &Self { side, over_d, .. } = self;
        let EndWaves { swing: (s, c), drive: (sin_drive, cos_drive), decay } = *waves;
        let (x, v) = state(half, side);
        let (omega, zeta, two) = (half.omega, half.free.zeta, F::int(2));
        let (cos_zero, sin_zero) = self.zero;
        let (sine, cosine) = (s.mul_add(cos_zero, c * sin_zero), c.mul_add(cos_zero, -(s * sin_zero)));
        let cos_drive = side * cos_drive;
        let (cosine, sine) = (decay * cosine, side * decay * (sine * over_d));
        let (x, v) =
            (x.mul_add(cosine, zeta.mul_add(x, v) * sine), v.mul_add(cosine, -(zeta.mul_add(v, x) * sine)));
        let a = -(two * zeta).mul_add(v, x);
        let b = omega * half.h;
        let n = b.mul_add(cos_drive, -v);
        let slope = -(b * omega).mul_add(sin_drive, a);
        // `rise` of ρ and its first two derivatives by the time from the end.
        let value = side * slope.mul_add(sin_drive, -(omega * n * cos_drive));
        let (p, change) = (half.weighted(v, x), half.weighted(a, v));
        let first = -(p * sin_drive);
        let second = -(side * change.mul_add(sin_drive, p * omega * cos_drive));
        let step = -(two * value * first) / (two * first).mul_add(first, -(value * second));
        let next = step.mul_add(half.free.frequency, y);
        let is_inside = (next > F::int(0)) & (next < F::pi());
        Step {
            y: next,
            amplitude: n / (omega * sin_drive),
            is_near: is_inside & ((next - y).abs() <= y * F::ratio(1, 512)),
        }
    }
}

/// Coefficients of the start by x = (angle/π)², w = (2Ω/d)² and q = ±(ζ/d) angle/π: of 1, x, x², xw, q, q², qx, qw, q³.
const FIT: [f64; 9] = [
    0.500_052_56,
    -0.061_592_92,
    -0.008_701_85,
    0.138_971_05,
    0.562_508_73,
    0.531_291_36,
    -0.034_111_98,
    0.101_934_17,
    0.254_466_38,
];
