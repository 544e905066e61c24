//! The regime below the border with damping: six reversals without a stop, or a stop in every cycle. Also the
//! verdict of a machine, whose ratios carry rounding.

use super::{Regime, Verdict};
use crate::cycle::Border;
use crate::cycle::six_reversals::{Within, force_ratios, within_edges};
use crate::float::Float;
use crate::machine::error::Error;
use crate::machine::ratios::Ratios;
use alloc::vec::Vec;

/// The verdict that holds for all ratios within rounding of these: two units in the last place of Ω and α,
/// four of ζ. `error` is the border's own relative error bound.
/// Over so small a box, the border is monotone in Ω and ζ except near an equally narrow peak. Its range is
/// taken from its values at the ends, in the middle and between. If they differ by more than an eighth, such
/// a peak may lie inside, and the verdict is undecided. This is a check, not a proof.
///
/// # Errors
/// Where a ratio leaves its domain.
pub(crate) fn verdict_around<F: Float>(ratios: Ratios<F>, error: F) -> Result<Verdict<F>, Error> {
    let (one, alpha) = (F::int(1), ratios.alpha());
    let off = |units: i32| one + F::int(units) * F::epsilon();
    let (weakest, strongest) = (alpha * off(-2), alpha * off(2));
    if strongest <= one {
        return Ok(Verdict::AtRest);
    }
    let mut points = Vec::with_capacity(15);
    for across in [0, -2, -1, 1, 2] {
        for along in [0, -4, 4] {
            let at = Ratios::new(ratios.omega() * off(across), alpha)?;
            points.push(at.with_damping_ratio(ratios.damping_ratio() * off(along))?);
        }
    }
    let borders = points.iter().map(|at| Border::of(at).min_force_ratio);
    let range = |(least, greatest): (F, F), b: F| (if b < least { b } else { least }, greatest.or_larger(b));
    let middle = Border::of(&ratios).min_force_ratio;
    let (least, greatest) = borders.fold((middle, middle), range);
    let is_wide = (greatest - least) * F::int(8) > greatest;
    // Such a peak is a maximum: an α far below all other values is below the peak, too.
    let below = if is_wide { least / F::int(2) } else { least * (one - error) };
    let is_below = strongest < below;
    if weakest <= one {
        let above = if is_below { Regime::Sticking } else { Regime::NonSticking };
        return Ok(Verdict::Undecided(Regime::Stuck, above));
    }
    if is_below {
        let mut found = points.iter().flat_map(|at| {
            let edges = force_ratios(at);
            [weakest, strongest].map(|alpha| within_edges(edges, alpha))
        });
        let first = found.next().unwrap_or(Within::Some);
        return Ok(match if found.all(|other| other == first) { first } else { Within::Some } {
            Within::All => Verdict::SixReversals,
            Within::None => Verdict::Sticking,
            Within::Some => Verdict::Undecided(Regime::Sticking, Regime::NonSticking),
        });
    }
    if !is_wide && weakest > greatest * (one + error) {
        return Ok(Verdict::NonSticking);
    }
    Ok(Verdict::Undecided(Regime::Sticking, Regime::NonSticking))
}

#[cfg(test)]
mod tests {
    use super::verdict_around;
    use crate::cycle::six_reversals::{Within, force_ratios, is_within, within_edges};
    use crate::motion::{LongRun, State};
    use crate::{Border, Ratios, Regime, Response, Verdict};

    const EITHER: Verdict<f64> = Verdict::Undecided(Regime::Sticking, Regime::NonSticking);

    fn ratios(omega: f64, alpha: f64, zeta: f64) -> Ratios<f64> {
        Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap()
    }

    #[test]
    fn an_edge_is_as_wide_as_its_error() {
        // The limits are 64 units in the last place, which are exact at powers of two.
        let error = 64.0 * f64::EPSILON;
        let at = |alpha: f64| within_edges(Some((4.0, 16.0)), alpha);
        for (alpha, inside) in [(4.0 * (1.0 + error), 1), (16.0 * (1.0 - error), -1)] {
            assert_eq!(at(alpha), Within::Some);
            assert_eq!(at(if inside > 0 { alpha.next_up() } else { alpha.next_down() }), Within::All);
        }
        for (alpha, inside) in [(4.0 * (1.0 - error), 1), (16.0 * (1.0 + error), -1)] {
            assert_eq!(at(alpha), Within::Some);
            assert_eq!(at(if inside > 0 { alpha.next_down() } else { alpha.next_up() }), Within::None);
        }
        assert_eq!(
            (at(4.0), at(16.0), at(8.0), at(1.0)),
            (Within::Some, Within::Some, Within::All, Within::None)
        );
        assert_eq!(within_edges(None, 8.0), Within::None);
        // The rounded edges themselves count as non-sticking.
        let (low, high) = force_ratios(&ratios(0.331, 1.0, 1e-3)).unwrap();
        let slides = |alpha| is_within(&ratios(0.331, alpha, 1e-3));
        assert!(slides(low) && slides(high) && slides(60.0));
        assert!(!slides(low.next_down()) && !slides(high.next_up()));
    }

