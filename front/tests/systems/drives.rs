//! Random machines with waves of other shapes, normal loads that vary, and bodies that are moved, beside small steps of the equations.
//!
//! The steps are those of Runge and Kutta, of order 4. An event is found by halving the step that passes it. The two have in common
//! the text of the file and nothing else: a wave is its formula here.

use crate::named;
use std::f64::consts::TAU;
use std::fmt::Write;
use stickslip::system::State as Full;

/// Numbers that look random.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// With four digits.
    fn between(&mut self, low: f64, high: f64) -> f64 {
        ((low + (high - low) * self.next()) * 1e4).round() / 1e4
    }
}

/// A function of time with its first and second derivative.
type OfTime = Box<dyn Fn(f64) -> [f64; 3]>;

/// A wave by its formula.
#[derive(Clone)]
struct Wave {
    shape: &'static str,
    amplitude: f64,
    frequency: f64,
    phase: f64,
    duty: f64,
}

impl Wave {
    fn new(random: &mut Random, shape: &'static str, amplitude: f64, frequency: f64) -> Self {
        let duty = if ["square", "pulse"].contains(&shape) { random.between(0.2, 0.8) } else { 0.5 };
        Self { shape, amplitude, frequency, phase: random.between(0.0, 6.0), duty }
    }

    fn text(&self) -> String {
        let Self { shape, amplitude, frequency, phase, duty } = self;
        let duty =
            if ["square", "pulse"].contains(shape) { format!(", duty = {duty:?}") } else { String::new() };
        format!(
            "amplitude = {amplitude:?}, frequency = \"{frequency:?} rad/s\", phase = {phase:?}, shape = \"{shape}\"{duty}"
        )
    }

    fn at(&self, t: f64) -> [f64; 3] {
        let angle = self.frequency * t + self.phase;
        let (sin, cos) = angle.sin_cos();
        let (p, w) = (self.amplitude, self.frequency);
        let part = (angle / TAU).rem_euclid(1.0);
        match self.shape {
            "sine" => [p * sin, p * w * cos, -(p * w * w * sin)],
            "square" => [if part < self.duty { p } else { -p }, 0.0, 0.0],
            "pulse" => [if part < self.duty { p } else { 0.0 }, 0.0, 0.0],
            "triangle" => {
                let slope = 4.0 * p * w / TAU;
                [4.0 * p / TAU * sin.asin(), if cos > 0.0 { slope } else { -slope }, 0.0]
            }
            _ => [p * (2.0 * part - 1.0), 2.0 * p * w / TAU, 0.0],
        }
    }

    /// The instants at which it changes its formula.
    fn breaks(&self, until: f64) -> Vec<f64> {
        let parts: &[f64] = match self.shape {
            "sine" => &[],
            "triangle" => &[0.25, 0.75],
            "sawtooth" => &[0.0],
            _ => &[0.0, self.duty],
        };
        let turns = (until * self.frequency / TAU) as i32 + 2;
        let all = (-1..=turns).flat_map(|k| parts.iter().map(move |part| f64::from(k) + part));
        all.map(|turn| (TAU * turn - self.phase) / self.frequency)
            .filter(|t| *t > 0.0 && *t < until)
            .collect()
    }
}

/// A machine of at most two bodies with one contact.
struct Machine {
    mass: [f64; 2],
    stiffness: [[f64; 2]; 2],
    damping: [[f64; 2]; 2],
    load: [OfTime; 2],
    /// The displacement of the first body, where it is prescribed.
    moved: Option<OfTime>,
    direction: [f64; 2],
    coefficient: f64,
    peak: f64,
    elastic: Option<f64>,
    /// The normal load: of time, of displacements and of velocities.
    normal: (OfTime, [f64; 2], [f64; 2]),
    breaks: Vec<f64>,
    start: [f64; 2],
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum Mode {
    Stuck,
    Slides(f64),
    Open,
    Holds,
    Yields(f64),
}

/// Displacements, velocities and the force of an elastic contact.
type State = [f64; 5];

fn plus(z: &State, by: f64, rate: &State) -> State {
    std::array::from_fn(|i| z[i] + by * rate[i])
}

impl Machine {
    /// M⁻¹ of a force, without a body that is moved.
    fn response(&self, f: [f64; 2]) -> [f64; 2] {
        let first = if self.moved.is_some() { 0.0 } else { f[0] / self.mass[0] };
        [first, f[1] / self.mass[1]]
    }

