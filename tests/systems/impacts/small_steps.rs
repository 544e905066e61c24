//! Bodies with frictions and stops by an independent program: Gragg's midpoint rule with extrapolation between events, an event by bisection,
//! and the forces of what is at rest by Gauss and Seidel's iteration. It has nothing in common with the engine.

use stickslip::system::{Event, EventKind, Model};

/// A stop with a restitution.
#[derive(Clone)]
pub(super) struct Wall {
    pub(super) b: Vec<f64>,
    pub(super) gap: f64,
    pub(super) e: f64,
}

/// A contact with Coulomb's friction, or, under a wall with this place among them, with a coefficient.
#[derive(Clone)]
pub(super) struct Rub {
    pub(super) b: Vec<f64>,
    pub(super) friction: f64,
    pub(super) peak: f64,
    pub(super) under: Option<usize>,
}

/// An event, with the velocity before a blow.
#[derive(Clone, Copy, Debug)]
pub(super) struct Kept {
    pub(super) time: f64,
    pub(super) element: usize,
    pub(super) kind: EventKind,
    pub(super) speed: f64,
}

impl Kept {
    pub(super) fn of(event: &Event<f64>) -> Self {
        let speed = event.velocities.map_or(0.0, |pair| pair.0);
        Self { time: event.time, element: event.element, kind: event.kind, speed }
    }
}

/// What an element does: it rests, slides in a direction, or, a stop, is away.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Mode {
    Rests,
    Slides(f64),
    Away,
}

#[derive(Clone)]
pub(super) struct Machine {
    /// Velocities below this are none after ever smaller blows.
    slow: f64,
    n: usize,
    inverse: Vec<Vec<f64>>,
    damping: Vec<Vec<f64>>,
    stiffness: Vec<Vec<f64>>,
    constant: Vec<f64>,
    waves: Vec<(f64, Vec<f64>, Vec<f64>)>,
    rubs: Vec<Rub>,
    walls: Vec<Wall>,
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// By Gauss and Jordan.
fn inverse(matrix: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let n = matrix.len();
    let mut rows: Vec<Vec<f64>> = (0..n)
        .map(|i| matrix[i].iter().copied().chain((0..n).map(|j| f64::from(u8::from(i == j)))).collect())
        .collect();
    for k in 0..n {
        let pivot = rows[k][k];
        rows[k].iter_mut().for_each(|x| *x /= pivot);
        let own = rows[k].clone();
        for (i, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != k) {
            let _ = i;
            let factor = row[k];
            row.iter_mut().zip(&own).for_each(|(x, y)| *x -= factor * y);
        }
    }
    rows.into_iter().map(|row| row[n..].to_vec()).collect()
}

/// Accelerations below this keep what rests.
const STILL: f64 = 1e-10;
/// A distance beyond a stop that is no rounding.
const DEEP: f64 = 1e-15;
/// A velocity that rounding cannot tell from 0: contacts of bodies that move together come to rest together.
const NONE: f64 = 1e-13;

impl Machine {
    pub(super) fn new(model: &Model<f64>, rubs: Vec<Rub>, walls: Vec<Wall>) -> Self {
        let waves = model.harmonics.iter().map(|h| (h.frequency, h.sin.clone(), h.cos.clone())).collect();
        Self {
            slow: 1e-6,
            n: model.mass.len(),
            inverse: inverse(&model.mass),
            damping: model.damping.clone(),
            stiffness: model.stiffness.clone(),
            constant: model.constant.clone(),
            waves,
            rubs,
            walls,
        }
    }

    /// The machine with another end of ever smaller blows.
    pub(super) fn with_slow(&self, slow: f64) -> Self {
        Self { slow, ..self.clone() }
    }

    fn count(&self) -> usize {
        self.rubs.len() + self.walls.len()
    }

    fn wall(&self, i: usize) -> Option<&Wall> {
        i.checked_sub(self.rubs.len()).and_then(|i| self.walls.get(i))
    }

    /// The place of the wall under whose force a contact is.
    fn wall_above(&self, i: usize) -> Option<usize> {
        Some(self.rubs.len() + self.rubs.get(i)?.under?)
    }

    /// Contacts under walls are away where these are, and slide or rest where they are not.
    fn follow(&self, modes: &mut [Mode], z: &[f64]) {
        for i in 0..self.rubs.len() {
            let Some(wall) = self.wall_above(i) else { continue };
            if modes[wall] == Mode::Away {
                modes[i] = Mode::Away;
            } else if modes[i] == Mode::Away {
                let v = self.velocity(i, z);
                modes[i] = if v.abs() > 1e-9 { Mode::Slides(v.signum()) } else { Mode::Rests };
            }
        }
    }

