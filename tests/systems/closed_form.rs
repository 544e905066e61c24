//! One contact and one harmonic load: the closed form and its border, against the paper's and the motion.

use crate::generator::Random;
use stickslip::system::{Element, Harmonic, Kind, Law, Model, Signal, State, SteadyKind, System};
use stickslip::{Ratios, Response};

pub(crate) fn contact(direction: Vec<f64>, friction: f64, peak: f64) -> Element<f64> {
    let kind = Kind::Contact { law: Law::constant(friction), peak, normal: None };
    Element { name: "contact".into(), direction, moves: Signal::constant(0.0), kind }
}

/// The machine of the ratios Ω, α, ζ, η in natural time and units of B.
pub(crate) fn one_body(omega: f64, alpha: f64, damping: f64, peak: f64) -> Model<f64> {
    Model {
        mass: vec![vec![1.0]],
        damping: vec![vec![2.0 * damping]],
        stiffness: vec![vec![1.0]],
        elements: vec![contact(vec![1.0], 1.0, peak)],
        harmonics: vec![Harmonic { frequency: omega, sin: vec![alpha], cos: vec![] }],
        ..Model::default()
    }
}

#[test]
fn one_body_is_the_papers() {
    let mut random = Random(1);
    let mut interior = 0;
    for _ in 0..400 {
        let omega = (random.between(0.15_f64.ln(), 6.0_f64.ln())).exp();
        // Interior borders need a light damper.
        let damping = if random.next() < 0.5 { random.between(0.0, 0.6) } else { random.between(0.0, 0.02) };
        let (damping, peak) = (damping, 1.0 + random.next() * random.between(0.0, 1.0));
        let ratios = Ratios::new(omega, 1.0)
            .and_then(|r| r.with_damping_ratio(damping))
            .and_then(|r| r.with_static_friction_ratio(peak))
            .expect("valid ratios");
        let least = Response::new(ratios).border.min_force_ratio;
        let system = System::new(&one_body(omega, 1.0, damping, peak)).expect("valid");
        let border = system.border().expect("one contact");
        interior += usize::from(border.touching_time > 0.0);
        let by = (border.least_load_factor / least - 1.0).abs();
        assert!(by < 1e-11, "Ω = {omega}, ζ = {damping}, η = {peak}: border by {by:e}");
        let alpha = least * random.between(1.01, 4.0);
        let ratios =
            Ratios::new(omega, alpha).and_then(|r| r.with_damping_ratio(damping)).expect("valid ratios");
        let Some(cycle) = Response::new(ratios).cycle else { continue };
        let found =
            System::new(&one_body(omega, alpha, damping, peak)).expect("valid").cycle().expect("one contact");
        let found = found.expect("a cycle above the border");
        for (name, seen, expected) in [
            ("Δ₀", found.max_displacement, cycle.max_displacement),
            ("t₂", found.displacement_time * omega, cycle.displacement_phase),
            ("V₀", found.max_velocity, cycle.max_velocity * omega),
        ] {
            let by = (seen / expected - 1.0).abs();
            assert!(by < 1e-10, "Ω = {omega}, α = {alpha}, ζ = {damping}: {name} {seen} for {expected}");
        }
    }
    assert!(interior > 20, "{interior} borders within the half cycle");
}

