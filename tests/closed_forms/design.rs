//! The inverse problems and the border behind them, from outside: every answer is substituted into the
//! forward functions.

use crate::drawn::cases;
use proptest::prelude::*;
use std::f64::consts::PI;
use stickslip::design::{
    self, Edge, OptimumKind, bands, force_ratio_for_displacement, force_ratio_for_velocity,
    most_dissipating_force_ratio, most_dissipating_frequency_ratio,
};
use stickslip::uncertainty::{Interval, ParameterBox};
use stickslip::{
    Border, Cycle, Drive, Excitation, Oscillator, Output, PhaseFunction, Ratios, Regime, Response, Verdict,
};

/// Ω from 0.05 to 20, uniform in its logarithm; the range contains nine poles of the border.
fn frequency_ratios() -> impl Strategy<Value = f64> {
    (0.05f64.ln()..20f64.ln()).prop_map(f64::exp)
}

fn border(omega: f64) -> f64 {
    Border::new(omega).unwrap().min_force_ratio
}

fn cycle(omega: f64, alpha: f64) -> Cycle<f64> {
    Cycle::new(Ratios::new(omega, alpha).unwrap()).unwrap()
}

/// Relative distance of Ω from the nearest pole 1/(2n+1).
fn distance_from_pole(omega: f64) -> f64 {
    let n = ((1.0 / omega - 1.0) / 2.0).round().max(1.0);
    (omega * (2.0 * n + 1.0) - 1.0).abs()
}

#[test]
fn the_border_to_the_last_digit() {
    for (omega, exact, by_turning_point) in [
        (0.4, 6.949_737_755_908_733, 5.654_423_047_491_228),
        (0.45, 4.140_195_114_985_661, 3.990_746_152_388_952),
        (0.3, 11.573_099_220_763_208, 11.394_643_532_580_029),
        (1.0, 4.0 / PI, 4.0 / PI),
        (1e9, (1.0 + PI * PI / 4.0).sqrt(), (1.0 + PI * PI / 4.0).sqrt()),
        (0.5, 3.0, 3.0),
        (0.25, 15.0, 15.0),
    ] {
        let found = Border::new(omega).unwrap();
        for (a, b) in
            [(found.min_force_ratio, exact), (found.min_force_ratio_turning_point, by_turning_point)]
        {
            assert!((a / b - 1.0f64).abs() <= 4.0 * f64::EPSILON, "{omega}: {a} against {b}");
        }
    }
    for (omega, exact) in [(0.35, 26.101_754_114_3), (0.22, 27.474_349_816_3)] {
        assert!((border(omega) - exact).abs() < 5e-11);
    }
    let least = Border::<f64>::minimum(0);
    assert!((least.omega - 0.849_158_848_834_442).abs() < 1e-15);
    assert!((least.force_ratio - 1.209_998_436_338_07).abs() < 5e-15);
}

/// Den Hartog's function f(τ) as it is written in the border's documentation, without rearrangement.
fn den_hartog(omega: f64, tau: f64) -> f64 {
    let tangent = (PI / (2.0 * omega)).tan();
    let fast = tau / omega;
    (fast.sin() + tangent * (tau.cos() - fast.cos())) / (omega * tau.sin())
}