    fn along(&self, x: [f64; 2]) -> f64 {
        self.direction[0] * x[0] + self.direction[1] * x[1]
    }

    fn normal_load(&self, t: f64, z: &State) -> f64 {
        let (time, by, rate) = &self.normal;
        time(t)[0] + by[0] * z[0] + by[1] * z[1] + rate[0] * z[2] + rate[1] * z[3]
    }

    /// The accelerations under a force of the contact.
    fn acceleration(&self, t: f64, z: &State, tension: f64) -> [f64; 2] {
        let force = std::array::from_fn(|i| {
            let springs: f64 =
                (0..2).map(|j| self.stiffness[i][j] * z[j] + self.damping[i][j] * z[2 + j]).sum();
            self.load[i](t)[0] - springs - self.direction[i] * tension
        });
        let mut a = self.response(force);
        if let Some(moved) = &self.moved {
            a[0] = moved(t)[2];
        }
        a
    }

    /// The force that keeps the contact at rest.
    fn holding(&self, t: f64, z: &State) -> f64 {
        self.along(self.acceleration(t, z, 0.0)) / self.along(self.response(self.direction))
    }

    fn tension(&self, mode: Mode, t: f64, z: &State) -> f64 {
        match mode {
            Mode::Stuck => self.holding(t, z),
            Mode::Slides(s) | Mode::Yields(s) => s * self.coefficient * self.normal_load(t, z),
            Mode::Open => 0.0,
            Mode::Holds => z[4],
        }
    }

    /// (µN)′.
    fn bound_rate(&self, t: f64, z: &State, a: [f64; 2]) -> f64 {
        let (time, by, rate) = &self.normal;
        self.coefficient * (time(t)[1] + by[0] * z[2] + by[1] * z[3] + rate[0] * a[0] + rate[1] * a[1])
    }

    fn rate(&self, mode: Mode, t: f64, z: &State) -> State {
        let a = self.acceleration(t, z, self.tension(mode, t, z));
        let spring = match (mode, self.elastic) {
            (Mode::Holds, Some(k)) => k * self.along([z[2], z[3]]),
            _ => 0.0,
        };
        [z[2], z[3], a[0], a[1], spring]
    }

    /// Negative where the mode has ended.
    fn guards(&self, mode: Mode, t: f64, z: &State) -> [f64; 2] {
        let load = self.normal_load(t, z);
        let v = self.along([z[2], z[3]]);
        match mode {
            Mode::Stuck => [self.peak * self.coefficient * load - self.holding(t, z).abs(), load],
            Mode::Slides(s) => [s * v, load],
            Mode::Open => [-load, 1.0],
            Mode::Holds => [self.coefficient * load - z[4].abs(), 1.0],
            Mode::Yields(s) => {
                let a = self.acceleration(t, z, self.tension(mode, t, z));
                [s * self.elastic.unwrap() * v - self.bound_rate(t, z, a), load]
            }
        }
    }

