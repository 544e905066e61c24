//! The loops of a block, by their outputs.

use super::super::block::{AtPoint, Block, each, select};
use super::super::columns::Looped;
use super::super::level::Loops;
use super::super::stages::Answer;
use crate::cycle::damped::half_period::HalfPeriod;
use crate::cycle::damped::middle::{Constants, Crest, Middle};
use crate::cycle::damped::rising::Rising;
use crate::cycle::damped::tangent::Angle;
use crate::cycle::damped::{displacement_phase, exists, from_turning_point};
use crate::cycle::velocity_phase;
use crate::float::circular::{Swell, held};
use crate::float::pair::Pair;

/// `[d, γ, 1/Ω]`, the first two in pairs, from `[Ω, ζ]`.
pub(super) struct Turning;

impl AtPoint<2, 5> for Turning {
    #[inline(always)]
    fn at(&self, [omega, zeta]: [f64; 2]) -> [f64; 5] {
        let Angle { d, gamma, inverse } = Angle::at(omega, zeta);
        [d.hi, d.lo, gamma.hi, gamma.lo, inverse]
    }
}

/// `[G, H]` in pairs from `[Ω, ζ]` and the results of [`Turning`]; NaN where the point must be recomputed.
pub(super) struct Responses(Swell<f64>);

impl AtPoint<7, 4> for Responses {
    #[inline(always)]
    fn at(&self, [omega, zeta, angle @ ..]: [f64; 7]) -> [f64; 4] {
        let (shift, h, is_accurate) = angle_of(angle).responses(omega, zeta, &self.0);
        [select(is_accurate & (zeta > 0.0), shift.hi, f64::NAN), shift.lo, h.hi, h.lo]
    }
}

#[inline(always)]
pub(super) fn angle_of([d, d_rest, gamma, gamma_rest, inverse]: [f64; 5]) -> Angle<f64> {
    let (d, gamma) = (Pair::new(d, d_rest), Pair::new(gamma, gamma_rest));
    Angle { d, gamma, inverse }
}

/// The half period from `[Ω, ζ]`, 1/Ω and the results of [`Responses`].
#[inline(always)]
pub(super) fn half([omega, zeta, inverse, shift, shift_rest, h, h_rest]: [f64; 7]) -> HalfPeriod<f64> {
    HalfPeriod::of_responses(omega, zeta, inverse, Pair::new(shift, shift_rest), Pair::new(h, h_rest))
}

/// `[a², S, α_min]`, the first two in pairs, from `[α, η]` and the inputs of [`half`]; a NaN in α_min means that the
/// point must be recomputed.
pub(super) struct Squares;

impl AtPoint<9, 5> for Squares {
    #[inline(always)]
    fn at(&self, [alpha, eta, given @ ..]: [f64; 9]) -> [f64; 5] {
        let (square, least, border) = from_turning_point(&half(given).with_static_friction(eta), alpha);
        [square.hi, square.lo, least.hi, least.lo, border]
    }
}

/// The half cycle from `[α, a², S, α_min]` and the inputs of [`half`], and whether there is one.
#[inline(always)]
pub(super) fn rising(
    [alpha, square, square_rest, least, least_rest, border, given @ ..]: [f64; 13],
) -> (Rising<f64>, bool) {
    let (square, least) = (Pair::new(square, square_rest), Pair::new(least, least_rest));
    (Rising::of_square(half(given), square, least), exists(alpha, border))
}

/// `[Δ₀, A₁]` from the inputs of [`rising`].
pub(super) struct Sizes;

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
pub(super) struct Middles;

#[inline(always)]
pub(super) fn middle([omega, zeta, angle @ .., shift]: [f64; 8]) -> Middle<f64> {
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
pub(super) struct Arrival(Constants<f64>);

impl Arrival {
    #[inline(always)]
    pub(super) fn new() -> Self {
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
pub(super) struct Wanted {
    pub(super) more: bool,
    pub(super) velocity: bool,
    pub(super) deviation: bool,
}

impl Wanted {
    pub(super) fn of(out: &Looped<'_>) -> Self {
        Self { more: out.has(3..8), velocity: out.has(5..8), deviation: out.has(7..8) }
    }
}

/// Blocks for what passes from one loop to the next.
pub(super) const WORK: usize = 30;

pub(super) struct Pass<'a> {
    pub(super) wanted: Wanted,
    pub(super) given: &'a [Block; 4],
    pub(super) found: &'a mut Answer,
    pub(super) work: &'a mut [Block; WORK],
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
