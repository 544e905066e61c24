//! A motion that does not become periodic.

use super::state::State;
use crate::float::Float;

/// A motion that was followed for many turns of the drive without becoming periodic, and whose neighbours do not approach it.
///
/// All of it is observed over the turns followed, after a quarter of them: no proof that the motion stays irregular for ever. Displacements in
/// units of B = r_y/k.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct Irregular<F> {
    pub(crate) state: State<F>,
    pub(crate) exponent: F,
    pub(crate) exponent_error: F,
    pub(crate) max_displacement: F,
    pub(crate) min_displacement: F,
    pub(crate) stops: u64,
    pub(crate) turns: u64,
    pub(crate) periods: F,
}

impl<F: Float> Irregular<F> {
    /// The greater Lyapunov exponent by turn of the drive: a small distance grows by `e^λ` in a turn, on average. From the exact linearised
    /// motion, by a disturbance that is carried along.
    pub const fn lyapunov_exponent(&self) -> F {
        self.exponent
    }

    /// Whether neighbours leave it exponentially: the exponent is above four times its standard error. Otherwise they neither leave nor approach
    /// it, as in a quasi-periodic motion.
    pub fn is_chaotic(&self) -> bool {
        self.exponent > F::int(4) * self.exponent_error
    }

    /// The standard error of that average, from the means of 32 parts of the time.
    pub const fn lyapunov_exponent_error(&self) -> F {
        self.exponent_error
    }

    /// The greatest displacement x/B that was met.
    pub const fn max_displacement(&self) -> F {
        self.max_displacement
    }

    /// The least displacement x/B that was met.
    pub const fn min_displacement(&self) -> F {
        self.min_displacement
    }

    /// Stops that were met.
    pub const fn stops(&self) -> u64 {
        self.stops
    }

    /// Turns of the drive over which exponent, extrema and stops were observed.
    pub const fn turns(&self) -> u64 {
        self.turns
    }

    /// Periods of the drive that were followed in all.
    pub const fn periods(&self) -> F {
        self.periods
    }

    /// The state reached in the end.
    pub const fn state(&self) -> State<F> {
        self.state
    }
}

#[cfg(test)]
mod tests {
    use crate::Ratios;
    use crate::exact::{DrivePhase, LongRun, State, Trajectory};

    fn ratios(eta: f64, alpha: f64) -> Ratios<f64> {
        let ratios = Ratios::new(0.45, alpha).unwrap().with_damping_ratio(0.02).unwrap();
        ratios.with_static_friction_ratio(eta).unwrap()
    }

    /// The state a turn of the drive later.
    fn turn(ratios: Ratios<f64>, start: State<f64>) -> State<f64> {
        let target = DrivePhase::in_cycle(1, 0.0).unwrap();
        let mut parts = Trajectory::new(ratios, start).unwrap().map(Result::unwrap);
        let part = parts.find(|part| part.end().is_none_or(|end| target.since(end.phase) <= 0.0)).unwrap();
        State { phase: start.phase, ..part.at(target).state }
    }

    /// The mean growth by turn of a distance of 1e-8 between two motions that is shortened after each.
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

    /// The exponent is the same from every start, and that of two motions that part.
    #[test]
    fn the_exponent_is_how_two_motions_part() {
        for (eta, alpha, expected) in [(2.5, 7.5, 0.135), (3.0, 8.5, 0.280)] {
            let ratios = ratios(eta, alpha);
            for (x, v) in [(0.0, 0.0), (4.0, 1.0), (-3.0, 6.0)] {
                let start = State::new(0.0, x, v).unwrap();
                let limit = LongRun::within(ratios, start, 16_000).unwrap();
                let LongRun::Irregular(motion) = limit else { panic!("{limit:?}") };
                let (found, error) = (motion.lyapunov_exponent(), motion.lyapunov_exponent_error());
                assert!(motion.is_chaotic() && (found - expected).abs() < 0.03 * expected, "{motion:?}");
                assert!(error < 0.02 * expected, "{motion:?}");
                let parting = growth(ratios, start, 3000);
                assert!((parting - expected).abs() < 0.1 * expected, "{eta}: {parting} for {expected}");
            }
        }
    }
}
