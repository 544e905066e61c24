//! The other motion: a power series of x in time on each of many short parts of a step, whose coefficients follow from the
//! equation of motion. Stops are found by bisection, extremes among samples, and integrals by Gauss's rule.

use super::Machine;
use stickslip::Excitation;

/// What the other computation finds.
#[derive(Debug, Clone, Default)]
pub(super) struct Sampled {
    pub(super) displacement: [f64; 2],
    pub(super) velocity: [f64; 2],
    /// The greatest absolute acceleration and the greatest transmitted force.
    pub(super) acceleration: f64,
    pub(super) force: f64,
    pub(super) end: [f64; 2],
    pub(super) residual: Option<f64>,
    pub(super) path: f64,
    pub(super) slides: u64,
    pub(super) stops: u64,
    pub(super) reversals: u64,
    pub(super) stick_time: f64,
    pub(super) works: [f64; 3],
    pub(super) cut: Option<f64>,
    /// The least relative distance of a decision from its bound.
    pub(super) margin: f64,
    pub(super) gave_up: bool,
}

/// The terms of a power series on a part in which ω t and 2β t are below 1.
const TERMS: usize = 22;

/// x, its first two derivatives and its third at t, by the coefficients of its power series.
fn at(series: &[f64; TERMS], t: f64) -> [f64; 4] {
    let mut value = [0.0; 4];
    for n in (0..TERMS).rev() {
        let n_f = n as f64;
        value[0] = value[0] * t + series[n];
        if n >= 1 {
            value[1] = value[1] * t + n_f * series[n];
        }
        if n >= 2 {
            value[2] = value[2] * t + n_f * (n_f - 1.0) * series[n];
        }
        if n >= 3 {
            value[3] = value[3] * t + n_f * (n_f - 1.0) * (n_f - 2.0) * series[n];
        }
    }
    value
}

/// The point at which a function changes its sign.
fn bisected(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let sign = f(low).signum();
    for _ in 0..60 {
        let middle = (low + high) / 2.0;
        if f(middle).signum() == sign { low = middle } else { high = middle }
    }
    (low + high) / 2.0
}

/// Gauss's rule with five points on [−1, 1].
const GAUSS: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

/// A machine on its way, per mass.
pub(super) struct Other<'a> {
    machine: &'a Machine,
    rate: f64,
    square: f64,
    x: f64,
    v: f64,
    /// The direction, 0 at rest.
    sign: f64,
    /// The direction before the last stop, and whether the body has rested since.
    before: f64,
    has_rested: bool,
    found: Sampled,
    is_in_record: bool,
}

impl<'a> Other<'a> {
    pub(super) fn new(machine: &'a Machine) -> Self {
        let [x, v] = machine.start;
        let sign = if v > 0.0 {
            1.0
        } else if v < 0.0 {
            -1.0
        } else {
            0.0
        };
        let found = Sampled {
            displacement: [x; 2],
            velocity: [v; 2],
            margin: f64::INFINITY,
            slides: u64::from(sign != 0.0),
            ..Sampled::default()
        };
        let (rate, square) = (machine.damping / machine.mass, machine.stiffness / machine.mass);
        Self { machine, rate, square, x, v, sign, before: 0.0, has_rested: false, found, is_in_record: true }
    }

    /// Friction per mass against motion in a direction.
    fn friction(&self, sign: f64) -> f64 {
        let m = self.machine;
        if sign > 0.0 { m.forward / m.mass } else { m.backward / m.mass }
    }

    /// The force per mass that holds the body against one in a direction.
    fn held(&self, sign: f64) -> f64 {
        let m = self.machine;
        if sign < 0.0 && m.is_one_way {
            return f64::INFINITY;
        }
        let (mean, offset) = ((m.forward + m.backward) / 2.0, (m.forward - m.backward) / 2.0);
        (m.eta * mean + sign * offset) / m.mass
    }

    fn see(&mut self, [x, v, a]: [f64; 3], load: f64) {
        let m = self.machine;
        let found = &mut self.found;
        found.displacement = [found.displacement[0].max(x), found.displacement[1].min(x)];
        found.velocity = [found.velocity[0].max(v), found.velocity[1].min(v)];
        let (absolute, force) = match m.excitation {
            Excitation::SurfaceAcceleration => (a - load, m.mass * (a - load) - m.mean),
            Excitation::Force => (a, m.mass * (a - load) - m.mean),
            _ => (a, m.mass * a - m.mean),
        };
        found.acceleration = found.acceleration.max(absolute.abs());
        found.force = found.force.max(force.abs());
    }

    fn near(&mut self, margin: f64) {
        self.found.margin = self.found.margin.min(margin.abs());
    }

    fn release(&mut self, sign: f64) {
        self.sign = sign;
        self.found.slides += 1;
        if self.before != 0.0 && !self.has_rested {
            self.found.reversals += 1;
            self.found.stops -= 1;
        }
    }

