//! The loops below Ω = 1/2, by the same functions as a single point.

use super::super::block::{AtPoint, Block, each, select};
use super::super::level::Loops;
use super::super::stages::Answer;
use super::{Pass, Sizes, Squares, WORK, half};
use crate::cycle::damped::free::Free;
use crate::cycle::damped::from_lobe;
use crate::cycle::damped::half_period::{HalfPeriod, has_lobes};
use crate::cycle::damped::lobes::{self, Edge, EndWaves, FromEnd, Lobe, Step};
use crate::cycle::damped::long::{Long, Turn, falling};
use crate::cycle::damped::low::{Climb, Crests};
use crate::cycle::damped::rising::Rising;
use crate::cycle::damped::wide::{WideState, WideWaves};
use crate::cycle::velocity_phase;
use crate::float::circular::held;
use crate::float::pair::Pair;

/// `[1/Ω, d, the quarter turns of dT/2, what is left of it]` below Ω = 1/2, d and the last in pairs, from `[Ω, ζ]`.
struct Turns;

impl AtPoint<2, 6> for Turns {
    #[inline(always)]
    fn at(&self, [omega, zeta]: [f64; 2]) -> [f64; 6] {
        let Turn { d, inverse, quarters, acute, .. } = Turn::at(omega, zeta);
        [inverse, d.hi, d.lo, quarters, acute.hi, acute.lo]
    }
}

#[inline(always)]
fn turn_of(inverse: f64, [d, d_rest, quarters, acute, acute_rest]: [f64; 5]) -> Turn<f64> {
    let (d, acute) = (Pair::new(d, d_rest), Pair::new(acute, acute_rest));
    // 1/d serves the waves at the end, which no loop needs.
    Turn { d, inverse, over_d: f64::NAN, quarters, acute }
}

/// The sine and cosine of dT/2 in pairs from the last three results of [`Turns`].
struct SinCos;

impl AtPoint<3, 4> for SinCos {
    #[inline(always)]
    fn at(&self, [quarters, acute, acute_rest]: [f64; 3]) -> [f64; 4] {
        let (sine, cosine) = turn_of(f64::NAN, [f64::NAN, f64::NAN, quarters, acute, acute_rest]).sin_cos();
        [sine.hi, sine.lo, cosine.hi, cosine.lo]
    }
}

/// `[e^{−ζT/2} − 1, e^{−ζT/2}]` in pairs from `[Ω, ζ, 1/Ω]`.
struct Falling;

impl AtPoint<3, 4> for Falling {
    #[inline(always)]
    fn at(&self, [omega, zeta, inverse]: [f64; 3]) -> [f64; 4] {
        let (fall, decay) = falling(omega, zeta, inverse);
        [fall.hi, fall.lo, decay.hi, decay.lo]
    }
}

/// `[G, H]` in pairs from `[Ω, ζ]`, the first three results of [`Turns`], and those of [`SinCos`] and [`Falling`]; NaN where
/// the point must be recomputed.
struct LongResponses;

impl AtPoint<13, 4> for LongResponses {
    #[inline(always)]
    fn at(&self, [omega, zeta, inverse, d, d_rest, waves @ ..]: [f64; 13]) -> [f64; 4] {
        let turn = turn_of(inverse, [d, d_rest, f64::NAN, f64::NAN, f64::NAN]);
        let [sine, sine_rest, cosine, cosine_rest, fall, fall_rest, decay, decay_rest] = waves;
        let swing = (Pair::new(sine, sine_rest), Pair::new(cosine, cosine_rest));
        let falling = (Pair::new(fall, fall_rest), Pair::new(decay, decay_rest));
        let Long { shift, h, is_accurate, .. } = Long::of(omega, zeta, &turn, swing, falling);
        [select(is_accurate, shift.hi, f64::NAN), shift.lo, h.hi, h.lo]
    }
}

/// `[d, 1/d]` from `[ζ]`.
struct Frequencies;

