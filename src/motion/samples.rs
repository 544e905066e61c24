//! The motion at evenly spaced phases, without drift.

use super::drive_phase::DrivePhase;
use super::state::Instant;
use super::trajectory::{Segment, Trajectory};
use crate::float::Float;
use crate::float::pair::Pair;
use crate::machine::error::{Error, Quantity, written};
use core::ops::ControlFlow;

/// The motion at the phases `θ = 2πk/n`, or at those of a sampling rate ([`Trajectory::samples_every`]), k counted up
/// from the first that is not before the start.
///
/// Each phase is computed from its integers k and n, never by adding up steps, so that the millionth cycle is
/// sampled as accurately as the first. The iterator is endless, also for a body that rests permanently; it
/// ends only after an error of the [`Trajectory`].
#[derive(Debug, Clone, Copy)]
pub struct Samples<F> {
    trajectory: Trajectory<F>,
    current: Option<Segment<F>>,
    place: Place<F>,
    /// The phase from which the samples are counted, where it is not 0.
    origin: Option<DrivePhase<F>>,
}

/// The next sample.
#[derive(Debug, Clone, Copy)]
enum Place<F> {
    /// Its cycle, its number in the cycle, and the number of samples in a cycle.
    OfCycle((i64, u32), u32),
    /// Its number k, and the turns of the drive from one sample to the next.
    Every(u64, F),
}

impl<F: Float> Place<F> {
    fn phase(&self) -> DrivePhase<F> {
        match *self {
            Self::OfCycle(at, per_cycle) => grid(at, per_cycle),
            Self::Every(k, turns) => multiple(k, turns),
        }
    }

    fn after(&self) -> Self {
        match *self {
            Self::OfCycle(at, per_cycle) => Self::OfCycle(after(at, per_cycle), per_cycle),
            Self::Every(k, turns) => Self::Every(k.saturating_add(1), turns),
        }
    }
}

impl<F: Float> Trajectory<F> {
    /// Samples of the motion, `per_cycle` of them in each cycle of the drive.
    ///
    /// # Errors
    /// Where `per_cycle` is zero, and as for the first item of the trajectory.
    pub fn samples(mut self, per_cycle: u32) -> Result<Samples<F>, Error> {
        if per_cycle == 0 {
            let value = written(f64::from(per_cycle));
            return Err(Error::NotPositive { quantity: Quantity::SamplesPerCycle, value });
        }
        let current = self.next().transpose()?;
        let mut at = (0, 0);
        if let Some(phase) = &current {
            let start = phase.start().phase;
            at.0 = start.cycles();
            // The search begins at the quotient less its rounding, so that few samples are skipped.
            let turn = start.reduced() / (F::int(2) * F::pi());
            let passed = F::from_f64(f64::from(per_cycle)) * (turn - F::int(8) * F::epsilon()) - F::int(1);
            at.1 = passed.to_f64() as u32;
            while grid::<F>(at, per_cycle).since(start) < F::int(0) {
                at = after(at, per_cycle);
            }
        }
        Ok(Samples { trajectory: self, current, place: Place::OfCycle(at, per_cycle), origin: None })
    }

    /// Samples of the motion at the phases `2πk turns` from 0 on, `turns` being the turns of the drive from one sample
    /// to the next, f_d/rate at a sampling rate. The first is at the start or after it.
    ///
    /// The phase of sample k has the rounding of `turns` k times, and no other.
    ///
    /// # Errors
    /// Where `turns` is not finite or not > 0, or so small that the number of a sample at the start is above 2⁵³, and as
    /// for the first item of the trajectory.
    #[doc(hidden)]
    pub fn samples_every(mut self, turns: F) -> Result<Samples<F>, Error> {
        let turns = crate::machine::ratios::positive(Quantity::SamplesPerCycle, turns)?;
        let current = self.next().transpose()?;
        let mut place = Place::Every(0, turns);
        if let Some(phase) = &current {
            let start = phase.start().phase;
            let begin = F::from_f64(start.cycles() as f64) + start.reduced() / (F::int(2) * F::pi());
            let (count, most) = (begin / turns, F::exp2i(53));
            if count > most {
                let (value, least) = (written(turns), written(begin / most));
                let greatest = written(F::int(1) / F::least_ratio());
                return Err(Error::OutOfRange {
                    quantity: Quantity::SamplesPerCycle,
                    value,
                    least,
                    greatest,
                });
            }
            // Less the rounding of the quotient, so that few samples are skipped. The cast to an integer saturates.
            let passed = count * (F::int(1) - F::int(16) * F::epsilon()) - F::int(2);
            place = Place::Every(passed.to_f64() as u64, turns);
            while place.phase().since(start) < F::int(0) {
                place = place.after();
            }
        }
        Ok(Samples { trajectory: self, current, place, origin: None })
    }
}

