//! Steps that fast modes do not shorten, beside short ones: stiff links, valves, light parts; and two modes of 1 : 10⁴ that graze.

#![allow(clippy::print_stdout, reason = "the counts of a campaign are shown with --nocapture")]

use crate::count;
use crate::generator::Random;
use crate::precise::{far, truth};
use stickslip::system::{
    Beyond, Element, Error, EventKind, Harmonic, Kind, Law, Model, Motion, Record, Signal, State, System,
};

fn element(direction: Vec<f64>, moves: f64, kind: Kind<f64>) -> Element<f64> {
    Element { name: String::new(), direction, moves: Signal::constant(moves), kind }
}

/// One to four bodies on springs and dampers, of which one or two are 10⁴ to 10⁹ times as stiff, or as light, with contacts, elastic contacts, stops and belts.
pub(crate) fn stiff(random: &mut Random) -> Model<f64> {
    let n = 1 + (random.next() * 4.0) as usize;
    let zeros = || vec![vec![0.0; n]; n];
    let (mut mass, mut damping, mut stiffness) = (zeros(), zeros(), zeros());
    let hard = (random.next() * n as f64) as usize;
    let kind = (random.next() * 4.0) as usize;
    let by = 10_f64.powf(random.between(4.0, 9.0));
    let damped = [0.0, random.between(0.01, 0.2), random.between(0.5, 3.0)][(random.next() * 3.0) as usize];
    for i in 0..n {
        mass[i][i] = random.between(0.5, 2.0);
        // A body in two is light.
        if kind == 1 && i == hard {
            mass[i][i] /= by.sqrt();
        }
        let stiff = if kind == 0 && i == hard { by } else { 1.0 };
        // A valve: a damper that is as strong.
        let dense = if kind == 2 && i == hard { by.sqrt() } else { 1.0 };
        // The first body may have no spring to the ground.
        let loose = if i == 0 && n > 1 && random.next() < 0.3 { 0.0 } else { 1.0 };
        let (k, c) =
            (random.between(0.5, 3.0) * stiff * loose, random.between(0.5, 1.5) * damped * dense * loose);
        for (matrix, x) in [(&mut stiffness, k), (&mut damping, c)] {
            matrix[i][i] += x;
            if i > 0 {
                matrix[i - 1][i - 1] += x;
                matrix[i - 1][i] -= x;
                matrix[i][i - 1] -= x;
            }
        }
    }
    let count = 1 + (random.next() * 2.0) as usize;
    let elements = (0..count)
        .map(|_| {
            let (at, other) = ((random.next() * n as f64) as usize, random.next() < 0.4);
            let mut direction = vec![0.0; n];
            direction[at] = 1.0;
            if other && at > 0 {
                direction[at - 1] = -1.0;
            }
            let belt = if random.next() < 0.2 { random.between(0.1, 1.0) } else { 0.0 };
            let friction = random.between(0.1, 1.0);
            match (random.next() * 5.0) as usize {
                0 => element(
                    direction,
                    0.0,
                    Kind::Elastic { stiffness: random.between(1.0, 9.0), friction, normal: None },
                ),
                1 => element(
                    direction,
                    0.0,
                    Kind::Stop {
                        gap: random.between(0.1, 1.0),
                        stiffness: random.between(5.0, 50.0),
                        damping: 0.1,
                    },
                ),
                2 => {
                    let law = Law { points: vec![(0.0, friction), (1.0, 0.8 * friction), (3.0, friction)] };
                    element(direction, belt, Kind::Contact { law, peak: 1.2, normal: None })
                }
                _ => element(
                    direction,
                    belt,
                    Kind::Contact { law: Law::constant(friction), peak: 1.0, normal: None },
                ),
            }
        })
        .collect();
    let (harmonics, records) = loads(random, n, [-2.0, 2.0], 2.0, [0.0, 2.0, 3.0, 4.5, 9.0]);
    Model { mass, damping, stiffness, elements, harmonics, records, ..Model::default() }
}

