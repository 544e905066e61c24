//! Derivatives by dual numbers, compared with central differences at 512 bits for every output.

#![allow(clippy::print_stdout, reason = "the figures measured, shown with --nocapture")]

use crate::random::Random;
use stickslip::float::Dual;
use stickslip::float::Mp;
use stickslip::sensitivity::{Parameter, Sensitivities};
use stickslip::{Border, Drive, Field, Float, Oscillator, Output, PhaseFunction, Ratios, Response, Scales};

type Wide = Mp<8>;

/// Ω below 1/2, near 1, near 1/3 and far above, with α at the border and above.
fn points() -> Vec<(f64, f64)> {
    let mut random = Random(5);
    let mut points = Vec::new();
    for i in 0..320 {
        let omega = match i % 8 {
            0 => random.between(0.5, 0.99),
            1 => random.between(1.01, 3.0),
            2 => random.scale(3.0, 1e3),
            3 => random.between(0.05, 0.5),
            4 => random.between(1.0 / 3.0, 0.5),
            5 => 1.0 + random.scale(1e-12, 1e-3) * if i % 16 < 8 { 1.0 } else { -1.0 },
            6 => (1.0 + random.scale(1e-9, 1e-3) * if i % 16 < 8 { 1.0 } else { -1.0 }) / 3.0,
            _ => {
                (1.0 + random.scale(1e-7, 1e-2) * if i % 16 < 8 { 1.0 } else { -1.0 })
                    / f64::from(2 * (i % 5) + 2)
            }
        };
        let over = if i % 3 == 0 { random.scale(1.0001, 1.1) } else { random.scale(1.1, 100.0) };
        points.push((omega, Border::new(omega).unwrap().min_force_ratio * over));
    }
    points
}

/// The parameters of a machine, in the order of the arrays here.
const PARAMETERS: [Parameter; 5] = [
    Parameter::Mass,
    Parameter::Stiffness,
    Parameter::FrictionBound,
    Parameter::Amplitude,
    Parameter::AngularFrequency,
];

const OUTPUTS: usize = Output::ALL.len();

/// Central difference quotients of each output with respect to each of N parameters, at 512 bits; accurate to
/// about 90 digits.
fn differences<const N: usize>(
    at: [f64; N],
    outputs: impl Fn([Wide; N]) -> Vec<Option<Wide>>,
) -> Vec<Vec<Option<Wide>>> {
    let at = at.map(Wide::from);
    (0..N)
        .map(|i| {
            let step = at[i] * Wide::exp2i(-150);
            let [up, down] = [step, -step].map(|step| {
                let mut there = at;
                there[i] += step;
                outputs(there)
            });
            let quotient = |(a, b): (Option<Wide>, Option<Wide>)| Some((a? - b?) / (Wide::int(2) * step));
            up.into_iter().zip(down).map(quotient).collect()
        })
        .collect()
}

/// The error of each derivative, in units of the larger of `p ∂y/∂p` and y; for phases, y counts as at least
/// one radian.
fn check<const N: usize>(
    at: [f64; N],
    found: impl Fn(Output) -> Option<(f64, [f64; N])>,
    radian: f64,
    outputs: impl Fn([Wide; N]) -> Vec<Option<Wide>>,
    worst: &mut [f64; OUTPUTS],
) {
    let expected = differences(at, &outputs);
    let values = outputs(at.map(Wide::from));
    let speed = values[2].map_or(0.0, Float::to_f64);
    for (o, output) in Output::ALL.into_iter().enumerate() {
        let Some((value, by)) = found(output) else {
            assert!(values[o].is_none(), "{output:?} is missing at {at:?}");
            continue;
        };
        let least = match output {
            Output::DisplacementPhase | Output::VelocityPhase | Output::BorderPhase => radian,
            Output::Deviation => speed * radian,
            _ => 0.0,
        };
        for i in 0..N {
            let exact = expected[i][o].unwrap().to_f64();
            let size = (exact * at[i]).abs().max(value.abs()).max(least);
            // Near Ω = 1, gσ is a product of a large and a small number.
            let conditioned = output != Output::Contraction || N > 2;
            let room = if conditioned { 1.0 } else { (0.1 / (at[0] - 1.0).abs()).max(1.0) };
            let error = if size == 0.0 { 0.0 } else { (by[i] - exact).abs() * at[i] / size / room };
            assert!(error < 1e-7, "{output:?} by {i} at {at:?}: {} against {exact}", by[i]);
            worst[o] = worst[o].max(error);
        }
    }
}