/// A chain of bodies with springs and dampers, all of them different, and a contact somewhere.
pub(crate) fn structure(random: &mut Random) -> Model<f64> {
    let n = 2 + usize::from(random.next() < 0.5) + usize::from(random.next() < 0.3);
    let mut zero = vec![vec![0.0; n]; n];
    let (mut mass, mut damping) = (zero.clone(), zero.clone());
    for i in 0..n {
        mass[i][i] = random.between(0.5, 3.0);
        let (k, c) = (random.between(1.0, 9.0), random.between(0.05, 0.4));
        for (matrix, x) in [(&mut zero, k), (&mut damping, c)] {
            matrix[i][i] += x;
            if i > 0 {
                matrix[i - 1][i - 1] += x;
                matrix[i - 1][i] -= x;
                matrix[i][i - 1] -= x;
            }
        }
    }
    // Springs and dampers lead from each body to the one before; the first is held by the ground.
    let at = (random.next() * n as f64) as usize;
    let mut direction = vec![0.0; n];
    direction[at] = 1.0;
    if at > 0 && random.next() < 0.5 {
        direction[at - 1] = -1.0;
    }
    let sin = (0..n).map(|_| random.between(-1.0, 1.0)).collect();
    let cos = (0..n).map(|_| random.between(-1.0, 1.0)).collect();
    Model {
        mass,
        damping,
        stiffness: zero,
        elements: vec![contact(direction, random.between(0.2, 1.0), 1.0)],
        harmonics: vec![Harmonic { frequency: random.between(0.3, 4.0), sin, cos }],
        ..Model::default()
    }
}

/// Three hundred structures, or ten times as many: a little above the border nothing sticks, a little below it does.
#[test]
fn the_border_divides() {
    let mut random = Random(2);
    for number in 0..crate::count(300, 3_000) {
        let model = structure(&mut random);
        let border = System::new(&model).and_then(|s| s.border()).expect("one contact");
        for (factor, sticks) in [(1.001, false), (0.999, true)] {
            let mut model = model.clone();
            for harmonic in &mut model.harmonics {
                for force in harmonic.sin.iter_mut().chain(&mut harmonic.cos) {
                    *force *= factor * border.least_load_factor;
                }
            }
            let system = System::new(&model).expect("valid");
            let steady = system.steady(&State::rest(system.coordinates())).expect("it settles");
            let element = &steady.motion.elements[0];
            // Below the border the contact sticks, or turns more than twice.
            let two = element.stops == 0 && steady.motion.events.len() == 2;
            assert_eq!(
                two, !sticks,
                "structure {number}, {factor}: {:?} {:?}",
                steady.kind, steady.motion.events
            );
            if !sticks {
                let cycle = system.cycle().expect("one contact").expect("a cycle");
                let by = element.work / cycle.work - 1.0;
                assert!(by.abs() < 1e-10, "structure {number}: work by {by:e}");
            }
        }
    }
}

/// The complex amplitudes `p/(k − mω² + icω)` of four hundred harmonics, one of them near the resonance.
#[test]
fn hundreds_of_harmonics_add_up() {
    let (m, c, k, slow, count) = (2.0, 3.0, 5000.0, 0.25, 400);
    let amplitude = |i: usize| 7.0 / (i as f64).sqrt();
    let mut harmonics = Vec::new();
    let (mut displacement, mut velocity) = (0.0, 0.0);
    for i in 1..=count {
        let (frequency, p) = (slow * i as f64, amplitude(i));
        // The load p sin ωt for odd numbers, p cos ωt for even ones.
        let is_sine = i % 2 == 1;
        let (sin, cos) = if is_sine { (vec![p], vec![]) } else { (vec![], vec![p]) };
        harmonics.push(Harmonic { frequency, sin, cos });
        let (real, imaginary) = (k - m * frequency * frequency, c * frequency);
        let size = real * real + imaginary * imaginary;
        // The parts of the answer in phase with the load, and a quarter behind it.
        let (with, behind) = (p * real / size, p * imaginary / size);
        displacement += if is_sine { -behind } else { with };
        velocity += frequency * if is_sine { with } else { behind };
    }
    let model = Model {
        mass: vec![vec![m]],
        damping: vec![vec![c]],
        stiffness: vec![vec![k]],
        harmonics,
        ..Model::default()
    };
    let system = System::new(&model).unwrap();
    let steady = system.steady(&State::rest(1)).unwrap();
    assert_eq!(steady.kind, SteadyKind::Periodic);
    let start = &steady.start;
    assert!(
        (start.displacement[0] / displacement - 1.0).abs() < 1e-11,
        "{} {displacement}",
        start.displacement[0]
    );
    assert!((start.velocity[0] / velocity - 1.0).abs() < 1e-11, "{} {velocity}", start.velocity[0]);
}
