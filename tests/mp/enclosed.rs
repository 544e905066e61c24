//! Enclosures of the closed forms, compared with the same outputs at 1024 bits, where they are sharp and
//! where a decision is close.

mod damped;
mod edges;
mod many;
mod ranges;
mod steady;

use crate::drawn::cases;
use proptest::prelude::*;
use stickslip::enclosed::{self, Enclosure, Known, Regime};
use stickslip::float::Mp;
use stickslip::{Border, Field as _, Float as _, Output, Ratios, Response};

/// A number whose rounding is negligible.
type Exact = Mp<16>;

fn known<const L: usize>(x: Mp<L>) -> Known {
    Known::exactly(x).unwrap()
}

/// A double, without rounding.
fn double(x: f64) -> Known {
    known(Mp::<1>::from(x))
}

/// A ratio exactly as written.
fn text(ratio: &str) -> Known {
    ratio.parse().unwrap()
}

/// The enclosures without damping or static friction.
fn response(omega: &Known, alpha: &Known, bits: u32) -> Result<enclosed::Response, stickslip::Error> {
    enclosed::KnownRatios::new(omega).with_force_ratio(alpha).response(bits)
}

/// The enclosures at ratios that are exact doubles.
fn at_point(omega: f64, alpha: f64) -> enclosed::Response {
    response(&double(omega), &double(alpha), 64).unwrap()
}

fn reference(omega: Exact, alpha: Exact) -> Response<Exact> {
    Response::new(Ratios::new(omega, alpha).unwrap())
}

/// The distance of the value from the midpoint, in radii.
fn radii(found: &Enclosure, value: Exact) -> f64 {
    let distance = (value - Exact::from(&found.mid)).abs();
    if distance == Exact::ZERO { 0.0 } else { (distance / Exact::from(&found.rad)).to_f64() }
}

/// The radius in units in the last place of the requested bits.
fn units(found: &Enclosure) -> f64 {
    let unit = Exact::from(&found.mid).abs().scale2(-(found.mid.prec() as i32));
    (Exact::from(&found.rad) / unit).to_f64()
}

/// Checks that every output lies in its enclosure; returns the widest enclosure in units in the last place.
fn check(omega: f64, alpha: Exact, bits: u32) -> f64 {
    let found = response(&double(omega), &known(alpha), bits).unwrap();
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
    assert_eq!(found.regime, Some(expected(&exact)), "{omega} {alpha}");
    widest
}

fn expected(exact: &Response<Exact>) -> Regime {
    let (omega, alpha) = (exact.ratios.omega(), exact.ratios.alpha());
    if alpha <= Exact::from(1) {
        Regime::Stuck
    } else if alpha < exact.border.min_force_ratio {
        Regime::BelowBorder
    } else if omega == Exact::from(1) {
        Regime::Unbounded
    } else {
        Regime::NonSticking
    }
}

/// Frequency ratios of ordinary size, and close to 1 and 1/n.
fn frequencies() -> impl Strategy<Value = f64> {
    let beside = (1u32..12, 4i32..50, any::<bool>()).prop_map(|(n, e, above)| {
        let distance = if above { 2f64.powi(-e) } else { -2f64.powi(-e) };
        (1.0 + distance) / f64::from(n)
    });
    let poles = (1u32..12).prop_map(|n| 1.0 / f64::from(n));
    prop_oneof![4 => (-4.0f64..4.0).prop_map(f64::exp), 3 => beside, 1 => poles]
}

/// α divided by the border, minus 1.
fn excesses() -> impl Strategy<Value = f64> {
    prop_oneof![3 => 1e-3f64..20.0, 2 => (3i32..60).prop_map(|e| 2f64.powi(-e)), 1 => -0.5f64..-1e-6]
}

fn never_outside(omega: f64, excess: f64, wide: bool) {
    let least = Border::new(Exact::from(omega)).unwrap().min_force_ratio;
    let alpha = Exact::rounded(Mp::<2>::rounded(least * (Exact::from(1) + Exact::from(excess))));
    let widest = check(omega, alpha, if wide { 256 } else { 64 });
    // Half a unit in the last place is up to 1 of these units, and the two bits beyond those requested leave
    // another half.
    assert!(widest <= 1.5, "{omega} {alpha}: {widest} units");
}

/// An input that failed once.
#[test]
fn a_value_that_was_outside() {
    never_outside(0.3125, 0.125, false);
}

