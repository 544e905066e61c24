//! Points that may have a damper and static friction: the outputs of [`LOOPED`] except λ by loops, all others point by
//! point.

mod loops;
mod low;

use super::alone;
use super::block::{Block, POINTS, set};
use super::columns::{BORDER, LOOPED, Looped, Slices};
use super::level::Level;
use super::stages::Answer;
use super::straight::is_any_nan;
use crate::cycle::regime::regime_of;
use crate::machine::ratios::Ratios;
use crate::output::Output;
use loops::{Pass, Sizes, Squares, WORK, Wanted, half};
use low::LongPass;

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
