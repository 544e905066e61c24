//! Friction under the force, and the blows, of a stop with a restitution.

use super::small_steps::{Machine, Rub, Wall};
use super::{Judged, Random, at, beside, element, energy, of, rub, stop};
use stickslip::system::{Element, EventKind, Harmonic, Kind, Model, State, SteadyKind, System};

fn under(direction: Vec<f64>, stop: usize, coefficient: f64, peak: f64) -> Element<f64> {
    element("rub", direction, Kind::UnderStop { stop, coefficient, peak })
}

/// Along the floor and up.
fn block(mass: f64, elements: Vec<Element<f64>>) -> Model<f64> {
    Model {
        mass: vec![vec![mass, 0.0], vec![0.0, mass]],
        damping: vec![vec![0.0; 2]; 2],
        stiffness: vec![vec![0.0; 2]; 2],
        constant: vec![0.0, -mass * 9.81],
        elements,
        ..Model::default()
    }
}

/// A block falls from h and moves along the floor with u. Each blow takes µ (1 + e) v from u, and at the end of the blows the impulse of the floor is
/// that of the weight: the speed is then u − µ g t, as if the block had been in touch all the time. It stops at u/(µ g), or in a blow before.
#[test]
fn a_block_thrown_along_the_floor_slows_down_with_the_blows() {
    let (g, h, m) = (9.81_f64, 0.3, 1.7);
    let v = (2.0 * g * h).sqrt();
    for (e, mu, u) in [(0.5_f64, 0.2, 3.0), (0.3, 0.6, 4.0), (0.0, 0.4, 2.0), (0.8, 0.15, 6.0)] {
        let elements = vec![stop(vec![0.0, -1.0], 0.0, e), under(vec![1.0, 0.0], 0, mu, 1.3)];
        let start = State { displacement: vec![0.0, h], velocity: vec![u, 0.0], ..State::rest(2) };
        let motion = System::new(&block(m, elements)).unwrap().simulate(&start, 6.0).unwrap();
        let rests = v / g + 2.0 * e * v / (g * (1.0 - e));
        let stops = u / (mu * g);
        assert!(stops > rests, "the case is of a block that slides on");
        let closes: Vec<_> = of(&motion, EventKind::Close);
        assert!(closes.len() == 2 && closes.iter().all(|c| (c.time - rests).abs() < 1e-13), "{closes:?}");
        let [stick] = of(&motion, EventKind::Stick)[..] else { panic!("{:?}", motion.events) };
        assert!((stick.time - stops).abs() < 1e-13 && stick.element == 1, "{} {stops}", stick.time);
        // Between the blows k and k + 1, 2 eᵏ⁺¹ v/g apart, the speed is u − µ v (1 + e)(1 + e + … + eᵏ).
        let (mut way, mut speed) = (u * v / g, u);
        for k in 0..400 {
            let falls = v * e.powi(k);
            speed -= mu * (1.0 + e) * falls;
            way += speed * 2.0 * e * falls / g;
        }
        let left = u - mu * g * rests;
        way += left * left / (2.0 * mu * g);
        assert!((motion.end.displacement[0] - way).abs() < 1e-12, "{} {way}", motion.end.displacement[0]);
        assert!((motion.elements[1].work - m * u * u / 2.0).abs() < 1e-12 * m * u * u);
        assert!((motion.elements[0].work - m * g * h).abs() < 1e-12 * m * g * h);
        assert_eq!((motion.end.velocity[0], motion.end.velocity[1]), (0.0, 0.0));
        assert!(energy(&motion) < 1e-13);
    }
    // With much friction the first blow stops it, and half of the energy of (1 + e) µ v = u is no more than that.
    let elements = vec![stop(vec![0.0, -1.0], 0.0, 0.5), under(vec![1.0, 0.0], 0, 0.9, 1.0)];
    let start = State { displacement: vec![0.0, h], velocity: vec![1.5, 0.0], ..State::rest(2) };
    let motion = System::new(&block(m, elements)).unwrap().simulate(&start, 6.0).unwrap();
    assert!((motion.end.displacement[0] - 1.5 * v / g).abs() < 1e-13);
    assert!((motion.elements[1].work / (m * 1.5 * 1.5 / 2.0) - 1.0).abs() < 1e-13);
    // The end of the blows, with nothing left to slide, begins a rest.
    let rests = v / g + 2.0 * 0.5 * v / (g * 0.5);
    let rest = &motion.elements[1];
    assert!(rest.stops == 1 && (rest.time_at_rest - (6.0 - rests)).abs() < 1e-12, "{rest:?} {rests}");
}