    #[test]
    fn a_machine_is_decided_beyond_rounding() {
        let at = |omega, alpha| verdict_around(ratios(omega, alpha, 0.1), 16.0 * f64::EPSILON).unwrap();
        let least = Border::of(&Ratios::of_machine(0.7, 0.1).unwrap()).min_force_ratio;
        for (units, verdict) in [
            (100.0, Verdict::NonSticking),
            (16.0, EITHER),
            (0.0, EITHER),
            (-16.0, EITHER),
            (-100.0, Verdict::Sticking),
        ] {
            assert_eq!(at(0.7, least * (1.0 + units * f64::EPSILON)), verdict, "{units}");
        }
        // The limits are two units in the last place of α around 1.
        let stuck = Verdict::Undecided(Regime::Stuck, Regime::Sticking);
        for (alpha, verdict) in [
            (1.0 - 2.0 * f64::EPSILON, Verdict::AtRest),
            (1.0 - f64::EPSILON, stuck),
            (1.0, stuck),
            (1.0 + 2.0 * f64::EPSILON, stuck),
            (1.0 + 3.0 * f64::EPSILON, Verdict::Sticking),
        ] {
            assert_eq!(at(0.7, alpha), verdict, "{alpha:?}");
        }
        let six = |alpha| verdict_around(ratios(0.331, alpha, 1e-3), 16.0 * f64::EPSILON).unwrap();
        let (low, high) = force_ratios(&ratios(0.331, 1.0, 1e-3)).unwrap();
        let due = [Verdict::Sticking, EITHER, Verdict::SixReversals, EITHER, Verdict::Sticking];
        assert_eq!([low * 0.999, low, 60.0, high, high * 1.001].map(six), due);
    }

    /// The border near the pole at 1/3 in double precision, over the rounding of single precision. Where its
    /// values differ by more than an eighth of the greatest, there may be a peak between them.
    #[test]
    fn a_border_that_changes_by_an_eighth_may_have_a_peak() {
        let (unit, zeta) = (f64::from(f32::EPSILON), 1e-9f32);
        let (mut near, mut beyond) = (0, 0);
        let mut omega = (1.0f32 / 3.0) * (1.0 + 2e-6);
        while omega < (1.0f32 / 3.0) * (1.0 + 6e-6) {
            let border = |off: f64| {
                // Ω rounded to single precision.
                let omega = omega * (1.0 + off * unit) as f32;
                Border::of(&Ratios::of_machine(f64::from(omega), f64::from(zeta)).unwrap()).min_force_ratio
            };
            let values = [-2.0, -1.0, 0.0, 1.0, 2.0].map(border);
            let (least, greatest) = (values[4], values[0]);
            let spread = (greatest - least) / greatest;
            let at = |alpha: f64| {
                let ratios = Ratios::new(omega, alpha as f32).unwrap().with_damping_ratio(zeta).unwrap();
                verdict_around(ratios, 16.0 * f32::EPSILON).unwrap()
            };
            if spread > 0.126 {
                beyond += u32::from(spread < 0.14);
                assert!(
                    at(1.5 * greatest).regime().is_none() && at(0.9 * least).regime().is_none(),
                    "{omega}"
                );
                assert_eq!(at(0.45 * least), Verdict::SixReversals, "{omega}");
            } else if spread < 0.124 {
                near += u32::from(spread > 0.1125);
                assert_eq!(at(1.5 * greatest), Verdict::NonSticking, "{omega} {spread}");
            }
            omega = omega.next_up();
        }
        assert!(near > 0 && beyond > 0, "{near} {beyond}");
    }

    /// Below the border near a pole, the motion reverses six times with a little damping and stops with more.
    #[test]
    fn a_little_damping_leaves_six_reversals() {
        for (zeta, zeros) in [(1e-5, Some(6)), (1e-3, Some(6)), (0.01, None)] {
            let border = Border::of(&Ratios::of_machine(0.331, zeta).unwrap()).min_force_ratio;
            let ratios = Ratios::new(0.331, 0.62 * border).unwrap().with_damping_ratio(zeta).unwrap();
            let limit = LongRun::from_start(ratios, State::default()).unwrap();
            let steady = limit.steady_state().unwrap();
            let slides = steady.sticks_per_cycle == 0;
            assert_eq!(slides.then_some(steady.velocity_zeros_per_cycle), zeros, "{zeta}");
            let response = Response::new(ratios);
            let (regime, verdict) = match zeros {
                Some(_) => (Regime::NonSticking, Verdict::SixReversals),
                None => (Regime::Sticking, Verdict::Sticking),
            };
            assert_eq!((response.regime, response.reversals_per_cycle()), (regime, zeros), "{zeta}");
            assert!(response.cycle.is_none());
            assert_eq!(Verdict::new(ratios), verdict, "{zeta}");
            assert_eq!(crate::motion::limit::observed::observed(ratios, &limit).regime, regime, "{zeta}");
        }
    }
}
