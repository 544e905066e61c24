//! Enclosures with damping and static friction.

use super::{Exact, double, known, radii, text, units};
use stickslip::enclosed::{self, Known, Regime};
use stickslip::float::Mp;
use stickslip::{Output, Ratios, Response};

/// Checks the closed forms with damping and static friction against the same outputs at 1024 bits.
fn check_damped(omega: f64, alpha: Exact, zeta: f64, eta: f64, bits: u32) -> f64 {
    let found = enclosed::KnownRatios::new(&double(omega))
        .with_force_ratio(&known(alpha))
        .with_damping_ratio(&double(zeta))
        .with_static_friction_ratio(&double(eta))
        .response(bits)
        .unwrap();
    let ratios = Ratios::new(Exact::from(omega), alpha).unwrap();
    let ratios = ratios.with_damping_ratio(Exact::from(zeta)).unwrap();
    let exact = Response::new(ratios.with_static_friction_ratio(Exact::from(eta)).unwrap());
    let (mut widest, mut values) = (0.0f64, 0);
    for output in Output::ALL {
        let (Some(enclosure), Some(value)) = (found.get(output), output.of(&exact)) else { continue };
        let off = radii(enclosure, value);
        assert!(
            off <= 1.0,
            "{omega} {alpha} {zeta} {eta} {output:?}: {value} is {off} radii from {enclosure}"
        );
        values += 1;
        widest = if value == Exact::ZERO { widest } else { widest.max(units(enclosure)) };
    }
    let is_above = alpha > exact.border.min_force_ratio;
    let expected = match exact.regime {
        _ if !is_above => Regime::BelowBorder,
        stickslip::Regime::DependsOnStart => Regime::DependsOnStart,
        _ => Regime::NonSticking,
    };
    assert_eq!(found.regime, Some(expected), "{omega} {alpha} {zeta} {eta}");
    let all = if is_above { Output::ALL.len() } else { 7 };
    assert!(values >= all - 1, "{omega} {alpha} {zeta} {eta}: {values} of {all}");
    widest
}

#[test]
fn damping_and_static_friction_have_enclosures() {
    for (i, (omega, zeta, eta, over)) in [
        (0.7, 0.05, 1.0, 1.5),
        (0.7, 0.05, 1.3, 1.01),
        (1.0, 0.2, 1.0, 2.0),
        (1.6, 1.0, 1.0, 1.2),
        (0.5, 1.0, 1.6, 3.0),
        (0.8, 2.5, 1.0, 1.5),
        (2.0, 40.0, 1.2, 1.5),
        (0.41, 0.003, 1.0, 1.1),
        (0.34, 0.02, 1.0, 1.0001),
        (0.29, 0.01, 2.0, 1.3),
        (0.19, 0.001, 1.0, 1.4),
        (0.11, 0.03, 1.0, 2.0),
        (0.07, 0.3, 1.0, 1.4),
        (0.4, 0.0, 1.5, 1.2),
        (0.7, 0.0, 1.3, 1.5),
        (1.4, 0.0, 2.0, 1.1),
        (0.6, 0.05, 1.3, 0.9),
        (0.36, 0.01, 1.0, 0.99),
        (3.0, 1e-9, 1.0, 1.5),
        (0.99999, 1e-6, 1.0, 1.5),
        // Just below Ω = 1/(2n) with less damping the condition's maximum is beside the turning point, and the greatest
        // force beside the end.
        (0.49999, 1e-5, 1.0, 1.5),
        (0.249_999_427_645_949_73, 6.442e-7, 1.0, 240.0),
        (0.099_999_997_350_625_69, 2.474e-8, 1.00141, 1.1),
        (0.0624999494728, 2.15e-8, 1.0, 3921.0),
        (0.199_999_991_482_512_2, 1.5e-6, 1.0, 1.000_001),
        (0.099_999_999_999_753_75, 2.148e-12, 1.0, 1.61),
        // Half a cycle of 1600 free waves.
        (3e-4, 3e-6, 1.0, 8.65),
    ]
    .into_iter()
    .enumerate()
    {
        let ratios = Ratios::new(Exact::from(omega), Exact::from(2.0)).unwrap();
        let ratios = ratios.with_damping_ratio(Exact::from(zeta)).unwrap();
        let ratios = ratios.with_static_friction_ratio(Exact::from(eta)).unwrap();
        let least = Response::new(ratios).border.min_force_ratio;
        let alpha = Exact::rounded(Mp::<2>::rounded(least * Exact::from(over)));
        let widest = check_damped(omega, alpha, zeta, eta, if i % 2 == 0 { 64 } else { 200 });
        assert!(widest <= 1.5, "{omega} {zeta} {eta}: {widest} units");
    }
}

/// For intervals of ζ and η, the enclosures contain the outputs of every point.
#[test]
fn intervals_of_damping_have_the_outputs_of_all_their_numbers() {
    let about = |x: f64| Known::between(&double(x), &double(x * (1.0 + 2f64.powi(-20)))).unwrap();
    for (omega, alpha, zeta, eta) in [(0.7, 2.2, 0.1, 1.2), (1.3, 9.0, 1.5, 1.0), (0.42, 14.0, 0.01, 1.1)] {
        // An interval above η = 1 has numbers for which other starts can lead to other motions.
        let (friction, regime) =
            if eta > 1.0 { (about(eta), Regime::DependsOnStart) } else { (double(eta), Regime::NonSticking) };
        let found = enclosed::KnownRatios::new(&about(omega))
            .with_force_ratio(&about(alpha))
            .with_damping_ratio(&about(zeta))
            .with_static_friction_ratio(&friction)
            .response(64)
            .unwrap();
        assert_eq!(found.regime, Some(regime), "{omega} {zeta}");
        for share in [0.0, 0.3, 1.0] {
            let at = |x: f64| x * (1.0 + share * 2f64.powi(-20));
            let ratios = Ratios::new(Exact::from(at(omega)), Exact::from(at(alpha))).unwrap();
            let ratios = ratios.with_damping_ratio(Exact::from(at(zeta))).unwrap();
            let eta = if eta > 1.0 { at(eta) } else { eta };
            let exact = Response::new(ratios.with_static_friction_ratio(Exact::from(eta)).unwrap());
            for output in Output::ALL {
                let (Some(enclosure), Some(value)) = (found.get(output), output.of(&exact)) else { continue };
                assert!(radii(enclosure, value) <= 1.0, "{omega} {output:?}: {enclosure} {value}");
            }
            let displacement = found.get(Output::MaxDisplacement).unwrap();
            assert!(displacement.rad.to_f64() < 1e-3, "{displacement}");
        }
    }
    // An interval across critical damping, and a ratio outside its domain.
    let both = Known::between(&text("0.99"), &text("1.01")).unwrap();
    let found = enclosed::KnownRatios::new(&text("0.7"))
        .with_force_ratio(&text("3"))
        .with_damping_ratio(&both)
        .response(64)
        .unwrap();
    assert_eq!((found.regime, found.get(Output::MaxDisplacement)), (Some(Regime::BelowBorder), None));
    let fails = |zeta, eta| {
        enclosed::KnownRatios::new(&text("0.7"))
            .with_force_ratio(&text("3"))
            .with_damping_ratio(&text(zeta))
            .with_static_friction_ratio(&text(eta))
            .response(64)
            .is_err()
    };
    assert!(fails("-0.1", "1") && fails("1e200", "1") && fails("0", "0.9"));
}
