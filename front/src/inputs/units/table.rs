//! The known units, each exact by definition, and their products and quotients.

use super::factor::Factor;
use Kind::{Acceleration, Angle, Energy, Force, Frequency, Length, Mass, Ratio, Time};
use stickslip::internal::{Dimension, Kind};

/// A unit: its dimension, and its value in kg, m, s and rad.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Unit {
    pub(super) dimension: Dimension,
    pub(super) factor: Factor,
}

/// A row of the table.
type Row = (&'static str, Kind, u128, u128, i8);

/// Symbol, kind, and numerator, denominator and power of π of the factor. `g` is the gram or standard
/// gravity, and `lb` and `oz` a mass or a force, depending on the quantity. The pound is 0.45359237 kg, the inch 0.0254 m, standard gravity
/// 9.80665 m/s².
#[rustfmt::skip]
const TABLE: &[Row] = &[
    ("%", Ratio, 1, 100, 0),
    ("kg", Mass, 1, 1, 0), ("g", Mass, 1, 1000, 0), ("mg", Mass, 1, 1_000_000, 0), ("t", Mass, 1000, 1, 0),
    ("tonne", Mass, 1000, 1, 0),
    ("lb", Mass, 45_359_237, 100_000_000, 0), ("lbm", Mass, 45_359_237, 100_000_000, 0),
    ("lbs", Mass, 45_359_237, 100_000_000, 0),
    ("oz", Mass, 45_359_237, 1_600_000_000, 0),
    ("slug", Mass, 8_896_443_230_521, 609_600_000_000, 0), ("slugs", Mass, 8_896_443_230_521, 609_600_000_000, 0),
    ("m", Length, 1, 1, 0), ("km", Length, 1000, 1, 0), ("cm", Length, 1, 100, 0), ("mm", Length, 1, 1000, 0),
    ("um", Length, 1, 1_000_000, 0), ("µm", Length, 1, 1_000_000, 0), ("μm", Length, 1, 1_000_000, 0),
    ("nm", Length, 1, 1_000_000_000, 0),
    ("in", Length, 254, 10_000, 0), ("ft", Length, 3048, 10_000, 0), ("mil", Length, 254, 10_000_000, 0),
    ("inch", Length, 254, 10_000, 0), ("mils", Length, 254, 10_000_000, 0), ("thou", Length, 254, 10_000_000, 0),
    ("s", Time, 1, 1, 0), ("sec", Time, 1, 1, 0), ("ms", Time, 1, 1000, 0), ("us", Time, 1, 1_000_000, 0), ("µs", Time, 1, 1_000_000, 0),
    ("μs", Time, 1, 1_000_000, 0), ("min", Time, 60, 1, 0), ("h", Time, 3600, 1, 0),
    ("rad", Angle, 1, 1, 0), ("deg", Angle, 1, 180, 1), ("°", Angle, 1, 180, 1), ("rev", Angle, 2, 1, 1),
    ("Hz", Frequency, 2, 1, 1), ("mHz", Frequency, 2, 1000, 1), ("kHz", Frequency, 2000, 1, 1),
    ("hz", Frequency, 2, 1, 1), ("khz", Frequency, 2000, 1, 1),
    ("rpm", Frequency, 1, 30, 1), ("RPM", Frequency, 1, 30, 1), ("cpm", Frequency, 1, 30, 1),
    ("g", Acceleration, 980_665, 100_000, 0), ("gn", Acceleration, 980_665, 100_000, 0),
    ("mg", Acceleration, 980_665, 100_000_000, 0), ("gal", Acceleration, 1, 100, 0), ("Gal", Acceleration, 1, 100, 0),
    ("N", Force, 1, 1, 0), ("mN", Force, 1, 1000, 0), ("kN", Force, 1000, 1, 0), ("MN", Force, 1_000_000, 1, 0),
    ("daN", Force, 10, 1, 0),
    ("lbf", Force, 44_482_216_152_605, 10_000_000_000_000, 0),
    ("lb", Force, 44_482_216_152_605, 10_000_000_000_000, 0),
    ("lbs", Force, 44_482_216_152_605, 10_000_000_000_000, 0),
    ("ozf", Force, 44_482_216_152_605, 160_000_000_000_000, 0),
    ("oz", Force, 44_482_216_152_605, 160_000_000_000_000, 0),
    ("klb", Force, 44_482_216_152_605, 10_000_000_000, 0),
    ("kip", Force, 44_482_216_152_605, 10_000_000_000, 0),
    ("kips", Force, 44_482_216_152_605, 10_000_000_000, 0),
    ("tf", Force, 980_665, 100, 0),
    ("kgf", Force, 980_665, 100_000, 0),
    ("J", Energy, 1, 1, 0), ("mJ", Energy, 1, 1000, 0), ("kJ", Energy, 1000, 1, 0),
];

fn unit(&(_, kind, p, q, pi): &Row) -> Unit {
    Unit { dimension: kind.dimension(), factor: Factor::new(p, q, pi) }
}

/// The symbol of a mass of this size, if there is one.
pub(super) fn mass_of(factor: Factor) -> Option<&'static str> {
    TABLE.iter().find(|row| row.1 == Mass && unit(row).factor == factor).map(|row| row.0)
}

/// The symbol `text` in the table with its unit, if its dimension is this one.
pub(super) fn symbol(text: &str, dimension: Dimension) -> Option<(&'static str, Unit)> {
    let row = TABLE.iter().find(|row| row.0 == text && row.1.dimension() == dimension)?;
    Some((row.0, unit(row)))
}