impl AtPoint<1, 2> for Frequencies {
    #[inline(always)]
    fn at(&self, [zeta]: [f64; 1]) -> [f64; 2] {
        let d = Free::new(zeta).frequency;
        [d, 1.0 / d]
    }
}

/// The end with the lobe below Ω = 1/2.
struct Edges;

impl AtPoint<8, 4> for Edges {
    /// `[side, the cosine and sine of the first zero of p, mark]` from 1/d and the inputs of [`half`]: the mark is 1 where there
    /// is a lobe, else 0, and NaN where the point must be recomputed.
    #[inline(always)]
    fn at(&self, [over_d, given @ ..]: [f64; 8]) -> [f64; 4] {
        let Edge { side, zero: (cosine, sine), has_lobe, is_alone, .. } = Edge::of(&half(given), over_d);
        [side, cosine, sine, select(is_alone, select(has_lobe, 1.0, 0.0), f64::NAN)]
    }
}

/// The half cycle below Ω = 1/2 from that end.
struct Ends;

impl AtPoint<13, 4> for Ends {
    /// `[the angle of the first zero of p, own, far, mark]` from `[d, 1/d]`, the results of [`Edges`] and the inputs of
    /// [`half`]: the mark is 1 where the lobe has a maximum, else 0, and NaN where the point must be recomputed.
    #[inline(always)]
    fn at(&self, [d, over_d, side, cosine, sine, mark, given @ ..]: [f64; 13]) -> [f64; 4] {
        let half = with_frequency(half(given), d);
        let (has_lobe, is_alone) = (mark > 0.0, !mark.is_nan());
        let edge = Edge { side, over_d, zero: (cosine, sine), has_lobe, is_alone };
        let FromEnd { angle, own, far, has_maximum, is_clear, .. } = FromEnd::of(&half, &edge);
        [angle, own, far, select(is_clear, select(has_maximum, 1.0, 0.0), f64::NAN)]
    }
}

#[inline(always)]
fn with_frequency(half: HalfPeriod<f64>, frequency: f64) -> HalfPeriod<f64> {
    HalfPeriod { free: Free { frequency, ..half.free }, ..half }
}

/// The half period and its end from `[d, 1/d, side, cosine, sine]`, the results of [`Ends`] and the inputs of [`half`].
#[inline(always)]
fn end_of(
    [d, over_d, side, cosine, sine, angle, own, far, mark, given @ ..]: [f64; 16],
) -> (HalfPeriod<f64>, FromEnd<f64>) {
    let (has_maximum, is_clear) = (mark > 0.0, !mark.is_nan());
    let from = FromEnd { side, over_d, zero: (cosine, sine), angle, own, far, has_maximum, is_clear };
    (with_frequency(half(given), d), from)
}

/// The waves at a place in the lobe, `[sin y, cos y, sin Ωτ, cos Ωτ, e^{−ζτ}]`.
struct LobeWaves(lobes::Constants<f64>);

#[inline(always)]
fn five(EndWaves { swing, drive, decay }: EndWaves<f64>) -> [f64; 5] {
    [swing.0, swing.1, drive.0, drive.1, decay]
}

impl AtPoint<16, 6> for LobeWaves {
    /// After the place y itself at the start, from the inputs of [`end_of`].
    #[inline(always)]
    fn at(&self, given: [f64; 16]) -> [f64; 6] {
        let (half, from) = end_of(given);
        let y = from.start(&half);
        let [a, b, c, d, e] = five(from.waves(&half, y, &self.0));
        [y, a, b, c, d, e]
    }
}

impl AtPoint<17, 5> for LobeWaves {
    /// At y, from this and the inputs of [`end_of`].
    #[inline(always)]
    fn at(&self, [y, given @ ..]: [f64; 17]) -> [f64; 5] {
        let (half, from) = end_of(given);
        five(from.waves(&half, y, &self.0))
    }
}

