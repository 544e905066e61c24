//! The exact motion: independent values, the closed forms, and the laws that every motion obeys.

mod limits;

use crate::random::Random;
use stickslip::motion::{End, Kind, LongRun, State, SteadyState, Trajectory};
use stickslip::{Border, Cycle, PhaseFunction, Ratios};

fn ratios(omega: f64, alpha: f64) -> Ratios<f64> {
    Ratios::new(omega, alpha).unwrap()
}

fn steady(omega: f64, alpha: f64) -> SteadyState<f64> {
    match LongRun::from_start(ratios(omega, alpha), State::default()).unwrap() {
        LongRun::Periodic(steady) => steady,
        other => panic!("({omega}, {alpha}): {other:?}"),
    }
}

/// A random start at (Ω, α), with x and v of the order of the motion.
fn start(random: &mut Random, omega: f64, alpha: f64) -> State<f64> {
    let reach = 2.0 * (1.0 + alpha) / (1.0 + omega * omega);
    let (x, v) = (random.between(-reach, reach), random.between(-reach, reach) / omega);
    State::new(random.between(0.0, 7.0), x, v).unwrap()
}

#[test]
fn reference_values_where_it_sticks() {
    for (omega, alpha, x, sticks, zeros, digits) in [
        (0.4, 6.0, 6.79382, 2, 4, 5e-6),
        (0.1, 3.0, 2.1600252446, 4, 4, 6e-11),
        (0.5, 2.0, 2.6068584084, 2, 2, 6e-11),
        (0.7, 1.2, 1.4174370977, 2, 2, 6e-11),
        (0.8, 1.1, 0.0565765889, 2, 2, 6e-11),
    ] {
        let s = steady(omega, alpha);
        assert!(
            (s.max_displacement.value - x).abs() < digits,
            "({omega}, {alpha}): {}",
            s.max_displacement.value
        );
        assert!((s.min_displacement.value + x).abs() < digits);
        assert_eq!((s.sticks_per_cycle, s.velocity_zeros_per_cycle), (sticks, zeros), "({omega}, {alpha})");
        // The motion itself reaches the limit: 500 cycles from rest, phase by phase.
        let motion = Trajectory::new(ratios(omega, alpha), State::default()).unwrap();
        let cycle: Vec<_> = motion
            .map(Result::unwrap)
            .skip_while(|p| p.start().phase.cycles() < 500)
            .take_while(|p| p.start().phase.cycles() < 501)
            .collect();
        let max = cycle.iter().map(|p| p.end().unwrap().x).fold(0.0, f64::max);
        assert!((max - s.max_displacement.value).abs() < 1e-13 * max, "({omega}, {alpha}): {max} {s:?}");
        assert_eq!(cycle.iter().filter(|p| p.kind == Kind::Stick).count() as u32, sticks);
        let rest: f64 = cycle.iter().filter(|p| p.kind == Kind::Stick).map(|p| p.duration().unwrap()).sum();
        assert!((rest / std::f64::consts::TAU - s.stick_fraction).abs() < 1e-12);
    }
}

#[test]
fn multipliers_at_a_known_point() {
    let [(re, im), (re2, im2)] = steady(0.7, 2.0).multipliers;
    assert!((re + 0.22240157).abs() < 1e-8 && (im.abs() - 0.13815796).abs() < 1e-8);
    assert_eq!((re2, im2), (re, -im));
}

/// The condition number of the problem itself. Rounding a state costs ε (1 + 1/Ω) of its size, and half a
/// turn leaves the fraction λ of any error, so that the errors accumulate to 1/(1 − λ); the closed form has
/// its own factor α²/(α² − K²).
fn condition(cycle: &Cycle<f64>) -> f64 {
    let (omega, alpha) = (cycle.ratios.omega(), cycle.ratios.alpha());
    let k = PhaseFunction::new(omega).unwrap().value();
    let size = cycle.max_displacement + cycle.max_velocity + alpha / (1.0 + omega * omega);
    let own = alpha * alpha / ((alpha - k) * (alpha + k));
    (1.0 + 1.0 / omega) * size / cycle.max_displacement / (1.0 - cycle.contraction()) + own
}

