//! Coordinates without mass: the triple friction pendulum stage by stage, small steps of a program of their own, small masses, and what is refused.

#![allow(clippy::print_stdout, reason = "the counts of a campaign are shown with --nocapture")]

use crate::closed_form::contact;
use crate::count;
use crate::generator::Random;
use stickslip::system::{
    Base, Element, EventKind, Harmonic, Kind, Law, Model, Motion, Moved, MovedBy, Signal, State, System,
};

/// A chain from the ground: the stiffness and the damping of each link, and what stands in it.
fn chain(mass: &[f64], links: &[(f64, f64)]) -> Model<f64> {
    let n = mass.len();
    let mut model = Model {
        mass: (0..n).map(|i| (0..n).map(|j| if i == j { mass[i] } else { 0.0 }).collect()).collect(),
        damping: vec![vec![0.0; n]; n],
        stiffness: vec![vec![0.0; n]; n],
        ..Model::default()
    };
    for (i, &(k, c)) in links.iter().enumerate() {
        for (matrix, x) in [(&mut model.stiffness, k), (&mut model.damping, c)] {
            matrix[i][i] += x;
            if i > 0 {
                matrix[i - 1][i - 1] += x;
                matrix[i][i - 1] -= x;
                matrix[i - 1][i] -= x;
            }
        }
    }
    model
}

/// The direction of the link that ends at a body.
fn link(n: usize, end: usize) -> Vec<f64> {
    (0..n)
        .map(|i| {
            if i == end {
                1.0
            } else if i + 1 == end {
                -1.0
            } else {
                0.0
            }
        })
        .collect()
}

fn element(n: usize, end: usize, kind: Kind<f64>) -> Element<f64> {
    Element { name: format!("link {end}"), direction: link(n, end), moves: Signal::constant(0.0), kind }
}

fn friction(force: f64) -> Kind<f64> {
    Kind::Contact { law: Law::constant(force), peak: 1.0, normal: None }
}

/// A triple friction pendulum after Fenz and Constantinou (2008): effective radii R₁ = R₄, R₂ = R₃, frictions µ₂ = µ₃ < µ₁ < µ₄, weight W, and
/// the displacements d of the outer surfaces at their restrainers. As three elements in series it has the radii R₁ − R₂, R₂ + R₃,
/// R₄ − R₃ and joints without mass between them.
struct Pendulum {
    weight: f64,
    outer: f64,
    inner: f64,
    friction: [f64; 3],
    capacity: f64,
}

const BEARING: Pendulum =
    Pendulum { weight: 1000.0, outer: 0.435, inner: 0.053, friction: [0.012, 0.02, 0.075], capacity: 0.064 };

impl Pendulum {
    /// The chain lower joint, upper joint, plate.
    fn model(&self, plate: f64, joint: f64, restrainer: Option<f64>) -> Model<f64> {
        let Self { weight, outer, inner, friction: [slow, first, last], capacity } = *self;
        let radii = [outer - inner, 2.0 * inner, outer - inner];
        let links: Vec<(f64, f64)> =
            radii.iter().map(|r| (weight / r, 2.0 * 0.3 * (joint * weight / r).sqrt())).collect();
        let mut model = chain(&[joint, joint, plate], &links);
        for (end, coefficient) in [first, slow, last].into_iter().enumerate() {
            model.elements.push(element(3, end, friction(coefficient * weight)));
        }
        if let Some(stiffness) = restrainer {
            let gap = (outer - inner) / outer * capacity;
            for end in [0, 2] {
                for side in [1.0, -1.0] {
                    let mut stop = element(3, end, Kind::Stop { gap, stiffness, damping: 0.0 });
                    stop.direction.iter_mut().for_each(|b| *b *= side);
                    model.elements.push(stop);
                }
            }
        }
        model
    }

    /// The force over the displacement as published: stages I to III, and on unloading from `turn` the same with twice the steps.
    fn force(&self, u: f64, turn: Option<(f64, f64)>) -> f64 {
        let Self { weight, outer, inner, friction: [slow, first, last], .. } = *self;
        // The displacements at which the stages II and III begin, and W over the sums of effective radii.
        let second = 2.0 * (first - slow) * inner;
        let third = second + (last - first) * (outer + inner);
        let stiffness = [weight / (2.0 * inner), weight / (outer + inner), weight / (2.0 * outer)];
        let (from, sign, factor) = match turn {
            None => ((0.0, slow * weight), 1.0, 1.0),
            Some((u, force)) => ((u, force - 2.0 * slow * weight), -1.0, 2.0),
        };
        let way = sign * (u - from.0);
        let stages = [
            way.min(factor * second),
            (way.min(factor * third) - factor * second).max(0.0),
            (way - factor * third).max(0.0),
        ];
        from.1 + sign * stages.iter().zip(stiffness).map(|(u, k)| u * k).sum::<f64>()
    }
}

