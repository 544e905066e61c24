//! The points at which the statements are checked.

use std::ops::{Add, Div, Mul, Sub};

/// Bands of Ω, with their ends as fractions: between the singular frequencies, and far above.
const BANDS: [((i32, i32), (i32, i32)); 7] = [
    ((1, 6), (1, 5)),
    ((1, 5), (1, 4)),
    ((1, 4), (1, 3)),
    ((1, 3), (1, 2)),
    ((1, 2), (1, 1)),
    ((1, 1), (2, 1)),
    ((2, 1), (9, 1)),
];

/// The number of parts into which the frequency ratios divide a band.
const PARTS: i32 = 6;

/// The frequency ratios 1/n that the points approach, and the exponents of ten of the distances.
const BESIDE: ([i32; 4], [u32; 3]) = ([1, 3, 5, 7], [3, 10, 30]);

/// With a damper: frequency ratios in hundredths, and damping ratios in thousandths, below, at and above
/// ζ = 1.
const OMEGA: [i32; 12] = [18, 24, 29, 34, 41, 47, 70, 95, 100, 105, 150, 400];
const ZETA: [i32; 6] = [10, 50, 200, 700, 1000, 1600];

/// α over the border, in hundredths: all of them without a damper, in turn with one.
const OVER: [i32; 3] = [101, 150, 400];

/// A point to check.
pub(super) struct CheckPoint<P> {
    pub(super) place: P,
    /// Whether the exact motion is followed, or proved, at this point.
    pub(super) with_motion: bool,
    /// Whether this is also done next to the border.
    pub(super) with_border: bool,
}

/// The numbers of the points.
pub(super) struct Numbers<N> {
    pub(super) ratio: fn(i32, i32) -> N,
    /// Whether a point at this distance from a singular frequency has digits left.
    pub(super) has_digits: fn(&N) -> bool,
    /// Whether the motion is followed at the point with this number, and with a damper next to the border.
    pub(super) in_turn: [fn(usize) -> bool; 2],
}

impl<N> Numbers<N>
where
    N: Clone + Add<Output = N> + Sub<Output = N> + Mul<Output = N> + Div<Output = N>,
{
    /// All points, each at Ω, ζ and α over the border in hundredths.
    ///
    /// Without a damper they lie on both sides of Ω = 1, in the bands between 1/5, 1/4, 1/3 and 1/2, and near
    /// Ω = 1, 1/3, 1/5 and 1/7 at distances down to 10⁻³⁰.
    pub(super) fn points<P>(&self, at: impl Fn(N, N, i32) -> Option<P>) -> Vec<CheckPoint<P>> {
        let (ratio, [motion, border]) = (self.ratio, self.in_turn);
        let plain = self.omegas().into_iter().enumerate().flat_map(|(number, (omega, ordinary))| {
            let of_over =
                |(i, over)| (omega.clone(), over, ordinary && motion(number + i), ordinary && i == 0);
            OVER.into_iter().enumerate().map(of_over).collect::<Vec<_>>()
        });
        let plain = plain.map(|(omega, over, motion, border)| (omega, ratio(0, 1), over, motion, border));
        let pairs = OMEGA.into_iter().flat_map(|omega| ZETA.into_iter().map(move |zeta| (omega, zeta)));
        let damped = pairs.zip(OVER.into_iter().cycle()).enumerate();
        let damped = damped.map(|(number, ((omega, zeta), over))| {
            (ratio(omega, 100), ratio(zeta, 1000), over, motion(number), border(number))
        });
        let point = |(omega, zeta, over, with_motion, with_border)| {
            Some(CheckPoint { place: at(omega, zeta, over)?, with_motion, with_border })
        };
        plain.chain(damped).filter_map(point).collect()
    }

    /// The frequency ratios without a damper, and whether the exact motion is followed at each: closer than 10⁻³
    /// to a singular frequency the motion takes too many periods to settle.
    fn omegas(&self) -> Vec<(N, bool)> {
        let (ratio, mut all) = (self.ratio, Vec::new());
        for ((p, q), (r, s)) in BANDS {
            let (low, high) = (ratio(p, q), ratio(r, s));
            let width = high - low.clone();
            all.extend((1..PARTS).map(|i| (low.clone() + width.clone() * ratio(i, PARTS), true)));
        }
        let (numbers, exponents) = BESIDE;
        for (n, exponent) in numbers.into_iter().flat_map(|n| exponents.map(|exponent| (n, exponent))) {
            let distance = (0..exponent).fold(ratio(1, 1), |d, _| d / ratio(10, 1));
            if (self.has_digits)(&distance) {
                let beside = [ratio(1, n) - distance.clone(), ratio(1, n) + distance];
                all.extend(beside.map(|omega| (omega, exponent == 3)));
            }
        }
        all
    }
}
