//! Bodies without mass in the questions that have closed forms, under a mass that a record shakes, and beside stops that give no way.

use crate::closed_form::contact;
use crate::compared::{Origin::SmallSteps, agreed, near};
use crate::generator::Random;
use stickslip::system::{
    Beyond, Element, Harmonic, Kind, Law, Model, Moved, MovedBy, Normal, Record, Signal, State, System,
};

fn rows(values: &[f64], n: usize) -> Vec<Vec<f64>> {
    values.chunks(n).map(<[f64]>::to_vec).collect()
}

/// A joint on the ground, whose spring of 2 is pulled by sin t, begins to slide at t = π/6 under a friction of 1, with cos π/6 at once: its greatest velocity.
#[test]
fn the_greatest_velocity_of_a_joint_is_where_it_begins_to_slide() {
    let pulled = Moved {
        coordinate: 1,
        by: MovedBy::Displacement,
        signal: Signal { sin: vec![1.0], ..Signal::constant(0.0) },
    };
    let model = Model {
        mass: rows(&[0.0, 0.0, 0.0, 1.0], 2),
        damping: rows(&[0.0; 4], 2),
        stiffness: rows(&[2.0, -2.0, -2.0, 2.0], 2),
        elements: vec![contact(vec![1.0, 0.0], 1.0, 1.0)],
        harmonics: vec![Harmonic { frequency: 1.0, sin: vec![], cos: vec![] }],
        moved: vec![pulled],
        ..Model::default()
    };
    let start = State { velocity: vec![0.0, 1.0], ..State::rest(2) };
    let motion = System::new(&model).unwrap().simulate(&start, 0.7).unwrap();
    let slip = std::f64::consts::FRAC_PI_6;
    assert!((motion.events[0].time - slip).abs() < 1e-14, "{:?}", motion.events);
    assert!((motion.max_velocity[0] - slip.cos()).abs() < 1e-14, "{}", motion.max_velocity[0]);
    assert!((motion.end.displacement[0] - (0.7_f64.sin() - 0.5)).abs() < 1e-14);
}

