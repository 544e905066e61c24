//! Enclosures of the closed forms against the same outputs at 1024 bits, where they are sharp and where a
//! decision is near.

use proptest::prelude::*;
use stickslip::enclosed::{self, Enclosure, Known, Regime};
use stickslip::float::mp::Mp;
use stickslip::{Border, Field as _, Float as _, Output, Ratios, Response};

/// A number with no rounding to speak of.
type Exact = Mp<16>;

fn known<const L: usize>(x: Mp<L>) -> Known {
    Known::exactly(x).unwrap()
}

/// A whole number, exactly.
fn whole(n: i32) -> Known {
    known(Mp::<1>::from(n))
}

fn reference(omega: Exact, alpha: Exact) -> Response<Exact> {
    Response::new(Ratios::new(omega, alpha).unwrap())
}

/// Distance of the value from the midpoint, in radii.
fn radii(found: &Enclosure, value: Exact) -> f64 {
    let distance = (value - Exact::from_rug(found.mid())).abs();
    if distance == Exact::ZERO { 0.0 } else { (distance / Exact::from_rug(found.rad())).to_f64() }
}

/// Radius in units of the last place of the bits asked for.
fn units(found: &Enclosure) -> f64 {
    let unit = Exact::from_rug(found.mid()).abs().scale2(-(found.mid().prec() as i32));
    (Exact::from_rug(found.rad()) / unit).to_f64()
}

/// Every output that exists is in its enclosure; the widest, in units in the last place.
fn check(omega: f64, alpha: Exact, bits: u32) -> f64 {
    let found =
        enclosed::response(&known(Mp::<1>::from(omega)), &known(alpha), &whole(0), &whole(1), bits).unwrap();
    let exact = reference(Exact::from(omega), alpha);
    let mut widest = 0.0f64;
    for output in Output::ALL {
        let value = output.of(&exact);
        let (Some(enclosure), Some(value)) = (found.get(output), value) else {
            assert!(value.is_none(), "{omega} {alpha} {output:?}: {value:?}");
            continue;
        };
        let off = radii(enclosure, value);
        assert!(
            off <= 1.0,
            "{omega} {alpha} {output:?} at {bits} bits: {value} is {off} radii from {enclosure}"
        );
        if value != Exact::ZERO {
            widest = widest.max(units(enclosure));
        }
    }
    assert_eq!(found.regime(), Some(expected(&exact)), "{omega} {alpha}");
    widest
}

fn expected(exact: &Response<Exact>) -> Regime {
    let (omega, alpha) = (exact.ratios().omega(), exact.ratios().alpha());
    if alpha <= Exact::from(1) {
        Regime::Stuck
    } else if alpha < exact.border().min_force_ratio() {
        Regime::BelowBorder
    } else if omega == Exact::from(1) {
        Regime::Unbounded
    } else {
        Regime::NonSticking
    }
}

/// Frequency ratios of ordinary size, and beside 1 and 1/n.
fn frequencies() -> impl Strategy<Value = f64> {
    let beside = (1u32..12, 4i32..50, any::<bool>()).prop_map(|(n, e, above)| {
        let distance = if above { 2f64.powi(-e) } else { -2f64.powi(-e) };
        (1.0 + distance) / f64::from(n)
    });
    prop_oneof![4 => (-4.0f64..4.0).prop_map(f64::exp), 3 => beside, 1 => (1u32..12).prop_map(|n| 1.0 / f64::from(n))]
}