/// The plate moved by a sine: its force is that of the published stages, in the first loading and around the whole loop.
#[test]
fn the_triple_pendulum_has_its_published_stages() {
    let (amplitude, omega) = (0.06, 0.7);
    let mut model = BEARING.model(0.0, 0.0, None);
    model.harmonics.push(Harmonic { frequency: omega, sin: vec![], cos: vec![] });
    let signal = Signal { sin: vec![amplitude], ..Signal::constant(0.0) };
    model.moved.push(Moved { coordinate: 2, by: MovedBy::Displacement, signal });
    let system = System::new(&model).expect("valid");
    let quarter = std::f64::consts::FRAC_PI_2 / omega;
    let times: Vec<f64> = (1..=2999).map(|i| 4.0 * quarter * i as f64 / 1000.0 / 1.0001).collect();
    let states = system.states(&State::rest(3), &times).expect("followed");
    let peak = BEARING.force(amplitude, None);
    let mut stages = [0; 3];
    for (state, time) in states.iter().zip(&times) {
        let u = amplitude * (omega * time).sin();
        // The link below the plate carries all of its force.
        let link = BEARING.weight / (BEARING.outer - BEARING.inner);
        let ours = state.force[2] + link * (state.displacement[2] - state.displacement[1]);
        let half = ((time / quarter + 1.0) / 2.0).floor() as i32;
        let due = match half {
            0 => BEARING.force(u, None),
            half if half % 2 == 1 => BEARING.force(u, Some((amplitude, peak))),
            _ => -BEARING.force(-u, Some((amplitude, peak))),
        };
        assert!((ours - due).abs() < 1e-9, "{time}: {ours} {due}");
        let moving = (0..3).filter(|&i| {
            let before = if i == 0 { 0.0 } else { state.velocity[i - 1] };
            (state.velocity[i] - before).abs() > 1e-12
        });
        stages[moving.count() - 1] += 1;
    }
    assert!(stages.iter().all(|&count| count > 100), "{stages:?}");
    // Energy: the loop's area is 4 Σ of the frictions over their ways, and what the frictions take.
    let motion = system.steady(&State::rest(3)).expect("steady").motion;
    let area: f64 = loop_area(amplitude, peak);
    let taken: f64 = motion.elements.iter().map(|e| e.work).sum();
    assert!(
        (motion.load_work - area).abs() < 1e-9 && (taken - area).abs() < 1e-9,
        "{area} {}",
        motion.load_work
    );
}

/// The area of the loop between ±amplitude, by the corners of its straight lines.
fn loop_area(amplitude: f64, peak: f64) -> f64 {
    let steps = 1_000_000;
    let width = 2.0 * amplitude / steps as f64;
    let height = |i: i32| {
        let u = amplitude - (f64::from(i) + 0.5) * width;
        let down = BEARING.force(u, Some((amplitude, peak)));
        let up = -BEARING.force(-u, Some((amplitude, peak)));
        (up - down) * width
    };
    (0..steps).map(height).sum()
}

