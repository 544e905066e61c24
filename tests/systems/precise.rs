//! The same cases at 128 bits, to 20 digits; steady motions and random systems at 128 bits beside 192.

#![allow(clippy::print_stdout, reason = "the counts of a campaign are shown with --nocapture")]

use crate::cases::{cases, number, start, text};
use crate::generator::Random;
use stickslip::Float;
use stickslip::float::{Field, Mp};
use stickslip::system::{
    Element, Harmonic, Kind, Law, Model, Motion, Moved, Normal, Record, Signal, State, SteadyKind, System,
};

type Wide = Mp<2>;

fn list<F: Float>(list: &[f64]) -> Vec<F> {
    list.iter().map(|&x| F::from_f64(x)).collect()
}

fn rows<F: Float>(rows: &[Vec<f64>]) -> Vec<Vec<F>> {
    rows.iter().map(|row| list(row)).collect()
}

fn signal<F: Float>(signal: &Signal<f64>) -> Signal<F> {
    Signal {
        constant: F::from_f64(signal.constant),
        sin: list(&signal.sin),
        cos: list(&signal.cos),
        records: list(&signal.records),
        rates: list(&signal.rates),
    }
}

fn of_normal<F: Float>(normal: &Normal<f64>) -> Normal<F> {
    Normal {
        signal: signal(&normal.signal),
        displacement: list(&normal.displacement),
        velocity: list(&normal.velocity),
    }
}

fn element<F: Float>(element: &Element<f64>) -> Element<F> {
    let of = F::from_f64;
    let kind = match &element.kind {
        Kind::Contact { law, peak, normal } => Kind::Contact {
            law: Law { points: law.points.iter().map(|&(v, r)| (of(v), of(r))).collect() },
            peak: of(*peak),
            normal: normal.as_ref().map(of_normal),
        },
        Kind::Elastic { stiffness, friction, normal } => Kind::Elastic {
            stiffness: of(*stiffness),
            friction: of(*friction),
            normal: normal.as_ref().map(of_normal),
        },
        Kind::Stop { gap, stiffness, damping } => {
            Kind::Stop { gap: of(*gap), stiffness: of(*stiffness), damping: of(*damping) }
        }
        Kind::Spring { points } => {
            Kind::Spring { points: points.iter().map(|&(y, force)| (of(y), of(force))).collect() }
        }
        Kind::UnderStop { stop, coefficient, peak } => {
            Kind::UnderStop { stop: *stop, coefficient: of(*coefficient), peak: of(*peak) }
        }
        Kind::HardStop { gap, restitution } => {
            Kind::HardStop { gap: of(*gap), restitution: of(*restitution) }
        }
    };
    let (name, direction) = (element.name.clone(), list(&element.direction));
    Element { name, direction, moves: signal(&element.moves), kind }
}

pub(crate) fn model<F: Float>(given: &Model<f64>) -> Model<F> {
    let harmonic = |h: &Harmonic<f64>| Harmonic {
        frequency: F::from_f64(h.frequency),
        sin: list(&h.sin),
        cos: list(&h.cos),
    };
    let record = |r: &Record<f64>| Record {
        times: list(&r.times),
        values: list(&r.values),
        force: list(&r.force),
        beyond: r.beyond,
    };
    let moved = |m: &Moved<f64>| Moved { coordinate: m.coordinate, by: m.by, signal: signal(&m.signal) };
    Model {
        coordinates: Vec::new(),
        mass: rows(&given.mass),
        damping: rows(&given.damping),
        stiffness: rows(&given.stiffness),
        elements: given.elements.iter().map(element).collect(),
        constant: list(&given.constant),
        harmonics: given.harmonics.iter().map(harmonic).collect(),
        records: given.records.iter().map(record).collect(),
        moved: given.moved.iter().map(moved).collect(),
        levels: Vec::new(),
    }
}

pub(crate) fn state<F: Float>(given: &State<f64>) -> State<F> {
    let [displacement, velocity, force] =
        [&given.displacement, &given.velocity, &given.force].map(|l| list(l));
    State { displacement, velocity, force, absolute_acceleration: vec![] }
}