    fn b(&self, i: usize) -> &[f64] {
        self.wall(i).map_or_else(|| &self.rubs[i].b, |wall| &wall.b)
    }

    fn response(&self, b: &[f64]) -> Vec<f64> {
        self.inverse.iter().map(|row| dot(row, b)).collect()
    }

    /// The accelerations without the forces of what rests.
    fn free(&self, modes: &[Mode], t: f64, z: &[f64]) -> Vec<f64> {
        let (q, v) = z.split_at(self.n);
        let mut force: Vec<f64> = (0..self.n)
            .map(|i| {
                let loads = self.waves.iter().map(|(w, sin, cos)| {
                    let (s, c) = (w * t).sin_cos();
                    sin[i] * s + cos[i] * c
                });
                let held = dot(&self.stiffness[i], q) + dot(&self.damping[i], v);
                self.constant[i] + loads.sum::<f64>() - held
            })
            .collect();
        for (rub, mode) in self.rubs.iter().zip(modes).filter(|(rub, _)| rub.under.is_none()) {
            if let Mode::Slides(s) = mode {
                force.iter_mut().zip(&rub.b).for_each(|(f, b)| *f -= b * s * rub.friction);
            }
        }
        self.response(&force)
    }

    /// The accelerations, with the forces of what rests within their bounds.
    fn acceleration(&self, modes: &[Mode], t: f64, z: &[f64]) -> Vec<f64> {
        let mut a = self.free(modes, t, z);
        // With those that slide under a force that is sought.
        let is_under = |i: usize| self.wall_above(i).is_some() && modes[i] != Mode::Away;
        let rests: Vec<usize> =
            (0..self.count()).filter(|&i| modes[i] == Mode::Rests || is_under(i)).collect();
        let mut force = vec![0.0; rests.len()];
        let responses: Vec<Vec<f64>> = rests.iter().map(|&i| self.response(self.b(i))).collect();
        for _ in 0..4000 {
            let mut change: f64 = 0.0;
            for (k, &i) in rests.iter().enumerate() {
                let own = dot(self.b(i), &responses[k]);
                let load = |wall: usize| rests.iter().position(|&i| i == wall).map_or(0.0, |k| force[k]);
                let (low, high) = match (self.wall(i), modes[i]) {
                    (Some(_), _) => (0.0, f64::INFINITY),
                    (None, Mode::Slides(s)) => {
                        let kinetic = s * self.rubs[i].friction * self.wall_above(i).map_or(1.0, load);
                        (kinetic, kinetic)
                    }
                    (None, _) => {
                        let bound = self.rubs[i].friction * self.rubs[i].peak;
                        let bound = bound * self.wall_above(i).map_or(1.0, load);
                        (-bound, bound)
                    }
                };
                let new = (force[k] + dot(self.b(i), &a) / own).clamp(low, high);
                let by = new - force[k];
                force[k] = new;
                change = change.max(by.abs());
                a.iter_mut().zip(&responses[k]).for_each(|(a, r)| *a -= by * r);
            }
            if change < 1e-14 {
                break;
            }
        }
        a
    }

    fn rate(&self, modes: &[Mode], t: f64, z: &[f64]) -> Vec<f64> {
        let mut rate = z[self.n..].to_vec();
        rate.extend(self.acceleration(modes, t, z));
        rate
    }

    /// A step of the length h: midpoint rules of 2, 4, … 14 parts, extrapolated to none.
    fn step(&self, modes: &[Mode], t: f64, z: &[f64], h: f64) -> Vec<f64> {
        let mut last: Vec<Vec<f64>> = Vec::new();
        let slope = self.rate(modes, t, z);
        for k in 1..=7_u32 {
            let d = h / f64::from(2 * k);
            let mut before = z.to_vec();
            let mut now: Vec<f64> = z.iter().zip(&slope).map(|(z, r)| z + d * r).collect();
            for i in 1..2 * k {
                let rate = self.rate(modes, t + d * f64::from(i), &now);
                let next = before.iter().zip(&rate).map(|(z, r)| z + 2.0 * d * r).collect();
                before = std::mem::replace(&mut now, next);
            }
            let rate = self.rate(modes, t + h, &now);
            let mut rows =
                vec![(0..z.len()).map(|i| 0.5 * (now[i] + before[i] + d * rate[i])).collect::<Vec<_>>()];
            for (old, j) in last.iter().zip(1..k) {
                let ratio = (f64::from(k) / f64::from(k - j)).powi(2) - 1.0;
                let newest = &rows[rows.len() - 1];
                rows.push(newest.iter().zip(old).map(|(x, y)| x + (x - y) / ratio).collect());
            }
            last = rows;
        }
        last.pop().unwrap_or_else(|| z.to_vec())
    }

