//! Two bodies in a row by small steps: the first on the ground by a spring, a damper and a contact, the second on the first, under
//! two sines. It shares no code and no formula with the library.
//!
//! A step is one of Runge and Kutta's fourth order, of the state and of the works. The end of a slide or of a rest is bisected.
//! Extremes are those of the steps, and between them the tops of parabolas.

/// Two bodies, their loads and the contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pair {
    pub(crate) mass: [f64; 2],
    /// Of the springs and dampers to the ground and between the bodies.
    pub(crate) spring: [f64; 2],
    pub(crate) damper: [f64; 2],
    pub(crate) friction: f64,
    /// The friction at rest over that in motion.
    pub(crate) peak: f64,
    /// The force on the second body: amplitude, angular frequency and phase of its sine.
    pub(crate) force: [f64; 3],
    /// The acceleration of the base, over which displacements are measured.
    pub(crate) base: [f64; 2],
}

/// Displacements, velocities, and the works of loads, dampers and contact.
pub(crate) type State = [f64; 7];

impl Pair {
    pub(crate) fn base_at(&self, t: f64) -> f64 {
        self.base[0] * (self.base[1] * t).sin()
    }

    fn loads(&self, t: f64) -> [f64; 2] {
        let [size, frequency, phase] = self.force;
        let force = size * (frequency * t + phase).sin();
        [-self.mass[0] * self.base_at(t), force - self.mass[1] * self.base_at(t)]
    }

    /// Forces of the springs and of the dampers.
    fn held([first, second]: [f64; 2], [x, y]: [f64; 2]) -> [f64; 2] {
        [first * x + second * (x - y), second * (y - x)]
    }

    /// The force of the contact on the ground: that of sliding, or the one that keeps the body at rest.
    pub(crate) fn contact(&self, t: f64, z: &State, sign: i32) -> f64 {
        match sign {
            0 => self.push(t, z),
            _ => f64::from(sign) * self.friction,
        }
    }

    /// The force of all but the contact on the first body.
    fn push(&self, t: f64, z: &State) -> f64 {
        let (spring, damper) = (Self::held(self.spring, [z[0], z[1]]), Self::held(self.damper, [z[2], z[3]]));
        self.loads(t)[0] - spring[0] - damper[0]
    }

    pub(crate) fn rate(&self, t: f64, z: &State, sign: i32) -> State {
        let (spring, damper) = (Self::held(self.spring, [z[0], z[1]]), Self::held(self.damper, [z[2], z[3]]));
        let (load, contact) = (self.loads(t), self.contact(t, z, sign));
        [
            z[2],
            z[3],
            (load[0] - spring[0] - damper[0] - contact) / self.mass[0],
            (load[1] - spring[1] - damper[1]) / self.mass[1],
            load[0] * z[2] + load[1] * z[3],
            damper[0] * z[2] + damper[1] * z[3],
            contact * z[2],
        ]
    }

    pub(crate) fn energy(&self, z: &State) -> f64 {
        let stretch = z[1] - z[0];
        let kinetic = self.mass[0] * z[2] * z[2] + self.mass[1] * z[3] * z[3];
        0.5 * (kinetic + self.spring[0] * z[0] * z[0] + self.spring[1] * stretch * stretch)
    }

    fn step(&self, t: f64, z: &State, sign: i32, h: f64) -> State {
        let at = |k: &State, share: f64| std::array::from_fn(|i| z[i] + share * h * k[i]);
        let a = self.rate(t, z, sign);
        let b = self.rate(t + h / 2.0, &at(&a, 0.5), sign);
        let c = self.rate(t + h / 2.0, &at(&b, 0.5), sign);
        let d = self.rate(t + h, &at(&c, 1.0), sign);
        std::array::from_fn(|i| z[i] + h / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]))
    }

    /// The direction of the motion after a velocity of zero: 0 where the contact holds.
    fn after_zero(&self, t: f64, z: &State) -> i32 {
        let push = self.push(t, z);
        if push.abs() <= self.peak * self.friction { 0 } else { push.signum() as i32 }
    }
}