/// α over the border, less 1.
fn excesses() -> impl Strategy<Value = f64> {
    prop_oneof![3 => 1e-3f64..20.0, 2 => (3i32..60).prop_map(|e| 2f64.powi(-e)), 1 => -0.5f64..-1e-6]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(80))]

    #[test]
    fn the_value_is_never_outside(omega in frequencies(), excess in excesses(), wide in any::<bool>()) {
        let least = Border::new(Exact::from(omega)).unwrap().min_force_ratio();
        let alpha = Exact::rounded(Mp::<2>::rounded(least * (Exact::from(1) + Exact::from(excess))));
        let widest = check(omega, alpha, if wide { 256 } else { 64 });
        // Half a unit in the last place is up to 1 of these, and two bits beyond those asked for leave
        // another half.
        prop_assert!(widest <= 1.5, "{omega} {alpha}: {widest} units");
    }

    /// Every number of the intervals has its outputs in their enclosures.
    #[test]
    fn intervals_have_the_outputs_of_all_their_numbers(
        omega in prop_oneof![0.52f64..0.95, 1.05f64..6.0, 0.35f64..0.45, 0.27f64..0.32], excess in 0.2f64..3.0,
        width in (6i32..40).prop_map(|e| 2f64.powi(-e)), shares in prop::collection::vec((0.0f64..1.0, 0.0f64..1.0), 6),
    ) {
        let alpha = Border::new(omega).unwrap().min_force_ratio() * (1.0 + excess);
        let interval = |x: f64| {
            Known::between(&known(Mp::<1>::from(x)), &known(Mp::<1>::from(x * (1.0 + width)))).unwrap()
        };
        let found = enclosed::response(&interval(omega), &interval(alpha), &whole(0), &whole(1), 64).unwrap();
        for (a, b) in shares.into_iter().chain([(0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)]) {
            let inside = |x: f64, share: f64| Exact::from(x) + (Exact::from(x * (1.0 + width)) - Exact::from(x)) * Exact::from(share);
            let exact = reference(inside(omega, a), inside(alpha, b));
            for output in Output::ALL {
                if let (Some(enclosure), Some(value)) = (found.get(output), output.of(&exact)) {
                    let off = radii(enclosure, value);
                    prop_assert!(off <= 1.0, "{omega} {alpha} ± {width} {output:?}: {value} is {off} radii from {enclosure}");
                }
            }
        }
        if width < 1e-9 {
            prop_assert_eq!(found.regime(), Some(Regime::NonSticking));
            let velocity = found.get(Output::MaxVelocity).unwrap();
            prop_assert!(velocity.rad().to_f64() < 1e5 * width, "{velocity}");
        }
    }
}

/// The closed forms with damping and static friction against the same outputs at 1024 bits.
fn check_damped(omega: f64, alpha: Exact, zeta: f64, eta: f64, bits: u32) -> f64 {
    let of = |x: f64| known(Mp::<1>::from(x));
    let found = enclosed::response(&of(omega), &known(alpha), &of(zeta), &of(eta), bits).unwrap();
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
    let is_above = alpha > exact.border().min_force_ratio();
    let expected = if is_above { Regime::NonSticking } else { Regime::BelowBorder };
    assert_eq!(found.regime(), Some(expected), "{omega} {alpha} {zeta} {eta}");
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
    ]
    .into_iter()
    .enumerate()
    {
        let ratios = Ratios::new(Exact::from(omega), Exact::from(2.0)).unwrap();
        let ratios = ratios.with_damping_ratio(Exact::from(zeta)).unwrap();
        let ratios = ratios.with_static_friction_ratio(Exact::from(eta)).unwrap();
        let least = Response::new(ratios).border().min_force_ratio();
        let alpha = Exact::rounded(Mp::<2>::rounded(least * Exact::from(over)));
        let widest = check_damped(omega, alpha, zeta, eta, if i % 2 == 0 { 64 } else { 200 });
        assert!(widest <= 1.5, "{omega} {zeta} {eta}: {widest} units");
    }
}

/// With ζ and η in intervals every number of them has its outputs in the enclosures.
#[test]
fn intervals_of_damping_have_the_outputs_of_all_their_numbers() {
    let of = |x: f64| known(Mp::<1>::from(x));
    let about = |x: f64| Known::between(&of(x), &of(x * (1.0 + 2f64.powi(-20)))).unwrap();
    for (omega, alpha, zeta, eta) in [(0.7, 2.2, 0.1, 1.2), (1.3, 9.0, 1.5, 1.0), (0.42, 14.0, 0.01, 1.1)] {
        let found = enclosed::response(&about(omega), &about(alpha), &about(zeta), &about(eta), 64).unwrap();
        assert_eq!(found.regime(), Some(Regime::NonSticking), "{omega} {zeta}");
        for share in [0.0, 0.3, 1.0] {
            let at = |x: f64| x * (1.0 + share * 2f64.powi(-20));
            let ratios = Ratios::new(Exact::from(at(omega)), Exact::from(at(alpha))).unwrap();
            let ratios = ratios.with_damping_ratio(Exact::from(at(zeta))).unwrap();
            let exact = Response::new(ratios.with_static_friction_ratio(Exact::from(at(eta))).unwrap());
            for output in Output::ALL {
                let (Some(enclosure), Some(value)) = (found.get(output), output.of(&exact)) else { continue };
                assert!(radii(enclosure, value) <= 1.0, "{omega} {output:?}: {enclosure} {value}");
            }
            let displacement = found.get(Output::MaxDisplacement).unwrap();
            assert!(displacement.rad().to_f64() < 1e-3, "{displacement}");
        }
    }
    // Swinging and creeping in one interval, and a ratio outside its domain.
    let known = |text: &str| text.parse::<Known>().unwrap();
    let both = Known::between(&known("0.99"), &known("1.01")).unwrap();
    let found = enclosed::response(&known("0.7"), &known("3"), &both, &known("1"), 64).unwrap();
    assert_eq!((found.regime(), found.get(Output::MaxDisplacement)), (None, None));
    let fails =
        |zeta, eta| enclosed::response(&known("0.7"), &known("3"), &known(zeta), &known(eta), 64).is_err();
    assert!(fails("-0.1", "1") && fails("1e200", "1") && fails("0", "0.9"));
}

