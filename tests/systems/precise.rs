//! The same cases at 128 bits, to 20 digits.

use crate::cases::{cases, text};
use stickslip::Float;
use stickslip::float::{Field, Mp};
use stickslip::system::{Element, Harmonic, Kind, Law, Model, Record, Signal, State, System};

type Wide = Mp<2>;

fn wide(list: &[f64]) -> Vec<Wide> {
    list.iter().map(|&x| Wide::from_f64(x)).collect()
}

fn rows(rows: &[Vec<f64>]) -> Vec<Vec<Wide>> {
    rows.iter().map(|row| wide(row)).collect()
}

fn signal(signal: &Signal<f64>) -> Signal<Wide> {
    Signal { constant: Wide::from_f64(signal.constant), sin: wide(&signal.sin), cos: wide(&signal.cos) }
}

fn element(element: &Element<f64>) -> Element<Wide> {
    let of = Wide::from_f64;
    let kind = match &element.kind {
        Kind::Contact { law, peak, normal: None } => Kind::Contact {
            law: Law { points: law.points.iter().map(|&(v, r)| (of(v), of(r))).collect() },
            peak: of(*peak),
            normal: None,
        },
        Kind::Elastic { stiffness, friction } => {
            Kind::Elastic { stiffness: of(*stiffness), friction: of(*friction) }
        }
        Kind::Stop { gap, stiffness, damping } => {
            Kind::Stop { gap: of(*gap), stiffness: of(*stiffness), damping: of(*damping) }
        }
        Kind::Contact { .. } => unreachable!("transient cases have constant normal loads"),
    };
    Element {
        name: element.name.clone(),
        direction: wide(&element.direction),
        moves: signal(&element.moves),
        kind,
    }
}

#[test]
fn transient_motions() {
    let mut count = 0;
    for case in cases().into_iter().filter(|c| c.run["kind"] == "transient") {
        let given = &case.model;
        let model = Model {
            mass: rows(&given.mass),
            damping: rows(&given.damping),
            stiffness: rows(&given.stiffness),
            elements: given.elements.iter().map(element).collect(),
            constant: vec![],
            harmonics: given
                .harmonics
                .iter()
                .map(|h| Harmonic {
                    frequency: Wide::from_f64(h.frequency),
                    sin: wide(&h.sin),
                    cos: wide(&h.cos),
                })
                .collect(),
            records: given
                .records
                .iter()
                .map(|r| Record { times: wide(&r.times), values: wide(&r.values), force: wide(&r.force) })
                .collect(),
        };
        let start = crate::cases::start(&case);
        let start =
            State { displacement: wide(&start.displacement), velocity: wide(&start.velocity), force: vec![] };
        let until = Wide::from_f64(crate::cases::number(&case.run["until"]));
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
