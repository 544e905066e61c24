//! Ranges over boxes of parameters, compared with many points of the boxes.

mod machines;
#[cfg(feature = "random")]
mod monte_carlo;

use crate::machine_box::machine;
use crate::random::Random;
use stickslip::uncertainty::{Evidence, Interval, ParameterBox, Range};
use stickslip::{Border, Error, Excitation, Output, Ratios, Regime, Response};

fn interval(random: &mut Random, x: f64, width: f64) -> Interval<f64> {
    let share = width * random.next();
    if share < 0.2 * width { Interval::exactly(x) } else { Interval::relative(x, share) }
}

fn undamped(omega: Interval<f64>, alpha: Interval<f64>) -> ParameterBox<f64> {
    ParameterBox::Ratios { omega, alpha, damping_ratio: Interval::exactly(0.0) }
}

fn within(random: &mut Random, i: Interval<f64>) -> f64 {
    let corner = random.next();
    if corner < 0.2 {
        i.low
    } else if corner < 0.4 {
        i.high
    } else {
        random.between(i.low, i.high)
    }
}

fn holds(range: &Range<f64>, value: f64) -> bool {
    range.low <= value && value <= range.high
}

#[test]
fn guaranteed_ranges_of_ratios_hold_everywhere() {
    let mut random = Random(61);
    let mut guaranteed = 0;
    for i in 0..1500 {
        let omega = random.scale(0.06, 20.0);
        let width = if i % 2 == 0 { 0.01 } else { 0.2 };
        let alpha = Border::new(omega).unwrap().min_force_ratio * random.scale(0.5, 8.0);
        let (omega, alpha) = (interval(&mut random, omega, width), interval(&mut random, alpha, 0.3));
        let whole = undamped(omega, alpha);
        let sticks = whole.verdict().unwrap().sticks();
        let ranges: Vec<_> = Output::ALL.iter().map(|o| whole.range(*o, 40).unwrap()).collect();
        for _ in 0..60 {
            let (omega, alpha) = (within(&mut random, omega), within(&mut random, alpha));
            let response = Response::new(Ratios::new(omega, alpha).unwrap());
            match sticks {
                Some(true) => assert!(matches!(response.regime, Regime::Sticking | Regime::Stuck)),
                Some(false) => {
                    assert!(matches!(response.regime, Regime::NonSticking | Regime::Unbounded));
                }
                None => {}
            }
            for (output, range) in Output::ALL.iter().zip(&ranges) {
                if let (Some(range), Some(value)) = (range, output.of(&response))
                    && range.is_guaranteed()
                {
                    guaranteed += 1;
                    assert!(
                        holds(range, value),
                        "{output:?} at ({omega}, {alpha}): {value} {range:?} {whole:?}"
                    );
                }
            }
        }
    }
    assert!(guaranteed > 200_000, "{guaranteed}");
}

/// Guaranteed ranges contain the exact values: at single points, at the ends of narrow boxes, and near 1, 1/n
/// and the border.
#[cfg(feature = "mp")]
#[test]
fn guaranteed_ranges_hold_the_exact_values() {
    use stickslip::Float;
    use stickslip::float::Mp;
    let mut random = Random(67);
    let mut seen = 0;
    for i in 0..2000 {
        let omega = match i % 4 {
            0 => random.scale(0.06, 20.0),
            1 => (1.0 / f64::from(2 + i % 9)) * (1.0 + random.scale(1e-12, 1e-2)),
            2 => 1.0 - random.scale(1e-9, 0.3),
            _ => 1.0 + random.scale(1e-9, 0.3),
        };
        let alpha = Border::new(omega).unwrap().min_force_ratio * (1.0 + random.scale(1e-12, 8.0));
        let width = if i % 3 == 0 { 0.0 } else { random.scale(1e-16, 1e-3) };
        let (omega, alpha) = (interval(&mut random, omega, width), interval(&mut random, alpha, width));
        let whole = undamped(omega, alpha);
        for output in Output::ALL {
            let Some(range) = whole.range(output, 3).unwrap().filter(Range::is_guaranteed) else { continue };
            let [low, high] = [range.low, range.high].map(Mp::<4>::from_f64);
            for (omega, alpha) in [
                (omega.low, alpha.low),
                (omega.low, alpha.high),
                (omega.high, alpha.low),
                (omega.high, alpha.high),
            ] {
                let ratios = Ratios::new(Mp::<4>::from_f64(omega), Mp::from_f64(alpha)).unwrap();
                let Some(value) = output.of(&Response::new(ratios)) else { continue };
                assert!(
                    low <= value && value <= high,
                    "{output:?} at ({omega:e}, {alpha:e}): {range:?} without {value}"
                );
                seen += 1;
            }
        }
    }
    assert!(seen > 20_000, "{seen}");
}