#[test]
fn the_closed_forms_where_it_does_not_stick() {
    let mut random = Random(3);
    let mut points = 0;
    let mut worst = [0.0f64; 2];
    while points < 12_000 {
        let omega = match points % 3 {
            0 => random.between(0.5, 2.5),
            1 => random.between(0.15, 1.1),
            _ => random.scale(0.5, 300.0),
        };
        let least = Border::new(omega).unwrap().min_force_ratio;
        let Ok(cycle) = Cycle::new(ratios(omega, least * random.scale(1.001, 20.0))) else { continue };
        let condition = condition(&cycle);
        // Near Ω = 1/n a motion never settles, and near 1/(2n+1) K is infinite.
        if cycle.contraction() > 1.0 - 1e-6 || condition > 1e8 {
            continue;
        }
        points += 1;
        let from = start(&mut random, omega, cycle.ratios.alpha());
        for (i, motion) in
            [LongRun::from_start(cycle.ratios, from).unwrap(), LongRun::try_from(&cycle).unwrap()]
                .iter()
                .enumerate()
        {
            let LongRun::Periodic(s) = motion else { panic!("{:?}: {motion:?}", cycle.ratios) };
            let x = s.max_displacement.value / cycle.max_displacement - 1.0;
            let v = s.max_velocity.value / cycle.max_velocity - 1.0;
            let error = x.abs().max(v.abs()) / (f64::EPSILON * condition);
            worst[i] = worst[i].max(error);
            assert!(error < 4.0, "{:?}: {x:e} {v:e} at condition {condition:e}, {s:?}", cycle.ratios);
            assert_eq!((s.sticks_per_cycle, s.velocity_zeros_per_cycle), (0, 2));
            let contraction = cycle.contraction().powi(2);
            assert!((s.contraction() - contraction).abs() < 1e-6, "{:?}", cycle.ratios);
            let phase = s.max_displacement.phase.reduced() - cycle.displacement_phase;
            assert!(phase.sin().abs() < 1e-15 * (4.0 * condition), "{:?}: {phase:e}", cycle.ratios);
        }
    }
    assert!(worst[0] > 0.0 && worst[1] > 0.0, "{worst:?}");
}

#[test]
fn every_motion_obeys_the_laws() {
    let mut random = Random(5);
    for _ in 0..3000 {
        let (omega, alpha) = (random.scale(0.01, 100.0), random.scale(0.3, 30.0));
        let from = start(&mut random, omega, alpha);
        let mut before = from;
        for phase in Trajectory::new(ratios(omega, alpha), from).unwrap().take(12).map(Result::unwrap) {
            let (first, Some(last)) = (phase.start(), phase.end()) else {
                assert_eq!((phase.ends_by, phase.kind), (End::Never, Kind::Stick));
                assert!(phase.start().x.abs() <= 1.0 - alpha + 1e-12);
                break;
            };
            // Each phase begins where the previous one ends.
            assert_eq!((first.phase, first.x), (before.phase, before.x));
            before = last;
            let duration = phase.duration().unwrap();
            assert!(duration >= 0.0 && last.v == 0.0);
            // No slide outlasts π(1 + 1/Ω) of natural time.
            if phase.kind != Kind::Stick {
                assert!(duration <= std::f64::consts::PI * (1.0 + omega) * (1.0 + 1e-12));
            }
            for i in 0..=20 {
                let theta = first.phase.reduced() + duration * f64::from(i) / 20.0;
                let at = stickslip::motion::DrivePhase::new(first.phase.cycles(), theta).unwrap();
                let now = phase.at(at);
                let size = 1.0 + alpha + now.state.x.abs() + now.state.v.abs() * omega;
                assert!(now.friction.abs() <= 1.0, "{now:?}");
                let residual = omega * omega * now.acceleration + now.friction + now.state.x
                    - alpha * at.reduced().sin();
                assert!(residual.abs() < 1e-14 * size * (1.0 + omega + 1.0 / omega), "{residual:e} {now:?}");
                match phase.kind {
                    Kind::SlideForward => assert_eq!(now.friction, 1.0),
                    Kind::SlideBackward => assert_eq!(now.friction, -1.0),
                    Kind::Stick => {}
                }
            }
        }
    }
}

