//! Points that may have a damper and static friction: the outputs of [`LOOPED`] except λ by loops, all others point by
//! point.

mod low;

use super::alone;
use super::block::{AtPoint, Block, POINTS, each, select, set};
use super::columns::{BORDER, LOOPED, Looped, Slices};
use super::level::{Level, Loops};
use super::stages::Answer;
use super::straight::is_any_nan;
use crate::cycle::damped::half_period::HalfPeriod;
use crate::cycle::damped::middle::{Constants, Crest, Middle};
use crate::cycle::damped::rising::Rising;
use crate::cycle::damped::tangent::Angle;
use crate::cycle::damped::{displacement_phase, exists, from_turning_point};
use crate::cycle::regime::regime_of;
use crate::cycle::velocity_phase;
use crate::float::circular::{Swell, held};
use crate::float::pair::Pair;
use crate::machine::ratios::Ratios;
use crate::output::Output;
use low::LongPass;

/// `[d, γ, 1/Ω]`, the first two in pairs, from `[Ω, ζ]`.
struct Turning;

impl AtPoint<2, 5> for Turning {
    #[inline(always)]
    fn at(&self, [omega, zeta]: [f64; 2]) -> [f64; 5] {
        let Angle { d, gamma, inverse } = Angle::at(omega, zeta);
        [d.hi, d.lo, gamma.hi, gamma.lo, inverse]
    }
}

/// `[G, H]` in pairs from `[Ω, ζ]` and the results of [`Turning`]; NaN where the point must be recomputed.
struct Responses(Swell<f64>);

impl AtPoint<7, 4> for Responses {
    #[inline(always)]
    fn at(&self, [omega, zeta, angle @ ..]: [f64; 7]) -> [f64; 4] {
        let (shift, h, is_accurate) = angle_of(angle).responses(omega, zeta, &self.0);
        [select(is_accurate & (zeta > 0.0), shift.hi, f64::NAN), shift.lo, h.hi, h.lo]
    }
}

#[inline(always)]
fn angle_of([d, d_rest, gamma, gamma_rest, inverse]: [f64; 5]) -> Angle<f64> {
    let (d, gamma) = (Pair::new(d, d_rest), Pair::new(gamma, gamma_rest));
    Angle { d, gamma, inverse }
}

/// The half period from `[Ω, ζ]`, 1/Ω and the results of [`Responses`].
#[inline(always)]
fn half([omega, zeta, inverse, shift, shift_rest, h, h_rest]: [f64; 7]) -> HalfPeriod<f64> {
    HalfPeriod::of_responses(omega, zeta, inverse, Pair::new(shift, shift_rest), Pair::new(h, h_rest))
}

/// `[a², S, α_min]`, the first two in pairs, from `[α, η]` and the inputs of [`half`]; a NaN in α_min means that the
/// point must be recomputed.
struct Squares;

impl AtPoint<9, 5> for Squares {
    #[inline(always)]
    fn at(&self, [alpha, eta, given @ ..]: [f64; 9]) -> [f64; 5] {
        let (square, least, border) = from_turning_point(&half(given).with_static_friction(eta), alpha);
        [square.hi, square.lo, least.hi, least.lo, border]
    }
}

/// The half cycle from `[α, a², S, α_min]` and the inputs of [`half`], and whether there is one.
#[inline(always)]
fn rising(
    [alpha, square, square_rest, least, least_rest, border, given @ ..]: [f64; 13],
) -> (Rising<f64>, bool) {
    let (square, least) = (Pair::new(square, square_rest), Pair::new(least, least_rest));
    (Rising::of_square(half(given), square, least), exists(alpha, border))
}

/// `[Δ₀, A₁]` from the inputs of [`rising`].
struct Sizes;

impl AtPoint<13, 2> for Sizes {
    #[inline(always)]
    fn at(&self, given: [f64; 13]) -> [f64; 2] {
        let (rising, slides) = rising(given);
        let size = rising.loop_sizes(given[0]).0;
        [select(slides, rising.max_displacement, f64::NAN), select(slides, size, f64::NAN)]
    }
}