/// A step to the maximum in the lobe, `[y, ρ]`; ρ is NaN where it is not near.
struct Steps;

#[inline(always)]
fn parts(Step { y, amplitude, is_near }: Step<f64>) -> [f64; 2] {
    [y, select(is_near, amplitude, f64::NAN)]
}

#[inline(always)]
fn step_of([y, amplitude]: [f64; 2]) -> Step<f64> {
    Step { y, amplitude, is_near: !amplitude.is_nan() }
}

impl AtPoint<22, 2> for Steps {
    /// The first, from y, the waves there and the inputs of [`end_of`].
    #[inline(always)]
    fn at(&self, [y, a, b, c, d, decay, given @ ..]: [f64; 22]) -> [f64; 2] {
        let (half, from) = end_of(given);
        parts(from.step(&half, y, &EndWaves { swing: (a, b), drive: (c, d), decay }))
    }
}

impl AtPoint<23, 2> for Steps {
    /// The second, from the first, the waves there and the inputs of [`end_of`].
    #[inline(always)]
    fn at(&self, [y, amplitude, given @ ..]: [f64; 23]) -> [f64; 2] {
        let [a, b, c, d, e, given @ ..] = given;
        let first = step_of([y, amplitude]);
        let [f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u] = given;
        let next = self.at([y, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u]);
        parts(first.or(step_of(next)))
    }
}

/// The only lobe of the border's condition that may exceed the turning point.
struct Lobes(lobes::Constants<f64>);

impl AtPoint<20, 2> for Lobes {
    /// `[time, mark]` from S at the turning point, the last step and the inputs of [`end_of`]: the mark is 1 where there is
    /// one, else 0, and NaN where the point must be recomputed.
    #[inline(always)]
    fn at(&self, [least, rest, y, amplitude, given @ ..]: [f64; 20]) -> [f64; 2] {
        let (half, from) = end_of(given);
        let (least, step) = (lobes::least(Pair::new(least, rest)), step_of([y, amplitude]));
        let Lobe { time, is_above, is_decided, .. } = from.lobe::<true>(&half, least, step, &self.0);
        let mark = select(is_above, 1.0, 0.0);
        [time, select(is_decided, mark, f64::NAN)]
    }
}

/// `[1/d, sin dτ, cos dτ]` in pairs from `[ζ, τ]`.
struct Swings;

impl AtPoint<2, 6> for Swings {
    #[inline(always)]
    fn at(&self, [zeta, time]: [f64; 2]) -> [f64; 6] {
        let (over_d, (sine, cosine)) = WideWaves::swing(zeta, Pair::exact(time));
        [over_d.hi, over_d.lo, sine.hi, sine.lo, cosine.hi, cosine.lo]
    }
}

/// `e^{−ζτ}` in a pair from `[ζ, side, τ]`.
struct Decays;

impl AtPoint<3, 2> for Decays {
    #[inline(always)]
    fn at(&self, [zeta, side, time]: [f64; 3]) -> [f64; 2] {
        let Pair { hi, lo } = WideWaves::decay(zeta, side, Pair::exact(time));
        [hi, lo]
    }
}

impl AtPoint<2, 2> for Decays {
    /// From the first end, `[ζ, τ]`.
    #[inline(always)]
    fn at(&self, [zeta, time]: [f64; 2]) -> [f64; 2] {
        self.at([zeta, 1.0, time])
    }
}

/// `[sin Ωτ, cos Ωτ]` in pairs from `[Ω, τ]`.
struct Drives;

impl AtPoint<2, 4> for Drives {
    #[inline(always)]
    fn at(&self, [omega, time]: [f64; 2]) -> [f64; 4] {
        let (sine, cosine) = WideWaves::drive(omega, Pair::exact(time));
        [sine.hi, sine.lo, cosine.hi, cosine.lo]
    }
}