#[test]
fn decimals_are_what_is_written() {
    let at = |omega: &str, alpha: &str| {
        enclosed::response(&omega.parse().unwrap(), &alpha.parse().unwrap(), &whole(0), &whole(1), 128)
            .unwrap()
    };
    // A fifth is a pole, where no force is enough; the double beside it is not.
    let pole = at("0.2", "1e6");
    assert_eq!((pole.regime(), pole.get(Output::MinForceRatio)), (None, None));
    assert!(
        enclosed::border(&known(Mp::<1>::from(0.2)), &whole(0), &whole(1), 64)
            .unwrap()
            .get(Output::MinForceRatio)
            .is_some()
    );
    // A sixth has K = 0 and the border 35 exactly; of a third of 1.5 nothing is rounded.
    let sixth = enclosed::border(&"1/6".parse().unwrap(), &whole(0), &whole(1), 64).unwrap();
    assert!(sixth.get(Output::MinForceRatio).unwrap().contains(&rug::Float::with_val(64, 35)));
    assert_eq!(sixth.get(Output::BestForceRatio).unwrap().to_string(), "0 ± 0");
    let half = at("0.5", "4");
    assert_eq!(half.regime(), Some(Regime::NonSticking));
    // α = 3 is the border at Ω = 1/2: that is not decided by any number of bits.
    let border = at("0.5", "3");
    assert_eq!((border.regime(), border.bits()), (None, enclosed::MAX_BITS));
    // Close to it, more bits decide.
    let text = format!("3.{}1", "0".repeat(100));
    let above = at("0.5", &text);
    assert!(above.regime() == Some(Regime::NonSticking) && above.bits() > 192, "{}", above.bits());
    assert_eq!(at("0.5", &format!("2.{}", "9".repeat(100))).regime(), Some(Regime::BelowBorder));
    assert_eq!(
        (at("1", "1.3").regime(), at("1", "1.27").regime()),
        (Some(Regime::Unbounded), Some(Regime::BelowBorder))
    );
    assert_eq!(at("0.7", "1").regime(), Some(Regime::Stuck));
}

/// Resonance a hundred decimals away, on the border: the cancellation asks for more bits, which are taken.
#[test]
fn more_bits_are_taken_where_they_are_needed() {
    let omega = format!("1.{}1", "0".repeat(99));
    let found =
        enclosed::response(&omega.parse().unwrap(), &"1.3".parse().unwrap(), &whole(0), &whole(1), 64)
            .unwrap();
    let displacement = found.get(Output::MaxDisplacement).unwrap();
    assert!(units(displacement) <= 1.5 && found.bits() > 256, "{displacement} {}", found.bits());
    let near = Exact::from_rational(
        &(rug::Rational::from(1)
            + rug::Rational::from((1, rug::Integer::from(rug::Integer::u_pow_u(10, 100))))),
    );
    let exact = reference(near, Exact::from_rational(&"13/10".parse().unwrap()));
    // The reference itself has lost some 660 of its 1024 bits.
    let value = exact.cycle().unwrap().max_displacement();
    assert!(((value - Exact::from_rug(displacement.mid())) / value).abs().to_f64() < 1e-18);
}

