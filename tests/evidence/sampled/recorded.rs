//! The answers of a motion under a record and after it.

use super::{Equation, Follower, Found, Load, Machine};

/// The answers of a motion under a record and after it.
#[derive(Debug, Clone)]
pub(crate) struct Recorded {
    pub(crate) found: Found,
    /// Displacement and velocity at the end of the record.
    pub(crate) end: [f64; 2],
    /// Time at rest in the record.
    pub(crate) rest: f64,
    /// Slides, stops that a rest follows, and reversals; of a body without friction, which vibrates for ever, those in
    /// the record.
    pub(crate) counts: [u64; 3],
    /// Displacement at the end of the motion, and whether it rests there.
    pub(crate) last: f64,
    pub(crate) is_over: bool,
    /// Whether it tends to its end without a last stop.
    pub(crate) creeps: bool,
}

impl Recorded {
    /// The amplitude, the equivalent stiffness and the equivalent damping ratio of the longest swing between two turning
    /// points.
    pub(crate) fn greatest_cycle(&self, machine: &Machine, [x, v]: [f64; 2]) -> Option<[f64; 3]> {
        let &Machine { stiffness, friction: [forward, backward], is_one_way, .. } = machine;
        let mut turns = self.found.turns.clone();
        if v == 0.0 {
            turns.insert(0, [x, 0.0]);
        }
        if self.creeps {
            turns.push([self.last, self.found.absolute_damper_work]);
        }
        // Stops on the way from one turning point to the next are none.
        turns.dedup_by(|next, before| next[0] == before[0]);
        let mut kept: Vec<[f64; 2]> = Vec::new();
        for turn in turns {
            if let [.., first, second] = kept[..]
                && (second[0] - first[0]) * (turn[0] - second[0]) > 0.0
            {
                kept.pop();
            }
            kept.push(turn);
        }
        let swings = kept.windows(2).map(|pair| [pair[0], pair[1]]);
        let way = |[one, two]: &[[f64; 2]; 2]| (two[0] - one[0]).abs();
        let longest = swings.max_by(|one, two| way(one).total_cmp(&way(two))).filter(|_| !is_one_way)?;
        let [from, to] = longest;
        let (low, high) = (from[0].min(to[0]), from[0].max(to[0]));
        // The forces of spring and friction on arrival at both turning points, and the work on the way there and back.
        let secant = ((stiffness * high + forward) - (stiffness * low - backward)) / (high - low);
        let work = (forward + backward) * (high - low) + 2.0 * (to[1] - from[1]);
        let amplitude = (high - low) / 2.0;
        Some([amplitude, secant, work / (std::f64::consts::TAU * secant * amplitude * amplitude)])
    }
}

/// Follows a body from a start through samples at these times and until it rests, or for so many steps more.
pub(crate) fn record(
    machine: Machine,
    load: Load,
    times: &[f64],
    samples: &[f64],
    start: [f64; 2],
    parts: f64,
) -> Recorded {
    watched(machine, load, [times, samples], start, parts, false)
}

/// The same, with the absolute acceleration of each part if it is asked for.
pub(crate) fn watched(
    machine: Machine,
    load: Load,
    [times, samples]: [&[f64]; 2],
    start: [f64; 2],
    parts: f64,
    has_floor: bool,
) -> Recorded {
    let equation = Equation { machine, load, law: [[0.0, 1.0], [0.0, 0.0]], surface: 0.0 };
    let part = machine.period() / parts;
    let slope = |i: usize| (samples[i + 1] - samples[i]) / (times[i + 1] - times[i]);
    let mut follower = Follower::new(equation, start, [samples[0], slope(0)], times[0], 1.0);
    let mut found = follower.watched();
    if let Some(found) = &mut found {
        found.floor = has_floor.then(Vec::new);
    }
    for i in 0..samples.len() - 1 {
        let length = times[i + 1] - times[i];
        let count = (length / part).ceil().max(8.0);
        follower.set_step(length / count);
        follower.set_load([samples[i], slope(i)]);
        follower.time = times[i];
        for _ in 0..count as u64 {
            follower.advance(&mut found);
        }
    }
    let end = [follower.state[0], follower.state[1]];
    let rest = found.as_ref().map_or(0.0, |found| found.rest);
    let counted = |found: &Option<Found>| {
        found.as_ref().map_or([0; 3], |found| [found.slides, found.ends - found.reversals, found.reversals])
    };
    let in_record = counted(&found);
    // A support stays where it is; a force and an acceleration end.
    let held = if load.is_foot() { samples[samples.len() - 1] } else { 0.0 };
    follower.set_load([held, 0.0]);
    follower.time = times[samples.len() - 1];
    let longest = (times[samples.len() - 1] - times[0]) / 8.0;
    follower.set_step(part.min(longest));
    let (mut is_over, mut creeps, mut quiet) = (false, false, 0);
    for _ in 0..400_000 {
        if follower.sign == 0 && follower.direction() == 0 {
            is_over = true;
            break;
        }
        // A creep, or a vibration without friction, ends in rounding.
        quiet = if follower.state[1].abs() < 1e-13 * follower.speed { quiet + 1 } else { 0 };
        if quiet > 200 {
            (is_over, creeps) = (true, true);
            break;
        }
        follower.advance(&mut found);
    }
    let counts = if machine.friction == [0.0; 2] { in_record } else { counted(&found) };
    let found = found.unwrap_or_else(Found::new);
    Recorded { found, end, rest, counts, last: follower.state[0], is_over, creeps }
}

/// The displacements at the times of a record.
#[allow(dead_code, reason = "the command's tests include this file, too")]
pub(crate) fn positions(
    machine: Machine,
    load: Load,
    [times, samples]: [&[f64]; 2],
    start: [f64; 2],
    parts: f64,
) -> Vec<f64> {
    let equation = Equation { machine, load, law: [[0.0, 1.0], [0.0, 0.0]], surface: 0.0 };
    let part = machine.period() / parts;
    let slope = |i: usize| (samples[i + 1] - samples[i]) / (times[i + 1] - times[i]);
    let mut follower = Follower::new(equation, start, [samples[0], slope(0)], times[0], 1.0);
    let mut found = vec![start[0]];
    for i in 0..samples.len() - 1 {
        let length = times[i + 1] - times[i];
        let count = (length / part).ceil().max(8.0);
        follower.set_step(length / count);
        follower.set_load([samples[i], slope(i)]);
        follower.time = times[i];
        (0..count as u64).for_each(|_| follower.advance(&mut None));
        found.push(follower.state[0]);
    }
    found
}