/// A harmonic, a record or both, with forces in a range on each coordinate: the harmonic of at most this frequency, the record at these times.
pub(crate) fn loads(
    random: &mut Random,
    n: usize,
    [least, greatest]: [f64; 2],
    fastest: f64,
    times: [f64; 5],
) -> (Vec<Harmonic<f64>>, Vec<Record<f64>>) {
    let force = |random: &mut Random| (0..n).map(|_| random.between(least, greatest)).collect::<Vec<_>>();
    let shaken = random.next() < 0.7;
    let harmonics = shaken.then(|| Harmonic {
        frequency: random.between(0.3, fastest),
        sin: force(random),
        cos: force(random),
    });
    let record = (!shaken || random.next() < 0.3).then(|| Record {
        times: times.to_vec(),
        values: vec![0.0, 1.5, -1.0, 1.0, 0.2],
        force: force(random),
        beyond: Beyond::Hold,
    });
    (harmonics.into_iter().collect(), record.into_iter().collect())
}

/// The greatest difference of two motions in parts of the motion; that of the stored energies less the rounding of their terms, of which those of
/// a stiff link are far above their sum.
fn apart(model: &Model<f64>, a: &Motion<f64>, b: &Motion<f64>) -> f64 {
    let q = &b.end.displacement;
    let terms = model
        .stiffness
        .iter()
        .zip(q)
        .flat_map(|(row, x)| row.iter().zip(q).map(move |(k, y)| (x * k * y).abs()));
    let rounding = 64.0 * f64::EPSILON * terms.sum::<f64>();
    let lists = |m: &Motion<f64>| {
        let force = m.end.force.clone();
        let works = m.elements.iter().map(|e| e.work).chain([m.load_work, m.damper_work]).collect::<Vec<_>>();
        let places =
            [&m.end.displacement, &m.max_displacement, &m.min_displacement].map(Clone::clone).concat();
        let speeds = [&m.end.velocity, &m.max_velocity, &m.min_velocity].map(Clone::clone).concat();
        [places, speeds, force, works]
    };
    let stored = ((a.stored - b.stored).abs() - rounding).max(0.0);
    let work =
        [b.load_work, b.damper_work, b.stored].into_iter().fold(1e-300, |most: f64, x| most.max(x.abs()));
    let pairs = lists(a).into_iter().zip(lists(b));
    pairs
        .map(|(a, b)| {
            let size = b.iter().fold(1e-300_f64, |most, x| most.max(x.abs()));
            a.iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / size
        })
        .fold(stored / work, f64::max)
}

/// The same machine with its bodies in the opposite order and the masses greater by some roundings: the same motion as far as f64 can tell. A rounding of
/// a stiff link is the ratio of the stiffnesses times that of a soft spring.
fn rounded(model: &Model<f64>, by: f64) -> Model<f64> {
    let mut other = model.clone();
    for (i, row) in other.mass.iter_mut().enumerate() {
        row[i] *= 1.0 + by * f64::EPSILON;
    }
    for matrix in [&mut other.mass, &mut other.damping, &mut other.stiffness] {
        matrix.reverse();
        matrix.iter_mut().for_each(|row| row.reverse());
    }
    other.elements.iter_mut().for_each(|e| e.direction.reverse());
    for harmonic in &mut other.harmonics {
        harmonic.sin.reverse();
        harmonic.cos.reverse();
    }
    other.records.iter_mut().for_each(|record| record.force.reverse());
    other
}