    /// Follows a step with the load from + slope t per mass; `foot` is the velocity of a support with the damper on it.
    fn step(&mut self, length: f64, [from, slope, foot]: [f64; 3]) {
        let mut t = 0.0;
        let mean = self.machine.mean / self.machine.mass;
        let fastest = (self.square.sqrt()).max(self.rate).max(1e-3 / length);
        let part = (length / 2.0).min(1.0 / fastest);
        let mut events = 0;
        while t < length {
            let left = length - t;
            let (load, g) = (from + slope * t, from + slope * t + mean - self.square * self.x);
            if self.sign == 0.0 {
                let size = g.abs() + self.held(1.0);
                let after = if g > self.held(1.0) || g < -self.held(-1.0) {
                    Some(0.0)
                } else {
                    let last = g + slope * left;
                    let bound = if last > self.held(1.0) { Some(self.held(1.0)) } else { None };
                    let bound = if last < -self.held(-1.0) { Some(-self.held(-1.0)) } else { bound };
                    if size > 0.0 {
                        self.near((last - self.held(1.0)) / size);
                        self.near((last + self.held(-1.0)) / size);
                    }
                    let reached = |bound: f64| {
                        if g == bound { 0.0 } else { bisected(0.0, left, |t| g + slope * t - bound) }
                    };
                    bound.map(reached)
                };
                if size > 0.0 {
                    self.near((g - self.held(1.0)) / size);
                    self.near((g + self.held(-1.0)) / size);
                }
                let rests = after.unwrap_or(left);
                if rests > 0.0 {
                    self.has_rested = true;
                    self.see([self.x, 0.0, 0.0], load);
                    self.see([self.x, 0.0, 0.0], load + slope * rests);
                    if self.is_in_record {
                        self.found.stick_time += rests;
                    }
                    self.found.works[1] += self.machine.damping * foot * foot * rests;
                }
                t += rests;
                if after.is_none() {
                    return;
                }
                // At once by the force, later by its slope.
                let is_now = g > self.held(1.0) || g < -self.held(-1.0);
                self.release(if is_now { g.signum() } else { slope.signum() });
                continue;
            }
            let (sign, h) = (self.sign, part.min(left));
            let push = load + mean - sign * self.friction(sign);
            let mut series = [0.0; TERMS];
            (series[0], series[1]) = (self.x, self.v);
            for n in 0..TERMS - 2 {
                let k = n as f64;
                let of_load = [push, slope].get(n).copied().unwrap_or(0.0);
                let force = of_load - self.rate * (k + 1.0) * series[n + 1] - self.square * series[n];
                series[n + 2] = force / ((k + 1.0) * (k + 2.0));
            }
            let stop = self.stop(&series, h);
            let length = stop.unwrap_or(h);
            self.sample(&series, length, [load, slope, foot]);
            let end = at(&series, length);
            (self.x, self.v) = (end[0], end[1]);
            t += length;
            if stop.is_some() {
                (self.v, self.sign, self.before, self.has_rested) = (0.0, 0.0, sign, false);
                self.found.stops += 1;
                self.found.displacement =
                    [self.found.displacement[0].max(self.x), self.found.displacement[1].min(self.x)];
                if self.machine.stiffness == 0.0 && !self.is_in_record {
                    return;
                }
                events += 1;
                if events > 20_000 {
                    self.found.gave_up = true;
                    return;
                }
            }
        }
    }

    /// The first zero of the velocity on a part that is too short for more than two.
    fn stop(&mut self, series: &[f64; TERMS], h: f64) -> Option<f64> {
        let sign = self.sign;
        let speed = |t: f64| sign * at(series, t)[1];
        let (start, end) = (at(series, 0.0), at(series, h));
        if start[1] == 0.0 {
            // A slide that has just begun gathers speed first.
            let first = h * 1e-9;
            return match (speed(first) > 0.0, sign * end[1] > 0.0) {
                (_, true) => None,
                (true, false) => Some(bisected(first, h, speed)),
                (false, false) => Some(first),
            };
        }
        if sign * end[1] <= 0.0 {
            return Some(bisected(0.0, h, speed));
        }
        if sign * start[2] < 0.0 && sign * end[2] > 0.0 {
            let turn = bisected(0.0, h, |t| at(series, t)[2]);
            let size = (start[1].abs()).max(end[1].abs());
            let least = speed(turn);
            self.near(least / size);
            if least < 0.0 {
                return Some(bisected(0.0, turn, speed));
            }
        }
        None
    }

