//! The minimum force ratio without sticking with viscous damping, from a complete list of candidates.
//!
//! The rising half cycle slides throughout where `x′ > 0` for 0 < τ < T = π/Ω, that is `a ≥ ρ(τ)`,
//!
//! ```text
//! ρ(τ) = n(τ)/(Ω sin Ωτ),   n = b cos Ωτ − h′(τ),   ρ(0⁺) = (1 + G + 2ζb)/Ω²,   b = ΩH.
//! ```
//!
//! So `α_min = q hypot(S, H)`, S = sup ρ, and with ρ(0⁺) alone, the condition at the turning point, it is the
//! analogue of eq. 61.
//!
//! # Where the supremum is
//!
//! With `D = Ω sin Ωτ` and `g = n′D − nD′`, ρ′ = g/D². Because `(d²/dτ² + Ω²) cos Ωτ = 0`,
//!
//! ```text
//! g′ = D (n″ + Ω²n) = −D p,   p = h‴ + Ω²h′ = (Ω² + 4ζ² − 1) h′ + 2ζh,
//! ```
//!
//! and p is a free vibration: its zeros are known, π/d apart (d = √(1 − ζ²)), with at most one for ζ ≥ 1.
//! Between two of them g is monotone, and it vanishes at both ends of the half cycle, n(0) = n(T) = 0. So ρ
//! has **at most one maximum between two zeros of p in (0, T), where p > 0, and none elsewhere**: each is one
//! bracketed root. The ends are no candidates: `ρ(T⁻) = ρ(0⁺) − 2/Ω²`.
//!
//! **For Ω ≥ d/2 the condition at the turning point suffices**, as eq. 61 does for Ω ≥ 1/2 without damping.
//! There `dT ≤ 2π`, p has two zeros at most, and a maximum between them needs p < 0 before and after; but
//! `p(0) + p(T) = 4ζ > 0`.
//!
//! For Ω < d/2 lobes are searched from both ends of the half cycle inwards, until the remaining ones cannot
//! exceed the supremum so far. With `A = hypot(h′, h″)` at the left end, ρ ≤ (max b cos Ωτ + A)/(Ω min sin
//! Ωτ), because h′ is a free vibration with decreasing energy.

use super::free::FreeState;
use super::half_period::HalfPeriod;
pub(crate) use super::half_period::{has_lobes, turning_point};
use super::lobes::{self, Lobe};
use super::rising::Moment;
use super::touch::{NearerEnd, Touch};
use super::wide::{WideState, WideWaves};
use crate::float::pair::Pair;
use crate::float::{Field, Float, Signed, at_precision, fused};
use crate::root::newton_within;

/// The greatest ρ so far.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Supremum<F> {
    amplitude: F,
    /// Where it is, if not at the turning point.
    touch: Option<Touch<F>>,
}

/// Where the supremum is if not at the turning point, and S there.
///
/// A touch that rounding puts below the turning point is not left out: both are compared in pairs.
#[inline(always)]
pub(crate) fn supremum<F: Float>(
    half: &HalfPeriod<F>,
    wide: &HalfPeriod<Pair<F>>,
    at_turning_point: Pair<F>,
) -> Option<(Touch<F>, Pair<F>)> {
    if !has_lobes(half) {
        return None;
    }
    let (Touch { from, time }, amplitude) = if const { F::PRECISION <= f64::MANTISSA_DIGITS } {
        let least = lobes::least(at_turning_point);
        let lobe = Lobe::of(half, least, &lobes::Constants::new());
        let touch = if !lobe.is_decided {
            greatest(half, Supremum { amplitude: least, touch: None }).touch?
        } else if lobe.is_above {
            Touch::new(if lobe.side < F::int(0) { NearerEnd::Last } else { NearerEnd::First }, lobe.time)
        } else {
            return None;
        };
        let side = if touch.from == NearerEnd::Last { F::int(-1) } else { F::int(1) };
        let mut found = refined_at(half, wide, side, touch.time);
        for _ in 0..3 {
            if found.is_near {
                break;
            }
            found = refined_at(half, wide, side, found.time);
        }
        let Refined { time, amplitude, .. } = found;
        (Touch { time, ..touch }, amplitude)
    } else {
        let touch = polished(half, narrowed(*half)?)?;
        (touch, needed(half, touch.from, &at(half, touch.from, touch.time)).wide())
    };
    if (amplitude - at_turning_point).value() > F::int(0) {
        let time = time.implicit_root(|time| rise(half, from, &at(half, from, time)));
        Some((Touch { from, time }, amplitude))
    } else {
        None
    }
}

