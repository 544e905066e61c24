//! The motion at evenly spaced phases, without drift.

use super::drive::DrivePhase;
use super::state::Instant;
use super::trajectory::{Phase, Trajectory};
use crate::error::{Error, Quantity};
use crate::float::Float;

/// The motion at the phases `θ = 2πk/n`, k counted up from the first that is not before the start.
///
/// Each phase is made from its integers k and n, never by adding up steps, so that the millionth cycle is sampled as
/// exactly as the first. Endless: a body at rest for ever goes on being sampled.
#[derive(Debug, Clone, Copy)]
pub struct Samples<F> {
    trajectory: Trajectory<F>,
    current: Option<Phase<F>>,
    index: i64,
    per_cycle: i64,
}

impl<F: Float> Trajectory<F> {
    /// Samples of the motion, `per_cycle` of them in a cycle of the drive.
    ///
    /// # Errors
    /// Where `per_cycle` is zero.
    pub fn samples(mut self, per_cycle: u32) -> Result<Samples<F>, Error> {
        if per_cycle == 0 {
            let value = per_cycle.to_string();
            return Err(Error::NotPositive { quantity: Quantity::SamplesPerCycle, value });
        }
        let per_cycle = i64::from(per_cycle);
        let current = self.next();
        let mut index = 0;
        if let Some(phase) = &current {
            let start = phase.start().phase;
            index = start.cycles() * per_cycle;
            while grid::<F>(index, per_cycle).since(start) < F::int(0) {
                index += 1;
            }
        }
        Ok(Samples { trajectory: self, current, index, per_cycle })
    }
}

/// The phase 2πk/n, k = `index`, n = `per_cycle`: the nearest half turn and the rest of less than half of one.
fn grid<F: Float>(index: i64, per_cycle: i64) -> DrivePhase<F> {
    let cycles = index.div_euclid(per_cycle);
    let doubled = 2 * index.rem_euclid(per_cycle);
    let half_turn = (2 * doubled + per_cycle).div_euclid(2 * per_cycle);
    let rest = F::from_f64((doubled - half_turn * per_cycle) as f64) / F::from_f64(per_cycle as f64);
    DrivePhase::of_half_turn(2 * cycles + half_turn, F::pi() * rest)
}

impl<F: Float> Iterator for Samples<F> {
    type Item = Instant<F>;

    fn next(&mut self) -> Option<Instant<F>> {
        let phase = grid(self.index, self.per_cycle);
        loop {
            let current = self.current?;
            if current.end().is_none_or(|end| phase.since(end.phase) <= F::int(0)) {
                self.index += 1;
                return Some(current.at(phase));
            }
            self.current = self.trajectory.next();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::grid;
    use crate::Ratios;
    use crate::exact::{State, Trajectory};
    use std::f64::consts::{PI, TAU};

    #[test]
    fn the_grid_is_exact() {
        for n in [1i64, 2, 3, 7, 360] {
            for k in -2 * n..3 * n {
                let p = grid::<f64>(k, n);
                let theta = k as f64 * TAU / n as f64;
                assert!((p.angle() + p.half_turns() as f64 * PI - theta).abs() < 1e-14 * (1.0 + theta.abs()));
                assert!((-PI / 2.0..PI / 2.0).contains(&p.angle()), "{k}/{n}");
                let far = grid::<f64>(k + n * 1_000_000, n);
                assert_eq!((far.angle(), far.half_turns() - p.half_turns()), (p.angle(), 2_000_000));
            }
        }
    }

    #[test]
    fn samples_follow_the_phases() {
        let start = State::new(0.1, 0.3, -0.4).unwrap();
        let motion = Trajectory::new(Ratios::new(0.6, 1.7).unwrap(), start).unwrap();
        let samples: Vec<_> = motion.samples(97).unwrap().take(5 * 97).collect();
        let mut phases = motion.peekable();
        for sample in &samples {
            while phases.next_if(|p| p.end().unwrap().phase.since(sample.state.phase) < 0.0).is_some() {}
            let phase = phases.peek().unwrap();
            assert_eq!(phase.at(sample.state.phase), *sample);
        }
        assert!(samples[0].state.phase.since(start.phase) >= 0.0);
        assert!(motion.samples(0).is_err());
    }
}