    fn velocity(&self, i: usize, z: &[f64]) -> f64 {
        dot(self.b(i), &z[self.n..])
    }

    /// Takes a velocity, or a distance, along an element out of a part of the state.
    fn without(&self, i: usize, part: &mut [f64], by: f64) {
        let response = self.response(self.b(i));
        let own = dot(self.b(i), &response);
        part.iter_mut().zip(&response).for_each(|(x, r)| *x -= by / own * r);
    }

    /// Whether an element's mode has ended.
    fn has_ended(&self, i: usize, modes: &[Mode], z: &[f64], a: &[f64]) -> bool {
        match modes[i] {
            Mode::Slides(s) => s * self.velocity(i, z) < -1e-14,
            Mode::Away => self.wall(i).is_some_and(|wall| dot(&wall.b, &z[..self.n]) > wall.gap + DEEP),
            Mode::Rests => dot(self.b(i), a).abs() > STILL,
        }
    }

    /// Lets go what cannot rest.
    fn settle(&self, modes: &mut [Mode], t: f64, z: &[f64]) {
        loop {
            let a = self.acceleration(modes, t, z);
            let along: Vec<f64> = (0..self.count()).map(|i| dot(self.b(i), &a)).collect();
            let leaves: Vec<usize> =
                (0..self.count()).filter(|&i| modes[i] == Mode::Rests && along[i].abs() > STILL).collect();
            if leaves.is_empty() {
                return;
            }
            for i in leaves {
                modes[i] = if self.wall(i).is_some() { Mode::Away } else { Mode::Slides(along[i].signum()) };
            }
            self.follow(modes, z);
        }
    }

    /// Blows at walls: `v₊ + e v ≤ 0`, `P ≥ 0`, one of them zero, at those that are hit and those in touch.
    fn blow(&self, modes: &mut [Mode], hit: &[usize], t: f64, z: &mut [f64], events: &mut Vec<Kept>) {
        let touches = |i: &usize| self.wall(*i).is_some() && modes[*i] == Mode::Rests;
        let mut all = hit.to_vec();
        all.extend((0..self.count()).filter(touches));
        let due: Vec<f64> = all
            .iter()
            .map(|&i| {
                let v = self.velocity(i, z);
                let e = self.wall(i).map_or(0.0, |wall| wall.e);
                if hit.contains(&i) && e * v > self.slow { -e * v } else { 0.0 }
            })
            .collect();
        let before: Vec<f64> = all.iter().map(|&i| self.velocity(i, z)).collect();
        let mut impulse = vec![0.0; all.len()];
        for _ in 0..4000 {
            let mut change: f64 = 0.0;
            for (k, &i) in all.iter().enumerate() {
                let own = dot(self.b(i), &self.response(self.b(i)));
                let new = (impulse[k] + (self.velocity(i, z) - due[k]) / own).max(0.0);
                let by = new - impulse[k];
                impulse[k] = new;
                change = change.max(by.abs());
                self.without(i, &mut z[self.n..], by * own);
            }
            if change < 1e-15 {
                break;
            }
        }
        // The friction under the impulses: it stops what slides, or is the coefficient times the impulse.
        let under: Vec<(usize, f64)> = (0..self.rubs.len())
            .filter_map(|i| {
                let wall = self.wall_above(i)?;
                let normal = all.iter().position(|&i| i == wall).map(|k| impulse[k])?;
                Some((i, self.rubs[i].friction * normal))
            })
            .collect();
        let mut friction = vec![0.0; under.len()];
        for _ in 0..4000 {
            let mut change: f64 = 0.0;
            for (k, &(i, most)) in under.iter().enumerate() {
                let own = dot(self.b(i), &self.response(self.b(i)));
                let new = (friction[k] + self.velocity(i, z) / own).clamp(-most, most);
                let by = new - friction[k];
                friction[k] = new;
                change = change.max(by.abs());
                self.without(i, &mut z[self.n..], by * own);
            }
            if change < 1e-15 {
                break;
            }
        }
        for (k, &i) in all.iter().enumerate() {
            let Some(wall) = self.wall(i) else { continue };
            let over = dot(&wall.b, &z[..self.n]) - wall.gap;
            self.without(i, &mut z[..self.n], over);
            if hit.contains(&i) && before[k] > self.slow {
                events.push(Kept { time: t, element: i, kind: EventKind::Blow, speed: before[k] });
            }
            let after = self.velocity(i, z);
            modes[i] = if after < -self.slow { Mode::Away } else { Mode::Rests };
        }
        for (i, mode) in modes.iter_mut().enumerate().take(self.rubs.len()) {
            let v = self.velocity(i, z);
            *mode = if v.abs() > 1e-9 { Mode::Slides(v.signum()) } else { Mode::Rests };
        }
        self.follow(modes, z);
        for (i, mode) in modes.iter().enumerate() {
            if *mode == Mode::Rests {
                let v = self.velocity(i, z);
                self.without(i, &mut z[self.n..], v);
            }
        }
    }

