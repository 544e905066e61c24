//! The same cases at 128 bits, to 20 digits; steady motions and random systems at 128 bits beside 192.

use crate::cases::{cases, number, start, text};
use stickslip::Float;
use stickslip::float::{Field, Mp};
use stickslip::system::{
    Element, Harmonic, Kind, Law, Model, Normal, Record, Signal, State, SteadyKind, System,
};

type Wide = Mp<2>;

fn list<F: Float>(list: &[f64]) -> Vec<F> {
    list.iter().map(|&x| F::from_f64(x)).collect()
}

fn rows<F: Float>(rows: &[Vec<f64>]) -> Vec<Vec<F>> {
    rows.iter().map(|row| list(row)).collect()
}

fn signal<F: Float>(signal: &Signal<f64>) -> Signal<F> {
    Signal { constant: F::from_f64(signal.constant), sin: list(&signal.sin), cos: list(&signal.cos) }
}

fn element<F: Float>(element: &Element<f64>) -> Element<F> {
    let of = F::from_f64;
    let kind = match &element.kind {
        Kind::Contact { law, peak, normal } => Kind::Contact {
            law: Law { points: law.points.iter().map(|&(v, r)| (of(v), of(r))).collect() },
            peak: of(*peak),
            normal: normal
                .as_ref()
                .map(|n| Normal { signal: signal(&n.signal), displacement: list(&n.displacement) }),
        },
        Kind::Elastic { stiffness, friction } => {
            Kind::Elastic { stiffness: of(*stiffness), friction: of(*friction) }
        }
        Kind::Stop { gap, stiffness, damping } => {
            Kind::Stop { gap: of(*gap), stiffness: of(*stiffness), damping: of(*damping) }
        }
    };
    let (name, direction) = (element.name.clone(), list(&element.direction));
    Element { name, direction, moves: signal(&element.moves), kind }
}

fn model<F: Float>(given: &Model<f64>) -> Model<F> {
    let harmonic = |h: &Harmonic<f64>| Harmonic {
        frequency: F::from_f64(h.frequency),
        sin: list(&h.sin),
        cos: list(&h.cos),
    };
    let record =
        |r: &Record<f64>| Record { times: list(&r.times), values: list(&r.values), force: list(&r.force) };
    Model {
        mass: rows(&given.mass),
        damping: rows(&given.damping),
        stiffness: rows(&given.stiffness),
        elements: given.elements.iter().map(element).collect(),
        constant: list(&given.constant),
        harmonics: given.harmonics.iter().map(harmonic).collect(),
        records: given.records.iter().map(record).collect(),
    }
}

fn state<F: Float>(given: &State<f64>) -> State<F> {
    let [displacement, velocity, force] =
        [&given.displacement, &given.velocity, &given.force].map(|l| list(l));
    State { displacement, velocity, force }
}

/// The largest difference of two states, relative to the largest value.
fn difference(a: &State<Mp<2>>, b: &State<Mp<3>>) -> f64 {
    let pairs = || a.displacement.iter().zip(&b.displacement).chain(a.velocity.iter().zip(&b.velocity));
    let size = pairs().map(|(_, b)| b.to_f64().abs()).fold(1e-3, f64::max);
    // The decimal digits of the narrower number, read at the wider precision.
    let wider = |x: &Mp<2>| x.to_string().parse::<Mp<3>>().expect("digits");
    pairs().map(|(a, &b)| (wider(a) - b).to_f64().abs()).fold(0.0, f64::max) / size
}