proptest! {
    #![proptest_config(cases(40))]

    #[test]
    fn the_value_is_never_outside(omega in frequencies(), excess in excesses(), wide in any::<bool>()) {
        never_outside(omega, excess, wide);
    }

    /// The enclosures contain the outputs of every point of the intervals.
    #[test]
    fn intervals_have_the_outputs_of_all_their_numbers(
        omega in prop_oneof![0.52f64..0.95, 1.05f64..6.0, 0.35f64..0.45, 0.27f64..0.32],
        excess in 0.2f64..3.0,
        width in (6i32..40).prop_map(|e| 2f64.powi(-e)),
        shares in prop::collection::vec((0.0f64..1.0, 0.0f64..1.0), 6),
    ) {
        let alpha = Border::new(omega).unwrap().min_force_ratio * (1.0 + excess);
        let interval = |x: f64| {
            Known::between(&double(x), &double(x * (1.0 + width))).unwrap()
        };
        let found = response(&interval(omega), &interval(alpha), 64).unwrap();
        for (a, b) in shares.into_iter().chain([(0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)]) {
            let inside = |x: f64, share: f64| {
                let width = Exact::from(x * (1.0 + width)) - Exact::from(x);
                Exact::from(x) + width * Exact::from(share)
            };
            let exact = reference(inside(omega, a), inside(alpha, b));
            for output in Output::ALL {
                if let (Some(enclosure), Some(value)) = (found.get(output), output.of(&exact)) {
                    let off = radii(enclosure, value);
                    prop_assert!(
                        off <= 1.0,
                        "{omega} {alpha} ± {width} {output:?}: {value} is {off} radii from {enclosure}"
                    );
                }
            }
        }
        if width < 1e-9 {
            prop_assert_eq!(found.regime, Some(Regime::NonSticking));
            let velocity = found.get(Output::MaxVelocity).unwrap();
            prop_assert!(velocity.rad.to_f64() < 1e5 * width, "{velocity}");
        }
    }
}

#[test]
fn decimals_are_what_is_written() {
    let at = |omega: &str, alpha: &str| response(&text(omega), &text(alpha), 128).unwrap();
    // 1/5 is a pole, where no force suffices; the double next to it is not.
    let pole = at("0.2", "1e6");
    assert_eq!((pole.regime, pole.get(Output::MinForceRatio)), (Some(Regime::BelowBorder), None));
    assert!(
        enclosed::KnownRatios::new(&double(0.2)).response(64).unwrap().get(Output::MinForceRatio).is_some()
    );
    // At 1/6, K = 0 and the border is exactly 35; no value there is rounded.
    let sixth = enclosed::KnownRatios::new(&text("1/6")).response(64).unwrap();
    assert!(sixth.get(Output::MinForceRatio).unwrap().contains(&rug::Float::with_val(64, 35)));
    assert_eq!(sixth.get(Output::BestForceRatio).unwrap().to_string(), "0 ± 0");
    let half = at("0.5", "4");
    assert_eq!(half.regime, Some(Regime::NonSticking));
    // α = 3 is the border at Ω = 1/2, which no number of bits decides.
    let border = at("0.5", "3");
    assert_eq!((border.regime, border.bits), (None, enclosed::MAX_BITS));
    // Close to the border, more bits decide.
    let above = at("0.5", &format!("3.{}1", "0".repeat(100)));
    assert!(above.regime == Some(Regime::NonSticking) && above.bits > 192, "{}", above.bits);
    assert_eq!(at("0.5", &format!("2.{}", "9".repeat(100))).regime, Some(Regime::BelowBorder));
    assert_eq!(
        (at("1", "1.3").regime, at("1", "1.27").regime),
        (Some(Regime::Unbounded), Some(Regime::BelowBorder))
    );
    assert_eq!(at("0.7", "1").regime, Some(Regime::Stuck));
}

/// On the border, a hundred decimals away from resonance: the cancellation requires more bits, which are
/// used.
#[test]
fn more_bits_are_taken_where_they_are_needed() {
    let omega = format!("1.{}1", "0".repeat(99));
    let found = response(&text(&omega), &text("1.3"), 64).unwrap();
    let displacement = found.get(Output::MaxDisplacement).unwrap();
    assert!(units(displacement) <= 1.5 && found.bits > 256, "{displacement} {}", found.bits);
    let near = Exact::from(
        &(rug::Rational::from(1)
            + rug::Rational::from((1, rug::Integer::from(rug::Integer::u_pow_u(10, 100))))),
    );
    let exact = reference(near, Exact::from(&rug::Rational::from((13, 10))));
    // The reference itself has lost about 660 of its 1024 bits.
    let value = exact.cycle.as_ref().unwrap().max_displacement;
    assert!(((value - Exact::from(&displacement.mid)) / value).abs().to_f64() < 1e-18);
}

#[test]
fn what_is_outside_the_domain_is_refused() {
    let message =
        |omega: &str, alpha: &str, bits| response(&text(omega), &text(alpha), bits).unwrap_err().to_string();
    assert!(message("0", "2", 64).starts_with("frequency ratio Ω = 0 must be > 0"));
    assert!(message("-1", "2", 64).starts_with("frequency ratio Ω = -1 must be > 0"));
    assert!(message("1e-80", "2", 64).contains("must be ≥"));
    assert!(message("1", "-2", 64).starts_with("force ratio α = -2 must be > 0"));
    assert!(message("1", "1e80", 64).contains("must be ≥"));
    assert_eq!(message("1", "2", 0), "precision in bits = 0 must be > 0");
    assert!(message("1", "2", 8193).contains("≤ 8192"));
    for wrong in ["", "x", "inf", "nan", "1 5", "1_0", "1/0", "/3", "1/-3", "--1", "1e99999999", "0x1"] {
        assert!(wrong.parse::<Known>().is_err(), "{wrong}");
    }
    assert!(Known::between(&text("2"), &text("1")).is_err());
    assert!(Known::exactly(Mp::<1>::NAN).is_err());
}