/// Springs in a row by hand: two masses with a joint between them and one between the first and the ground. The border is that of one
/// spring each, and at 1.001 times it the motion with the joints never sticks, at 0.999 times it does.
#[test]
fn a_joint_between_springs_is_one_spring() {
    let mut random = Random(750_117);
    for case in 0..12 {
        let mut draw = |low: f64, high: f64| low + (high - low) * random.next();
        let [k0, k1, k2, k3] = [(); 4].map(|()| draw(2.0, 9.0));
        let [m, n] = [draw(0.5, 2.0), draw(0.5, 2.0)];
        let damping = draw(0.05, 0.4);
        let (load, upper, lower) = (draw(4.0, 9.0), draw(-2.0, 2.0), draw(-2.0, 2.0));
        let frequency = draw(0.6, 3.0);
        let peak = if case % 3 == 0 { draw(1.0, 1.4) } else { 1.0 };
        // ground –k0– joint –k1– m –k2– joint –k3– n, and a damper between the masses and from m to the ground
        let jointed = |factor: f64| Model {
            mass: rows(&[0.0, 0.0, 0.0, 0.0, 0.0, m, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, n], 4),
            damping: rows(
                &[
                    0.0,
                    0.0,
                    0.0,
                    0.0, //
                    0.0,
                    2.0 * damping,
                    0.0,
                    -damping, //
                    0.0,
                    0.0,
                    0.0,
                    0.0, //
                    0.0,
                    -damping,
                    0.0,
                    damping,
                ],
                4,
            ),
            stiffness: rows(
                &[
                    k0 + k1,
                    -k1,
                    0.0,
                    0.0, //
                    -k1,
                    k1 + k2,
                    -k2,
                    0.0, //
                    0.0,
                    -k2,
                    k2 + k3,
                    -k3, //
                    0.0,
                    0.0,
                    -k3,
                    k3,
                ],
                4,
            ),
            harmonics: vec![Harmonic {
                frequency,
                sin: vec![lower * factor, 0.0, 0.0, load * factor],
                cos: vec![0.0, 0.0, upper * factor, 0.0],
            }],
            elements: vec![contact(vec![0.0, 1.0, 0.0, 0.0], 1.0, peak)],
            ..Model::default()
        };
        let (below, above) = (k0 * k1 / (k0 + k1), k2 * k3 / (k2 + k3));
        // A force on a joint acts on its neighbours in the ratio of the springs.
        let (down, up) = (k1 / (k0 + k1), [k2 / (k2 + k3), k3 / (k2 + k3)]);
        let by_hand = Model {
            mass: rows(&[m, 0.0, 0.0, n], 2),
            damping: rows(&[2.0 * damping, -damping, -damping, damping], 2),
            stiffness: rows(&[below + above, -above, -above, above], 2),
            harmonics: vec![Harmonic {
                frequency,
                sin: vec![lower * down, load],
                cos: vec![upper * up[0], upper * up[1]],
            }],
            elements: vec![contact(vec![1.0, 0.0], 1.0, peak)],
            ..Model::default()
        };
        let border = |model: &Model<f64>| System::new(model).unwrap().border().unwrap();
        let (ours, other) = (border(&jointed(1.0)), border(&by_hand));
        let near = |a: f64, b: f64| (a - b).abs() < 1e-10 * (1.0 + b.abs());
        assert!(near(ours.least_load_factor, other.least_load_factor), "{ours:?} {other:?}");
        assert!(near(ours.touching_time, other.touching_time), "{ours:?} {other:?}");
        let rests = |factor: f64| {
            let system = System::new(&jointed(ours.least_load_factor * factor)).unwrap();
            system.steady(&State::rest(4)).unwrap().motion.elements[0].time_at_rest
        };
        if peak == 1.0 {
            assert_eq!(rests(1.001), 0.0, "{ours:?}");
            assert!(rests(0.999) > 0.0, "{ours:?}");
        }
        let cycle = System::new(&jointed(1.5 * ours.least_load_factor)).unwrap().cycle().unwrap().unwrap();
        let followed =
            System::new(&jointed(1.5 * ours.least_load_factor)).unwrap().steady(&State::rest(4)).unwrap();
        let range = followed.motion.max_displacement[1] - followed.motion.min_displacement[1];
        assert!((2.0 * cycle.max_displacement - range).abs() < 1e-9 * range, "{cycle:?} {range}");
    }
}

/// Two masses with a Maxwell element between them, whose spring and damper meet in a joint that another spring ties to the ground. Its steps
/// are those of Runge and Kutta over the displacements and velocities of the masses and the displacement of the joint.
#[derive(Debug, Clone, Copy)]
struct Maxwell {
    mass: [f64; 2],
    /// From the ground to the first mass, from the first to the joint, from the joint to the ground, and from the first to the second.
    stiffness: [f64; 4],
    /// Of the first mass, and from the joint to the second one.
    damping: [f64; 2],
    peak: f64,
    /// On the second mass with the sine, and on the joint with the cosine.
    load: [f64; 2],
    frequency: f64,
}

impl Maxwell {
    fn model(&self, factor: f64) -> Model<f64> {
        let Self { mass: [m, n], stiffness: [ground, own, tie, between], damping: [c, d], .. } = *self;
        Model {
            mass: rows(&[m, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, n], 3),
            damping: rows(&[c, 0.0, 0.0, 0.0, d, -d, 0.0, -d, d], 3),
            stiffness: rows(
                &[ground + own + between, -own, -between, -own, own + tie, 0.0, -between, 0.0, between],
                3,
            ),
            harmonics: vec![Harmonic {
                frequency: self.frequency,
                sin: vec![0.0, 0.0, factor * self.load[0]],
                cos: vec![0.0, factor * self.load[1], 0.0],
            }],
            elements: vec![contact(vec![1.0, 0.0, 0.0], 1.0, self.peak)],
            ..Model::default()
        }
    }