#[test]
fn what_is_outside_the_domain_is_refused() {
    let message = |omega: &str, alpha: &str, bits| {
        enclosed::response(&omega.parse().unwrap(), &alpha.parse().unwrap(), &whole(0), &whole(1), bits)
            .unwrap_err()
            .to_string()
    };
    assert!(message("0", "2", 64).starts_with("frequency ratio Ω = 0 must be > 0"));
    assert!(message("-1", "2", 64).starts_with("frequency ratio Ω = -1 must be > 0"));
    assert!(message("1e-80", "2", 64).contains("must be ≥"));
    assert!(message("1", "-2", 64).starts_with("force ratio α = -2 must be > 0"));
    assert!(message("1", "1e80", 64).contains("must be ≥"));
    assert_eq!(message("1", "2", 0), "precision in bits = 0 must be > 0");
    assert!(message("1", "2", 8193).contains("≤ 8192"));
    for text in ["", "x", "inf", "nan", "1 5", "1_0", "1/0", "/3", "1/-3", "--1", "1e99999999", "0x1"] {
        assert!(text.parse::<Known>().is_err(), "{text}");
    }
    assert!(Known::between(&"2".parse().unwrap(), &"1".parse().unwrap()).is_err());
    assert!(Known::exactly(Mp::<1>::NAN).is_err());
}

/// The motions of the exact solver at 256 bits, each proved to exist: place, stops, extrema and multipliers
/// in their enclosures.
#[test]
fn steady_motions_are_proved() {
    use stickslip::exact::{LongRun, State};
    for (omega, alpha, zeta, eta, sticks) in [
        ("0.4", "6", "0", "1", 2),
        ("0.1", "3", "0", "1", 4),
        ("0.15", "3", "0", "1", 4),
        ("1.5", "2.5", "0", "1", 0),
        ("0.6", "1.7", "0.05", "1", 2),
        ("0.8", "2", "0.05", "1", 0),
        ("0.6", "2.2", "0.05", "1.3", 2),
        ("0.3", "4", "0.1", "1.3", 2),
        ("0.8", "1.5", "0.05", "1.25", 0),
        // At and above critical damping.
        ("0.6", "1.7", "1", "1", 2),
        ("0.4", "1.6", "3", "1.2", 2),
        ("0.9", "9", "1.5", "1", 0),
        // One of a mirror pair.
        ("0.5", "4", "0.02", "1.3", 1),
    ] {
        let known = |text: &str| text.parse::<Known>().unwrap();
        let found = enclosed::steady(&known(omega), &known(alpha), &known(zeta), &known(eta), 128).unwrap();
        let found = found.unwrap_or_else(|why| panic!("{omega} {alpha} {zeta}: {why}"));
        let ratios = Ratios::new(omega.parse::<Mp<4>>().unwrap(), alpha.parse().unwrap()).unwrap();
        let ratios = ratios.with_damping_ratio(zeta.parse().unwrap()).unwrap();
        let ratios = ratios.with_static_friction_ratio(eta.parse().unwrap()).unwrap();
        let run = LongRun::from_start(ratios, State::rest()).unwrap();
        let exact = run.steady_state().unwrap();
        let near = |enclosure: &Enclosure, value: Mp<4>, name: &str| {
            // At least 30 digits, and the solver's value within its own 60.
            let off = (value - Mp::from_rug(enclosure.mid())).abs().to_f64();
            assert!(enclosure.rad().to_f64() < 1e-30, "{omega} {alpha} {zeta} {name}: {enclosure}");
            assert!(
                off <= enclosure.rad().to_f64() + 1e-55,
                "{omega} {alpha} {zeta} {name}: {enclosure} {value}"
            );
        };
        near(&found.max_displacement, exact.max_displacement(), "max_displacement");
        near(&found.min_displacement, exact.min_displacement(), "min_displacement");
        near(&found.max_velocity, exact.max_velocity(), "max_velocity");
        near(&found.min_velocity, exact.min_velocity(), "min_velocity");
        assert_eq!(
            (found.is_symmetric, found.turns_per_cycle),
            (exact.is_symmetric(), exact.turns_per_cycle()),
            "{omega} {alpha} {zeta}"
        );
        near(&found.stick_fraction, exact.stick_fraction(), "stick_fraction");
        assert_eq!(
            (found.sticks_per_cycle, exact.sticks_per_cycle()),
            (sticks, sticks),
            "{omega} {alpha} {zeta}"
        );
        assert_eq!(
            found.velocity_zeros_per_cycle,
            exact.velocity_zeros_per_cycle(),
            "{omega} {alpha} {zeta}"
        );
        for ((re, im), (x, y)) in found.multipliers.iter().zip(exact.multipliers()) {
            for (enclosure, value) in [(re, x), (im, y)] {
                let off = (value - Mp::from_rug(enclosure.mid())).abs().to_f64();
                assert!(off < 1e-25, "{omega} {alpha} {zeta}: {enclosure} {value}");
            }
        }
        assert!(found.only_within.1.mid().to_f64() > 1e-7, "{:?}", found.only_within);
    }
}