/// Whether S is below an amplitude a by at least a sixteenth of a, and a is not small compared with H. Then α
/// is above the border, and lobes that cannot reach S need not be searched.
pub(crate) fn is_far_below<F: Float>(half: &HalfPeriod<F>, amplitude: F) -> bool {
    let most = amplitude * F::ratio(15, 16);
    if !(most > turning_point(half) && most * F::int(1024) > half.h.abs()) {
        return false;
    }
    !has_lobes(half) || greatest(half, Supremum { amplitude: most, touch: None }).touch.is_none()
}

/// The least Δ₀/B with which it does not stick at its turning points, S − G: `[η + G(1 − Ω²) + 2ζΩH]/Ω²`.
#[inline(always)]
pub(crate) fn least_displacement<F: Field>(half: &HalfPeriod<F>) -> F {
    (half.static_friction + half.shift * half.one_minus_square + half.damper() * half.h)
        * half.inverse.square()
}

/// The search at a lower precision.
fn narrowed<F: Float>(half: HalfPeriod<F>) -> Option<Touch<F>> {
    at_precision!(narrowed, <F>(half: HalfPeriod<F>) -> Option<Touch<F>>, |there, back: G| {
        let half = half.map(there);
        let wide = half.wide();
        let (found, _) = supremum(&half, &wide, turning_point(&wide))?;
        Some(Touch { from: found.from, time: back(found.time) })
    })
}

/// The maximum next to one found at a lower precision: it is the only one between the zeros of p around it.
fn polished<F: Float>(half: &HalfPeriod<F>, near: Touch<F>) -> Option<Touch<F>> {
    let (first, step) = zeros(half, near.from, &at(half, near.from, F::int(0)).free)?;
    let low = first + ((near.time - first) / step).floor() * step;
    maximum_between(half, near.from, low, low + step)
}

/// The half cycle at a time from one of its ends.
fn at<F: Float>(half: &HalfPeriod<F>, from: NearerEnd, time: F) -> Moment<F> {
    match from {
        NearerEnd::First => half.at(time),
        NearerEnd::Last => half.before_end(time),
    }
}

/// The first zero of p at a time > 0 from the end given, where the free vibration is `start`, and the distance to the next;
/// `None` where it is uncertain.
pub(crate) fn zeros<N: Signed>(
    half: &HalfPeriod<N>,
    from: NearerEnd,
    start: &FreeState<N>,
) -> Option<(N, N)> {
    let (d, pi) = (half.free.frequency, N::pi());
    let (p, slope) = (half.weighted(start.v, start.x), half.weighted(start.a, start.v));
    // p = e^{−ζτ} P cos(dτ − χ); backwards in time the sine changes its sign.
    let sine = (slope + half.free.zeta * p) / d;
    let chi = match from {
        NearerEnd::First => sine.atan2(p),
        NearerEnd::Last => (-sine).atan2(p),
    };
    let angle = chi + pi / N::int(2);
    let angle = if !angle.positive()? {
        angle + pi
    } else if angle.is_above(pi) == Some(true) {
        angle - pi
    } else {
        angle
    };
    (angle.positive() == Some(true)).then(|| (angle / d, pi / d))
}

impl<F: Field> HalfPeriod<F> {
    /// `p = (Ω² + 4ζ² − 1) h′ + 2ζh`.
    pub(crate) fn weighted(&self, velocity: F, displacement: F) -> F {
        let zeta = self.free.zeta;
        (F::int(4) * zeta.square() - self.one_minus_square) * velocity + F::int(2) * zeta * displacement
    }
}

/// ρ(τ).
fn needed<F: Float>(half: &HalfPeriod<F>, from: NearerEnd, at: &Moment<F>) -> F {
    let b = half.omega * half.h;
    let n = match from {
        NearerEnd::First => shortfall(half, at),
        NearerEnd::Last => b * at.drive.1 - at.free.v,
    };
    n / (half.omega * at.drive.0)
}