#[test]
fn single_precision_runs_the_same_code() {
    for (omega, alpha, x, sticks) in
        [(0.7f32, 1.2f32, 1.417_437_1f32, 2), (0.4, 6.0, 6.793_822, 2), (1.5, 2.5, 1.632_993_2, 0)]
    {
        let motion = LongRun::from_start(Ratios::new(omega, alpha).unwrap(), State::default()).unwrap();
        let s = motion.steady_state().unwrap();
        assert!((s.max_displacement.value / x - 1.0).abs() < 2e-6, "{}", s.max_displacement.value);
        assert_eq!(s.sticks_per_cycle, sticks);
    }
}

#[test]
fn bad_input_is_named() {
    let message = |theta, x, v| State::new(theta, x, v).unwrap_err().to_string();
    assert_eq!(message(f64::NAN, 0.0, 0.0), "phase ω_d t = NaN must be finite");
    assert_eq!(message(0.0, f64::NAN, 0.0), "displacement x/B = NaN must be finite");
    assert_eq!(message(0.0, 0.0, f64::INFINITY), "velocity v = inf must be finite");
    let slow = Trajectory::new(ratios(1e-9, 2.0), State::default()).unwrap_err().to_string();
    assert!(slow.starts_with("frequency ratio Ω = 1e-9 must be ≥"), "{slow}");
    assert!(LongRun::from_start(ratios(1e9, 2.0), State::default()).is_err());
}

/// Found by fuzzing: a subnormal speed made the search for velocity zeros proceed from one subnormal time to
/// the next.
#[test]
fn next_to_no_speed_is_rest() {
    for v in [f64::from_bits(2), -f64::from_bits(1), 1e-300, f64::MIN_POSITIVE] {
        let start = State::new(0.0, 1.000_000_003_579_771_1, v).unwrap();
        let ratios = Ratios::new(0.500_000_000_000_007_1f64, 4.000_000_002_328_306).unwrap();
        let last =
            Trajectory::new(ratios, start).unwrap().nth(9).and_then(|phase| phase.unwrap().end()).unwrap();
        assert!((last.phase - start.phase) > 6.0, "{v:e}: {last:?}");
    }
}

/// The work of the drive remains accurate if a motion is small compared with the force.
#[test]
fn the_work_of_the_drive_keeps_its_digits() {
    let mut random = Random(13);
    let known = (1.010119046630832, 1.001103680808663);
    let near = (0..4000).map(|_| {
        let omega =
            if random.next() < 0.5 { random.scale(0.05, 20.0) } else { 1.0 + random.between(-0.1, 0.1) };
        (omega, 1.0 + random.scale(1e-4, 30.0))
    });
    let there = steady(known.0, known.1);
    assert!((there.energy_in / there.energy_out - 1.0).abs() < 1e-13, "{there:?}");
    let mut worst = (0.0f64, known);
    for (omega, alpha) in core::iter::once(known).chain(near) {
        let limit = LongRun::from_start(ratios(omega, alpha), State::default()).unwrap();
        let LongRun::Periodic(s) = limit else { continue };
        let scale = (1.0 + s.max_displacement.value) * (1.0 + 1.0 / omega);
        // The effect of the distance from the limit.
        let open = 4.0 * (s.distance.0 + s.distance.1) * (1.0 + alpha);
        let error = ((s.energy_in - s.energy_out).abs() - open).max(0.0) / s.energy_out / scale;
        worst = if error > worst.0 { (error, (omega, alpha)) } else { worst };
    }
    assert!(worst.0 < 1e-13, "{worst:?}");
}

/// A stop is counted once wherever the cycle is cut, and every stop has the velocity zero at its beginning.
#[test]
fn a_stop_at_the_seam_is_one() {
    for (omega, alpha, x, v) in
        [(1.5, 1.05, -5.0, 2.0), (1.0, 1.1426440156402995, 2.794843283062587, -2.9502384629787977)]
    {
        let limit = LongRun::from_start(ratios(omega, alpha), State::new(0.0, x, v).unwrap()).unwrap();
        let steady = limit.steady_state().unwrap();
        assert_eq!((steady.sticks_per_cycle, steady.velocity_zeros_per_cycle), (2, 2), "{steady:?}");
    }
}
