//! A motion that does not become periodic.

use crate::float::Float;
use crate::motion::state::State;

/// A motion that was followed for many turns of the drive without becoming periodic, and whose neighbours do
/// not approach it.
///
/// All values are observations over the turns computed, after the first quarter; they do not prove that the
/// motion remains irregular. Displacements are in units of B = r_y/k.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "F: Float + serde::Serialize",
        deserialize = "F: Float + serde::Deserialize<'de>"
    ))
)]
#[non_exhaustive]
#[must_use]
pub struct Irregular<F> {
    /// The larger Lyapunov exponent per turn of the drive: on average a small distance grows by `e^λ` in a
    /// turn. It is the mean growth of a disturbance under the exact linearised motion.
    pub lyapunov_exponent: F,
    /// The standard error of the Lyapunov exponent, from the means of 32 parts of the time.
    pub lyapunov_exponent_error: F,
    /// The maximum displacement x/B over the turns observed.
    pub max_displacement: F,
    /// The minimum displacement x/B over the turns observed.
    pub min_displacement: F,
    /// Stops over the turns observed.
    pub stops: u64,
    /// Turns of the drive over which exponent, extrema and stops were observed.
    #[cfg_attr(feature = "serde", serde(rename = "turns_observed"))]
    pub turns: u64,
    /// The number of periods of the drive that were followed, including those before the observation.
    pub periods: F,
    /// The state at the end.
    pub state: State<F>,
}

impl<F: Float> Irregular<F> {
    /// Whether neighbouring motions diverge exponentially: the exponent is above four times its standard
    /// error. Otherwise they neither diverge nor approach, as in a quasi-periodic motion.
    #[must_use]
    pub fn is_chaotic(&self) -> bool {
        self.lyapunov_exponent > F::int(4) * self.lyapunov_exponent_error
    }
}

#[cfg(test)]
mod tests {
    use crate::Ratios;
    use crate::motion::{DrivePhase, LongRun, State, Trajectory};
    use std::ops::ControlFlow;

    fn ratios(eta: f64, alpha: f64) -> Ratios<f64> {
        let ratios = Ratios::new(0.45, alpha).unwrap().with_damping_ratio(0.02).unwrap();
        ratios.with_static_friction_ratio(eta).unwrap()
    }

    /// The state one turn of the drive later.
    fn turn(ratios: Ratios<f64>, start: State<f64>) -> State<f64> {
        let target = DrivePhase::new(1, 0.0).unwrap();
        let mut parts = Trajectory::new(ratios, start).unwrap().map(Result::unwrap);
        let part = parts.find(|part| part.end().is_none_or(|end| target.since(end.phase) <= 0.0)).unwrap();
        State { phase: start.phase, ..part.at(target).state }
    }

    /// The mean growth per turn of the distance between two motions, which is reset to 1e-8 after each turn.
    fn growth(ratios: Ratios<f64>, start: State<f64>, turns: u32) -> f64 {
        let small = 1e-8;
        let (mut one, mut sum) = (start, 0.0);
        for _ in 0..200 {
            one = turn(ratios, one);
        }
        let mut other = State { x: one.x + small, ..one };
        for _ in 0..turns {
            (one, other) = (turn(ratios, one), turn(ratios, other));
            let (dx, dv) = (other.x - one.x, other.v - one.v);
            let distance = dx.hypot(dv);
            sum += (distance / small).ln();
            let shortened = small / distance;
            other = State { x: one.x + dx * shortened, v: one.v + dv * shortened, ..one };
        }
        sum / f64::from(turns)
    }

    /// The exponent is the same from every start, and equals the rate at which two motions separate.
    #[test]
    fn the_exponent_is_how_two_motions_part() {
        for (eta, alpha, expected) in [(2.5, 7.5, 0.135), (3.0, 8.5, 0.280)] {
            let ratios = ratios(eta, alpha);
            for (x, v) in [(0.0, 0.0), (4.0, 1.0), (-3.0, 6.0)] {
                let start = State::new(0.0, x, v).unwrap();
                let limit =
                    LongRun::within(ratios, start, 16_000, &mut || ControlFlow::Continue(())).unwrap();
                let LongRun::Irregular(motion) = limit else { panic!("{limit:?}") };
                let (found, error) = (motion.lyapunov_exponent, motion.lyapunov_exponent_error);
                assert!(motion.is_chaotic() && (found - expected).abs() < 0.03 * expected, "{motion:?}");
                assert!(error < 0.02 * expected, "{motion:?}");
                let parting = growth(ratios, start, 3000);
                assert!((parting - expected).abs() < 0.1 * expected, "{eta}: {parting} for {expected}");
            }
        }
    }
}
