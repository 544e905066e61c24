//! A body with dry friction by small steps and dense samples: the reference of every number that a motion has.
//!
//! It shares no code and no formula with the library. The state (x, x′, load, second state of the load, 1) obeys a linear
//! equation in each direction of the motion and at rest. A step is its matrix exponential, by the power series with
//! scaling and squaring; a change of direction is bisected. Extremes are those of the samples, and between samples the
//! bisected zero of the derivative. Works are integrals over the steps by Hermite's formula of the sixth order.

#![allow(dead_code, reason = "each test takes what it needs")]

pub(crate) type Row = [f64; 5];
pub(crate) type Matrix = [Row; 5];

fn dot(a: &Row, b: &Row) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] + a[4] * b[4]
}

fn times(a: &Matrix, z: &Row) -> Row {
    [dot(&a[0], z), dot(&a[1], z), dot(&a[2], z), dot(&a[3], z), dot(&a[4], z)]
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let mut c = [[0.0; 5]; 5];
    for (row, into) in a.iter().zip(&mut c) {
        for (factor, other) in row.iter().zip(b) {
            for (sum, x) in into.iter_mut().zip(other) {
                *sum += factor * x;
            }
        }
    }
    c
}

fn sum(terms: &[(f64, Row)]) -> Row {
    let mut total = [0.0; 5];
    for (factor, row) in terms {
        for (into, x) in total.iter_mut().zip(row) {
            *into += factor * x;
        }
    }
    total
}

/// e^{Ah}, by the power series of A h/2ⁿ and n squarings. The rate is the greatest one of A, whatever the units of its
/// rows: a squaring more than needed would cost a bit.
fn exponential(a: &Matrix, h: f64, rate: f64) -> Matrix {
    let size = rate * h;
    let halvings = if size > 0.25 { (size / 0.25).log2().ceil() as i32 } else { 0 };
    let scale = h / 2f64.powi(halvings);
    let unit = |i: usize| {
        let mut row = [0.0; 5];
        row[i] = 1.0;
        row
    };
    let mut term: Matrix = std::array::from_fn(unit);
    let mut total = term;
    for k in 1..20 {
        term = product(a, &term);
        for (row, into) in term.iter_mut().zip(&mut total) {
            for (x, sum) in row.iter_mut().zip(into) {
                *x *= scale / f64::from(k);
                *sum += *x;
            }
        }
    }
    (0..halvings).fold(total, |power, _| product(&power, &power))
}

/// e^{At} z, by the power series over short parts of t.
fn moved(a: &Matrix, z: &Row, t: f64) -> Row {
    let mut term = *z;
    let mut total = *z;
    for k in 1..18 {
        let next = times(a, &term);
        for ((x, y), into) in term.iter_mut().zip(&next).zip(&mut total) {
            *x = y * t / f64::from(k);
            *into += *x;
        }
    }
    total
}

/// The load: its first state is a force on the body, the displacement of the foot of the spring, that of the foot of
/// spring and damper, or the acceleration of the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Load {
    Force,
    Foot,
    DampedFoot,
    Surface,
}

impl Load {
    pub(crate) fn is_foot(self) -> bool {
        matches!(self, Self::Foot | Self::DampedFoot)
    }
}

/// `m x″ + c x′ + k x + friction = load + p̄`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Machine {
    pub(crate) mass: f64,
    pub(crate) stiffness: f64,
    pub(crate) damping: f64,
    /// Friction against motion with x′ > 0 and with x′ < 0.
    pub(crate) friction: [f64; 2],
    /// The forces that release the body forwards and backwards.
    pub(crate) held: [f64; 2],
    pub(crate) mean: f64,
    pub(crate) is_one_way: bool,
}

impl Machine {
    /// A body with friction r_y in the mean, ±`offset` by direction, and static friction of η times the mean.
    pub(crate) fn new(
        [mass, stiffness, damping]: [f64; 3],
        [friction, offset, eta]: [f64; 3],
        mean: f64,
    ) -> Self {
        Self {
            mass,
            stiffness,
            damping,
            friction: [friction + offset, friction - offset],
            held: [eta * friction + offset, eta * friction - offset],
            mean,
            is_one_way: false,
        }
    }

    /// The shortest time in which the motion changes, as a period.
    pub(crate) fn period(&self) -> f64 {
        let natural = (self.stiffness / self.mass).sqrt();
        let rate = natural.max(self.damping / self.mass);
        std::f64::consts::TAU / rate.max(1e-300)
    }
}

