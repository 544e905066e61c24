//! Points that may have a damper and static friction: {Δ₀, α_min, A₁} by a loop, all else point by point.

use super::alone;
use super::block::{AtPoint, Block, POINTS, each, select, set};
use super::columns::Slices;
use super::level::{Level, Loops};
use crate::cycle::damped::half_period::HalfPeriod;
use crate::cycle::damped::tangent::Angle;
use crate::cycle::damped::{amplitude_from_turning_point, exists};
use crate::cycle::regime::regime_of;
use crate::float::pair::Pair;
use crate::machine::ratios::Ratios;
use crate::output::Output;

/// `[d, γ, 1/Ω]` in pairs from `[Ω, ζ]`.
struct Turning;

impl AtPoint<2, 6> for Turning {
    #[inline(always)]
    fn at(&self, [omega, zeta]: [f64; 2]) -> [f64; 6] {
        let Angle { d, gamma, inverse } = Angle::at(omega, zeta);
        [d.hi, d.lo, gamma.hi, gamma.lo, inverse.hi, inverse.lo]
    }
}

/// `[p, r]` in pairs from `[Ω, ζ]` and the results of [`Turning`]; NaN where the point must be recomputed.
struct Fraction;

impl AtPoint<8, 4> for Fraction {
    #[inline(always)]
    fn at(&self, [omega, zeta, angle @ ..]: [f64; 8]) -> [f64; 4] {
        let ((p, r), is_accurate) = angle_of(angle).fraction(omega, zeta);
        [select(is_accurate & (zeta > 0.0), p.hi, f64::NAN), p.lo, r.hi, r.lo]
    }
}

/// `[G, H]` in pairs from `[Ω, ζ]` and the results of [`Turning`] and [`Fraction`].
struct Responses;

impl AtPoint<12, 4> for Responses {
    #[inline(always)]
    fn at(
        &self,
        [omega, zeta, d, d_rest, gamma, gamma_rest, inverse, inverse_rest, fraction @ ..]: [f64; 12],
    ) -> [f64; 4] {
        let angle = angle_of([d, d_rest, gamma, gamma_rest, inverse, inverse_rest]);
        let [p, p_rest, r, r_rest] = fraction;
        let (shift, h) = angle.tangent(omega, zeta, (Pair::new(p, p_rest), Pair::new(r, r_rest)));
        [shift.hi, shift.lo, h.hi, h.lo]
    }
}

#[inline(always)]
fn angle_of([d, d_rest, gamma, gamma_rest, inverse, inverse_rest]: [f64; 6]) -> Angle<f64> {
    let (d, gamma) = (Pair::new(d, d_rest), Pair::new(gamma, gamma_rest));
    Angle { d, gamma, inverse: Pair::new(inverse, inverse_rest) }
}

/// `[Δ₀, α_min, A₁]` from `[Ω, α, ζ, η]` and the results of [`Responses`]; a NaN in α_min means that the point
/// must be recomputed.
struct Sizes;

impl AtPoint<8, 3> for Sizes {
    #[inline(always)]
    fn at(&self, [omega, alpha, zeta, eta, shift, shift_rest, h, h_rest]: [f64; 8]) -> [f64; 3] {
        let (shift, h) = (Pair::new(shift, shift_rest), Pair::new(h, h_rest));
        let half = HalfPeriod::of_response(omega, zeta, shift, h).with_static_friction(eta);
        let [displacement, border, size] = amplitude_from_turning_point(half, alpha);
        let slides = exists(alpha, border);
        [select(slides, displacement, f64::NAN), border, select(slides, size, f64::NAN)]
    }
}

struct Pass<'a> {
    given: &'a [Block; 4],
    found: &'a mut [Block; 3],
    work: &'a mut [Block; 14],
}

impl Loops for Pass<'_> {
    type Output = ();

    /// Four loops, each short enough for the processor to compute several of its rounds at a time.
    #[inline(always)]
    fn run(self) {
        let Self { given: [omega, alpha, zeta, eta], found, work } = self;
        let [a, b, c, d, e, f, p, p_rest, r, r_rest, work @ ..] = work;
        each(&Turning, [omega, zeta], [&mut *a, b, c, d, e, f]);
        each(&Fraction, [omega, zeta, a, b, c, d, e, f], [&mut *p, p_rest, r, r_rest]);
        each(&Responses, [omega, zeta, a, b, c, d, e, f, p, p_rest, r, r_rest], work.each_mut());
        let [shift, shift_rest, h, h_rest] = work;
        each(&Sizes, [omega, alpha, zeta, eta, shift, shift_rest, h, h_rest], found.each_mut());
    }
}

/// Fills the columns of `n` points, of which the first is the one at `start`.
pub(super) fn run(
    level: Level,
    start: usize,
    n: usize,
    mut columns: Slices<'_, { Output::ALL.len() }>,
    ratios: &impl Fn(usize) -> Option<Ratios<f64>>,
) {
    if !columns.is_amplitude() {
        return (0..n).for_each(|i| columns.put(i, ratios(start + i)));
    }
    let (mut given, mut found) = ([[0.0; POINTS]; 4], [[0.0; POINTS]; 3]);
    let mut work = [[0.0; POINTS]; 14];
    let mut points = [None; POINTS];
    let mut out = columns.take_looped();
    for first in (0..n).step_by(POINTS) {
        let count = POINTS.min(n - first);
        for (i, point) in points.iter_mut().take(count).enumerate() {
            *point = ratios(start + first + i);
            let parts = point.map_or([1.0, 1.0, 0.0, 1.0], |ratios: Ratios<f64>| {
                let (zeta, eta) = (ratios.damping_ratio(), ratios.static_friction_ratio());
                [ratios.omega(), ratios.alpha(), zeta, eta]
            });
            set(&mut given, i, parts);
        }
        // Without a damper the loops would leave every point.
        if level == Level::Scalar || given[2].iter().all(|&zeta| zeta == 0.0) {
            found[1].fill(f64::NAN);
        } else {
            level.run(Pass { given: &given, found: &mut found, work: &mut work });
        }
        for (i, point) in points.iter().take(count).enumerate() {
            if found[1].get(i).is_some_and(|border| border.is_nan()) {
                let values = point.map_or([f64::NAN; 3], alone::amplitude_of);
                set(&mut found, i, values);
            }
        }
        out.put_numbers(first, count, &found);
        let regimes = out.regime.iter_mut().flat_map(|slice| slice.iter_mut().skip(first));
        for ((slot, point), &border) in regimes.zip(points.iter().take(count)).zip(&found[1]) {
            *slot = point.map(|ratios| regime_of(ratios, border));
        }
    }
}
