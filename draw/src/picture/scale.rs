//! The unit in which an axis is drawn: the one of its label, that unit with another prefix, or with a power of ten.

use super::ticks::{is_of_powers, raised, ticks};
use crate::figure::Axis;

/// The units that take prefixes, each with the largest exponent in use: no ks, no Mm/s.
const UNITS: [(&str, i32); 11] = [
    ("m", 3),
    ("s", 0),
    ("m/s", 0),
    ("m/s²", 0),
    ("N", 9),
    ("N·m", 9),
    ("J", 9),
    ("W", 9),
    ("Hz", 9),
    ("N/m", 9),
    ("Pa", 9),
];
/// The prefixes with their exponents.
const PREFIXES: [(&str, i32); 8] =
    [("p", -12), ("n", -9), ("µ", -6), ("m", -3), ("", 0), ("k", 3), ("M", 6), ("G", 9)];
/// The greatest values of an axis, from the first and below the second, that keep their unit; those of a unit without
/// a suitable prefix.
const PLAIN: (f64, f64) = (1e-2, 1e4);
const PLAIN_AS_THEY_ARE: (f64, f64) = (1e-3, 1e5);
/// The power of ten below which a number is nearly subnormal.
const LEAST: i32 = -300;

/// The label of an axis and its ticks as (value, text), in the unit in which the axis is drawn.
pub(super) fn drawn(axis: &Axis) -> (String, Vec<(f64, String)>) {
    let (exponent, label) = scaled(axis).unwrap_or((0, axis.label.clone()));
    let ticks = if exponent == 0 { ticks(axis) } else { ticks_at(axis, exponent) };
    (label, ticks.into_iter().filter(|(value, _)| is_on(axis, *value)).collect())
}

/// Whether a value has a place on an axis, which far from its ends a rounded number may not have.
fn is_on(axis: &Axis, value: f64) -> bool {
    (-1e-6..=1.0 + 1e-6).contains(&axis.share(value))
}

/// The ticks of an axis whose values are multiples of a power of ten.
fn ticks_at(axis: &Axis, exponent: i32) -> Vec<(f64, String)> {
    // A power with a positive exponent is exact up to 10²².
    let (over, times) = (10f64.powi(exponent.abs()), exponent < 0);
    let down = |value: f64| if times { value * over } else { value / over };
    let up = |value: f64| if times { value / over } else { value * over };
    let own = Axis::new(&axis.label, (down(axis.low), down(axis.high)), axis.logarithmic);
    ticks(&own).into_iter().map(|(value, text)| (up(value), text)).collect()
}

/// The power of ten of an axis and its label with it; `None` for an axis that is drawn as it is.
fn scaled(axis: &Axis) -> Option<(i32, String)> {
    let greatest = axis.low.abs().max(axis.high.abs());
    let is_known = greatest > 0.0 && axis.low.is_finite() && axis.high.is_finite();
    // Powers of ten are their own scale, and an end at 0 has none.
    let has_own = axis.logarithmic && (axis.low.min(axis.high) <= 0.0 || is_of_powers(axis));
    if axis.label.is_empty() || !is_known || has_own {
        return None;
    }
    let (name, unit) = match axis.label.rsplit_once(" (") {
        Some((name, rest)) => (name, rest.strip_suffix(')')?),
        None => (axis.label.as_str(), ""),
    };
    let exponent = 3 * (greatest.log10().floor() as i32).div_euclid(3);
    let other = prefixed(unit, exponent);
    let (least, most) = if other.is_some() { PLAIN } else { PLAIN_AS_THEY_ARE };
    if exponent < LEAST || (least..most).contains(&greatest) {
        return None;
    }
    let unit = other.unwrap_or_else(|| format!("{} {unit}", raised(exponent)).trim_end().to_owned());
    Some((exponent, format!("{name} ({unit})")))
}

/// The unit that is this power of ten times another; `None` where no prefix makes it.
fn prefixed(unit: &str, exponent: i32) -> Option<String> {
    let own = PREFIXES.iter().find_map(|&(prefix, of)| {
        let base = unit.strip_prefix(prefix)?;
        UNITS.iter().find(|(name, _)| *name == base).map(|&(name, most)| (name, most, of))
    });
    let (base, most, own) = own?;
    let (prefix, _) = PREFIXES.iter().find(|(_, of)| *of == own + exponent && *of <= most)?;
    Some(format!("{prefix}{base}"))
}