    /// The rates, and the force on the first mass without its friction.
    fn rates(&self, t: f64, z: [f64; 5], factor: f64, friction: Option<f64>) -> ([f64; 5], f64) {
        let Self { mass: [m, n], stiffness: [ground, own, tie, between], damping: [c, d], load, .. } = *self;
        let [x, v, y, w, joint] = z;
        let (sin, cos) = (self.frequency * t).sin_cos();
        let slip = (factor * load[1] * cos - own * (joint - x) - tie * joint) / d;
        let force = -ground * x - own * (x - joint) - between * (x - y) - c * v;
        let push = factor * load[0] * sin - between * (y - x) + d * slip;
        ([v, friction.map_or(0.0, |friction| (force - friction) / m), w, push / n, w + slip], force)
    }

    fn step(&self, t: f64, h: f64, z: [f64; 5], factor: f64, friction: Option<f64>) -> [f64; 5] {
        let on = |z: [f64; 5], k: [f64; 5], h: f64| [0, 1, 2, 3, 4].map(|i| z[i] + h * k[i]);
        let rate = |t: f64, z: [f64; 5]| self.rates(t, z, factor, friction).0;
        let one = rate(t, z);
        let two = rate(t + h / 2.0, on(z, one, h / 2.0));
        let three = rate(t + h / 2.0, on(z, two, h / 2.0));
        let four = rate(t + h, on(z, three, h));
        [0, 1, 2, 3, 4].map(|i| z[i] + h / 6.0 * (one[i] + 2.0 * two[i] + 2.0 * three[i] + four[i]))
    }

    /// How often the first mass comes to rest in the last twenty periods at a part of the load, and its range then: the load falls to this part
    /// from twice as much, slowly, so that it does not rest before.
    fn long_run(&self, factor: f64) -> (usize, f64) {
        const STEPS: u32 = 800;
        let period = std::f64::consts::TAU / self.frequency;
        let h = period / f64::from(STEPS);
        let (mut z, mut slides, mut rests, mut range) =
            ([0.0, 1e-3, 0.0, 0.0, 0.0], true, 0, (0.0_f64, 0.0_f64));
        let (fall, turns) = (120, 260);
        for turn in 0..turns {
            let factor = factor * 2.0_f64.powf((1.0 - f64::from(turn) / f64::from(fall)).max(0.0));
            for i in 0..STEPS {
                let t = h * f64::from(turn * STEPS + i);
                if !slides {
                    let force = self.rates(t, z, factor, None).1;
                    slides = force.abs() > self.peak;
                    if slides {
                        z[1] = 1e-12 * force.signum();
                    }
                }
                if !slides {
                    z = self.step(t, h, z, factor, None);
                    continue;
                }
                let friction = z[1].signum();
                let next = self.step(t, h, z, factor, Some(friction));
                if next[1] * friction > 0.0 {
                    z = next;
                } else {
                    let (mut low, mut high) = (0.0, h);
                    for _ in 0..60 {
                        let middle = f64::midpoint(low, high);
                        let there = self.step(t, middle, z, factor, Some(friction));
                        if there[1] * friction > 0.0 { low = middle } else { high = middle }
                    }
                    z = self.step(t, high, z, factor, Some(friction));
                    z[1] = 0.0;
                    let force = self.rates(t + high, z, factor, None).1;
                    slides = force.abs() > self.peak;
                    rests += usize::from(!slides && turn + 20 >= turns);
                    let friction = slides.then(|| force.signum());
                    z = self.step(t + high, h - high, z, factor, friction);
                }
                if turn + 20 >= turns {
                    range = (range.0.min(z[0]), range.1.max(z[0]));
                }
            }
        }
        (rests, range.1 - range.0)
    }
}

