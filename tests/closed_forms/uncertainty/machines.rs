//! Ranges over boxes of machines in physical units.

use super::{holds, interval, machine, within};
use crate::random::Random;
use stickslip::uncertainty::{Evidence, Interval, ParameterBox, Range};
use stickslip::{Border, Drive, Excitation, Oscillator, Output, Regime, Response, Scales};

/// The amplitude at which an undamped machine has the force p₀.
fn amplitude(excitation: Excitation, p0: f64, body: &Oscillator<f64>, w: f64) -> f64 {
    p0 / Drive::new(excitation, 1.0, w).unwrap().force_amplitude(body)
}

#[test]
fn guaranteed_ranges_of_machines_hold_everywhere() {
    let mut random = Random(63);
    let (mut guaranteed, mut never, mut always) = (0, 0, 0);
    for i in 0..800_usize {
        let excitation = Excitation::ALL[i % 7];
        let (m, k, r) = (random.scale(0.1, 10.0), random.scale(0.1, 10.0), random.scale(0.1, 10.0));
        let omega = random.scale(0.1, 8.0);
        let p0 = r * Border::new(omega).unwrap().min_force_ratio * random.scale(0.4, 8.0);
        let w = omega * (k / m).sqrt();
        let a = amplitude(excitation, p0, &Oscillator::new(m, k, r).unwrap(), w);
        let width = if i % 3 == 0 { 0.05 } else { 0.004 };
        let [m, k, r, a, w] = [m, k, r, a, w].map(|x| interval(&mut random, x, width));
        let machine = machine(excitation, [m, k, r, a, w, Interval::exactly(0.0)]);
        let sticks = machine.verdict().unwrap().sticks();
        (never, always) =
            (never + i32::from(sticks == Some(false)), always + i32::from(sticks == Some(true)));
        let ranges: Vec<_> = Output::ALL.iter().map(|o| machine.range(*o, 20).unwrap()).collect();
        for _ in 0..40 {
            let [m, k, r, a, w] = [m, k, r, a, w].map(|i| within(&mut random, i));
            let body = Oscillator::new(m, k, r).unwrap();
            let drive = Drive::new(excitation, a, w).unwrap();
            let scales = Scales::new(&body, &drive).unwrap();
            let response = Response::new(drive.ratios(&body).unwrap());
            match sticks {
                Some(true) => assert!(response.cycle.as_ref().is_none()),
                Some(false) => {
                    assert!(response.cycle.as_ref().is_some() || response.regime == Regime::Unbounded)
                }
                None => {}
            }
            for (output, range) in Output::ALL.iter().zip(&ranges) {
                let value = output.of(&response).map(|y| y * output.unit(&scales));
                if let (Some(range), Some(value)) = (range, value)
                    && range.is_guaranteed()
                {
                    guaranteed += 1;
                    assert!(holds(range, value), "{output:?}: {value} {range:?} {machine:?}");
                }
            }
        }
    }
    assert!(guaranteed > 50_000 && never > 100 && always > 50, "{guaranteed} {never} {always}");
}

/// A box of a single machine contains its ratios, with their rounding, and gives the same verdict and margin.
#[test]
fn one_machine_is_in_its_own_box() {
    let mut random = Random(64);
    for _ in 0..2000 {
        let mut one = || Interval::exactly(random.scale(0.01, 100.0));
        let [m, k, r, a, w] = [one(), one(), one(), one(), one()];
        for excitation in Excitation::ALL {
            let machine = machine(excitation, [m, k, r, a, w, Interval::exactly(0.0)]);
            let body = Oscillator::new(m.low, k.low, r.low).unwrap();
            let drive = Drive::new(excitation, a.low, w.low).unwrap();
            let Ok(ratios) = drive.ratios(&body) else { continue };
            let ParameterBox::Ratios { omega, alpha, .. } = machine.ratios().unwrap() else {
                panic!("a machine")
            };
            let holds = |i: Interval<f64>, x: f64| i.low <= x && x <= i.high && i.high - i.low < 1e-14 * x;
            assert!(holds(omega, ratios.omega()) && holds(alpha, ratios.alpha()), "{machine:?}");
            let margin = machine.range(Output::Margin, 1).unwrap().unwrap();
            assert_eq!(margin.evidence, Evidence::Guaranteed { sharp: false });
        }
    }
}

/// Where the stiffness is the least certain parameter, the guaranteed range with many pieces is nearly
/// attained.
#[test]
fn guaranteed_ranges_of_machines_are_close() {
    let mut random = Random(65);
    let mut seen = 0;
    for _ in 0..60 {
        let exactly = |x: f64| Interval::exactly(x);
        let (k, w) = (random.scale(0.1, 10.0), random.scale(0.3, 4.0));
        let stiffness = Interval::relative(k, 0.15);
        let least = Border::new(w / stiffness.low.sqrt()).unwrap().min_force_ratio;
        let p0 = least * random.scale(1.5, 6.0);
        let known = [exactly(1.0), stiffness, exactly(1.0), exactly(p0), exactly(w), exactly(0.0)];
        let machine = machine(Excitation::Force, known);
        for output in [Output::MaxDisplacement, Output::LoopSizeStiffness, Output::LoopSizeInertia] {
            let Some(range) = machine.range(output, 4000).unwrap().filter(Range::is_guaranteed) else {
                continue;
            };
            seen += 1;
            let (mut low, mut high) = (f64::INFINITY, 0.0);
            for i in 0..=400 {
                let k = stiffness.low + (stiffness.high - stiffness.low) * f64::from(i) / 400.0;
                let (body, drive) = (Oscillator::new(1.0, k, 1.0).unwrap(), Drive::force(p0, w).unwrap());
                let scales = Scales::new(&body, &drive).unwrap();
                let response = Response::new(drive.ratios(&body).unwrap());
                let value = output.of(&response).unwrap() * output.unit(&scales);
                (low, high) = (f64::min(low, value), f64::max(high, value));
            }
            let slack = 0.03 * (high - low);
            assert!(range.low >= low - slack && range.high <= high + slack, "{range:?} {low} {high}");
        }
    }
    assert!(seen > 60, "{seen}");
}
