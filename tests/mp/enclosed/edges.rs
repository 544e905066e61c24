//! Regimes and borders over intervals that lie on both sides of an edge, and where a body may be held.

use super::{Exact, double, text, whole};
use stickslip::enclosed::{self, Known, Regime};
use stickslip::float::Mp;
use stickslip::{Border, Field as _, Output};

fn between(low: &str, high: &str) -> Known {
    Known::between(&text(low), &text(high)).unwrap()
}

fn regime(omega: &str, alpha: &Known, zeta: &str, eta: &str) -> Option<Regime> {
    enclosed::response(&text(omega), alpha, &text(zeta), &text(eta), 64).unwrap().regime
}

#[test]
fn a_force_ratio_on_both_sides_of_one_has_no_regime() {
    for zeta in ["0", "0.1"] {
        assert_eq!(regime("0.7", &between("0.9", "1"), zeta, "1"), Some(Regime::Stuck));
        assert_eq!(regime("0.7", &between("0.9", "1.1"), zeta, "1"), None);
        assert_eq!(regime("0.7", &between("1.01", "1.1"), zeta, "1"), Some(Regime::BelowBorder));
    }
}

/// At Ω = 1 the border is 4/π for every η; a body at rest that the force cannot release stays there.
#[test]
fn at_resonance_static_friction_can_hold_the_body() {
    assert_eq!(regime("1", &text("1.4"), "0", "1"), Some(Regime::Unbounded));
    assert_eq!(regime("1", &text("1.4"), "0", "1.5"), None);
    assert_eq!(regime("1", &text("1.6"), "0", "1.5"), Some(Regime::Unbounded));
    assert_eq!(regime("1", &text("1.6"), "0.01", "1.5"), Some(Regime::NonSticking));
}

/// Below Ω = 1/2 the border exceeds that at the turning point, which is enough above.
#[test]
fn the_border_around_one_half_is_that_of_each_frequency() {
    let found = enclosed::border(&between("0.42", "0.51"), &whole(0), &whole(1), 64).unwrap();
    let enclosure = found.get(Output::MinForceRatio);
    for omega in [0.42, 0.45, 0.48, 0.5, 0.51] {
        let least = Border::<Exact>::new(Exact::from(omega)).unwrap().min_force_ratio;
        let (mid, rad) =
            enclosure.map_or((least, Exact::ZERO), |e| (Exact::from_rug(&e.mid), Exact::from_rug(&e.rad)));
        assert!((least - mid).abs() <= rad, "{omega}: {least} {mid} {rad}");
    }
}

#[test]
fn an_enclosure_has_two_ends() {
    let found = enclosed::border(&double(0.75), &whole(0), &whole(1), 64).unwrap();
    let enclosure = found.get(Output::MinForceRatio).unwrap();
    let at = |radii: i32| {
        Mp::<4>::from_rug(&enclosure.mid) + Mp::<4>::from_rug(&enclosure.rad) * Mp::<4>::int(radii)
    };
    for (radii, is_inside) in [(-1_000_000, false), (-2, false), (0, true), (2, false), (1_000_000, false)] {
        let x = rug::Float::from(at(radii));
        assert_eq!(enclosure.contains(&x), is_inside, "{radii} radii: {x}");
    }
}