/// What only touches is not claimed: the reason is given, and at a decision the event.
#[test]
fn what_cannot_be_proved_is_not_claimed() {
    use enclosed::{Event, Unproved};
    let known = |text: &str| text.parse::<Known>().unwrap();
    let with = |[omega, alpha, zeta, eta]: [&str; 4]| {
        enclosed::steady(&known(omega), &known(alpha), &known(zeta), &known(eta), 64)
    };
    let reason = |omega, alpha| with([omega, alpha, "0", "1"]).unwrap().unwrap_err();
    assert_eq!(reason("0.7", "0.9"), Unproved::NotPeriodic);
    assert_eq!(reason("1", "2"), Unproved::NotPeriodic);
    assert_eq!(reason("1e-4", "3"), Unproved::TooManySlides);
    assert_eq!(reason("0.5", "3"), Unproved::Family);
    // Force ratios on both sides of the border: the slides of some end earlier than those of others, and no
    // number of bits tells which.
    let both = Known::between(&known("1.5679"), &known("1.5681")).unwrap();
    let both = enclosed::steady(&known("0.7"), &both, &known("0.05"), &known("1"), 64).unwrap();
    let Err(Unproved::Undecided { event, bits, .. }) = both else { panic!("{both:?}") };
    assert_eq!((event, bits), (Event::End, 4160));
    // Six reversals a cycle are a motion like any other.
    let six = with(["0.331", "61.6", "0", "1"]).unwrap();
    assert_eq!(six.unwrap().velocity_zeros_per_cycle, 6);
    assert!(with(["1e10", "3", "0", "1"]).is_err() && with(["0.5", "3", "0", "0.99"]).is_err());
}

/// A million points, half of them adversarial: no value outside; widths and times for `docs/accuracy.md`.
/// `STICKSLIP_SEED`, `STICKSLIP_POINTS` and `STICKSLIP_SECONDS` say which, how many and for how long at most.
#[test]
#[ignore = "minutes; .ci/slow enclosures"]
#[allow(clippy::print_stdout, reason = "the figures are what it is run for")]
fn a_million_points() {
    use std::time::{Duration, Instant};
    use stickslip::enclosed::MAX_BITS;
    let number = |name: &str, otherwise: u64| std::env::var(name).map_or(otherwise, |n| n.parse().unwrap());
    let (most, seconds) = (number("STICKSLIP_POINTS", 1_000_000), number("STICKSLIP_SECONDS", 1 << 40));
    let (mut count, start) = (0, Instant::now());
    let mut state = number("STICKSLIP_SEED", 20);
    let mut random = move || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / 2f64.powi(53)
    };
    let (mut widths, mut undecided, mut values, mut more_bits) = (Vec::new(), 0, 0u64, 0);
    let (mut with, mut without) = (Duration::ZERO, Duration::ZERO);
    for i in (0..most).take_while(|_| start.elapsed().as_secs() < seconds) {
        count += 1;
        let n = (1.0 + 12.0 * random()).floor();
        let sign = if random() < 0.5 { 1.0 } else { -1.0 };
        let omega = match i % 4 {
            0 => (6.0 * (2.0 * random() - 1.0)).exp(),
            1 => 0.1 + 3.0 * random(),
            2 => (1.0 + sign * 2f64.powf(-3.0 - 49.0 * random())) / n,
            _ => (1.0 + sign * 2f64.powf(-1.0 - 9.0 * random())) / n,
        };
        let least = Border::new(omega).unwrap().min_force_ratio();
        let alpha = match i % 3 {
            0 => least * (1.0 + 20.0 * random()),
            1 => least * (1.0 + 2f64.powf(-52.0 * random())),
            // Below the border only where no motion of six reversals has to be looked for, which has no
            // enclosure.
            _ => least * (1.0 + if omega < 0.5 { 1.0 } else { sign } * 2f64.powf(-4.0 - 48.0 * random())),
        };
        let begun = Instant::now();
        let found = enclosed::response(
            &known(Mp::<1>::from(omega)),
            &known(Mp::<1>::from(alpha)),
            &whole(0),
            &whole(1),
            64,
        )
        .unwrap();
        with += begun.elapsed();
        let ratios = Ratios::new(Mp::<1>::from(omega), Mp::from(alpha)).unwrap();
        let begun = Instant::now();
        let plain = Response::guarded(ratios);
        std::hint::black_box(Output::ALL.map(|output| output.of(&plain)));
        without += begun.elapsed();
        let exact = Response::guarded(Ratios::new(Mp::<4>::from(omega), Mp::from(alpha)).unwrap());
        undecided += u64::from(found.regime().is_none());
        more_bits += u64::from(found.bits() > 128);
        assert!(found.bits() <= MAX_BITS);
        for output in Output::ALL {
            if let Some(enclosure) = found.get(output)
                && let Some(value) = output.of(&exact)
            {
                let distance = (value - Mp::<4>::from_rug(enclosure.mid())).abs();
                let rad = Mp::<4>::from_rug(enclosure.rad());
                assert!(distance <= rad, "{omega:e} {alpha:e} {output:?}: {value} {enclosure}");
                values += 1;
                if value != Mp::ZERO {
                    // Both ends, in units in the last place of 64 bits.
                    widths.push(
                        (rad.scale2(1) / Mp::<4>::rounded(Mp::<1>::rounded(value).ulp())).to_f64() as f32
                    );
                }
            }
        }
    }
    widths.sort_by(f32::total_cmp);
    println!(
        "{count} points, {values} values of all outputs, none outside; width median {}, worst {} ulp; {undecided} undecided; \
         more than 128 bits: {more_bits}; time {:.2} times that of Response::guarded",
        widths[widths.len() / 2],
        widths[widths.len() - 1],
        with.as_secs_f64() / without.as_secs_f64()
    );
}

