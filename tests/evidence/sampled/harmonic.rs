//! The limit of a motion under a harmonic load, and its multipliers.

use super::{Equation, Follower, Found, Load, Machine, Of};

/// The excitation, amplitude and angular frequency of a harmonic load.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Harmonic {
    pub(crate) machine: Machine,
    pub(crate) load: Load,
    /// The amplitude of the load's first state, whose phase is ω t: `amplitude · sin ωt`.
    pub(crate) amplitude: f64,
    pub(crate) frequency: f64,
}

/// A periodic motion.
#[derive(Debug, Clone)]
pub(crate) struct Cycle {
    pub(crate) found: Found,
    /// Turns of the load.
    pub(crate) turns: u32,
    /// Whether the second half is the mirror image of the first, about the mean displacement.
    pub(crate) is_symmetric: bool,
    /// The two multipliers as their sum and their product.
    pub(crate) multipliers: [f64; 2],
    /// A follower at the beginning of a turn.
    pub(crate) begin: Follower,
    pub(crate) steps: u32,
}

/// The end of a motion under a harmonic load.
#[derive(Debug, Clone)]
pub(crate) enum Limit {
    Periodic(Box<Cycle>),
    /// At rest for good at x.
    Rest(f64),
    Unsettled,
}

impl Harmonic {
    pub(crate) fn equation(&self) -> Equation {
        let w = self.frequency;
        let law = [[0.0, w], [-w, 0.0]];
        Equation { machine: self.machine, load: self.load, law, surface: -1.0 / (w * w) }
    }

    /// Steps in a turn: 256 of the fastest part of the motion.
    pub(crate) fn steps(&self) -> u32 {
        let turn = std::f64::consts::TAU / self.frequency;
        2 * (128.0 * (turn / self.machine.period()).max(1.0)).ceil() as u32
    }

    /// The mean position, about which the motion is symmetric.
    pub(crate) fn mean(&self) -> f64 {
        (self.machine.mean - (self.machine.friction[0] - self.machine.friction[1]) / 2.0)
            / self.machine.stiffness
    }

    /// A follower at a phase of the load.
    pub(crate) fn follower(&self, start: [f64; 2], phase: f64) -> Follower {
        let step = std::f64::consts::TAU / self.frequency / f64::from(self.steps());
        let load = [self.amplitude * phase.sin(), self.amplitude * phase.cos()];
        Follower::new(self.equation(), start, load, phase / self.frequency, step)
    }

    /// Follows the motion from a start until it repeats, within so many turns.
    pub(crate) fn limit(&self, start: [f64; 2], phase: f64, most: u32) -> Limit {
        let steps = self.steps();
        let mut follower = self.follower(start, phase);
        let mut last: Vec<[f64; 2]> = Vec::new();
        for turn in 0..most {
            let (mut reach, mut speed, mut has_moved) = (0f64, 0f64, false);
            for _ in 0..steps {
                follower.advance(&mut None);
                reach = reach.max((follower.state[0] - self.mean()).abs());
                speed = speed.max(follower.state[1].abs());
                has_moved |= follower.sign != 0;
            }
            // The load is as it was; only the rounding of load and time grows.
            follower.time = phase / self.frequency;
            follower.set_load([self.amplitude * phase.sin(), self.amplitude * phase.cos()]);
            if !has_moved {
                return Limit::Rest(follower.state[0]);
            }
            let now = [follower.state[0], follower.state[1]];
            let repeats = |turns: usize, room: f64| {
                last.len() >= turns && {
                    let before = last[last.len() - turns];
                    (now[0] - before[0]).abs() <= room * reach && (now[1] - before[1]).abs() <= room * speed
                }
            };
            // A disturbance that turns may look small after some turns and grow again: the cycle is the shortest that
            // repeats to a coarser measure.
            if turn > 8
                && (1..=8).any(|turns| repeats(turns, 2e-14))
                && let Some(turns) = (1..=8).find(|&turns| repeats(turns, 1e-9))
                && repeats(turns, 1e-12)
            {
                // What is left of the way is a multiple of the last step where a disturbance decays slowly.
                for _ in 0..(turn / 3) * steps {
                    follower.advance(&mut None);
                }
                follower.time = phase / self.frequency;
                follower.set_load([self.amplitude * phase.sin(), self.amplitude * phase.cos()]);
                return Limit::Periodic(Box::new(self.cycle(follower, turns as u32)));
            }
            last.push(now);
        }
        Limit::Unsettled
    }