/// Quantities that have extremes: x, x′, x″, the acceleration and the displacement in space, the force of spring,
/// damper and friction on their support, and that of the spring alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Of {
    Displacement,
    Velocity,
    Acceleration,
    AbsoluteAcceleration,
    AbsoluteDisplacement,
    Transmitted,
    Spring,
}
const QUANTITIES: [Of; 7] = [
    Of::Displacement,
    Of::Velocity,
    Of::Acceleration,
    Of::AbsoluteAcceleration,
    Of::AbsoluteDisplacement,
    Of::Transmitted,
    Of::Spring,
];

/// An extreme of the samples, that between samples, and the time of the latter.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Extreme {
    pub(crate) sampled: f64,
    pub(crate) value: f64,
    pub(crate) time: f64,
}

/// The body and its load as one linear equation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Equation {
    pub(crate) machine: Machine,
    pub(crate) load: Load,
    /// The load's state l obeys `l′ = law · l`.
    pub(crate) law: [[f64; 2]; 2],
    /// The displacement of the surface over its acceleration, where there is one.
    pub(crate) surface: f64,
}

impl Equation {
    /// The greatest rate of change.
    fn rate(&self) -> f64 {
        (std::f64::consts::TAU / self.machine.period()).max(self.law[1][0].abs())
    }

    /// The rate of change of the load's first state.
    fn load_rate(&self) -> Row {
        [0.0, 0.0, self.law[0][0], self.law[0][1], 0.0]
    }

    /// The force of the load on the body.
    fn force(&self) -> Row {
        let Machine { mass, stiffness, damping, .. } = self.machine;
        let first = [0.0, 0.0, 1.0, 0.0, 0.0];
        match self.load {
            Load::Force => first,
            Load::Foot => sum(&[(stiffness, first)]),
            Load::DampedFoot => sum(&[(stiffness, first), (damping, self.load_rate())]),
            Load::Surface => sum(&[(-mass, first)]),
        }
    }

    /// The force on a body at rest.
    fn pull(&self) -> Row {
        sum(&[
            (1.0, self.force()),
            (1.0, [-self.machine.stiffness, -self.machine.damping, 0.0, 0.0, self.machine.mean]),
        ])
    }

    fn matrix(&self, sign: i32) -> Matrix {
        let Machine { mass, friction, .. } = self.machine;
        let law = self.law;
        let load = [[0.0, 0.0, law[0][0], law[0][1], 0.0], [0.0, 0.0, law[1][0], law[1][1], 0.0]];
        if sign == 0 {
            return [[0.0; 5], [0.0; 5], load[0], load[1], [0.0; 5]];
        }
        let against = if sign > 0 { -friction[0] } else { friction[1] };
        let pull = sum(&[(1.0 / mass, self.pull()), (against / mass, [0.0, 0.0, 0.0, 0.0, 1.0])]);
        [[0.0, 1.0, 0.0, 0.0, 0.0], pull, load[0], load[1], [0.0; 5]]
    }

    /// A quantity as a row that the state is multiplied by.
    fn row(&self, of: Of, a: &Matrix) -> Row {
        let unit = |i: usize| {
            let mut row = [0.0; 5];
            row[i] = 1.0;
            row
        };
        let of_surface = f64::from(u8::from(self.load == Load::Surface));
        match of {
            Of::Displacement => unit(0),
            Of::Velocity => unit(1),
            Of::Acceleration => a[1],
            Of::AbsoluteAcceleration => sum(&[(1.0, a[1]), (of_surface, unit(2))]),
            Of::AbsoluteDisplacement => sum(&[(1.0, unit(0)), (of_surface * self.surface, unit(2))]),
            Of::Transmitted => {
                // m x″ = load + p̄ − transmitted; a foot and its surface are one support.
                let load = if self.load.is_foot() { 0.0 } else { 1.0 };
                sum(&[(load, self.force()), (self.machine.mean, unit(4)), (-self.machine.mass, a[1])])
            }
            // The foot is the load's first state where it moves.
            Of::Spring => {
                let foot = if self.load.is_foot() { 1.0 } else { 0.0 };
                sum(&[(self.machine.stiffness, unit(0)), (-self.machine.stiffness * foot, unit(2))])
            }
        }
    }
}

