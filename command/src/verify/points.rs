//! The points at which the statements are checked.

use stickslip::{Border, Float, Ratios};

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

/// The number of parts into which the frequency ratios divide a band.
pub(super) const PARTS: i32 = 6;

/// The frequency ratios 1/n that the points approach, and the exponents of ten of the distances.
pub(super) const BESIDE: ([i32; 4], [u32; 3]) = ([1, 3, 5, 7], [3, 10, 30]);

/// With a damper: frequency ratios in hundredths, and damping ratios in thousandths, below, at and above
/// ζ = 1.
pub(super) const OMEGA: [i32; 12] = [18, 24, 29, 34, 41, 47, 70, 95, 100, 105, 150, 400];
pub(super) const ZETA: [i32; 6] = [10, 50, 200, 700, 1000, 1600];

/// α over the border, in hundredths: all of them without a damper, in turn with one.
pub(super) const OVER: [i32; 3] = [101, 150, 400];

/// A point to check.
pub(super) struct CheckPoint<F> {
    pub(super) ratios: Ratios<F>,
    /// Whether the exact motion is followed at this point.
    pub(super) with_motion: bool,
    /// Whether the exact motion is also followed next to the border.
    pub(super) with_border: bool,
}

/// All points.
///
/// Without a damper they lie on both sides of Ω = 1, in the bands between 1/5, 1/4, 1/3 and 1/2, and near
/// Ω = 1, 1/3, 1/5 and 1/7 at distances down to 10⁻³⁰ where the precision is at least twice as fine.
pub(super) fn all<F: Float>() -> Vec<CheckPoint<F>> {
    // A motion with a thousand digits takes a tenth of a second; at such precisions only every third motion
    // is followed.
    let in_turn = |number: usize| F::PRECISION <= 512 || number.is_multiple_of(OVER.len());
    let plain = omegas::<F>().into_iter().enumerate().flat_map(|(number, (omega, ordinary))| {
        OVER.into_iter().enumerate().filter_map(move |(i, over)| {
            Some(CheckPoint {
                ratios: above_border(omega, F::int(0), over)?,
                with_motion: ordinary && in_turn(number + i),
                with_border: ordinary && i == 0,
            })
        })
    });
    let pairs = OMEGA.into_iter().flat_map(|omega| ZETA.into_iter().map(move |zeta| (omega, zeta)));
    let damped =
        pairs.zip(OVER.into_iter().cycle()).enumerate().filter_map(|(number, ((omega, zeta), over))| {
            let ratios = above_border(F::ratio(omega, 100), F::ratio(zeta, 1000), over)?;
            Some(CheckPoint { ratios, with_motion: in_turn(number), with_border: in_turn(number) })
        });
    plain.chain(damped).collect()
}

/// The ratios at α `over` hundredths of the exact border.
fn above_border<F: Float>(omega: F, zeta: F, over: i32) -> Option<Ratios<F>> {
    let least = Border::with_damping(omega, zeta).ok()?.min_force_ratio;
    Ratios::new(omega, least * F::ratio(over, 100)).ok()?.with_damping_ratio(zeta).ok()
}

/// The frequency ratios without a damper, and whether the exact motion is followed at each: closer than 10⁻³
/// to a singular frequency the motion takes too many periods to settle.
fn omegas<F: Float>() -> Vec<(F, bool)> {
    let mut all = Vec::new();
    for ((p, q), (r, s)) in BANDS {
        let (low, high) = (F::ratio(p, q), F::ratio(r, s));
        all.extend((1..PARTS).map(|i| (low + (high - low) * F::ratio(i, PARTS), true)));
    }
    let (numbers, exponents) = BESIDE;
    for n in numbers {
        for exponent in exponents {
            let distance = (0..exponent).fold(F::int(1), |d, _| d / F::int(10));
            // Closer than half the digits, the paper's own forms have no digits left.
            if distance.square() > F::epsilon() {
                let beside = [F::ratio(1, n) - distance, F::ratio(1, n) + distance];
                all.extend(beside.map(|omega| (omega, exponent == 3)));
            }
        }
    }
    all
}