#[cfg(test)]
mod tests {
    use super::drawn;
    use crate::figure::Axis;

    fn label(name: &str, ends: (f64, f64)) -> String {
        drawn(&Axis::new(name, ends, false)).0
    }

    #[test]
    fn small_and_large_values_have_a_prefix() {
        for (ends, unit, due) in [
            ((0.0, 1e-5), "m", "µm"),
            ((-8e-3, 7e-3), "m", "mm"),
            ((0.0, 2.5e-5), "mm", "nm"),
            ((0.0, 3e-3), "mm", "µm"),
            ((0.0, 25_000.0), "mm", "m"),
            ((0.0, 1.2e7), "N", "MN"),
            ((0.0, 12_000.0), "kN", "MN"),
            ((0.0, 3e-4), "kN", "mN"),
            ((0.0, 0.004), "s", "ms"),
            ((0.0, 2e-6), "m/s²", "µm/s²"),
            ((0.0, 20_000.0), "Hz", "kHz"),
            ((0.0, 5e8), "m/s", "10⁶ m/s"),
            // No prefix is in use.
            ((0.0, 20_000.0), "s", "s"),
            ((0.0, 300_000.0), "m/s", "10³ m/s"),
            ((0.0, 2e-9), "mm", "pm"),
            ((0.0, 2e-5), "in", "10⁻⁶ in"),
            ((0.0, 2e-5), "g", "10⁻⁶ g"),
            ((0.0, 1e-20), "m", "10⁻²¹ m"),
            // The values keep the unit that was asked for.
            ((0.0, 0.02), "m", "m"),
            ((0.0, 9000.0), "N", "N"),
        ] {
            assert_eq!(label(&format!("a ({unit})"), ends), format!("a ({due})"), "{ends:?} {unit}");
        }
        assert_eq!(label("displacement x/B", (0.0, 2.0)), "displacement x/B");
        assert_eq!(label("displacement x/B", (0.0, 2e-5)), "displacement x/B (10⁻⁶)");
        assert_eq!(label("displacement x/B", (-4e8, 4e7)), "displacement x/B (10⁶)");
        assert_eq!(label("", (0.0, 1e-9)), "");
    }

    #[test]
    fn the_ticks_are_in_the_unit_of_the_label() {
        let texts = |axis: &Axis| drawn(axis).1.into_iter().map(|(_, text)| text).collect::<Vec<_>>();
        assert_eq!(texts(&Axis::linear("a (m)", 0.0, 1e-5)), ["0", "2", "4", "6", "8", "10"]);
        assert_eq!(texts(&Axis::linear("a (mm)", 0.0, 25_000.0)), ["0", "5", "10", "15", "20", "25"]);
        assert_eq!(texts(&Axis::logarithmic("a (m)", 3e-5, 3e-4)), ["50", "100", "200"]);
        assert_eq!(drawn(&Axis::logarithmic("a (m)", 1e-9, 1e-4)).0, "a (m)");
        for (value, text) in drawn(&Axis::linear("a (m)", -3e-7, 4e-7)).1 {
            let read: f64 = text.replace('−', "-").parse().unwrap();
            assert!((value - read * 1e-9).abs() <= 1e-15 * value.abs(), "{value} {text}");
        }
    }

    /// Every value of an axis has at most four digits before the point in the unit that is drawn.
    #[test]
    fn numbers_are_short_at_every_magnitude() {
        for unit in ["m", "mm", "kN", "in", "m/s", "s", "J", "Hz"] {
            for exponent in -290..300 {
                let high = 3.3 * 10f64.powi(exponent);
                let (label, ticks) = drawn(&Axis::linear(&format!("a ({unit})"), 0.0, high));
                let longest = ticks.iter().map(|(_, text)| text.chars().count()).max().unwrap();
                assert!(longest <= 6 && ticks.len() > 3, "{unit} {exponent}: {label} {ticks:?}");
            }
        }
    }
}