/// The waves from the results of [`Swings`], [`Decays`] and [`Drives`].
#[inline(always)]
fn waves_of([a, b, c, d, e, f, g, h, i, j, k, l]: [f64; 12]) -> WideWaves<f64> {
    let of = Pair::new;
    WideWaves { over_d: of(a, b), swing: (of(c, d), of(e, f)), decay: of(g, h), drive: (of(i, j), of(k, l)) }
}

/// Free vibration at the lobe's maximum, `[h′, h″]` in pairs.
struct States;

impl AtPoint<20, 4> for States {
    /// From the side, the inputs of [`waves_of`] and of [`half`].
    #[inline(always)]
    fn at(&self, [side, a, b, c, d, e, f, g, h, i, j, k, l, given @ ..]: [f64; 20]) -> [f64; 4] {
        let half = half(given);
        let waves = waves_of([a, b, c, d, e, f, g, h, i, j, k, l]);
        let WideState { velocity, acceleration, .. } = half.wide().free_from(half.free.zeta, side, &waves);
        [velocity.hi, velocity.lo, acceleration.hi, acceleration.lo]
    }
}

/// `[α_min]`.
struct Borders;

impl AtPoint<22, 1> for Borders {
    /// From η, `[side, time, mark]` of the lobe, the force ratio at the turning point, S there, the results of [`States`] and
    /// [`Drives`] and the inputs of [`half`].
    #[inline(always)]
    fn at(&self, [eta, side, time, mark, at_turning_point, least, rest, given @ ..]: [f64; 22]) -> [f64; 1] {
        let ([a, b, c, d, e, f, g, h, given @ ..], of) = (given, Pair::new);
        let half = half(given).with_static_friction(eta);
        let drive = (of(e, f), of(g, h));
        let state = WideState { velocity: of(a, b), acceleration: of(c, d), drive };
        let at_end = (of(least, rest), at_turning_point);
        let (border, is_near) = from_lobe(&half, (side, time), &state, at_end);
        let border = select(is_near, border, f64::NAN);
        [select(mark.is_nan(), f64::NAN, select(mark > 0.0, border, at_turning_point))]
    }
}

/// The half cycle from `[Δ₀, the low part of Δ₀, a]` and the inputs of [`half`].
#[inline(always)]
fn known([max_displacement, rest, amplitude, given @ ..]: [f64; 10]) -> Rising<f64> {
    Rising { half: half(given), amplitude, max_displacement, rest }
}

/// The velocity's driven part below Ω = 1/2: its size, the time of its crest, and the free part's velocity at the start, from the
/// inputs of [`known`].
struct Driven;

impl AtPoint<10, 3> for Driven {
    #[inline(always)]
    fn at(&self, given: [f64; 10]) -> [f64; 3] {
        Crests::driven(&known(given))
    }
}

/// `[K sin e, K cos e]` of the free part at that crest.
struct FreeParts(lobes::Constants<f64>);

impl AtPoint<13, 2> for FreeParts {
    /// From `[d, 1/d]`, the time of the crest and the inputs of [`known`].
    #[inline(always)]
    fn at(&self, [d, over_d, centre, given @ ..]: [f64; 13]) -> [f64; 2] {
        let rising = known(given);
        let rising = Rising { half: with_frequency(rising.half, d), ..rising };
        let waves = Crests::waves_near(&rising.half.free, over_d, centre, &self.0);
        Crests::free_at(&rising, over_d, waves).into()
    }
}

/// `[K, e]` from these.
struct Polar;

impl AtPoint<2, 2> for Polar {
    #[inline(always)]
    fn at(&self, [sine, cosine]: [f64; 2]) -> [f64; 2] {
        Crests::polar((sine, cosine))
    }
}

/// Steps to the maximum velocity: `[δ, a time near the maximum, the velocity]`; δ is NaN where no further step may find it, the time
/// until one has.
struct Climbs(lobes::Constants<f64>);

