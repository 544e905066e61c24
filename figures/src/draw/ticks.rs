//! The ticks of an axis and their labels.

use crate::Axis;

/// Ticks of an axis as (value, text).
pub(super) fn ticks(axis: &Axis) -> Vec<(f64, String)> {
    let (low, high) = (axis.low.min(axis.high), axis.low.max(axis.high));
    if !axis.logarithmic {
        return round_steps(low, high);
    }
    let powers = powers_of_ten(low, high);
    // One or two ticks would not show the scale.
    if powers.len() > 2 { powers } else { one_two_five(low, high) }
}

/// 1, 2 and 5 times each power of ten; a linear scale where these are still too few.
fn one_two_five(low: f64, high: f64) -> Vec<(f64, String)> {
    let (first, last) = (low.log10().floor() as i32, high.log10().ceil() as i32);
    let tick = |e: i32| {
        [1, 2, 5].map(|m| {
            let value = f64::from(m) * 10f64.powi(e);
            let text = if (-4..6).contains(&e) {
                format!("{value:.*}", usize::try_from(-e).unwrap_or(0))
            } else {
                format!("{m}·{}", power(e))
            };
            (value, text)
        })
    };
    let within = |(value, _): &(f64, String)| *value >= low * (1.0 - 1e-9) && *value <= high * (1.0 + 1e-9);
    let found: Vec<_> = (first..=last).flat_map(tick).filter(within).collect();
    if found.len() > 2 { found } else { round_steps(low, high) }
}

/// Powers of ten, at most nine of them.
fn powers_of_ten(low: f64, high: f64) -> Vec<(f64, String)> {
    let (first, last) = ((low.log10() - 1e-9).ceil() as i32, (high.log10() + 1e-9).floor() as i32);
    let step = ((last - first) / 8 + 1).max(1);
    let from = first + (step - first.rem_euclid(step)) % step;
    (from..=last).step_by(step.unsigned_abs() as usize).map(|e| (10f64.powi(e), power(e))).collect()
}

/// A power of ten in characters that need no markup.
fn power(exponent: i32) -> String {
    if (-2..=3).contains(&exponent) {
        return 10f64.powi(exponent).to_string();
    }
    let raised =
        |c: char| c.to_digit(10).map_or(Some('⁻'), |digit| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit as usize));
    format!("10{}", exponent.to_string().chars().filter_map(raised).collect::<String>())
}

/// Multiples of 1, 2 or 5 times a power of ten, four to nine of them.
fn round_steps(low: f64, high: f64) -> Vec<(f64, String)> {
    let rough = (high - low) / 6.0;
    let size = 10f64.powf(rough.log10().floor());
    let step =
        [1.0, 2.0, 5.0, 10.0].map(|m| m * size).into_iter().find(|s| *s >= rough * 0.8).unwrap_or(rough);
    let digits = (-step.log10().floor()).max(0.0) as usize;
    let (first, last) = ((low / step - 1e-9).ceil() as i64, (high / step + 1e-9).floor() as i64);
    (first..=last).map(|i| i as f64 * step).map(|v| (v, format!("{v:.digits$}").replace('-', "−"))).collect()
}

#[cfg(test)]
mod tests {
    use super::ticks;
    use crate::Axis;

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
            ["10⁻¹⁵", "10⁻¹²", "10⁻⁹", "10⁻⁶", "10⁻³", "1"]
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
}
