//! Regimes and borders over intervals that lie on both sides of an edge, and where a body may be held.

use super::{Exact, double, text};
use stickslip::enclosed::{self, Known, Regime};
use stickslip::float::Mp;
use stickslip::{Border, Field as _, Output, Ratios};

fn between(low: &str, high: &str) -> Known {
    Known::between(&text(low), &text(high)).unwrap()
}

fn regime(omega: &str, alpha: &Known, zeta: &str, eta: &str) -> Option<Regime> {
    enclosed::KnownRatios::new(&text(omega))
        .with_force_ratio(alpha)
        .with_damping_ratio(&text(zeta))
        .with_static_friction_ratio(&text(eta))
        .response(64)
        .unwrap()
        .regime
}

#[test]
fn a_force_ratio_on_both_sides_of_one_has_no_regime() {
    for zeta in ["0", "0.1"] {
        assert_eq!(regime("0.7", &between("0.9", "1"), zeta, "1"), Some(Regime::Stuck));
        assert_eq!(regime("0.7", &between("0.9", "1.1"), zeta, "1"), None);
        assert_eq!(regime("0.7", &between("1.01", "1.1"), zeta, "1"), Some(Regime::BelowBorder));
    }
}

/// At Ω = 1 the border is 4/π for every η, and the displacement that it takes at the turning point is η. Every
/// start leads to a motion without a stop above 4η/π, or with a damper above the bound for every start.
#[test]
fn at_resonance_the_border_does_not_depend_on_static_friction() {
    for eta in ["1", "1.5"] {
        assert_eq!(regime("1", &text("1.2"), "0", eta), Some(Regime::BelowBorder));
        let depends = (eta != "1").then_some(Regime::DependsOnStart);
        assert_eq!(regime("1", &text("1.3"), "0", eta), depends.or(Some(Regime::Unbounded)));
        assert_eq!(regime("1", &text("1.6"), "0.01", eta), depends.or(Some(Regime::NonSticking)));
        assert_eq!(regime("1", &text("1.91"), "0", eta), Some(Regime::Unbounded));
        assert_eq!(regime("1", &text("3"), "0.01", eta), Some(Regime::NonSticking));
        let moves = |alpha: &Known| {
            enclosed::KnownRatios::new(&text("1"))
                .with_force_ratio(alpha)
                .with_static_friction_ratio(&text(eta))
                .response(64)
                .unwrap()
                .moves_from_rest
        };
        assert_eq!((moves(&text(eta)), moves(&text("1.51"))), (Some(false), Some(true)));
        assert_eq!(moves(&between("0.9", "1.6")), None);
        let found = enclosed::KnownRatios::new(&text("1"))
            .with_static_friction_ratio(&text(eta))
            .response(64)
            .unwrap();
        let border = found.get(Output::MinForceRatio).unwrap();
        assert!(
            border.contains(&rug::Float::from(Exact::int(4) / <Exact as stickslip::Real>::pi())),
            "{eta}: {border}"
        );
        let least = found.get(Output::LeastDisplacement).unwrap();
        assert!(least.contains(&rug::Float::with_val(64, eta.parse::<f64>().unwrap())), "{eta}: {least}");
        assert!(least.rad < 1e-15, "{least}");
    }
}

#[test]
fn a_force_ratio_that_is_too_large_has_the_bounds_of_its_domain() {
    let error =
        enclosed::KnownRatios::new(&text("0.7")).with_force_ratio(&text("1e300")).response(64).unwrap_err();
    assert!(error.to_string().contains("1e300 must be ≥ 0 and ≤ 1.8"), "{error}");
}

/// At Ω = 1/(2n + 1) no force suffices for two reversals without a stop, except with a damper.
#[test]
fn at_a_pole_every_force_is_below_the_border() {
    for omega in ["1/3", "0.2", "1/7"] {
        for eta in ["1", "3"] {
            for alpha in ["1.5", "1e6", "1e75"] {
                assert_eq!(
                    regime(omega, &text(alpha), "0", eta),
                    Some(Regime::BelowBorder),
                    "{omega} {alpha}"
                );
            }
            assert_eq!(regime(omega, &text("1"), "0", eta), Some(Regime::Stuck));
        }
        assert_eq!(regime(omega, &text("1e6"), "0.1", "1"), Some(Regime::NonSticking), "{omega}");
    }
    for omega in ["0.5", "0.25", "1"] {
        assert_ne!(regime(omega, &text("1e6"), "0", "1"), Some(Regime::BelowBorder), "{omega}");
    }
}

/// Without damping the enclosure with static friction contains the border of each pair of ratios.
#[test]
fn the_border_with_static_friction_is_inside() {
    for omega in [0.05, 0.11, 0.23, 0.3, 0.4, 0.45, 0.5, 0.7, 1.0, 3.0] {
        for eta in [1.0, 1.001, 1.1, 1.5, 4.0, 30.0] {
            let ratios = Ratios::new(Exact::from(omega), Exact::int(2)).unwrap();
            let ratios = ratios.with_static_friction_ratio(Exact::from(eta)).unwrap();
            let expected = Border::of(&ratios);
            let found = enclosed::KnownRatios::new(&double(omega))
                .with_static_friction_ratio(&double(eta))
                .response(64)
                .unwrap();
            for (output, value) in [
                (Output::MinForceRatio, expected.min_force_ratio),
                (Output::LeastDisplacement, expected.least_displacement),
                (Output::BorderPhase, expected.border_phase),
            ] {
                let enclosure = found.get(output).unwrap();
                assert!(enclosure.contains(&rug::Float::from(value)), "{output} {omega} {eta} {enclosure}");
            }
        }
    }
}

/// Below Ω = 1/2 the border exceeds that at the turning point, which is enough above.
#[test]
fn the_border_around_one_half_is_that_of_each_frequency() {
    for low in [0.36, 0.39, 0.42, 0.45, 0.48, 0.49, 0.495, 0.499] {
        let range = Known::between(&double(low), &double(0.5)).unwrap();
        let found = enclosed::KnownRatios::new(&range).response(64).unwrap();
        let enclosure = found.get(Output::MinForceRatio);
        let least = Border::<Exact>::new(Exact::from(low)).unwrap().min_force_ratio;
        assert!(enclosure.is_none_or(|it| it.contains(&rug::Float::from(least))), "{low}: {enclosure:?}");
    }
}

#[test]
fn an_enclosure_has_two_ends() {
    let found = enclosed::KnownRatios::new(&double(0.75)).response(64).unwrap();
    let enclosure = found.get(Output::MinForceRatio).unwrap();
    let at = |radii: i32| Mp::<4>::from(&enclosure.mid) + Mp::<4>::from(&enclosure.rad) * Mp::<4>::int(radii);
    for (radii, is_inside) in [(-1_000_000, false), (-2, false), (0, true), (2, false), (1_000_000, false)] {
        let x = rug::Float::from(at(radii));
        assert_eq!(enclosure.contains(&x), is_inside, "{radii} radii: {x}");
    }
}
