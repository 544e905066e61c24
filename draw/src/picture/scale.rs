//! The unit in which an axis is drawn: the one of its label, that unit with another prefix, or with a power of ten.

use super::ticks::{is_of_powers, raised, ticks};
use crate::figure::{Axis, Figure};
use std::borrow::Cow;
use std::collections::BTreeMap;

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

/// The figure whose axes of one unit know the greatest value of them all.
pub(super) fn in_one_unit(figure: &Figure) -> Cow<'_, Figure> {
    let mut greatest: BTreeMap<&str, f64> = BTreeMap::new();
    let axes = || figure.panels.iter().flat_map(|panel| [&panel.x, &panel.y]);
    for axis in axes() {
        if let Some((_, unit)) = parts(axis).filter(|(_, unit)| !unit.is_empty()) {
            let most = greatest.entry(unit).or_default();
            *most = most.max(size(axis));
        }
    }
    let due = |axis: &Axis| parts(axis).and_then(|(_, unit)| greatest.get(unit).copied()).unwrap_or_default();
    if axes().all(|axis| due(axis) <= size(axis)) {
        return Cow::Borrowed(figure);
    }
    let mut own = figure.clone();
    for axis in own.panels.iter_mut().flat_map(|panel| [&mut panel.x, &mut panel.y]) {
        axis.beside = due(axis);
    }
    Cow::Owned(own)
}

/// The greatest magnitude on an axis.
fn size(axis: &Axis) -> f64 {
    axis.low.abs().max(axis.high.abs())
}

/// The name and the unit of an axis that may be drawn in another unit.
fn parts(axis: &Axis) -> Option<(&str, &str)> {
    let is_known = size(axis) > 0.0 && axis.low.is_finite() && axis.high.is_finite();
    // Powers of ten are their own scale, and an end at 0 has none.
    let has_own = axis.logarithmic && (axis.low.min(axis.high) <= 0.0 || is_of_powers(axis));
    if axis.label.is_empty() || !is_known || has_own {
        return None;
    }
    match axis.label.rsplit_once(" (") {
        Some((name, rest)) => Some((name, rest.strip_suffix(')')?)),
        None => Some((axis.label.as_str(), "")),
    }
}

/// The power of ten of an axis and its label with it; `None` for an axis that is drawn as it is.
fn scaled(axis: &Axis) -> Option<(i32, String)> {
    let ((name, unit), own) = (parts(axis)?, size(axis));
    let shared = power(unit, own.max(axis.beside));
    // Beside far greater values an axis keeps a unit of its own, in which its numbers are short.
    let exponent = shared.as_ref().map_or(0, |(exponent, _)| *exponent);
    let is_far = axis.beside > own && own < PLAIN_AS_THEY_ARE.0 * 10f64.powi(exponent);
    let (exponent, unit) = if is_far { power(unit, own) } else { shared }?;
    Some((exponent, format!("{name} ({unit})")))
}

/// The power of ten in which values up to the greatest one are drawn, and the unit with it.
fn power(unit: &str, greatest: f64) -> Option<(i32, String)> {
    let exponent = 3 * (greatest.log10().floor() as i32).div_euclid(3);
    let other = prefixed(unit, exponent);
    let (least, most) = if other.is_some() { PLAIN } else { PLAIN_AS_THEY_ARE };
    if exponent < LEAST || (least..most).contains(&greatest) {
        return None;
    }
    Some((exponent, other.unwrap_or_else(|| format!("{} {unit}", raised(exponent)).trim_end().to_owned())))
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
    use super::{drawn, in_one_unit};
    use crate::figure::{Axis, Figure, Panel};

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
    fn axes_of_one_unit_are_drawn_in_one() {
        let labels = |ends: &[(&str, f64)]| {
            let panel = |(label, high): &(&str, f64)| {
                let y = Axis::linear(&format!("a ({label})"), 0.0, *high);
                Panel::new("", Axis::linear("period (s)", 0.0, 4.0), y, Vec::new())
            };
            let figure = Figure::new("", "", "", ends.iter().map(panel).collect::<Vec<_>>());
            let shared = in_one_unit(&figure);
            shared.panels.iter().map(|panel| drawn(&panel.y).0).collect::<Vec<_>>()
        };
        // The peak of a spectrum in metres, and what remains of it.
        assert_eq!(labels(&[("m", 0.03), ("m", 0.002), ("m/s²", 0.004)]), ["a (m)", "a (m)", "a (mm/s²)"]);
        assert_eq!(labels(&[("m", 4e-4), ("m", 0.008)]), ["a (mm)", "a (mm)"]);
        assert_eq!(labels(&[("N", 2e4), ("N", 300.0)]), ["a (kN)", "a (kN)"]);
        // A thousandth of a thousandth has no room in that unit.
        assert_eq!(labels(&[("m", 3.0), ("m", 2e-6)]), ["a (m)", "a (µm)"]);
        assert_eq!(labels(&[("m", 3.0), ("mm", 8e-4)]), ["a (m)", "a (nm)"]);
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