fn report(worst: &[f64; OUTPUTS], bound: f64) {
    for (output, worst) in Output::ALL.iter().zip(worst) {
        println!("{:32} {worst:.1e}", output.name());
    }
    for (output, &worst) in Output::ALL.iter().zip(worst) {
        // Near 1/(2n) the phase at which the velocity touches zero is less accurate than the border.
        let bound = if *output == Output::BorderPhase { 1e-11 } else { bound };
        assert!(worst < bound, "{output:?}: {worst:e}");
    }
}

fn all_outputs<F: Float>(omega: F, alpha: F) -> Vec<Option<F>> {
    let response = Response::new(Ratios::new(omega, alpha).unwrap());
    Output::ALL.map(|output| output.of(&response)).to_vec()
}

#[test]
fn by_the_ratios_at_512_bits() {
    let mut worst = [0.0; OUTPUTS];
    for (omega, alpha) in points() {
        let all = crate::by_ratios(Ratios::new(omega, alpha).unwrap());
        let found = |output| all.iter().find(|(own, ..)| *own == output).map(|&(_, value, by)| (value, by));
        check([omega, alpha], found, 1.0, |[omega, alpha]| all_outputs(omega, alpha), &mut worst);
    }
    report(&worst, 1e-13);
}

#[test]
fn by_the_machine_at_512_bits() {
    let mut random = Random(11);
    let mut worst = [0.0; OUTPUTS];
    for (i, (omega, alpha)) in points().into_iter().step_by(3).enumerate() {
        let (m, k, r) = (random.scale(0.1, 100.0), random.scale(0.1, 1e4), random.scale(0.1, 10.0));
        let is_base = i % 2 == 0;
        let w = omega * (k / m).sqrt();
        // The ratios that result from the rounded parameters; near a pole the difference matters.
        let least = Border::new(w / (k / m).sqrt()).unwrap().min_force_ratio;
        let alpha = alpha.max(least * 1.001);
        let a = if is_base { alpha * r / k } else { alpha * r };
        let at = [m, k, r, a, w];
        fn machine<F: Float>([m, k, r, a, w]: [F; 5], is_base: bool) -> (Oscillator<F>, Drive<F>) {
            let drive = if is_base {
                Drive::new(stickslip::Excitation::FootMotion, a, w)
            } else {
                Drive::force(a, w)
            };
            (Oscillator::new(m, k, r).unwrap(), drive.unwrap())
        }
        let outputs = |at: [Wide; 5]| {
            let (body, drive) = machine(at, is_base);
            let scales = Scales::new(&body, &drive).unwrap();
            let response = Response::new(drive.ratios(&body).unwrap());
            Output::ALL.map(|o| o.of(&response).map(|y| y * o.unit(&scales))).to_vec()
        };
        let distance = |n: f64| (n * omega - 1.0).abs();
        // Near a pole or a corner, an Ω rounded to f64 differs significantly from that at 512 bits.
        if (1..40).any(|n| distance(f64::from(n)) < 1e-4) {
            continue;
        }
        let (body, drive) = machine(at, is_base);
        let all = Sensitivities::by_parameters(&body, &drive).unwrap();
        let found = |output| all.of(output).map(|found| (found.value, PARAMETERS.map(|p| found.by(p))));
        check(at, found, 1.0 / w, outputs, &mut worst);
    }
    report(&worst, 1e-11);
}

/// The code is the same, and so are the bits of the values.
#[test]
fn the_values_are_those_of_f64() {
    for (omega, alpha) in points() {
        let plain = all_outputs(omega, alpha);
        let [o, a] = Dual::parameters([omega, alpha]);
        let dual: Vec<_> = all_outputs::<Dual<2>>(o, a).into_iter().map(|y| y.map(Dual::value)).collect();
        assert_eq!(plain, dual, "({omega}, {alpha})");
    }
}

#[test]
fn the_border_against_its_slope_in_closed_form() {
    for (omega, alpha) in points() {
        let p = PhaseFunction::new(omega).unwrap();
        let [o] = Dual::parameters([omega]);
        let border = Border::new(o).unwrap().min_force_ratio;
        let (found, slope) = (border.derivatives()[0], Border::slope(&p));
        let size = slope.abs().max(border.value() / omega);
        assert!((found - slope).abs() < 1e-14 * size, "{omega} {alpha}: {found} {slope}");
        let by_ratios = crate::by_ratios(Ratios::new(omega, alpha).unwrap());
        assert!(by_ratios.contains(&(Output::MinForceRatio, border.value(), [found, 0.0])));
    }
}
