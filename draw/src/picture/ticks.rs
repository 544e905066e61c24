//! The ticks of an axis and their labels: for any two ends, also equal, subnormal, infinite and NaN ones.

use crate::figure::Axis;

/// The most ticks of an axis.
const MOST: usize = 12;

/// The most letters of a label beside the axis' title; a longer one has a power of ten.
const LETTERS: usize = 7;

/// Ticks of an axis as (value, text): at most twelve, within its ends, and none where an end is not finite or has no logarithm.
pub(super) fn ticks(axis: &Axis) -> Vec<(f64, String)> {
    let (low, high) = (axis.low.min(axis.high), axis.low.max(axis.high));
    if !(axis.low.is_finite() && axis.high.is_finite()) || axis.logarithmic && low <= 0.0 {
        return Vec::new();
    }
    if !axis.logarithmic {
        return round_steps(low, high);
    }
    if is_of_powers(axis) { powers_of_ten(low, high) } else { one_two_five(low, high) }
}

/// Whether the ticks of a logarithmic axis are powers of ten: one or two would not show the scale.
pub(super) fn is_of_powers(axis: &Axis) -> bool {
    powers_of_ten(axis.low.min(axis.high), axis.low.max(axis.high)).len() > 2
}

/// 1, 2 and 5 times each power of ten; a linear scale where these are still too few.
fn one_two_five(low: f64, high: f64) -> Vec<(f64, String)> {
    let (first, last) = (low.log10().floor() as i32, high.log10().ceil() as i32);
    let tick = |e: i32| [1, 2, 5].map(|m| (m, e, f64::from(m) * 10f64.powi(e)));
    let within = |(_, _, value): &(i32, i32, f64)| is_within((low, high), *value);
    let found: Vec<_> = (first..=last).flat_map(tick).filter(within).collect();
    if !(3..=MOST).contains(&found.len()) {
        return round_steps(low, high);
    }
    let is_plain = found.iter().all(|(_, e, _)| (-4..6).contains(e));
    let text = |(m, e, value): (i32, i32, f64)| {
        let decimals = usize::try_from(-e).unwrap_or(0);
        (value, if is_plain { format!("{value:.decimals$}") } else { format!("{m}·{}", raised(e)) })
    };
    found.into_iter().map(text).collect()
}

/// Whether a positive value lies between two ends, or on them but for rounding.
fn is_within((low, high): (f64, f64), value: f64) -> bool {
    value >= low * (1.0 - 1e-9) && value <= high * (1.0 + 1e-9)
}

/// The values without labels between the ticks of a logarithmic axis: the multiples of each power of ten or, where
/// not each power has a label, the powers. None where the ticks are those of a linear axis.
pub(super) fn minor(axis: &Axis) -> Vec<f64> {
    let (low, high) = (axis.low.min(axis.high), axis.low.max(axis.high));
    let found: Vec<_> = ticks(axis).into_iter().map(|(value, _)| value).collect();
    let [first, second, ..] = found.as_slice() else { return Vec::new() };
    if !axis.logarithmic {
        return Vec::new();
    }
    let is_scale = is_of_powers(axis) || *second > first * 1.9 && found.len() < MOST;
    if !is_scale {
        return Vec::new();
    }
    let multiples = if second / first > 11.0 { 1..=1 } else { 1..=9 };
    let exponents = low.log10().floor() as i32..=high.log10().floor() as i32;
    let values = exponents.flat_map(|e| multiples.clone().map(move |m| f64::from(m) * 10f64.powi(e)));
    let is_between = |value: &f64| {
        is_within((low, high), *value) && !found.iter().any(|tick| (value / tick - 1.0).abs() < 1e-9)
    };
    values.filter(is_between).collect()
}

/// Powers of ten, at most nine of them.
fn powers_of_ten(low: f64, high: f64) -> Vec<(f64, String)> {
    let (first, last) = ((low.log10() - 1e-9).ceil() as i32, (high.log10() + 1e-9).floor() as i32);
    let step = ((last - first) / 8 + 1).max(1);
    let from = first + (step - first.rem_euclid(step)) % step;
    let exponents = || (from..=last).step_by(step.unsigned_abs() as usize);
    // Numbers and powers side by side would be read as two scales.
    let is_plain = exponents().all(|e| (-2..=3).contains(&e));
    let text = |value: f64, e| if is_plain { value.to_string() } else { raised(e) };
    let powers = exponents().map(|e| (10f64.powi(e), text(10f64.powi(e), e)));
    // The powers below 10⁻³⁰⁷ may be 0.
    powers.filter(|(value, _)| *value > 0.0).collect()
}

