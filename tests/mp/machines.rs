//! Ranges over boxes of machines, proved by ball arithmetic: they contain the outputs of every machine of the
//! box.

use crate::machine_box::machine;
use stickslip::uncertainty::{Interval, ParameterBox, Range};
use stickslip::{Drive, Excitation, Oscillator, Output, Regime, Response, Scales, Verdict};

/// m, k, r_y, the amplitude, ω_d and c, each with its relative uncertainty.
type Machine = ([f64; 6], [f64; 6]);

fn parts(excitation: Excitation, (values, shares): &Machine) -> ParameterBox<f64> {
    machine(excitation, core::array::from_fn(|i| Interval::relative(values[i], shares[i])))
}

/// An output of the machine at a position in each interval, from −1 to 1.
fn value(
    excitation: Excitation,
    (values, shares): &Machine,
    places: [f64; 6],
    output: Output,
) -> Option<f64> {
    let [m, k, r, a, w, c] = core::array::from_fn(|i| values[i] * (1.0 + shares[i] * places[i]));
    let body = Oscillator::new(m, k, r).unwrap().with_damping(c).unwrap();
    let drive = Drive::new(excitation, a, w).unwrap();
    let response = Response::new(drive.ratios(&body).unwrap());
    Some(output.of(&response)? * output.unit(&Scales::new(&body, &drive).unwrap()))
}

/// Corners, the middle and positions in between.
fn places() -> Vec<[f64; 6]> {
    let corner = |n: u32| core::array::from_fn(|i| if n >> i & 1 == 1 { 1.0 } else { -1.0 });
    let between = |n: u32| {
        core::array::from_fn(|i| {
            let step = [0.618_034, 0.754_878, 0.324_718, 0.569_840, 0.220_744, 0.819_173][i];
            2.0 * (f64::from(n) * step).fract() - 1.0
        })
    };
    (0..64).map(corner).chain((1..60).map(between)).chain([[0.0; 6]]).collect()
}

#[test]
fn the_outputs_of_every_machine_are_in_the_range_of_the_box() {
    let outputs = [
        Output::MaxDisplacement,
        Output::MaxVelocity,
        Output::VelocityPhase,
        Output::LoopSizeStiffness,
        Output::LoopSizeInertia,
        Output::MinForceRatio,
        Output::Margin,
        Output::BestLoopSize,
        Output::Contraction,
    ];
    let machines = [
        (Excitation::Force, ([50.0, 1000.0, 5.0, 12.0, 6.0, 0.0], [0.0, 0.01, 0.02, 0.0, 0.01, 0.0])),
        (Excitation::FootMotion, ([50.0, 1000.0, 5.0, 0.012, 6.0, 0.0], [0.01, 0.01, 0.02, 0.01, 0.0, 0.0])),
        (Excitation::Force, ([50.0, 1000.0, 5.0, 12.0, 3.0, 20.0], [0.01, 0.0, 0.02, 0.0, 0.0, 0.02])),
        (Excitation::Force, ([50.0, 1000.0, 5.0, 60.0, 6.0, 600.0], [0.0, 0.005, 0.01, 0.01, 0.0, 0.01])),
        (Excitation::Unbalance, ([50.0, 1000.0, 5.0, 0.33, 6.0, 0.0], [0.0, 0.01, 0.02, 0.01, 0.0, 0.0])),
        (
            Excitation::DampedFootMotion,
            ([50.0, 1000.0, 5.0, 0.012, 3.0, 20.0], [0.01, 0.0, 0.02, 0.0, 0.0, 0.02]),
        ),
        (
            Excitation::SurfaceMotion,
            ([50.0, 1000.0, 5.0, 0.0067, 6.0, 0.0], [0.0, 0.01, 0.02, 0.01, 0.0, 0.0]),
        ),
        (
            Excitation::SurfaceVelocity,
            ([50.0, 1000.0, 5.0, 0.04, 6.0, 0.0], [0.0, 0.01, 0.02, 0.01, 0.0, 0.0]),
        ),
        (
            Excitation::SurfaceAcceleration,
            ([50.0, 1000.0, 5.0, 0.24, 6.0, 0.0], [0.0, 0.01, 0.02, 0.01, 0.01, 0.0]),
        ),
    ];
    for (excitation, machine) in &machines {
        let whole = parts(*excitation, machine);
        for output in outputs {
            let values: Vec<f64> =
                places().into_iter().filter_map(|at| value(*excitation, machine, at, output)).collect();
            let low = values.iter().copied().fold(f64::INFINITY, f64::min);
            let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let Range { low: least, high: greatest, .. } =
                whole.enclosed(output, 24).unwrap().unwrap_or_else(|| panic!("{machine:?} {output:?}"));
            let rounding = 1e-13 * low.abs().max(high.abs());
            assert!(
                least <= low + rounding && high - rounding <= greatest,
                "{excitation} {machine:?} {output:?}: {least} … {greatest}, but {low} … {high}"
            );
            // More parts give a closer range. An output that takes a search, cancels or hardly changes over
            // the box remains wider for longer.
            let more = whole.enclosed(output, 100).unwrap().unwrap();
            assert!(more.is_guaranteed() && more.high - more.low <= greatest - least, "{output:?} {more:?}");
            let wider = (more.high - more.low) - (high - low);
            let is_wide = matches!(output, Output::MaxVelocity | Output::VelocityPhase | Output::Contraction);
            let share = if is_wide { 30.0 } else { 8.0 };
            assert!(wider <= share * (high - low) + rounding, "{machine:?} {output:?}: {wider} {low} {high}");
            assert!(more.low <= low + rounding && high - rounding <= more.high, "{output:?} {more:?}");
        }
    }
}

/// A machine that is known exactly has its outputs to all digits; one on both sides of the border has a
/// margin and no proved motion.
#[test]
fn what_is_exact_is_sharp_and_what_may_stick_has_no_range() {
    let exact = ([50.0, 1000.0, 5.0, 12.0, 6.0, 20.0], [0.0; 6]);
    for output in [Output::MaxDisplacement, Output::VelocityPhase, Output::TransmittedForce] {
        let found = parts(Excitation::Force, &exact).enclosed(output, 5).unwrap().unwrap();
        let value = value(Excitation::Force, &exact, [0.0; 6], output).unwrap();
        assert!(
            (found.low - value).abs() + (found.high - value).abs() <= 1e-14 * value,
            "{output:?} {found:?}"
        );
    }
    let both =
        parts(Excitation::Force, &([50.0, 1000.0, 5.0, 9.0, 6.0, 20.0], [0.0, 0.0, 0.3, 0.0, 0.0, 0.1]));
    assert_eq!(both.enclosed(Output::MaxDisplacement, 20), Ok(None));
    let margin = both.enclosed(Output::Margin, 20).unwrap().unwrap();
    assert!(margin.low < 1.0 && margin.high > 1.0, "{margin:?}");
    assert_eq!(both.verdict(), Ok(Verdict::Undecided(Regime::Sticking, Regime::NonSticking)));
    let sampled = both.range(Output::MinForceRatio, 10).unwrap().unwrap();
    let proved = both.enclosed(Output::MinForceRatio, 20).unwrap().unwrap();
    assert!(!sampled.is_guaranteed() && proved.low <= sampled.low && sampled.high <= proved.high);
    let negative = Interval { low: -1.0, high: 1.0 };
    let ParameterBox::Machine(mut refused) = both else { panic!("ratios") };
    refused.damping = negative;
    let refused = ParameterBox::Machine(refused).enclosed(Output::Margin, 1);
    assert!(refused.unwrap_err().to_string().contains("-1 must be ≥ 0"));
}
