//! A motion on its way: step by step, with the event within a step by bisection.

use super::found::Part;
use super::{Equation, Found, Machine, Matrix, Of, Row, dot, exponential, moved, sum, times};

/// A motion on its way.
#[derive(Debug, Clone)]
pub(crate) struct Follower {
    pub(crate) equation: Equation,
    pub(super) matrices: [Matrix; 3],
    pub(super) steps: [Matrix; 3],
    pub(super) step: f64,
    pub(crate) state: Row,
    pub(crate) time: f64,
    /// The direction of the motion, 0 at rest.
    pub(crate) sign: i32,
    /// The greatest speed so far: smaller parts of it are rounding.
    pub(super) speed: f64,
    pub(super) rested: f64,
    /// The direction of the last slide that ended.
    pub(super) last: i32,
}

pub(super) const ROUNDING: f64 = 1e-14;

impl Follower {
    pub(crate) fn new(equation: Equation, [x, v]: [f64; 2], load: [f64; 2], time: f64, step: f64) -> Self {
        let matrices = [-1, 0, 1].map(|sign| equation.matrix(sign));
        let mut follower = Self {
            equation,
            matrices,
            steps: matrices.map(|a| exponential(&a, step, equation.rate())),
            step,
            state: [x, v, load[0], load[1], 1.0],
            time,
            sign: if v > 0.0 {
                1
            } else if v < 0.0 {
                -1
            } else {
                0
            },
            speed: v.abs(),
            rested: 0.0,
            last: 0,
        };
        if follower.sign == 0 {
            follower.sign = follower.direction();
        }
        follower
    }

    pub(super) fn matrix(&self) -> &Matrix {
        &self.matrices[(self.sign + 1) as usize]
    }

    /// The direction in which a body at v = 0 moves now; 0 where friction holds it, or nearly does: a force on the bound
    /// that grows releases the body in the step, and one that falls does not.
    pub(super) fn direction(&self) -> i32 {
        let Machine { held, is_one_way, .. } = self.equation.machine;
        let pull = dot(&self.equation.pull(), &self.state);
        if pull > held[0] * (1.0 + 1e-12) {
            1
        } else if -pull > held[1] * (1.0 + 1e-12) && !is_one_way {
            -1
        } else {
            0
        }
    }

    /// The state of the load jumps, to this one.
    pub(crate) fn set_load(&mut self, load: [f64; 2]) {
        (self.state[2], self.state[3]) = (load[0], load[1]);
    }

    pub(crate) fn set_step(&mut self, step: f64) {
        if step != self.step {
            self.step = step;
            let rate = self.equation.rate();
            self.steps = self.matrices.map(|a| exponential(&a, step, rate));
        }
    }

    /// The first zero of a guard `row · z`, which is not positive at first, within a time.
    pub(super) fn crossing(&self, row: &Row, length: f64, end: &Row, room: f64) -> Option<f64> {
        let a = self.matrix();
        let value = |t: f64| dot(row, &moved(a, &self.state, t));
        let slope = |z: &Row| dot(row, &times(a, z));
        let mut high = length;
        if dot(row, end) <= room {
            if !(slope(&self.state) > 0.0 && slope(end) < 0.0) {
                return None;
            }
            let mut low = 0.0;
            for _ in 0..60 {
                let middle = (low + high) / 2.0;
                if slope(&moved(a, &self.state, middle)) > 0.0 { low = middle } else { high = middle }
            }
            if value(high) <= room {
                return None;
            }
        }
        // It may begin at 0 or a rounding above.
        let mut low = 0.0;
        if dot(row, &self.state) >= 0.0 {
            let mut tried = high / 2.0;
            while value(tried) >= 0.0 {
                (high, tried) = (tried, tried / 2.0);
                if tried < 1e-12 * length {
                    return Some(0.0);
                }
            }
            low = tried;
        }
        for _ in 0..70 {
            let middle = (low + high) / 2.0;
            if value(middle) > 0.0 { high = middle } else { low = middle }
        }
        Some(high)
    }

    /// Follows the motion through one step.
    pub(crate) fn advance(&mut self, found: &mut Option<Found>) {
        let mut left = self.step;
        for _ in 0..1000 {
            if self.sign == 0 {
                let sign = self.direction();
                if sign != 0 {
                    self.release(sign, found);
                }
            }
            let is_whole = left == self.step;
            let end = if is_whole {
                times(&self.steps[(self.sign + 1) as usize], &self.state)
            } else {
                moved(self.matrix(), &self.state, left)
            };
            let event = if self.sign != 0 {
                self.speed = self.speed.max(end[1].abs());
                let row = [0.0, -f64::from(self.sign), 0.0, 0.0, 0.0];
                self.crossing(&row, left, &end, ROUNDING * self.speed).map(|t| (t, 0))
            } else {
                let Machine { held, is_one_way, .. } = self.equation.machine;
                let guard = |sign: f64, held: f64| {
                    sum(&[(sign, self.equation.pull()), (-held, [0.0, 0.0, 0.0, 0.0, 1.0])])
                };
                let forwards = self.crossing(&guard(1.0, held[0]), left, &end, 0.0).map(|t| (t, 1));
                let backwards = if is_one_way {
                    None
                } else {
                    self.crossing(&guard(-1.0, held[1]), left, &end, 0.0).map(|t| (t, -1))
                };
                match (forwards, backwards) {
                    (Some(one), Some(two)) => Some(if one.0 <= two.0 { one } else { two }),
                    (one, two) => one.or(two),
                }
            };
            let Some((t, next)) = event else {
                self.pass(end, left, found);
                return;
            };
            let mut at = moved(self.matrix(), &self.state, t);
            at[1] = 0.0;
            self.pass(at, t, found);
            left -= t;
            if self.sign != 0 {
                if let Some(found) = found {
                    found.ends += 1;
                    found.stops.push([self.time, self.state[0]]);
                    found.turns.push([self.state[0], found.absolute_damper_work]);
                }
                (self.last, self.sign, self.rested) = (self.sign, 0, 0.0);
            } else {
                self.release(next, found);
            }
            if left <= 0.0 {
                return;
            }
        }
        panic!("events without an end: {self:?}");
    }

    pub(super) fn release(&mut self, sign: i32, found: &mut Option<Found>) {
        if let Some(found) = found {
            // A velocity that touches zero is found to the root of its rounding, and rests for as long.
            let lasts = self.rested > 1e-5 * self.step;
            found.rests += u64::from(lasts);
            if lasts || self.last == 0 {
                found.slides += 1;
            } else if self.last == sign {
                // A touch: the slide goes on.
                found.ends -= 1;
                found.stops.pop();
                found.turns.pop();
            } else {
                found.slides += 1;
                found.reversals += 1;
            }
        }
        self.sign = sign;
    }

    pub(super) fn pass(&mut self, end: Row, length: f64, found: &mut Option<Found>) {
        if let Some(found) = found
            && length > 0.0
        {
            let a = &self.matrices[(self.sign + 1) as usize];
            let part = Part { a, start: self.state, end, time: self.time, length, sign: self.sign };
            found.add(&self.equation, &part);
        }
        if self.sign == 0 {
            self.rested += length;
        }
        (self.state, self.time) = (end, self.time + length);
    }

    pub(crate) fn watched(&self) -> Option<Found> {
        let mut found = Found::new();
        found.slides = u64::from(self.sign != 0);
        Some(found)
    }
}
