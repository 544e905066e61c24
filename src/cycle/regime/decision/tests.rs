use crate::{Border, Drive, Error, NoStop, Oscillator, Ratios, Regime, Verdict};

const EITHER: Verdict<f64> = Verdict::Undecided(Regime::Sticking, Regime::NonSticking);

fn verdict(omega: f64, alpha: f64) -> Verdict<f64> {
    Verdict::new(Ratios::new(omega, alpha).unwrap())
}

#[test]
fn each_verdict_has_its_place() {
    assert_eq!(verdict(0.7, 1.0), Verdict::AtRest);
    assert_eq!(verdict(0.7, 1f64.next_up()), Verdict::Sticking);
    assert_eq!(verdict(0.7, 1.4), Verdict::NonSticking);
    assert_eq!(verdict(1.0, 1.2), Verdict::Sticking);
    assert_eq!(verdict(1.0, 1.3), Verdict::Unbounded);
    let unsure = Verdict::Undecided(Regime::Sticking, Regime::Unbounded);
    assert_eq!(verdict(1.0, 4.0 / std::f64::consts::PI), unsure);
}

#[test]
fn one_over_2n_is_decided_to_the_last_float() {
    for omega in [0.5, 0.25, 2f64.powi(-10), 2f64.powi(-26), 2f64.powi(-27), 2f64.powi(-40)] {
        let least = 1.0 / (omega * omega) - 1.0;
        match verdict(omega, least) {
            Verdict::Degenerate(family) => assert_eq!(family.max_shift, 0.0),
            other => panic!("{omega}: {other:?}"),
        }
        assert_eq!(verdict(omega, least.next_down()), Verdict::Sticking);
        assert_eq!(verdict(omega, 0.5), Verdict::AtRest);
    }
    // Near 1/(2n), too, there is a single limit.
    for omega in [0.5 * (1.0 - 1e-14), 0.5f64.next_down(), 0.5f64.next_up(), 1.0 / 6.0] {
        assert_eq!(verdict(omega, 1.5 / (omega * omega)), Verdict::NonSticking, "{omega}");
    }
}

#[test]
fn undecided_within_the_error_bound_only() {
    for omega in [0.052, 0.22, 0.3, 0.4, 0.45, 0.7, 0.99, 1.5, 20.0, 1.0 / 3.0] {
        let least = Border::new(omega).unwrap().min_force_ratio;
        for over in [0.0, 4.0, -4.0] {
            assert_eq!(verdict(omega, least * (1.0 + over * f64::EPSILON)), EITHER, "{omega}");
        }
        assert_eq!(verdict(omega, least * (1.0 + 1e-14)), Verdict::NonSticking, "{omega}");
        // At the float next to the pole, the gap between six reversals and the border is below rounding.
        let below = if omega == 1.0 / 3.0 { EITHER } else { Verdict::Sticking };
        assert_eq!(verdict(omega, least * (1.0 - 1e-14)), below, "{omega}");
    }
}

/// From 2⁵³ on 1/Ω rounds to even integers: no odd one seemed to be near.
#[test]
fn at_the_lowest_frequencies_it_may_reverse_six_times() {
    let mut found = 0;
    for i in 0..400 {
        let omega = 5.596_158_043_149_874e-17 * (1.0 + f64::from(i) * f64::from(i) * 2f64.powi(-12));
        let Some((low, high)) = NoStop::of(&Ratios::new(omega, 1.0).unwrap()).six_reversals else {
            continue;
        };
        if high > low * 1.001 {
            assert_eq!(verdict(omega, (low * high).sqrt()), Verdict::SixReversals, "{omega:e}");
            found += 1;
        }
    }
    assert!(found > 5, "{found}");
}

#[test]
fn beside_a_pole_it_may_reverse_six_times() {
    let (low, high) = NoStop::of(&Ratios::new(0.331, 1.0).unwrap()).six_reversals.unwrap();
    for (alpha, expected) in [
        (low * 0.999, Verdict::Sticking),
        (low * (1.0 - 1e-15), EITHER),
        (low, EITHER),
        (low * 1.001, Verdict::SixReversals),
        (high * 0.999, Verdict::SixReversals),
        (high, EITHER),
        (high * 1.001, Verdict::Sticking),
    ] {
        assert_eq!(verdict(0.331, alpha), expected, "{alpha}");
    }
    let within = |omega, alpha| Verdict::<f64>::within(omega, alpha).unwrap();
    for (omega, alpha, expected) in [
        ((0.3305, 0.3325), (80.0, 100.0), Verdict::SixReversals),
        ((0.332, 0.334), (80.0, 100.0), Verdict::SixReversals),
        ((0.3305, 0.3306), (40.0, 50.0), Verdict::Sticking),
        ((0.332, 0.334), (50.0, 100.0), EITHER),
        ((0.336, 0.337), (50.0, 100.0), Verdict::Sticking),
        ((0.326, 0.337), (50.0, 51.0), EITHER),
        ((0.21, 0.32), (10.4, 10.5), Verdict::Sticking),
    ] {
        assert_eq!(within(omega, alpha), expected, "{omega:?} {alpha:?}");
    }
}