/// The largest difference of two states, relative to the largest value.
fn difference(a: &State<Mp<2>>, b: &State<Mp<4>>) -> f64 {
    let pairs = || a.displacement.iter().zip(&b.displacement).chain(a.velocity.iter().zip(&b.velocity));
    let size = pairs().map(|(_, b)| b.to_f64().abs()).fold(1e-3, f64::max);
    // The decimal digits of the narrower number, read at the wider precision.
    let wider = |x: &Mp<2>| x.to_string().parse::<Mp<4>>().expect("digits");
    pairs().map(|(a, &b)| (wider(a) - b).to_f64().abs()).fold(0.0, f64::max) / size
}

/// Steady motions found at 128 bits are those found at 256 bits, to 20 digits.
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
        let wide = System::new(&model::<Mp<4>>(&case.model))
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

/// Random systems at 128 bits end where they do at 256 bits, with the same events, and obey every element's law at dense samples
/// of their motion, to 20 digits: an event that was missed would break one.
#[cfg(feature = "generators")]
#[test]
fn random_systems() {
    use arbitrary::{Arbitrary, Unstructured};
    use stickslip::generators::Structure;

    let (mut events, mut sampled, mut random) = (0, 0, Random(1));
    for number in 0..crate::count(6, 300) {
        let bytes: Vec<u8> = (0..900).map(|_| random.byte()).collect();
        let Structure { model: given, start, until } =
            Structure::arbitrary(&mut Unstructured::new(&bytes)).unwrap();
        let narrow = System::new(&model::<Mp<2>>(&given))
            .and_then(|s| s.simulate(&state(&start), Float::from_f64(until)))
            .expect("it moves");
        let wide = System::new(&model::<Mp<4>>(&given))
            .and_then(|s| s.simulate(&state(&start), Float::from_f64(until)))
            .expect("it moves");
        let (seen, expected) = (told(&narrow), told(&wide));
        assert_eq!(seen.len(), expected.len(), "{number}: {seen:?} for {expected:?}");
        let by = difference(&narrow.end, &wide.end);
        assert!(by < 1e-20, "{number}: by {by:e}");
        events += seen.len();
        sampled += laws_hold(&given, &start, until, &narrow.events);
    }
    println!("{events} events, {sampled} states at 128 bits");
    assert!(events > 30 && sampled > 2_000, "{events} events, {sampled} states");
}

/// The events without those of ever smaller blows at their end, of which more are told with more bits.
#[cfg(feature = "generators")]
fn told<F: Float>(motion: &Motion<F>) -> Vec<(usize, stickslip::system::EventKind)> {
    use stickslip::system::EventKind::Close;
    let mut ending = None;
    let is_told = |event: &&stickslip::system::Event<F>| {
        if event.velocities.is_some_and(|(before, _)| before.to_f64() < 1e-12) {
            ending = Some(event.element);
        }
        if ending == Some(event.element) && event.kind == Close {
            ending = None;
        }
        ending.is_none()
    };
    motion.events.iter().filter(is_told).map(|event| (event.element, event.kind)).collect()
}