    /// The states (x, x′) of a cycle at a phase of the load, one for each of its turns.
    pub(crate) fn states(&self, cycle: &Cycle, phase: f64) -> Vec<[f64; 2]> {
        let turn = std::f64::consts::TAU;
        let begin = self.frequency * cycle.begin.time;
        let ahead = (phase - begin).rem_euclid(turn) / self.frequency;
        let mut follower = cycle.begin.clone();
        let step = turn / self.frequency / f64::from(cycle.steps);
        let whole = (ahead / step).floor();
        (0..cycle.turns)
            .map(|_| {
                let mut here = follower.clone();
                for _ in 0..whole as u64 {
                    here.advance(&mut None);
                }
                if ahead > whole * step {
                    here.set_step(ahead - whole * step);
                    here.advance(&mut None);
                }
                for _ in 0..cycle.steps {
                    follower.advance(&mut None);
                }
                [here.state[0], here.state[1]]
            })
            .collect()
    }

    /// The state (x, x′) after so many turns from a start.
    pub(crate) fn after(&self, start: [f64; 2], phase: f64, turns: u32) -> [f64; 2] {
        let mut follower = self.follower(start, phase);
        for _ in 0..turns * self.steps() {
            follower.advance(&mut None);
        }
        [follower.state[0], follower.state[1]]
    }

    /// The sum and the product of the multipliers of the map over so many turns, by differences at a point well within
    /// a slide that the motion from a start passes.
    pub(crate) fn multipliers(&self, start: [f64; 2], phase: f64, turns: u32) -> [f64; 2] {
        let steps = self.steps() * turns;
        let mut follower = self.follower(start, phase);
        let mut seam = follower.clone();
        for _ in 0..steps {
            follower.advance(&mut None);
            if follower.state[1].abs() > seam.state[1].abs() {
                seam = follower.clone();
            }
        }
        let size = 1e-6 * (seam.state[0].abs() + seam.state[1].abs());
        let map = |index: usize, sign: f64| {
            let mut moved = seam.clone();
            moved.state[index] += sign * size;
            for _ in 0..steps {
                moved.advance(&mut None);
            }
            [moved.state[0], moved.state[1]]
        };
        let column = |index: usize| {
            let (up, down) = (map(index, 1.0), map(index, -1.0));
            [(up[0] - down[0]) / (2.0 * size), (up[1] - down[1]) / (2.0 * size)]
        };
        let (one, two) = (column(0), column(1));
        [one[0] + two[1], one[0] * two[1] - one[1] * two[0]]
    }

    /// The cycle through the state of a follower.
    fn cycle(&self, begin: Follower, turns: u32) -> Cycle {
        let steps = self.steps();
        // The cycle is counted from the fastest sample, in the middle of a slide.
        let (mut seam, mut follower) = (begin.clone(), begin.clone());
        for _ in 0..steps * turns {
            follower.advance(&mut None);
            if follower.state[1].abs() > seam.state[1].abs() {
                seam = follower.clone();
            }
        }
        let mut found = seam.watched();
        let mut follower = seam.clone();
        let mut half = follower.state;
        for i in 0..steps * turns {
            if 2 * i == steps * turns {
                half = follower.state;
            }
            follower.advance(&mut found);
        }
        let mean = self.mean();
        let reach = found.as_ref().map_or(0.0, |found| {
            (found.most(Of::Displacement).value - found.least(Of::Displacement).value).abs()
        });
        let is_symmetric = turns % 2 == 1 && (half[0] - mean + seam.state[0] - mean).abs() < 1e-8 * reach;
        // The derivative of the map over the cycle, by differences.
        let sizes = [1e-5 * reach, 1e-5 * seam.state[1].abs()];
        let map = |index: usize, sign: f64| {
            let mut moved = seam.clone();
            moved.state[index] += sign * sizes[index];
            for _ in 0..steps * turns {
                moved.advance(&mut None);
            }
            [moved.state[0], moved.state[1]]
        };
        let column = |index: usize| {
            let (up, down) = (map(index, 1.0), map(index, -1.0));
            [(up[0] - down[0]) / (2.0 * sizes[index]), (up[1] - down[1]) / (2.0 * sizes[index])]
        };
        let (one, two) = (column(0), column(1));
        let multipliers = [one[0] + two[1], one[0] * two[1] - one[1] * two[0]];
        let found = found.unwrap_or_else(Found::new);
        Cycle { found, turns, is_symmetric, multipliers, begin, steps }
    }
}
