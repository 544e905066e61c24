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

use super::free::Free;
use super::half_period::HalfPeriod;
use super::touch::{End, Touch};
use crate::float::Float;
use crate::float::circular::{SinCos, TO_HALF_PI};

/// One end of the half cycle, with free vibration by the time t from there.
struct FromEnd<F> {
    from: End,
    /// h and h′ at the end, with the sign that makes both those of a motion that begins there.
    x: F,
    v: F,
    /// p.
    weight: F,
    /// cos and sin of the first zero of p, in (0, π], and that angle.
    zero: (F, F),
    angle: F,
}

/// The lobes of one half cycle.
struct Lobes<'a, F> {
    half: &'a HalfPeriod<F>,
    circular: SinCos<F, 8, 8>,
}

/// The nearest that a zero of p is to an end, in units of 1/d: beside it g is a small difference.
fn nearest<F: Float>() -> F {
    F::ratio(1, 64)
}

/// The greatest maximum of ρ, if it may be above an amplitude; `Err` where this does not decide it.
#[inline(always)]
pub(super) fn greatest<F: Float>(half: &HalfPeriod<F>, least: F) -> Result<Option<Touch<F>>, ()> {
    Lobes { half, circular: TO_HALF_PI.of() }.greatest(least)
}

impl<F: Float> Lobes<'_, F> {
    /// `(sin y, cos y)` for y in [0, π].
    #[inline(always)]
    fn upper(&self, angle: F) -> (F, F) {
        let (s, c) = self.circular.sin_cos(angle - F::pi() * F::ratio(1, 2));
        (c, -s)
    }

    #[inline(always)]
    fn end(&self, from: End) -> FromEnd<F> {
        let (half, one, zero) = (self.half, F::int(1), F::int(0));
        let (free, b) = (half.free, half.omega * half.h);
        let (x, v) = match from {
            End::First => (one + half.shift, b),
            End::Last => (one - half.shift, -b),
        };
        let a = -(x + F::int(2) * free.zeta * v);
        let (weight, slope) = (half.weighted(v, x), half.weighted(a, v));
        // p = e^{−ζτ} (p cos dτ + [(p′ + ζp)/d] sin dτ), with a time that may run backwards.
        let part = (slope + free.zeta * weight) / free.frequency;
        let part = match from {
            End::First => part,
            End::Last => -part,
        };
        let size = weight.mul_add(weight, part * part).sqrt();
        let (sine, cosine) = (weight / size, -(part / size));
        let (sine, cosine) = if sine < zero { (-sine, -cosine) } else { (sine, cosine) };
        FromEnd { from, x, v, weight, zero: (cosine, sine), angle: F::angle_of(sine, cosine) }
    }

    /// At the time (angle + y)/d from the end, 0 ≤ y ≤ π: n, the `rise` of ρ and its first two derivatives by that time, and
    /// sin Ωτ.
    #[inline(always)]
    fn at(&self, end: &FromEnd<F>, y: F) -> (F, [F; 3], F) {
        let half = self.half;
        let (free, omega) = (half.free, half.omega);
        let (time, (s, c)) = ((end.angle + y) / free.frequency, self.upper(y));
        let (cos_zero, sin_zero) = end.zero;
        let (sine, cosine) = (s.mul_add(cos_zero, c * sin_zero), c.mul_add(cos_zero, -(s * sin_zero)));
        let (sin_drive, cos_drive) = self.upper(omega * time);
        let (sign, cos_drive) = match end.from {
            End::First => (F::int(1), cos_drive),
            End::Last => (F::int(-1), -cos_drive),
        };
        let decay = (-(sign * free.zeta * time)).exp();
        let waves =
            super::free::Waves { cosine: decay * cosine, sine: sign * decay * (sine / free.frequency) };
        let state = free.after(waves, end.x, end.v);
        let b = omega * half.h;
        let n = b.mul_add(cos_drive, -state.v);
        let slope = -(b * omega).mul_add(sin_drive, state.a);
        let value = slope.mul_add(sin_drive, -(omega * n * cos_drive));
        let (p, change) = (half.weighted(state.v, state.x), half.weighted(state.a, state.v));
        let second = -(change.mul_add(sin_drive, p * omega * cos_drive));
        (n, [sign * value, -(p * sin_drive), sign * second], sin_drive)
    }

    #[inline(always)]
    fn greatest(&self, least: F) -> Result<Option<Touch<F>>, ()> {
        let half = self.half;
        let (zero, pi, omega) = (F::int(0), F::pi(), half.omega);
        let Free { zeta, frequency: d, .. } = half.free;
        let ends = [self.end(End::First), self.end(End::Last)];
        let [first, last] = &ends;
        // A NaN is not above it.
        let is_clear = first.angle > nearest() && last.angle > nearest();
        let both = first.weight < zero && last.weight < zero;
        if !is_clear || both {
            return Err(());
        }
        // The lobes at both ends that are decided, in units of π/d.
        let lobes = |end: &FromEnd<F>| if end.weight < zero { F::int(2) } else { F::int(1) };
        let rest = |end: &FromEnd<F>| lobes(end).mul_add(pi, end.angle) / d;
        let (mut best, mut touch) = (least, None);
        for end in &ends {
            if end.weight < zero && (end.angle + pi) / d < half.period {
                let (y, amplitude) = self.maximum(end).ok_or(())?;
                if amplitude > best * (F::int(1) - F::ratio(1, 1 << 16)) {
                    (best, touch) =
                        (best.or_larger(amplitude), Some(Touch::new(end.from, (end.angle + y) / d)));
                }
            }
        }
        let (start, before_end) = (rest(first), rest(last));
        if start + before_end >= half.period {
            return Ok(touch);
        }
        let ((sin_start, cos_start), (sin_end, cos_end)) =
            (self.upper(omega * start), self.upper(omega * before_end));
        let b = omega * half.h;
        let driven = (b * cos_start).or_larger(-(b * cos_end));
        let a = -(first.x + F::int(2) * zeta * b);
        let across = (a + zeta * b) / d;
        let size = b.mul_add(b, across * across).sqrt() * (-(zeta * start)).exp();
        let sine = if sin_start < sin_end { sin_start } else { sin_end };
        if driven + size < best * omega * sine { Ok(touch) } else { Err(()) }
    }

    /// The maximum in the lobe after the first zero of p, by its phase since then, and a value of ρ that it exceeds by no
    /// more than a part of 10⁻⁶.
    #[inline(always)]
    fn maximum(&self, end: &FromEnd<F>) -> Option<(F, F)> {
        let (zero, pi, d) = (F::int(0), F::pi(), self.half.free.frequency);
        // As without damping.
        let (x, z) = ((end.angle / pi).square(), F::int(4) * (self.half.omega / d).square());
        let bend = z.mul_add(F::ratio(143, 1000), F::ratio(-62, 1000));
        let mut y = end.angle * x.mul_add(F::ratio(-9, 1000).mul_add(x, bend), F::ratio(1, 2));
        for _ in 0..8 {
            let (n, [value, slope, bend], sine) = self.at(end, y);
            let step = -(F::int(2) * value * slope) / (F::int(2) * slope).mul_add(slope, -(value * bend));
            let next = step.mul_add(d, y);
            let is_inside = next > zero && next < pi;
            if !is_inside {
                return None;
            }
            if (next - y).abs() <= y * F::ratio(1, 1 << 11) {
                return Some((next, n / (self.half.omega * sine)));
            }
            y = next;
        }
        None
    }
}