/// The phase 2πk turns: the product exactly, less its nearest half turn.
fn multiple<F: Float>(k: u64, turns: F) -> DrivePhase<F> {
    let Pair { hi, lo } = Pair::exact(F::from_f64(k as f64) * F::int(2)) * turns;
    let half_turn = hi.round();
    DrivePhase::of_half_turn(half_turn.to_f64() as i64, F::pi() * ((hi - half_turn) + lo))
}

/// The cycle and number of the sample after this one.
fn after((cycle, number): (i64, u32), per_cycle: u32) -> (i64, u32) {
    match number.saturating_add(1) {
        next if next < per_cycle => (cycle, next),
        _ => (cycle.saturating_add(1), 0),
    }
}

/// The phase 2π(cycle + k/n), n = `per_cycle`: the nearest half turn and the rest of less than half of one.
fn grid<F: Float>((cycle, number): (i64, u32), per_cycle: u32) -> DrivePhase<F> {
    let (k, n) = (i64::from(number), i64::from(per_cycle));
    // None of these products overflows an i64: k < n < 2³².
    let half_turn = k.saturating_mul(4).saturating_add(n).div_euclid(n.saturating_mul(2));
    let rest = k.saturating_mul(2).saturating_sub(half_turn.saturating_mul(n));
    let rest = F::from_f64(rest as f64) / F::from_f64(n as f64);
    DrivePhase::of_half_turn(cycle.saturating_mul(2).saturating_add(half_turn), F::pi() * rest)
}

impl<F: Float> Samples<F> {
    /// The phase of the next sample.
    fn phase(&self) -> DrivePhase<F> {
        let phase = self.place.phase();
        match self.origin {
            Some(origin) => phase.later_by_half_turns(origin.half_turns()).advanced(origin.angle()),
            None => phase,
        }
    }
}

// For the programs of this repository.
#[doc(hidden)]
impl<F: Float> Samples<F> {
    /// These samples counted from the start of the motion, which is the first of them.
    #[must_use]
    pub fn from_start(self) -> Self {
        let place = match self.place {
            Place::OfCycle(_, per_cycle) => Place::OfCycle((0, 0), per_cycle),
            Place::Every(_, turns) => Place::Every(0, turns),
        };
        Self { origin: self.current.map(|segment| segment.start().phase), place, ..self }
    }

    /// The next sample, as long as `keep_going` returns [`ControlFlow::Continue`]. `keep_going` is called at
    /// every slide and stop before the sample; a cycle has about 4 + 4/Ω of them. After an interruption the
    /// next call continues from there.
    ///
    /// An error is [`Error::Interrupted`] or an error of the trajectory.
    pub fn next_while(
        &mut self,
        mut keep_going: impl FnMut() -> ControlFlow<()>,
    ) -> Option<Result<Instant<F>, Error>> {
        let phase = self.phase();
        loop {
            let current = self.current?;
            if current.end().is_none_or(|end| phase.since(end.phase) <= F::int(0)) {
                self.place = self.place.after();
                return Some(Ok(current.at(phase)));
            }
            if keep_going().is_break() {
                return Some(Err(Error::Interrupted));
            }
            self.current = match self.trajectory.next()? {
                Ok(next) => Some(next),
                Err(error) => {
                    self.current = None;
                    return Some(Err(error));
                }
            };
        }
    }
}

impl<F: Float> Iterator for Samples<F> {
    type Item = Result<Instant<F>, Error>;

    fn next(&mut self) -> Option<Result<Instant<F>, Error>> {
        self.next_while(|| ControlFlow::Continue(()))
    }
}

#[cfg(test)]
mod tests {
    use super::grid;
    use crate::Error;
    use crate::Ratios;
    use crate::motion::{State, Trajectory};
    use core::ops::ControlFlow;
    use std::f64::consts::{PI, TAU};

    #[test]
    fn the_grid_is_exact() {
        for n in [1u32, 2, 3, 7, 360, u32::MAX] {
            for k in (0..n).step_by(1.max(n as usize / 500)) {
                for cycle in [-2, 0, 1] {
                    let p = grid::<f64>((cycle, k), n);
                    let theta = (cycle as f64 + f64::from(k) / f64::from(n)) * TAU;
                    assert!(
                        (p.angle() + p.half_turns() as f64 * PI - theta).abs() < 1e-14 * (1.0 + theta.abs())
                    );
                    assert!((-PI / 2.0..PI / 2.0).contains(&p.angle()), "{k}/{n}");
                    let far = grid::<f64>((cycle + 1_000_000, k), n);
                    assert_eq!((far.angle(), far.half_turns() - p.half_turns()), (p.angle(), 2_000_000));
                }
            }
        }
    }

