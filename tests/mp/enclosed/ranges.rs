//! Ranges over boxes of ratios: the guaranteed ones at f64, and those proved by ball arithmetic.

use super::{Exact, at_point, double};
use stickslip::enclosed::{Known, KnownRatios, Regime};
use stickslip::uncertainty::{Interval, ParameterBox};
use stickslip::{Border, Float as _, Output, Ratios, Response};

fn undamped(omega: Interval<f64>, alpha: Interval<f64>) -> ParameterBox<f64> {
    ParameterBox::Ratios { omega, alpha, damping_ratio: Interval::exactly(0.0) }
}

/// The guaranteed ranges of `uncertainty` at f64 in boxes of a single point, where only the margin for
/// rounding lies between the two ends. Returns the number of ranges that contain the enclosed value, and the
/// largest fraction of a margin used by rounding.
fn margins_hold(count: u32, seed: f64) -> (u32, f64) {
    let outputs = [
        Output::MaxDisplacement,
        Output::LoopSizeStiffness,
        Output::LoopSizeInertia,
        Output::MinForceRatio,
        Output::Margin,
        Output::BestForceRatio,
        Output::MaxVelocity,
    ];
    let (mut compared, mut largest) = (0, 0.0f64);
    for i in 0..count {
        let share = |step: f64| (f64::from(i) * step + seed).fract();
        let (n, sign) = ((1.0 + 9.0 * share(0.324_717_957_244_746)).floor(), share(0.569_840_290_998_053));
        let omega = match i % 3 {
            0 => 0.21 + 2.8 * share(0.618_033_988_749_895),
            1 => (7.0 * (share(0.618_033_988_749_895) - 0.5)).exp(),
            _ => (1.0 + (sign - 0.5).signum() * 2f64.powf(-2.0 - 49.0 * share(0.618_033_988_749_895))) / n,
        };
        let least = Border::new(omega).unwrap().min_force_ratio;
        let alpha = least * (1.0 + 8.0 * share(0.754_877_666_246_693).powi(6) + 1e-12);
        let found = at_point(omega, alpha);
        let point = undamped(Interval::exactly(omega), Interval::exactly(alpha));
        for output in outputs {
            let Some(range) = point.range(output, 4).unwrap().filter(|range| range.is_guaranteed()) else {
                continue;
            };
            let Some(enclosure) = found.get(output) else { continue };
            let (mid, rad) = (Exact::from(&enclosure.mid), Exact::from(&enclosure.rad));
            let (low, high) = (Exact::from(range.low), Exact::from(range.high));
            let inside = low <= mid - rad && mid + rad <= high;
            assert!(inside, "{omega:e} {alpha:e} {output:?}: {} … {} {enclosure}", range.low, range.high);
            let off = ((mid.scale2(1) - low - high) / (high - low)).to_f64().abs();
            (compared, largest) = (compared + 1, largest.max(off));
        }
    }
    (compared, largest)
}

#[test]
fn guaranteed_ranges_have_the_enclosed_values() {
    let (compared, largest) = margins_hold(600, 0.0);
    assert!(compared > 3000 && largest > 0.05 && largest < 1.0, "{compared} {largest}");
}

/// The same at 10⁵ points, for `docs/uncertainty.md`.
#[test]
#[ignore = "minutes; .ci/slow enclosures"]
#[allow(clippy::print_stdout, reason = "the figures are what it is run for")]
fn margins_of_many_ranges() {
    let count = std::env::var("STICKSLIP_POINTS").map_or(100_000, |n| n.parse().unwrap());
    let (compared, largest) = margins_hold(count, 0.123);
    println!("{count} points, {compared} ranges with their value, at most {largest:.3} of a margin taken");
}