/// With restrainers the first, then the last outer surface comes to its end: stages IV and V at the published displacements and stiffnesses, as far as
/// a restrainer of a finite stiffness gives way.
#[test]
fn the_triple_pendulum_stiffens_at_its_restrainers() {
    let (amplitude, omega, stop) = (0.17, 0.5, 1e9);
    let mut model = BEARING.model(0.0, 0.0, Some(stop));
    model.harmonics.push(Harmonic { frequency: omega, sin: vec![], cos: vec![] });
    let signal = Signal { sin: vec![amplitude], ..Signal::constant(0.0) };
    model.moved.push(Moved { coordinate: 2, by: MovedBy::Displacement, signal });
    let system = System::new(&model).expect("valid");
    let Pendulum { weight, outer, inner, friction: [slow, first, last], capacity } = BEARING;
    let third = 2.0 * (first - slow) * inner + (last - first) * (outer + inner);
    let fourth = third + 2.0 * capacity - (last - first) * 2.0 * outer;
    let fifth = fourth + (last - first) * (outer + inner);
    let motion = system.simulate(&State::rest(3), 1.5 / omega).expect("followed");
    let closes: Vec<f64> = motion
        .events
        .iter()
        .filter(|e| e.kind == EventKind::Close)
        .map(|e| amplitude * (omega * e.time).sin())
        .collect();
    assert!(
        matches!(closes.as_slice(), [a, b] if (a - fourth).abs() < 1e-9 && (b - fifth).abs() < 1e-7),
        "{closes:?} {fourth} {fifth}"
    );
    let force = |u: f64| {
        let time = (u / amplitude).asin() / omega;
        let state = &system.states(&State::rest(3), &[time]).expect("followed")[0];
        state.force[1] + weight / (2.0 * inner) * (state.displacement[1] - state.displacement[0])
    };
    for (from, to, radius) in
        [(third, fourth, 2.0 * outer), (fourth, fifth, inner + outer), (fifth, amplitude, 2.0 * inner)]
    {
        let (a, b) = (from + 0.2 * (to - from), from + 0.8 * (to - from));
        let stiffness = (force(b) - force(a)) / (b - a);
        assert!((stiffness / (weight / radius) - 1.0).abs() < 1e-4, "{radius}: {stiffness}");
    }
}

/// Under a mass on a shaken base the motion with joints of a small mass goes to that without: with √m, as dampers of the joints do.
#[test]
fn small_masses_approach_none() {
    let shaken = |joint: f64| -> Motion<f64> {
        let mut model = BEARING.model(102.0, joint, None);
        let force = (0..3).map(|i| if i == 2 { -2.45 * 102.0 } else { 0.0 }).collect();
        model.harmonics.push(Harmonic { frequency: 2.513, sin: force, cos: vec![] });
        let acceleration = Signal { sin: vec![2.45], ..Signal::constant(0.0) };
        let base = Base { influence: vec![1.0; 3], acceleration };
        let system = System::new(&model).expect("valid").with_base(&base).expect("valid");
        system.simulate(&State::rest(3), 3.0).expect("followed")
    };
    let exact = shaken(0.0);
    let far = |joint: f64| {
        let motion = shaken(joint);
        (0..3).map(|i| (motion.end.displacement[i] - exact.end.displacement[i]).abs()).fold(0.0, f64::max)
    };
    let (coarse, fine) = (far(1e-2), far(1e-4));
    assert!(exact.events.len() > 8 && coarse < 1e-2, "{coarse}");
    assert!(fine < coarse / 8.0 && fine > coarse / 12.5, "{coarse} {fine}");
    let balance = exact.load_work
        - exact.damper_work
        - exact.stored
        - exact.elements.iter().map(|e| e.work).sum::<f64>();
    assert!(balance.abs() < 1e-10 * exact.load_work, "{balance}");
}

/// A random chain with a body without mass in it, and its loads.
fn random_chain(random: &mut Random) -> Model<f64> {
    let n = 2 + random.below(3) as usize;
    let mut mass: Vec<f64> =
        (0..n).map(|_| if random.next() < 0.5 { 0.0 } else { random.between(0.5, 2.0) }).collect();
    let light = random.below(n as u64) as usize;
    mass[light] = 0.0;
    let links: Vec<(f64, f64)> = (0..n)
        .map(|i| {
            let is_heavy = mass[i] > 0.0 && (i == 0 || mass[i - 1] > 0.0);
            let damped = random.next() < if is_heavy { 0.7 } else { 0.2 };
            (random.between(1.0, 5.0), if damped { random.between(0.1, 0.6) } else { 0.0 })
        })
        .collect();
    let mut model = chain(&mass, &links);
    for end in 0..n {
        let kind = match random.below(5) {
            0 | 1 => friction(random.between(0.1, 0.8)),
            2 => Kind::Elastic {
                stiffness: random.between(1.0, 6.0),
                friction: random.between(0.1, 0.8),
                normal: None,
            },
            3 => Kind::Stop {
                gap: random.between(0.05, 0.4),
                stiffness: random.between(2.0, 20.0),
                damping: 0.0,
            },
            _ => continue,
        };
        model.elements.push(element(n, end, kind));
    }
    for frequency in [0.7, 1.3] {
        let sin = (0..n).map(|_| if random.next() < 0.6 { random.between(-2.0, 2.0) } else { 0.0 }).collect();
        model.harmonics.push(Harmonic { frequency: frequency * random.between(0.8, 1.2), sin, cos: vec![] });
    }
    if random.next() < 0.3 && light + 1 < n {
        let signal = Signal { sin: vec![random.between(0.2, 1.0)], ..Signal::constant(0.0) };
        model.moved.push(Moved { coordinate: n - 1, by: MovedBy::Displacement, signal });
    }
    model
}