    #[test]
    fn far_on_and_dense() {
        let ratios = Ratios::new(0.6, 1.7).unwrap();
        for (theta, per_cycle) in [(1e16, u32::MAX), (-1e16, u32::MAX), (3.0, u32::MAX), (6.2, 1), (0.0, 3)] {
            let start = State::new(theta, 0.3, -0.4).unwrap();
            let samples: Vec<_> = Trajectory::new(ratios, start)
                .unwrap()
                .samples(per_cycle)
                .unwrap()
                .take(3)
                .map(Result::unwrap)
                .collect();
            let first = samples[0].state.phase.since(start.phase);
            let step = TAU / f64::from(per_cycle);
            assert!((0.0..=step * (1.0 + 1e-15) + 1e-15).contains(&first), "{theta}: {first:e}");
            for pair in samples.windows(2) {
                assert!((pair[1].state.phase.since(pair[0].state.phase) - step).abs() < 1e-15);
            }
        }
    }

    /// Sampling interrupted at each slide and stop yields the same samples.
    #[test]
    fn a_sample_can_be_broken_off() {
        let motion = Trajectory::new(Ratios::new(0.01, 1.7).unwrap(), State::default()).unwrap();
        let mut broken = motion.samples(1).unwrap();
        for sample in motion.samples(1).unwrap().take(4).map(Result::unwrap) {
            let mut asked = 0;
            let found = loop {
                match broken.next_while(|| ControlFlow::Break(())).unwrap() {
                    Ok(found) => break found,
                    Err(error) => assert_eq!(error, Error::Interrupted),
                }
                assert_eq!(
                    broken.next_while(|| ControlFlow::Break(())).unwrap().err(),
                    Some(Error::Interrupted)
                );
                asked += 1;
                // Advance by one slide or stop.
                broken.current = broken.trajectory.next().transpose().unwrap();
            };
            assert_eq!(found, sample);
            assert!(asked == 0 || asked > 50, "{asked}");
        }
    }

    /// A rate that is no multiple of the frequency: each sample is the motion at its own phase, far on, too.
    #[test]
    fn samples_at_a_rate_follow_the_phases() {
        let motion = Trajectory::new(Ratios::new(0.6, 1.7).unwrap(), State::default()).unwrap();
        let turns = 0.013_7;
        for (k, sample) in motion.samples_every(turns).unwrap().take(3000).map(Result::unwrap).enumerate() {
            let phase = sample.state.phase;
            let theta = TAU * (turns * k as f64);
            assert!((phase.half_turns() as f64 * PI + phase.angle() - theta).abs() < 1e-12 * (1.0 + theta));
            let segment = motion.map(Result::unwrap).find(|s| s.end().unwrap().phase.since(phase) >= 0.0);
            if k % 500 == 0 {
                assert_eq!(segment.unwrap().at(phase), sample);
            }
        }
        let same: Vec<_> = motion.samples_every(1.0 / 64.0).unwrap().take(200).map(Result::unwrap).collect();
        let due: Vec<_> = motion.samples(64).unwrap().take(200).map(Result::unwrap).collect();
        assert_eq!(same, due);
        let later =
            Trajectory::new(Ratios::new(0.6, 1.7).unwrap(), State::new(100.0, 0.0, 0.0).unwrap()).unwrap();
        let first = later.samples_every(0.3).unwrap().next().unwrap().unwrap();
        assert!(
            (0.0..=0.3 * TAU).contains(&first.state.phase.since(State::new(100.0, 0.0, 0.0).unwrap().phase))
        );
        for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(motion.samples_every(wrong).is_err());
        }
        // A start far on, whose samples before it are not counted through, or not countable.
        for (turns, start) in [(1e-9, 3.0), (1e-12, 6.2), (1e-3, 1e9)] {
            let start = State::new(start, 0.3, -0.4).unwrap();
            let first = Trajectory::new(Ratios::new(0.6, 1.7).unwrap(), start).unwrap();
            let first = first.samples_every(turns).unwrap().next().unwrap().unwrap();
            let after = first.state.phase.since(start.phase);
            assert!((0.0..=turns * TAU * (1.0 + 1e-3)).contains(&after), "{turns}: {after:e}");
        }
        assert!(later.samples_every(1e-26).is_err());
        assert!(motion.samples_every(1e-26).is_ok());
    }

    #[test]
    fn samples_follow_the_phases() {
        let start = State::new(0.1, 0.3, -0.4).unwrap();
        let motion = Trajectory::new(Ratios::new(0.6, 1.7).unwrap(), start).unwrap();
        let samples: Vec<_> = motion.samples(97).unwrap().take(5 * 97).map(Result::unwrap).collect();
        let mut phases = motion.map(Result::unwrap).peekable();
        for sample in &samples {
            while phases.next_if(|p| p.end().unwrap().phase.since(sample.state.phase) < 0.0).is_some() {}
            let phase = phases.peek().unwrap();
            assert_eq!(phase.at(sample.state.phase), *sample);
        }
        assert!(samples[0].state.phase.since(start.phase) >= 0.0);
        assert!(motion.samples(0).is_err());
    }
}
