//! The loops below Ω = 1/2, by the same functions as a single point.

use super::super::block::{AtPoint, each, select};
use super::super::level::Loops;
use super::{Pass, Sizes, Squares, half};
use crate::cycle::damped::from_lobe;
use crate::cycle::damped::lobes::{self, Lobe};
use crate::cycle::damped::long::Long;
use crate::cycle::damped::rising::Rising;
use crate::cycle::velocity_phase;
use crate::float::circular::held;
use crate::float::pair::Pair;

/// `[1/Ω, G, H]` below Ω = 1/2, the last two in pairs, from `[Ω, ζ]`; NaN where the point must be recomputed.
struct LongResponses;

impl AtPoint<2, 5> for LongResponses {
    #[inline(always)]
    fn at(&self, [omega, zeta]: [f64; 2]) -> [f64; 5] {
        let Long { inverse, shift, h, is_accurate, .. } = Long::at(omega, zeta);
        [inverse, select(is_accurate, shift.hi, f64::NAN), shift.lo, h.hi, h.lo]
    }
}

/// The only lobe of the border's condition that may exceed the turning point.
struct Lobes(lobes::Constants<f64>);

impl AtPoint<8, 3> for Lobes {
    /// `[side, time, mark]` from η and the inputs of [`half`]: the mark is 1 where there is one, else 0, and NaN where the
    /// point must be recomputed.
    #[inline(always)]
    fn at(&self, [eta, given @ ..]: [f64; 8]) -> [f64; 3] {
        let half = half(given).with_static_friction(eta);
        let Lobe { side, time, is_above, is_decided } = Lobe::of_half(&half, &self.0);
        let mark = select(is_above, 1.0, 0.0);
        [side, time, select(is_decided, mark, f64::NAN)]
    }
}

/// `[α_min]` from η, the lobe, the force ratio at the turning point, and the inputs of [`half`].
struct Borders;

impl AtPoint<12, 1> for Borders {
    #[inline(always)]
    fn at(&self, [eta, side, time, mark, at_turning_point, given @ ..]: [f64; 12]) -> [f64; 1] {
        let half = half(given).with_static_friction(eta);
        let (border, is_near) = from_lobe(&half, side, time, at_turning_point);
        let border = select(is_near, border, f64::NAN);
        [select(mark.is_nan(), f64::NAN, select(mark > 0.0, border, at_turning_point))]
    }
}

/// The half cycle from `[Δ₀, the low part of Δ₀, a]` and the inputs of [`half`].
#[inline(always)]
fn known([max_displacement, rest, amplitude, given @ ..]: [f64; 10]) -> Rising<f64> {
    Rising { half: half(given), amplitude, max_displacement, rest }
}

/// A time near the maximum velocity below Ω = 1/2 from the inputs of [`known`]; NaN where it is not known.
struct LongStart(lobes::Constants<f64>);

impl AtPoint<10, 1> for LongStart {
    #[inline(always)]
    fn at(&self, given: [f64; 10]) -> [f64; 1] {
        let (time, is_found) = known(given).fastest_of_most(&self.0);
        [select(is_found, time, f64::NAN)]
    }
}

/// The maximum velocity below Ω = 1/2.
struct LongArrival;

impl AtPoint<13, 4> for LongArrival {
    /// `[V₀, ω_d t₁, α_min, Δ₁]` from a time near it, ω_d t₂, α_min and the inputs of [`known`]; a NaN in α_min means that
    /// the velocity must be recomputed.
    #[inline(always)]
    fn at(&self, [time, phase2, border, given @ ..]: [f64; 13]) -> [f64; 4] {
        let rising = known(given);
        let (summit, _, is_near) = rising.arrive_below::<true>(Pair::exact(time));
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

/// The pass below Ω = 1/2.
pub(super) struct LongPass<'a>(pub(super) Pass<'a>);

impl Loops for LongPass<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Pass { wanted, given: [omega, alpha, zeta, eta], found, work } = self.0;
        let [inverse, shift, shift_rest, h, h_rest, work @ ..] = work;
        let [square, square_rest, least, least_rest, side, time, mark, turning, rest, amplitude, ..] = work;
        let [delta, border, size1, phase2, size2, velocity, phase1, deviation, _] = found;
        let half = [&mut *inverse, shift, shift_rest, h, h_rest];
        each(&LongResponses, [omega, zeta], half);
        let [i, j, k, l, m, n, o] = [omega, zeta, &*inverse, shift, shift_rest, h, h_rest];
        let squares = [&mut *square, square_rest, least, least_rest, &mut *turning];
        each(&Squares, [alpha, eta, i, j, k, l, m, n, o], squares);
        let lobes = Lobes(held(lobes::Constants::new()));
        each(&lobes, [eta, i, j, k, l, m, n, o], [&mut *side, time, mark]);
        each(&Borders, [eta, side, time, mark, turning, i, j, k, l, m, n, o], [&mut *border]);
        let given = [alpha, square, square_rest, least, least_rest, border, i, j, k, l, m, n, o];
        if !wanted.more {
            return each::<13, 2>(&Sizes, given, [delta, size1]);
        }
        each::<13, 6>(&Sizes, given, [&mut *delta, size1, phase2, size2, rest, amplitude]);
        if wanted.velocity {
            let start = LongStart(held(lobes::Constants::new()));
            each(&start, [delta, rest, amplitude, i, j, k, l, m, n, o], [&mut *time]);
            mark.copy_from_slice(border);
            let given = [time, phase2, mark, delta, rest, amplitude, i, j, k, l, m, n, o];
            each(&LongArrival, given, [velocity, phase1, border, deviation]);
        }
    }
}