/// The units that are written after a unit of force without a sign between them, as in `Ns/m` and `kNm`.
const AFTER_FORCE: [&str; 3] = ["s", "mm", "m"];

/// The possible meanings of one name: none if it is unknown, two for `g`.
fn atoms(name: &str) -> Vec<Unit> {
    let named = |name| -> Vec<Unit> { TABLE.iter().filter(|row| row.0 == name).map(unit).collect() };
    let whole = named(name);
    if !whole.is_empty() {
        return whole;
    }
    let joined = AFTER_FORCE.iter().find_map(|second| {
        let (first, _) = symbol(name.strip_suffix(second)?, Force.dimension())?;
        Some(
            named(first)
                .into_iter()
                .flat_map(|a| named(second).into_iter().filter_map(move |b| product(a, b, 1))),
        )
    });
    joined.into_iter().flatten().collect()
}

/// The possible meanings of a unit such as `kN/mm`, `m/s²` or `oz-in`: none if it is unknown, two for `g`.
pub(super) fn parse(text: &str) -> Vec<Unit> {
    let mut meanings = vec![Unit { dimension: [0; 4], factor: Factor::ONE }];
    let mut sign = 1i8;
    let mut rest = text;
    loop {
        let end = rest.find(['/', '*', '·', '⋅', '-']).unwrap_or(rest.len());
        let (part, after) = rest.split_at(end);
        let (name, exponent) = with_exponent(part.trim());
        let atoms = atoms(name);
        let products = meanings.iter().flat_map(|whole| {
            atoms.iter().filter_map(|atom| product(*whole, *atom, sign.checked_mul(exponent)?))
        });
        meanings = products.collect();
        let mut left = after.chars();
        match left.next() {
            None => return meanings,
            Some(separator) => sign = if separator == '/' { -1 } else { 1 },
        }
        rest = left.as_str();
    }
}

/// A name and its exponent: `s^2`, `s2`, `s²`; the exponent is 1 by default, and 0 if it is invalid.
fn with_exponent(part: &str) -> (&str, i8) {
    let Some((at, last)) = part.char_indices().next_back() else { return (part, 1) };
    let exponent = match last {
        '2' | '²' => 2,
        '3' | '³' => 3,
        _ => return (part, 1),
    };
    let name = part.get(..at).unwrap_or_default();
    (name.strip_suffix('^').unwrap_or(name), exponent)
}

fn product(whole: Unit, atom: Unit, exponent: i8) -> Option<Unit> {
    let mut dimension = whole.dimension;
    for (sum, part) in dimension.iter_mut().zip(atom.dimension) {
        *sum = sum.checked_add(part.checked_mul(exponent)?)?;
    }
    Some(Unit { dimension, factor: whole.factor.and(atom.factor.power(exponent)?)? })
}

#[cfg(test)]
mod tests {
    use super::{Factor, TABLE, parse};

    /// Derived units agree with products of the defined ones; a slug is 1 lbf s²/ft.
    #[test]
    fn derived_units_are_made_of_the_defined_ones() {
        let factor = |text: &str| parse(text)[0].factor.and(Factor::ONE).unwrap();
        assert_eq!(factor("slug"), factor("lbf*s^2/ft"));
        assert_eq!(factor("lbf"), factor("lb*ft/s2").and(Factor::new(980_665, 30_480, 0)).unwrap());
        assert_eq!(factor("kip/in"), factor("lbf/mil"));
        assert_eq!((factor("kips"), factor("kips/in")), (factor("kip"), factor("kip/in")));
        assert_eq!(factor("rpm"), factor("rev/min"));
        assert_eq!(factor("J"), factor("N·m"));
        assert_eq!(factor("lbf*ft"), factor("ozf*inch").and(Factor::new(192, 1, 0)).unwrap());
        assert_eq!((factor("thou"), factor("klb")), (factor("mils"), factor("kips")));
        assert_eq!(
            (factor("daN"), factor("slugs/tonne")),
            (factor("kN/%").and(Factor::new(1, 10_000, 0)).unwrap(), factor("slug/t"))
        );
        assert_eq!(factor("Ns/m"), factor("N*s/m"));
        assert_eq!((factor("kNs/mm"), factor("kNm")), (factor("kN*s/mm"), factor("kN*m")));
        assert_eq!((factor("hz"), factor("cpm")), (factor("Hz"), factor("rev/min")));
        assert!(["Nx/m", "sN", "Nss", "MHz"].iter().all(|text| parse(text).is_empty()));
        assert!(parse("kN//m").is_empty() && parse("").is_empty() && parse("/s").is_empty());
    }

    #[test]
    fn the_reference_lists_every_unit() {
        let page = include_str!("../../../../docs/outputs.md");
        let (_, list) = page.split_once("## Units").unwrap();
        let list = list.split("\n## ").next().unwrap();
        for (symbol, ..) in TABLE {
            assert!(list.contains(&format!("`{symbol}`")), "{symbol}");
        }
    }

    #[test]
    fn symbols_with_two_meanings_are_those_of_gravity_and_the_pound() {
        for (i, (symbol, dimension, ..)) in TABLE.iter().enumerate() {
            let twins = TABLE.iter().enumerate().filter(|(j, (other, ..))| *j != i && other == symbol);
            for (_, (other, of, ..)) in twins {
                assert!(["g", "mg", "lb", "lbs", "oz"].contains(other) && of != dimension, "{other}");
            }
        }
    }
}