/// A joint that a damper carries has a border, too: beside small steps, in which the first mass rests just below it and never just above.
#[test]
fn a_joint_at_a_damper_has_a_border() {
    let mut random = Random(751_129);
    let mut places = [0; 2];
    for case in 0..12 {
        let mut draw = |low: f64, high: f64| low + (high - low) * random.next();
        let machine = Maxwell {
            mass: [draw(0.5, 2.0), draw(0.5, 2.0)],
            stiffness: [
                draw(1.0, 5.0),
                draw(1.0, 8.0),
                if case % 2 == 0 { 0.0 } else { draw(0.5, 3.0) },
                draw(1.0, 5.0),
            ],
            damping: [draw(0.1, 0.4), draw(0.3, 2.0)],
            peak: if case % 3 == 0 { draw(1.0, 1.3) } else { 1.0 },
            load: [draw(3.0, 8.0), draw(-2.0, 2.0)],
            frequency: if case % 4 == 3 { draw(0.15, 0.35) } else { draw(0.5, 3.0) },
        };
        let ours = System::new(&machine.model(1.0)).unwrap().border().unwrap();
        // Under a static friction the cycle repels its neighbours close to the border, as friction that falls does.
        let above = if machine.peak > 1.0 { 0.02 } else { 2e-4 };
        let due = [1.0 - 2e-4, 1.0 + above].map(|part| machine.long_run(part * ours.least_load_factor).0 > 0);
        agreed("system border least_load_factor by system::System::border", [true, false], due, SmallSteps);
        places[usize::from(ours.touching_time > 0.0)] += 1;
        let factor = 1.5 * ours.least_load_factor;
        let cycle = System::new(&machine.model(factor)).unwrap().cycle().unwrap().unwrap();
        let (_, range) = machine.long_run(factor);
        // The greatest of the samples is below the peak by (ωh)²/8 of it at most.
        near(
            "system border cycle by system::System::cycle",
            2.0 * cycle.max_displacement,
            range,
            SmallSteps,
            1e-4,
        );
    }
    assert!(places.iter().all(|count| *count > 0), "{places:?}");
    // Without either of both a joint has none.
    let loose = Model {
        mass: rows(&[1.0, 0.0, 0.0, 0.0], 2),
        damping: rows(&[0.0; 4], 2),
        stiffness: rows(&[1.0, 0.0, 0.0, 0.0], 2),
        harmonics: vec![Harmonic { frequency: 1.3, sin: vec![3.0, 0.0], cos: vec![] }],
        elements: vec![contact(vec![1.0, 0.0], 1.0, 1.0)],
        ..Model::default()
    };
    let said = System::new(&loose).unwrap_err().to_string();
    assert!(said.contains("needs a spring, a damper or a contact that carries it"), "{said}");
}

/// Two modes that couple by the friction of a belt, as in a disc brake: with a joint in one of its springs they are those of the springs in
/// a row, growth and threshold alike.
#[test]
fn the_stability_of_sliding_with_a_joint() {
    let belt = |direction: Vec<f64>, normal: Vec<f64>, force: f64| Element {
        name: "belt".into(),
        direction,
        moves: Signal::constant(-3.0),
        kind: Kind::Contact {
            law: Law::constant(0.6),
            peak: 1.0,
            normal: Some(Normal { signal: Signal::constant(force), displacement: normal, velocity: vec![] }),
        },
    };
    let (first, second, coupling, contact) = (11.0, 20.0, 4.0, 6.0);
    let one = Model {
        mass: rows(&[1.0, 0.0, 0.0, 1.0], 2),
        damping: rows(&[0.02, 0.0, 0.0, 0.01], 2),
        stiffness: rows(&[first + coupling, -coupling, -coupling, second + coupling + contact], 2),
        elements: vec![belt(vec![1.0, 0.0], vec![0.0, contact], 5.0)],
        ..Model::default()
    };
    // The coupling as two springs of twice its stiffness with a joint between them.
    let twice = 2.0 * coupling;
    let jointed = Model {
        mass: rows(&[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0], 3),
        damping: rows(&[0.02, 0.0, 0.0, 0.0, 0.01, 0.0, 0.0, 0.0, 0.0], 3),
        stiffness: rows(
            &[first + twice, 0.0, -twice, 0.0, second + twice + contact, -twice, -twice, -twice, 2.0 * twice],
            3,
        ),
        elements: vec![belt(vec![1.0, 0.0, 0.0], vec![0.0, contact, 0.0], 5.0)],
        ..Model::default()
    };
    let of = |model: &Model<f64>| System::new(model).unwrap().sliding().expect("a belt");
    let (ours, other) = (of(&jointed), of(&one));
    let near = |a: f64, b: f64| (a - b).abs() < 1e-7 * (1.0 + b.abs());
    assert!(near(ours.growth, other.growth) && near(ours.frequency, other.frequency), "{ours:?} {other:?}");
    let (a, b) = (ours.threshold.expect("flutter"), other.threshold.expect("flutter"));
    assert!(near(a.factor, b.factor) && near(a.frequency, b.frequency) && a.frequency > 0.0, "{a:?} {b:?}");
    // A damper at the joint has no such answer.
    let mut damped = jointed;
    damped.damping[2][2] = 0.1;
    assert!(System::new(&damped).unwrap().sliding().is_none());
}

