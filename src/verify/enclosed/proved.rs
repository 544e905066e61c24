//! The closed forms compared with motions that are proved to exist from the equation of motion alone.

use super::answered::Answered;
use super::point::{Found, Place};
use super::{Residue, damped};
use crate::enclosed::{Enclosure, Known, Steady, steady};
use crate::float::ball::{Ball, Radius};
use crate::float::mp::Mp;
use crate::float::{Field, Real};
use rug::Rational;

/// Equations and statements without damping.
pub(super) const ROWS: [(&str, &str); 7] = [
    ("44", "Δ₀ is that of a motion proved to exist"),
    ("43", "ω_d t₂ is that of its maximum"),
    ("49", "V₀ is the greatest velocity of that motion"),
    ("62", "that motion has two reversals a cycle and no stop"),
    ("λ", "the sum and the product of λ² are those of its linearised cycle"),
    ("λ", "the contraction is the larger |λ| of that cycle"),
    ("62", "just below the border a motion with stops is proved, and one without above"),
];

/// The same with damping.
pub(super) const DAMPED: [(&str, &str); 7] = [
    ("44, ζ", "with damping Δ₀ is that of a motion proved to exist"),
    ("43, ζ", "with damping ω_d t₂ is that of its maximum"),
    ("49, ζ", "with damping V₀ is the greatest velocity of that motion"),
    ("62, ζ", "with damping that motion has two reversals a cycle and no stop"),
    ("λ, ζ", "with damping the sum and the product of λ² are those of its linearised cycle"),
    ("λ, ζ", "with damping the contraction is the larger |λ| of that cycle"),
    ("62, ζ", "just below the damped border a motion with stops is proved, and one without above"),
];

/// The answers of the closed forms, with damping or without.
fn answered<const W: usize>(place: &Place) -> Option<Answered<W>> {
    if place.is_damped() {
        damped::Found::at(place).map(|found| found.answered())
    } else {
        Found::at(place).map(|found| found.answered())
    }
}

/// The residues at a point, in the order of [`ROWS`].
pub(super) fn residues(place: &Place, bits: u32) -> Vec<Option<Residue>> {
    macro_rules! at {
        ($($width:literal)*) => {$(
            if Mp::<$width>::BITS >= bits + 64 {
                return against(place, bits, answered::<$width>(place));
            }
        )*};
    }
    at!(5 17 65 129);
    Vec::new()
}

/// A residual of one unit if the condition fails, and of zero if it holds.
fn count<const W: usize>(is_right: bool) -> Residue {
    Residue::of(Ball::<W>::int(i32::from(!is_right)), Ball::int(1))
}

fn motion(place: &Place, alpha: &Known, bits: u32) -> Option<Steady> {
    let one = Known::rational(Rational::from(1));
    steady(&place.omega, alpha, &place.zeta, &one, bits).ok()?.ok()
}

/// The residuals of the answers for the motion at the point.
pub(super) fn against<const W: usize>(
    place: &Place,
    bits: u32,
    answered: Option<Answered<W>>,
) -> Vec<Option<Residue>> {
    let unknown = Residue { most: Radius::INFINITE, least: Radius::ZERO, has_zero: true };
    if !place.with_motion {
        return vec![None; ROWS.len()];
    }
    let (Some(found), Some(motion)) = (answered, motion(place, &place.alpha, bits.saturating_add(8))) else {
        return vec![Some(unknown); ROWS.len()];
    };
    let border = place.with_border.then(|| beside_the_border(place, found.min_force_ratio)).flatten();
    let (scale, one, two) = (found.scale, Ball::int(1), Ball::int(2));
    let ball = |x: &Enclosure| Ball::<W>::new(Mp::from_rug(&x.mid), Radius::above(Mp::<2>::from_rug(&x.rad)));
    // The motion begins with a reversal: the sine of the remaining phase to t₂, or to t₂ and half a turn.
    let late = (found.displacement_phase - ball(&motion.start.0)).sin();
    // λ₁² + λ₂² = (λ₁ + λ₂)² − 2 λ₁λ₂
    let [(a, b), (p, q)] = motion.multipliers.each_ref().map(|(re, im)| (ball(re), ball(im)));
    let (trace, product) = (a + p, a * p - b * q);
    let by_trace = found.sum.square() - two * found.product - trace;
    let by_product = found.product.square() - product;
    let largest = a.hypot(b).larger(&p.hypot(q));
    let slides = motion.sticks_per_cycle == 0 && motion.velocity_zeros_per_cycle == 2;
    vec![
        Some(Residue::of(ball(&motion.max_displacement) - found.max_displacement, scale)),
        Some(Residue::of(late * found.max_displacement, scale)),
        Some(Residue::of(ball(&motion.max_velocity) - found.max_velocity, scale)),
        Some(count::<W>(slides)),
        Some(Residue::of(by_trace.abs() + by_product.abs(), scale)),
        Some(Residue::of(found.contraction.square() - largest, one)),
        border,
    ]
}

/// The stops of the motions at α_min (1 ∓ 2⁻¹⁶), except next to a pole, where the body need not stop below
/// the border.
fn beside_the_border<const W: usize>(place: &Place, least: Ball<W>) -> Option<Residue> {
    let turns = place.omega.middle().recip();
    let nearest = (Rational::from(&turns - 1u32) / 2u32).round() * 2u32 + 1u32;
    if (turns - nearest).abs() * 128u32 <= 1 {
        return None;
    }
    let beside = |share: Ball<W>| {
        let alpha = Mp::<1>::rounded((least * share).mid()).to_rational()?;
        motion(place, &Known::rational(alpha), 64).map(|motion| motion.sticks_per_cycle)
    };
    let (one, little) = (Ball::int(1), Ball::ratio(1, 1 << 16));
    let (below, above) = (beside(one - little), beside(one + little));
    Some(count::<W>(below.is_some_and(|stops| stops > 0) && above == Some(0)))
}