/// On a floor in touch the friction is the coefficient times what presses: it holds a pull up to µ' N, where N falls with the lift.
#[test]
fn the_floor_holds_what_its_force_allows() {
    let (g, m, mu, peak, pull, lift, w) = (9.81_f64, 2.0, 0.5, 1.2, 3.0, 12.0, 2.0);
    let elements = vec![stop(vec![0.0, -1.0], 0.0, 0.4), under(vec![1.0, 0.0], 0, mu, peak)];
    let mut model = block(m, elements);
    model.constant[0] = pull;
    model.harmonics = vec![Harmonic { frequency: w, sin: vec![0.0, lift], cos: vec![] }];
    let system = System::new(&model).unwrap();
    let motion = system.simulate(&at(vec![0.0, 0.0]), 1.5).unwrap();
    // pull = peak µ (m g − lift sin ωt).
    let due = ((m * g - pull / (mu * peak)) / lift).asin() / w;
    assert!(due.is_nan(), "it holds throughout");
    assert!(motion.events.is_empty() && motion.end.velocity == [0.0, 0.0], "{:?}", motion.events);
    model.constant[0] = 2.0 * pull;
    let motion = System::new(&model).unwrap().simulate(&at(vec![0.0, 0.0]), 1.5).unwrap();
    let due = ((m * g - 2.0 * pull / (mu * peak)) / lift).asin() / w;
    let first = motion.events[0];
    assert!(first.kind == EventKind::Slip && (first.time - due).abs() < 1e-14, "{first:?} {due}");
    // Then m x″ = pull − µ (m g − lift sin ωt), from the slip on.
    let t = 1.5 - due;
    let integral = |s: f64| -(w * s).sin() / (w * w);
    let lifted = integral(1.5) - integral(due) + t * (w * due).cos() / w;
    let x = ((2.0 * pull - mu * m * g) * t * t / 2.0 + mu * lift * lifted) / m;
    assert!((motion.end.displacement[0] - x).abs() < 1e-13, "{} {x}", motion.end.displacement[0]);
    assert!(energy(&motion) < 1e-13);
}

/// Bodies along a floor, the first of which bounces on it, perhaps below a ceiling: for the engine, and for the small steps.
fn machine(random: &mut Random) -> (Model<f64>, State<f64>, Machine, f64) {
    let bodies = 1 + random.below(2) as usize;
    // Along the floor, up, and the second body along the floor.
    let n = bodies + 1;
    let zeros = || vec![vec![0.0; n]; n];
    let (mut mass, mut damping, mut stiffness) = (zeros(), zeros(), zeros());
    let heavy = random.between(0.5, 2.0);
    (0..n).for_each(|i| mass[i][i] = if i < 2 { heavy } else { random.between(0.5, 2.0) });
    let mut link = |random: &mut Random, a: usize, b: Option<usize>, most: f64| {
        let (k, c) = (random.between(0.1, 1.0) * most, random.between(0.0, 0.6));
        for (matrix, x) in [(&mut stiffness, k), (&mut damping, c)] {
            matrix[a][a] += x;
            if let Some(b) = b {
                matrix[b][b] += x;
                matrix[a][b] -= x;
                matrix[b][a] -= x;
            }
        }
    };
    link(random, 0, None, 60.0);
    link(random, 1, None, 10.0);
    if random.next() < 0.4 {
        // A strut at an angle.
        link(random, 0, Some(1), 15.0);
    }
    if bodies > 1 {
        link(random, 2, Some(0), 60.0);
        if random.next() < 0.3 {
            let x = random.between(-0.2, 0.2);
            (mass[0][2], mass[2][0]) = (x, x);
        }
    }
    let restitution = |random: &mut Random| match random.below(8) {
        0 => 0.0,
        1 => 1.0,
        _ => random.between(0.05, 0.95),
    };
    let axis =
        |i: usize, sign: f64| -> Vec<f64> { (0..n).map(|j| if i == j { sign } else { 0.0 }).collect() };
    let mut walls = vec![Wall { b: axis(1, -1.0), gap: 0.0, e: restitution(random) }];
    if random.next() < 0.3 {
        walls.push(Wall { b: axis(1, 1.0), gap: random.between(0.03, 0.2), e: restitution(random) });
    }
    let mut rubs: Vec<Rub> = (0..walls.len())
        .filter_map(|i| {
            let (has, friction) = (i == 0 || random.next() < 0.7, random.between(0.05, 0.9));
            has.then(|| Rub { b: axis(0, 1.0), friction, peak: 1.0, under: Some(i) })
        })
        .collect();
    if bodies > 1 {
        let mut b = axis(2, 1.0);
        match random.below(3) {
            // The second body slides on the first one, under the floor's force: through a scraper.
            0 => {
                b[0] = -1.0;
                rubs.push(Rub { b, friction: random.between(0.05, 0.5), peak: 1.0, under: Some(0) });
            }
            1 => rubs.push(Rub { b, friction: random.between(0.5, 3.0), peak: 1.0, under: None }),
            _ => {}
        }
    }
    let g = 9.81 * heavy;
    let mut constant = vec![0.0; n];
    constant[1] = -g;
    let harmonics: Vec<Harmonic<f64>> = (0..1 + random.below(2))
        .map(|_| {
            let mut sin: Vec<f64> = (0..n).map(|_| random.between(-20.0, 20.0)).collect();
            sin[1] = random.between(0.3, 2.5) * g;
            let frequency = random.between(3.0, 25.0);
            Harmonic { frequency, sin, cos: (0..n).map(|_| random.between(-5.0, 5.0)).collect() }
        })
        .collect();
    let count = rubs.len();
    let elements = rubs.iter().map(|r| match r.under {
        Some(wall) => under(r.b.clone(), count + wall, r.friction, r.peak),
        None => rub(r.b.clone(), r.friction, r.peak),
    });
    let elements = elements.chain(walls.iter().map(|w| stop(w.b.clone(), w.gap, w.e))).collect();
    let model = Model { mass, damping, stiffness, elements, constant, harmonics, ..Model::default() };
    let machine = Machine::new(&model, rubs, walls);
    let mut start = at(vec![0.0; n]);
    start.displacement[1] = random.between(0.005, 0.03);
    start.velocity[0] = random.between(-1.0, 1.0);
    (model, start, machine, random.between(1.0, 2.5))
}

