//! The regime with damping: by the border, and below it by the exact motion where that may never stop.
//!
//! Beside the poles Ω = 1/(2n+1) of the border without damping there is a motion of six reversals a cycle and
//! no stop below the border (`crate::nonsticking::six_reversals`). A little damping leaves some of it: of 60
//! force ratios below the border at each of 60 frequencies within 0.07 of 1/Ω = 3, 5, 7, 9 it was met at ζ =
//! 0.0024 and below for 1/Ω = 3, at ζ = 0.001 and below for the others, within 0.034 of the pole, and at no
//! damping ratio from 0.006 to 1.5. So it is asked for where ζ < 1/128 and 1/Ω is within 1/16 of 2n + 1.

use crate::exact::{LongRun, State};
use crate::float::Float;
use crate::ratios::Ratios;

/// Whether the exact motion below the border never stops: `Some(false)` where it was not asked, `None` where
/// it does not settle.
pub(crate) fn never_stops<F: Float>(ratios: Ratios<F>) -> Option<bool> {
    let (one, two) = (F::int(1), F::int(2));
    let half_turns = one / ratios.omega();
    let odd = two * ((half_turns - one) / two).round() + one;
    let beside_pole = odd > one && (half_turns - odd).abs() * F::int(16) < one;
    if !beside_pole || ratios.damping_ratio() * F::int(128) >= one {
        return Some(false);
    }
    let limit = LongRun::from_start(ratios, State::rest()).ok()?;
    limit.steady_state().map(|steady| steady.sticks_per_cycle() == 0)
}

#[cfg(test)]
mod tests {
    use super::never_stops;
    use crate::exact::{LongRun, State};
    use crate::{Border, Place, Ratios, Regime, Response, Verdict};

    /// Below the border beside a pole the motion reverses six times with a little damping, and stops with
    /// more.
    #[test]
    fn a_little_damping_leaves_six_reversals() {
        for (zeta, zeros) in [(1e-5, Some(6)), (1e-3, Some(6)), (0.01, None)] {
            let border = Border::with_damping(0.331, zeta).unwrap().min_force_ratio();
            let ratios = Ratios::new(0.331, 0.62 * border).unwrap().with_damping_ratio(zeta).unwrap();
            let limit = LongRun::from_start(ratios, State::rest()).unwrap();
            let steady = limit.steady_state().unwrap();
            let slides = steady.sticks_per_cycle() == 0;
            assert_eq!(slides.then(|| steady.velocity_zeros_per_cycle()), zeros, "{zeta}");
            let response = Response::new(ratios);
            let (regime, verdict) = match zeros {
                Some(_) => (Regime::NonSticking, Verdict::SixReversals),
                None => (Regime::Sticking, Verdict::Sticking),
            };
            assert_eq!((response.regime(), response.reversals_per_cycle()), (regime, zeros), "{zeta}");
            assert!(response.cycle().is_none());
            assert_eq!(Place::new(ratios).verdict(), verdict, "{zeta}");
            assert_eq!(crate::regime::observed(ratios, &limit).regime, regime, "{zeta}");
        }
        let ratios = Ratios::new(0.4, 3.0).unwrap().with_damping_ratio(1e-5).unwrap();
        assert_eq!(never_stops(ratios), Some(false));
    }
}