/// Friction elements in series under a mass: for a way of the mass, of the two that give way the one at the lower force.
#[derive(Clone, Copy)]
struct Series {
    stiffness: [f64; 2],
    friction: [f64; 2],
    way: [f64; 2],
}

impl Series {
    /// The forces at which the elements give way in a direction.
    fn bounds(&self, sign: f64) -> [f64; 2] {
        [0, 1].map(|i| self.stiffness[i] * self.way[i] + sign * self.friction[i])
    }

    /// After a way of the mass, and the force then.
    fn after(mut self, way: f64) -> (Self, f64) {
        let sign = way.signum();
        let mut left = way.abs();
        let [a, b] = self.bounds(sign).map(|force| sign * force);
        let weak = usize::from(a > b);
        let alone = ((a - b).abs() / self.stiffness[weak]).min(left);
        self.way[weak] += sign * alone;
        left -= alone;
        let sum = self.stiffness[0] + self.stiffness[1];
        for i in [0, 1] {
            self.way[i] += sign * left * self.stiffness[1 - i] / sum;
        }
        let bounds = self.bounds(sign).map(|force| sign * force);
        (self, sign * bounds[0].min(bounds[1]))
    }
}

/// A mass on two bearings in series, whose joint has no mass, on a base under a record: beside steps of 10⁻⁵, in which the force is that of
/// the way alone. A reversal is up to a step late, so that velocities are off by some accelerations, up to 5, times it.
#[test]
fn a_mass_on_joints_under_a_record() {
    let (mass, stiffness, friction) = (1.5, [7.0, 12.0], [1.1, 2.3]);
    let times: Vec<f64> = (0..=12).map(|i| 0.4 * f64::from(i)).collect();
    let values = vec![0.0, 3.0, -4.0, 2.0, 5.0, -3.0, -4.0, 4.0, 1.0, -5.0, 3.0, 1.0, 0.0];
    let joint = |name: &str, direction: Vec<f64>, force: f64| Element {
        name: name.into(),
        ..contact(direction, force, 1.0)
    };
    let model = Model {
        mass: rows(&[0.0, 0.0, 0.0, mass], 2),
        damping: rows(&[0.0; 4], 2),
        stiffness: rows(&[stiffness[0] + stiffness[1], -stiffness[1], -stiffness[1], stiffness[1]], 2),
        elements: vec![
            joint("lower", vec![1.0, 0.0], friction[0]),
            joint("upper", vec![-1.0, 1.0], friction[1]),
        ],
        records: vec![Record {
            times: times.clone(),
            values: values.clone(),
            force: vec![0.0, -mass],
            beyond: Beyond::Zero,
        }],
        ..Model::default()
    };
    let asked: Vec<f64> = (1..=24).map(|i| 0.2 * f64::from(i)).collect();
    let ours = System::new(&model).unwrap().states(&State::rest(2), &asked).unwrap();
    let acceleration = |t: f64| {
        let i = ((t / 0.4) as usize).min(11);
        values[i] + (values[i + 1] - values[i]) * (t - times[i]) / 0.4
    };
    let (mut series, mut x, mut v, mut t) = (Series { stiffness, friction, way: [0.0; 2] }, 0.0, 0.0, 0.0);
    let (steps, mut slid, mut rested) = (20_000, 0, 0);
    for (state, until) in ours.iter().zip(&asked) {
        let h = (until - t) / f64::from(steps);
        for step in 0..steps {
            let now = t + h * f64::from(step);
            let push = -mass * acceleration(now + h / 2.0);
            let (low, high) = {
                let ([a, b], [c, d]) = (series.bounds(-1.0), series.bounds(1.0));
                (a.max(b), c.min(d))
            };
            if v == 0.0 && (low..=high).contains(&push) {
                rested += 1;
                continue;
            }
            let direction = if v == 0.0 { if push > high { 1.0 } else { -1.0 } } else { f64::signum(v) };
            let rate = |at: f64, way: f64, v: f64| {
                let tension = series.after(direction * (direction * way).max(1e-300)).1;
                (v, -acceleration(at.min(4.8 - 1e-12)) - tension / mass)
            };
            let one = rate(now, 0.0, v);
            let two = rate(now + h / 2.0, h / 2.0 * one.0, v + h / 2.0 * one.1);
            let three = rate(now + h / 2.0, h / 2.0 * two.0, v + h / 2.0 * two.1);
            let four = rate(now + h, h * three.0, v + h * three.1);
            let way = h / 6.0 * (one.0 + 2.0 * two.0 + 2.0 * three.0 + four.0);
            let gain = h / 6.0 * (one.1 + 2.0 * two.1 + 2.0 * three.1 + four.1);
            if direction * (v + gain) <= 0.0 {
                // It comes to rest within the step: the way of a constant deceleration.
                let way = if gain == 0.0 { 0.0 } else { -v * v / (2.0 * gain / h) };
                if way != 0.0 {
                    series = series.after(way).0;
                }
                (x, v) = (x + way, 0.0);
            } else {
                series = series.after(way).0;
                (x, v) = (x + way, v + gain);
                slid += 1;
            }
        }
        t = *until;
        let due = [series.way[0], x, v];
        let found = [state.displacement[0], state.displacement[1], state.velocity[1]];
        for (a, b) in found.iter().zip(due) {
            assert!((a - b).abs() < 2e-4, "{until}: {found:?} {due:?}");
        }
    }
    assert!(slid > 100_000 && rested > 5000, "{slid} {rested}");
}