/// The same events, and the same motion within 10⁻¹⁰, as with steps of the fastest mode. Where a motion multiplies its own rounding (a
/// contact that chatters with the ringing of a link) or that of its link, it is within four times what rounding makes of the short steps
/// themselves, or as near as they are to the motion at 128 bits.
#[test]
fn stiff_machines_move_as_by_short_steps() {
    let mut random = Random(78);
    let (mut compared, mut long, mut worst, mut events, mut rough, mut undecided) = (0, 0, 0.0_f64, 0, 0, 0);
    for number in 0..count(60, 500) {
        let model = stiff(&mut random);
        let until = random.between(3.0, 9.0);
        let system = System::new(&model).expect("valid");
        let steps = system.steps_per_time() * until;
        if steps > count(40_000, 400_000) as f64 {
            continue;
        }
        let start = State::rest(model.mass.len());
        let short = system.clone().by_short_steps().simulate(&start, until);
        let found = system.simulate(&start, until);
        let (short, found) = match (short, found) {
            (Ok(short), Ok(found)) => (short, found),
            // Contacts that share a force: what is undecided for one is for the other.
            (Err(short), Err(found)) if short == found && matches!(short, Error::Undecided { .. }) => {
                undecided += 1;
                continue;
            }
            (short, found) => panic!("{number}: {:?} {:?}\n{model:?}", short.err(), found.err()),
        };
        let turned = [3.0, -5.0].map(|by| {
            let system = System::new(&rounded(&model, by)).expect("valid").by_short_steps();
            let mut turned = system.simulate(&start, until).expect("it moves");
            for list in [
                &mut turned.end.displacement,
                &mut turned.end.velocity,
                &mut turned.max_displacement,
                &mut turned.min_displacement,
                &mut turned.max_velocity,
                &mut turned.min_velocity,
            ] {
                list.reverse();
            }
            turned
        });
        let list = |m: &Motion<f64>| m.events.iter().map(|e| (e.element, e.kind)).collect::<Vec<_>>();
        if turned.iter().any(|turned| list(turned) != list(&short)) {
            // Rounding decides an event.
            rough += 1;
            continue;
        }
        compared += 1;
        long += usize::from(system.has_long_steps(until));
        assert_eq!(list(&found), list(&short), "{number}: {model:?}");
        let own = turned.iter().map(|turned| apart(&model, turned, &short)).fold(0.0, f64::max);
        let by = apart(&model, &found, &short);
        if by >= 1e-10_f64.max(4.0 * own) {
            let truth = truth(&model, until).expect("it moves");
            let [ours, theirs] = [&found, &short].map(|motion| far(until, motion, &truth));
            println!("{number}: {by:e} apart, {own:e} by rounding; off by {ours:?} and {theirs:?}");
            assert!(
                ours.zip(theirs).is_some_and(|(ours, theirs)| ours <= 4.0 * theirs),
                "{number}: {model:?}"
            );
        }
        if by < 1e-10 {
            worst = worst.max(by);
        } else {
            rough += 1;
        }
        events += found.events.len();
    }
    println!(
        "{compared} machines, {long} with long steps, {events} events, apart by {worst:e}; {rough} multiply their rounding, {undecided} are undecided"
    );
    assert!(compared > count(25, 300) && events > 5 * compared, "{compared} {events}");
    assert!(undecided * 50 <= compared, "{undecided} of {compared}");
    assert!(long * 3 > compared && rough * 10 < compared, "{long} and {rough} of {compared}");
}