#[test]
fn what_is_guaranteed_is_close_and_what_is_sampled_is_not_wider() {
    let mut random = Random(62);
    for _ in 0..200 {
        let omega = random.scale(0.1, 10.0);
        let alpha = Border::new(omega).unwrap().min_force_ratio * random.scale(1.1, 8.0);
        let omega = Interval::relative(omega, 0.002);
        let width = random.scale(0.005, 0.1);
        let alpha = Interval::relative(alpha, width);
        let whole = undamped(omega, alpha);
        if whole.verdict().unwrap().sticks() != Some(false) {
            continue;
        }
        for output in [
            Output::MaxDisplacement,
            Output::LoopSizeStiffness,
            Output::MinForceRatio,
            Output::BestForceRatio,
        ] {
            let coarse = whole.range(output, 10).unwrap().unwrap();
            let fine = whole.range(output, 4000).unwrap().unwrap();
            assert!(coarse.is_guaranteed() && coarse.low <= fine.low * (1.0 + 1e-14), "{output:?}");
            assert!(fine.high <= coarse.high * (1.0 + 1e-14), "{output:?} {coarse:?} {fine:?}");
            // The ends of the fine range are nearly attained.
            let (mut low, mut high) = (f64::INFINITY, 0.0);
            for i in 0..=400 {
                for j in [0.0, 0.25, 0.5, 0.75, 1.0] {
                    let at = |i: Interval<f64>, share: f64| i.low + (i.high - i.low) * share;
                    let ratios = Ratios::new(at(omega, f64::from(i) / 400.0), at(alpha, j)).unwrap();
                    let value = output.of(&Response::new(ratios)).unwrap();
                    (low, high) = (f64::min(low, value), f64::max(high, value));
                }
            }
            let slack = 0.03 * (high - low) + 1e-12 * high;
            assert!(
                fine.low >= low - slack && fine.high <= high + slack,
                "{output:?} {fine:?} {low} {high} {whole:?}"
            );
        }
        // The range of V₀ is guaranteed at a single frequency.
        let at_one = undamped(Interval::exactly(omega.low), alpha);
        let fastest = at_one.range(Output::MaxVelocity, 100).unwrap().unwrap();
        assert_eq!(fastest.evidence, Evidence::Guaranteed { sharp: true });
        assert!(!whole.range(Output::MaxVelocity, 100).unwrap().unwrap().is_guaranteed());
        let sampled = whole.range(Output::Contraction, 100).unwrap().unwrap();
        assert!(matches!(sampled.evidence, Evidence::Sampled { points: 105, existing: 105 }), "{sampled:?}");
        let more = whole.range(Output::Contraction, 1000).unwrap().unwrap();
        assert!(more.low <= sampled.low && more.high >= sampled.high);
    }
}

#[test]
fn what_is_wrong_is_named() {
    let one = Interval::exactly(1.0);
    let empty =
        [Interval { low: 2.0, high: 1.0 }, Interval::relative(2.0, -0.1), Interval::absolute(2.0, f64::NAN)];
    for empty in empty {
        let is_empty = |found: Result<_, Error>| matches!(found, Err(Error::EmptyInterval { .. }));
        assert!(is_empty(undamped(empty, one).verdict()) && is_empty(undamped(one, empty).verdict()));
        assert!(is_empty(machine(Excitation::Force, [one, one, one, one, empty, one]).verdict()));
    }
    let negative = Interval::absolute(1.0, 2.0);
    assert!(undamped(negative, one).verdict().is_err() && undamped(one, negative).verdict().is_err());
    let refused = machine(Excitation::Force, [one, one, negative, one, one, one]);
    assert!(refused.verdict().is_err() && refused.range(Output::Margin, 1).is_err());
    // The body sticks throughout: the cycle has no displacement anywhere, while the border is known.
    let sticking = undamped(Interval::exactly(0.7), Interval::exactly(1.2));
    assert_eq!(sticking.range(Output::MaxDisplacement, 10), Ok(None));
    assert!(sticking.range(Output::MinForceRatio, 10).unwrap().unwrap().is_guaranteed());
    // Across the border, the cycle exists in part of the box.
    let over = undamped(Interval::exactly(0.7), Interval { low: 1.2, high: 1.5 });
    let Evidence::Sampled { points, existing } =
        over.range(Output::MaxDisplacement, 100).unwrap().unwrap().evidence
    else {
        panic!("guaranteed")
    };
    assert!(existing > 30 && existing < points);
}

/// With a damper, the verdict of a box is proved by ball arithmetic, and undecided without it; its ranges are
/// sampled.
#[test]
fn a_damper_takes_balls() {
    let exactly = Interval::exactly;
    let whole = undamped(exactly(0.7), exactly(9.0));
    let with = |low, high| ParameterBox::Ratios {
        omega: exactly(0.7),
        alpha: exactly(9.0),
        damping_ratio: Interval { low, high },
    };
    let damped = with(0.1, 0.2);
    assert_eq!(whole.verdict().unwrap().regime(), Some(Regime::NonSticking));
    let proved = cfg!(feature = "mp").then_some(Regime::NonSticking);
    assert_eq!(damped.verdict().unwrap().regime(), proved);
    let range = damped.range(Output::MaxDisplacement, 50).unwrap().unwrap();
    for zeta in [0.1, 0.13, 0.2] {
        let ratios = Ratios::new(0.7, 9.0).unwrap().with_damping_ratio(zeta).unwrap();
        let value = Output::MaxDisplacement.of(&Response::new(ratios)).unwrap();
        assert!(holds(&range, value) && !range.is_guaranteed(), "{zeta}: {value} {range:?}");
    }
    // A damper that may be absent counts.
    let perhaps = with(0.0, 0.2);
    let range = perhaps.range(Output::MaxDisplacement, 50).unwrap().unwrap();
    for zeta in [0.0, 0.1, 0.2] {
        let ratios = Ratios::new(0.7, 9.0).unwrap().with_damping_ratio(zeta).unwrap();
        let value = Output::MaxDisplacement.of(&Response::new(ratios)).unwrap();
        assert!(holds(&range, value) && !range.is_guaranteed(), "{zeta}: {value} {range:?}");
    }
    assert!(with(-1.0, 1.0).verdict().is_err());
}