/// What a stretch of a motion amounts to.
#[derive(Debug, Clone)]
pub(crate) struct Found {
    most: [Extreme; 7],
    least: [Extreme; 7],
    /// Path forwards and backwards.
    pub(crate) path: [f64; 2],
    pub(crate) rest: f64,
    /// Rests that last, ends of slides, those that a slide in the other direction follows at once, and beginnings of
    /// slides.
    pub(crate) rests: u64,
    pub(crate) ends: u64,
    pub(crate) reversals: u64,
    pub(crate) slides: u64,
    /// Work of the load's force on the body, and of a moving support on spring and damper.
    pub(crate) load_work: f64,
    pub(crate) foot_work: f64,
    /// ∫ c v² of the velocity v, and that of the velocity between the damper's ends.
    pub(crate) absolute_damper_work: f64,
    pub(crate) damper_work: f64,
    /// The ends of slides: time and displacement.
    pub(crate) stops: Vec<[f64; 2]>,
    /// At each of them the displacement and the work of a damper on the ground so far.
    pub(crate) turns: Vec<[f64; 2]>,
    /// The absolute acceleration in each part, where it was asked for.
    pub(crate) floor: Option<Vec<Floor>>,
}

/// The absolute acceleration in a part of a motion: at the places of [`GAUSS`] and at both ends.
#[derive(Debug, Clone)]
pub(crate) struct Floor {
    pub(crate) length: f64,
    pub(crate) nodes: [f64; 5],
    pub(crate) ends: [f64; 2],
}

/// The places and weights of a Gauss quadrature on [0, 1].
pub(crate) const GAUSS: [[f64; 2]; 5] = [
    [0.046_910_077_030_668, 0.118_463_442_528_094_54],
    [0.230_765_344_947_158_45, 0.239_314_335_249_683_23],
    [0.5, 0.284_444_444_444_444_44],
    [0.769_234_655_052_841_5, 0.239_314_335_249_683_23],
    [0.953_089_922_969_332, 0.118_463_442_528_094_54],
];

impl Found {
    pub(crate) fn most(&self, of: Of) -> Extreme {
        self.most[of as usize]
    }
    pub(crate) fn least(&self, of: Of) -> Extreme {
        self.least[of as usize]
    }
    /// The greatest absolute value, of the samples and between them.
    pub(crate) fn greatest(&self, of: Of) -> Extreme {
        let (most, least) = (self.most(of), self.least(of));
        let sampled = most.sampled.abs().max(least.sampled.abs());
        let value = most.value.abs().max(least.value.abs());
        let time = if most.value.abs() >= least.value.abs() { most.time } else { least.time };
        Extreme { sampled, value, time }
    }
    pub(crate) fn friction_work(&self, machine: &Machine) -> f64 {
        machine.friction[0] * self.path[0] + machine.friction[1] * self.path[1]
    }

    fn new() -> Self {
        let nothing = |value: f64| [Extreme { sampled: value, value, time: f64::NAN }; 7];
        Self {
            most: nothing(f64::NEG_INFINITY),
            least: nothing(f64::INFINITY),
            path: [0.0; 2],
            rest: 0.0,
            rests: 0,
            ends: 0,
            reversals: 0,
            slides: 0,
            load_work: 0.0,
            foot_work: 0.0,
            absolute_damper_work: 0.0,
            damper_work: 0.0,
            stops: Vec::new(),
            turns: Vec::new(),
            floor: None,
        }
    }
}

/// The part of a motion between two samples or events.
struct Part<'a> {
    a: &'a Matrix,
    start: Row,
    end: Row,
    time: f64,
    length: f64,
    sign: i32,
}