/// The guaranteed ranges of `uncertainty` at f64 in boxes of one point, where nothing but their margin for
/// rounding lies between the two ends: how many have the enclosed value in them, and the largest part of a
/// margin that rounding takes.
fn margins_hold(count: u32, seed: f64) -> (u32, f64) {
    use stickslip::uncertainty::{Interval, RatioBox};
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
        let least = Border::new(omega).unwrap().min_force_ratio();
        let alpha = least * (1.0 + 8.0 * share(0.754_877_666_246_693).powi(6) + 1e-12);
        let found = enclosed::response(
            &known(Mp::<1>::from(omega)),
            &known(Mp::<1>::from(alpha)),
            &whole(0),
            &whole(1),
            64,
        )
        .unwrap();
        let point = RatioBox::new(Interval::exactly(omega), Interval::exactly(alpha)).unwrap();
        for output in outputs {
            let Some(range) = point.range(output, 4).unwrap().filter(|range| range.is_guaranteed()) else {
                continue;
            };
            let Some(enclosure) = found.get(output) else { continue };
            let (mid, rad) = (Exact::from_rug(enclosure.mid()), Exact::from_rug(enclosure.rad()));
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

/// Ranges proved in balls have the outputs of points of the box, whatever the output, and close in on them as
/// the box is cut into more parts.
#[test]
fn proved_ranges_have_the_outputs_of_the_box() {
    use stickslip::uncertainty::{Interval, RatioBox};
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
        let interval = |low, high| Interval::between(low, high).unwrap();
        let ratios = RatioBox::new(interval(o1, o2), interval(a1, a2)).unwrap();
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
    // A box on both sides of the border, of a pole or of Ω = 1 has no proved displacement, but a border.
    for (o1, o2, a1, a2) in [(0.7, 0.71, 1.0, 2.0), (0.33, 0.34, 9.0, 9.5), (0.99, 1.01, 2.0, 2.0)] {
        let interval = |low, high| Interval::between(low, high).unwrap();
        let ratios = RatioBox::new(interval(o1, o2), interval(a1, a2)).unwrap();
        assert_eq!(ratios.enclosed(Output::MaxDisplacement, 50), Ok(None), "{o1} {a1}");
        let border = ratios.enclosed(Output::MinForceRatio, 50).unwrap();
        assert_eq!(border.is_some(), o1 > 0.5, "{o1} {a1}");
    }
}