#[inline(always)]
fn marked(Climb { delta, is_open, is_found, time, velocity }: Climb<f64>) -> [f64; 3] {
    [select(is_open, delta, f64::NAN), select(is_found, time, f64::NAN), velocity]
}

#[inline(always)]
fn climb_of([delta, time, velocity]: [f64; 3]) -> Climb<f64> {
    Climb { delta, is_open: !delta.is_nan(), is_found: !time.is_nan(), time, velocity }
}

impl AtPoint<9, 3> for Climbs {
    /// Before the first, from `[Ω, ζ]` and the parts of [`Crests`].
    #[inline(always)]
    fn at(&self, [omega, zeta, crests @ ..]: [f64; 9]) -> [f64; 3] {
        marked(Crests::of_parts((omega, zeta), crests, &self.0).foot())
    }
}

impl AtPoint<12, 3> for Climbs {
    /// The next, from the one before and these.
    #[inline(always)]
    fn at(&self, [delta, time, velocity, omega, zeta, crests @ ..]: [f64; 12]) -> [f64; 3] {
        marked(Crests::of_parts((omega, zeta), crests, &self.0).climb(&climb_of([delta, time, velocity])))
    }
}

/// A time near the maximum velocity below Ω = 1/2; NaN where it is not known.
struct LongStart(lobes::Constants<f64>);

impl AtPoint<12, 1> for LongStart {
    /// From the inputs of [`Climbs`].
    #[inline(always)]
    fn at(&self, [delta, time, velocity, omega, zeta, crests @ ..]: [f64; 12]) -> [f64; 1] {
        let crests = Crests::of_parts((omega, zeta), crests, &self.0);
        [select(crests.is_greatest(&climb_of([delta, time, velocity])), time, f64::NAN)]
    }
}

/// The maximum velocity below Ω = 1/2.
struct LongArrival;

impl AtPoint<25, 4> for LongArrival {
    /// `[V₀, ω_d t₁, α_min, Δ₁]` from a time near it, ω_d t₂, α_min and the inputs of [`waves_of`] and of [`known`]; a NaN in
    /// α_min means that the velocity must be recomputed.
    #[inline(always)]
    fn at(
        &self,
        [time, phase2, border, a, b, c, d, e, f, g, h, i, j, k, l, given @ ..]: [f64; 25],
    ) -> [f64; 4] {
        let (rising, waves) = (known(given), waves_of([a, b, c, d, e, f, g, h, i, j, k, l]));
        let (summit, _, is_near) = rising.arrive_below(Pair::exact(time), &waves);
        let is_inside = (time > 0.0) & (time < rising.half.period);
        // Without a cycle there is nothing to find.
        let is_found = (is_near & is_inside) | rising.max_displacement.is_nan();
        [
            summit.velocity,
            velocity_phase(phase2, rising.half.omega, -summit.sigma),
            select(is_found, border, f64::NAN),
            summit.displacement,
        ]
    }
}

/// Computes the velocity of place `i` by the search for a single point, if all else is known after a pass, and returns whether
/// it is.
pub(super) fn has_summit(
    [omega, _, zeta, _]: &[Block; 4],
    found: &mut Answer,
    work: &[Block; WORK],
    i: usize,
) -> bool {
    let at = |block: &Block| block.get(i).copied().unwrap_or(f64::NAN);
    let [inverse, shift, shift_rest, h, h_rest, _, _, _, _, _, mark, rest, amplitude, ..] = work;
    let [delta, border, _, phase2, _, velocity, phase1, deviation, _] = found;
    let given = [delta, rest, amplitude, omega, zeta, inverse, shift, shift_rest, h, h_rest].map(at);
    let (rising, border_known) = (known(given), at(mark));
    if border_known.is_nan() || rising.max_displacement.is_nan() || !has_lobes(&rising.half) {
        return false;
    }
    let summit = rising.summit();
    let phase = velocity_phase(at(phase2), rising.half.omega, -summit.sigma);
    let answers = [summit.velocity, phase, summit.displacement, border_known];
    for (block, answer) in [velocity, phase1, deviation, border].into_iter().zip(answers) {
        if let Some(slot) = block.get_mut(i) {
            *slot = answer;
        }
    }
    true
}

