//! Points that may have a damper and static friction: {Δ₀, α_min, A₁} by a loop, all else point by point.

use super::block::{AtPoint, Block, POINTS, each, select, set};
use super::columns::Slices;
use super::level::{Level, Loops};
use super::straight::is_any_nan;
use crate::cycle::damped::half_period::HalfPeriod;
use crate::cycle::damped::tangent::Angle;
use crate::cycle::damped::{amplitude_from_turning_point, exists};
use crate::cycle::regime::regime_of;
use crate::cycle::response;
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
        let has_velocity = columns.has_velocity();
        let answer = |i| ratios(start + i).map(|ratios| Output::answer(has_velocity, ratios));
        return (0..n).for_each(|i| columns.put(i, answer(i)));
    }
    let (mut given, mut found) = ([[0.0; POINTS]; 4], [[0.0; POINTS]; 3]);
    let mut work = [[0.0; POINTS]; 14];
    let mut out = columns.take_looped();
    for first in (0..n).step_by(POINTS) {
        let count = POINTS.min(n - first);
        let mut is_damped = false;
        for i in 0..count {
            let point = ratios(start + first + i).map(|point: Ratios<f64>| {
                is_damped |= point.is_damped();
                [point.omega(), point.alpha(), point.damping_ratio(), point.static_friction_ratio()]
            });
            set(&mut given, i, point.unwrap_or(NOWHERE));
        }
        // Without a damper the loops would leave every point.
        if level == Level::Scalar || !is_damped {
            found[1].fill(f64::NAN);
        } else {
            level.run(Pass { given: &given, found: &mut found, work: &mut work });
        }
        if is_any_nan(&found[1]) {
            for i in 0..count {
                if found[1].get(i).is_some_and(|border| border.is_nan()) {
                    let values = point_at(&given, i).map_or([f64::NAN; 3], response::amplitude);
                    set(&mut found, i, values);
                }
            }
        }
        out.put_numbers(first, count, &found);
        let regimes = out.regime.iter_mut().flat_map(|slice| slice.iter_mut().skip(first)).take(count);
        for (i, (slot, &border)) in regimes.zip(&found[1]).enumerate() {
            *slot = point_at(&given, i).map(|ratios| regime_of(ratios, border));
        }
    }
}

/// What stands for a point without ratios.
const NOWHERE: [f64; 4] = [f64::NAN; 4];

/// The ratios of a block's point.
fn point_at(given: &[Block; 4], i: usize) -> Option<Ratios<f64>> {
    let [omega, alpha, zeta, eta] = given.each_ref().map(|block| block.get(i).copied().unwrap_or(f64::NAN));
    (!omega.is_nan()).then(|| Ratios::of_valid(omega, alpha, zeta, eta))
}
