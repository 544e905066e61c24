//! Each erratum of `docs/errata.md`: the form as printed, the corrected one, and the reference value.

use stickslip::cycle::{self, matching, printed};
use stickslip::{Border, Cycle, Drive, Oscillator, PhaseFunction, Ratios, Response};

fn cycle(omega: f64, alpha: f64) -> Cycle<f64> {
    Cycle::new(Ratios::new(omega, alpha).unwrap()).unwrap()
}

fn close(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance * b.abs(), "{a} against {b}");
}

fn printed_velocity(c: &Cycle<f64>) -> f64 {
    let (omega, alpha) = (c.ratios.omega(), c.ratios.alpha());
    printed::max_velocity(omega, alpha, matching::pi_1(omega).cos(), c.deviation())
}

fn corrected_velocity(c: &Cycle<f64>) -> f64 {
    let g = c.given();
    cycle::equations::max_velocity_from_phase(
        g.amplitude,
        g.omega,
        matching::pi_1(g.omega).cos(),
        c.velocity_phase.sin_cos(),
        c.deviation(),
        (1.0 - g.omega).signum(),
    )
}

#[test]
fn erratum_1_the_second_root_of_49_above_the_natural_frequency() {
    let c = cycle(1.5, 2.5);
    let reference = 1.654_152_276_482_076_4;
    close(c.max_velocity, reference, 1e-15);
    close(corrected_velocity(&c), reference, 1e-14);
    close(printed_velocity(&c), 1.933_924_354_979_769, 1e-14);
    // Eq. 37 and 48 print the same root of ρ².
    let (g, u) = (c.given(), c.unknowns());
    close(g.max_velocity(&u, -1.0) / 1.5, reference, 1e-14);
    close(g.max_velocity(&u, 1.0) / 1.5, 1.933_924_354_979_769, 1e-14);
}

#[test]
fn erratum_2_the_first_root_of_49_near_the_border() {
    let c = cycle(0.939_24, 1.249_1);
    let reference = 1.961_975_184_344_734_2;
    assert!(c.velocity_phase.cos() < 0.0, "the root stands for a negative number");
    close(c.max_velocity, reference, 1e-14);
    close(corrected_velocity(&c), reference, 1e-12);
    close(printed_velocity(&c), 5.435_169_765_408_348, 1e-12);
    // Away from the border and below the natural frequency, the printed form is correct.
    let c = cycle(0.7, 2.0);
    close(printed_velocity(&c), 3.761_239_935_323_71, 1e-14);
}

#[test]
fn erratum_3_the_range_of_43_where_k_is_positive() {
    let c = cycle(0.4, 9.0);
    close(c.displacement_phase, 1.335_292_090_074_097, 1e-15);
    let ratio = c.max_displacement / c.ratios.forced_amplitude();
    close(printed::displacement_phase(ratio), 1.806_300_563_515_696_3, 1e-14);
    // Where K < 0, on both sides of Ω = 1, the printed range is correct.
    for (omega, alpha) in [(0.7, 2.0), (1.5, 2.5), (0.3, 12.0)] {
        let c = cycle(omega, alpha);
        let ratio = c.max_displacement / c.ratios.forced_amplitude();
        close(printed::displacement_phase(ratio), c.displacement_phase, 1e-14);
    }
}

#[test]
fn erratum_4_equation_61_does_not_suffice_below_one_half() {
    let p = PhaseFunction::new(0.4f64).unwrap();
    close(Border::turning_point_at(&p), 5.654_423_047_491_228, 1e-15);
    close(Border::at(&p).min_force_ratio, 6.949_737_755_908_733, 1e-15);
    // Between the two, eq. 62 holds, but the motion of eq. 54 runs backwards and is impossible.
    let alpha = 6.0;
    assert!(cycle::border::turning_point_criterion(p.value(), 0.4, alpha));
    let delta = cycle::max_displacement(p.value(), alpha, 1.0 - 0.16);
    let phase = cycle::equations::displacement_phase(p.value(), alpha, 0.4);
    let half = cycle::den_hartog::FallingHalf {
        amplitude: alpha / (1.0 - 0.16),
        friction_displacement: 1.0,
        omega: 0.4,
        phase_lag: cycle::den_hartog::phase_lag(phase),
        c1: cycle::den_hartog::sine_coefficient(1.0, p.tangent()),
        c2: cycle::den_hartog::cosine_coefficient(1.0),
    };
    close(half.displacement(0.0), delta, 1e-14);
    assert!(half.velocity(0.47) > 0.1, "x′ > 0 in a half cycle that is to fall: {}", half.velocity(0.47));
    // At and above the exact border the velocity keeps its sign.
    let c = cycle(0.4, 7.0);
    let half = c.den_hartog();
    assert!((1..1000).all(|i| half.velocity(f64::from(i) * std::f64::consts::PI / 1000.0) < 0.0));
}