/// The solution of a small system, by elimination.
fn solved(mut a: Vec<Vec<f64>>, mut y: Vec<f64>) -> Vec<f64> {
    let n = y.len();
    for i in 0..n {
        let pivot = (i..n).max_by(|&j, &k| a[j][i].abs().total_cmp(&a[k][i].abs())).unwrap();
        a.swap(i, pivot);
        y.swap(i, pivot);
        for j in i + 1..n {
            let by = a[j][i] / a[i][i];
            let row = a[i].clone();
            a[j].iter_mut().zip(&row).skip(i).for_each(|(x, y)| *x -= by * y);
            y[j] -= by * y[i];
        }
    }
    for i in (0..n).rev() {
        y[i] = (y[i] - (i + 1..n).map(|j| a[i][j] * y[j]).sum::<f64>()) / a[i][i];
    }
    y
}

/// Forces T in boxes with `s = a − G T` that is 0 inside and outward at a bound, by trying all cases; the last one first.
fn boxed(g: &[Vec<f64>], a: &[f64], bounds: &[[f64; 2]], last: &mut Vec<usize>) -> Vec<f64> {
    let count = a.len();
    let tried = |case: &[usize]| -> Option<Vec<f64>> {
        let mut force: Vec<f64> =
            (0..count).map(|e| if case[e] == 2 { 0.0 } else { bounds[e][case[e]] }).collect();
        if force.iter().any(|x| x.is_infinite()) {
            return None;
        }
        let free: Vec<usize> = (0..count).filter(|&e| case[e] == 2).collect();
        let right = |e: usize| a[e] - (0..count).map(|k| g[e][k] * force[k]).sum::<f64>();
        let inner = free.iter().map(|&e| free.iter().map(|&k| g[e][k]).collect()).collect();
        let found = solved(inner, free.iter().map(|&e| right(e)).collect());
        free.iter().zip(found).for_each(|(&e, x)| force[e] = x);
        let holds = |e: usize| {
            let slip = a[e] - (0..count).map(|k| g[e][k] * force[k]).sum::<f64>();
            match case[e] {
                2 => force[e] >= bounds[e][0] - 1e-12 && force[e] <= bounds[e][1] + 1e-12,
                side => {
                    if side == 1 {
                        slip >= -1e-12
                    } else {
                        slip <= 1e-12
                    }
                }
            }
        };
        (0..count).all(holds).then_some(force)
    };
    if last.len() == count
        && let Some(found) = tried(last)
    {
        return found;
    }
    for number in 0..3_usize.pow(count as u32) {
        let case: Vec<usize> = (0..count).map(|e| number / 3_usize.pow(e as u32) % 3).collect();
        if let Some(found) = tried(&case) {
            *last = case;
            return found;
        }
    }
    panic!("no case holds")
}