/// The half cycle in pairs, at up to the precision of f64.
#[inline(always)]
fn wide_at<F: Float>(half: &HalfPeriod<Pair<F>>, from: NearerEnd, time: F) -> Moment<Pair<F>> {
    match from {
        NearerEnd::First => half.wide_at(time.wide()),
        NearerEnd::Last => half.wide_before_end(time.wide()),
    }
}

/// [`rise`] in pairs, at up to the precision of f64.
fn wide_rise<F: Float>(half: &HalfPeriod<F>, from: NearerEnd, time: F) -> (F, F) {
    fused!(<'a, F>(half: &'a HalfPeriod<F>, from: NearerEnd, time: F) -> (F, F) {
        let wide = half.in_pairs();
        let (value, slope) = rise(&wide, from, &wide_at(&wide, from, time));
        (value.value(), slope.value())
    })
}

/// [`rise`] at a time; in pairs beside the ends, where it is of the third order and its terms of the first.
fn certain_rise<F: Float>(half: &HalfPeriod<F>, from: NearerEnd, time: F) -> (F, F) {
    let is_beside = time.square() <= F::int(64) * F::epsilon().sqrt();
    if const { F::PRECISION <= f64::MANTISSA_DIGITS } && is_beside {
        wide_rise(half, from, time)
    } else {
        rise(half, from, &at(half, from, time))
    }
}

/// A maximum of ρ found in the arithmetic of the type.
#[derive(Clone, Copy)]
pub(crate) struct Refined<F> {
    /// The time since the end of the half cycle on its side, after one more step in pairs.
    pub(crate) time: F,
    /// ρ there, to more digits than the type has.
    pub(crate) amplitude: Pair<F>,
    /// Whether the step was small enough for that.
    pub(crate) is_near: bool,
}

/// [`refined`] with the state.
#[inline(always)]
fn refined_at<F: Float>(half: &HalfPeriod<F>, wide: &HalfPeriod<Pair<F>>, side: F, time: F) -> Refined<F> {
    let at = Pair::exact(time.constant());
    let waves = WideWaves::at((half.omega, half.free.zeta), side, at);
    refined(half, wide, side, time, &wide.free_from(half.free.zeta, side, &waves))
}

/// A step in pairs from a time near a maximum of ρ since the end of the half cycle on this side, 1 or −1, by the state there.
///
/// `ρ′ = v/(Ω sin² Ωτ)` with v of [`rise`], so that over the step v/v′ ρ grows by half of −v²/v′ in this place.
#[inline(always)]
pub(crate) fn refined<F: Float>(
    half: &HalfPeriod<F>,
    wide: &HalfPeriod<Pair<F>>,
    side: F,
    time: F,
    state: &WideState<F>,
) -> Refined<F> {
    let (zeta, omega, time) = (half.free.zeta, half.omega, time.constant());
    let b = wide.h * omega;
    let WideState { velocity, acceleration, drive: (sine, cosine) } = *state;
    let cosine = Pair::new(side * cosine.hi, side * cosine.lo);
    let n = b * cosine - velocity;
    let slope = -(b * omega * sine).plus(acceleration);
    let value = side * (slope * sine - n * cosine * omega).value().constant();
    let displacement = -(F::int(2) * zeta).mul_add(velocity.hi, acceleration.hi);
    let bend = -(half.weighted(velocity.hi, displacement) * sine.hi).constant();
    let pull = sine * omega;
    let amplitude = n / pull;
    let step = value / bend;
    // Its square is left of the time, and its cube of the amplitude.
    let is_near = step.square() <= F::int(64) * F::epsilon() * time.square();
    let growth = -(value * step) / (F::int(2) * (pull.hi * sine.hi).constant());
    let growth = if is_near { growth } else { F::int(0) };
    Refined { time: time - step, amplitude: amplitude + Pair::exact(growth), is_near }
}

