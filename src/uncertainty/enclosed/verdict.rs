//! The verdict on all motions of a box from the side of 1 on which the margin lies.

use super::parts::Ends;
use crate::cycle::regime::{Regime, Verdict};
use crate::float::Float;
use crate::machine::error::Error;
use rug::Rational;

/// The verdict that holds for all ratios [Ω, α, ζ] in these intervals; `is_above_one` says whether the margin
/// is above or below 1 over the whole box of these ratios.
///
/// # Errors
/// Those of `is_above_one`.
pub(super) fn by_margin<F: Float>(
    [omega, alpha, zeta]: [&Ends; 3],
    is_above_one: impl FnOnce() -> Result<Option<bool>, Error>,
) -> Result<Verdict<F>, Error> {
    if alpha.1 <= 1 {
        return Ok(Verdict::AtRest);
    }
    let may_rest = alpha.0 <= 1;
    let below = if may_rest { Regime::Stuck } else { Regime::Sticking };
    Ok(match is_above_one()? {
        Some(true) if !may_rest => {
            let may_grow = zeta.0 == 0 && omega.0 <= 1 && omega.1 >= 1;
            let grows = Verdict::Undecided(Regime::NonSticking, Regime::Unbounded);
            if may_grow { grows } else { Verdict::NonSticking }
        }
        Some(false) if !may_reverse_six_times(omega, zeta) => {
            let sticks = Verdict::Undecided(Regime::Stuck, Regime::Sticking);
            if may_rest { sticks } else { Verdict::Sticking }
        }
        _ => Verdict::Undecided(below, Regime::NonSticking),
    })
}

/// Whether the frequency and damping ratios come near a cycle of six reversals: 1/Ω within 1/16 of an odd
/// number ≥ 3, and ζ below 1/128 (`regime::no_stop`).
fn may_reverse_six_times(omega: &Ends, zeta: &Ends) -> bool {
    let reach = Rational::from((1, 16));
    let (from, to) =
        (Rational::from(omega.1.recip_ref()) - &reach, Rational::from(omega.0.recip_ref()) + reach);
    // The last odd number that is not above `to`.
    let half: Rational = (to - 1u32) / 2u32;
    let last = half.floor() * 2u32 + 1u32;
    zeta.0 < Rational::from((1, 128)) && last >= 3 && last >= from
}

#[cfg(test)]
mod tests {
    use super::{by_margin, may_reverse_six_times};
    use crate::cycle::regime::{Regime, Verdict};
    use rug::Rational;

    fn r(p: i64, q: i64) -> Rational {
        Rational::from((p, q))
    }

    #[test]
    fn six_reversals_are_within_a_sixteenth_of_the_odd_numbers() {
        let at = |low: Rational, high: Rational, zeta: Rational| {
            may_reverse_six_times(&(high.recip(), low.recip()), &(zeta.clone(), zeta))
        };
        let tiny = r(1, 1 << 40);
        for odd in [3i64, 5, 7, 101] {
            let (low, high) = (r(16 * odd - 1, 16), r(16 * odd + 1, 16));
            for (inverse, is) in [
                (low.clone(), true),
                (low.clone() - &tiny, false),
                (high.clone(), true),
                (high.clone() + &tiny, false),
                (r(odd, 1), true),
                (r(odd + 1, 1), false),
            ] {
                assert_eq!(at(inverse.clone(), inverse.clone(), r(0, 1)), is, "{inverse}");
                assert_eq!(at(inverse.clone(), inverse.clone(), r(1, 128) - &tiny), is, "{inverse}");
                assert!(!at(inverse.clone(), inverse, r(1, 128)));
            }
            // The tests cover intervals around and next to the limits.
            assert!(at(low.clone() - r(1, 2), high.clone() + r(1, 2), r(0, 1)));
            assert!(
                at(low.clone() - r(1, 2), low.clone(), r(0, 1)) && at(high.clone(), r(odd + 1, 1), r(0, 1))
            );
            assert!(!at(high + &tiny, r(odd + 1, 1), r(0, 1)) && !at(r(odd - 1, 1), low - &tiny, r(0, 1)));
        }
        // The first odd number, 1, has no cycle of six reversals.
        assert!(!at(r(1, 1), r(1, 1), r(0, 1)) && !at(r(1, 2), r(2, 1), r(0, 1)));
        // Only part of the box has sufficiently little damping.
        assert!(may_reverse_six_times(&(r(1, 3), r(1, 3)), &(r(1, 129), r(1, 2))));
    }

    #[test]
    fn each_side_of_the_margin_has_its_verdict() {
        let exactly = |p, q| (r(p, q), r(p, q));
        let (six, far, none) = (exactly(1, 3), exactly(2, 5), exactly(0, 1));
        let strong = exactly(9, 1);
        let around_one = (r(1, 2), r(2, 1));
        let either = |a, b| Verdict::<f64>::Undecided(a, b);
        let (stuck, sticks, slides) = (Regime::Stuck, Regime::Sticking, Regime::NonSticking);
        let grows = either(slides, Regime::Unbounded);
        for (omega, alpha, zeta, margin, verdict) in [
            (&far, &strong, &none, Some(true), Verdict::NonSticking),
            (&far, &strong, &none, Some(false), Verdict::Sticking),
            (&far, &strong, &none, None, either(sticks, slides)),
            (&six, &strong, &none, Some(false), either(sticks, slides)),
            (&far, &around_one, &none, Some(true), either(stuck, slides)),
            (&far, &around_one, &none, Some(false), either(stuck, sticks)),
            (&far, &around_one, &none, None, either(stuck, slides)),
            (&six, &around_one, &none, Some(false), either(stuck, slides)),
            (&exactly(1, 1), &strong, &none, Some(true), grows),
            (&around_one, &strong, &none, Some(true), grows),
            (&(r(1, 2), r(1, 1)), &strong, &none, Some(true), grows),
            (&(r(1, 1), r(2, 1)), &strong, &none, Some(true), grows),
            (&(r(1, 1), r(2, 1)), &strong, &exactly(1, 100), Some(true), Verdict::NonSticking),
            (&(r(101, 100), r(2, 1)), &strong, &none, Some(true), Verdict::NonSticking),
            (&(r(1, 2), r(99, 100)), &strong, &none, Some(true), Verdict::NonSticking),
            (&far, &(r(1, 2), r(1, 1)), &none, None, Verdict::AtRest),
            (&far, &(r(1, 1), r(9, 1)), &none, Some(false), either(stuck, sticks)),
            (&far, &(r(1, 2), r(1001, 1000)), &none, Some(false), either(stuck, sticks)),
            (&far, &(r(1001, 1000), r(2, 1)), &none, Some(false), Verdict::Sticking),
        ] {
            assert_eq!(
                by_margin([omega, alpha, zeta], || Ok(margin)),
                Ok(verdict),
                "{omega:?} {alpha:?} {margin:?}"
            );
        }
    }
}
