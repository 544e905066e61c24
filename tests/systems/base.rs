//! Absolute accelerations on a base that moves.

use crate::closed_form::contact;
use crate::generator::Random;
use stickslip::Excitation;
use stickslip::motion::record::{Body, Record as Samples};
use stickslip::system::{Base, Beyond, Element, Harmonic, Kind, Model, Record, Signal, State, System};

fn shaken(random: &mut Random, count: usize) -> Vec<f64> {
    let mut value = 0.0;
    let mut next = || {
        value = 0.8 * value + random.between(-1.5, 1.5);
        value
    };
    (0..count).map(|_| next()).collect()
}

/// Bodies under random records have the greatest absolute accelerations of the exact motion of one body.
#[test]
fn one_body_has_the_greatest_acceleration_of_its_record() {
    let mut random = Random(21);
    let mut stuck = 0;
    for number in 0..200 {
        let (mass, stiffness) = (random.between(0.5, 4.0), random.between(1.0, 60.0));
        let damping = random.between(0.0, 0.3) * 2.0 * (stiffness * mass).sqrt();
        let friction = random.between(0.1, 1.0) * mass;
        let peak = if random.next() < 0.5 { 1.0 } else { random.between(1.0, 1.6) };
        let values = shaken(&mut random, 30);
        let body = Body::new(mass, friction)
            .and_then(|b| b.with_stiffness(stiffness))
            .and_then(|b| b.with_damping(damping))
            .and_then(|b| b.with_static_friction_ratio(peak))
            .expect("valid");
        let record = Samples::new(Excitation::SurfaceAcceleration, random.between(0.05, 0.2), values.clone())
            .expect("valid");
        let expected = body.follow(&record).expect("it is found");
        let times = (0..values.len()).map(|i| record.time(i)).collect();
        let model = Model {
            mass: vec![vec![mass]],
            damping: vec![vec![damping]],
            stiffness: vec![vec![stiffness]],
            elements: vec![contact(vec![1.0], friction, peak)],
            records: vec![Record { times, values, force: vec![-mass], beyond: Beyond::Zero }],
            ..Model::default()
        };
        let acceleration = Signal { records: vec![1.0], ..Signal::constant(0.0) };
        let base = Base { influence: vec![1.0], acceleration };
        let system = System::new(&model).and_then(|s| s.with_base(&base)).expect("valid");
        let motion = system.simulate(&State::rest(1), record.end() + 400.0).expect("it is found");
        let (seen, due) = (motion.max_absolute_acceleration[0], expected.max_absolute_acceleration);
        assert!((seen - due).abs() < 1e-10 * due, "{number}: {seen} for {due}");
        stuck += motion.elements[0].stops;
    }
    assert!(stuck > 200, "{stuck}");
}

/// The absolute accelerations by Newton's law, from displacements, velocities and the elements' forces.
fn by_newton(model: &Model<f64>, masses: [f64; 2], base: f64, time: f64, state: &State<f64>) -> [f64; 2] {
    [0, 1].map(|i| {
        let row = |m: &[Vec<f64>], x: &[f64]| m[i].iter().zip(x).map(|(a, b)| a * b).sum::<f64>();
        let elements = model.elements.iter().zip(&state.force);
        let held: f64 = elements.map(|(element, force)| element.direction[i] * force).sum();
        let drive: f64 = model.harmonics.iter().skip(1).map(|h| h.sin[i] * (h.frequency * time).sin()).sum();
        // The load of the base is taken with the acceleration relative to it.
        let relative = (drive
            - masses[i] * base
            - held
            - row(&model.stiffness, &state.displacement)
            - row(&model.damping, &state.velocity))
            / masses[i];
        relative + base
    })
}