/// Random machines beside an independent program: the same events, and the same end.
#[test]
fn random_machines_are_those_of_small_steps() {
    let mut random = Random(762);
    let (mut compared, mut blows, mut closes, mut opens, mut slides) = (0, 0, 0, 0, 0);
    let (mut worst, mut multiplied, mut failed) = (0.0_f64, 0, Vec::new());
    for number in 0..crate::count(40, 500) {
        let (model, start, machine, until) = machine(&mut random);
        let motion = System::new(&model).and_then(|system| system.simulate(&start, until));
        let motion = motion.unwrap_or_else(|error| panic!("{number}: {error}\n{model:?}"));
        assert!(energy(&motion) < 1e-12, "{number}: {}", energy(&motion));
        match beside(&model, &machine, &start, until, &motion) {
            Ok(Judged { is_multiplied: true, .. }) => multiplied += 1,
            Ok(Judged { by, .. }) => worst = worst.max(by),
            Err(why) => failed.push(format!("{number}: {why}\n{model:?}\n{start:?}")),
        }
        compared += 1;
        let count = |kind| of(&motion, kind).len();
        blows += count(EventKind::Blow);
        closes += count(EventKind::Close);
        opens += count(EventKind::Open);
        slides += count(EventKind::Stick) + count(EventKind::Slip) + count(EventKind::Reverse);
    }
    println!(
        "{compared} machines, {blows} blows, {closes} contacts, {opens} of them opened, {slides} slips, rests and reversals, worst {worst:e}, {multiplied} beside 256 bits"
    );
    assert!(failed.is_empty(), "{} of {compared}\n{}", failed.len(), failed.join("\n"));
    assert!(multiplied * 100 <= compared, "{multiplied} of {compared}");
    assert!(blows > 10 * compared && closes > compared && opens > 0 && slides > compared);
}