#[test]
fn erratum_5_the_optimum_of_65_sticks_for_some_frequencies() {
    let at = |omega: f64| Response::new(Ratios::new(omega, 2.0).unwrap());
    // At Ω = 0.6 eq. 65 gives 0.87, where the body is at rest; the best non-sticking force ratio is the
    // border, 1.88.
    let low = at(0.6);
    close(low.best_force_ratio, 0.870_929_686_322_907_6, 1e-14);
    assert!(!low.best_is_reached());
    let loop_at = |alpha| cycle(0.6, alpha).loop_size_stiffness();
    let border = low.border.min_force_ratio;
    assert!(loop_at(border) > loop_at(border * 1.001) && loop_at(border) < low.best_loop_size.unwrap());
    // At Ω = 1.5 the optimum of eq. 65 is reached.
    assert!(at(1.5).best_is_reached());
    close(cycle(1.5, at(1.5).best_force_ratio).loop_size_stiffness(), at(1.5).best_loop_size.unwrap(), 1e-14);
    // For Ω ≥ 1/2 the dividing line is Ω|T| = 1.
    for i in 0..300 {
        let omega = 0.5 + f64::from(i) * 0.0101;
        let tangent = PhaseFunction::new(omega).unwrap().tangent();
        assert_eq!(at(omega).best_is_reached(), omega * tangent.abs() >= 1.0, "{omega}");
    }
}

#[test]
fn erratum_6_the_deviation_grows_in_one_unit_and_falls_in_the_other() {
    let ratios = [1.6, 2.0, 10.0];
    let in_b = ratios.map(|alpha| cycle(0.7, alpha).deviation());
    for (got, expected) in in_b.iter().zip([0.3728, 0.4665, 0.6597]) {
        assert!((got - expected).abs() < 5e-5);
    }
    // With p₀ fixed, B = p₀/(αk) and Δ₁ k/p₀ = (Δ₁/B)/α: it increases up to α ≈ 1.78 and decreases beyond.
    let at_fixed_force = [1.6, 1.8, 2.0, 3.0, 10.0].map(|alpha| cycle(0.7, alpha).deviation() / alpha);
    let expected = [0.233_010_73, 0.236_864_99, 0.233_242_65, 0.190_285_85, 0.065_970_232];
    for (got, expected) in at_fixed_force.iter().zip(expected) {
        close(*got, expected, 1e-7);
    }
}

/// The greatest absolute displacement of a body of mass, stiffness and friction 1 under `u_g0 sin Ωt`, after
/// 60 cycles from rest by small steps of Heun's method in the fixed frame; and that relative to a base that
/// carries the surface, if it does.
fn shaken(omega: f64, base: f64, carries_surface: bool) -> f64 {
    let ground = |t: f64| (base * (omega * t).sin(), base * omega * (omega * t).cos());
    let carried = f64::from(u8::from(carries_surface));
    let acceleration = |t: f64, x: f64, v: f64| {
        let (u, rate) = ground(t);
        u - x - (v - carried * rate).signum()
    };
    let (steps, cycles) = (40_000, 60);
    let dt = std::f64::consts::TAU / omega / f64::from(steps);
    let (mut x, mut v, mut furthest) = (0.0, 0.0, 0.0_f64);
    for i in 0..cycles * steps {
        let t = f64::from(i) * dt;
        let a = acceleration(t, x, v);
        let b = acceleration(t + dt, x + dt * v, v + dt * a);
        if i >= (cycles - 1) * steps {
            furthest = furthest.max((x - carried * ground(t).0).abs());
        }
        (x, v) = (x + dt * (v + dt * a / 2.0), v + dt * (a + b) / 2.0);
    }
    furthest
}

#[test]
fn erratum_7_the_force_of_a_base_that_carries_the_surface() {
    let (omega, base) = (1.5, 2.5);
    let printed = cycle(omega, base).max_displacement;
    let corrected = cycle(omega, omega * omega * base).max_displacement;
    close(printed, 1.632_993_161_855_452, 1e-15);
    close(corrected, 4.349_329_450_233_296, 1e-12);
    close(shaken(omega, base, true), corrected, 1e-4);
    close(shaken(omega, base, false), printed, 1e-4);
    // The library's support motion moves the support of the spring.
    let body = Oscillator::new(1.0, 1.0, 1.0).unwrap();
    let drive = Drive::new(stickslip::Excitation::FootMotion, base, omega).unwrap();
    assert_eq!(drive.ratios(&body).unwrap().alpha(), base);
}