/// The laws at samples between the events of a motion at 128 bits: how many samples there are.
#[cfg(feature = "generators")]
fn laws_hold(
    given: &Model<f64>,
    start: &State<f64>,
    until: f64,
    events: &[stickslip::system::Event<Wide>],
) -> usize {
    use crate::random::systems::broken;
    let model = model::<Wide>(given);
    let count = i32::try_from(crate::count(500, 2_000)).expect("few");
    let end = Wide::from_f64(until);
    let times: Vec<Wide> =
        (1..count).map(|i| end * Wide::from_f64(f64::from(i)) / Wide::from_f64(f64::from(count))).collect();
    let system = System::new(&model).expect("valid");
    let states = system.states(&state(start), &times).expect("it moves");
    let near = end * Wide::exp2i(-30);
    let apart = |time: Wide| events.iter().all(|e| Field::abs(e.time - time) > near);
    let mut seen = 0;
    for (state, &time) in states.iter().zip(&times).filter(|(_, time)| apart(**time)) {
        for (element, &force) in model.elements.iter().zip(&state.force) {
            let fault = broken(element, &model, time, state, force, Wide::from_f64(1e-20));
            assert!(fault.is_none(), "{} at {time}: {fault:?}", element.name);
        }
        seen += 1;
    }
    seen
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

/// A matrix by rows, for the search below.
type Rows<F> = Vec<Vec<F>>;

fn product<F: Float>(a: &Rows<F>, b: &Rows<F>) -> Rows<F> {
    let zero = F::int(0);
    let entry = |row: &Vec<F>, j: usize| row.iter().zip(b).fold(zero, |sum, (&x, other)| sum + x * other[j]);
    a.iter().map(|row| (0..b[0].len()).map(|j| entry(row, j)).collect()).collect()
}

fn applied<F: Float>(a: &Rows<F>, x: &[F]) -> Vec<F> {
    a.iter().map(|row| row.iter().zip(x).fold(F::int(0), |sum, (&a, &x)| sum + a * x)).collect()
}

/// e^{At}: the series at t/2¹⁶, squared sixteen times.
fn exponential<F: Float>(a: &Rows<F>, time: F) -> Rows<F> {
    let d = a.len();
    let unit = |i: usize, j: usize| F::int(i32::from(i == j));
    let mut sum: Rows<F> = (0..d).map(|i| (0..d).map(|j| unit(i, j)).collect()).collect();
    let mut term = sum.clone();
    let small = time * F::exp2i(-16);
    for k in 1..=24 {
        term = product(a, &term);
        for (row, total) in term.iter_mut().zip(&mut sum) {
            for (x, y) in row.iter_mut().zip(total) {
                *x = *x * small / F::int(k);
                *y = *y + *x;
            }
        }
    }
    (0..16).for_each(|_| sum = product(&sum, &sum));
    sum
}

/// Gauss's elimination with the largest pivot of each column.
fn solution<F: Float>(mut a: Rows<F>, mut y: Vec<F>) -> Vec<F> {
    let d = y.len();
    for k in 0..d {
        let size = |i: usize| Field::abs(a[i][k]).to_f64();
        let best = (k..d).max_by(|&i, &j| size(i).total_cmp(&size(j))).expect("a row");
        a.swap(k, best);
        y.swap(k, best);
        for i in (0..d).filter(|&i| i != k) {
            let pivot = a[k].clone();
            let factor = a[i][k] / pivot[k];
            for (x, p) in a[i].iter_mut().zip(pivot).skip(k) {
                *x = *x - factor * p;
            }
            y[i] = y[i] - factor * y[k];
        }
    }
    (0..d).map(|k| y[k] / a[k][k]).collect()
}

/// The least load of a structure with diagonal masses, by dense samples of `[v(τ) − v_f cos ωτ]/(ω sin ωτ)` and of ever
/// denser ones about the greatest.
fn sampled_border<F: Float>(given: &Model<f64>) -> F {
    let model = model::<F>(given);
    let (n, zero) = (model.mass.len(), F::int(0));
    let (b, omega) = (&model.elements[0].direction, model.harmonics[0].frequency);
    let Kind::Contact { law, peak, .. } = &model.elements[0].kind else { panic!("a contact") };
    let friction = law.points[0].1;
    let dot = |x: &[F]| b.iter().zip(x).fold(zero, |sum, (&b, &x)| sum + b * x);
    let d = 2 * n + 1;
    let mut a = vec![vec![zero; d]; d];
    for i in 0..n {
        a[i][n + i] = F::int(1);
        for j in 0..n {
            a[n + i][j] = -model.stiffness[i][j] / model.mass[i][i];
            a[n + i][n + j] = -model.damping[i][j] / model.mass[i][i];
        }
        // After the reversal at which y is greatest the friction pushes on.
        a[n + i][2 * n] = b[i] * friction / model.mass[i][i];
    }
    let half = F::pi() / omega;
    // Half a period turns the friction's part round.
    let whole = exponential(&a, half);
    let sum = |i: usize, j: usize| F::int(i32::from(i == j)) + whole[i][j];
    let matrix = (0..2 * n).map(|i| (0..2 * n).map(|j| sum(i, j)).collect()).collect();
    let mut start = solution(matrix, (0..2 * n).map(|i| -whole[i][2 * n]).collect());
    start.push(F::int(1));
    let turned = dot(&start[n..2 * n]);
    let mut stiff = vec![vec![zero; 2 * n]; 2 * n];
    for i in 0..n {
        for j in 0..n {
            let elastic = model.stiffness[i][j] - omega * omega * model.mass[i][j];
            (stiff[i][j], stiff[n + i][n + j]) = (elastic, elastic);
            (stiff[i][n + j], stiff[n + i][j]) = (-omega * model.damping[i][j], omega * model.damping[i][j]);
        }
    }
    let waves = solution(stiff, [&model.harmonics[0].sin[..], &model.harmonics[0].cos[..]].concat());
    let amplitude = dot(&waves[..n]).hypot(dot(&waves[n..]));
    let quotient = |time: F, state: &[F]| {
        let (sin, cos) = (omega * time).sin_cos();
        (dot(&state[n..2 * n]) - turned * cos) / (omega * sin)
    };
    let rate = applied(&a, &start);
    let inertia = b.iter().zip(0..n).fold(zero, |sum, (&b, i)| sum + b * b / model.mass[i][i]);
    let mut least = (dot(&rate[n..2 * n]) + (*peak - F::int(1)) * friction * inertia) / (omega * omega);
    let (mut from, mut at, mut step, mut count) = (zero, start, half / F::int(400), 400);
    for _ in 0..34 {
        let on = exponential(&a, step);
        let mut best: Option<(F, F, Vec<F>)> = None;
        let mut state = at.clone();
        for i in 1..count {
            let next = applied(&on, &state);
            let value = quotient(from + step * F::int(i), &next);
            if best.as_ref().is_none_or(|(most, ..)| value > *most) {
                best = Some((value, from + step * F::int(i - 1), state.clone()));
            }
            state = next;
        }
        let Some((value, place, state)) = best else { break };
        least = if value > least { value } else { least };
        (from, at, step, count) = (place, state, step / F::int(4), 8);
    }
    least.hypot(turned / omega) / amplitude
}

/// The border at 128 bits is that of a dense search at 256 bits, and that of doubles to their rounding: at the reversal, within
/// the half period, and with a static friction of its own.
#[test]
fn the_border_at_128_bits() {
    use crate::closed_form::structure;
    let mut random = Random(12);
    let mut seen = [0; 2];
    while seen.iter().any(|&count| count < 3) {
        let mut given = structure(&mut random);
        if let Kind::Contact { peak, .. } = &mut given.elements[0].kind {
            *peak = if random.next() < 0.5 { 1.0 } else { 1.25 };
        }
        let double = System::new(&given).and_then(|s| s.border()).expect("one contact");
        let place = usize::from(double.touching_time > 0.0);
        if seen[place] == 3 {
            continue;
        }
        seen[place] += 1;
        let narrow = System::new(&model::<Wide>(&given)).and_then(|s| s.border()).expect("one contact");
        let due = sampled_border::<Mp<4>>(&given);
        let wide = narrow.least_load_factor.to_string().parse::<Mp<4>>().expect("digits");
        let by = (Field::abs(wide - due) / due).to_f64();
        // 2⁻¹²⁸ is 3e-39; the sums of the half period and the solutions lose some digits.
        assert!(by < 1e-33, "{seen:?}: 128 bits by {by:e}");
        let by = double.least_load_factor / due.to_f64() - 1.0;
        assert!(by.abs() < 1e-11, "{seen:?}: doubles by {by:e}");
    }
}

/// The growth of a disturbance on the way to a motion is that of the distance of two motions, so near at first that they stay near.
#[test]
fn the_growth_of_a_disturbance_is_that_of_two_motions_apart() {
    let given = crate::verdicts::striking([0.12, 0.04, 0.1, 0.81], 2.5);
    let found = System::new(&given).unwrap().steady(&State::rest(1)).unwrap();
    assert_eq!((found.kind, found.periods), (SteadyKind::Periodic, 8));
    let system = System::new(&model::<Mp<4>>(&given)).unwrap();
    let period = Mp::from_f64(found.period) / Mp::from_f64(8.0);
    let times = |count: usize| (0..=count).map(|i| period * Mp::from_f64(i as f64)).collect::<Vec<_>>();
    let from = system.states(&State::rest(1), &times(8)).unwrap().pop().unwrap();
    let mut other = from.clone();
    other.displacement[0] += Mp::from_f64(1e-50);
    other.velocity[0] -= Mp::from_f64(1.7e-50);
    let both = [from, other].map(|start| system.states(&start, &times(found.followed - 8)).unwrap());
    let apart = both[0].iter().zip(&both[1]).map(|(a, b)| {
        let by = |a: Mp<4>, b: Mp<4>| (a - b).to_f64();
        by(a.displacement[0], b.displacement[0]).hypot(by(a.velocity[0], b.velocity[0]))
    });
    let (mut smallest, mut growth) = (f64::INFINITY, 1.0_f64);
    for by in apart {
        smallest = smallest.min(by);
        growth = growth.max(by / smallest);
    }
    // The units of the disturbance are the sizes of each period, which differ by a few times.
    let by = found.disturbance_growth / growth;
    assert!(growth > 1e8 && (0.1..10.0).contains(&by), "{growth:e} {:e}", found.disturbance_growth);
}

/// How far a motion from rest is from that at 128 bits: its end, greatest velocities, forces and works, in parts of the greatest of each. None where 128 bits have other events, or nothing
/// moves but by rounding.
pub(crate) fn far(until: f64, found: &Motion<f64>, truth: &Motion<Wide>) -> Option<f64> {
    let due = truth.events.iter().map(|e| (e.element, e.kind));
    if !found.events.iter().map(|e| (e.element, e.kind)).eq(due) {
        return None;
    }
    let sizes = |lists: [&[Wide]; 2]| lists.concat().iter().map(|x| x.to_f64().abs()).fold(0.0, f64::max);
    let reach = sizes([&truth.max_displacement, &truth.min_displacement]);
    if reach < 1e-15 {
        return None;
    }
    // The velocity of a machine that has hardly moved is rounding.
    let speed = sizes([&truth.max_velocity, &truth.min_velocity]).max(reach / until);
    let works = [found.load_work, found.damper_work];
    let works: Vec<f64> = found.elements.iter().map(|e| e.work).chain(works).collect();
    let due = [truth.load_work, truth.damper_work];
    let due: Vec<Wide> = truth.elements.iter().map(|e| e.work).chain(due).collect();
    let (force, work) = (sizes([&truth.end.force, &[]]), sizes([&due, &[]]));
    let pairs = [
        (&found.end.displacement, &truth.end.displacement, reach),
        (&found.end.velocity, &truth.end.velocity, speed),
        (&found.max_velocity, &truth.max_velocity, speed),
        (&found.min_velocity, &truth.min_velocity, speed),
        (&found.end.force, &truth.end.force, force),
        (&works, &due, work),
    ];
    let by = pairs.map(|(a, b, size)| {
        let far = a.iter().zip(b).map(|(&a, &b)| (Wide::from_f64(a) - b).to_f64().abs());
        far.fold(0.0, f64::max) / size.max(1e-300)
    });
    Some(by.into_iter().fold(0.0, f64::max))
}

/// The motion from rest at 128 bits.
pub(crate) fn truth(given: &Model<f64>, until: f64) -> Option<Motion<Wide>> {
    let wide = System::<Wide>::new(&model(given)).expect("valid");
    wide.simulate(&State::rest(given.mass.len()), Wide::from_f64(until)).ok()
}

/// Stiff machines, with steps that their fast modes do not shorten: within 10⁻¹⁰ of the motion at 128 bits, or within four times what short
/// steps are off by, where the motion multiplies rounding.
#[test]
fn long_steps_are_as_near_to_the_motion_as_short_ones() {
    let mut random = Random(87);
    let (mut compared, mut worst) = (0, [0.0_f64; 2]);
    for number in 0..crate::count(24, 300) {
        let given = crate::long_steps::stiff(&mut random);
        let system = System::new(&given).expect("valid");
        let (n, until) = (given.mass.len(), 1.5);
        if system.steps_per_time() * until > 6_000.0 || !system.has_long_steps(until) {
            continue;
        }
        let Some(truth) = truth(&given, until) else { continue };
        let far = |system: &System<f64>| {
            far(until, &system.simulate(&State::rest(n), until).expect("it moves"), &truth)
        };
        let (long, short) = (far(&system), far(&system.clone().by_short_steps()));
        let Some(short) = short else { continue };
        let long = long.unwrap_or_else(|| panic!("{number}: other events\n{given:?}"));
        assert!(long < 1e-10_f64.max(4.0 * short), "{number}: {long:?} {short:?}\n{given:?}");
        compared += 1;
        worst = [worst[0].max(long), worst[1].max(short)];
    }
    println!(
        "{compared} stiff machines at 128 bits: long steps are off by {:e}, short ones by {:e}",
        worst[0], worst[1]
    );
    assert!(compared >= crate::count(6, 80), "{compared}");
}