/// What a motion has had so far.
#[derive(Debug, Clone)]
pub(crate) struct Stepped {
    pub(crate) pair: Pair,
    pub(crate) time: f64,
    pub(crate) state: State,
    pub(crate) sign: i32,
    /// Displacements, velocities and absolute accelerations of both bodies: the greatest and the least.
    pub(crate) extremes: [[f64; 2]; 6],
    pub(crate) events: Vec<(f64, &'static str)>,
    pub(crate) rest: f64,
    last: Vec<[f64; 6]>,
}

impl Stepped {
    pub(crate) fn new(pair: Pair, time: f64, start: [f64; 4]) -> Self {
        let state = [start[0], start[1], start[2], start[3], 0.0, 0.0, 0.0];
        let sign = if start[2] == 0.0 { pair.after_zero(time, &state) } else { start[2].signum() as i32 };
        let none = [f64::NEG_INFINITY, f64::INFINITY];
        let mut new =
            Self { pair, time, state, sign, extremes: [none; 6], events: vec![], rest: 0.0, last: vec![] };
        new.see();
        new
    }

    fn quantities(&self) -> [f64; 6] {
        let (z, rate) = (&self.state, self.pair.rate(self.time, &self.state, self.sign));
        let base = self.pair.base_at(self.time);
        [z[0], z[1], z[2], z[3], rate[2] + base, rate[3] + base]
    }

    /// Takes the extremes of the state, and the tops of parabolas through the last three steps.
    fn see(&mut self) {
        let now = self.quantities();
        self.last.push(now);
        let three = self.last.len().checked_sub(3).map(|from| [0, 1, 2].map(|i| self.last[from + i]));
        for (i, [most, least]) in self.extremes.iter_mut().enumerate() {
            (*most, *least) = (most.max(now[i]), least.min(now[i]));
            let Some([a, b, c]) = three.map(|three| three.map(|row| row[i])) else { continue };
            if (b - a) * (b - c) > 0.0 {
                let top = b + (c - a).powi(2) / (8.0 * (2.0 * b - a - c));
                (*most, *least) = (most.max(top), least.min(top));
            }
        }
    }

    /// Follows the motion for a time, in so many steps between events.
    pub(crate) fn follow(&mut self, duration: f64, steps: u32) {
        let (end, h) = (self.time + duration, duration / f64::from(steps));
        while self.time < end {
            let h = h.min(end - self.time);
            let next = self.pair.step(self.time, &self.state, self.sign, h);
            let is_over = |z: &State, at: f64| match self.sign {
                0 => self.pair.push(at, z).abs() > self.pair.peak * self.pair.friction,
                sign => f64::from(sign) * z[2] < 0.0,
            };
            if !is_over(&next, self.time + h) {
                self.rest += if self.sign == 0 { h } else { 0.0 };
                self.time = if end - self.time <= h { end } else { self.time + h };
                self.state = next;
                self.see();
                continue;
            }
            let (mut low, mut high) = (0.0, h);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                let z = self.pair.step(self.time, &self.state, self.sign, middle);
                if is_over(&z, self.time + middle) { high = middle } else { low = middle }
            }
            let mut z = self.pair.step(self.time, &self.state, self.sign, high);
            self.rest += if self.sign == 0 { high } else { 0.0 };
            self.time += high;
            z[2] = 0.0;
            self.state = z;
            // The end of a slide is an extreme, and so are both sides of a jump.
            self.see();
            let sign = match self.sign {
                0 => self.pair.push(self.time, &z).signum() as i32,
                _ => self.pair.after_zero(self.time, &z),
            };
            let kind = match (self.sign, sign) {
                (0, _) => "slip",
                (_, 0) => "stick",
                _ => "reverse",
            };
            self.events.push((self.time, kind));
            self.sign = sign;
            self.last.clear();
            self.see();
        }
    }
}