    /// The displacements and velocities at the end, and the events, with steps of this length, from displacements and velocities.
    pub(super) fn followed(&self, start: &[f64], until: f64, step: f64) -> (Vec<f64>, Vec<Kept>) {
        let mut z = start.to_vec();
        let first = |i| match self.velocity(i, start) {
            _ if self.wall(i).is_some() => Mode::Away,
            0.0 => Mode::Rests,
            v => Mode::Slides(v.signum()),
        };
        let mut modes: Vec<Mode> = (0..self.count()).map(first).collect();
        self.follow(&mut modes, start);
        self.settle(&mut modes, 0.0, &z);
        let (mut t, mut events) = (0.0, Vec::new());
        // Short steps after an event, so that a short flight is not passed over.
        let mut longest = 1e-6;
        while t < until {
            let h = step.min(until - t).min(longest);
            longest *= 1.6;
            let ended = |at: f64, only: Option<usize>| -> (Vec<f64>, Vec<usize>) {
                let after = self.step(&modes, t, &z, at);
                let a = self.acceleration(&modes, t + at, &after);
                let all = (0..self.count()).filter(|i| only.is_none_or(|only| only == *i));
                let found = all.filter(|&i| self.has_ended(i, &modes, &after, &a)).collect();
                (after, found)
            };
            let (after, fired) = ended(h, None);
            if fired.is_empty() {
                (t, z) = (t + h, after);
                if until - t < 1e-12 {
                    break;
                }
                continue;
            }
            let zero = |&i: &usize| {
                let (mut low, mut high) = (0.0, h);
                for _ in 0..48 {
                    let middle = f64::midpoint(low, high);
                    if ended(middle, Some(i)).1.is_empty() { low = middle } else { high = middle }
                }
                (high, i)
            };
            let (at, element) = fired.iter().map(zero).min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
            let (after, mut fired) = ended(at, None);
            let a = self.acceleration(&modes, t + at, &after);
            let stops = |i: usize| match modes[i] {
                Mode::Slides(s) => s * self.velocity(i, &after) < NONE && s * dot(self.b(i), &a) < 0.0,
                _ => false,
            };
            fired.extend((0..self.count()).filter(|&i| i == element || stops(i)));
            fired.sort_unstable();
            fired.dedup();
            let before = modes.clone();
            (t, z) = (t + at, after);
            longest = 1e-6;
            let hit = fired.iter().copied().filter(|&i| before[i] == Mode::Away && self.wall(i).is_some());
            let hit: Vec<usize> = hit.collect();
            for &i in fired.iter().filter(|&&i| matches!(before[i], Mode::Slides(_))) {
                let v = self.velocity(i, &z);
                self.without(i, &mut z[self.n..], v);
                modes[i] = Mode::Rests;
            }
            if !hit.is_empty() {
                self.blow(&mut modes, &hit, t, &mut z, &mut events);
            }
            self.settle(&mut modes, t, &z);
            for (element, pair) in before.iter().zip(&modes).enumerate() {
                let kind = match pair {
                    (Mode::Slides(_), Mode::Rests) => EventKind::Stick,
                    (Mode::Rests, Mode::Slides(_)) => EventKind::Slip,
                    (Mode::Slides(a), Mode::Slides(b)) if a != b && hit.is_empty() => EventKind::Reverse,
                    (Mode::Away, Mode::Rests | Mode::Slides(_)) => EventKind::Close,
                    (Mode::Rests | Mode::Slides(_), Mode::Away) => EventKind::Open,
                    _ => continue,
                };
                events.push(Kept { time: t, element, kind, speed: 0.0 });
            }
        }
        (z, events)
    }
}