/// Steady motions found at 128 bits are those found at 192 bits, to 20 digits.
#[test]
fn steady_motions() {
    let mut count = 0;
    let chosen = [
        "two-masses-contact-between",
        "four-masses-two-contacts",
        "normal-load-varies",
        "elastic-stop",
        "random-1007",
    ];
    for case in cases().into_iter().filter(|c| chosen.contains(&c.name.as_str())) {
        let n = case.model.mass.len();
        let narrow = System::new(&model::<Mp<2>>(&case.model))
            .expect("valid")
            .steady(&State::rest(n))
            .expect("it settles");
        let wide = System::new(&model::<Mp<3>>(&case.model))
            .expect("valid")
            .steady(&State::rest(n))
            .expect("it settles");
        assert_eq!((narrow.kind, wide.kind), (SteadyKind::Periodic, SteadyKind::Periodic), "{}", case.name);
        let by = difference(&narrow.start, &wide.start);
        assert!(by < 1e-20, "{}: by {by:e}", case.name);
        count += 1;
    }
    assert_eq!(count, chosen.len());
}

/// Random systems at 128 bits end where they do at 192 bits, with the same events.
#[cfg(feature = "generators")]
#[test]
fn random_systems() {
    use arbitrary::{Arbitrary, Unstructured};
    use stickslip::generators::Structure;

    let (mut events, mut seed) = (0, 1_u64);
    for number in 0..6 {
        let mut byte = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 56) as u8
        };
        let bytes: Vec<u8> = (0..900).map(|_| byte()).collect();
        let Structure { model: given, start, until } =
            Structure::arbitrary(&mut Unstructured::new(&bytes)).unwrap();
        let narrow = System::new(&model::<Mp<2>>(&given))
            .and_then(|s| s.simulate(&state(&start), Float::from_f64(until)))
            .expect("it moves");
        let wide = System::new(&model::<Mp<3>>(&given))
            .and_then(|s| s.simulate(&state(&start), Float::from_f64(until)))
            .expect("it moves");
        let kinds = |e: &stickslip::system::Event<Mp<2>>| (e.element, e.kind);
        let seen: Vec<_> = narrow.events.iter().map(kinds).collect();
        let expected: Vec<_> = wide.events.iter().map(|e| (e.element, e.kind)).collect();
        assert_eq!(seen.len(), expected.len(), "{number}: {seen:?} for {expected:?}");
        let by = difference(&narrow.end, &wide.end);
        assert!(by < 1e-20, "{number}: by {by:e}");
        events += seen.len();
    }
    assert!(events > 30, "{events}");
}

#[test]
fn transient_motions() {
    let mut count = 0;
    for case in cases().into_iter().filter(|c| c.run["kind"] == "transient") {
        let (model, start) = (model::<Wide>(&case.model), state(&start(&case)));
        let until = Wide::from_f64(number(&case.run["until"]));
        let motion = System::new(&model).expect("valid").simulate(&start, until).expect(&case.name);
        let expected: Vec<Wide> = case.answer["events"]
            .as_array()
            .expect("events")
            .iter()
            .map(|e| text(&e[0]).parse().expect("digits"))
            .collect();
        // The reference of this case has π/2 and e^−2v with all their digits, the file has doubles of them. The falling law
        // multiplies their rounding by e^(15 t) while the speed is low, some 10⁶.
        let allowed = if case.name == "modelica-friction-table" { 1e-10 } else { 1e-20 };
        let close = |seen: Wide, value: Wide, size: Wide| (Field::abs(seen - value) / size).to_f64();
        assert_eq!(motion.events.len(), expected.len(), "{}", case.name);
        for (event, &time) in motion.events.iter().zip(&expected) {
            let by = close(event.time, time, until);
            assert!(by < allowed, "{}: {event:?} by {by:e}", case.name);
        }
        for (name, seen) in [("displacement", &motion.end.displacement), ("velocity", &motion.end.velocity)] {
            let values = case.answer[name].as_array().expect("a list");
            for (&seen, value) in seen.iter().zip(values) {
                let value: Wide = text(value).parse().expect("digits");
                let by = close(seen, value, Wide::from_f64(1.0));
                assert!(by < allowed, "{}: {name} by {by:e}", case.name);
            }
        }
        count += 1;
    }
    assert_eq!(count, 6);
}