#[test]
fn a_wider_type_decides() {
    for omega in [0.22f32, 0.3, 0.4, 0.7, 1.5, 20.0] {
        let least = Border::new(omega).unwrap().min_force_ratio;
        for alpha in [least, least.next_up(), least.next_down()] {
            let narrow = Verdict::new(Ratios::new(omega, alpha).unwrap());
            assert_eq!(narrow, Verdict::Undecided(Regime::Sticking, Regime::NonSticking));
            assert!(verdict(omega.into(), alpha.into()).regime().is_some(), "{omega} {alpha}");
        }
    }
}

#[test]
fn the_error_bound_holds_at_single_precision() {
    for i in 1..4000u16 {
        let omega = f32::from(i) / 1000.0 + 0.02;
        let narrow = f64::from(Border::new(omega).unwrap().min_force_ratio);
        let wide = Border::new(f64::from(omega)).unwrap().min_force_ratio;
        let error = (narrow / wide - 1.0).abs() / f64::from(f32::EPSILON);
        assert!(error < f64::from(Verdict::<f32>::BORDER_ERROR), "{omega}: {error}");
    }
}

#[test]
fn intervals_say_what_holds_for_all() {
    let within = |omega, alpha| Verdict::<f64>::within(omega, alpha).unwrap();
    // The border has a minimum of 1.20999 between 0.8 and 0.9; its values there are 1.2234 and 1.2184.
    assert_eq!(within((0.8, 0.9), (1.205, 1.2099)), Verdict::Sticking);
    assert_eq!(within((0.8, 0.9), (1.215, 1.216)), EITHER);
    assert_eq!(within((0.8, 0.9), (1.23, 1.3)), Verdict::NonSticking);
    assert_eq!(within((0.32, 0.34), (1e3, 1e4)), EITHER);
    assert_eq!(within((0.9, 1.1), (2.0, 3.0)), Verdict::Undecided(Regime::NonSticking, Regime::Unbounded));
    assert_eq!(within((0.7, 0.8), (0.5, 1.1)), Verdict::Undecided(Regime::Stuck, Regime::Sticking));
    assert_eq!(within((0.7, 0.8), (0.5, 3.0)), Verdict::Undecided(Regime::Stuck, Regime::NonSticking));
    assert_eq!(within((0.7, 0.8), (0.5, 1.0)), Verdict::AtRest);
    assert!(Verdict::within((0.7, 0.8), (2.0, 1.0)).is_err());
    assert!(Verdict::within((0.8, 0.7), (1.0, 2.0)).is_err());
}

#[test]
fn a_machine_at_resonance_is_not_known_to_be_exactly_there() {
    let body = Oscillator::new(1.0, 1.0, 1.0).unwrap();
    let at = |p0: f64| Verdict::of(&body, &Drive::force(p0, 1.0).unwrap()).unwrap();
    assert_eq!(at(2.0), Verdict::Undecided(Regime::NonSticking, Regime::Unbounded));
    assert_eq!(at(1.2), Verdict::Sticking);
    // 1/3 as rounded is next to a pole, and the border is undetermined.
    let drive = Drive::force(1e16, 1.0 / 3.0).unwrap();
    assert_eq!(Verdict::of(&body, &drive).unwrap(), EITHER);
    assert!(Verdict::new(drive.ratios(&body).unwrap()).regime().is_some());
}

#[test]
fn with_damping_the_error_bound_is_16_units() {
    let at = |omega: f64, alpha, zeta| {
        Verdict::new(Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap())
    };
    let least = Border::of(&Ratios::of_machine(0.7, 0.1).unwrap()).min_force_ratio;
    let [above, below] = [16.0, -16.0].map(|units| least * (1.0 + units * f64::EPSILON));
    for (alpha, verdict) in [
        (above.next_up(), Verdict::NonSticking),
        (above, EITHER),
        (least, EITHER),
        (below, EITHER),
        (below.next_down(), Verdict::Sticking),
        (1f64.next_up(), Verdict::Sticking),
        (1.0, Verdict::AtRest),
    ] {
        assert_eq!(at(0.7, alpha, 0.1), verdict, "{alpha:?}");
    }
    let (low, high) = NoStop::of(&Ratios::of_machine(0.331, 1e-3).unwrap()).six_reversals.unwrap();
    let due = [Verdict::Sticking, EITHER, Verdict::SixReversals, EITHER, Verdict::Sticking];
    assert_eq!([low * 0.999, low, 60.0, high, high * 1.001].map(|alpha| at(0.331, alpha, 1e-3)), due);
}