impl Found {
    fn add(&mut self, equation: &Equation, part: &Part<'_>) {
        let Part { a, ref start, ref end, length, sign, .. } = *part;
        let derivatives = |z: &Row| {
            let first = times(a, z);
            [*z, first, times(a, &first)]
        };
        let ends = [derivatives(start), derivatives(end)];
        for of in QUANTITIES {
            self.include(of, &equation.row(of, a), part, &ends);
        }
        if let Some(floor) = &mut self.floor {
            let row = equation.row(Of::AbsoluteAcceleration, a);
            let nodes = GAUSS.map(|[place, _]| dot(&row, &moved(a, start, place * length)));
            floor.push(Floor { length, nodes, ends: [dot(&row, start), dot(&row, end)] });
        }
        if sign == 0 {
            self.rest += length;
            // The foot works on a spring that the body does not move, too.
        } else {
            self.path[usize::from(sign < 0)] += (end[0] - start[0]).abs();
        }
        let integral = |one: &Row, two: &Row| {
            let at = |[z, d, dd]: &[Row; 3]| {
                let (p, q) =
                    ([dot(one, z), dot(one, d), dot(one, dd)], [dot(two, z), dot(two, d), dot(two, dd)]);
                [p[0] * q[0], p[1] * q[0] + p[0] * q[1], p[2] * q[0] + 2.0 * p[1] * q[1] + p[0] * q[2]]
            };
            let (f, g) = (at(&ends[0]), at(&ends[1]));
            length * ((f[0] + g[0]) / 2.0 + length * ((f[1] - g[1]) / 10.0 + length * (f[2] + g[2]) / 120.0))
        };
        let velocity = [0.0, 1.0, 0.0, 0.0, 0.0];
        let Machine { stiffness, damping, .. } = equation.machine;
        if sign != 0 {
            self.load_work += integral(&equation.force(), &velocity);
            self.absolute_damper_work += damping * integral(&velocity, &velocity);
        }
        let rate = equation.load_rate();
        let on_foot = if equation.load == Load::DampedFoot { 1.0 } else { 0.0 };
        let between = sum(&[(1.0, velocity), (-on_foot, rate)]);
        self.damper_work += damping * integral(&between, &between);
        if equation.load.is_foot() {
            let spring = [-stiffness, 0.0, stiffness, 0.0, 0.0];
            let pull = sum(&[(1.0, spring), (-damping * on_foot, between)]);
            self.foot_work += integral(&pull, &rate);
        }
    }

    fn include(&mut self, of: Of, row: &Row, part: &Part<'_>, ends: &[[Row; 3]; 2]) {
        let index = of as usize;
        let at = |end: &[Row; 3]| [dot(row, &end[0]), dot(row, &end[1])];
        let [first, last] = [at(&ends[0]), at(&ends[1])];
        for (sign, best) in [(1.0, &mut self.most[index]), (-1.0, &mut self.least[index])] {
            for (value, time) in [(first[0], part.time), (last[0], part.time + part.length)] {
                if sign * value > sign * best.sampled {
                    best.sampled = value;
                }
                if sign * value > sign * best.value {
                    (best.value, best.time) = (value, time);
                }
            }
            let (up, down) = (sign * first[1], -sign * last[1]);
            let could = (sign * first[0]).max(sign * last[0]) + up.max(down) * part.length;
            if up > 0.0 && down > 0.0 && could > sign * best.value {
                let (mut low, mut high) = (0.0, part.length);
                for _ in 0..60 {
                    let middle = (low + high) / 2.0;
                    let z = moved(part.a, &part.start, middle);
                    if sign * dot(row, &times(part.a, &z)) > 0.0 { low = middle } else { high = middle }
                }
                let value = dot(row, &moved(part.a, &part.start, low));
                if sign * value > sign * best.value {
                    (best.value, best.time) = (value, part.time + low);
                }
            }
        }
    }
}

/// A motion on its way.
#[derive(Debug, Clone)]
pub(crate) struct Follower {
    pub(crate) equation: Equation,
    matrices: [Matrix; 3],
    steps: [Matrix; 3],
    step: f64,
    pub(crate) state: Row,
    pub(crate) time: f64,
    /// The direction of the motion, 0 at rest.
    pub(crate) sign: i32,
    /// The greatest speed so far: smaller parts of it are rounding.
    speed: f64,
    rested: f64,
    /// The direction of the last slide that ended.
    last: i32,
}

const ROUNDING: f64 = 1e-14;

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

    fn matrix(&self) -> &Matrix {
        &self.matrices[(self.sign + 1) as usize]
    }

    /// The direction in which a body at v = 0 moves now; 0 where friction holds it, or nearly does: a force on the bound
    /// that grows releases the body in the step, and one that falls does not.
    fn direction(&self) -> i32 {
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
    fn crossing(&self, row: &Row, length: f64, end: &Row, room: f64) -> Option<f64> {
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

    fn release(&mut self, sign: i32, found: &mut Option<Found>) {
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

    fn pass(&mut self, end: Row, length: f64, found: &mut Option<Found>) {
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
    // A foot stays where it is; a force and an acceleration end.
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