proptest! {
    #![proptest_config(cases(2000))]

    /// A billionth above the border f stays below Δ₀/B; a billionth below it f exceeds Δ₀/B at the limiting
    /// phase.
    #[test]
    fn a_billionth_from_the_border_the_regime_is_right(omega in frequency_ratios()) {
        prop_assume!(distance_from_pole(omega) > 1e-3 && (omega - 1.0).abs() > 1e-3);
        let least = border(omega);
        let at = |share: f64| Response::new(Ratios::new(omega, least * share).unwrap());
        let (above, below) = (at(1.0 + 1e-9), at(1.0 - 1e-9));
        prop_assert_eq!(Verdict::new(above.ratios), Verdict::NonSticking);
        prop_assert_eq!(Verdict::new(below.ratios), Verdict::Sticking);
        let margin = |answer| Output::Margin.of(answer).unwrap();
        prop_assert!((margin(&above) - 1.0 - 1e-9).abs() < 1e-15 && margin(&below) < 1.0);
        prop_assert_eq!(above.regime, Regime::NonSticking);
        prop_assert_eq!(below.regime, Regime::Sticking);

        let delta = |alpha: f64| {
            let p = PhaseFunction::new(omega).unwrap();
            (alpha - p.value()) * (alpha + p.value()) / (1.0 - omega * omega).powi(2)
        };
        let (delta_above, delta_below) =
            (delta(least * (1.0 + 1e-9)).sqrt(), delta(least * (1.0 - 1e-9)).sqrt());
        let touching = above.border.border_phase;
        let sup = if touching == 0.0 { 1.0 / (omega * omega) } else { den_hartog(omega, touching) };
        prop_assert!(sup > delta_below, "{sup} {delta_below}");
        for i in 1..500 {
            let tau = PI * f64::from(i) / 500.0;
            prop_assert!(den_hartog(omega, tau) < delta_above, "{tau}");
            let near = touching + 1e-6 * (f64::from(i) - 250.0);
            prop_assert!(near <= 1e-4 * omega || den_hartog(omega, near) < delta_above, "{near}");
        }
    }

    /// Compared with eighth-order differences, whose step follows the distance from the poles.
    #[test]
    fn the_slope_of_the_border_is_that_of_differences(omega in frequency_ratios()) {
        // Between the poles 1/(2n+3) and 1/(2n+1).
        let lobe = ((1.0 / omega - 1.0) / 2.0).max(0.0) as u16;
        let distance = distance_from_pole(omega).min(1.0);
        let h = omega * (distance * 2e-3).min(1e-3);
        let corner = [Some(lobe), lobe.checked_add(1)].into_iter().flatten().filter_map(Border::<f64>::shortfall);
        let mut joints: Vec<f64> = corner.flat_map(|s| [s.low, s.high]).collect();
        joints.push(0.5 / f64::from(u32::from(lobe) + 1));
        prop_assume!(distance > 1e-4 && joints.iter().all(|joint| (omega - joint).abs() > 5.0 * h));
        let [c1, c2, c3, c4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
        let pair = |n: f64| border(omega + n * h) - border(omega - n * h);
        let difference = (c1 * pair(1.0) + c2 * pair(2.0) + c3 * pair(3.0) + c4 * pair(4.0)) / h;
        let slope = Border::slope(&PhaseFunction::new(omega).unwrap());
        let rounding = 1e-15 * border(omega) / h;
        prop_assert!((difference - slope).abs() < 10.0 * rounding + 1e-9 * slope.abs(), "{difference} {slope} {h}");
    }

    #[test]
    fn min_force_and_max_friction_sit_on_the_border(
        omega in frequency_ratios(), stiffness in 0.1f64..1e6, friction in 0.01f64..1e3, mass in 0.01f64..1e4,
    ) {
        let body = Oscillator::new(mass, stiffness, friction).unwrap();
        let frequency = omega * body.natural_frequency();
        let force = design::min_amplitude(&body, Excitation::Force, frequency).unwrap();
        let base = design::min_amplitude(&body, Excitation::FootMotion, frequency).unwrap();
        let drive = |share: f64| Drive::force(force * share, frequency).unwrap();
        // The effect of rounding Ω on the way in and out.
        let p = PhaseFunction::new(omega).unwrap();
        let slack = 1e-14 * (1.0 + (omega * Border::slope(&p) / border(omega)).abs());
        for drive in [drive(1.0), Drive::new(stickslip::Excitation::FootMotion, base, frequency).unwrap()] {
            let margin = Output::Margin.of(&Response::new(drive.ratios(&body).unwrap())).unwrap();
            prop_assert!((margin - 1.0).abs() < slack, "{margin}");
            prop_assert_eq!(Verdict::of(&body, &drive).unwrap().regime(), None);
            let greatest = design::max_friction(&body, &drive).unwrap();
            prop_assert!((greatest / friction - 1.0).abs() < slack);
        }
        // Within rounding of Ω = 1, sliding cannot be distinguished from unbounded growth; within 1e-7 of a
        // pole, six reversals cannot be distinguished from two.
        prop_assume!((omega - 1.0).abs() > 1e-14 && distance_from_pole(omega) > 1e-6);
        let verdict = |share| Verdict::of(&body, &drive(share)).unwrap();
        prop_assert_eq!(verdict(1.0 - 8.0 * slack).regime(), Some(Regime::Sticking));
        prop_assert_eq!(verdict(1.0 + 8.0 * slack).regime(), Some(Regime::NonSticking));
    }

    #[test]
    fn the_force_for_a_target_reaches_it(omega in frequency_ratios(), over in 1.0f64..50.0) {
        prop_assume!((omega - 1.0).abs() > 1e-6);
        let least = Border::new(omega).unwrap().least_displacement;
        let target = least * over;
        let alpha = force_ratio_for_displacement(omega, 0.0, target).unwrap();
        // Δ₀ is as ill-conditioned as α² − K², so that the comparison is made in α.
        let reached = cycle(omega, alpha.max(border(omega))).max_displacement;
        let k = PhaseFunction::new(omega).unwrap().value();
        let condition = alpha * alpha / ((alpha - k) * (alpha + k));
        prop_assert!((reached / target - 1.0).abs() < 1e-14 * condition, "{reached} {target}");

        let alpha = border(omega) * over * (1.0 + 1e-9);
        let speed = cycle(omega, alpha).max_velocity;
        let again = force_ratio_for_velocity(omega, 0.0, speed).unwrap();
        prop_assert!((again / alpha - 1.0).abs() < 1e-13, "{again} {alpha}");
        let forward = cycle(omega, again.max(border(omega))).max_velocity;
        prop_assert!((forward / speed - 1.0).abs() < 1e-13 * condition.max(1.0), "{forward} {speed}");
    }

    /// A scan of the range finds sliding exactly inside the bands.
    #[test]
    fn the_bands_are_those_of_a_scan(
        alpha in (1.2f64.ln()..200f64.ln()).prop_map(f64::exp),
        ends in (frequency_ratios(), frequency_ratios()),
    ) {
        let (low, high) = (ends.0.min(ends.1), ends.0.max(ends.1));
        let found: Vec<_> = bands(alpha, 0.0, low..=high).unwrap().collect::<Result<_, _>>().unwrap();
        for pair in found.windows(2) {
            prop_assert!(pair[0].high < pair[1].low && pair[0].lobe > pair[1].lobe);
        }
        for band in &found {
            prop_assert!(low <= band.low && band.low <= band.high && band.high <= high);
            for (end, edge, outward, limit) in
                [(band.low, band.low_edge, -1.0, low), (band.high, band.high_edge, 1.0, high)]
            {
                prop_assert!(border(end) <= alpha);
                match edge {
                    Edge::Range => prop_assert_eq!(end, limit),
                    Edge::Border => prop_assert!(border(end * (1.0 + outward * 1e-8)) > alpha),
                }
            }
        }
        for i in 0..=500 {
            let omega = low * (high / low).powf(f64::from(i) / 500.0);
            let omega = omega.clamp(low, high);
            let inside = found.iter().any(|band| band.low <= omega && omega <= band.high);
            prop_assert_eq!(inside, border(omega) <= alpha, "{}", omega);
            let answer = Response::new(Ratios::new(omega, alpha).unwrap());
            prop_assert_eq!(answer.cycle.as_ref().is_some(), alpha >= border(omega));
        }
    }

    #[test]
    fn no_other_friction_dissipates_more(omega in frequency_ratios(), over in 1.0f64..20.0) {
        prop_assume!((omega - 1.0).abs() > 1e-6);
        let best = most_dissipating_force_ratio(omega, 0.0).unwrap();
        prop_assert!(best.at >= border(omega));
        let other = cycle(omega, border(omega) * over).loop_size_stiffness();
        prop_assert!(other <= best.value * (1.0 + 1e-13));
        let forward = cycle(omega, best.at).loop_size_stiffness();
        let k = PhaseFunction::new(omega).unwrap().value();
        let condition = best.at.powi(2) / ((best.at - k) * (best.at + k));
        prop_assert!((forward / best.value - 1.0).abs() < 1e-14 * condition);
        let answer = Response::new(Ratios::new(omega, best.at).unwrap());
        prop_assert_eq!(answer.best_is_reached(), best.kind == OptimumKind::Interior);
    }

    #[test]
    fn no_other_stiffness_dissipates_more(
        alpha in 1.21f64..60.0, ends in (frequency_ratios(), frequency_ratios()), share in 0.0f64..1.0,
    ) {
        let (low, high) = (ends.0.min(ends.1), ends.0.max(ends.1));
        // A₂ is infinite at Ω = 1 where α > 4/π.
        let high = if low < 1.0 && alpha > 1.27 { high.min(0.99).max(low) } else { high };
        let at = |omega| Cycle::new(Ratios::new(omega, alpha).unwrap()).map(|c| c.loop_size_inertia());
        let other = at(low + share * (high - low));
        match most_dissipating_frequency_ratio(alpha, low..=high) {
            Ok(best) => {
                prop_assert!(low <= best.at && best.at <= high);
                prop_assert!((at(best.at).unwrap() / best.value - 1.0).abs() < 1e-12);
                prop_assert!(other.unwrap_or(0.0) <= best.value * (1.0 + 1e-12));
            }
            Err(error) => prop_assert!(other.is_err(), "{}", error),
        }
    }

    #[test]
    fn the_range_of_the_border_holds_it(
        ends in (frequency_ratios(), frequency_ratios()),
        share in 0.0f64..1.0,
    ) {
        let (low, high) = (ends.0.min(ends.1), ends.0.max(ends.1));
        let ratios = ParameterBox::Ratios {
            omega: Interval { low, high },
            alpha: Interval::exactly(2.0),
            damping_ratio: Interval::exactly(0.0),
        };
        let range = ratios.range(Output::MinForceRatio, 0).unwrap().unwrap();
        let inside = border((low + share * (high - low)).clamp(low, high));
        prop_assert!(range.low <= inside && inside <= range.high);
    }
}

/// Just beyond the frequencies at which a cycle of six reversals exists, 0.0213 and 0.0375 from an odd 1/Ω, a
/// machine below the border sticks, and its verdict is decided despite its rounding.
#[test]
fn next_to_six_reversals_a_machine_sticks() {
    for pole in [3.0, 5.0, 17.0] {
        for off in [-0.0214, -0.02129, -0.02124, -0.0212, 0.036, 0.0373, 0.03743, 0.03749, 0.0376] {
            let omega = 1.0 / (pole + off);
            let body = Oscillator::new(2.0, 8.0, 3.0).unwrap();
            let force = 3.0 * border(omega) * 0.97;
            let verdict = Verdict::of(&body, &Drive::force(force, 2.0 * omega).unwrap()).unwrap();
            assert_eq!(verdict, Verdict::Sticking, "{pole} {off}");
        }
    }
}

#[test]
fn single_precision_answers_the_same_questions() {
    let found: Vec<_> = bands(12.0f32, 0.0, 0.1..=2.0).unwrap().map(Result::unwrap).collect();
    assert!((found[0].low - 0.280_666).abs() < 1e-6 && (found[1].low - 0.370_699).abs() < 1e-6);
    let alpha = force_ratio_for_velocity(1.5f32, 0.0, 1.654_152_3).unwrap();
    assert!((alpha - 2.5).abs() < 1e-6);
    let best = most_dissipating_frequency_ratio(1.25f32, 0.5..=2.0).unwrap();
    assert!((best.at - 0.934_679_8).abs() < 1e-5);
}