/// Within the error of the border nothing is known. Below it every start stops again and again, above it the
/// start decides. A force that does not release a body at rest needs no border.
#[test]
fn with_static_friction_the_border_is_as_wide_as_its_error() {
    for (omega, zeta, units) in [(0.6, 0.0, 8.0), (0.6, 0.1, 16.0), (0.95, 0.2, 16.0)] {
        let ratios = |alpha: f64, eta| {
            let ratios = Ratios::new(omega, alpha).unwrap().with_static_friction_ratio(eta).unwrap();
            ratios.with_damping_ratio(zeta).unwrap()
        };
        let least = Border::of(&ratios(2.0, 1.1)).min_force_ratio;
        let at = |off: f64| Verdict::new(ratios(least * (1.0 + off * f64::EPSILON), 1.1));
        assert!(least > 1.1, "{omega} {zeta}");
        let unsure = Verdict::Undecided(Regime::Sticking, Regime::DependsOnStart);
        for (off, verdict) in [
            (-1.5 * units, Verdict::Sticking),
            (-0.5 * units, unsure),
            (0.5 * units, unsure),
            (1.5 * units, Verdict::DependsOnStart),
        ] {
            assert_eq!(at(off), verdict, "{omega} {zeta} {off}");
        }
        assert_eq!(Verdict::new(ratios(1.0, 1.1)), Verdict::AtRest);
        assert_eq!(Verdict::new(ratios(1.1, 1.1)), Verdict::DependsOnStart);
        assert_eq!(Verdict::new(ratios(1.1f64.next_up(), 1.1)), Verdict::Sticking);
    }
    // A border below η: a body at rest stays on either side of it.
    let ratios = |alpha: f64| Ratios::new(1.036, alpha).unwrap().with_static_friction_ratio(2.07).unwrap();
    let least = Border::of(&ratios(2.0)).min_force_ratio;
    assert!((least - 1.302_564).abs() < 1e-6, "{least}");
    for alpha in [1.1, least, 1.31, 2.06, 2.07, 2.08, 1e9] {
        assert_eq!(Verdict::new(ratios(alpha)), Verdict::DependsOnStart, "{alpha}");
    }
}

/// Beside a pole the cycle of six reversals has narrower edges.
#[test]
fn with_static_friction_six_reversals_have_their_edges() {
    let ratios = |alpha: f64| {
        let ratios = Ratios::new(0.331, alpha).unwrap().with_damping_ratio(5e-4).unwrap();
        ratios.with_static_friction_ratio(1.01).unwrap()
    };
    let (low, high) = crate::NoStop::of(&ratios(2.0)).six_reversals.unwrap();
    let unsure = Verdict::Undecided(Regime::Sticking, Regime::DependsOnStart);
    let (sticks, depends) = (Verdict::Sticking, Verdict::DependsOnStart);
    let due = [sticks, unsure, depends, unsure, sticks];
    assert_eq!([low * 0.999, low, 100.0, high, high * 1.001].map(|alpha| Verdict::new(ratios(alpha))), due);
}

/// The rounding of a machine's ratios reaches over Ω = 1 from either side.
#[test]
fn a_machine_beside_resonance_may_be_at_it() {
    for omega in [1f64.next_down(), 1.0, 1f64.next_up()] {
        let body = Oscillator::new(1.0, 1.0, 1.0).unwrap();
        let drive = Drive::force(1.4, omega).unwrap();
        let found = Verdict::of(&body, &drive).unwrap();
        assert_eq!(found, Verdict::Undecided(Regime::NonSticking, Regime::Unbounded), "{omega}");
    }
}

#[test]
fn a_machine_with_higher_static_friction_is_refused() {
    let body = Oscillator::new(1.0, 1.0, 1.0).unwrap().with_static_friction(1.5).unwrap();
    let found = Verdict::of(&body, &Drive::force(3.0, 0.7).unwrap());
    assert!(matches!(found, Err(Error::StaticFriction { .. })), "{found:?}");
}