impl AtPoint<13, 6> for Sizes {
    /// The same and `[ω_d t₂, A₂, the low part of Δ₀, a]`.
    #[inline(always)]
    fn at(&self, given: [f64; 13]) -> [f64; 6] {
        let (rising, slides) = rising(given);
        let ((size1, size2), phase) = (rising.loop_sizes(given[0]), displacement_phase(rising.drive()));
        [
            select(slides, rising.max_displacement, f64::NAN),
            select(slides, size1, f64::NAN),
            select(slides, phase, f64::NAN),
            select(slides, size2, f64::NAN),
            rising.rest,
            rising.amplitude,
        ]
    }
}

impl AtPoint<13, 8> for Sizes {
    /// The outputs of the smaller loop, and `[ω_d t₂, A₂, α_min, the low part of Δ₀]` with f_c and f_s of the drive; a NaN in α_min means that
    /// the point must be recomputed.
    #[inline(always)]
    fn at(&self, given: [f64; 13]) -> [f64; 8] {
        let (rising, slides) = rising(given);
        let ((size1, size2), drive) = (rising.loop_sizes(given[0]), rising.drive());
        let phase = displacement_phase(drive);
        [
            select(slides, rising.max_displacement, f64::NAN),
            select(slides, size1, f64::NAN),
            select(slides, phase, f64::NAN),
            select(slides, size2, f64::NAN),
            select(!slides | rising.does_not_stick(), given[5], f64::NAN),
            rising.rest,
            drive.0.value(),
            drive.1.value(),
        ]
    }
}

/// The middle of the half cycle from `[Ω, ζ]`, the results of [`Turning`] and G.
struct Middles;

#[inline(always)]
fn middle([omega, zeta, angle @ .., shift]: [f64; 8]) -> Middle<f64> {
    angle_of(angle).middle(omega, zeta, shift)
}

impl AtPoint<8, 2> for Middles {
    /// Without the displacement.
    #[inline(always)]
    fn at(&self, given: [f64; 8]) -> [f64; 2] {
        let Middle { velocity, slope, .. } = middle(given);
        [velocity, slope]
    }
}

impl AtPoint<8, 3> for Middles {
    #[inline(always)]
    fn at(&self, given: [f64; 8]) -> [f64; 3] {
        let Middle { velocity, slope, displacement } = middle(given);
        [velocity, slope, displacement]
    }
}

/// The peak velocity.
struct Arrival(Constants<f64>);

impl Arrival {
    #[inline(always)]
    fn new() -> Self {
        Self(held(Constants::new()))
    }
}

impl AtPoint<11, 4> for Arrival {
    /// `[V₀, ω_d t₁, α_min, Δ₁]` from `[Ω, ζ, f_c, f_s, Δ₀, the low part of Δ₀, ω_d t₂, α_min]` and the middle; a NaN
    /// in α_min means that the velocity must be recomputed.
    #[inline(always)]
    fn at(
        &self,
        [omega, zeta, along, across, delta, rest, phase2, border, velocity, slope, displacement]: [f64; 11],
    ) -> [f64; 4] {
        let middle = Middle { velocity, slope, displacement };
        let Crest { sigma, velocity, displacement, is_found } =
            middle.arrive(&self.0, (omega, zeta), (along, across), Pair::new(delta, rest));
        // Without a cycle there is nothing to find.
        let border = select(is_found | delta.is_nan(), border, f64::NAN);
        [velocity, velocity_phase(phase2, omega, -sigma), border, displacement]
    }
}

impl AtPoint<10, 3> for Arrival {
    /// V₀ and its phase, without Δ₁.
    #[inline(always)]
    fn at(&self, [a, b, c, d, e, f, g, h, velocity, slope]: [f64; 10]) -> [f64; 3] {
        let [velocity, phase, border, _] = self.at([a, b, c, d, e, f, g, h, velocity, slope, 0.0]);
        [velocity, phase, border]
    }
}

/// The outputs beyond {Δ₀, α_min, A₁} that are asked for.
#[derive(Clone, Copy)]
struct Wanted {
    more: bool,
    velocity: bool,
    deviation: bool,
}

impl Wanted {
    fn of(out: &Looped<'_>) -> Self {
        Self { more: out.has(3..8), velocity: out.has(5..8), deviation: out.has(7..8) }
    }
}