/// 10ᵉ.
pub(super) fn raised(exponent: i32) -> String {
    let letter =
        |c: char| c.to_digit(10).map_or(Some('⁻'), |digit| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit as usize));
    format!("10{}", exponent.to_string().chars().filter_map(letter).collect::<String>())
}

/// Multiples of 1, 2 or 5 times a power of ten, four to nine of them; the ends themselves where the numbers between
/// them are too few for steps.
fn round_steps(low: f64, high: f64) -> Vec<(f64, String)> {
    /// Steps that are rounded to a thousandth of themselves are not round.
    const COARSE: f64 = 1000.0;
    let width = high - low;
    let rough = if width.is_finite() { width / 6.0 } else { high / 6.0 - low / 6.0 };
    let size = 10f64.powf(rough.log10().floor());
    let step =
        [1.0, 2.0, 5.0, 10.0].map(|m| m * size).into_iter().find(|s| *s >= rough * 0.8).unwrap_or(rough);
    let finest = COARSE * (f64::EPSILON * low.abs().max(high.abs())).max(f64::MIN_POSITIVE);
    if step < finest || !step.is_finite() {
        let ends = if low < high { vec![low, high] } else { vec![low] };
        return ends.into_iter().map(|value| (value, exponential(value))).collect();
    }
    let (first, last) = ((low / step - 1e-9).ceil() as i64, (high / step + 1e-9).floor() as i64);
    let values = (first..=last).take(MOST).map(|i| i as f64 * step).filter(|value| value.is_finite());
    labelled(values.collect(), step.log10().floor() as i32)
}

/// Values with their labels, all with decimals down to the place 10ᵉ or all with the same power of ten.
fn labelled(values: Vec<f64>, place: i32) -> Vec<(f64, String)> {
    let decimals = usize::try_from(-place).unwrap_or(0);
    // The length is known without the text, which could have hundreds of letters.
    let letters = |value: &f64| {
        let digits = value.abs().max(1.0).log10().floor() as usize + 1;
        digits + decimals + usize::from(decimals > 0) + usize::from(*value < 0.0)
    };
    if values.iter().all(|value| letters(value) <= LETTERS) {
        return values.into_iter().map(|v| (v, format!("{v:.decimals$}").replace('-', "−"))).collect();
    }
    let exponent = |value: f64| value.abs().log10().floor() as i32;
    let common =
        values.iter().filter(|value| **value != 0.0).map(|value| exponent(*value)).max().unwrap_or(0);
    let decimals = usize::try_from(common - place).unwrap_or(0).min(16);
    let text = |value: f64| {
        if value == 0.0 {
            return "0".to_owned();
        }
        // In two steps where the power itself would be subnormal.
        let scaled =
            if common < -300 { value * 1e300 / 10f64.powi(common + 300) } else { value / 10f64.powi(common) };
        times(&format!("{scaled:.decimals$}"), common)
    };
    values.into_iter().map(|value| (value, text(value))).collect()
}