/// Proved ranges contain the outputs at points of the box, for every output, and approach them as the box is
/// cut into more parts.
#[test]
fn proved_ranges_have_the_outputs_of_the_box() {
    let outputs = [
        Output::MaxDisplacement,
        Output::VelocityPhase,
        Output::MaxVelocity,
        Output::Contraction,
        Output::MinForceRatio,
        Output::MaxAcceleration,
        Output::MaxAbsoluteDisplacement,
    ];
    let boxes = [
        (0.7, 0.72, 2.0, 2.1, 144, 4.0),
        (1.4, 1.5, 2.5, 2.5, 40, 4.0),
        (0.4, 0.4, 8.0, 9.0, 6, 10.0),
        (0.41, 0.412, 9.0, 9.0, 6, 10.0),
    ];
    for (o1, o2, a1, a2, pieces, slack) in boxes {
        let interval = |low, high| Interval { low, high };
        let ratios = undamped(interval(o1, o2), interval(a1, a2));
        for output in outputs {
            let values: Vec<f64> = (0..=8)
                .flat_map(|i| (0..=8).map(move |j| (f64::from(i) / 8.0, f64::from(j) / 8.0)))
                .filter_map(|(s, t)| {
                    let ratios = Ratios::new(o1 + s * (o2 - o1), a1 + t * (a2 - a1)).unwrap();
                    output.of(&Response::new(ratios))
                })
                .collect();
            let range = ratios.enclosed(output, pieces).unwrap().unwrap();
            let low = values.iter().copied().fold(f64::INFINITY, f64::min);
            let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let rounding = 1e-13 * low.abs().max(high.abs());
            assert!(range.is_guaranteed() && range.low <= low + rounding && high - rounding <= range.high);
            let wider = (range.high - range.low) - (high - low);
            assert!(
                wider <= slack * (high - low) + 0.02 * high.abs(),
                "{o1} {a1} {output:?}: {range:?} {low} {high}"
            );
        }
    }
    // A box on both sides of the border, of a pole or of Ω = 1 has no proved displacement, but it has a
    // border.
    for (o1, o2, a1, a2) in [(0.7, 0.71, 1.0, 2.0), (0.33, 0.34, 9.0, 9.5), (0.99, 1.01, 2.0, 2.0)] {
        let interval = |low, high| Interval { low, high };
        let ratios = undamped(interval(o1, o2), interval(a1, a2));
        assert_eq!(ratios.enclosed(Output::MaxDisplacement, 50), Ok(None), "{o1} {a1}");
        let border = ratios.enclosed(Output::MinForceRatio, 50).unwrap();
        assert_eq!(border.is_some(), o1 > 0.5, "{o1} {a1}");
    }
}

/// Over one interval an output contains the values of dense samples. Where it changes by at least as large a part as the ratio, the
/// enclosure is at most half again as wide as the range of the samples: 5/4 is sought. Beside an extreme it takes more parts than
/// there are.
#[test]
fn one_interval_gives_nearly_the_range() {
    let sharp = [
        Output::MaxDisplacement,
        Output::MaxVelocity,
        Output::MaxAcceleration,
        Output::TransmittedForce,
        Output::DynamicAmplification,
        Output::MinForceRatio,
        Output::LoopSizeInertia,
        Output::EquivalentDamping,
        Output::EffectiveDampingRatio,
    ];
    let mut state = 7u64;
    let mut drawn = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut compared = 0;
    for n in 0..30 {
        let zeta = if n % 10 == 9 { 0.02 + 0.4 * drawn() } else { 0.0 };
        let omega = if n % 3 == 2 { 1.1 + drawn() } else { 0.51 + 0.4 * drawn() };
        let at =
            |omega: f64, alpha: f64| Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
        let least = Response::new(at(omega, 1.0)).border.min_force_ratio;
        let alpha: f64 = least * (1.3 + 3.0 * drawn());
        let width = 10f64.powf(-4.0 + 2.5 * drawn());
        let (is_omega, half) = (n % 2 == 0, width / 2.0);
        let interval = |x: f64, is_wide: bool| {
            if is_wide {
                Known::between(&double(x * (1.0 - half)), &double(x * (1.0 + half))).unwrap()
            } else {
                double(x)
            }
        };
        let found = KnownRatios::new(&interval(omega, is_omega))
            .with_force_ratio(&interval(alpha, !is_omega))
            .with_damping_ratio(&double(zeta))
            .response(64)
            .unwrap();
        assert_eq!(found.regime, Some(Regime::NonSticking), "{omega} {alpha} {zeta} {width}");
        let samples: Vec<_> = (0..=200)
            .map(|i| 1.0 + half * (f64::from(i) / 100.0 - 1.0))
            .map(|s| Response::new(if is_omega { at(omega * s, alpha) } else { at(omega, alpha * s) }))
            .collect();
        for output in Output::ALL {
            let Some(enclosure) = found.get(output) else { continue };
            let values: Vec<f64> = samples.iter().filter_map(|sample| output.of(sample)).collect();
            let (low, high) = values
                .iter()
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (x.min(low), x.max(high)));
            let (mid, rad) = (enclosure.mid.to_f64(), enclosure.rad.to_f64());
            let rounding = 1e-12 * mid.abs();
            let place = format!("{output:?} at {omega} {alpha} {zeta} {width}: {enclosure}, {low} to {high}");
            assert!(mid - rad <= low + rounding && high - rounding <= mid + rad, "{place}");
            if sharp.contains(&output) && high - low >= width * mid.abs() {
                assert!(2.0 * rad <= 1.5 * (high - low), "{place}");
                compared += 1;
            }
        }
    }
    assert!(compared > 100, "{compared}");
}