/// The displacements at the end by implicit steps: M (v − v₀)/h + C v + K (q₀ + h v) = f − B T with each T in its box.
fn by_steps(model: &Model<f64>, until: f64, steps: usize) -> Vec<f64> {
    let (n, h, parts) = (model.mass.len(), until / steps as f64, &model.elements);
    let (mut q, mut v, mut tension) = (vec![0.0; n], vec![0.0; n], vec![0.0; parts.len()]);
    let moved = model.moved.first().map(|m| (m.coordinate, m.signal.sin[0], model.harmonics[0].frequency));
    let is_moved = |i: usize| moved.is_some_and(|(coordinate, ..)| coordinate == i);
    let full = |i: usize, j: usize| model.mass[i][j] / h + model.damping[i][j] + h * model.stiffness[i][j];
    let matrix: Vec<Vec<f64>> = (0..n)
        .map(|i| {
            let entry =
                |j: usize| if is_moved(i) || is_moved(j) { f64::from(u8::from(i == j)) } else { full(i, j) };
            (0..n).map(entry).collect()
        })
        .collect();
    let acts = |e: usize| -> Vec<f64> {
        let own = parts[e].direction.iter().enumerate();
        own.map(|(i, &b)| if is_moved(i) { 0.0 } else { b }).collect()
    };
    let along = |b: &[f64], x: &[f64]| b.iter().zip(x).map(|(b, x)| b * x).sum::<f64>();
    let compliance = |e: usize| match parts[e].kind {
        Kind::Elastic { stiffness, .. } | Kind::Stop { stiffness, .. } => 1.0 / (h * stiffness),
        Kind::Contact { .. } => 0.0,
        ref other => panic!("{other:?} is not drawn"),
    };
    let answers: Vec<Vec<f64>> = (0..parts.len()).map(|e| solved(matrix.clone(), acts(e))).collect();
    let g: Vec<Vec<f64>> = (0..parts.len())
        .map(|e| {
            (0..parts.len())
                .map(|k| along(&acts(e), &answers[k]) + if e == k { compliance(e) } else { 0.0 })
                .collect()
        })
        .collect();
    let bounds: Vec<[f64; 2]> = parts
        .iter()
        .map(|part| match part.kind {
            Kind::Contact { ref law, .. } => [-law.points[0].1, law.points[0].1],
            Kind::Elastic { friction, .. } => [-friction, friction],
            Kind::Stop { .. } => [0.0, f64::INFINITY],
            ref other => panic!("{other:?} is not drawn"),
        })
        .collect();
    let mut case = Vec::new();
    for step in 1..=steps {
        let time = h * step as f64;
        let known =
            moved.map(|(i, by, omega)| (i, by * ((omega * time).sin() - (omega * (time - h)).sin()) / h));
        let mut right = vec![0.0; n];
        for (i, right) in right.iter_mut().enumerate() {
            *right = (0..n).map(|j| model.mass[i][j] * v[j] / h - model.stiffness[i][j] * q[j]).sum::<f64>()
                + model.harmonics.iter().map(|w| w.sin[i] * (w.frequency * time).sin()).sum::<f64>();
            if let Some((place, speed)) = known {
                *right = if place == i { speed } else { *right - full(i, place) * speed };
            }
        }
        let free = solved(matrix.clone(), right);
        let way: Vec<f64> = (0..parts.len())
            .map(|e| {
                along(&parts[e].direction, &free)
                    + match parts[e].kind {
                        Kind::Contact { .. } => 0.0,
                        Kind::Elastic { .. } => tension[e] * compliance(e),
                        Kind::Stop { gap, .. } => (along(&parts[e].direction, &q) - gap) / h,
                        ref other => panic!("{other:?} is not drawn"),
                    }
            })
            .collect();
        tension = boxed(&g, &way, &bounds, &mut case);
        v = (0..n)
            .map(|i| free[i] - answers.iter().zip(&tension).map(|(a, t)| a[i] * t).sum::<f64>())
            .collect();
        q.iter_mut().zip(&v).for_each(|(q, v)| *q += h * v);
    }
    q
}

/// Random chains with bodies without mass beside implicit steps, whose error falls with the step.
#[test]
fn random_chains_are_those_of_small_steps() {
    let mut random = Random(75);
    let (mut events, mut worst) = ([0; 8], 0.0_f64);
    for number in 0..count(12, 500) {
        let model = random_chain(&mut random);
        let until = 9.0;
        let system = System::new(&model).unwrap_or_else(|e| panic!("{number}: {e}\n{model:?}"));
        let motion = system
            .simulate(&State::rest(model.mass.len()), until)
            .unwrap_or_else(|e| panic!("{number}: {e}\n{model:?}"));
        for event in &motion.events {
            events[event.kind as usize % 8] += 1;
        }
        let (coarse, fine) = (by_steps(&model, until, 20_000), by_steps(&model, until, 40_000));
        for (i, (&a, &b)) in coarse.iter().zip(&fine).enumerate() {
            // The error of a step is one of the first order: half of it is left, and twice the step shows it.
            let (ours, best, apart) = (motion.end.displacement[i], 2.0 * b - a, (b - a).abs());
            worst = worst.max((ours - best).abs() / (1e-4 + apart));
            assert!((ours - best).abs() < 1e-4 + apart, "{number}: {ours} {best} {apart}\n{model:?}");
            assert!(apart < 0.02, "{number}: {apart}\n{model:?}");
        }
        let work: f64 = motion.elements.iter().map(|e| e.work).sum();
        let left = motion.load_work - motion.damper_work - motion.stored - work;
        let pressed =
            model.elements.iter().any(|e| matches!(e.kind, Kind::Stop { .. } | Kind::Elastic { .. }));
        assert!(
            pressed || left.abs() < 1e-10 * (1.0 + motion.load_work.abs()),
            "{number}: {left}\n{model:?}"
        );
    }
    println!("{events:?} events by their kinds, the ends by {worst:.2} of the bound at most");
    assert!(events.iter().take(2).all(|&count| count > 5), "{events:?}");
}