/// Blocks for what passes from one loop to the next.
const WORK: usize = 30;

struct Pass<'a> {
    wanted: Wanted,
    given: &'a [Block; 4],
    found: &'a mut Answer,
    work: &'a mut [Block; WORK],
}

impl Loops for Pass<'_> {
    type Output = ();

    /// Several loops, each short enough for the processor to compute several of its rounds at a time.
    #[inline(always)]
    fn run(self) {
        let Self { wanted, given: [omega, alpha, zeta, eta], found, work } = self;
        let [a, b, c, d, e, shift, shift_rest, h, h_rest, work @ ..] = work;
        let [square, square_rest, least, least_rest, rest, along, across, mark, middle @ ..] = work;
        let [delta, border, size1, phase2, size2, velocity, phase1, deviation, _] = found;
        each(&Turning, [omega, zeta], [&mut *a, b, c, d, e]);
        let responses = Responses(held(Swell::new()));
        each(&responses, [omega, zeta, a, b, c, d, e], [&mut *shift, shift_rest, h, h_rest]);
        let [i, j, k, l, m, n, o] = [omega, zeta, &*e, shift, shift_rest, h, h_rest];
        let squares = [&mut *square, square_rest, least, least_rest, &mut *border];
        each(&Squares, [alpha, eta, i, j, k, l, m, n, o], squares);
        let given = [alpha, square, square_rest, least, least_rest, border, i, j, k, l, m, n, o];
        if !wanted.more {
            return each::<13, 2>(&Sizes, given, [delta, size1]);
        }
        each::<13, 8>(&Sizes, given, [&mut *delta, size1, phase2, size2, mark, rest, along, across]);
        if !wanted.velocity {
            *border = *mark;
            return;
        }
        let given = [omega, zeta, a, b, c, d, e, shift];
        let [x, v, w, ..] = middle;
        let at = [omega, zeta, &*along, across, delta, rest, phase2, mark];
        let [i, j, k, l, m, n, o, q] = at;
        if wanted.deviation {
            each::<8, 3>(&Middles, given, [&mut *v, w, x]);
            let given = [i, j, k, l, m, n, o, q, v, w, x];
            each::<11, 4>(&Arrival::new(), given, [velocity, phase1, border, deviation]);
        } else {
            each::<8, 2>(&Middles, given, [&mut *v, w]);
            each::<10, 3>(&Arrival::new(), [i, j, k, l, m, n, o, q, v, w], [velocity, phase1, border]);
        }
    }
}

/// Points below Ω = 1/2 from blocks with others among them, until they fill a block: their ratios, and their places.
struct Gathered {
    given: [Block; 4],
    places: [usize; POINTS],
    count: usize,
}

/// What a run of loops over points with a damper shares.
struct Run<'a> {
    level: Level,
    wanted: Wanted,
    out: Looped<'a>,
    found: Answer,
    work: [Block; WORK],
}

