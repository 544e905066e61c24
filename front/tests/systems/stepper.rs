//! Small steps for one or two bodies in a row with one contact: an independent program for laws that are curves and for springs with laws.
//!
//! It steps by Runge and Kutta's fifth order after Dormand and Prince. The step in which a guard changes its sign is repeated with other
//! lengths until the guard is zero at its end. It shares no code and no formula with the engine.

/// A force over one variable.
pub(crate) type Law = Box<dyn Fn(f64) -> f64>;

/// `ground –(spring 1)– first body –(spring 2)– second body`, with a contact between the ground, or a belt, and the last body.
pub(crate) struct Machine {
    pub(crate) mass: Vec<f64>,
    /// The force of each spring over its stretch, its corners, and its damping constant.
    pub(crate) spring: Vec<(Law, Vec<f64>, f64)>,
    /// The friction over the speed; nothing without a contact.
    pub(crate) friction: Option<Law>,
    pub(crate) belt: f64,
    /// On the first body: amplitude, angular frequency, phase, constant.
    pub(crate) load: [f64; 4],
    pub(crate) start: Vec<f64>,
    pub(crate) step: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Mode {
    Slides(f64),
    Sticks,
}

/// The end of a motion: displacements, then velocities.
pub(crate) type End = (Vec<f64>, Vec<(f64, &'static str)>);

impl Machine {
    fn bodies(&self) -> usize {
        self.mass.len()
    }

    /// The force on each body without friction.
    fn forces(&self, t: f64, z: &[f64]) -> Vec<f64> {
        let n = self.bodies();
        let [amplitude, frequency, phase, constant] = self.load;
        let mut force = vec![0.0; n];
        force[0] += amplitude * (frequency * t + phase).sin() + constant;
        for (i, (law, _, damping)) in self.spring.iter().enumerate() {
            let below = |k: usize| if i == 0 { 0.0 } else { z[k + i - 1] };
            let pull = law(z[i] - below(0)) + damping * (z[n + i] - below(n));
            force[i] -= pull;
            if i > 0 {
                force[i - 1] += pull;
            }
        }
        force
    }

    fn slope(&self, t: f64, z: &[f64], mode: Mode) -> Vec<f64> {
        let n = self.bodies();
        let mut force = self.forces(t, z);
        let last = n - 1;
        match (mode, &self.friction) {
            (Mode::Sticks, _) => force[last] = 0.0,
            (Mode::Slides(sign), Some(law)) => force[last] -= sign * law(sign * (z[n + last] - self.belt)),
            (Mode::Slides(_), None) => {}
        }
        let mut slope = z[n..].to_vec();
        slope.extend(force.iter().zip(&self.mass).map(|(f, m)| f / m));
        slope
    }

    /// A step of Dormand and Prince's fifth order.
    fn stepped(&self, t: f64, z: &[f64], h: f64, mode: Mode) -> Vec<f64> {
        const A: [&[f64]; 6] = [
            &[],
            &[1.0 / 5.0],
            &[3.0 / 40.0, 9.0 / 40.0],
            &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
            &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
            &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
        ];
        const C: [f64; 6] = [0.0, 0.2, 0.3, 0.8, 8.0 / 9.0, 1.0];
        const B: [f64; 6] = [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0];
        let mut slopes: Vec<Vec<f64>> = Vec::new();
        let moved = |slopes: &[Vec<f64>], by: &[f64]| -> Vec<f64> {
            let sum = |i: usize| slopes.iter().zip(by).map(|(k, a)| a * k[i]).sum::<f64>();
            (0..z.len()).map(|i| z[i] + h * sum(i)).collect()
        };
        for (a, c) in A.iter().zip(C) {
            let at = moved(&slopes, a);
            slopes.push(self.slope(t + c * h, &at, mode));
        }
        moved(&slopes, &B)
    }

    /// What is positive as long as the mode and the pieces of the springs last.
    fn guards(&self, t: f64, z: &[f64], mode: Mode, sides: &[Vec<bool>]) -> Vec<f64> {
        let n = self.bodies();
        let mut guards = Vec::new();
        match (mode, &self.friction) {
            (Mode::Slides(sign), Some(_)) => guards.push(sign * (z[2 * n - 1] - self.belt)),
            (Mode::Sticks, Some(law)) => guards.push(law(0.0) - self.forces(t, z)[n - 1].abs()),
            (_, None) => {}
        }
        for (i, ((_, corners, _), sides)) in self.spring.iter().zip(sides).enumerate() {
            let stretch = z[i] - if i == 0 { 0.0 } else { z[i - 1] };
            guards
                .extend(corners.iter().zip(sides).map(|(c, up)| if *up { stretch - c } else { c - stretch }));
        }
        guards
    }

    /// On which side of its corners each spring is.
    fn sides(&self, z: &[f64]) -> Vec<Vec<bool>> {
        let stretch = |i: usize| z[i] - if i == 0 { 0.0 } else { z[i - 1] };
        self.spring.iter().enumerate().map(|(i, s)| s.1.iter().map(|c| stretch(i) > *c).collect()).collect()
    }

    /// What the contact does at rest.
    fn at_rest(&self, t: f64, z: &[f64]) -> Mode {
        let Some(law) = &self.friction else { return Mode::Slides(1.0) };
        let held = self.forces(t, z)[self.bodies() - 1];
        if held.abs() <= law(0.0) { Mode::Sticks } else { Mode::Slides(held.signum()) }
    }

    /// The motion from the start.
    pub(crate) fn follow(&self, until: f64) -> End {
        let n = self.bodies();
        let (mut t, mut z) = (0.0, self.start.clone());
        let speed = z[2 * n - 1] - self.belt;
        let mut mode = if speed == 0.0 { self.at_rest(t, &z) } else { Mode::Slides(speed.signum()) };
        let mut sides = self.sides(&z);
        let mut events = Vec::new();
        while t < until {
            let whole = self.step.min(until - t);
            let mut h = whole;
            let mut next = self.stepped(t, &z, h, mode);
            let before = self.guards(t, &z, mode, &sides);
            let after = self.guards(t + h, &next, mode, &sides);
            let falls = |k: &usize| after[*k] < 0.0 && before[*k] >= -1e-13;
            let fired: Vec<usize> = (0..after.len()).filter(falls).collect();
            let mut first = None;
            for k in fired {
                let (mut low, mut high) = (0.0, whole);
                for _ in 0..60 {
                    let middle = f64::midpoint(low, high);
                    let at = self.stepped(t, &z, middle, mode);
                    if self.guards(t + middle, &at, mode, &sides)[k] < 0.0 {
                        high = middle
                    } else {
                        low = middle
                    }
                }
                if first.is_none_or(|(time, _)| high < time) {
                    first = Some((high, k));
                }
            }
            if let Some((time, k)) = first {
                h = time;
                next = self.stepped(t, &z, h, mode);
                t += h;
                z = next;
                if k == 0 && self.friction.is_some() {
                    let old = mode;
                    if let Mode::Slides(_) = mode {
                        z[2 * n - 1] = self.belt;
                    }
                    mode = match old {
                        Mode::Sticks => Mode::Slides(self.forces(t, &z)[n - 1].signum()),
                        Mode::Slides(_) => self.at_rest(t, &z),
                    };
                    match (old, mode) {
                        (Mode::Sticks, _) => events.push((t, "slip")),
                        (_, Mode::Sticks) => events.push((t, "stick")),
                        (old, new) if old != new => events.push((t, "reverse")),
                        _ => events.push((t, "touch")),
                    }
                } else {
                    let place = k - usize::from(self.friction.is_some());
                    let mut all = sides.iter_mut().flatten();
                    if let Some(side) = all.nth(place) {
                        *side = !*side;
                    }
                }
                continue;
            }
            t += h;
            z = next;
        }
        (z, events)
    }
}
