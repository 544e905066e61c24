//! What a stretch of a motion amounts to: extremes, paths, times at rest and works.

use super::{Equation, Extreme, Load, Machine, Matrix, Of, QUANTITIES, Row, dot, moved, sum, times};

/// What a stretch of a motion amounts to.
#[derive(Debug, Clone)]
pub(crate) struct Found {
    pub(super) most: [Extreme; 7],
    pub(super) least: [Extreme; 7],
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

    pub(super) fn new() -> Self {
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
pub(super) struct Part<'a> {
    pub(super) a: &'a Matrix,
    pub(super) start: Row,
    pub(super) end: Row,
    pub(super) time: f64,
    pub(super) length: f64,
    pub(super) sign: i32,
}

impl Found {
    pub(super) fn add(&mut self, equation: &Equation, part: &Part<'_>) {
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
            // The support works on a spring that the body does not move, too.
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

    pub(super) fn include(&mut self, of: Of, row: &Row, part: &Part<'_>, ends: &[[Row; 3]; 2]) {
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