impl Run<'_> {
    /// Computes the points of a block that are below Ω = 1/2, or the others.
    fn block(&mut self, given: &[Block; 4], count: usize, is_low: bool) {
        let Self { level, wanted, found, work, .. } = self;
        let [omegas, _, zetas, _] = given;
        // Without a damper the loops would leave every point.
        let has_loops = *level != Level::Scalar && zetas.iter().any(|&zeta| zeta > 0.0);
        if !has_loops {
            found[BORDER].fill(f64::NAN);
        } else {
            let pass = Pass { wanted: *wanted, given, found, work };
            if is_low { level.run(LongPass(pass)) } else { level.run(pass) }
        }
        if is_any_nan(&found[BORDER]) {
            for (i, &omega) in omegas.iter().enumerate().take(count) {
                let is_left = found[BORDER].get(i).is_some_and(|border| border.is_nan());
                if is_left && is_low == is_below(omega) {
                    if has_loops && is_low && wanted.velocity && low::has_summit(given, found, work, i) {
                        continue;
                    }
                    if wanted.more {
                        set(found, i, alone::all(point_at(given, i)));
                    } else {
                        set(found, i, alone::amplitude(point_at(given, i)));
                    }
                }
            }
        }
    }

    /// Writes the answers of a block.
    fn put(&mut self, given: &[Block; 4], first: usize, count: usize) {
        let Self { out, found, .. } = self;
        out.put_numbers(first, count, found);
        let regimes = out.regime.iter_mut().flat_map(|slice| slice.iter_mut().skip(first)).take(count);
        for (i, (slot, &border)) in regimes.zip(&found[BORDER]).enumerate() {
            *slot = point_at(given, i).map(|ratios| regime_of(ratios, border));
        }
    }

    /// Computes the points that were gathered, and writes their answers.
    fn gathered(&mut self, points: &mut Gathered) {
        self.block(&points.given, points.count, true);
        let Self { out, found, .. } = self;
        for (i, &place) in points.places.iter().enumerate().take(points.count) {
            for (slice, block) in out.numbers.iter_mut().zip(&*found) {
                let slot = slice.as_mut().and_then(|slice| slice.get_mut(place));
                if let (Some(slot), Some(&value)) = (slot, block.get(i)) {
                    *slot = value;
                }
            }
            if let Some(slot) = out.regime.as_mut().and_then(|slice| slice.get_mut(place)) {
                let border = found[BORDER].get(i).copied().unwrap_or(f64::NAN);
                *slot = point_at(&points.given, i).map(|ratios| regime_of(ratios, border));
            }
        }
        points.count = 0;
    }
}

/// Whether the loops below Ω = 1/2 compute a point.
#[inline(always)]
fn is_below(omega: f64) -> bool {
    omega < 0.5
}

/// Fills the columns of `n` points, of which the first is the one at `start`.
pub(super) fn run(
    level: Level,
    start: usize,
    n: usize,
    mut columns: Slices<'_, { Output::ALL.len() }>,
    ratios: &impl Fn(usize) -> Option<Ratios<f64>>,
) {
    if !columns.is_looped_with_damper() {
        let has_velocity = columns.has_velocity();
        let answer = |i| ratios(start + i).map(|ratios| Output::answer(has_velocity, ratios));
        return (0..n).for_each(|i| columns.put(i, answer(i)));
    }
    let out = columns.take_looped();
    let wanted = Wanted::of(&out);
    let (found, work) = ([[0.0; POINTS]; LOOPED.len()], [[0.0; POINTS]; WORK]);
    let mut run = Run { level, wanted, out, found, work };
    let mut given = [[0.0; POINTS]; 4];
    let mut low = Gathered { given, places: [0; POINTS], count: 0 };
    for first in (0..n).step_by(POINTS) {
        let count = POINTS.min(n - first);
        for i in 0..count {
            let point = ratios(start + first + i).map(|point: Ratios<f64>| {
                [point.omega(), point.alpha(), point.damping_ratio(), point.static_friction_ratio()]
            });
            set(&mut given, i, point.unwrap_or(NOWHERE));
        }
        let [omegas, ..] = &given;
        let below = omegas.iter().take(count).filter(|&&omega| is_below(omega)).count();
        run.block(&given, count, below == count);
        run.put(&given, first, count);
        if below == count {
            continue;
        }
        let places = if below == 0 { 0 } else { count };
        for i in 0..places {
            let point = given.each_ref().map(|block| block.get(i).copied().unwrap_or(f64::NAN));
            if !is_below(point[0]) {
                continue;
            }
            set(&mut low.given, low.count, point);
            if let Some(slot) = low.places.get_mut(low.count) {
                *slot = first + i;
            }
            low.count += 1;
            if low.count == POINTS {
                run.gathered(&mut low);
            }
        }
    }
    if low.count > 0 {
        run.gathered(&mut low);
    }
}

/// What stands for a point without ratios.
const NOWHERE: [f64; 4] = [f64::NAN; 4];

/// The ratios of a block's point.
fn point_at(given: &[Block; 4], i: usize) -> Option<Ratios<f64>> {
    let [omega, alpha, zeta, eta] = given.each_ref().map(|block| block.get(i).copied().unwrap_or(f64::NAN));
    (!omega.is_nan()).then(|| Ratios::of_valid(omega, alpha, zeta, eta))
}