/// All digits of a number, as m·10ᵉ.
fn exponential(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let text = format!("{value:e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    times(digits, exponent.parse().unwrap_or(0))
}

/// A number in four digits, as on an axis.
pub(super) fn number(value: f64) -> String {
    if value == 0.0 || (1e-3..1e6).contains(&value.abs()) {
        let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
        return format!("{rounded}").replace('-', "−");
    }
    let text = format!("{value:.3e}");
    exponential(text.parse().unwrap_or(value))
}

/// These digits times 10ᵉ.
fn times(digits: &str, exponent: i32) -> String {
    let digits = digits.replace('-', "−");
    if exponent == 0 { digits } else { format!("{digits}·{}", raised(exponent)) }
}

#[cfg(test)]
mod tests {
    use super::{MOST, minor, ticks};
    use crate::figure::{Axis, Figure, Panel, Series, Style};
    use crate::plane::{Plane, Scale};
    use proptest::prelude::*;
    use proptest::test_runner::RngSeed;

    fn texts(axis: &Axis) -> Vec<String> {
        ticks(axis).into_iter().map(|(_, text)| text).collect()
    }

    #[test]
    fn ticks_are_round_and_few() {
        assert_eq!(texts(&Axis::linear("", 0.0, 2.0)), ["0.0", "0.5", "1.0", "1.5", "2.0"]);
        assert_eq!(texts(&Axis::linear("", -1.1, 1.1)), ["−1.0", "−0.5", "0.0", "0.5", "1.0"]);
        assert_eq!(texts(&Axis::logarithmic("", 0.1, 1000.0)), ["0.1", "1", "10", "100", "1000"]);
        assert_eq!(
            texts(&Axis::logarithmic("", 1e-17, 1.0)),
            ["10⁻¹⁵", "10⁻¹²", "10⁻⁹", "10⁻⁶", "10⁻³", "10⁰"]
        );
        assert_eq!(texts(&Axis::logarithmic("", 0.05, 2.0)), ["0.05", "0.1", "0.2", "0.5", "1", "2"]);
        assert_eq!(texts(&Axis::logarithmic("", 30.0, 400.0)), ["50", "100", "200"]);
        assert_eq!(texts(&Axis::logarithmic("", 1.1, 1.9)), ["1.2", "1.4", "1.6", "1.8"]);
        // An axis that runs downwards, as in a key with the light end below.
        assert_eq!(texts(&Axis::linear("", 1.0, 0.0)), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        for high in [0.7, 1.3, 4.0, 9.9, 16.0, 30.0, 123.0] {
            assert!((4..=10).contains(&ticks(&Axis::linear("", 0.0, high)).len()), "{high}");
        }
    }

    #[test]
    fn long_labels_have_a_power_of_ten() {
        assert_eq!(
            texts(&Axis::linear("", 0.0, 1e-5)),
            ["0", "0.2·10⁻⁵", "0.4·10⁻⁵", "0.6·10⁻⁵", "0.8·10⁻⁵", "1.0·10⁻⁵"]
        );
        assert_eq!(texts(&Axis::linear("", -1e9, 1e9)), ["−1.0·10⁹", "−0.5·10⁹", "0", "0.5·10⁹", "1.0·10⁹"]);
    }

    /// Either all labels of an axis are powers of ten, or none is.
    #[test]
    fn an_axis_has_one_kind_of_labels() {
        assert_eq!(texts(&Axis::logarithmic("", 1e-3, 0.1)), ["10⁻³", "10⁻²", "10⁻¹"]);
        assert_eq!(
            texts(&Axis::logarithmic("", 0.01, 1e4)),
            ["10⁻²", "10⁻¹", "10⁰", "10¹", "10²", "10³", "10⁴"]
        );
        assert_eq!(texts(&Axis::logarithmic("", 3e-5, 3e-4)), ["5·10⁻⁵", "1·10⁻⁴", "2·10⁻⁴"]);
        for (low, high) in [(1e-4, 2.0), (0.5, 2e5), (1e5, 3e6), (7e-6, 9e-4), (1e-17, 1e17)] {
            let found = texts(&Axis::logarithmic("", low, high));
            let raised =
                found.iter().filter(|text| text.contains("10") && !text.ends_with(['0', '1'])).count();
            assert!(found.len() > 2 && (raised == 0 || raised == found.len()), "{found:?}");
        }
        for (low, high) in [(0.0, 3e-7), (-4e8, 7e9), (0.0, 1.1e6), (-1e-300, 2e-303)] {
            let found = texts(&Axis::linear("", low, high));
            let powers: std::collections::BTreeSet<_> = found
                .iter()
                .filter(|text| *text != "0")
                .map(|text| text.split_once('·').map(|t| t.1))
                .collect();
            assert!(found.len() > 3 && powers.len() == 1, "{found:?}");
        }
    }

    #[test]
    fn a_logarithmic_axis_has_minor_ticks() {
        let near = |found: Vec<f64>, due: &[f64]| {
            assert_eq!(found.len(), due.len(), "{found:?}");
            assert!(found.iter().zip(due).all(|(a, b)| (a / b - 1.0).abs() < 1e-12), "{found:?}");
        };
        let hundred: Vec<f64> = (2..10).chain((20..100).step_by(10)).map(f64::from).collect();
        near(minor(&Axis::logarithmic("", 1.0, 100.0)), &hundred);
        near(minor(&Axis::logarithmic("", 100.0, 1.0)), &hundred);
        near(minor(&Axis::logarithmic("", 30.0, 400.0)), &[30.0, 40.0, 60.0, 70.0, 80.0, 90.0, 300.0, 400.0]);
        near(minor(&Axis::logarithmic("", 1e-4, 1e8)), &[1e-3, 1e-1, 1e1, 1e3, 1e5, 1e7]);
        near(minor(&Axis::logarithmic("", 1.1, 1.9)), &[]);
        near(minor(&Axis::linear("", 1.0, 100.0)), &[]);
    }

    #[test]
    fn ends_without_numbers_between_them_are_ticks() {
        assert_eq!(texts(&Axis::linear("", 3.0, 3.0)), ["3"]);
        assert_eq!(texts(&Axis::linear("", 0.0, 5e-324)), ["0", "5·10⁻³²⁴"]);
        assert_eq!(texts(&Axis::linear("", 0.0, f64::INFINITY)).len(), 0);
        assert_eq!(texts(&Axis::logarithmic("", 0.0, 1.0)).len(), 0);
        assert!(texts(&Axis::linear("", -f64::MAX, f64::MAX)).len() > 3);
    }

    /// Any number: of each sign and magnitude, and beside others.
    fn number() -> impl Strategy<Value = f64> {
        prop_oneof![
            any::<u64>().prop_map(f64::from_bits),
            (-330.0..309.0).prop_map(|e: f64| 10f64.powf(e)),
            (-10i32..10).prop_map(f64::from),
        ]
    }

    /// As `tests/drawn` of the library.
    fn cases(count: u32) -> ProptestConfig {
        let given = ProptestConfig::with_cases(count);
        let rng_seed = match given.rng_seed {
            RngSeed::Random => RngSeed::Fixed(1),
            seed @ RngSeed::Fixed(_) => seed,
        };
        ProptestConfig { rng_seed, failure_persistence: None, ..given }
    }

    proptest! {
        #![proptest_config(cases(20_000))]

        #[test]
        fn ticks_are_few_and_short_for_any_ends(
            low in number(),
            high in number(),
            beside in 0u64..2000,
            is_narrow: bool,
            logarithmic: bool,
        ) {
            let high = if is_narrow { f64::from_bits(low.to_bits().saturating_add(beside)) } else { high };
            let axis = Axis::new("", (low, high), logarithmic);
            let found = ticks(&axis);
            prop_assert!(found.len() <= MOST, "{found:?}");
            let has_scale = low.is_finite() && high.is_finite() && !(logarithmic && low.min(high) <= 0.0);
            prop_assert_eq!(found.is_empty(), !has_scale);
            let (least, greatest) = (low.min(high), low.max(high));
            let slack = 1e-8 * (greatest / 2.0 - least / 2.0) + 1e-8 * if logarithmic { greatest.abs() } else { 0.0 };
            for (value, text) in &found {
                prop_assert!(*value >= least - slack && *value <= greatest + slack, "{value} {text}");
                prop_assert!(!text.is_empty() && text.chars().count() <= 27, "{value} {text}");
            }
            let distinct: std::collections::BTreeSet<_> = found.iter().map(|(_, text)| text).collect();
            prop_assert_eq!(distinct.len(), found.len());
        }

    }

    proptest! {
        #![proptest_config(cases(1_000))]

        #[test]
        fn a_picture_of_any_values_is_drawn(
            ends in [number(), number(), number(), number()],
            logarithmic: [bool; 2],
            points in proptest::collection::vec((number(), number()), 0..12),
            shades in [number(), number()],
        ) {
            let [left, right, low, high] = ends;
            let axis = |ends, logarithmic| Axis::new("a", ends, logarithmic);
            let styles = [
                Style::Line, Style::Dashed, Style::Marked(2), Style::Marks, Style::Dots, Style::Beyond, Style::Arrow,
                Style::Named, Style::Thick,
            ];
            let series = styles.map(|style| Series::new("s", style, 1, points.clone()));
            let [x_log, y_log] = logarithmic;
            let panel = Panel::new("", axis((left, right), x_log), axis((low, high), y_log), series.to_vec());
            let x: Vec<f64> = points.iter().map(|point| point.0).collect();
            let y: Vec<f64> = points.iter().map(|point| point.1).collect();
            let values: Vec<f64> = y.iter().flat_map(|y| x.iter().map(move |x| x + y)).collect();
            let scale = Scale::Shades { low: shades[0], high: shades[1], logarithmic: x_log };
            let plane = Plane { label: "p".to_owned(), x, y, values, scale };
            for panel in [panel.clone(), panel.over(plane)] {
                let drawing = Figure::new("f", "title", "", [panel]).svg().unwrap();
                prop_assert!(drawing.ends_with("</svg>\n") || drawing.ends_with("</svg>"));
            }
        }
    }
}
