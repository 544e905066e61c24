//! The points at which the identities are evaluated.

use super::above_border;
use crate::float::Float;
use crate::nonsticking::Cycle;

/// Bands of Ω, with their ends as fractions: between the singular frequencies, and far above.
pub(super) const BANDS: [((i32, i32), (i32, i32)); 7] = [
    ((1, 6), (1, 5)),
    ((1, 5), (1, 4)),
    ((1, 4), (1, 3)),
    ((1, 3), (1, 2)),
    ((1, 2), (1, 1)),
    ((1, 1), (2, 1)),
    ((2, 1), (9, 1)),
];

/// A point to check.
pub(super) struct Point<F> {
    pub(super) cycle: Cycle<F>,
    /// Whether the exact motion is computed there and eq. 21–25 are solved.
    pub(super) with_motion: bool,
    /// Whether the border is checked.
    pub(super) with_border: bool,
}

/// All points.
pub(super) fn points<F: Float>() -> Vec<Point<F>> {
    let times = [F::ratio(101, 100), F::ratio(3, 2), F::int(4)];
    // A motion with a thousand digits takes a tenth of a second; at such precisions only one α is used at
    // each Ω, in turn.
    let all = F::PRECISION <= 512;
    let at = |(number, (omega, ordinary)): (usize, (F, bool))| {
        times.iter().enumerate().filter_map(move |(i, &t)| {
            let cycle = above_border(omega, t)?;
            let in_turn = number.saturating_add(i).is_multiple_of(times.len());
            Some(Point { cycle, with_motion: ordinary && (all || in_turn), with_border: ordinary && i == 0 })
        })
    };
    omegas::<F>().into_iter().enumerate().flat_map(at).collect()
}

/// The frequency ratios, and whether the exact motion is computed there: within 10⁻³ of a singular frequency
/// it takes too many periods to settle.
fn omegas<F: Float>() -> Vec<(F, bool)> {
    const INSIDE: i32 = 6;
    let mut all = Vec::new();
    for ((p, q), (r, s)) in BANDS {
        let (low, high) = (F::ratio(p, q), F::ratio(r, s));
        all.extend((1..INSIDE).map(|i| (low + (high - low) * F::ratio(i, INSIDE), true)));
    }
    for n in [1, 3, 5, 7] {
        for digits in [3, 10, 30] {
            let distance = (0..digits).fold(F::int(1), |d, _| d / F::int(10));
            // Closer than half the digits, the paper's own forms have no digits left.
            if distance.square() > F::epsilon() {
                all.extend(
                    [F::ratio(1, n) - distance, F::ratio(1, n) + distance].map(|omega| (omega, digits == 3)),
                );
            }
        }
    }
    all
}