    /// Samples a part of a slide, and its extremes between the samples.
    fn sample(&mut self, series: &[f64; TERMS], length: f64, [load, slope, foot]: [f64; 3]) {
        const SAMPLES: usize = 4;
        let m = self.machine;
        let mut before = at(series, 0.0);
        let mut now = 0.0;
        self.see([before[0], before[1], before[2]], load);
        for i in 1..=SAMPLES {
            let t = length * i as f64 / SAMPLES as f64;
            let after = at(series, t);
            self.see([after[0], after[1], after[2]], load + slope * t);
            // Between them v, a and a − load have an extreme where a, a′ and a′ − slope change sign.
            type Derivative = fn([f64; 4], f64) -> f64;
            let derivatives: [Derivative; 3] = [|m, _| m[2], |m, _| m[3], |m, slope| m[3] - slope];
            for f in derivatives {
                if f(before, slope) * f(after, slope) < 0.0 {
                    let turn = bisected(now, t, |t| f(at(series, t), slope));
                    let [x, v, a, _] = at(series, turn);
                    self.see([x, v, a], load + slope * turn);
                }
            }
            (before, now) = (after, t);
        }
        let moved = (before[0] - series[0]).abs();
        self.found.path += moved;
        self.found.works[0] += m.mass * self.friction(self.sign) * moved;
        for (place, weight) in GAUSS {
            let t = length * (1.0 + place) / 2.0;
            let v = at(series, t)[1];
            let weight = weight * length / 2.0;
            self.found.works[1] += m.damping * (v - foot).powi(2) * weight;
            self.found.works[2] += (m.mass * (load + slope * t) + m.mean) * v * weight;
        }
    }

    /// Follows the body under a constant load to its rest, to within 1e-13 of its limit, or for a period.
    fn settle(&mut self, load: f64, end: f64, size: f64) {
        self.is_in_record = false;
        let m = self.machine;
        let (omega, mean) = (self.square.sqrt(), m.mean / m.mass);
        let is_free = m.forward == 0.0 && m.backward == 0.0;
        let counts = (self.found.slides, self.found.stops, self.found.reversals);
        if omega == 0.0 {
            // Without a spring the slide stops, slows down or runs.
            for _ in 0..100_000 {
                if self.sign == 0.0 {
                    let g = load + mean;
                    if g <= self.held(1.0) && g >= -self.held(-1.0) {
                        self.see([self.x, 0.0, 0.0], load);
                        self.found.residual = Some(self.x);
                        return;
                    }
                    self.release(g.signum());
                }
                let drive = self.sign * (load + mean) - self.friction(self.sign);
                if drive > 0.0 || (is_free && self.rate == 0.0 && drive == 0.0) {
                    self.found.cut = Some(end);
                    return;
                }
                if drive == 0.0 {
                    self.found.residual = Some(self.x + self.v / self.rate);
                    self.found.path += (self.v / self.rate).abs();
                    self.found.works[2] += (m.mass * load + m.mean) * self.v / self.rate;
                    self.found.works[1] += 0.5 * m.mass * self.v * self.v;
                    self.see([self.x, self.v, -self.rate * self.v], load);
                    self.see([self.x + self.v / self.rate, 0.0, 0.0], load);
                    return;
                }
                let stops = (self.v.abs() / drive.abs()).max(1e-12);
                self.step(stops, [load, 0.0, 0.0]);
            }
            self.found.gave_up = true;
            return;
        }
        if is_free && self.rate == 0.0 {
            let period = std::f64::consts::TAU / omega;
            self.step(period, [load, 0.0, 0.0]);
            if self.sign == 0.0 {
                self.found.residual = Some(self.x);
            } else {
                self.found.cut = Some(end + period);
            }
            return;
        }
        for _ in 0..2_000 {
            let (slides, stops) = (self.found.slides, self.found.stops);
            self.step(2.0 / omega, [load, 0.0, 0.0]);
            let limit = (load + mean - self.sign * self.friction(self.sign)) / self.square;
            let slow = if self.rate > 2.0 * omega { self.rate / omega } else { 1.0 };
            let rest = (self.x - limit).abs() + self.v.abs() * slow / omega;
            let is_at_rest = self.sign == 0.0 && (slides, stops) == (self.found.slides, self.found.stops);
            // What is left is below what the answers are compared to.
            let is_at_limit = self.sign != 0.0 && rest < 1e-13 * size;
            if is_at_rest || is_at_limit {
                self.found.residual = Some(if is_at_rest { self.x } else { limit });
                if is_free && !m.is_one_way && self.rate < 2.0 * omega {
                    (self.found.slides, self.found.stops, self.found.reversals) = counts;
                }
                return;
            }
        }
        self.found.gave_up = true;
    }

    pub(super) fn follow(mut self) -> Sampled {
        let m = self.machine;
        let factor = match m.excitation {
            Excitation::Force => 1.0 / m.mass,
            Excitation::SurfaceAcceleration => -1.0,
            _ => self.square,
        };
        let is_damped = m.excitation == Excitation::DampedFootMotion;
        for pair in m.samples.windows(2) {
            let slope = (pair[1] - pair[0]) / m.step;
            let foot = if is_damped { slope } else { 0.0 };
            self.step(m.step, [pair[0] * factor + self.rate * foot, slope * factor, foot]);
        }
        self.found.end = [self.x, self.v];
        let is_held = is_damped || m.excitation == Excitation::FootMotion;
        let load = if is_held { m.samples[m.samples.len() - 1] * factor } else { 0.0 };
        let most = self.found.displacement[0].abs().max(self.found.displacement[1].abs());
        let size = most + self.v.abs() * m.step;
        let end = m.step * (m.samples.len() - 1) as f64;
        self.settle(load, end, size);
        self.found
    }
}