/// A joint of two contacts without a spring: the weaker one slides, as if the other were glued. A spring in series with a damper
/// is Maxwell's element.
#[test]
fn joints_without_springs() {
    let load = Harmonic { frequency: 1.0, sin: vec![0.0, 8.0], cos: vec![] };
    let mut model = chain(&[0.0, 1.0], &[(0.0, 0.0), (0.0, 0.0)]);
    model.stiffness[1][1] = 10.0;
    model.elements = vec![element(2, 0, friction(3.0)), element(2, 1, friction(2.0))];
    model.harmonics.push(load);
    let ours = System::new(&model).expect("valid").simulate(&State::rest(2), 30.0).expect("followed");
    let glued = Model {
        mass: vec![vec![1.0]],
        damping: vec![vec![0.0]],
        stiffness: vec![vec![10.0]],
        elements: vec![contact(vec![1.0], 2.0, 1.0)],
        harmonics: vec![Harmonic { frequency: 1.0, sin: vec![8.0], cos: vec![] }],
        ..Model::default()
    };
    let due = System::new(&glued).expect("valid").simulate(&State::rest(1), 30.0).expect("followed");
    assert_eq!(ours.events.len(), due.events.len());
    assert!(
        (ours.end.displacement[1] - due.end.displacement[0]).abs() < 1e-12 && ours.end.displacement[0] == 0.0
    );
    // x″ = −20 x − F, F′ = 10 (x′ − F/3).
    let maxwell = chain(&[0.0, 1.0], &[(10.0, 0.0), (0.0, 3.0)]);
    let mut maxwell = Model { ..maxwell };
    maxwell.stiffness[1][1] = 20.0;
    let start = State { displacement: vec![0.0, 1.0], ..State::rest(2) };
    let end = System::new(&maxwell).expect("valid").simulate(&start, 2.0).expect("followed").end;
    let (mut z, steps) = ([1.0, 0.0, 0.0], 20_000);
    let rate = |[x, v, f]: [f64; 3]| [v, -20.0 * x - f, 10.0 * (v - f / 3.0)];
    let h = 2.0 / f64::from(steps);
    for _ in 0..steps {
        let at = |k: [f64; 3], by: f64| [z[0] + by * k[0], z[1] + by * k[1], z[2] + by * k[2]];
        let a = rate(z);
        let b = rate(at(a, h / 2.0));
        let c = rate(at(b, h / 2.0));
        let d = rate(at(c, h));
        for i in 0..3 {
            z[i] += h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
        }
    }
    assert!((end.displacement[1] - z[0]).abs() < 1e-10, "{} {}", end.displacement[1], z[0]);
    assert!((10.0 * end.displacement[0] - z[2]).abs() < 1e-10, "{} {}", end.displacement[0], z[2]);
}

/// What has no answer is named.
#[test]
fn what_has_no_answer_is_named() {
    let refused = |model: &Model<f64>| System::new(model).map(|_| ()).unwrap_err().to_string();
    let model = || chain(&[0.0, 1.0], &[(3.0, 0.0), (2.0, 0.0)]);
    let with = |kind: Kind<f64>| Model { elements: vec![element(2, 0, kind)], ..model() };
    let falling = Kind::Contact { law: Law::constant(1.0), peak: 1.2, normal: None };
    assert!(refused(&with(falling)).contains("link 0 must have no static friction"));
    let law = Law { points: vec![(0.0, 1.0), (1.0, 0.5)] };
    assert!(
        refused(&with(Kind::Contact { law, peak: 1.0, normal: None }))
            .contains("one friction at every speed")
    );
    assert!(refused(&with(Kind::Stop { gap: 1.0, stiffness: 1.0, damping: 1.0 })).contains("no damping"));
    let mut alone = chain(&[0.0, 1.0], &[(0.0, 0.0), (0.0, 0.0)]);
    alone.coordinates = vec!["joint".into(), "box".into()];
    assert!(refused(&alone).starts_with("joint, which has no mass, needs a spring"));
    // Both slide: the joint would be free.
    alone.elements = vec![element(2, 0, Kind::Elastic { stiffness: 1.0, friction: 2.0, normal: None })];
    alone.harmonics.push(Harmonic { frequency: 1.0, sin: vec![3.0, 0.0], cos: vec![] });
    let free = System::new(&alone).expect("valid").simulate(&State::rest(2), 3.0).unwrap_err().to_string();
    assert!(free.starts_with("joint, which has no mass, is held neither"), "{free}");
}