/// A contact without friction on two uncoupled bodies of the frequencies 1 and 10⁴ turns where its velocity passes zero:
/// `V − a cos t − b cos 10⁴t`. Its least value is a little above or below zero, so that the fast mode decides.
#[test]
fn a_fast_mode_that_decides_is_not_passed_over() {
    let fast = 1e4_f64;
    let mut touched = 0;
    for (number, share) in [1e-1, 1e-3, 1e-5, 1e-7, 1e-9].into_iter().enumerate() {
        for above in [-0.9, -0.3, -1e-3, 1e-3, 0.3] {
            let (a, b) = (1.0, share);
            // The least value of the sum is close to V − a − b, at t = 0 and wherever both cosines are 1; the slow one is flat there.
            let belt = a + b * (1.0 + above);
            let model = Model {
                mass: vec![vec![1.0, 0.0], vec![0.0, 1.0]],
                damping: vec![vec![0.0; 2]; 2],
                stiffness: vec![vec![1.0, 0.0], vec![0.0, fast * fast]],
                elements: vec![element(
                    vec![1.0, 1.0],
                    belt,
                    Kind::Contact { law: Law::constant(0.0), peak: 1.0, normal: None },
                )],
                ..Model::default()
            };
            // From a quarter of a turn before the slow crest, with a phase of the fast mode that is no multiple of it.
            let (slow_phase, fast_phase) = (-1.5_f64, 0.7 + number as f64);
            let start = State {
                displacement: vec![a * slow_phase.sin(), b / fast * fast_phase.sin()],
                velocity: vec![a * slow_phase.cos(), b * fast_phase.cos()],
                ..State::rest(2)
            };
            let value = |t: f64| belt - a * (slow_phase + t).cos() - b * (fast_phase + fast * t).cos();
            // Where the sum is least: beside the crests of the fast mode, and all around the slow one, which is flat there.
            let crests = (1..4776).flat_map(|k| {
                let crest = std::f64::consts::TAU * f64::from(k) - fast_phase;
                (-40..=40).map(move |part| (crest + f64::from(part) * 0.01) / fast)
            });
            let beside = (-20_000..=20_000).map(|k| -slow_phase + f64::from(k) * 1e-7);
            let mut places: Vec<f64> = crests.chain(beside).collect();
            places.sort_by(f64::total_cmp);
            let first = places.iter().copied().find(|&t| value(t) < 0.0);
            let least = places.iter().map(|&t| value(t)).fold(f64::MAX, f64::min);
            let system = System::new(&model).expect("valid");
            assert!(system.has_long_steps(3.0));
            let motion = system.simulate(&start, 3.0).expect("it moves");
            let turns = motion.events.iter().find(|e| e.kind == EventKind::Reverse);
            match (first, turns) {
                (Some(crest), Some(event)) => {
                    touched += 1;
                    let radian = 1.0 / fast;
                    assert!(
                        event.time <= crest && event.time > crest - 3.2 * radian,
                        "{share:e} {above}: {event:?} {crest}"
                    );
                    // The phase of the fast mode, up to 3·10⁴, is known to some units in its last place.
                    assert!(
                        value(event.time).abs() < 1e-13 + 2e-11 * b,
                        "{share:e} {above}: {:e}",
                        value(event.time)
                    );
                }
                (None, None) => assert!(least > 0.0),
                (first, turns) => panic!("{share:e} {above}: {first:?} {turns:?}, least {least:e}"),
            }
        }
    }
    assert!(touched >= 8, "{touched}");
}

/// A valve with the rates 1.68 and 78,123 a second (overdamped), and a link of 10⁹ kN/m between masses of 100 t and 0.5 t, do not take the
/// steps of their fastest mode: in 600 s that would be 5·10⁷ of them, where a motion may have 2·10⁶.
#[test]
fn a_minute_of_a_stiff_machine_is_no_million_steps() {
    let valve = Model {
        mass: vec![vec![1.6]],
        damping: vec![vec![125_000.0]],
        stiffness: vec![vec![210_490.0]],
        elements: vec![element(
            vec![1.0],
            0.0,
            Kind::Contact { law: Law::constant(700.0), peak: 1.1, normal: None },
        )],
        harmonics: vec![Harmonic { frequency: 0.7, sin: vec![3000.0], cos: vec![] }],
        ..Model::default()
    };
    let system = System::new(&valve).expect("valid");
    assert!(600.0 * system.steps_per_time() > 4e7);
    let motion = system.simulate(&State::rest(1), 600.0).expect("within the steps of a motion");
    // Without inertia, c v = F sin ωt − k x − r: the energies agree.
    let spent = motion.damper_work + motion.elements[0].work + motion.stored;
    assert!((motion.load_work - spent).abs() < 1e-9 * motion.load_work, "{motion:?}");
    assert!(motion.elements[0].stops > 100, "{}", motion.elements[0].stops);
    let steady = system.steady(&State::rest(1)).expect("it settles");
    assert!(steady.motion.elements[0].stops == 2, "{steady:?}");
}