/// n(τ) in a form that keeps its digits as τ → 0.
///
/// `n = (1 + G + 2ζb) s + b (cos Ωτ − c)`, s = e^{−ζτ} sin(dτ)/d, c = e^{−ζτ} cos dτ + ζs, where
/// `cos Ωτ − c = −2 sin((Ω+d)τ/2) sin((Ω−d)τ/2) − (e^{−ζτ} − 1) cos dτ − ζs`.
fn shortfall<F: Float>(half: &HalfPeriod<F>, at: &Moment<F>) -> F {
    let (two, d, zeta, tau) = (F::int(2), half.free.frequency, half.free.zeta, at.tau);
    let (sum, difference) = ((half.omega + d) * tau / two, (half.omega - d) * tau / two);
    let decay = (-(zeta * tau)).exp_m1();
    let differs = -(two * sum.sin() * difference.sin()) - decay * (d * tau).cos() - zeta * at.waves.sine;
    half.holding() * at.waves.sine + half.omega * half.h * differs
}

/// `g/Ω = n′ sin Ωτ − Ω n cos Ωτ`, which has the sign of ρ′, and its derivative `−p sin Ωτ`: by the time from
/// the end given.
#[inline(always)]
pub(crate) fn rise<F: Field>(half: &HalfPeriod<F>, from: NearerEnd, at: &Moment<F>) -> (F, F) {
    let ((s, c), omega, b) = (at.drive, half.omega, half.omega * half.h);
    let (n, slope) = (b * c - at.free.v, -(b * omega * s) - at.free.a);
    let value = slope * s - omega * n * c;
    let derivative = -(half.weighted(at.free.v, at.free.x) * s);
    match from {
        NearerEnd::First => (value, derivative),
        // Rising by the time from the other end is falling, and the derivative of that changes its sign
        // twice.
        NearerEnd::Last => (-value, derivative),
    }
}

/// The maximum of ρ between two neighbouring zeros of p in (0, T), by their times from the end given, if
/// there is one.
fn maximum_between<F: Float>(half: &HalfPeriod<F>, from: NearerEnd, low: F, high: F) -> Option<Touch<F>> {
    let zero = F::int(0);
    if !(low > zero && high < half.period) {
        return None;
    }
    let slope = |time: F| certain_rise(half, from, time);
    let is_maximum = slope(low).0 > zero && slope(high).0 < zero;
    is_maximum.then(|| Touch { from, time: newton_within(low, high, slope) })
}

/// The greater of `best` and all maxima of ρ.
#[cold]
#[inline(never)]
fn greatest<F: Float>(half: &HalfPeriod<F>, best: Supremum<F>) -> Supremum<F> {
    let mut best = best;
    let from_end = |from| zeros(half, from, &at(half, from, F::int(0)).free);
    let (Some((mut low, step)), Some((mut before_end, _))) =
        (from_end(NearerEnd::First), from_end(NearerEnd::Last))
    else {
        return best;
    };
    let may_exceed = |low: F, before_end: F, best: F| {
        exceeds(half, [&half.at(low), &half.before_end(before_end)], best) == Some(true)
    };
    // Lobes inwards from both ends; where the two meet both are searched.
    while low + before_end < half.period && may_exceed(low, before_end, best.amplitude) {
        for (from, time) in [(NearerEnd::First, low), (NearerEnd::Last, before_end)] {
            if let Some(touch) = maximum_between(half, from, time, time + step) {
                let amplitude = needed(half, from, &at(half, from, touch.time));
                if amplitude > best.amplitude {
                    best = Supremum { amplitude, touch: Some(touch) };
                }
            }
        }
        (low, before_end) = (low + step, before_end + step);
    }
    best
}

/// Whether ρ could exceed the supremum so far between two times; `None` where that is uncertain.
///
/// b cos Ωτ is monotone, and sin Ωτ has no minimum inside.
#[inline(always)]
pub(crate) fn exceeds<N: Signed>(
    half: &HalfPeriod<N>,
    [start, end]: [&Moment<N>; 2],
    best: N,
) -> Option<bool> {
    let b = half.omega * half.h;
    let driven = (b * start.drive.1).larger(b * end.drive.1);
    let sine = start.drive.0.smaller(end.drive.0);
    (driven + start.free.velocity_bound()).is_above(best * half.omega * sine)
}