/// Two bodies with a contact, an elastic contact and a stop, on a base under a harmonic and a record at once, with a force of their
/// own: the greatest values are those of dense samples, and no sample is above them. The samples are those of Newton's law, and
/// of the differences of the sampled velocity with the acceleration of the base.
#[test]
fn the_greatest_accelerations_are_those_of_dense_samples() {
    let mut random = Random(22);
    let (mut events, mut differences) = (0, 0);
    for number in 0..20 {
        let masses = [random.between(0.5, 2.0), random.between(0.5, 2.0)];
        let (k, join, c) = (random.between(1.0, 6.0), random.between(0.5, 8.0), random.between(0.0, 0.4));
        let element = |direction: Vec<f64>, kind| Element {
            name: "element".into(),
            direction,
            moves: Signal::constant(0.0),
            kind,
        };
        let values = shaken(&mut random, 12);
        let times: Vec<f64> = (0..12).map(|i| 0.7 * f64::from(i)).collect();
        let (omega, sin, cos) =
            (random.between(0.5, 4.0), random.between(-2.0, 2.0), random.between(-1.0, 1.0));
        let model = Model {
            mass: vec![vec![masses[0], 0.0], vec![0.0, masses[1]]],
            damping: vec![vec![c, -c], vec![-c, c]],
            stiffness: vec![vec![k + join, -join], vec![-join, join]],
            elements: vec![
                contact(vec![1.0, 0.0], random.between(0.1, 1.0), random.between(1.0, 1.5)),
                element(
                    vec![-1.0, 1.0],
                    Kind::Elastic { stiffness: 3.0, friction: random.between(0.1, 0.8), normal: None },
                ),
                element(vec![0.0, 1.0], Kind::Stop { gap: 0.3, stiffness: 40.0, damping: 0.5 }),
            ],
            harmonics: vec![
                Harmonic {
                    frequency: omega,
                    sin: masses.map(|m| -m * sin).to_vec(),
                    cos: masses.map(|m| -m * cos).to_vec(),
                },
                Harmonic { frequency: 1.3, sin: vec![0.0, 0.7], cos: vec![] },
            ],
            records: vec![Record {
                times: times.clone(),
                values: values.clone(),
                force: masses.map(|m| -m).to_vec(),
                beyond: Beyond::Zero,
            }],
            ..Model::default()
        };
        let acceleration =
            Signal { sin: vec![sin], cos: vec![cos], records: vec![1.0], ..Signal::constant(0.0) };
        let base = Base { influence: vec![1.0; 2], acceleration };
        let plain = System::new(&model).expect("valid");
        let system = plain.clone().with_base(&base).expect("valid");
        let until = 12.0;
        let motion = system.simulate(&State::rest(2), until).expect("it is found");
        let without = plain.simulate(&State::rest(2), until).expect("it is found");
        assert!(without.max_absolute_acceleration.is_empty());
        assert!(without.end.absolute_acceleration.is_empty());
        let end = State { absolute_acceleration: vec![], ..motion.end.clone() };
        assert_eq!((&motion.events, &end), (&without.events, &without.end), "{number}");
        let mut at: Vec<f64> = (0..=24_000).map(|i| until * f64::from(i) / 24_000.0).collect();
        let jumps = motion.events.iter().map(|e| e.time).chain(times.iter().copied());
        at.extend(jumps.flat_map(|t| [t - 1e-9, t + 1e-9]).filter(|t| *t > 0.0 && *t < until));
        at.sort_by(f64::total_cmp);
        let mut most = [0.0f64; 2];
        let base_at = |time: f64| {
            let shake = times.windows(2).zip(values.windows(2)).find(|(t, _)| t[0] <= time && time < t[1]);
            let shake = shake.map_or(0.0, |(t, p)| p[0] + (p[1] - p[0]) * (time - t[0]) / (t[1] - t[0]));
            let phase = omega * time;
            sin * phase.sin() + cos * phase.cos() + shake
        };
        let states = system.states(&State::rest(2), &at).expect("it is found");
        for (&time, state) in at.iter().zip(&states) {
            let found = by_newton(&model, masses, base_at(time), time, state);
            most = [0, 1].map(|i| most[i].max(found[i].abs()));
            for (seen, due) in state.absolute_acceleration.iter().zip(found) {
                // The end of the record is a jump at a sample.
                let by = (seen - due).abs();
                assert!(
                    by < 1e-11 || (time - times[11]).abs() < 1e-9,
                    "{number} at {time}: {seen} for {due}"
                );
            }
        }
        let jumps: Vec<f64> = motion.events.iter().map(|e| e.time).chain(times.iter().copied()).collect();
        for (t, of) in at.windows(3).zip(states.windows(3)) {
            let is_even = (t[2] - 2.0 * t[1] + t[0]).abs() < 1e-12;
            if !is_even || jumps.iter().any(|jump| (t[0] - 1e-9..=t[2] + 1e-9).contains(jump)) {
                continue;
            }
            for i in 0..2 {
                let slope = (of[2].velocity[i] - of[0].velocity[i]) / (t[2] - t[0]);
                let (seen, due) = (of[1].absolute_acceleration[i], slope + base_at(t[1]));
                // ω² ≤ 2 (6 + 2·8 + 3 + 40) while the stop is pressed, and h²/6 of it 5.4·10⁻⁶ of the acceleration.
                let size = most[0].max(most[1]);
                assert!((seen - due).abs() < 6e-6 * size, "{number} at {}: {seen} for {due}", t[1]);
                differences += 1;
            }
        }
        for (i, (&seen, sampled)) in motion.max_absolute_acceleration.iter().zip(most).enumerate() {
            // A summit is at most h/2 = 2.5·10⁻⁴ from a sample, and above it by ω² (h/2)²/2 = 4.1·10⁻⁶ of itself.
            let above = (seen - sampled) / seen;
            assert!(
                (-1e-12..4.1e-6).contains(&above),
                "{number}, {i}: {seen} for {sampled}, above by {above:e}"
            );
        }
        events += motion.events.len();
    }
    assert!(events > 200 && differences > 800_000, "{events} events, {differences} differences");
}

#[test]
fn what_a_base_must_be() {
    let one = || vec![vec![1.0]];
    let model = Model { mass: one(), damping: one(), stiffness: one(), ..Model::default() };
    let system = System::new(&model).expect("valid");
    let good = Base { influence: vec![1.0], acceleration: Signal::constant(0.0) };
    let by = |signal: Signal<f64>| Base { acceleration: signal, ..good.clone() };
    for (base, due) in [
        (Base { influence: vec![], ..good.clone() }, "base: influence has 0 entries, but must have 1"),
        (Base { influence: vec![f64::NAN], ..good.clone() }, "base: influence[1] = NaN must be finite"),
        (
            by(Signal { records: vec![1.0], ..Signal::constant(0.0) }),
            "base: acceleration.records has 1 entries, but must have 0",
        ),
        (
            by(Signal { sin: vec![1.0], ..Signal::constant(0.0) }),
            "base: acceleration.sin has 1 entries, but must have 0",
        ),
    ] {
        assert_eq!(system.clone().with_base(&base).expect_err("wrong").to_string(), due);
    }
}