    fn step(&self, mode: Mode, t: f64, z: &State, h: f64) -> State {
        // Just inside a piece, so that the formulae of its ends are its own.
        let inside = |at: f64| at.clamp(t + 1e-13, t + h - 1e-13);
        let k1 = self.rate(mode, inside(t), z);
        let k2 = self.rate(mode, t + h / 2.0, &plus(z, h / 2.0, &k1));
        let k3 = self.rate(mode, t + h / 2.0, &plus(z, h / 2.0, &k2));
        let k4 = self.rate(mode, inside(t + h), &plus(z, h, &k3));
        std::array::from_fn(|i| z[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
    }

    /// The mode of a contact at rest or in motion by its state alone.
    fn closed(&self, t: f64, z: &mut State) -> Mode {
        let v = self.along([z[2], z[3]]);
        if v.abs() > 1e-9 {
            return Mode::Slides(v.signum());
        }
        let by = self.response(self.direction);
        let share = v / self.along(by);
        (z[2], z[3]) = (z[2] - share * by[0], z[3] - share * by[1]);
        let holding = self.holding(t, z);
        let bound = self.peak * self.coefficient * self.normal_load(t, z);
        if holding.abs() <= bound { Mode::Stuck } else { Mode::Slides(holding.signum()) }
    }

    /// What follows a mode whose guard of this number is 0.
    fn next(&self, mode: Mode, guard: usize, t: f64, z: &mut State) -> Mode {
        match (mode, guard) {
            (Mode::Stuck, 0) => Mode::Slides(self.holding(t, z).signum()),
            (Mode::Slides(_), 0) => self.closed(t, z),
            (Mode::Holds, _) => {
                z[4] = z[4].signum() * self.coefficient * self.normal_load(t, z);
                Mode::Yields(z[4].signum())
            }
            (Mode::Yields(s), 0) => {
                z[4] = s * self.coefficient * self.normal_load(t, z);
                Mode::Holds
            }
            (Mode::Open, _) => {
                let v = self.along([z[2], z[3]]);
                let Some(k) = self.elastic else { return self.closed(t, z) };
                z[4] = 0.0;
                let a = self.acceleration(t, z, 0.0);
                if k * v.abs() <= self.bound_rate(t, z, a) { Mode::Holds } else { Mode::Yields(v.signum()) }
            }
            _ => {
                z[4] = 0.0;
                Mode::Open
            }
        }
    }

    /// The state at the end and the number of events, with steps of this length.
    fn followed(&self, until: f64, step: f64) -> (State, usize) {
        let mut z = [self.start[0], self.start[1], 0.0, 0.0, 0.0];
        let place = |z: &mut State, t: f64| {
            if let Some(moved) = &self.moved {
                let [x, v, _] = moved(t);
                (z[0], z[2]) = (x, v);
            }
        };
        place(&mut z, 1e-13);
        let mut mode = if self.normal_load(0.0, &z) < 0.0 {
            Mode::Open
        } else if self.elastic.is_some() {
            Mode::Holds
        } else {
            self.closed(1e-13, &mut z)
        };
        let mut events = 0;
        let mut pieces = self.breaks.clone();
        pieces.push(until);
        pieces.sort_by(f64::total_cmp);
        let mut t = 0.0;
        for end in pieces {
            let mut fine = 0;
            while t < end {
                let h = if fine > 0 { step / 64.0 } else { step }.min(end - t);
                fine -= 1;
                let after = self.step(mode, t, &z, h);
                let guards = self.guards(mode, t + h - 1e-13, &after);
                if guards.iter().all(|g| *g >= 0.0) {
                    (t, z) = (t + h, after);
                    // The last bit of a piece.
                    if end - t < 1e-12 {
                        t = end;
                    }
                    continue;
                }
                // The first zero of each guard that has become negative.
                let zero = |guard: usize| {
                    let (mut low, mut high) = (0.0, h);
                    for _ in 0..60 {
                        let middle = f64::midpoint(low, high);
                        let there = self.step(mode, t, &z, middle);
                        if self.guards(mode, t + middle, &there)[guard] < 0.0 {
                            high = middle;
                        } else {
                            low = middle;
                        }
                    }
                    low
                };
                let fired = (0..2).filter(|&i| guards[i] < 0.0).map(|i| (zero(i), i));
                let (at, guard) = fired.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
                z = self.step(mode, t, &z, at.max(1e-12));
                t += at;
                mode = self.next(mode, guard, t, &mut z);
                events += 1;
                fine = 64;
            }
            if end >= until {
                break;
            }
            // The loads, or a velocity that is prescribed, may have changed at once.
            place(&mut z, t + 1e-13);
            let old = mode;
            mode = match mode {
                Mode::Stuck | Mode::Slides(_) => {
                    let v = self.along([z[2], z[3]]);
                    let is_slow = matches!(mode, Mode::Slides(s) if s * v >= 0.0);
                    if is_slow { mode } else { self.closed(t + 1e-13, &mut z) }
                }
                Mode::Yields(_) if self.guards(mode, t + 1e-13, &z)[0] < 0.0 => self.next(mode, 0, t, &mut z),
                other => other,
            };
            events += usize::from(mode != old);
        }
        (z, events)
    }
}

fn zero() -> OfTime {
    Box::new(|_| [0.0; 3])
}

fn constant(x: f64) -> OfTime {
    Box::new(move |_| [x, 0.0, 0.0])
}

fn of(wave: &Wave, constant: f64) -> OfTime {
    let wave = wave.clone();
    Box::new(move |t| {
        let [x, v, a] = wave.at(t);
        [x + constant, v, a]
    })
}

const UNTIL: f64 = 6.0;

/// A body on springs, with a second one on it, under a load; the file is not finished.
fn frame(random: &mut Random, wave: &Wave) -> (String, Machine) {
    let mass = [random.between(0.5, 3.0), random.between(0.5, 3.0)];
    let [ground, between, other] =
        [random.between(20.0, 200.0), random.between(20.0, 200.0), random.between(20.0, 200.0)];
    let dampers = [random.between(0.1, 2.0), random.between(0.1, 2.0), random.between(0.1, 2.0)];
    let start = [random.between(-0.1, 0.1), random.between(-0.1, 0.1)];
    let mut text = format!(
        "units = \"N,m\"\nmasses = {{ a = {{ mass = {:?}, start = {:?} }}, b = {{ mass = {:?}, start = {:?} }} }}\n",
        mass[0], start[0], mass[1], start[1]
    );
    let ends = [("ground", "a"), ("a", "b"), ("ground", "b")];
    for ((first, second), (k, c)) in ends.iter().zip([ground, between, other].iter().zip(dampers)) {
        write!(
            text,
            "[[springs]]\nbetween = [\"{first}\", \"{second}\"]\nstiffness = {k:?}\ndamping = {c:?}\n"
        )
        .unwrap();
    }
    write!(text, "[[forces]]\non = \"a\"\nwaves = [{{ {} }}]\n", wave.text()).unwrap();
    let matrix = |x: [f64; 3]| [[x[0] + x[1], -x[1]], [-x[1], x[1] + x[2]]];
    let machine = Machine {
        mass,
        stiffness: matrix([ground, between, other]),
        damping: matrix(dampers),
        load: [of(wave, 0.0), zero()],
        moved: None,
        direction: [1.0, 0.0],
        coefficient: 1.0,
        peak: 1.0,
        elastic: None,
        normal: (constant(1.0), [0.0; 2], [0.0; 2]),
        breaks: wave.breaks(UNTIL),
        start,
    };
    (text, machine)
}

/// A load of another shape than a sine.
fn shaped(random: &mut Random) -> (String, Machine) {
    let shape = ["square", "triangle", "sawtooth", "pulse"][(4.0 * random.next()) as usize];
    let (size, frequency) = (random.between(8.0, 30.0), random.between(2.0, 8.0));
    let wave = Wave::new(random, shape, size, frequency);
    let (mut text, mut machine) = frame(random, &wave);
    let friction = random.between(1.0, 8.0);
    machine.peak = if random.next() < 0.5 { 1.0 } else { random.between(1.0, 1.5) };
    machine.normal.0 = constant(friction);
    write!(
        text,
        "[[contacts]]\nbetween = [\"ground\", \"a\"]\nfriction = {friction:?}\npeak = {:?}\n",
        machine.peak
    )
    .unwrap();
    (text, machine)
}

/// A normal load by a wave and a spring with a damper, on a rigid or on an elastic contact.
fn pressed(random: &mut Random, elastic: bool) -> (String, Machine) {
    let frequency = random.between(2.0, 8.0);
    let size = random.between(8.0, 30.0);
    let (mut text, mut machine) = {
        let wave = Wave::new(random, "sine", size, frequency);
        frame(random, &wave)
    };
    let shape = if random.next() < 0.6 { "sine" } else { "triangle" };
    let (mean, amplitude) = (random.between(8.0, 25.0), random.between(2.0, 30.0));
    let load = Wave::new(random, shape, amplitude, frequency);
    let (k, c) = (random.between(-60.0, 60.0), random.between(-1.0, 1.0));
    machine.coefficient = random.between(0.1, 0.5);
    machine.normal = (of(&load, mean), [0.0, k], [0.0, c]);
    machine.breaks = load.breaks(UNTIL);
    write!(
        text,
        "[[contacts]]\nbetween = [\"ground\", \"a\"]\ncoefficient = {:?}\nnormal_load = {{ constant = {mean:?}, {}, between = [\"ground\", \
         \"b\"], stiffness = {k:?}, damping = {c:?} }}\n",
        machine.coefficient,
        load.text()
    )
    .unwrap();
    if elastic {
        let stiffness = random.between(50.0, 400.0);
        machine.elastic = Some(stiffness);
        writeln!(text, "stiffness = {stiffness:?}").unwrap();
    }
    (text, machine)
}

/// A block on a table that is moved, held by a spring to the table and one to the ground.
fn moved(random: &mut Random, elastic: bool) -> (String, Machine) {
    let shape = if random.next() < 0.5 { "sine" } else { "triangle" };
    let (size, frequency) = (random.between(0.05, 0.3), random.between(2.0, 8.0));
    let wave = Wave::new(random, shape, size, frequency);
    let mass = random.between(0.5, 3.0);
    let [table, ground] = [random.between(10.0, 100.0), random.between(10.0, 100.0)];
    let [c, d] = [random.between(0.1, 1.0), random.between(0.1, 1.0)];
    let friction = random.between(1.0, 12.0);
    let mut text = format!(
        "units = \"N,m\"\nmasses = {{ table = {{ moves = {{ displacement = {{ {} }} }} }}, block = {mass:?} }}\n[[springs]]\nbetween = \
         [\"table\", \"block\"]\nstiffness = {table:?}\ndamping = {c:?}\n[[springs]]\nbetween = [\"ground\", \"block\"]\nstiffness = \
         {ground:?}\ndamping = {d:?}\n[[contacts]]\nbetween = [\"table\", \"block\"]\nfriction = {friction:?}\n",
        wave.text()
    );
    let stiffness = elastic.then(|| random.between(50.0, 400.0));
    if let Some(stiffness) = stiffness {
        writeln!(text, "stiffness = {stiffness:?}").unwrap();
    }
    let matrix = |x: f64, y: f64| [[x, -x], [-x, x + y]];
    let machine = Machine {
        mass: [1.0, mass],
        stiffness: matrix(table, ground),
        damping: matrix(c, d),
        load: [zero(), zero()],
        moved: Some(of(&wave, 0.0)),
        direction: [-1.0, 1.0],
        coefficient: friction,
        peak: 1.0,
        elastic: stiffness,
        normal: (constant(1.0), [0.0; 2], [0.0; 2]),
        breaks: wave.breaks(UNTIL),
        start: [0.0; 2],
    };
    (text, machine)
}

/// The events and the end of each machine are those of small steps.
fn compare(seed: u64, make: impl Fn(&mut Random) -> (String, Machine), usual: usize) -> usize {
    let count = crate::count(usual, 500);
    let mut random = Random(seed);
    let mut all = 0;
    for number in 0..count {
        let (text, machine) = make(&mut random);
        let system = named(&text);
        let motion =
            system.system.simulate(&system.described.start, UNTIL).unwrap_or_else(|e| panic!("{e}\n{text}"));
        let (q, v) = (&motion.end.displacement, &motion.end.velocity);
        let off = |step: f64| {
            let (z, events) = machine.followed(UNTIL, step);
            let by = (0..2).map(|i| (z[i] - q[i]).abs().max((z[2 + i] - v[i]).abs())).fold(0.0, f64::max);
            (by, events)
        };
        let is_near = |(by, events): (f64, usize)| by < 1e-9 && events == motion.events.len();
        // What the steps are too long for is seen by shorter ones.
        let found = off(5e-4);
        assert!(
            is_near(found) || is_near(off(5e-5)),
            "{number}: {found:?} {:?}, {} events\n{text}{:?}",
            off(5e-5),
            motion.events.len(),
            motion.events
        );
        all += motion.events.len();
    }
    all
}

/// An entry of a state: a displacement, a velocity or a force.
fn part(state: &mut Full<f64>, place: usize) -> Option<&mut f64> {
    let Full { displacement, velocity, force, .. } = state;
    displacement.iter_mut().chain(velocity.iter_mut()).chain(force).nth(place)
}

/// The steady motion is what the start leads to: the state after many periods. Its multipliers are those of differences.
#[test]
fn steady_motions_are_the_limits_of_the_start() {
    let count = crate::count(6, 100);
    let mut random = Random(6);
    let (mut settled, mut traces) = (0, 0);
    for number in 0..5 * count {
        let (text, machine) = match number % 5 {
            0 => shaped(&mut random),
            1 => pressed(&mut random, false),
            2 => pressed(&mut random, true),
            3 => moved(&mut random, false),
            _ => moved(&mut random, true),
        };
        let system = named(&text);
        let start = &system.described.start;
        let found = system.system.steady(start).unwrap_or_else(|e| panic!("{e}\n{text}"));
        let largest = found.multipliers.first().map_or(0.0, |(re, im)| re.hypot(*im));
        if found.kind.name() != "periodic" || largest > 0.98 {
            continue;
        }
        settled += 1;
        // As many periods of the loads as were followed, and whole periods of the motion more.
        let many = |count: usize| f64::from(u32::try_from(count).unwrap());
        let more = (-30.0 / largest.max(0.1).ln()).ceil();
        let time = found.period * (more + many(found.followed) / many(found.periods));
        let states = system.system.states(start, &[time]).unwrap();
        let apart = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let by = apart(&states[0].displacement, &found.start.displacement)
            .max(apart(&states[0].velocity, &found.start.velocity));
        assert!(by < 1e-9, "{number}: {by:e}, largest multiplier {largest}\n{text}");
        // The trace of the map's derivative is the sum of its multipliers; where the map has a corner there is none.
        let (n, size) = (found.start.displacement.len(), 1e-6);
        let after = |place: usize, by: f64| -> Option<f64> {
            let mut beside = found.start.clone();
            *part(&mut beside, place)? += by;
            let mut end = system.system.states(&beside, &[found.period]).ok()?.pop()?;
            part(&mut end, place).copied()
        };
        let first = usize::from(machine.moved.is_some());
        let last = n + n + usize::from(machine.elastic.is_some());
        let places = (first..n).chain(n + first..last);
        let trace = places.map(|place| {
            let (low, middle, high) = (after(place, -size)?, after(place, 0.0)?, after(place, size)?);
            let is_smooth = (low - 2.0 * middle + high).abs() < 1e-3 * size;
            is_smooth.then_some((high - low) / (2.0 * size))
        });
        let Some(trace) = trace.sum::<Option<f64>>() else { continue };
        let due: f64 = found.multipliers.iter().map(|(re, _)| re).sum();
        assert!((trace - due).abs() < 1e-4, "{number}: {trace} {:?}\n{text}", found.multipliers);
        traces += 1;
    }
    assert!(settled > 3 * count && traces > count, "{settled} {traces}");
}

#[test]
fn waves_of_other_shapes_are_those_of_small_steps() {
    assert!(compare(1, shaped, 25) > 200);
}

#[test]
fn normal_loads_that_vary_are_those_of_small_steps() {
    assert!(compare(2, |random| pressed(random, false), 25) > 200);
}

#[test]
fn elastic_contacts_under_normal_loads_that_vary_are_those_of_small_steps() {
    assert!(compare(3, |random| pressed(random, true), 25) > 200);
}

#[test]
fn bodies_that_are_moved_are_those_of_small_steps() {
    assert!(compare(4, |random| moved(random, false), 25) > 200);
}

#[test]
fn elastic_contacts_with_bodies_that_are_moved_are_those_of_small_steps() {
    assert!(compare(5, |random| moved(random, true), 25) > 200);
}
