//! Boxes of ratios and machines with damping, compared with the same at 256 bits.

use crate::machine_box::machine;
use crate::random::Random;
use stickslip::float::Mp;
use stickslip::uncertainty::{Interval, ParameterBox};
use stickslip::{Border, Drive, Excitation, Oscillator, Output, Ratios, Regime, Response, Verdict};

type Wide = Mp<4>;

fn ratio_box(omega: Interval<f64>, alpha: Interval<f64>, damping_ratio: Interval<f64>) -> ParameterBox<f64> {
    ParameterBox::Ratios { omega, alpha, damping_ratio }
}

fn holds(interval: Interval<f64>, x: Wide) -> bool {
    Wide::from(interval.low) <= x && x <= Wide::from(interval.high)
}

/// For exact ratios, the range exceeds the value at 256 bits at both ends by the outward rounding alone.
#[test]
fn what_is_known_exactly_is_rounded_outward() {
    let mut random = Random(81);
    let mut compared = 0;
    for _ in 0..60 {
        let (omega, zeta) = (random.scale(0.1, 8.0), random.scale(1e-3, 2.0));
        let least =
            Border::of(&Ratios::new(omega, 1.0).unwrap().with_damping_ratio(zeta).unwrap()).min_force_ratio;
        let alpha = (least * random.between(0.5, 3.0)).max(1.01);
        let [o, a, z] = [omega, alpha, zeta].map(Interval::exactly);
        let ratios = Ratios::new(Wide::from(omega), Wide::from(alpha)).unwrap();
        let response = Response::new(ratios.with_damping_ratio(Wide::from(zeta)).unwrap());
        for output in
            [Output::MinForceRatio, Output::Margin, Output::MaxDisplacement, Output::LoopSizeStiffness]
        {
            let range = ratio_box(o, a, z).enclosed(output, 8).unwrap();
            let Some(value) = output.of(&response) else {
                assert_eq!(range, None, "{omega} {alpha} {zeta} {output:?}");
                continue;
            };
            let range = range.unwrap_or_else(|| panic!("{omega} {alpha} {zeta} {output:?}"));
            let found = Interval { low: range.low, high: range.high };
            assert!(
                range.is_guaranteed() && holds(found, value) && range.high - range.low <= 1e-15 * range.high,
                "{omega} {alpha} {zeta} {output:?}: {range:?} {value}"
            );
            compared += 1;
        }
    }
    assert!(compared > 150, "{compared}");
}

/// A box that contains the border is undecided, and one that is 1e-9 away from it is decided.
#[test]
fn the_verdict_changes_at_the_border() {
    let mut random = Random(82);
    let mut decided = 0;
    for _ in 0..40 {
        let (omega, zeta) = (random.scale(0.4, 8.0), random.scale(0.02, 2.0));
        let least =
            Border::of(&Ratios::new(omega, 1.0).unwrap().with_damping_ratio(zeta).unwrap()).min_force_ratio;
        if least < 1.01 {
            continue;
        }
        let [o, z] = [omega, zeta].map(Interval::exactly);
        let verdict = |low: f64, high: f64| {
            let alpha = Interval { low: least * low, high: least * high };
            ratio_box(o, alpha, z).verdict().unwrap()
        };
        let undecided = Verdict::Undecided(Regime::Sticking, Regime::NonSticking);
        assert_eq!(verdict(1.0 + 1e-9, 1.1), Verdict::NonSticking, "{omega} {zeta}");
        assert_eq!(verdict(1.0 - 1e-2, 1.0 - 1e-9), Verdict::Sticking, "{omega} {zeta}");
        assert_eq!(verdict(1.0 - 1e-9, 1.0 + 1e-9), undecided, "{omega} {zeta}");
        assert_eq!(verdict(0.1 / least, 1.0 / least), Verdict::AtRest, "{omega} {zeta}");
        decided += 1;
    }
    assert!(decided > 20, "{decided}");
    // Without a damper the motion at Ω = 1 is unbounded.
    let around_one = Interval { low: 0.99, high: 1.01 };
    let whole = ratio_box(around_one, Interval::exactly(9.0), Interval { low: 0.0, high: 0.5 });
    assert_eq!(whole.verdict().unwrap().regime(), None);
    let damped = ratio_box(around_one, Interval::exactly(9.0), Interval { low: 0.1, high: 0.5 });
    assert_eq!(damped.verdict(), Ok(Verdict::NonSticking));
}

/// The ratios of one machine with a damper, at 256 bits, lie in the box of its ratios at f64.
#[test]
fn one_machine_with_a_damper_is_in_its_own_box() {
    let mut random = Random(83);
    for _ in 0..2000 {
        let parts: [f64; 6] = core::array::from_fn(|_| random.scale(0.01, 100.0));
        let machine = machine(Excitation::Force, parts.map(Interval::exactly));
        let ParameterBox::Ratios { omega, alpha, damping_ratio: zeta } = machine.ratios().unwrap() else {
            panic!("a machine")
        };
        let [m, k, r, a, w, c] = parts.map(Wide::from);
        let body = Oscillator::new(m, k, r).unwrap().with_damping(c).unwrap();
        let ratios = Drive::force(a, w).unwrap().ratios(&body).unwrap();
        assert!(holds(omega, ratios.omega()) && holds(alpha, ratios.alpha()), "{parts:?}");
        assert!(holds(zeta, ratios.damping_ratio()), "{parts:?}");
        assert!(zeta.high - zeta.low < 1e-14 * zeta.high, "{parts:?}");
    }
}

/// Without balls, ranges with damping are sampled. They lie inside the proved ranges, which approach them as
/// the box is cut.
#[test]
fn sampled_ranges_are_within_the_proved_ones() {
    let whole = ratio_box(
        Interval { low: 0.84, high: 0.86 },
        Interval { low: 2.3, high: 2.5 },
        Interval { low: 0.03, high: 0.05 },
    );
    for output in [Output::MinForceRatio, Output::Margin, Output::MaxDisplacement] {
        let sampled = whole.range(output, 200).unwrap().unwrap();
        let excess = |pieces| {
            let proved = whole.enclosed(output, pieces).unwrap().unwrap();
            assert!(!sampled.is_guaranteed() && proved.is_guaranteed(), "{output:?}");
            assert!(
                proved.low <= sampled.low && sampled.high <= proved.high,
                "{output:?}: {sampled:?} {proved:?}"
            );
            proved.high - proved.low - (sampled.high - sampled.low)
        };
        // The excess of a ball is proportional to the width of its part, and 64 times as many parts are a
        // quarter as wide in each direction.
        let (few, many) = (excess(50), excess(3200));
        assert!(many < few / 4.0, "{output:?}: {few} {many}");
    }
}