/// The pass below Ω = 1/2, in loops of which none waits long for its own results.
pub(super) struct LongPass<'a>(pub(super) Pass<'a>);

impl Loops for LongPass<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Pass { wanted, given: [omega, alpha, zeta, eta], found, work } = self.0;
        let [inverse, shift, shift_rest, h, h_rest, square, square_rest, least, least_rest, work @ ..] = work;
        let [delta, border, size1, phase2, size2, velocity, phase1, deviation, _] = found;
        {
            let [d, d_rest, quarters, acute, acute_rest, work @ ..] = &mut *work;
            let [sine, sine_rest, cosine, cosine_rest, fall, fall_rest, decay, decay_rest, ..] = work;
            let turns = [&mut *inverse, &mut *d, &mut *d_rest, &mut *quarters, &mut *acute, &mut *acute_rest];
            each(&Turns, [omega, zeta], turns);
            let swing = [&mut *sine, &mut *sine_rest, &mut *cosine, &mut *cosine_rest];
            each(&SinCos, [quarters, acute, acute_rest], swing);
            let falling = [&mut *fall, &mut *fall_rest, &mut *decay, &mut *decay_rest];
            each(&Falling, [omega, zeta, inverse], falling);
            let waves = [sine, sine_rest, cosine, cosine_rest, fall, fall_rest, decay, decay_rest];
            let [a, b, c, e, f, g, i, j] = waves.map(|block| &*block);
            let given = [omega, zeta, inverse, d, d_rest, a, b, c, e, f, g, i, j];
            each(&LongResponses, given, [&mut *shift, &mut *shift_rest, &mut *h, &mut *h_rest]);
        }
        let [i, j, k, l, m, n, o] = [omega, zeta, &*inverse, shift, shift_rest, h, h_rest];
        {
            let [turning, side, time, mark, work @ ..] = &mut *work;
            let squares = [&mut *square, square_rest, &mut *least, &mut *least_rest, &mut *turning];
            each(&Squares, [alpha, eta, i, j, k, l, m, n, o], squares);
            {
                let [d, over_d, cosine, sine, angle, own, far, has, work @ ..] = &mut *work;
                each(&Frequencies, [zeta], [&mut *d, &mut *over_d]);
                let edges = [&mut *side, &mut *cosine, &mut *sine, &mut *mark];
                each(&Edges, [&*over_d, i, j, k, l, m, n, o], edges);
                let given = [&*d, over_d, side, cosine, sine, mark, i, j, k, l, m, n, o];
                each(&Ends, given, [&mut *angle, &mut *own, &mut *far, &mut *has]);
                let end = [&*d, over_d, side, cosine, sine, angle, own, far, has];
                let [a, b, c, d, e, f, g, h, p] = end;
                let [y, rho, next, at_next, u, v, w, x, z, ..] = work;
                let waves = LobeWaves(held(lobes::Constants::new()));
                let given = [a, b, c, d, e, f, g, h, p, i, j, k, l, m, n, o];
                each::<16, 6>(&waves, given, [&mut *y, &mut *u, &mut *v, &mut *w, &mut *x, &mut *z]);
                let given = [&*y, u, v, w, x, z, a, b, c, d, e, f, g, h, p, i, j, k, l, m, n, o];
                each::<22, 2>(&Steps, given, [&mut *next, &mut *at_next]);
                let given = [&*next, a, b, c, d, e, f, g, h, p, i, j, k, l, m, n, o];
                each::<17, 5>(&waves, given, [&mut *u, &mut *v, &mut *w, &mut *x, &mut *z]);
                let given = [&*next, at_next, u, v, w, x, z, a, b, c, d, e, f, g, h, p, i, j, k, l, m, n, o];
                each::<23, 2>(&Steps, given, [&mut *y, &mut *rho]);
                let given = [&*least, least_rest, y, rho, a, b, c, d, e, f, g, h, p, i, j, k, l, m, n, o];
                each(&Lobes(held(lobes::Constants::new())), given, [time, mark]);
            }
            let [a, b, c, d, e, f, g, h, p, q, r, s, w, x, y, z, ..] = work;
            each(&Swings, [zeta, time], [&mut *a, b, c, d, e, f]);
            each::<3, 2>(&Decays, [zeta, side, time], [&mut *g, h]);
            each(&Drives, [omega, time], [&mut *p, q, r, s]);
            let given = [&*side, a, b, c, d, e, f, g, h, p, q, r, s, i, j, k, l, m, n, o];
            each(&States, given, [&mut *w, &mut *x, &mut *y, &mut *z]);
            let given = [eta, &*side, time, mark, turning, least, least_rest];
            let [a, b, c, d, e, f, g] = given;
            let given = [a, b, c, d, e, f, g, w, x, y, z, p, q, r, s, i, j, k, l, m, n, o];
            each(&Borders, given, [&mut *border]);
        }
        let [time, mark, rest, amplitude, a, b, c, d, e, f, g, p, q, r, s, t, ..] = work;
        let given = [alpha, square, square_rest, least, least_rest, border, i, j, k, l, m, n, o];
        if !wanted.more {
            return each::<13, 2>(&Sizes, given, [delta, size1]);
        }
        each::<13, 6>(&Sizes, given, [&mut *delta, size1, phase2, size2, rest, amplitude]);
        if wanted.velocity {
            let constants = held(lobes::Constants::new());
            each(&Frequencies, [zeta], [&mut *a, &mut *b]);
            each(&Driven, [delta, rest, amplitude, i, j, k, l, m, n, o], [&mut *c, &mut *f, &mut *g]);
            let given = [&*a, b, f, delta, rest, amplitude, i, j, k, l, m, n, o];
            each(&FreeParts(constants), given, [&mut *p, &mut *q]);
            each(&Polar, [p, q], [&mut *d, &mut *e]);
            {
                let [a, b, c, d, e, f, g] = [&*a, &*b, &*c, &*d, &*e, &*f, &*g];
                let climbs = Climbs(constants);
                let given = [omega, zeta, a, b, c, d, e, f, g];
                each::<9, 3>(&climbs, given, [&mut *p, &mut *q, &mut *r]);
                let given = [&*p, q, r, omega, zeta, a, b, c, d, e, f, g];
                each::<12, 3>(&climbs, given, [&mut *s, &mut *t, &mut *mark]);
                let given = [&*s, t, mark, omega, zeta, a, b, c, d, e, f, g];
                each::<12, 3>(&climbs, given, [&mut *p, &mut *q, &mut *r]);
                let given = [&*p, q, r, omega, zeta, a, b, c, d, e, f, g];
                each::<12, 3>(&climbs, given, [&mut *s, &mut *t, &mut *mark]);
                let given = [&*s, t, mark, omega, zeta, a, b, c, d, e, f, g];
                each(&LongStart(constants), given, [&mut *time]);
            }
            mark.copy_from_slice(border);
            each(&Swings, [zeta, time], [&mut *a, b, c, d, e, f]);
            each::<2, 2>(&Decays, [zeta, time], [&mut *g, p]);
            each(&Drives, [omega, time], [&mut *q, r, s, t]);
            let given = [time, phase2, &*mark, a, b, c, d, e, f, g, p, q, r, s, t, delta, rest, amplitude];
            let [a, b, c, d, e, f, g, h, p, q, r, s, t, u, v, w, x, y] = given;
            let given = [a, b, c, d, e, f, g, h, p, q, r, s, t, u, v, w, x, y, i, j, k, l, m, n, o];
            each(&LongArrival, given, [velocity, phase1, border, deviation]);
        }
    }
}