/// What has no answer says what to write instead.
#[test]
fn what_joints_do_not_have_is_refused() {
    let row = |direction: Vec<f64>| Model {
        mass: rows(&[0.0, 0.0, 0.0, 1.0], 2),
        damping: rows(&[0.0; 4], 2),
        stiffness: rows(&[5.0, -2.0, -2.0, 2.0], 2),
        harmonics: vec![Harmonic { frequency: 1.0, sin: vec![0.0, 3.0], cos: vec![] }],
        elements: vec![contact(direction, 1.0, 1.0)],
        coordinates: vec!["joint".into(), "box".into()],
        ..Model::default()
    };
    let said =
        |model: &Model<f64>| System::new(model).and_then(|system| system.border()).unwrap_err().to_string();
    let at_joint = said(&row(vec![1.0, 0.0]));
    assert!(at_joint.starts_with("joint, which has no mass, must not be at the contact"), "{at_joint}");
    // A stop that gives no way beside a joint.
    let mut stopped = row(vec![0.0, 1.0]);
    stopped.elements.push(Element {
        name: "wall".into(),
        direction: vec![0.0, 1.0],
        moves: Signal::constant(0.0),
        kind: Kind::HardStop { gap: 0.5, restitution: 0.4 },
    });
    let hard = System::new(&stopped).unwrap_err().to_string();
    assert!(
        hard.starts_with("wall must have a stiffness in place of a restitution beside a body without mass"),
        "{hard}"
    );
    if let Some(wall) = stopped.elements.last_mut() {
        wall.kind = Kind::Stop { gap: 0.5, stiffness: 1e4, damping: 0.0 };
    }
    assert!(System::new(&stopped).is_ok());
}
