//! The closed forms against motions that are proved to exist from the equation of motion alone.

use super::Residue;
use super::point::{Found, Place};
use crate::enclosed::{Enclosure, Known, Steady, steady};
use crate::float::ball::{Ball, Radius};
use crate::float::mp::Mp;
use crate::float::{Field, Real};
use crate::nonsticking::{matching::pi_1, stability::multiplier_product};
use rug::Rational;

/// Equations and statements.
pub(super) const ROWS: [(&str, &str); 5] = [
    ("44", "Δ₀ is that of a motion proved to exist"),
    ("49", "V₀ is the greatest velocity of that motion"),
    ("62", "that motion has two reversals a cycle and no stop"),
    ("λ", "the sum and the product of λ² are those of its linearised cycle"),
    ("62", "just below the border a motion with stops is proved, and one without above"),
];

/// The residues at a point, in the order of [`ROWS`].
pub(super) fn residues(place: &Place, bits: u32) -> Vec<Option<Residue>> {
    macro_rules! at {
        ($($width:literal)*) => {$(
            if Mp::<$width>::BITS >= bits + 64 {
                return at_width::<$width>(place, bits);
            }
        )*};
    }
    at!(5 17 65 129);
    Vec::new()
}

/// One unit where something is not as it should be, and none where it is.
fn count<const W: usize>(is_right: bool) -> Residue {
    Residue::of(Ball::<W>::int(i32::from(!is_right)), Ball::int(1))
}

fn motion(omega: &Known, alpha: &Known, bits: u32) -> Option<Steady> {
    steady(omega, alpha, &Known::rational(Rational::new()), &Known::rational(Rational::from(1)), bits)
        .ok()
        .flatten()
}

fn at_width<const W: usize>(place: &Place, bits: u32) -> Vec<Option<Residue>> {
    let unknown = Residue { most: Radius::INFINITE, least: Radius::ZERO, has_zero: true };
    if !place.with_motion {
        return vec![None; ROWS.len()];
    }
    let border = place.with_border.then(|| beside_the_border::<W>(place)).flatten();
    let (Some(found), Some(motion)) =
        (Found::<W>::at(place), motion(&place.omega, &place.alpha, bits.saturating_add(8)))
    else {
        return vec![Some(unknown), Some(unknown), Some(unknown), Some(unknown), border];
    };
    let (answers, one) = (&found.answers, Ball::int(1));
    let ball =
        |x: &Enclosure| Ball::<W>::new(Mp::from_rug(x.mid()), Radius::above(Mp::<2>::from_rug(x.rad())));
    let scale = one + answers.max_displacement + found.point.given.amplitude.abs();
    // λ₁² + λ₂² = (λ₁ + λ₂)² − 2 λ₁λ₂
    let [(a, b), (p, q)] = motion.multipliers.each_ref().map(|(re, im)| (ball(re), ball(im)));
    let s = multiplier_product(found.point.given.omega, answers.max_displacement);
    let sum = (one + s) * pi_1(found.point.given.omega).cos();
    let (trace, product) = (a + p, a * p - b * q);
    let by_trace = sum.square() - Ball::int(2) * s - trace;
    let by_product = s.square() - product;
    let slides = motion.sticks_per_cycle == 0 && motion.velocity_zeros_per_cycle == 2;
    vec![
        Some(Residue::of(ball(&motion.max_displacement) - answers.max_displacement, scale)),
        Some(Residue::of(ball(&motion.max_velocity) - answers.max_velocity, scale)),
        Some(count::<W>(slides)),
        Some(Residue::of(by_trace.abs() + by_product.abs(), scale)),
        border,
    ]
}

/// The stops of the motions at α_min (1 ∓ 2⁻¹⁶), but next to a pole, where the body need not stop below the border.
fn beside_the_border<const W: usize>(place: &Place) -> Option<Residue> {
    let least = Found::<W>::at(place)?.edge.min_force_ratio;
    let turns = place.omega.middle().recip();
    let nearest = (Rational::from(&turns - 1u32) / 2u32).round() * 2u32 + 1u32;
    if (turns - nearest).abs() * 128u32 <= 1 {
        return None;
    }
    let beside = |share: Ball<W>| {
        let alpha = Mp::<1>::rounded((least * share).mid()).to_rational()?;
        motion(&place.omega, &Known::rational(alpha), 64).map(|motion| motion.sticks_per_cycle)
    };
    let (one, little) = (Ball::int(1), Ball::ratio(1, 1 << 16));
    let (below, above) = (beside(one - little), beside(one + little));
    Some(count::<W>(below.is_some_and(|stops| stops > 0) && above == Some(0)))
}
