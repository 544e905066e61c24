//! Points that may have a damper and static friction: {Δ₀, α_min, A₁} by a loop, all else point by point.

use super::alone;
use super::block::{AtPoint, Block, POINTS, each, select};
use super::columns::Slices;
use super::level::{Level, Loops};
use crate::cycle::damped::half_period::HalfPeriod;
use crate::cycle::damped::tangent::Tangent;
use crate::cycle::damped::{amplitude_from_turning_point, exists};
use crate::cycle::regime::regime_of;
use crate::machine::ratios::Ratios;
use crate::output::Output;

/// `[Δ₀, α_min, A₁]` from `[Ω, α, ζ, η]`, which are in their domains; a NaN in α_min means that the point must
/// be recomputed.
struct Point;

impl AtPoint<4, 3> for Point {
    #[inline(always)]
    fn at(&self, [omega, alpha, zeta, eta]: [f64; 4]) -> [f64; 3] {
        let tangent = Tangent::at(omega, zeta);
        let half = HalfPeriod::of_tangent(omega, zeta, &tangent).with_static_friction(eta);
        let [displacement, border, size] = amplitude_from_turning_point(half, alpha);
        let slides = exists(alpha, border);
        let is_answered = tangent.is_accurate & (zeta > 0.0);
        [
            select(slides, displacement, f64::NAN),
            select(is_answered, border, f64::NAN),
            select(slides, size, f64::NAN),
        ]
    }
}

struct Pass<'a> {
    given: &'a [Block; 4],
    found: &'a mut [Block; 3],
}

impl Loops for Pass<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        each(&Point, self.given.each_ref(), self.found.each_mut());
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
            for (block, part) in given.iter_mut().zip(parts) {
                if let Some(slot) = block.get_mut(i) {
                    *slot = part;
                }
            }
        }
        if level == Level::Scalar {
            found[1].fill(f64::NAN);
        } else {
            level.run(Pass { given: &given, found: &mut found });
        }
        for (i, point) in points.iter().take(count).enumerate() {
            if found[1].get(i).is_some_and(|border| border.is_nan()) {
                let values = point.map_or([f64::NAN; 3], alone::amplitude_of);
                for (block, value) in found.iter_mut().zip(values) {
                    if let Some(slot) = block.get_mut(i) {
                        *slot = value;
                    }
                }
            }
        }
        for (slice, block) in out.numbers.iter_mut().zip(&found) {
            let part = slice.as_mut().and_then(|slice| slice.get_mut(first..first + count));
            if let (Some(part), Some(values)) = (part, block.get(..count)) {
                part.copy_from_slice(values);
            }
        }
        let regimes = out.regime.iter_mut().flat_map(|slice| slice.iter_mut().skip(first));
        for ((slot, point), &border) in regimes.zip(points.iter().take(count)).zip(&found[1]) {
            *slot = point.map(|ratios| regime_of(ratios, border));
        }
    }
}