/// The multipliers of a motion whose friction slides in its blows, and of one whose friction stops in them, add up to the trace of differences.
#[test]
fn multipliers_go_through_the_friction_of_a_blow() {
    for (e, mu, lift, count) in [(0.4, 0.3, 15.0, 20), (0.3, 0.9, 22.0, 22)] {
        let elements = vec![stop(vec![0.0, -1.0], 0.0, e), under(vec![1.0, 0.0], 0, mu, 1.0)];
        let model = Model {
            damping: vec![vec![3.0, 0.0], vec![0.0, 0.5]],
            stiffness: vec![vec![900.0, 0.0], vec![0.0, 60.0]],
            harmonics: vec![Harmonic { frequency: 50.0, sin: vec![6.0, lift], cos: vec![4.0, 0.0] }],
            ..block(1.0, elements)
        };
        let system = System::new(&model).unwrap();
        let found = system.steady(&at(vec![0.0, 0.01])).unwrap();
        assert!(found.kind == SteadyKind::Periodic && of(&found.motion, EventKind::Blow).len() == count);
        let first = [&*found.start.displacement, &*found.start.velocity].concat();
        let (h, mut trace) = (1e-6, 0.0);
        for i in 0..4 {
            let moved = |by: f64| {
                let mut from = first.clone();
                from[i] += by;
                let (q, v) = from.split_at(2);
                // A body on the floor does not go below it.
                let displacement = vec![q[0], q[1].max(0.0)];
                let start = State { displacement, velocity: v.to_vec(), ..State::rest(2) };
                let end = system.simulate(&start, found.period).unwrap().end;
                [end.displacement, end.velocity].concat()[i]
            };
            trace += (moved(h) - moved(-h)) / (2.0 * h);
        }
        let sum: f64 = found.multipliers.iter().map(|one| one.0).sum();
        assert!((trace - sum).abs() < 1e-7, "{trace} {sum}");
    }
}

/// Friction on which the force of its stop depends is refused.
#[test]
fn friction_that_the_force_of_its_stop_depends_on_is_refused() {
    let text = |model: &Model<f64>| System::new(model).unwrap_err().to_string();
    let floor = || stop(vec![0.0, -1.0], 0.0, 0.5);
    let across = "rub must be across the stop that presses on it, without a contact, another stop or an entry of the mass matrix that \
                  joins both: the force of the stop would depend on the friction. Give the stop a stiffness";
    assert_eq!(text(&block(1.0, vec![floor(), under(vec![1.0, 0.5], 0, 0.3, 1.0)])), across);
    let mut model = block(1.0, vec![floor(), under(vec![1.0, 0.0], 0, 0.3, 1.0)]);
    assert!(System::new(&model).is_ok());
    (model.mass[0][1], model.mass[1][0]) = (0.1, 0.1);
    assert_eq!(text(&model), across);
    // A contact at an angle, and a corner whose sides rub.
    assert_eq!(
        text(&block(1.0, vec![floor(), under(vec![1.0, 0.0], 0, 0.3, 1.0), rub(vec![1.0, 1.0], 1.0, 1.0)])),
        across
    );
    // A guide along the fall; the stops of a play are never in touch at once.
    let shared = "rub must be under a stop whose force the motion determines, without a contact along its direction, or contacts along a sum \
                  that has it: these share the force. Give the stop a stiffness";
    let play = vec![floor(), under(vec![1.0, 0.0], 0, 0.3, 1.0), stop(vec![0.0, 1.0], 0.2, 0.5)];
    assert!(System::new(&block(1.0, play)).is_ok());
    for other in [rub(vec![0.0, 1.0], 1.0, 1.0), rub(vec![0.0, 2.0], 0.0, 1.0)] {
        assert_eq!(text(&block(1.0, vec![floor(), under(vec![1.0, 0.0], 0, 0.3, 1.0), other])), shared);
    }
    let corner = vec![
        floor(),
        under(vec![1.0, 0.0], 0, 0.3, 1.0),
        stop(vec![1.0, 0.0], 0.1, 0.5),
        under(vec![0.0, 1.0], 2, 0.3, 1.0),
    ];
    assert_eq!(text(&block(1.0, corner)), across);
    let place = "rub must be under the force of a stop with a restitution, by its place among the elements";
    assert_eq!(text(&block(1.0, vec![floor(), under(vec![1.0, 0.0], 1, 0.3, 1.0)])), place);
    assert_eq!(text(&block(1.0, vec![floor(), under(vec![1.0, 0.0], 7, 0.3, 1.0)])), place);
    assert_eq!(
        text(&block(1.0, vec![floor(), under(vec![1.0, 0.0], 0, -0.3, 1.0)])),
        "rub: coefficient = -0.3 must be ≥ 0"
    );
    assert_eq!(
        text(&block(1.0, vec![floor(), under(vec![1.0, 0.0], 0, 0.3, 0.5)])),
        "rub: peak = 0.5 must be ≥ 1"
    );
}
